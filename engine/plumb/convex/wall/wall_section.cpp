// Sections of a complex with a vertical plane W.
//
// A facet's boundary is walked once. Each crossing with W, and each corner on W, becomes a Cut with
// the number of times the boundary crosses a line beside W, on its negative side; cuts are sorted
// along the line of facet and W by exact signs, and between two consecutive cuts the line is inside
// the facet if the number of crossings so far is odd. Pieces along sides of the facet are left out:
// these are edges in W, which several facets share, and are added once each.
//
// Angles at edges (SectorTest) are compared by the sign of the sine of two half-planes, with half
// turns separate, so no angle is ever computed. Vertical planes through a line belong to the pencil
// of the planes of the line, so their numbers are no longer than for two planes of the set. See
// docs/design/walls.md, section Vertical walls.
// Tested by tests/convex/walls_test.cpp.
#include "plumb/convex/wall/wall_section.h"

#include <algorithm>

#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

Integer dot(const IntegerRow& row, const std::array<Integer, 3>& v) {
  return row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
}

}  // namespace

Vertical::Vertical(const std::array<Integer, 3>& direction, SpaceTables& tables)
    : direction_(direction), tables_(tables) {
  for (std::size_t i = 1; i < 3; ++i) {
    if (abs(direction_[i]) > abs(direction_[axis_])) axis_ = i;
  }
  PLUMB_CHECK(direction_[axis_] != 0);
  if (direction_[axis_] < 0) {
    for (Integer& d : direction_) d = -d;
  }
}

/// The sign of the scalar product of a normal and a direction, computed once for each plane.
Sign Vertical::rise(PlaneId p) {
  if (p.value() >= rise_.size()) rise_.resize(tables_.planes.size(), FilteredSign::Unsure);
  FilteredSign& known = rise_[p];
  if (!is_decided(known)) {
    known = filtered(sign_of(dot(tables_.planes.coefficients(p), direction_)));
  }
  return decided(known);
}

/// Returns the combination of the two planes whose normal is orthogonal to the direction. The
/// weight of each row is the product of the direction with the other row.
OrientedPlane Vertical::through(const std::array<PlaneId, 2>& line) {
  const Integer first = dot(tables_.planes.coefficients(line[0]), direction_);
  const Integer second = dot(tables_.planes.coefficients(line[1]), direction_);
  const OrientedPlane wall = tables_.planes.intern(Pencil{line[0], line[1], first, second});
  PLUMB_CHECK(wall.is_valid());
  return wall;
}

PlaneId Vertical::through(SpacePoint x, PlaneId avoided) {
  const RationalPoint3 at = exact(tables_.points, x);
  const std::array<Integer, 3>& d = direction_;
  PlaneId other;
  for (std::size_t i = 0; i < 3 && !other.is_valid(); ++i) {
    // The normal d x e_i is orthogonal to the vertical.
    std::array<Rational, 3> n;
    n[(i + 1) % 3] = d[(i + 2) % 3];
    n[(i + 2) % 3] = -d[(i + 1) % 3];
    const Rational offset = -(n[0] * at.x + n[1] * at.y + n[2] * at.z);
    const OrientedPlane plane = tables_.planes.intern(n[0], n[1], n[2], offset);
    if (plane.is_valid() && plane.plane() != avoided) other = plane.plane();
  }
  // At every point, there are at least two vertical planes of this form.
  PLUMB_CHECK(other.is_valid());
  return other;
}

double Vertical::slope(std::size_t axis) const {
  return nearest_double(Rational(direction_[axis], direction_[axis_]));
}

void sectors_of(const SpaceComplex& complex, EdgeId e, std::vector<Sector>& sectors) {
  sectors.clear();
  const UseId any = complex.edge_use[e];
  if (!any.is_valid()) {
    const VolumeId around = complex.edge_volume[e];
    if (complex.volume_mark[around] == 1) sectors.push_back({e, around, {}, {}});
    return;
  }
  UseId u = any;
  do {
    const UseId next = complex.use_radial[u];
    const VolumeId between = complex.volume_after(u);
    if (complex.volume_mark[between] == 1) sectors.push_back({e, between, u, next});
    u = next;
  } while (u != any);
}

Sign SectorTest::sine(EdgeId e, HalfPlane from, HalfPlane to) const {
  if (from.plane == to.plane) return Sign::Zero;
  const auto& [p, q] = c_.edge_planes[e];
  return turn_about_line(c_.planes(), p, q, from.plane, to.plane) * from.sense * to.sense;
}

