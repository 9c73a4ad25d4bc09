// Labels are the marks of faces. All edges and vertices of a closed set belong to it, so marks need
// no labels of their own.
// Tested by tests/plane/plane_simplify_test.cpp.
#include "plumb/plane/plane_simplify.h"

#include <utility>

#include "plumb/plane/layer/border_graph.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

LabelledComplex labelled_by_marks(PlaneComplex complex) {
  LabelledComplex labelled{std::move(complex), {}};
  for (std::size_t f = 0; f < labelled.complex.face_count(); ++f) {
    labelled.label.push_back(labelled.complex.mark(FaceId(f)) ? 1 : 0);
  }
  return labelled;
}

/// Returns the closed set of the faces with label 1 and of all edges and vertices.
Nef2 closed_set(LabelledComplex labelled, Context& context) {
  PlaneComplex complex = std::move(labelled.complex);
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    complex.marks.face[f] = labelled.label[f] == 1 ? 1 : 0;
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) complex.marks.edge[e] = 1;
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) complex.marks.vertex[v] = 1;
  return Nef2::from_complex(std::move(complex), context);
}

}  // namespace

SimplifiedSet simplify_borders(const Nef2& set, const LayerSimplifyOptions& options,
                               Context& context) {
  if (!set.is_bounded()) {
    throw Error(ErrorCode::BadArgument, "only bounded sets can be simplified");
  }
  const RoundedSet rounded = round_to_doubles(set, context);
  const LabelledComplex labelled = labelled_by_marks(rounded.set.complex());
  BorderGraph borders(labelled, context);
  borders.simplify(options, context);
  const BorderCounts counts = borders.counts();
  return {closed_set(borders.arranged(context), context),
          counts.before,
          counts.after,
          counts.blocked,
          counts.moved,
          rounded.report};
}

}  // namespace plumb
