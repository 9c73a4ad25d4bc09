#include "plumb/convex/fixed_planes.h"

#include <algorithm>
#include <numeric>

#include "plumb/convex/choose_plane.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {

FixedPlanes::FixedPlanes(CutSurface& surface, std::span<const HalfedgeId> reflex, Context& context)
    : s_(surface) {
  find_tips(reflex);
  for (std::size_t i = 0; i < reflex.size(); ++i) {
    context.checkpoint("choosing planes", i, reflex.size());
    const HalfedgeId h = reflex[i];
    const std::size_t e = s_.half(h).edge.value();
    if (plane_.size() <= e) plane_.resize(e + 1);
    plane_[e] = choose(h);
  }
}

void FixedPlanes::find_tips(std::span<const HalfedgeId> reflex) {
  for (const HalfedgeId h : reflex) {
    const VertexId a = s_.half(h).origin, b = s_.target(h);
    spokes_.push_back({a, b});
    spokes_.push_back({b, a});
  }
  std::sort(spokes_.begin(), spokes_.end());
  const auto is_alone = [this](std::size_t i) {
    const bool is_first = i == 0 || spokes_[i - 1][0] != spokes_[i][0];
    return is_first && (i + 1 == spokes_.size() || spokes_[i + 1][0] != spokes_[i][0]);
  };
  std::vector<std::array<VertexId, 2>> shared;
  for (std::size_t i = 0; i < spokes_.size(); ++i) {
    if (!is_alone(i)) shared.push_back(spokes_[i]);
  }
  spokes_ = std::move(shared);
}

Sign FixedPlanes::side_of(VertexId v, PlaneId p) const {
  return side(s_.points(), s_.point[v.value()], p);
}

/// Do all edges of some tip in p lead to one side? Not of one on the line.
bool FixedPlanes::may_touch(PlaneId p, std::array<PlaneId, 2> line) const {
  for (std::size_t i = 0; i < spokes_.size();) {
    const VertexId tip = spokes_[i][0];
    std::size_t end = i;
    while (end < spokes_.size() && spokes_[end][0] == tip) ++end;
    const auto is_on = [&](PlaneId q) { return side_of(tip, q) == Sign::Zero; };
    if (is_on(p) && !(is_on(line[0]) && is_on(line[1]))) {
      const Sign first = side_of(spokes_[i][1], p);
      bool is_one_side = first != Sign::Zero;
      for (std::size_t k = i + 1; k < end && is_one_side; ++k) {
        is_one_side = side_of(spokes_[k][1], p) == first;
      }
      if (is_one_side) return true;
    }
    i = end;
  }
  return false;
}

PlaneId FixedPlanes::choose(HalfedgeId h) {
  const PlaneId p = s_.plane_of(h).plane(), q = s_.plane_of(s_.half(h).twin).plane();
  if (p == q || !may_touch(p, {p, q})) return p;
  return may_touch(q, {p, q}) ? choose_between(h) : q;
}

/// m = c1 n1 + c2 n2, with outward normals and c1 c2 < 0.
PlaneId FixedPlanes::choose_between(HalfedgeId h) {
  const OrientedPlane p = s_.plane_of(h), q = s_.plane_of(s_.half(h).twin);
  for (int sum = 2;; ++sum) {
    for (int c = 1; c < sum; ++c) {
      if (std::gcd(c, sum) != 1) continue;
      const PlaneId between =
          intern_pencil(s_.tables->planes, p.plane(), q.plane(),
                        {p.is_opposite() ? -c : c, q.is_opposite() ? sum - c : c - sum});
      if (between.is_valid() && !may_touch(between, {p.plane(), q.plane()})) return between;
    }
  }
}

}  // namespace plumb
