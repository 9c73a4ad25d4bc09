#include "plumb/convex/wall_conflicts.h"

#include <algorithm>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_boxes.h"

namespace plumb {
namespace {

class ConflictSearch {
 public:
  explicit ConflictSearch(const SpaceComplex& walls) : c_(walls) {}

  std::vector<std::pair<FacetId, FacetId>> run(Context& context) {
    std::vector<Box3> boxes;
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) boxes.push_back(box_of(c_, FacetId(f)));
    const BoxTree tree(boxes);
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (f % 256 == 0) context.checkpoint("walls that cross", f, c_.facet_count());
      tree.for_each_meeting(boxes[f], [&](std::uint32_t g) {
        if (g > f && may_conflict(FacetId(f), FacetId(g))) pairs_.emplace_back(f, g);
      });
    }
    std::sort(pairs_.begin(), pairs_.end());
    return std::move(pairs_);
  }

 private:
  /// How a facet lies to the plane of another.
  struct Place {
    bool is_before = false, is_behind = false;  // strictly, somewhere
    std::vector<VertexId> on;
    bool crosses() const { return is_before && is_behind; }
  };

  template <class Visit>
  void for_each_corner(FacetId f, const Visit& visit) const {
    const UseId first = c_.cycles_of(f)[0];
    UseId u = first;
    do {
      visit(c_.use_origin(u));
      u = c_.use_next[u.value()];
    } while (u != first);
  }

  Place place(FacetId f, PlaneId plane) const {
    Place result;
    for_each_corner(f, [&](VertexId v) {
      const Sign s = side(c_.points(), c_.vertex_point[v.value()], plane);
      if (s == Sign::Positive) result.is_before = true;
      if (s == Sign::Negative) result.is_behind = true;
      if (s == Sign::Zero) result.on.push_back(v);
    });
    std::sort(result.on.begin(), result.on.end());
    return result;
  }

  bool may_conflict(FacetId f, FacetId g) const {
    const PlaneId p = c_.facet_plane[f.value()], q = c_.facet_plane[g.value()];
    if (p == q) return true;
    const Place x = place(f, q);
    if (!x.crosses() && x.on.empty()) return false;
    const Place y = place(g, p);
    if (!y.crosses() && y.on.empty()) return false;
    return x.crosses() || y.crosses() || x.on != y.on;
  }

  const SpaceComplex& c_;
  std::vector<std::pair<FacetId, FacetId>> pairs_;
};

}  // namespace

std::vector<std::pair<FacetId, FacetId>> find_wall_conflicts(const SpaceComplex& walls,
                                                             Context& context) {
  return ConflictSearch(walls).run(context);
}

}  // namespace plumb
