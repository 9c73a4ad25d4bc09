// Points of a plane as algorithms on them ask for them (by index, exactly, however they are
// stored), triangulation of regions, and the sweep that triangulation and nesting have in common.
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

/// A list of points of a plane with exact predicates by index.
class PlanarPoints {
 public:
  virtual std::uint32_t size() const = 0;  ///< Returns the number of points.
  /// Returns the turn of i, j, k: Positive is left.
  virtual Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const = 0;
  /// Returns the lexicographic order of i and j, x first.
  virtual Sign compare(std::uint32_t i, std::uint32_t j) const = 0;
  /// Returns Positive if l lies inside the circle of i, j, k. Requires that these run
  /// counter-clockwise.
  virtual Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                        std::uint32_t l) const = 0;

 protected:
  ~PlanarPoints() = default;
};

// Points of space seen along a coordinate axis as points of the plane: all questions about points
// of one plane are asked there.

/// The axis along which a view looks, and from which side.
struct FlatView {
  std::size_t axis = 2;      ///< The coordinate of space that is left out.
  bool is_mirrored = false;  ///< Whether the view looks from -axis.

  /// Returns the view onto the positive side of the (canonical) plane, along the axis to which its
  /// normal is nearest. Orientations of its points then have the signs seen from its positive side.
  static FlatView of_plane(const PlaneTable& planes, PlaneId plane);
  /// Returns the coordinate of space that is x (0) or y (1) of the view.
  std::size_t coordinate(std::size_t i) const {
    const bool is_second = (i == 1) != is_mirrored;
    return (axis + (is_second ? 2 : 1)) % 3;
  }
};

/// A list of points in a view, with exact predicates by index. Filter stages: doubles with the
/// points' boxes, or with the nearest doubles if they are given. Then input points go on as
/// orient2d() does, others in integers, circles in rationals. Not for several threads at once:
/// exact coordinates are kept when they have been asked for.
class FlatPoints final : public PlanarPoints {
 public:
  /// Makes an empty list of points of this table, to which it keeps a reference.
  explicit FlatPoints(const Point3Table& points) : points_(points) {}

