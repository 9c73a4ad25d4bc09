// One cut: splits edges and faces along the selected component of a section, adds a wall to either
// side, and collects the pieces by a flood over faces.
//
// Walls are two faces with the same boundary, one for each side of T. Invariants after the split:
// every segment of the component is a half-edge pair (low, high) across a face, or an edge in T;
// the low wall is joined to what lies below T and the high wall to what lies above it. At an edge
// in T the sheets are joined in the order in which they are met inside the solid. The low side owns
// the points of T: its wall has mark 1, and of the rings into which a vertex is divided one on the
// lower side keeps the vertex's mark, so every point of the set still belongs to one copy.
//
// A cut adds at most one piece and makes no reflex edges: docs/design/walls.md, section Cuts,
// Lemmas 1 and 2.
// Tested by tests/convex/cut_surface_test.cpp.
#include "plumb/convex/part/surface_cut.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "plumb/convex/decompose.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {

std::vector<RingSide> ring_of(const CutSurface& surface, HalfedgeId first) {
  std::vector<RingSide> ring;
  HalfedgeId h = first;
  do {
    const CutSurface::Half& half = surface.half(h);
    ring.push_back({half.origin, surface.target(h), half.other, half.along});
    h = half.next;
  } while (h != first);
  return ring;
}

bool is_hole(const CutSurface& surface, OrientedPlane plane, std::span<const RingSide> ring) {
  const auto point = [&](VertexId v) { return surface.point[v]; };
  VertexId least = ring[0].from;
  for (const RingSide& side : ring) {
    if (side.from != least &&
        compare_xyz(surface.points(), point(side.from), point(least)) == Sign::Negative) {
      least = side.from;
    }
  }
  // A ring may pass through the vertex several times. It is a hole if it turns right at one of its
  // corners there.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i].from != least) continue;
    const RingSide& before = ring[i == 0 ? ring.size() - 1 : i - 1];
    const Sign turn = det3_sign(surface.planes(), plane.plane(), before.other, ring[i].other) *
                      before.along * ring[i].along * plane.orientation();
    // If the turn is Zero, the ring runs back along itself, inside of another ring.
    if (turn != Sign::Positive) return true;
  }
  return false;
}

namespace {

/// Returns the axis of the smallest component of the normal. The plane is not perpendicular to it.
std::size_t level_axis(const PlaneRow& row) {
  const std::array<double, 3> n{std::abs(row.n[0]), std::abs(row.n[1]), std::abs(row.n[2])};
  if (n[0] <= n[1] && n[0] <= n[2]) return 0;
  return n[1] <= n[2] ? 1 : 2;
}

}  // namespace

RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   VertexId v) {
  const Point3Table& points = surface.points();
  const std::size_t axis = level_axis(surface.planes().row(plane));
  const SpacePoint x = surface.point[v];
  int winding = 0;
  for (const RingSide& side : ring) {
    if (side.from == v || side.to == v) return RingPlace::On;
    const Sign a = compare_axis(points, surface.point[side.from], x, axis);
    const Sign b = compare_axis(points, surface.point[side.to], x, axis);
    if (a == b && a != Sign::Zero) continue;
    const Sign left = plumb::side(points, x, side.other) * side.along * Sign::Negative;
    if (left == Sign::Zero && (a != b || a == Sign::Zero)) {
      // The vertex is on the line of the side: either between the ends, or on the level line of a
      // side that is level.
      if (a != Sign::Zero || b != Sign::Zero) return RingPlace::On;
      const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
      for (const std::size_t k : {second, third}) {
        const Sign c = compare_axis(points, surface.point[side.from], x, k);
        const Sign d = compare_axis(points, surface.point[side.to], x, k);
        if (c != d) return RingPlace::On;
      }
      continue;
    }
    const bool is_above_a = a == Sign::Positive, is_above_b = b == Sign::Positive;
    if (is_above_a == is_above_b) continue;
    if (is_above_b && left == Sign::Positive) ++winding;
    if (is_above_a && left == Sign::Negative) --winding;
  }
  return winding == 0 ? RingPlace::Outside : RingPlace::Inside;
}

RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   std::span<const RingSide> other) {
  for (const RingSide& side : other) {
    const RingPlace place = place_in(surface, plane, ring, side.from);
    if (place != RingPlace::On) return place;
  }
  return RingPlace::On;
}

/// No half-edge or face changes before the section has been found and accepted. Therefore a plane
/// that is refused leaves only unused points.
CutPieces PlaneCut::run(std::span<const FaceId> faces, PlaneId plane, HalfedgeId seed) {
  plane_ = plane;
  new_faces_.clear();
  if (!section_.find(faces, plane, seed)) return {};
  split_edges();
  split_faces();
  make_walls();
  return flood(faces);
}

// ---------------------------------------------------------------- split

/// Splits the edges in which selected chords end. Two chords may end in the same edge, one in each
/// face beside it. The second chord then already ends in the new vertex.
void PlaneCut::split_edges() {
  for (const Segment& segment : section_.segments()) {
    if (segment.half.is_valid() || !section_.is_selected(segment)) continue;
    for (const std::uint32_t i : {segment.start, segment.end}) {
      const Event& event = section_.events()[i];
      if (event.is_crossing && s_.target(event.at) != event.vertex) {
        split_edge(event.at, event.vertex);
      }
    }
  }
}

/// Splits an edge. Half-edge h from a to b now leads from a to x, and a new half-edge leads from x
/// to b. The other side is split in the same way.
void PlaneCut::split_edge(HalfedgeId h, VertexId at) {
  const HalfedgeId t = s_.half(h).twin;
  const HalfedgeId h2(s_.halves.size()), t2(s_.halves.size() + 1);
  for (const HalfedgeId old : {h, t}) {
    CutSurface::Half half = s_.half(old);
    half.origin = at;
    half.origin_mark = half.mark;
    half.prev = old;
    half.next_cycle = {};
    half.twin = old == h ? t : h;
    s_.halves.push_back(half);
    const HalfedgeId added(s_.halves.size() - 1);
    s_.half(half.next).prev = added;
    s_.half(old).next = added;
    s_.half(old).twin = old == h ? t2 : h2;
  }
}

/// Returns the half-edge at the corner in whose sector a direction begins. An earlier chord may
/// have divided the sector.
HalfedgeId PlaneCut::corner_of(const Event& event, std::uint8_t direction) const {
  if (event.is_crossing) return s_.half(event.at).next;
  if (!event.first_out.is_valid()) return event.at;
  const auto turn = [&](std::uint8_t to) { return (to + 4U - event.out_class) % 4U; };
  return turn(direction) < turn(event.first_class) ? event.at : event.first_out;
}

// Inserts the chord as a pair of half-edges. This joins two cycles of the face or divides one. When
// all chords are inserted, share_cycles() assigns faces to the cycles.
void PlaneCut::insert_chord(Segment& segment) {
  Event& from = section_.events()[segment.start];
  Event& to = section_.events()[segment.end];
  const HalfedgeId hx = corner_of(from, 0), hy = corner_of(to, 2);
  const HalfedgeId c(s_.halves.size()), d(s_.halves.size() + 1);
  const CutSurface::Face& face = s_.face(segment.face);
  const HalfedgeId before_x = s_.half(hx).prev, before_y = s_.half(hy).prev;
  CutSurface::Half along{from.vertex,  hy,
                         before_x,     d,
                         segment.face, {},
                         plane_,       {},
                         {},           face.plane.orientation(),
                         face.mark,    s_.half(hx).origin_mark,
                         false};
  CutSurface::Half back{to.vertex,    hx,
                        before_y,     c,
                        segment.face, {},
                        plane_,       {},
                        {},           face.plane.orientation() * Sign::Negative,
                        face.mark,    s_.half(hy).origin_mark,
                        false};
  s_.halves.push_back(along);
  s_.halves.push_back(back);
  s_.half(before_x).next = c;
  s_.half(hy).prev = c;
  s_.half(before_y).next = d;
  s_.half(hx).prev = d;
  if (!from.first_out.is_valid()) std::tie(from.first_out, from.first_class) = std::pair(c, 0);
  if (!to.first_out.is_valid()) std::tie(to.first_out, to.first_class) = std::pair(d, 2);
  segment.low = c;
  segment.high = d;
}

