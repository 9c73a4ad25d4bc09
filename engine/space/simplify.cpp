#include "plumb/space/simplify.h"

#include <memory>
#include <utility>

#include "plumb/space/local_maps.h"
#include "plumb/space/space_draft.h"
#include "plumb/space/vertex_carrier.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {

namespace {

constexpr std::uint64_t kBytesPerUse = 110;  // a draft, and what is joined

/// Step 1.
class MinimalForm {
 public:
  explicit MinimalForm(const SpaceComplex& complex)
      : complex_(complex), overlay_(complex.planes()) {}

  bool holds(Context& context) {
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      if (dissolves(FacetId(f))) return false;
    }
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      if (dissolves(EdgeId(e))) return false;
    }
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      if (v % 4096 == 0) context.checkpoint("simplify", v, complex_.vertex_count());
      if (dissolves(VertexId(v))) return false;
    }
    return true;
  }

 private:
  bool dissolves(FacetId f) const {
    const auto& [above, below] = complex_.facet_volume[f.value()];
    const Mark own = complex_.facet_mark[f.value()];
    return complex_.volume_mark[above.value()] == own && complex_.volume_mark[below.value()] == own;
  }

  /// Facets stay: an edge goes if it lies inside one, or in a volume.
  bool dissolves(EdgeId e) const {
    const Mark own = complex_.edge_mark[e.value()];
    const UseId first = complex_.edge_use[e.value()];
    if (!first.is_valid()) {
      return complex_.volume_mark[complex_.edge_volume[e.value()].value()] == own;
    }
    const UseId second = complex_.use_radial[first.value()];
    if (second == first || complex_.use_radial[second.value()] != first) return false;
    const std::uint32_t f = complex_.use_facet[first.value()].value();
    const std::uint32_t g = complex_.use_facet[second.value()].value();
    return complex_.facet_plane[f] == complex_.facet_plane[g] && complex_.facet_mark[f] == own &&
           complex_.facet_mark[g] == own;
  }

  /// Edges stay: only where there are none, or two, can a vertex be a place inside something else.
  bool dissolves(VertexId v) {
    const std::size_t degree = complex_.star_of(v).size();
    if (degree != 0 && degree != 2) return false;
    local_map(complex_, v, local_);
    return overlay_.simplify(local_.map) ||
           classify(complex_.planes(), local_.map) != PyramidKind::Vertex;
  }

  const SpaceComplex& complex_;
  SphereOverlay overlay_;
  LocalMap local_;
};

}  // namespace

SpaceComplex simplified(SpaceComplex complex, Context& context) {
  if (MinimalForm(complex).holds(context)) return complex;
  MemoryCharge memory(context);
  memory.add(kBytesPerUse * complex.use_count(), "the minimal form");
  SpaceDraft draft(std::const_pointer_cast<SpaceTables>(complex.tables));
  SphereOverlay overlay(complex.planes());
  VertexCarrier carrier(complex, draft, overlay);
  LocalMap local;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    if (v % 4096 == 0) context.checkpoint("simplify", v, complex.vertex_count());
    local_map(complex, VertexId(v), local);
    carrier.add_simplified(VertexId(v), local);
  }
  carrier.face_ends();
  SpaceComplex result = join(std::move(draft), context);
  if (result.vertex_count() == 0) result.volume_mark[0] = complex.volume_mark[0];
  return result;
}

}  // namespace plumb
