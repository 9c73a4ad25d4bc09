// Walls that resolve vertical reflex edges. A cell is, seen along the vertical, a polygon; a wall
// prolongs the plane of a facet across the vertical edge, into the reflex angle, and ends at the
// first facet or earlier wall it meets. It is bounded below and above by chains of obstacles in its
// plane, which are followed one by one: an obstacle ends at a vertex, or at an edge that crosses
// the plane. The next obstacle begins at the same vertex or edge. So no coordinates are compared to
// follow a chain.
//
// Invariants: walls of one cell do not cross, because each wall stops at the first earlier wall
// (traces_); edges one upon the other on a vertical line are resolved together, from the topmost.
// Each wall divides a cell into two at most. A cell that lies above itself may be cut too early,
// and a later round repairs that (walls.cpp). See docs/design/walls.md, section Vertical walls.
// Tested by tests/convex/walls_test.cpp.
#include "plumb/convex/wall/wall_spread.h"

#include <algorithm>
#include <array>
#include <optional>

#include "plumb/convex/wall/wall_section.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {
namespace {

/// A vertical wall of a cell, seen along the vertical.
struct Trace {
  PlaneId plane;
  Station from, to;  // The place `from` is where the wall began.
};

/// A volume with its facets and the walls that it has received.
class Cell {
 public:
  Cell(const SpaceComplex& complex, SpaceTables& tables, Vertical& vertical, VolumeId volume,
       std::span<const FacetId> facets)
      : c_(complex),
        tables_(tables),
        vertical_(vertical),
        volume_(volume),
        facets_(facets),
        sector_test_(complex) {}

  /// Makes a wall from the topmost of the edges on one line at which the cell is reflex.
  void spread_from(const Sector& sector, std::vector<WallPolygon>& walls) {
    const Line line = line_of(sector);
    if (!line.is_topmost || is_resolved(sector, line)) return;
    if (!sector.first.is_valid()) {
      // If a line was removed from the cell, walls extend to both sides of it.
      const PlaneId plane = c_.edge_planes[sector.edge][0];
      run(plane, line, Sign::Positive, walls);
      run(plane, line, Sign::Negative, walls);
      return;
    }
    const HalfPlane facet = sector_test_.of_use(sector.first);
    // The facet extends along sense (n x d), where d is the direction of the edge. The direction n
    // x up is ahead (wall_section.h).
    const Sign facet_side = facet.sense * climb(sector.edge);
    run(facet.plane, line, -facet_side, walls);
  }

 private:
  /// Edges that lie one upon the other, given by the vertices at their ends.
  struct Line {
    VertexId top, bottom;
    bool is_topmost;
  };

  enum class Side : std::uint8_t { Ceiling, Floor };

  // ---- the line

  /// Returns Positive if half-edge 2e points upward.
  Sign climb(EdgeId e) const {
    const auto& [p, q] = c_.edge_planes[e];
    return det3_sign(tables_.planes, p, q, vertical_.level());
  }

  Line line_of(const Sector& sector) {
    const std::uint32_t h =
        2 * sector.edge.value() + (climb(sector.edge) == Sign::Positive ? 0 : 1);
    Line line{c_.target(HalfedgeId(h)), c_.origin[h], true};
    line.is_topmost = !reflex_beyond(HalfedgeId(h ^ 1U)).is_valid();
    for (HalfedgeId down(h); down.is_valid(); down = reflex_beyond(down)) {
      line.bottom = c_.origin[down];
    }
    return line;
  }

  /// Returns the half-edge that ends at the start of this one and has the same direction, if the
  /// cell is reflex there, too. Otherwise, returns an invalid id.
  HalfedgeId reflex_beyond(HalfedgeId h) {
    for (const HalfedgeId out : c_.star_of(c_.origin[h])) {
      const EdgeId e = SpaceComplex::edge_of(out);
      if (out == h || !vertical_.is_vertical(c_.edge_planes[e])) continue;
      sectors_of(c_, e, sectors_);
      for (const Sector& s : sectors_) {
        if (s.volume == volume_ && sector_test_.is_reflex(s)) return SpaceComplex::twin(out);
      }
    }
    return {};
  }

  // Whether an earlier wall of the cell ended at this line and left two angles that are not reflex.
  bool is_resolved(const Sector& sector, const Line& line) const {
    const SpacePoint x = c_.vertex_point[line.top];
    return std::any_of(traces_.begin(), traces_.end(), [&](const Trace& t) {
      if (side(tables_.points, x, t.plane) != Sign::Zero) return false;
      if (side(tables_.points, x, t.to.cross) != Sign::Zero) return false;
      // The half-plane of the wall leads back to the start of the wall.
      const Sign ahead = side(tables_.points, t.from.point, t.to.cross) *
                         det3_sign(tables_.planes, t.to.cross, t.plane, vertical_.level());
      return sector_test_.is_resolved_by(sector, {t.plane, ahead * climb(sector.edge)});
    });
  }

  // ---- a wall

