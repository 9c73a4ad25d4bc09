// Predicates, triangulation and sweep for points in a plane. This header has three parts. The first
// part is an interface to points that are given by indices, with exact predicates; it does not
// depend on how the points are stored. The second part triangulates regions. The third part is a
// sweep that is used for triangulation and for the nesting of cycles.
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

/// A list of points of a plane, with exact predicates. The arguments of predicates are indices of
/// points.
class PlanarPoints {
 public:
  virtual std::uint32_t size() const = 0;  ///< Returns the number of points.
  /// Returns the direction of the turn at j on the way from i over j to k: Positive means left.
  virtual Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const = 0;
  /// Compares the points i and j by their x-coordinates. If these are equal, compares the points by
  /// their y-coordinates.
  virtual Sign compare(std::uint32_t i, std::uint32_t j) const = 0;
  /// Returns Positive if l lies inside the circle through i, j, k. Requires that i, j, k run
  /// counter-clockwise.
  virtual Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                        std::uint32_t l) const = 0;

 protected:
  ~PlanarPoints() = default;
};

/// Returns the direction of the turn of three points whose coordinates are known only
/// approximately. Positive means left. The result is Unsure if the approximations do not decide the
/// direction, or if a computation overflows. `error` is a bound for the error of a difference of
/// two coordinates, without the rounding error of this difference.
FilteredSign turn_of_nearby(const Point2& a, const Point2& b, const Point2& c, double error);

// Points of space, projected along a coordinate axis to points of the plane. Such a projection is
// called a view. If points of space lie in a common plane, all predicates of these points are
// evaluated in a view.

/// The axis along which a view looks, and the side from which it looks.
struct FlatView {
  std::size_t axis = 2;      ///< The index of the coordinate that the projection drops.
  bool is_mirrored = false;  ///< Whether the view looks from the negative side of the axis.

  /// Returns the view onto the positive side of the (canonical) plane, along the axis that is
  /// nearest to the normal of the plane. For points of the plane, orientations in this view have
  /// the same signs as orientations seen from the positive side of the plane.
  static FlatView of_plane(const PlaneTable& planes, PlaneId plane);
  /// Returns the index of the coordinate of space that the view shows as x (i = 0) or y (i = 1).
  std::size_t coordinate(std::size_t i) const {
    const bool is_second = (i == 1) != is_mirrored;
    return (axis + (is_second ? 2 : 1)) % 3;
  }
};

/// A list of points in a view, with exact predicates. A predicate is evaluated in stages:
/// - a filter in doubles, which uses the nearest doubles of the points if they are given, and the
///   boxes of the points otherwise,
/// - exact arithmetic: the stages of orient2d() for input points, integers for other points, and
///   rationals for circles.
///
/// An object must not be used by several threads at the same time, because even const functions
/// store exact coordinates when these are first needed.
class FlatPoints final : public PlanarPoints {
 public:
  /// Makes an empty list of points of the table `points`. Keeps a reference to the table.
  explicit FlatPoints(const Point3Table& points) : points_(points) {}

