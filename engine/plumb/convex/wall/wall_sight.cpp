// Walls that rise and fall from reflex edges: the lower envelope of what lies above an edge, within
// the vertical plane through it, and the upper envelope of what lies below.
//
// Shadows gives boxes of cells projected along the vertical, computed in balls of doubles with
// outward rounding, so a box tree over them finds every facet that may be above or below an edge.
// In the plane of the wall these facets leave obstacles that do not cross (wall_section.h). Sight
// keeps the base divided into intervals, each with the nearest obstacle so far, and inserts
// obstacles one by one; an interval is divided only at stations of obstacles, whose order is
// decided exactly.
//
// After these walls only vertical edges are reflex: docs/design/walls.md, section Vertical walls;
// B. Chazelle, SIAM Journal on Computing 13 (1984). If a point or a vertical line was removed from
// a volume, there is no edge from which a wall could start. It gets a wall through the whole set.
// Tested by tests/convex/walls_test.cpp.
#include "plumb/convex/wall/wall_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "plumb/base/internal/box_tree.h"
#include "plumb/convex/wall/wall_section.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/query/space_ray.h"

namespace plumb {
namespace {

/// Boxes of cells: their shadows along the vertical in two coordinates, and their heights in the
/// third.
class Shadows {
 public:
  Shadows(const SpaceComplex& complex, const Vertical& vertical)
      : c_(complex), axis_(vertical.axis()) {
    for (std::size_t i = 0; i < 2; ++i) {
      const double slope = vertical.slope(side_axis(i));
      slope_[i] = Ball::about(slope, slope == 0 ? 0 : std::fabs(slope) * Ball::kEps);
    }
  }

  Box3 of(VertexId v) const {
    const PointBox at = c_.points().box(c_.vertex_point[v]);
    const auto coordinate = [&](std::size_t i) { return Ball::about(at.mid[i], at.radius); };
    Box3 box;
    for (std::size_t i = 0; i < 2; ++i) {
      set(box, i, coordinate(side_axis(i)) - slope_[i] * coordinate(axis_));
    }
    set(box, 2, coordinate(axis_));
    return box;
  }
  Box3 of(EdgeId e) const {
    Box3 box = of(c_.origin[2 * e.value()]);
    box.add(of(c_.origin[2 * e.value() + 1]));
    return box;
  }
  Box3 of(FacetId f) const {
    Box3 box;
    const UseId first = c_.cycles_of(f)[0];
    UseId u = first;
    do {
      box.add(of(c_.use_origin(u)));
      u = c_.use_next[u];
    } while (u != first);
    return box;
  }

 private:
  std::size_t side_axis(std::size_t i) const { return (axis_ + 1 + i) % 3; }
  /// Extends an interval by its error and by the rounding of both sums. An unknown value becomes
  /// the whole axis.
  static void set(Box3& box, std::size_t i, Ball value) {
    if (!(value.error < Box3::kInfinity)) {
      box.low[i] = -Box3::kInfinity;
      box.high[i] = Box3::kInfinity;
      return;
    }
    const double wide = value.error * Ball::kUp;
    box.low[i] = value.mid - wide - std::fabs(value.mid) * Ball::kEps;
    box.high[i] = value.mid + wide + std::fabs(value.mid) * Ball::kEps;
  }

  const SpaceComplex& c_;
  std::size_t axis_;
  std::array<Ball, 2> slope_;
};

/// The obstacles that are first above a base, or below it.
class Sight {
 public:
  Sight(WallSection& section, const Obstacle& base, bool is_up)
      : section_(section), base_(base), is_up_(is_up), seen_{{base.from, base.to, kNone}} {}

  void run() {
    const std::vector<Obstacle>& all = section_.obstacles();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const Obstacle& o = all[i];
      if (o.owner == base_.owner || !overlap(o, base_.from, base_.to)) continue;
      if (section_.above(o, base_) == beyond()) insert(i);
    }
  }