  /// Makes one wall ahead of a line, between the chains of floor and ceiling. The wall ends at the
  /// nearest of their ends and the earlier walls of the cell.
  void run(PlaneId plane, const Line& line, Sign heading, std::vector<WallPolygon>& walls) {
    WallSection section(c_, tables_, vertical_, plane);
    for (const FacetId f : facets_) section.add(f);
    section.add_edges();
    const Station start = section.station(line.top);
    auto ceiling = follow(section, line.top, Side::Ceiling, heading);
    auto floor = follow(section, line.bottom, Side::Floor, heading);
    if (ceiling.empty() || floor.empty()) return;
    end_where_they_meet(section, heading, ceiling, floor);
    Station end = nearer(section, far_end(section, ceiling.back(), heading),
                         far_end(section, floor.back(), heading), heading);
    for (const Trace& t : traces_) {
      if (const auto hit = crossing(section, start, t, heading)) {
        end = nearer(section, end, *hit, heading);
      }
    }
    WallPolygon wall{plane, {}};
    add_corners(section, floor, end, heading, wall.corners);
    std::vector<SpacePoint> above;
    add_corners(section, ceiling, end, heading, above);
    wall.corners.insert(wall.corners.end(), above.rbegin(), above.rend());
    // The corners lead ahead along the floor and back under the ceiling, which is clockwise
    // (wall_section.h).
    if (heading == Sign::Positive) std::reverse(wall.corners.begin(), wall.corners.end());
    walls.push_back(std::move(wall));
    traces_.push_back({plane, start, end});
  }

  static Station near_end(const Obstacle& o, Sign heading) {
    return heading == Sign::Positive ? o.from : o.to;
  }
  static Station far_end(const WallSection& section, std::uint32_t o, Sign heading) {
    const Obstacle& obstacle = section.obstacles()[o];
    return heading == Sign::Positive ? obstacle.to : obstacle.from;
  }
  static Station nearer(const WallSection& section, const Station& a, const Station& b,
                        Sign heading) {
    return section.ahead(a.point, b) * heading == Sign::Positive ? b : a;
  }

  /// Returns the consecutive obstacles, beginning at the vertex.
  std::vector<std::uint32_t> follow(WallSection& section, VertexId from, Side side, Sign heading) {
    std::vector<std::uint32_t> chain;
    SpaceItem at = from;
    for (;;) {
      const std::uint32_t next = next_obstacle(section, at, side, heading);
      if (next == kNone || chain.size() > section.obstacles().size()) return chain;
      chain.push_back(next);
      at = far_item(section, next, heading);
      if (at.kind() == SpaceItem::Kind::Vertex && has_upright_edge(at.vertex(), side)) return chain;
    }
  }

  static SpaceItem far_item(const WallSection& section, std::uint32_t o, Sign heading) {
    const Obstacle& obstacle = section.obstacles()[o];
    return heading == Sign::Positive ? obstacle.to_item : obstacle.from_item;
  }

  /// Ends both chains at the first vertex in which floor and ceiling touch. The cell may continue
  /// behind it.
  static void end_where_they_meet(const WallSection& section, Sign heading,
                                  std::vector<std::uint32_t>& ceiling,
                                  std::vector<std::uint32_t>& floor) {
    std::vector<std::pair<SpaceItem, std::size_t>> places;
    for (std::size_t i = 0; i < floor.size(); ++i) {
      places.emplace_back(far_item(section, floor[i], heading), i + 1);
    }
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < ceiling.size(); ++i) {
      const SpaceItem item = far_item(section, ceiling[i], heading);
      const auto at =
          std::lower_bound(places.begin(), places.end(), std::pair{item, std::size_t{0}});
      if (at == places.end() || at->first != item) continue;
      ceiling.resize(i + 1);
      floor.resize(at->second);
      return;
    }
  }

