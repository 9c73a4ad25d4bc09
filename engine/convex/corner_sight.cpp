#include "plumb/convex/corner_sight.h"

#include <algorithm>

#include "plumb/convex/plane_diagonals.h"

namespace plumb {
namespace {

class CornerSight {
 public:
  CornerSight(const PlaneRegion& region, Context& context)
      : r_(region), context_(context), corners_(corners_of(region)) {
    triangulate(r_, context);
    number_corners();
  }

  std::vector<std::vector<std::uint32_t>> look() {
    seen_.resize(corners_.size());
    for (from_ = 0; from_ < corners_.size(); ++from_) {
      context_.checkpoint("convex partition", from_, corners_.size());
      look_around();
    }
    for (std::vector<std::uint32_t>& list : seen_) {
      std::ranges::sort(list);
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return std::move(seen_);
  }

 private:
  /// What is seen through a side of a triangle, between the rays to two vertices.
  struct Window {
    HalfedgeId side;  ///< of the triangle on this side, from right to left
    VertexId right, left;
  };

  bool is_boundary(HalfedgeId h) const { return r_.is_cut[edge_of(h).value()] == 0; }

  /// All half-edges that leave a corner get its number.
  void number_corners() {
    corner_.assign(r_.halfedge_count(), 0);
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      HalfedgeId h = corners_[i];
      corner_[h.value()] = i;
      while (!is_boundary(r_.before(h))) {
        h = twin(r_.before(h));
        corner_[h.value()] = i;
      }
    }
  }

  void look_around() {
    HalfedgeId h = corners_[from_];
    eye_ = r_.point(r_.start(h));
    while (true) {
      const HalfedgeId opposite = r_.after(h);
      see(opposite);
      see(r_.after(opposite));
      look_through({opposite, r_.start(opposite), r_.target(opposite)});
      if (is_boundary(r_.before(h))) return;
      h = twin(r_.before(h));
    }
  }

  void look_through(const Window& first) {
    windows_.push_back(first);
    while (!windows_.empty()) {
      const auto [side, right, left] = windows_.back();
      windows_.pop_back();
      if (is_boundary(side)) continue;
      const HalfedgeId to_top = r_.after(twin(side)), from_top = r_.after(to_top);
      const VertexId top = r_.start(from_top);
      const Sign from_right = turn(right, top), to_left = turn(top, left);
      const bool is_seen = from_right == Sign::Positive && to_left == Sign::Positive;
      if (is_seen) see(from_top);
      // twin(side) runs from left to right: to_top starts at the right end, from_top ends at the left one.
      if (from_right == Sign::Positive) windows_.push_back({to_top, right, is_seen ? top : left});
      if (to_left == Sign::Positive) windows_.push_back({from_top, is_seen ? top : right, left});
    }
  }

  Sign turn(VertexId a, VertexId b) const {
    return orient2d(r_.points.inputs, eye_, r_.point(a), r_.point(b));
  }
  void see(HalfedgeId leaving) {
    const std::uint32_t to = corner_[leaving.value()];
    seen_[std::max(from_, to)].push_back(std::min(from_, to));
  }

  PlaneRegion r_;
  Context& context_;
  std::vector<HalfedgeId> corners_;
  std::vector<std::uint32_t> corner_;  // per half-edge
  std::vector<std::vector<std::uint32_t>> seen_;
  std::vector<Window> windows_;
  std::uint32_t from_ = 0;
  std::uint32_t eye_ = 0;
};

}  // namespace

std::vector<HalfedgeId> corners_of(const PlaneRegion& region) {
  const HalfedgeId first = region.loops.front().halfedge();
  std::vector<HalfedgeId> corners{first};
  for (HalfedgeId h = region.after(first); h != first; h = region.after(h)) corners.push_back(h);
  return corners;
}

std::vector<std::vector<std::uint32_t>> lesser_corners_seen(const PlaneRegion& region,
                                                            Context& context) {
  return CornerSight(region, context).look();
}

}  // namespace plumb