  void reset(FlatView view);     ///< Empties the list and sets the view.
  void push_back(SpacePoint p);  ///< Appends a point.
  /// Appends a point and its coordinates, rounded to the nearest doubles. The filters use these
  /// doubles instead of the box that the table of points stores for the point. The doubles have
  /// smaller error bounds, so the filters decide more predicates. Requires
  /// nearest == rounded(points, p).
  void push_back(SpacePoint p, const RoundedPoint3& nearest);
  std::uint32_t size() const override { return static_cast<std::uint32_t>(at_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override;
  /// Returns orient(i, j, k) if a filter decides it, otherwise Unsure.
  FilteredSign nearby_orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  Sign compare(std::uint32_t i, std::uint32_t j) const override;
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override;
  /// Returns the side of a plane of space on which point i lies. Point i may be a point of the
  /// frame.
  Sign side(std::uint32_t i, PlaneId plane) const {
    return plumb::side(points_, at_[i].point, plane);
  }
  /// Returns the points of the list, in the view, as a table of points of the plane.
  PointTable2 table() const;

 private:
  struct Entry {
    Point2 mid;
    double radius;
    SpacePoint point;
    // Whether mid consists of the doubles nearest to the point. If the mids of two such points
    // differ, they are in the same order as the points.
    bool is_nearest;
  };
  /// The coordinates (x w, y w, w) with w > 0.
  using HomogeneousPoint = std::array<Integer, 3>;

  Sign compare_along(std::size_t i, std::size_t j, std::size_t side) const;
  const HomogeneousPoint& homogeneous_point(std::uint32_t i) const;
  const RationalPoint2& exact_point(std::uint32_t i) const;

  const Point3Table& points_;
  FlatView view_;
  std::vector<Entry> at_;
  // Computed when they are first needed.
  mutable std::vector<std::optional<HomogeneousPoint>> homogeneous_;
  mutable std::vector<std::optional<RationalPoint2>> exact_;
};

// Triangulation of regions of a plane. The corners of triangles are given points; no points are
// constructed.
//
// triangulate() sweeps over the points in lexicographic order, and triangulates the region behind
// the sweep line. Source: S. Hertel, K. Mehlhorn, Fast triangulation of simple polygons,
// Fundamentals of Computation Theory, 1983. The algorithm is extended to regions whose boundaries
// touch in points. Consider two neighbouring edges on the sweep line that have the region between
// them. For each such pair of edges, the algorithm stores a chain of points behind the sweep line.
// The part of the region between this chain and the sweep line is not triangulated yet. Each inner
// corner of a chain is reflex or flat.

using IndexEdge = std::array<std::uint32_t, 2>;      ///< Two points, in a direction.
using IndexTriangle = std::array<std::uint32_t, 3>;  ///< Three points, counter-clockwise.

/// Appends triangles that together cover the region to the left of the edges. Corners of triangles
/// are points of `points`, and each point inside the region is a corner. Requires that all points
/// are different, that edges meet each other only at common ends, and that no point lies inside an
/// edge. An edge that occurs in both directions is a slit. If the edges do not bound a region to
/// their left, the function appends nothing and returns false. This is the case if the edges wind
/// around some part of the plane more than once or a negative number of times. O(n log n) for n
/// edges and points.
bool triangulate(const PlanarPoints& points, std::span<const IndexEdge> edges,
                 std::vector<IndexTriangle>& triangles);

/// Flips sides of triangles until every side that is not in `edges` is locally Delaunay. If the
/// four corners of two adjacent triangles lie on a circle, the diagonal that ends at the point of
/// lowest index is used. So the result is unique. For n triangles, the number of flips is O(n^2) in
/// the worst case, and usually O(n).
void make_delaunay(const PlanarPoints& points, std::span<const IndexEdge> edges,
                   std::span<IndexTriangle> triangles);

// The sweep over a region of the plane that triangulate() and nest_cycles() have in common. The
// sweep visits points in lexicographic order. It maintains the list of the edges that meet the
// sweep line, sorted from bottom to top.

/// A sweep over the region to the left of directed edges. Has the same requirements as
/// triangulate(). An edge that occurs in both directions is a slit, or separates two parts of the
/// region.
class RegionSweep {
 protected:
  /// An edge. Its ends are given by their ranks in the order of the sweep.
  struct SweepEdge {
    std::uint32_t left;   ///< The rank of its lesser end.
    std::uint32_t right;  ///< The rank of its greater end.
    bool is_lower;        ///< Whether the region is above the edge.
  };
  /// A point whose position among the edges of the status is looked up.
  struct Probe {
    std::uint32_t rank;
  };
  /// The order from bottom to top of two edges on the sweep line, or of an edge and a point.
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

  /// Sorts the points. Requires that start() is called next. If `context` is not null, its limits
  /// are checked during the sweep.
  RegionSweep(const PlanarPoints& points, std::span<const IndexEdge> edges,
              Context* context = nullptr);
  RegionSweep(const RegionSweep&) = delete;
  RegionSweep& operator=(const RegionSweep&) = delete;
  virtual ~RegionSweep() = default;

  /// Sorts the edges by their left ends. Edges with the same left end are sorted from bottom to
  /// top.
  void start();

  /// Returns the direction of the turn that is made by the left end of an edge, its right end, and
  /// a point. A derived class may override this function to compute the turn from the line of the
  /// edge.
  virtual Sign turn(std::uint32_t edge, std::uint32_t rank) const {
    return orient(edges_[edge].left, edges_[edge].right, rank);
  }
  /// Returns the direction of the turn of three points, given by rank.
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return points_.orient(order_[i], order_[j], order_[k]);
  }

  /// Returns the range of those edges of the status whose end is the point of rank v. If no edge
  /// ends in this point, the range is empty, and lies at the position of the point among the edges.
  std::pair<Place, Place> edges_ending(std::uint32_t v);
  /// Returns the edge just below a position in the status, or kNone.
  std::uint32_t edge_below(Place at) const {
    return at == status_.begin() ? kNone : *std::prev(at);
  }
  /// Goes through the edges whose left end is the point of rank v, from bottom to top. For each of
  /// these edges, calls visit(edge) and then inserts the edge into the status. Stops and returns
  /// false as soon as visit() returns false.
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

  /// Calls the checkpoint of the context at every 4096th step.
  void count_step() {
    if (context_ != nullptr && ++steps_ % 4096 == 0) context_->checkpoint("sweep of a plane", 0, 0);
  }

  const PlanarPoints& points_;
  std::vector<std::uint32_t> order_;  // The point index of each rank.
  std::vector<SweepEdge> edges_;
  Status status_;

 private:
  void rank_points();
  bool is_below(std::uint32_t a, std::uint32_t b) const;

  Context* context_;
  std::uint64_t steps_ = 0;
  std::vector<std::uint32_t> rank_;  // The rank of each point index.
  // The edges, sorted by their left ends. Edges with the same left end are sorted from bottom to
  // top.
  std::vector<std::uint32_t> starts_;
  std::uint32_t next_start_ = 0;
  std::vector<std::uint32_t> incoming_;  // An edge in the status that ends at each rank.
  std::vector<Place> place_;             // The position of each edge in the status.
};

}  // namespace plumb
#pragma GCC visibility pop
