// A face of a plane complex as half-edges of its own, and the operations that cut it.
//
// Predicates work on headings (a line and a direction), never on points that cuts made: turns are
// signs of cross products of lines given by input points, so their degree does not grow with the
// number of cuts. Splitting an edge keeps its line; a vertex on it is a crossing of two lines of
// the set.
//
// RegionMaker translates a face in time of its own size: its maps from the complex to the region
// are cleared entry by entry (forget()), not as a whole. A marked vertex goes to the least marked
// face around it, and a marked edge to the one marked face at it, of which a minimal complex has at
// most one.
// Tested by tests/convex/plane_partition_test.cpp.
#include "plumb/convex/region/plane_region.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/plane/plane_points.h"

namespace plumb {
namespace {

Sign oriented(Sign s, bool is_opposite) { return is_opposite ? -s : s; }

}  // namespace

// ---------------------------------------------------------------- reading

bool PlaneRegion::is_bounded() const {
  return std::ranges::find(vertex_point, kAtInfinity) == vertex_point.end();
}

/// Headings along one line are parallel, which needs no arithmetic. All lines point upwards, so
/// `back` flips the sign.
Sign PlaneRegion::cross(Heading x, Heading y) const {
  if (x.line == y.line) return Sign::Zero;
  const Sign s = cross_sign(points.inputs, x.line.a, x.line.b, y.line.a, y.line.b);
  return oriented(s, x.back != y.back);
}

Sign PlaneRegion::side(Heading x, std::uint32_t point) const {
  return oriented(orient2d(points, x.line.a, x.line.b, point), x.back);
}

Sign PlaneRegion::ahead(Heading x, std::uint32_t point, std::uint32_t of) const {
  return oriented(compare_xy(points, point, of), x.back);
}

/// If the angle is exactly a half turn, the cross product is Zero and the directions are opposite.
/// A full turn, from a half-edge to itself, is not convex.
bool PlaneRegion::is_convex_turn(HalfedgeId from, HalfedgeId to) const {
  if (from == to) return false;
  const Heading x = heading(from), y = heading(to);
  const Sign turn = cross(x, y);
  return turn == Sign::Positive || (turn == Sign::Zero && !is_same_way(x, y));
}

bool PlaneRegion::is_reflex(HalfedgeId corner) const {
  if (is_at_infinity(start(corner))) return false;
  return !is_convex_turn(corner, twin(before(corner)));
}

/// The wedge extends counter-clockwise from `first` to `last`. If its angle is less than a half
/// turn, the heading must lie left of the first side and right of the last side. If the angle is
/// more, one of the two conditions is enough. If it is exactly a half turn, the first side decides.
/// A full turn contains every heading except that of its only side.
bool PlaneRegion::leads_into(HalfedgeId corner, Heading x) const {
  const Heading first = heading(corner), last = heading(before(corner)).reversed();
  const Sign from_first = cross(first, x), to_last = cross(x, last);
  const Sign wedge = cross(first, last);
  if (wedge == Sign::Positive) return from_first == Sign::Positive && to_last == Sign::Positive;
  if (wedge == Sign::Negative) return from_first == Sign::Positive || to_last == Sign::Positive;
  if (!is_same_way(first, last)) return from_first == Sign::Positive;
  return from_first != Sign::Zero || !is_same_way(first, x);
}

Heading PlaneRegion::from_to(VertexId a, VertexId b) const {
  const std::uint32_t p = point(a), q = point(b);
  const bool back = compare_xy(points, p, q) == Sign::Positive;
  return {back ? PlaneLine{q, p} : PlaneLine{p, q}, back};
}

std::size_t PlaneRegion::count_loops() const {
  IdVector<HalfedgeId, std::uint8_t> is_seen(halfedge_count(), 0);
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < halfedge_count(); ++i) {
    if (is_seen[i] != 0 || !is_inside(HalfedgeId(i))) continue;
    ++count;
    for (HalfedgeId h(i); is_seen[h] == 0; h = after(h)) is_seen[h] = 1;
  }
  return count;
}