  void reset(FlatView view);     ///< Empties the list and sets the view.
  void push_back(SpacePoint p);  ///< Appends a point.
  /// Appends a point with its nearest doubles, which are closer than its box, so that filters
  /// decide more. Requires nearest == rounded(points, p).
  void push_back(SpacePoint p, const RoundedPoint3& nearest);
  std::uint32_t size() const override { return static_cast<std::uint32_t>(at_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override;
  Sign compare(std::uint32_t i, std::uint32_t j) const override;
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override;
  /// Returns the side of a plane of space on which point i lies; it may be a point of the frame.
  Sign side(std::uint32_t i, PlaneId plane) const {
    return plumb::side(points_, at_[i].point, plane);
  }
  /// Returns the same points in a table of the plane.
  PointTable2 table() const;

 private:
  struct Entry {
    Point2 mid;
    double radius;
    SpacePoint point;
    bool is_nearest;  // Whether mid is nearest; if two such differ, they are in the points' order.
  };
  /// The coordinates (x w, y w, w) with w > 0.
  using HomogeneousPoint = std::array<Integer, 3>;

  Sign compare_along(std::size_t i, std::size_t j, std::size_t side) const;
  const HomogeneousPoint& homogeneous_point(std::uint32_t i) const;
  const RationalPoint2& exact_point(std::uint32_t i) const;

  const Point3Table& points_;
  FlatView view_;
  std::vector<Entry> at_;
  // Computed when they are first asked for.
  mutable std::vector<std::optional<HomogeneousPoint>> homogeneous_;
  mutable std::vector<std::optional<RationalPoint2>> exact_;
};

// Regions of a plane cut into triangles between their own points.
//
// triangulate() sweeps in lexicographic order and triangulates what it leaves behind (S. Hertel, K.
// Mehlhorn, Fast triangulation of simple polygons, Fundamentals of Computation Theory, 1983;
// extended to regions whose boundaries touch in points). The part of the region between two
// neighbouring edges on the sweep line keeps a chain: the points behind the line that no triangle
// has closed off, where each corner is reflex or flat.

using IndexEdge = std::array<std::uint32_t, 2>;      ///< Two points, in a direction.
using IndexTriangle = std::array<std::uint32_t, 3>;  ///< Three points, counter-clockwise.

/// Appends triangles whose corners are given points and whose union is the region to the left of
/// the edges. Points inside the region are corners too. Requires that all points are different and
/// that edges meet each other and points in their ends only; an edge that runs both ways is a slit.
/// Returns false, and appends nothing, if the edges have no region to their left (somewhere it
/// would be covered twice, or less than once). O(n log n).
bool triangulate(const PlanarPoints& points, std::span<const IndexEdge> edges,
                 std::vector<IndexTriangle>& triangles);

/// Flips sides of triangles that are not among `edges` until every one is locally Delaunay. Of four
/// points on a circle the one with the lowest index is joined, so the result is unique. O(n^2)
/// flips at worst, O(n) as a rule.
void make_delaunay(const PlanarPoints& points, std::span<const IndexEdge> edges,
                   std::span<IndexTriangle> triangles);

// The sweep over a region of the plane that triangulate() and nest_cycles() have in common: points
// in lexicographic order, and the edges that meet the sweep line from bottom to top.

/// A sweep over the region to the left of directed edges. Requires what triangulate() does: edges
/// meet each other and points in their ends only; an edge that runs both ways is a slit, or has a
/// part of the region on either side.
class RegionSweep {
 protected:
  /// An edge from its lesser end to its greater one, in ranks of the sweep order.
  struct SweepEdge {
    std::uint32_t left;   ///< The rank of its lesser end.
    std::uint32_t right;  ///< The rank of its greater end.
    bool is_lower;        ///< Whether the region is above it.
  };
  /// A point by its rank, to be looked up among edges.
  struct Probe {
    std::uint32_t rank;
  };
  /// The order of edges on the sweep line, and of edges and points.
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

  /// Sorts the points; start() must follow. Checks the limits of the context, if there is one.
  RegionSweep(const PlanarPoints& points, std::span<const IndexEdge> edges,
              Context* context = nullptr);
  RegionSweep(const RegionSweep&) = delete;
  RegionSweep& operator=(const RegionSweep&) = delete;
  virtual ~RegionSweep() = default;

  /// Sorts the edges by their left ends, and there from bottom to top.
  void start();

  /// Returns the turn from the left end of an edge over the right one to a point. A derived class
  /// that knows the lines of edges can ask these instead.
  virtual Sign turn(std::uint32_t edge, std::uint32_t rank) const {
    return orient(edges_[edge].left, edges_[edge].right, rank);
  }
  /// Returns the turn of three points, by rank.
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return points_.orient(order_[i], order_[j], order_[k]);
  }

  /// Returns the edges in the status that end in v, or an empty range, if v lies between edges, at
  /// its place.
  std::pair<Place, Place> edges_ending(std::uint32_t v);
  /// Returns the edge just below a place of the status, or kNone.
  std::uint32_t edge_below(Place at) const {
    return at == status_.begin() ? kNone : *std::prev(at);
  }
  /// Calls visit(edge) for the edges that leave v to the right, bottom to top, and puts each into
  /// the status. Returns false as soon as a visit does.
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

  /// Calls a checkpoint at every 4096th step.
  void count_step() {
    if (context_ != nullptr && ++steps_ % 4096 == 0) context_->checkpoint("sweep of a plane", 0, 0);
  }

  const PlanarPoints& points_;
  std::vector<std::uint32_t> order_;  // The index of each rank.
  std::vector<SweepEdge> edges_;
  Status status_;

 private:
  void rank_points();
  bool is_below(std::uint32_t a, std::uint32_t b) const;

  Context* context_;
  std::uint64_t steps_ = 0;
  std::vector<std::uint32_t> rank_;    // The rank of each index.
  std::vector<std::uint32_t> starts_;  // Edges by left end, there from bottom to top.
  std::uint32_t next_start_ = 0;
  std::vector<std::uint32_t> incoming_;  // An edge in the status that ends at each rank.
  std::vector<Place> place_;             // The place of each edge in the status.
};

}  // namespace plumb
#pragma GCC visibility pop
