#include "plumb/space/simplify.h"

#include <memory>
#include <utility>

#include "plumb/space/local_maps.h"
#include "plumb/space/merge_coplanar.h"
#include "plumb/space/space_draft.h"
#include "plumb/space/vertex_carrier.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {

namespace {

constexpr std::uint64_t kBytesPerUse = 110;  // a draft, and what is joined

/// Does a facet, a free edge or a lone vertex go?
class MapChanges {
 public:
  explicit MapChanges(const SpaceComplex& complex) : c_(complex) {}

  bool exist() const {
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (has_mark(c_.facet_volume[f][0], c_.facet_mark[f]) &&
          has_mark(c_.facet_volume[f][1], c_.facet_mark[f])) {
        return true;
      }
    }
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (!c_.edge_use[e].is_valid() && has_mark(c_.edge_volume[e], c_.edge_mark[e])) return true;
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.star_of(VertexId(v)).empty() && goes_alone(v)) return true;
    }
    return false;
  }

 private:
  bool has_mark(VolumeId v, Mark mark) const { return c_.volume_mark[v.value()] == mark; }
  bool goes_alone(std::uint32_t v) const {
    const FacetId f = c_.vertex_facet[v];
    if (f.is_valid()) return c_.facet_mark[f.value()] == c_.vertex_mark[v];
    return has_mark(c_.vertex_volume[v], c_.vertex_mark[v]);
  }

  const SpaceComplex& c_;
};

}  // namespace

SpaceComplex simplified_by_maps(const SpaceComplex& complex, Context& context) {
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

SpaceComplex simplified(SpaceComplex complex, Context& context) {
  context.checkpoint("simplify", 0, complex.vertex_count());
  if (MapChanges(complex).exist()) return simplified_by_maps(complex, context);
  CoplanarMerge merge(complex, context);
  if (!merge.is_needed()) return complex;
  return merge.run(context);
}

}  // namespace plumb