std::uint64_t PlaneRegion::count_reflex_corners() const {
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (is_inside(h) && is_reflex(h)) ++count;
  }
  for (const Corner& c : loops) count += c.is_other() ? 1 : 0;
  return count;
}

// ---------------------------------------------------------------- cutting

VertexId PlaneRegion::add_vertex(std::uint32_t at, bool mark) {
  vertex_point.push_back(at);
  vertex_mark.push_back(mark ? 1 : 0);
  return VertexId(vertex_count() - 1);
}

HalfedgeId PlaneRegion::new_edge(VertexId from, VertexId to, Heading along) {
  origin.push_back(along.back ? to : from);
  origin.push_back(along.back ? from : to);
  next.resize(origin.size());
  prev.resize(origin.size());
  line.push_back(along.line);
  edge_mark.push_back(1);
  is_cut.push_back(1);
  is_frame.push_back(0);
  return HalfedgeId(2 * (line.size() - 1) + (along.back ? 1 : 0));
}

/// Links a new edge between two corners. At an isolated vertex, the edge returns to itself. At a
/// corner, it lies between the half-edge that arrives and the half-edge that leaves.
HalfedgeId PlaneRegion::add_edge(Corner from, Corner to, Heading along) {
  const HalfedgeId h = new_edge(vertex_at(from), vertex_at(to), along);
  const auto attach = [this](HalfedgeId leaving, Corner at) {
    if (!at.is_halfedge()) return link(twin(leaving), leaving);
    const HalfedgeId arriving = before(at.halfedge());
    link(twin(leaving), at.halfedge());
    link(arriving, leaving);
  };
  attach(h, from);
  attach(twin(h), to);
  return h;
}

HalfedgeId PlaneRegion::split_edge(HalfedgeId h, VertexId at) {
  const EdgeId old = edge_of(h);
  const VertexId to = target(h);
  const HalfedgeId on = new_edge(at, to, heading(h)), back = twin(h);
  edge_mark.back() = edge_mark[old];
  is_cut.back() = is_cut[old];
  is_frame.back() = is_frame[old];
  // If both sides are inside, the far end is linked first, because one of the half-edges may follow
  // the other there.
  if (is_inside(back)) {
    const HalfedgeId arriving = before(back);
    link(arriving, twin(on));
    link(twin(on), back);
  }
  origin[back] = at;
  const HalfedgeId following = after(h);
  link(h, on);
  link(on, following);
  return on;
}

/// Unlinks the edge on both sides. Its half-edges count as outside afterwards.
void PlaneRegion::remove_edge(HalfedgeId h) {
  const HalfedgeId back = twin(h);
  const HalfedgeId after_h = after(h), after_back = after(back);
  const HalfedgeId before_h = before(h), before_back = before(back);
  link(before_h, after_back);
  link(before_back, after_h);
  next[h] = next[back] = prev[h] = prev[back] = HalfedgeId();
}

// ---------------------------------------------------------------- making

/// Finds the owner of every vertex once for all regions. The owner is the marked face at the vertex
/// that has the least id.
RegionMaker::RegionMaker(const PlaneComplex& complex)
    : c_(complex),
      owner_(complex.vertex_count()),
      vertex_(complex.dcel.vertex_count()),
      edge_(complex.dcel.edge_count()),
      input_(complex.points.size(), kNone) {
  for (std::uint32_t i = 0; i < complex.vertex_count(); ++i) {
    const VertexId v(i);
    const auto take = [&](FaceId f) {
      if (!complex.is_beyond(f) && complex.mark(f) && !(owner_[i].is_valid() && owner_[i] < f)) {
        owner_[i] = f;
      }
    };
    if (complex.dcel.is_isolated(v)) {
      take(complex.dcel.face(complex.dcel.isolated_loop(v)));
      continue;
    }
    for (const HalfedgeId h : complex.dcel.around(v)) take(complex.dcel.face(h));
  }
}