/// The segments of one face are consecutive, because the faces were searched one by one.
void PlaneCut::split_faces() {
  std::vector<Segment>& segments = section_.segments();
  std::vector<HalfedgeId> chords;
  for (std::size_t i = 0; i < segments.size();) {
    const FaceId f = segments[i].face;
    if (!f.is_valid()) {
      ++i;
      continue;
    }
    chords.clear();
    for (; i < segments.size() && segments[i].face == f; ++i) {
      if (!section_.is_selected(segments[i])) continue;
      insert_chord(segments[i]);
      chords.push_back(segments[i].low);
      chords.push_back(segments[i].high);
    }
    if (!chords.empty()) share_cycles(f, chords);
  }
}

FaceId PlaneCut::new_face(const CutSurface::Face& like) {
  const FaceId f(s_.faces.size());
  s_.faces.push_back(like);
  s_.faces.back().cycle = {};
  new_faces_.push_back(f);
  return f;
}

/// Adds the cycle of `first` to those of the face.
void PlaneCut::set_cycle(FaceId f, HalfedgeId first) {
  HalfedgeId h = first;
  do {
    s_.half(h).face = f;
    h = s_.half(h).next;
  } while (h != first);
  HalfedgeId* link = &s_.face(f).cycle;
  while (link->is_valid()) link = &s_.half(*link).next_cycle;
  *link = first;
  s_.half(first).next_cycle = {};
}

/// Collects the cycles that a face has after chords were inserted, each cycle once, and gives each
/// a face of its own. A half-edge without a face counts as visited.
void PlaneCut::share_cycles(FaceId f, std::span<const HalfedgeId> chords) {
  std::vector<HalfedgeId> firsts(chords.begin(), chords.end()), cycles;
  const bool has_holes = s_.half(s_.face(f).cycle).next_cycle.is_valid();
  for (HalfedgeId c = s_.face(f).cycle; c.is_valid() && has_holes; c = s_.half(c).next_cycle) {
    firsts.push_back(c);
  }
  for (const HalfedgeId first : firsts) s_.half(first).face = f;
  for (const HalfedgeId first : firsts) {
    if (!s_.half(first).face.is_valid()) continue;
    cycles.push_back(first);
    HalfedgeId h = first;
    do {
      s_.half(h).face = {};
      h = s_.half(h).next;
    } while (h != first);
  }
  for (HalfedgeId c = s_.face(f).cycle; c.is_valid();) {
    c = std::exchange(s_.half(c).next_cycle, {});
  }
  s_.face(f).cycle = {};
  if (has_holes) return share_holes(f, cycles);
  set_cycle(f, cycles[0]);
  for (const HalfedgeId c : std::span(cycles).subspan(1)) set_cycle(new_face(s_.face(f)), c);
}

/// Assigns faces to cycles if some cycles may be holes. Each hole goes to the innermost ring around
/// it.
void PlaneCut::share_holes(FaceId f, std::span<const HalfedgeId> cycles) {
  const OrientedPlane plane = s_.face(f).plane;
  std::vector<std::vector<RingSide>> rings;
  std::vector<FaceId> face_of(cycles.size());
  std::vector<std::uint8_t> hole;
  for (const HalfedgeId first : cycles) {
    std::vector<RingSide> ring = ring_of(s_, first);
    hole.push_back(is_hole(s_, plane, ring) ? 1 : 0);
    rings.push_back(std::move(ring));
  }
  bool is_first = true;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (hole[i] != 0) continue;
    face_of[i] = std::exchange(is_first, false) ? f : new_face(s_.face(f));
    set_cycle(face_of[i], cycles[i]);
  }
  const auto is_in = [&](std::size_t inner, std::size_t outer) {
    return place_in(s_, plane.plane(), rings[outer], rings[inner]) == RingPlace::Inside;
  };
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (hole[i] == 0) continue;
    std::size_t best = cycles.size();
    for (std::size_t o = 0; o < cycles.size(); ++o) {
      if (hole[o] == 0 && is_in(i, o) && (best == cycles.size() || is_in(o, best))) best = o;
    }
    PLUMB_CHECK(best < cycles.size());
    set_cycle(face_of[best], cycles[i]);
  }
}

// ---------------------------------------------------------------- wall