  /// Returns the corners of the wall, or no corners if there is nothing above (below) a part of the
  /// base.
  std::vector<SpacePoint> polygon() const {
    std::vector<SpacePoint> corners{base_.to.point, base_.from.point};
    for (const Interval& i : seen_) {
      if (i.obstacle == kNone) return {};
      const PlaneId plane = section_.obstacles()[i.obstacle].plane;
      corners.push_back(section_.corner(i.from, plane));
      corners.push_back(section_.corner(i.to, plane));
    }
    // The corners lead back along the base and ahead above it, which is counter-clockwise
    // (wall_section.h). For a wall below the base, the order is reversed.
    if (!is_up_) std::reverse(corners.begin(), corners.end());
    return corners;
  }

 private:
  struct Interval {
    Station from, to;
    std::uint32_t obstacle;
  };

  Sign beyond() const { return is_up_ ? Sign::Positive : Sign::Negative; }
  bool overlap(const Obstacle& o, const Station& from, const Station& to) const {
    return section_.ahead(o.to.point, from) == Sign::Positive &&
           section_.ahead(o.from.point, to) == Sign::Negative;
  }

  /// The intervals that the obstacle overlaps are consecutive, so they are found by binary search
  /// and replaced as a whole.
  void insert(std::uint32_t number) {
    const Obstacle& o = section_.obstacles()[number];
    auto first = std::partition_point(seen_.begin(), seen_.end(), [&](const Interval& i) {
      return section_.ahead(o.from.point, i.to) != Sign::Negative;
    });
    std::vector<Interval> changed;
    auto last = first;
    for (; last != seen_.end() && overlap(o, last->from, last->to); ++last) {
      split(*last, number, changed);
    }
    const auto at = seen_.erase(first, last);
    seen_.insert(at, changed.begin(), changed.end());
  }

  // Replaces the interval by up to three: the new obstacle takes the middle one if it is nearer to
  // the base. Obstacles do not cross, so one comparison decides for the whole overlap.
  void split(const Interval& i, std::uint32_t number, std::vector<Interval>& parts) const {
    const Obstacle& o = section_.obstacles()[number];
    if (i.obstacle != kNone && section_.above(o, section_.obstacles()[i.obstacle]) != -beyond()) {
      parts.push_back(i);
      return;
    }
    Interval mine{i.from, i.to, number};
    if (section_.ahead(o.from.point, i.from) == Sign::Positive) {
      mine.from = o.from;
      parts.push_back({i.from, o.from, i.obstacle});
    }
    const bool ends_before = section_.ahead(o.to.point, i.to) == Sign::Negative;
    if (ends_before) mine.to = o.to;
    parts.push_back(mine);
    if (ends_before) parts.push_back({o.to, i.to, i.obstacle});
  }

  WallSection& section_;
  const Obstacle base_;
  bool is_up_;
  std::vector<Interval> seen_;
};

class SightWalls {
 public:
  SightWalls(const SpaceComplex& complex, SpaceTables& tables, Vertical& vertical)
      : c_(complex),
        tables_(tables),
        vertical_(vertical),
        sector_test_(complex),
        shadows_(complex, vertical) {}

  std::vector<WallPolygon> run(Context& context) {
    make_tree();
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (e % 64 == 0) context.checkpoint("walls", e, c_.edge_count());
      look_from(EdgeId(e));
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      const VolumeId around = c_.vertex_volume[v];
      if (around.is_valid() && c_.volume_mark[around] == 1) cut_across(VertexId(v));
    }
    return std::move(walls_);
  }