/// Copies the loops of a face. A level point is added to the right of each isolated vertex, which
/// has no side of its own to be joined along (region_cuts.h).
PlaneRegion RegionMaker::region(FaceId face) {
  region_ = {};
  face_ = face;
  for (const LoopId l : c_.dcel.loops_of(face)) add_loop(l);
  if (is_unbounded(c_, face) && region_.is_bounded()) add_frame();
  region_.first_level_point = static_cast<std::uint32_t>(region_.points.inputs.size());
  for (const Corner& c : region_.loops) {
    if (!c.is_other()) continue;
    const RationalPoint2 at = exact(region_.points, region_.point(c.other()));
    region_.points.inputs.push_back(at.x + 1, at.y);
  }
  forget();
  return std::move(region_);
}

void RegionMaker::add_loop(LoopId l) {
  const Corner first = c_.dcel.first(l);
  if (first.is_other()) {
    region_.loops.push_back(vertex(first.other()));
    return;
  }
  const auto local = [this](HalfedgeId h) {
    return HalfedgeId(2 * edge(edge_of(h)).value() + (h.value() & 1U));
  };
  for (const HalfedgeId h : c_.dcel.along(l)) {
    const HalfedgeId here = local(h), following = local(c_.dcel.next(h));
    region_.next[here] = following;
    region_.prev[following] = here;
  }
  region_.loops.push_back(local(first.halfedge()));
}

/// Adds a frame of one vertex and one edge. The region is to the left of its first half-edge.
void RegionMaker::add_frame() {
  const VertexId v = region_.add_vertex(PlaneRegion::kAtInfinity, false);
  const HalfedgeId h = region_.new_edge(v, v, {{0, 0}, false});
  region_.is_cut.back() = 0;
  region_.is_frame.back() = 1;
  region_.next[h] = region_.prev[h] = h;
  region_.loops.push_back(h);
}

VertexId RegionMaker::vertex(VertexId v) {
  VertexId& local = vertex_[v];
  if (local.is_valid()) return local;
  vertices_.push_back(v);
  if (c_.is_at_infinity(v)) {
    local = region_.add_vertex(PlaneRegion::kAtInfinity, false);
  } else {
    const std::uint32_t at = input(c_.vertex_point[v]);
    local = region_.add_vertex(at, c_.mark(v) && owner(v) == face_);
  }
  return local;
}

EdgeId RegionMaker::edge(EdgeId e) {
  EdgeId& local = edge_[e];
  if (local.is_valid()) return local;
  edges_.push_back(e);
  const bool is_frame = c_.is_frame(e);
  const PlaneLine along = is_frame ? PlaneLine{0, 0} : line(c_.line[e]);
  const VertexId from = vertex(c_.dcel.origin(first_half(e)));
  const VertexId to = vertex(c_.dcel.target(first_half(e)));
  local = edge_of(region_.new_edge(from, to, {along, false}));
  // In a minimal complex a marked edge has no marked face on both sides, so it belongs to this
  // region.
  region_.edge_mark.back() = !is_frame && c_.mark(e) ? 1 : 0;
  region_.is_cut.back() = 0;
  region_.is_frame.back() = is_frame ? 1 : 0;
  return local;
}

std::uint32_t RegionMaker::input(std::uint32_t point) {
  std::uint32_t& local = input_[point];
  if (local != kNone) return local;
  inputs_.push_back(point);
  PointTable2& table = region_.points.inputs;
  local = static_cast<std::uint32_t>(table.size());
  const PlanePointsView all(c_.points);
  if (all.is_input(point) && all.inputs().is_double(point)) {
    table.push_back(all.inputs().approx(point));
  } else {
    const RationalPoint2 at = exact(all, point);
    table.push_back(at.x, at.y);
  }
  return local;
}

void RegionMaker::forget() {
  for (const VertexId v : vertices_) vertex_[v] = VertexId();
  for (const EdgeId e : edges_) edge_[e] = EdgeId();
  for (const std::uint32_t p : inputs_) input_[p] = kNone;
  vertices_.clear();
  edges_.clear();
  inputs_.clear();
}

}  // namespace plumb