/// The low wall faces the direction of the canonical normal of T, away from the part below, and
/// owns the points of T. The high wall faces the opposite direction and has mark 0.
void PlaneCut::make_walls() {
  const std::vector<Segment>& segments = section_.segments();
  wall_low_.assign(segments.size(), {});
  wall_high_.assign(segments.size(), {});
  const CutSurface::Face wall{OrientedPlane(plane_, false), {}, kWallOrigin, 1};
  const FaceId low = new_face(wall), high = new_face(wall);
  s_.face(high).plane = OrientedPlane(plane_, true);
  s_.face(high).mark = 0;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (section_.is_selected(segments[i]) && !wall_low_[i].is_valid()) add_walls(i, low, high);
  }
  join_walls();
  give_vertices();
}

/// Adds both wall half-edges for each segment of a cycle. The outer cycle need not be a face's
/// first.
void PlaneCut::add_walls(std::uint32_t first, FaceId low, FaceId high) {
  const std::vector<Segment>& segments = section_.segments();
  std::uint32_t i = first;
  do {
    wall_low_[i] = add_wall_half(segments[i], low, true);
    wall_high_[i] = add_wall_half(segments[i], high, false);
    i = segments[i].next;
  } while (i != first);
  do {
    const std::uint32_t next = segments[i].next;
    s_.half(wall_low_[i]).next = wall_low_[next];
    s_.half(wall_low_[next]).prev = wall_low_[i];
    s_.half(wall_high_[next]).next = wall_high_[i];
    s_.half(wall_high_[i]).prev = wall_high_[next];
    i = next;
  } while (i != first);
  set_cycle(low, wall_low_[first]);
  set_cycle(high, wall_high_[first]);
}

HalfedgeId PlaneCut::add_wall_half(const Segment& segment, FaceId face, bool is_low) {
  const HalfedgeId like = segment.half.is_valid() ? segment.half : segment.low;
  CutSurface::Half half;
  half.origin = is_low ? segment.from : segment.to;
  half.face = face;
  half.other = segment.place.other;
  half.along = segment.place.sign() * (is_low ? Sign::Positive : Sign::Negative);
  half.edge = s_.half(like).edge;
  half.line = s_.half(like).line;
  // If both faces rise from T, no half-edge of the surface is below T. In this case, this half-edge
  // has the mark of that ring.
  if (is_low && segment.half.is_valid()) half.origin_mark = s_.half(segment.half).origin_mark;
  s_.halves.push_back(half);
  return HalfedgeId(s_.halves.size() - 1);
}

/// Makes two half-edges twins, with the mark of the edge and whether it is reflex. By Lemma 2 a cut
/// never makes an edge reflex that was not.
void PlaneCut::join(HalfedgeId a, HalfedgeId b, Mark mark) {
  s_.half(a).twin = b;
  s_.half(b).twin = a;
  s_.half(a).mark = s_.half(b).mark = mark;
  s_.half(a).is_reflex = s_.half(b).is_reflex = s_.is_reflex_at(a);
}

/// Joins the walls to the chords immediately. Edges in T are collected first. Both of their sides
/// may be segments, and these must be joined together.
void PlaneCut::join_walls() {
  const std::vector<Segment>& segments = section_.segments();
  std::vector<std::pair<HalfedgeId, std::uint32_t>> edges;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    if (!section_.is_selected(segment)) continue;
    if (segment.half.is_valid()) {
      edges.emplace_back(std::min(segment.half, s_.half(segment.half).twin), i);
    } else {
      join(segment.low, wall_low_[i], s_.half(segment.low).mark);
      join(segment.high, wall_high_[i], 0);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const HalfedgeId h = edges[k].first;
    const Segment* left = nullptr;
    const Segment* right = nullptr;
    const auto take = [&](std::uint32_t i) {
      (segments[i].half == h ? left : right) = &segments[i];
    };
    take(edges[k].second);
    if (k + 1 < edges.size() && edges[k + 1].first == h) take(edges[++k].second);
    join_edge(h, left, right);
  }
}