/// Two half-planes of one plane are equal or opposite. Otherwise, the sine decides,
/// counter-clockwise about half-edge 2e.
int SectorTest::turn(EdgeId e, HalfPlane from, HalfPlane to) const {
  const Sign s = sine(e, from, to);
  if (s == Sign::Zero) return from.sense == to.sense ? 0 : 2;
  return s == Sign::Positive ? 1 : 3;
}

bool SectorTest::is_reflex(const Sector& s) const {
  if (!s.first.is_valid() || s.first == s.second) return true;
  return turn(s.edge, of_use(s.first), of_use(s.second)) == 3;
}

/// Compares the turns from the first facet. A second sine is needed only if both are in the same
/// half turn.
bool SectorTest::holds(const Sector& s, HalfPlane h) const {
  if (!s.first.is_valid()) return true;
  const int at = turn(s.edge, of_use(s.first), h);
  if (at == 0) return false;
  if (s.first == s.second) return true;
  const int end = turn(s.edge, of_use(s.first), of_use(s.second));
  if (at != end) return at < end;
  return at != 2 && sine(s.edge, h, of_use(s.second)) == Sign::Positive;
}

bool SectorTest::is_resolved_by(const Sector& s, HalfPlane h) const {
  if (!s.first.is_valid() || !holds(s, h)) return false;
  return turn(s.edge, of_use(s.first), h) <= 2 && turn(s.edge, h, of_use(s.second)) <= 2;
}

void WallSection::note(EdgeId e) {
  for (std::uint32_t h = 2 * e.value(); h < 2 * e.value() + 2; ++h) {
    const SpacePoint x = c_.vertex_point[c_.origin[h]];
    if (side(tables_.points, x, wall_) != Sign::Zero) return;
  }
  if (!vertical_.is_vertical(c_.edge_planes[e])) edges_.push_back(e);
}

void WallSection::add_edges() {
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  for (const EdgeId e : edges_) obstacles_.push_back(obstacle(e));
}

/// If a facet lies in a vertical plane other than W, all its pieces are vertical. If a facet lies
/// in W, only its edges are pieces.
void WallSection::add(FacetId f) {
  const PlaneId plane = c_.facet_plane[f];
  const bool is_upright = vertical_.rise(plane) == Sign::Zero;
  if (is_upright && plane != wall_) return;
  gather(f);
  for (const EdgeId e : sides_) {
    if (!vertical_.is_vertical(c_.edge_planes[e])) edges_.push_back(e);
  }
  if (plane == wall_ || cuts_.size() < 2) return;
  order(plane);
  int crossings = 0;
  for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
    crossings += cuts_[i].crossings;
    const Cut &from = cuts_[i], &to = cuts_[i + 1];
    if (crossings % 2 == 0 || from.item == to.item || is_side(from, to)) continue;
    obstacles_.push_back({plane, f, station(from), station(to), from.item, to.item});
  }
}

// ---------------------------------------------------------------- the section of a facet

void WallSection::gather(FacetId f) {
  cuts_.clear();
  sides_.clear();
  for (const UseId cycle : c_.cycles_of(f)) gather(cycle);
  for (const VertexId v : c_.inner_of(f)) {
    const SpacePoint x = c_.vertex_point[v];
    if (side(tables_.points, x, wall_) == Sign::Zero) cuts_.push_back({x, v, 0});
  }
}

/// Walks one boundary cycle with the sides of three consecutive corners at hand. A corner on W
/// counts a crossing for each neighbour on the negative side, so a boundary that touches W counts
/// two or none.
void WallSection::gather(UseId cycle) {
  const auto side_of = [&](UseId u) {
    return side(tables_.points, c_.vertex_point[c_.use_origin(u)], wall_);
  };
  UseId u = cycle;
  Sign before = side_of(c_.use_prev[u]), at = side_of(u);
  do {
    const UseId next = c_.use_next[u];
    const Sign after = side_of(next);
    const EdgeId e = SpaceComplex::edge_of(c_.use_halfedge[u]);
    if (at == Sign::Zero) {
      const VertexId v = c_.use_origin(u);
      const int crossings = (before == Sign::Negative ? 1 : 0) + (after == Sign::Negative ? 1 : 0);
      cuts_.push_back({c_.vertex_point[v], v, crossings});
      if (after == Sign::Zero) sides_.push_back(e);
    } else if (at * after == Sign::Negative) {
      const auto& [p, q] = c_.edge_planes[e];
      cuts_.push_back({tables_.points.add(p, q, wall_), e, 1});
    }
    before = at;
    at = after;
    u = next;
  } while (u != cycle);
}