  std::uint32_t next_obstacle(const WallSection& section, SpaceItem at, Side side, Sign heading) {
    const std::vector<Obstacle>& all = section.obstacles();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const SpaceItem begin = heading == Sign::Positive ? all[i].from_item : all[i].to_item;
      if (begin == at && bounds(section, all[i], side)) return i;
    }
    return kNone;
  }

  /// Whether the cell is below the obstacle (ceiling), or above it (floor).
  bool bounds(const WallSection& section, const Obstacle& o, Side side) {
    const bool looks_up = side == Side::Floor;
    if (o.owner.kind() == SpaceItem::Kind::Facet) {
      const bool is_positive_side = (vertical_.rise(o.plane) == Sign::Positive) == looks_up;
      return c_.facet_volume[o.owner.index()][is_positive_side ? 0 : 1] == volume_;
    }
    const EdgeId e = o.owner.edge();
    const OrientedPlane wall = vertical_.through(c_.edge_planes[e]);
    const HalfPlane half{section.wall(), looks_up ? -wall.orientation() : wall.orientation()};
    sectors_of(c_, e, sectors_);
    return std::any_of(sectors_.begin(), sectors_.end(), [&](const Sector& s) {
      return s.volume == volume_ && sector_test_.holds(s, half);
    });
  }

  /// Whether an edge of the boundary of the cell leads straight down from a vertex of the ceiling,
  /// or straight up from a vertex of the floor.
  bool has_upright_edge(VertexId v, Side side) {
    for (const HalfedgeId h : c_.star_of(v)) {
      const EdgeId e = SpaceComplex::edge_of(h);
      if (!vertical_.is_vertical(c_.edge_planes[e])) continue;
      const bool runs_up = (climb(e) == Sign::Positive) != SpaceComplex::is_reverse(h);
      if (runs_up != (side == Side::Floor)) continue;
      sectors_of(c_, e, sectors_);
      if (std::any_of(sectors_.begin(), sectors_.end(),
                      [this](const Sector& s) { return s.volume == volume_; })) {
        return true;
      }
    }
    return false;
  }

  /// If the wall from `start` meets an earlier wall ahead, returns the meeting place.
  std::optional<Station> crossing(WallSection& section, const Station& start, const Trace& t,
                                  Sign heading) {
    const PlaneId wall = section.wall();
    if (t.plane == wall) {
      Station best = nearer(section, t.from, t.to, heading);
      if (section.ahead(best.point, start) * heading != Sign::Positive) return {};
      return best;
    }
    const Sign a = side(tables_.points, t.from.point, wall);
    const Sign b = side(tables_.points, t.to.point, wall);
    if (a == b) return {};
    if (det3_sign(tables_.planes, wall, t.plane, vertical_.level()) == Sign::Zero) return {};
    const SpacePoint x = tables_.points.add(wall, t.plane, vertical_.level());
    if (section.ahead(x, start) * heading != Sign::Positive) return {};
    return Station{x, t.plane};
  }

  /// Appends the points of a chain up to a station.
  static void add_corners(WallSection& section, const std::vector<std::uint32_t>& chain,
                          const Station& end, Sign heading, std::vector<SpacePoint>& corners) {
    for (const std::uint32_t i : chain) {
      const Obstacle o = section.obstacles()[i];
      const Station from = near_end(o, heading);
      if (section.ahead(end.point, from) * heading != Sign::Positive) return;
      corners.push_back(section.corner(from, o.plane));
      const Station to = nearer(section, far_end(section, i, heading), end, heading);
      corners.push_back(section.corner(to, o.plane));
    }
  }

  const SpaceComplex& c_;
  SpaceTables& tables_;
  Vertical& vertical_;
  VolumeId volume_;
  std::span<const FacetId> facets_;
  SectorTest sector_test_;
  std::vector<Trace> traces_;
  std::vector<Sector> sectors_;
};

/// For each volume, a list of cells. All lists are in one array.
template <class T>
struct ByVolume {
  std::vector<std::uint32_t> begin;
  std::vector<T> entry;

  ByVolume(std::size_t volumes, std::vector<std::pair<VolumeId, T>> pairs) : begin(volumes + 1, 0) {
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& [volume, item] : pairs) {
      ++begin[volume.value() + 1];
      entry.push_back(item);
    }
    for (std::size_t v = 0; v < volumes; ++v) begin[v + 1] += begin[v];
  }
  std::span<const T> of(std::size_t v) const {
    return std::span(entry).subspan(begin[v], begin[v + 1] - begin[v]);
  }
};

ByVolume<FacetId> facets_by_volume(const SpaceComplex& c) {
  std::vector<std::pair<VolumeId, FacetId>> pairs;
  for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
    const auto& [above, below] = c.facet_volume[f];
    pairs.emplace_back(above, FacetId(f));
    if (below != above) pairs.emplace_back(below, FacetId(f));
  }
  return {c.volume_count(), std::move(pairs)};
}

/// Returns the reflex sectors of vertical edges for each volume.
ByVolume<Sector> reflex_sectors_by_volume(const SpaceComplex& c, Vertical& vertical) {
  std::vector<std::pair<VolumeId, Sector>> pairs;
  const SectorTest test(c);
  std::vector<Sector> sectors;
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    if (!vertical.is_vertical(c.edge_planes[e])) continue;
    sectors_of(c, EdgeId(e), sectors);
    for (const Sector& s : sectors) {
      if (test.is_reflex(s)) pairs.emplace_back(s.volume, s);
    }
  }
  return {c.volume_count(), std::move(pairs)};
}

}  // namespace

std::vector<WallPolygon> spread_walls(const SpaceComplex& complex, SpaceTables& tables,
                                      Vertical& vertical, Context& context) {
  const auto sectors = reflex_sectors_by_volume(complex, vertical);
  const auto facets = facets_by_volume(complex);
  std::vector<WallPolygon> walls;
  for (std::uint32_t v = 0; v < complex.volume_count(); ++v) {
    Cell cell(complex, tables, vertical, VolumeId(v), facets.of(v));
    for (const Sector& s : sectors.of(v)) {
      context.checkpoint("walls", v, complex.volume_count());
      cell.spread_from(s, walls);
    }
  }
  return walls;
}

}  // namespace plumb