/// Joins the walls at an edge in T with the section on its left, on its right, or on both sides.
/// Sheets are joined in the order in which they are met inside of the solid. A sheet with the
/// direction of h is joined to a sheet with the opposite direction.
void PlaneCut::join_edge(HalfedgeId h, const Segment* left, const Segment* right) {
  const HalfedgeId t = s_.half(h).twin;
  const Mark mark = s_.half(h).mark;
  const auto at = [this](const Segment* segment) { return segment - section_.segments().data(); };
  const auto low = [&](const Segment* segment) {
    return wall_low_[static_cast<std::size_t>(at(segment))];
  };
  const auto high = [&](const Segment* segment) {
    return wall_high_[static_cast<std::size_t>(at(segment))];
  };
  if (right == nullptr) {
    join(t, low(left), mark);
    join(h, high(left), 0);
  } else if (left == nullptr) {
    join(h, low(right), mark);
    join(t, high(right), 0);
  } else if (section_.lean(h) == Sign::Negative) {  // Both faces rise from T.
    join(low(left), low(right), mark);
    join(h, high(left), 0);
    join(t, high(right), 0);
  } else {
    join(h, low(right), mark);
    join(t, low(left), 0);
    join(high(left), high(right), 0);
  }
}

/// Decides which ring owns each vertex. If a ring was divided, one of its parts on the lower side
/// becomes the owner.
void PlaneCut::give_vertices() {
  given_.clear();
  for (const bool is_low : {true, false}) {
    for (const HalfedgeId h : is_low ? wall_low_ : wall_high_) {
      if (h.is_valid()) give_vertex(h, is_low);
    }
  }
  for (const auto* walls : {&wall_low_, &wall_high_}) {
    for (const HalfedgeId h : *walls) {
      if (h.is_valid()) set_origin_marks(h, s_.half(h).origin_mark & Mark{1});
    }
  }
}

void PlaneCut::set_origin_marks(HalfedgeId first, Mark mark) {
  HalfedgeId h = first;
  do {
    s_.half(h).origin_mark = mark;
    h = s_.half(s_.half(h).prev).twin;
  } while (h != first);
}

/// Walks around the ring that contains the wall half-edge. One of the half-edges of the ring that
/// had the vertex before carries its mark. The ring keeps the mark if the ring is on the lower
/// side, and no other ring has received the mark.
void PlaneCut::give_vertex(HalfedgeId wall_half, bool is_low) {
  constexpr Mark kSeen = 4;
  if ((s_.half(wall_half).origin_mark & kSeen) != 0) return;
  Mark mark = 0;
  HalfedgeId h = wall_half;
  do {
    mark |= s_.half(h).origin_mark;
    h = s_.half(s_.half(h).prev).twin;
  } while (h != wall_half);
  const VertexId v = s_.half(wall_half).origin;
  const bool is_given = std::find(given_.begin(), given_.end(), v) != given_.end();
  const bool is_owner = is_low && mark == 1 && !is_given;
  if (is_owner) given_.push_back(v);
  set_origin_marks(wall_half, is_owner ? kSeen | Mark{1} : kSeen);
}

// ---------------------------------------------------------------- flood

// Collects the faces of one or two pieces, those of the lower piece first. If the cut does not
// separate the piece, the first flood also reaches the other wall.
CutPieces PlaneCut::flood(std::span<const FaceId> faces) {
  face_stamp_.resize(s_.faces.size(), 0);
  ++stamp_;
  CutPieces pieces;
  std::vector<FaceId> left;
  const auto reach = [&](FaceId f) {
    if (face_stamp_[f] == stamp_) return;
    face_stamp_[f] = stamp_;
    left.push_back(f);
    pieces.back().push_back(f);
  };
  const auto gather = [&](FaceId first) {
    if (face_stamp_[first] == stamp_) return;
    pieces.emplace_back();
    reach(first);
    while (!left.empty()) {
      const FaceId f = left.back();
      left.pop_back();
      s_.for_each_half(f, [&](HalfedgeId h) { reach(s_.half(s_.half(h).twin).face); });
    }
  };
  const std::size_t walls = new_faces_.size() - 2;
  gather(new_faces_[walls]);
  gather(new_faces_[walls + 1]);
  std::size_t count = 0;
  for (const auto& piece : pieces) count += piece.size();
  PLUMB_CHECK(count == faces.size() + new_faces_.size());
  return pieces;
}

}  // namespace plumb