/// Sorts the cuts by the direction "ahead" along the line of W and the facet's plane.
void WallSection::order(PlaneId plane) {
  const bool runs_back = vertical_.rise(plane) == Sign::Positive;
  std::sort(cuts_.begin(), cuts_.end(), [&](const Cut& a, const Cut& b) {
    if (a.item == b.item) return false;
    const Sign s = order_along_line(tables_.points, plane, wall_, a.point, b.point);
    return s == (runs_back ? Sign::Negative : Sign::Positive);
  });
}

bool WallSection::is_side(const Cut& a, const Cut& b) const {
  if (a.item.kind() != SpaceItem::Kind::Vertex || b.item.kind() != SpaceItem::Kind::Vertex) {
    return false;
  }
  return std::any_of(sides_.begin(), sides_.end(), [&](EdgeId e) {
    const VertexId v = c_.origin[2 * e.value()], w = c_.origin[2 * e.value() + 1];
    return (v == a.item.vertex() && w == b.item.vertex()) ||
           (w == a.item.vertex() && v == b.item.vertex());
  });
}

// ---------------------------------------------------------------- places

Station WallSection::station(const Cut& cut) {
  if (cut.item.kind() == SpaceItem::Kind::Vertex) return station(cut.item.vertex());
  return {cut.point, vertical_.through(c_.edge_planes[cut.item.index()]).plane()};
}

/// Searches for an existing vertical plane through the vertex: the plane of a vertical edge, or the
/// wall of another edge. A new plane is needed only if the vertex has no such edge.
Station WallSection::station(VertexId v) {
  const SpacePoint x = c_.vertex_point[v];
  for (const HalfedgeId h : c_.star_of(v)) {
    const auto& planes = c_.edge_planes[h.value() / 2];
    if (vertical_.is_vertical(planes)) return {x, planes[planes[0] == wall_ ? 1 : 0]};
    const PlaneId cross = vertical_.through(planes).plane();
    if (cross != wall_) return {x, cross};
  }
  return {x, vertical_.through(x, wall_)};
}

Obstacle WallSection::obstacle(EdgeId e) {
  const auto& planes = c_.edge_planes[e];
  const PlaneId plane = planes[vertical_.rise(planes[0]) == Sign::Zero ? 1 : 0];
  VertexId v = c_.origin[2 * e.value()], w = c_.origin[2 * e.value() + 1];
  Station from = station(v), to = station(w);
  if (ahead(to.point, from) == Sign::Negative) {
    std::swap(from, to);
    std::swap(v, w);
  }
  return {plane, e, from, to, v, w};
}

Sign WallSection::ahead(SpacePoint x, const Station& s) const {
  if (x == s.point) return Sign::Zero;
  const Sign beside = side(tables_.points, x, s.cross);
  if (beside == Sign::Zero) return beside;
  return beside * det3_sign(tables_.planes, s.cross, wall_, vertical_.level());
}

Sign WallSection::above(SpacePoint x, PlaneId plane) const {
  return side(tables_.points, x, plane) * vertical_.rise(plane);
}

/// Obstacles do not cross, so a comparison at one end of their overlap decides, and the other end
/// decides if they meet in the first.
Sign WallSection::above(const Obstacle& x, const Obstacle& y) const {
  const Sign at_from = ahead(x.from.point, y.from) != Sign::Negative
                           ? above(x.from.point, y.plane)
                           : -above(y.from.point, x.plane);
  if (at_from != Sign::Zero) return at_from;
  return ahead(x.to.point, y.to) != Sign::Positive ? above(x.to.point, y.plane)
                                                   : -above(y.to.point, x.plane);
}

/// If the plane contains the station's own point, this point is used, so that the point does not
/// get a second definition.
SpacePoint WallSection::corner(const Station& s, PlaneId plane) {
  if (side(tables_.points, s.point, plane) == Sign::Zero) return s.point;
  return tables_.points.add(wall_, plane, s.cross);
}

}  // namespace plumb