 private:
  void make_tree() {
    std::vector<Box3> boxes;
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) boxes.push_back(shadows_.of(FacetId(f)));
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_use[e].is_valid()) continue;
      free_edges_.push_back(EdgeId(e));
      boxes.push_back(shadows_.of(EdgeId(e)));
    }
    tree_ = BoxTree(boxes);
  }

  /// Makes the walls above and below one edge, if a marked volume with a reflex sector at the edge
  /// is there.
  void look_from(EdgeId e) {
    sectors_of(c_, e, sectors_);
    const bool is_any_reflex =
        std::any_of(sectors_.begin(), sectors_.end(),
                    [this](const Sector& s) { return sector_test_.is_reflex(s); });
    if (!is_any_reflex) return;
    if (vertical_.is_vertical(c_.edge_planes[e])) {
      if (!c_.edge_use[e].is_valid()) cut_across(c_.origin[2 * e.value()]);
      return;
    }
    const OrientedPlane wall = vertical_.through(c_.edge_planes[e]);
    // With wall = k (c_q n_p - c_p n_q), up.(n_W x d) = -k |...|^2, so the upper half-plane has the
    // opposite orientation (wall_section.h).
    const HalfPlane up{wall.plane(), -wall.orientation()};
    const HalfPlane down{wall.plane(), wall.orientation()};
    const bool sees_up = is_in_reflex_sector(up), sees_down = is_in_reflex_sector(down);
    if (!sees_up && !sees_down) return;
    WallSection section(c_, tables_, vertical_, wall.plane());
    gather(e, section);
    const Obstacle base = section.obstacle(e);
    if (sees_up) add_wall(section, base, true);
    if (sees_down) add_wall(section, base, false);
  }

  bool is_in_reflex_sector(HalfPlane h) const {
    return std::any_of(sectors_.begin(), sectors_.end(), [&](const Sector& s) {
      return sector_test_.is_reflex(s) && sector_test_.holds(s, h);
    });
  }

  /// Collects the obstacles above or below the edge.
  void gather(EdgeId e, WallSection& section) {
    Box3 query = shadows_.of(e);
    query.low[2] = -Box3::kInfinity;
    query.high[2] = Box3::kInfinity;
    found_.clear();
    tree_.for_each_meeting(query, [this](std::uint32_t i) { found_.push_back(i); });
    std::sort(found_.begin(), found_.end());
    for (const std::uint32_t i : found_) {
      if (i < c_.facet_count()) {
        section.add(FacetId(i));
      } else {
        section.note(free_edges_[i - c_.facet_count()]);
      }
    }
    section.add_edges();
  }

  /// Cuts the whole set at a point, or at a vertical line, that was removed from a volume. There is
  /// no edge at which a wall could begin.
  void cut_across(VertexId v) {
    const PlaneId wall = vertical_.through(c_.vertex_point[v], PlaneId());
    const PlaneId level = vertical_.level();
    // The coordinate of the axis `across` increases or decreases along the level lines of the wall.
    std::size_t across = (vertical_.axis() + 1) % 3;
    if (minor_sign(tables_.planes, wall, level, across) == Sign::Zero) {
      across = (vertical_.axis() + 2) % 3;
    }
    const Box3 all = box_of(c_);
    const auto [left, right] = beyond(all, across);
    const auto [low, high] = beyond(all, vertical_.axis());
    Point3Table& points = tables_.points;
    WallPolygon polygon{wall,
                        {points.add(wall, left, low), points.add(wall, left, high),
                         points.add(wall, right, high), points.add(wall, right, low)}};
    if (minor_sign(tables_.planes, wall, level, across) == Sign::Negative) {
      std::reverse(polygon.corners.begin(), polygon.corners.end());
    }
    walls_.push_back(std::move(polygon));
  }

  /// Returns two planes across an axis with the set between them.
  std::array<PlaneId, 2> beyond(const Box3& all, std::size_t axis) {
    const auto plane = [&](double at) {
      std::array<double, 3> n{};
      n[axis] = 1;
      return tables_.planes.intern(n[0], n[1], n[2], -at).plane();
    };
    const double infinity = std::numeric_limits<double>::max();
    return {plane(std::nextafter(all.low[axis], -infinity)),
            plane(std::nextafter(all.high[axis], infinity))};
  }

  void add_wall(WallSection& section, const Obstacle& base, bool is_up) {
    Sight sight(section, base, is_up);
    sight.run();
    walls_.push_back({section.wall(), sight.polygon()});
  }

  const SpaceComplex& c_;
  SpaceTables& tables_;
  Vertical& vertical_;
  SectorTest sector_test_;
  Shadows shadows_;
  BoxTree tree_;
  std::vector<EdgeId> free_edges_;
  std::vector<Sector> sectors_;
  std::vector<std::uint32_t> found_;
  std::vector<WallPolygon> walls_;
};

}  // namespace

std::vector<WallPolygon> sight_walls(const SpaceComplex& complex, SpaceTables& tables,
                                     Vertical& vertical, Context& context) {
  return SightWalls(complex, tables, vertical).run(context);
}

}  // namespace plumb
