// Edges between equal labels are left out, and the pieces of one curve that remain on both sides of
// a left-out crossing become one curve again, so that rounding does not bend borders at crossings
// that are no longer there; this takes linear time (without_edges()). What is left is rounded as
// one subdivision, and read off face by face. Rounding may remove a narrow face between two faces
// with equal labels, so edges between equal labels are left out once more. Then neighbouring faces
// have different labels, and each face is one polygon.
//
// Tested by tests/plane/layer_test.cpp.
#include "plumb/plane/layer/labelled_layer.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "plumb/plane/arrangement.h"
#include "plumb/plane/complex/plane_draft.h"
#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/plane_measure.h"

namespace plumb {
namespace {

/// Returns for each edge whether it lies between faces with different labels.
std::vector<std::uint8_t> border_edges(const PlaneComplex& complex,
                                       const std::vector<std::uint32_t>& label) {
  const Dcel& dcel = complex.dcel;
  std::vector<std::uint8_t> is_border;
  is_border.reserve(complex.edge_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    is_border.push_back(label[dcel.face(h).value()] != label[dcel.face(twin(h)).value()] ? 1 : 0);
  }
  return is_border;
}

/// Returns for each vertex whether it is an input point, that is, not a crossing.
std::vector<std::uint8_t> input_corners(const PlaneComplex& complex) {
  std::vector<std::uint8_t> is_corner;
  is_corner.reserve(complex.vertex_count());
  for (const std::uint32_t p : complex.vertex_point) {
    is_corner.push_back(p < complex.points.inputs.size() ? 1 : 0);
  }
  return is_corner;
}

bool has_inner_edges(const LabelledComplex& labelled) {
  const Dcel& dcel = labelled.complex.dcel;
  for (std::size_t e = 0; e < labelled.complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    if (labelled.label[dcel.face(h).value()] == labelled.label[dcel.face(twin(h)).value()]) {
      return true;
    }
  }
  return false;
}

/// Appends the rings of a face as a polygon.
void append_polygon(Layer& layer, const PlaneComplex& complex, FaceId f) {
  for (const std::vector<VertexId>& ring : face_rings(complex, f)) {
    for (const VertexId v : ring) layer.ring_corners.push_back(v.value());
    layer.end_ring();
  }
  layer.end_polygon();
}

}  // namespace

LabelledComplex labelled_arrangement(const PlanePoints& points, std::span<const SweepCurve> curves,
                                     std::span<const SideLabels> sides,
                                     std::span<const std::uint32_t> isolated, Context& context) {
  Arrangement kept = arrange(points, curves, isolated, context);
  LabelledComplex result{std::move(kept.complex), {}};
  result.label.assign(result.complex.face_count(), kNoLabel);
  std::vector<SegmentId> origins;
  for (std::size_t e = 0; e < result.complex.edge_count(); ++e) {
    origins.clear();
    kept.origin_sets.append(kept.origins[e], origins);
    const HalfedgeId h = first_half(EdgeId(e));
    const SideLabels side = sides[origins.front().value()];
    result.label[result.complex.dcel.face(h).value()] = side.left;
    result.label[result.complex.dcel.face(twin(h)).value()] = side.right;
  }
  return result;
}

LabelledComplex without_inner_edges(const PlaneComplex& complex,
                                    const std::vector<std::uint32_t>& label,
                                    std::span<const std::uint8_t> is_corner, Context& context) {
  context.checkpoint("borders", 0, 0);
  const std::vector<std::uint8_t> corners =
      is_corner.empty() ? input_corners(complex)
                        : std::vector<std::uint8_t>(is_corner.begin(), is_corner.end());
  ReducedComplex reduced = without_edges(complex, border_edges(complex, label), corners);
  LabelledComplex result{std::move(reduced.complex), {}};
  result.label.reserve(reduced.merged.size());
  for (const FaceId f : reduced.merged) result.label.push_back(label[f.value()]);
  return result;
}

RoundedLabels rounded_labels(const PlaneComplex& complex, const std::vector<std::uint32_t>& label,
                             Context& context, std::span<const std::uint8_t> is_corner) {
  const LabelledComplex kept = without_inner_edges(complex, label, is_corner, context);
  RoundedSubdivision rounded = round_to_doubles(kept.complex, context);
  LabelledComplex result{std::move(rounded.complex), {}};
  for (const FaceId f : rounded.exact_face) result.label.push_back(kept.label[f.value()]);
  // If a narrow face vanishes, the faces beside it may have the same label.
  if (has_inner_edges(result))
    result = without_inner_edges(result.complex, result.label, {}, context);
  return {std::move(result), rounded.report};
}

Layer layer_of_labels(const LabelledComplex& labelled, std::size_t label_count, const Layer* named,
                      Context& context) {
  const PlaneComplex& complex = labelled.complex;
  std::vector<std::pair<std::uint32_t, FaceId>> faces;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (labelled.label[f] != kNoLabel) faces.push_back({labelled.label[f], FaceId(f)});
  }
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.value() < b.second.value();
  });
  Layer layer;
  if (named != nullptr) layer.crs = named->crs;
  layer.points.reserve(complex.vertex_count());
  for (const std::uint32_t p : complex.vertex_point) {
    layer.points.push_back(complex.points.inputs.approx(p));
  }
  auto next = faces.begin();
  for (std::uint32_t l = 0; l < label_count; ++l) {
    if (l % kFacesPerCheckpoint == 0) context.checkpoint("polygons", l, label_count);
    for (; next != faces.end() && next->first == l; ++next) {
      append_polygon(layer, complex, next->second);
    }
    layer.end_feature(named == nullptr ? "" : named->id(l),
                      named == nullptr ? "" : named->properties(l));
  }
  return layer;
}

}  // namespace plumb
