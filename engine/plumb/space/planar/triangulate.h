// Points of a plane as algorithms on them ask: by index, exact, whatever they are held as.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/sign.h"
#include "plumb/predicates/space/rounded_point3.h"

#pragma GCC visibility push(default)
namespace plumb {

class PlanarPoints {
 public:
  virtual std::uint32_t size() const = 0;
  /// Positive: i, j, k turn left.
  virtual Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const = 0;
  /// Lexicographic order, x first.
  virtual Sign compare(std::uint32_t i, std::uint32_t j) const = 0;
  /// For i, j, k counter-clockwise. Positive: l inside their circle.
  virtual Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                        std::uint32_t l) const = 0;

 protected:
  ~PlanarPoints() = default;
};

// Points of space seen along a coordinate axis, as points of the plane: where questions about
// points of one plane are asked.

/// The axis to look along, and from which side.
struct FlatView {
  std::size_t axis = 2;
  bool is_mirrored = false;  ///< from -axis: counter-clockwise there is counter-clockwise here

  /// Looks onto the positive side of the (canonical) plane: along the axis that its normal is
  /// nearest to. Orientations of its points then have the signs seen from its positive side.
  static FlatView of_plane(const PlaneTable& planes, PlaneId plane);
  /// The coordinate of space that is x (0) or y (1) of the view.
  std::size_t coordinate(std::size_t i) const {
    const bool is_second = (i == 1) != is_mirrored;
    return (axis + (is_second ? 2 : 1)) % 3;
  }
};

/// A list of points in a view. Predicates by index, exact. Ladder: doubles with the points' boxes,
/// or with the nearest doubles where they are given; input points go on as orient2d() does, others
/// in integers, circles in rationals.
class FlatPoints final : public PlanarPoints {
 public:
  explicit FlatPoints(const Point3Table& points) : points_(points) {}

  void reset(FlatView view);
  void push_back(SpacePoint p);
  /// Closer than boxes are, so that filters decide more. Requires nearest == rounded(points, p).
  void push_back(SpacePoint p, const RoundedPoint3& nearest);
  std::uint32_t size() const override { return static_cast<std::uint32_t>(at_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override;
  Sign compare(std::uint32_t i, std::uint32_t j) const override;
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override;
  /// The side of a plane of space. Also of points of the frame.
  Sign side(std::uint32_t i, PlaneId plane) const {
    return plumb::side(points_, at_[i].point, plane);
  }
  /// The same points in a table of the plane.
  PointTable2 table() const;

 private:
  struct Entry {
    Point2 mid;
    double radius;
    SpacePoint point;
    bool is_nearest;  // mid is; orders of different ones are those of the points
  };
  /// (x w, y w, w) with w > 0.
  using HomogeneousPoint = std::array<Integer, 3>;

  Sign compare_along(std::size_t i, std::size_t j, std::size_t side) const;
  const HomogeneousPoint& homogeneous_point(std::uint32_t i) const;
  const RationalPoint2& exact_point(std::uint32_t i) const;

  const Point3Table& points_;
  FlatView view_;
  std::vector<Entry> at_;
  // When asked.
  mutable std::vector<std::optional<HomogeneousPoint>> homogeneous_;
  mutable std::vector<std::optional<RationalPoint2>> exact_;
};

// Regions of a plane cut into triangles between their own points.
//
// Main flow of triangulate(): a sweep in lexicographic order that triangulates what it leaves
// behind (Hertel and Mehlhorn, "Fast triangulation of simple polygons", FCT 1983, extended to
// regions whose boundaries touch in points). The part of the region between two edges met by the
// sweep line keeps a chain: the points behind it that no triangle has closed off, each corner of it
// reflex or flat.

using IndexEdge = std::array<std::uint32_t, 2>;
using IndexTriangle = std::array<std::uint32_t, 3>;

/// Appends triangles, counter-clockwise, whose corners are given points and whose union is the
/// region to the left of the edges. Points inside the region are corners too. Requires all points
/// to be different and edges that meet each other and points in their ends only; one that runs both
/// ways is a slit. False, and nothing appended: the edges have no region to their left (somewhere
/// it would be covered twice, or less than once). O(n log n).
bool triangulate(const PlanarPoints& points, std::span<const IndexEdge> edges,
                 std::vector<IndexTriangle>& triangles);

/// Flips edges that are not among `edges` until every one is locally Delaunay; of four points on a
/// circle the one with the lowest index is joined. Hence the result is unique. O(n^2) flips at
/// worst, O(n) as a rule.
void make_delaunay(const PlanarPoints& points, std::span<const IndexEdge> edges,
                   std::span<IndexTriangle> triangles);

// The sweep over a region of the plane that triangulate() and nest_cycles() have in common: points
// in lexicographic order, and the edges that meet the sweep line from bottom to top.
//
// The region lies to the left of its edges. Requires what triangulate() does: edges meet each other
// and points in their ends only; one that runs both ways is a slit, or has a part of the region on
// either side.

class RegionSweep {
 protected:
  /// An edge from its lesser end to its greater, in ranks of the sweep order.
  struct SweepEdge {
    std::uint32_t left;
    std::uint32_t right;
    bool is_lower;  ///< the region is above it
  };
  struct Probe {
    std::uint32_t rank;
  };
  struct Below {
    using is_transparent = void;
    const RegionSweep* sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return sweep->is_below(a, b); }
    bool operator()(std::uint32_t edge, Probe point) const {
      return sweep->turn(edge, point.rank) == Sign::Positive;
    }
  };
  using Status = std::set<std::uint32_t, Below>;
  using Place = Status::iterator;

  /// Then start(). Looks at the limits of the context, if there is one.
  RegionSweep(const PlanarPoints& points, std::span<const IndexEdge> edges,
              Context* context = nullptr);
  RegionSweep(const RegionSweep&) = delete;
  RegionSweep& operator=(const RegionSweep&) = delete;
  virtual ~RegionSweep() = default;

  /// Sorts the edges by their left ends, and there from bottom to top.
  void start();

  /// The turn from the left end of an edge over the right one to a point. (Whoever knows the edges'
  /// lines can ask them.)
  virtual Sign turn(std::uint32_t edge, std::uint32_t rank) const {
    return orient(edges_[edge].left, edges_[edge].right, rank);
  }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return points_.orient(order_[i], order_[j], order_[k]);
  }

  /// The edges in the status that end in v, or an empty range where v lies between edges.
  std::pair<Place, Place> edges_ending(std::uint32_t v);
  /// The edge just below a place of the status; kNone: there is none.
  std::uint32_t edge_below(Place at) const {
    return at == status_.begin() ? kNone : *std::prev(at);
  }
  /// Calls visit(edge) for the edges that leave v to the right, bottom to top, and puts each into
  /// the status. False: a visit said so.
  template <class Visit>
  bool insert_leaving(std::uint32_t v, const Visit& visit) {
    for (; next_start_ < starts_.size() && edges_[starts_[next_start_]].left == v; ++next_start_) {
      const std::uint32_t e = starts_[next_start_];
      if (!visit(e)) return false;
      place_[e] = status_.insert(e).first;
      incoming_[edges_[e].right] = e;
    }
    return true;
  }

  /// For every 4096th step.
  void count_step() {
    if (context_ != nullptr && ++steps_ % 4096 == 0) context_->checkpoint("sweep of a plane", 0, 0);
  }

  const PlanarPoints& points_;
  std::vector<std::uint32_t> order_;  // per rank: index
  std::vector<SweepEdge> edges_;
  Status status_;

 private:
  void rank_points();
  bool is_below(std::uint32_t a, std::uint32_t b) const;

  Context* context_;
  std::uint64_t steps_ = 0;
  std::vector<std::uint32_t> rank_;    // per index
  std::vector<std::uint32_t> starts_;  // edges by left end, bottom to top
  std::uint32_t next_start_ = 0;
  std::vector<std::uint32_t> incoming_;  // per rank: an edge in the status that ends there
  std::vector<Place> place_;             // per edge in the status
};

}  // namespace plumb
#pragma GCC visibility pop
