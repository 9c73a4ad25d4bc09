// The overlay of two sphere maps: the entry points boolean_op() and simplify(), the special case of
// an edge through a facet, location of directions, and the kind of a map's centre.
//
// The general overlay runs in three classes: SphereContacts finds where the maps meet, SpherePieces
// cuts and links arcs, SphereLabels finds faces and the cells of the operands.
// docs/design/sphere.md proves them.
//
// SphereLunes does the most common case: the map of a point inside an edge (lunes: two opposite
// points joined by half-circles) over the map of a point inside a facet that the edge pierces (a
// loop that crosses all half-circles). Main flow of SphereLunes::build():
//  1. tests whether the maps are like this, and on which side of the loop the first point lies
//  2. cuts each half-circle where the loop crosses it, and the loop there; all links are known
//  3. makes each face, the part of a lune on one side of the loop
// Its cost is O(half-circles) and one sign.
//
// Tested by tests/sphere/sphere_overlay_test.cpp.

#include "plumb/sphere/overlay/sphere_overlay.h"

#include <array>
#include <optional>
#include <vector>

#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/sphere/arcs/sphere_arcs.h"
#include "plumb/sphere/overlay/sphere_contacts.h"
#include "plumb/sphere/overlay/sphere_labels.h"
#include "plumb/sphere/overlay/sphere_simplify.h"

namespace plumb {

/// The overlay of lunes and a loop. The object keeps its memory between calls.
class SphereLunes {
 public:
  /// Fills `out`, except its marks, and `cells`, which has the pair of old cells that contains each
  /// new cell. Returns false, and leaves both unchanged, if the maps are not lunes and a loop that
  /// crosses them.
  bool build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b, SphereMap& out,
             SphereOrigins& cells);

 private:
  using Pair = SphereOrigins::Pair;

  Pair pair(SphereCell of_lunes, SphereCell of_circle) const;
  SphereCell face_on(Sign side) const;
  Sign start_side(std::uint32_t i) const;
  void add_points();
  void add_arc(PlaneId circle, std::uint32_t from, std::uint32_t to, const Pair& cells);
  void cut_half_circles();
  void cut_circle();
  void link_crossing(std::uint32_t i, std::uint32_t leaving, std::uint32_t arriving);
  void link_ends();
  void number_faces();
  std::uint32_t face(std::uint32_t lune, Sign side);

  const SphereMap* lunes_ = nullptr;
  const SphereMap* circle_ = nullptr;
  bool has_lunes_first_ = false;  // Whether map a has the lunes.
  Sign first_side_ = Sign::Zero;  // The side of the circle on which point 0 of the lunes lies.
  SphereMap* out_ = nullptr;
  SphereOrigins* cells_ = nullptr;
  std::vector<std::uint32_t>
      lune_of_piece_;  // For each piece of the circle, the face of the lunes.
  // For each face of the lunes and each side, the new face or kNone.
  std::vector<std::uint32_t> number_;
};

namespace {

/// Whether the map is one loop.
bool is_circle(const SphereMap& map) {
  return map.point_count() == 0 && map.arc_count() == 1 && map.is_loop(0);
}

/// Whether the map consists of two opposite points that are joined by half-circles. The definitions
/// of the points must show that they are opposite. All other maps use the general overlay.
bool are_lunes(const SphereMap& map) {
  if (map.point_count() != 2 || map.arc_count() == 0) return false;
  if (map.direction[1] != map.direction[0].opposite()) return false;
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (map.is_loop(a) || map.origin[2 * a] == map.origin[2 * a + 1]) return false;
  }
  return true;
}

/// Half-circle i of the lunes becomes arcs 2i and 2i + 1, which have its direction. Returns the
/// half-arc of these arcs that leaves the same point as the given half-arc of the lunes.
std::uint32_t leaving_half(std::uint32_t half) { return 4 * (half / 2) + (half % 2 == 0 ? 0 : 3); }

}  // namespace

SphereLunes::Pair SphereLunes::pair(SphereCell of_lunes, SphereCell of_circle) const {
  return has_lunes_first_ ? Pair{of_lunes, of_circle} : Pair{of_circle, of_lunes};
}

/// Returns the face of the circle's map on a side of the circle.
SphereCell SphereLunes::face_on(Sign side) const {
  return SphereCell::face(circle_->face[side == Sign::Positive ? 0 : 1]);
}

/// Returns the side of the circle on which the point lies where half-circle i starts, if it is
/// followed counter-clockwise.
Sign SphereLunes::start_side(std::uint32_t i) const {
  return lunes_->origin[2 * i] == 0 ? first_side_ : -first_side_;
}

/// Adds the ends of the half-circles, then the crossings. A counter-clockwise walk on c that comes
/// from the positive side of q crosses q at n_c x n_q.
void SphereLunes::add_points() {
  const PlaneId q = circle_->circle[0];
  const auto count = static_cast<std::uint32_t>(lunes_->arc_count());
  out_->direction = lunes_->direction;
  cells_->point = {pair(SphereCell::point(0), face_on(first_side_)),
                   pair(SphereCell::point(1), face_on(-first_side_))};
  for (std::uint32_t i = 0; i < count; ++i) {
    const PlaneId c = lunes_->circle[i];
    const SphereDirection crossing{c, q};
    out_->direction.push_back(start_side(i) == Sign::Positive ? crossing : crossing.opposite());
    cells_->point.push_back(pair(SphereCell::arc(i), SphereCell::arc(0)));
  }
  out_->first_out.assign(2 + count, kNone);
  out_->point_face.assign(2 + count, kNone);
}

void SphereLunes::add_arc(PlaneId circle, std::uint32_t from, std::uint32_t to, const Pair& cells) {
  out_->circle.push_back(circle);
  out_->origin.push_back(from);
  out_->origin.push_back(to);
  cells_->arc.push_back(cells);
}

void SphereLunes::cut_half_circles() {
  for (std::uint32_t i = 0; i < lunes_->arc_count(); ++i) {
    const SphereCell arc = SphereCell::arc(i);
    const Sign side = start_side(i);
    const PlaneId c = lunes_->circle[i];
    add_arc(c, lunes_->origin[2 * i], 2 + i, pair(arc, face_on(side)));
    add_arc(c, 2 + i, lunes_->origin[2 * i + 1], pair(arc, face_on(-side)));
  }
}

/// Goes clockwise around the point on the circle's positive side. Seen from there, the circle is
/// counter-clockwise, so a piece leads from the half-circle after a lune to the half-circle before
/// it.
void SphereLunes::cut_circle() {
  const auto first_piece = static_cast<std::uint32_t>(out_->circle.size());
  const auto last_piece = first_piece + static_cast<std::uint32_t>(lunes_->arc_count()) - 1;
  lune_of_piece_.clear();
  out_->next.resize(2 * (std::size_t{last_piece} + 1));
  const std::uint32_t start = lunes_->first_out[first_side_ == Sign::Positive ? 0 : 1];
  std::uint32_t h = start;
  for (std::uint32_t piece = first_piece; piece <= last_piece; ++piece) {
    const std::uint32_t after = lunes_->clockwise(h);
    const std::uint32_t lune = lunes_->face[SphereMap::twin(h)];  // The face to the right of h.
    lune_of_piece_.push_back(lune);
    add_arc(circle_->circle[0], 2 + after / 2, 2 + h / 2,
            pair(SphereCell::face(lune), SphereCell::arc(0)));
    link_crossing(h / 2, piece == first_piece ? last_piece : piece - 1, piece);
    h = after;
  }
}

/// Links the four half-arcs around the crossing with half-circle i, where one piece of the circle
/// leaves and another arrives. Their clockwise order is: the leaving piece, the half-arc to the
/// negative side, the arriving piece backwards, the half-arc to the positive side.
void SphereLunes::link_crossing(std::uint32_t i, std::uint32_t leaving, std::uint32_t arriving) {
  const std::uint32_t on = 2 * (2 * i + 1), back = 2 * (2 * i) + 1;
  const bool goes_down = start_side(i) == Sign::Positive;
  const std::array<std::uint32_t, 4> clockwise{2 * leaving, goes_down ? on : back, 2 * arriving + 1,
                                               goes_down ? back : on};
  for (std::size_t k = 0; k < 4; ++k) {
    out_->next[SphereMap::twin(clockwise[k])] = clockwise[(k + 1) % 4];
  }
  out_->first_out[2 + i] = clockwise[0];
}

/// Around the ends of the half-circles, the order is the order of the lunes.
void SphereLunes::link_ends() {
  for (std::uint32_t h = 0; h < lunes_->next.size(); ++h) {
    out_->next[SphereMap::twin(leaving_half(h))] = leaving_half(lunes_->clockwise(h));
  }
  for (const std::size_t p : {0U, 1U}) out_->first_out[p] = leaving_half(lunes_->first_out[p]);
}

/// Returns the number of the part of a lune on one side of the circle, and numbers it if it is new.
std::uint32_t SphereLunes::face(std::uint32_t lune, Sign side) {
  std::uint32_t& number = number_[2 * std::size_t{lune} + (side == Sign::Positive ? 0 : 1)];
  if (number == kNone) {
    number = static_cast<std::uint32_t>(cells_->face.size());
    cells_->face.push_back(pair(SphereCell::face(lune), face_on(side)));
  }
  return number;
}

void SphereLunes::number_faces() {
  number_.assign(2 * lunes_->face_count(), kNone);
  cells_->face.clear();
  for (std::uint32_t i = 0; i < lunes_->arc_count(); ++i) {
    for (const Sign side : {start_side(i), -start_side(i)}) {
      for (const std::uint32_t half : {2 * i, 2 * i + 1}) {
        out_->face.push_back(face(lunes_->face[half], side));
      }
    }
  }
  for (const std::uint32_t lune : lune_of_piece_) {
    for (const Sign side : {Sign::Positive, Sign::Negative}) {
      out_->face.push_back(face(lune, side));
    }
  }
}

bool SphereLunes::build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
                        SphereMap& out, SphereOrigins& cells) {
  has_lunes_first_ = is_circle(b);
  lunes_ = has_lunes_first_ ? &a : &b;
  circle_ = has_lunes_first_ ? &b : &a;
  if (!is_circle(*circle_) || !are_lunes(*lunes_)) return false;
  first_side_ = side_of(planes, lunes_->direction[0], circle_->circle[0]);
  if (first_side_ == Sign::Zero) return false;
  out_ = &out;
  cells_ = &cells;
  out.clear();
  cells.arc.clear();
  add_points();
  cut_half_circles();
  cut_circle();
  link_ends();
  number_faces();
  return true;
}

namespace {

Mark mark_of(const SphereMap& map, SphereCell cell) {
  switch (cell.kind()) {
    case SphereCell::Kind::Point:
      return map.point_mark[cell.index()];
    case SphereCell::Kind::Arc:
      return map.arc_mark[cell.index()];
    case SphereCell::Kind::Face:
      break;
  }
  return map.face_mark[cell.index()];
}

/// Sets `to` to the pairs of the old cells.
void pick(const std::vector<std::uint32_t>& old, const std::vector<SphereOrigins::Pair>& from,
          std::vector<SphereOrigins::Pair>& to) {
  to.clear();
  for (const std::uint32_t i : old) to.push_back(from[i]);
}

/// Sets `to` to the old cells, each as a pair without a partner.
void name(const std::vector<std::uint32_t>& old, SphereCell::Kind kind,
          std::vector<SphereOrigins::Pair>& to) {
  to.clear();
  for (const std::uint32_t i : old) to.push_back({SphereCell(kind, i), SphereCell()});
}

void name_all(std::size_t count, SphereCell::Kind kind, std::vector<SphereOrigins::Pair>& to) {
  to.clear();
  for (std::uint32_t i = 0; i < count; ++i) to.push_back({SphereCell(kind, i), SphereCell()});
}

}  // namespace

struct SphereOverlay::Work {
  explicit Work(const PlaneTable& p) : planes(p) {}

  void overlay(const SphereMap& a, const SphereMap& b, SphereLimits* limits);
  void select(const SphereMap& a, const SphereMap& b, const MarkTable& table);
  void simplify(SphereMap& out, SphereOrigins& origins);

  const PlaneTable& planes;
  SphereLunes lunes;
  SphereContacts contacts;
  SpherePieces pieces;
  SphereLabels labels;
  SphereOrigins cells;
  SphereSimplifier simplifier;
  SphereMap spare;
};

/// Computes the overlay of the maps. The result, without marks, is in pieces.map and cells.
void SphereOverlay::Work::overlay(const SphereMap& a, const SphereMap& b, SphereLimits* limits) {
  if (lunes.build(planes, a, b, pieces.map, cells)) return;
  contacts.find(planes, a, b, SphereContacts::kMostTabled, limits);
  pieces.build(planes, a, b, contacts, limits);
  labels.build(planes, a, b, contacts, pieces, cells, limits);
}

void SphereOverlay::Work::select(const SphereMap& a, const SphereMap& b, const MarkTable& table) {
  const auto add = [&](const std::vector<SphereOrigins::Pair>& pairs, std::vector<Mark>& marks) {
    for (const auto& [in_a, in_b] : pairs)
      marks.push_back(table(mark_of(a, in_a), mark_of(b, in_b)));
  };
  add(cells.point, pieces.map.point_mark);
  add(cells.arc, pieces.map.arc_mark);
  add(cells.face, pieces.map.face_mark);
  pieces.map.centre_mark = table(a.centre_mark, b.centre_mark);
}

void SphereOverlay::Work::simplify(SphereMap& out, SphereOrigins& origins) {
  if (simplifier.run(pieces.map, out)) {
    pick(simplifier.old_point(), cells.point, origins.point);
    pick(simplifier.old_arc(), cells.arc, origins.arc);
    pick(simplifier.old_face(), cells.face, origins.face);
  } else {
    std::swap(out, pieces.map);
    std::swap(origins, cells);
  }
}

SphereOverlay::SphereOverlay(const PlaneTable& planes) : work_(std::make_unique<Work>(planes)) {}
SphereOverlay::~SphereOverlay() = default;

void SphereOverlay::boolean_op(const SphereMap& a, const SphereMap& b, const MarkTable& table,
                               SphereMap& out, SphereOrigins& origins, Context* context) {
  Work& w = *work_;
  std::optional<SphereLimits> limits;
  if (context != nullptr && !SphereContacts::are_small(a, b)) limits.emplace(*context);
  w.overlay(a, b, limits ? &*limits : nullptr);
  w.select(a, b, table);
  w.simplify(out, origins);
}

bool SphereOverlay::simplify(SphereMap& map, SphereOrigins* kept) {
  const SphereSimplifier& s = work_->simplifier;
  const bool changed = work_->simplifier.run(map, work_->spare);
  if (changed) std::swap(map, work_->spare);
  if (kept == nullptr) return changed;
  using Kind = SphereCell::Kind;
  if (changed) {
    name(s.old_point(), Kind::Point, kept->point);
    name(s.old_arc(), Kind::Arc, kept->arc);
    name(s.old_face(), Kind::Face, kept->face);
  } else {
    name_all(map.point_count(), Kind::Point, kept->point);
    name_all(map.arc_count(), Kind::Arc, kept->arc);
    name_all(map.face_count(), Kind::Face, kept->face);
  }
  return changed;
}

// The cell of a map in which a direction lies, and the kind of a map's centre.

namespace {

bool is_parallel(const PlaneTable& planes, PlaneId p, PlaneId q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (minor_sign(planes, p, q, axis) != Sign::Zero) return false;
  }
  return true;
}

/// Returns the plane of the map that is parallel to `plane`, which need not contain the centre, or
/// `plane` itself if there is none. Canonical planes that are parallel have normals of the same
/// direction, so both define the same directions.
PlaneId plane_like(const PlaneTable& planes, const SphereMap& map, PlaneId plane) {
  PlaneId like = plane;
  const auto look_at = [&](PlaneId p) {
    if (like == plane && p != plane && is_parallel(planes, p, plane)) like = p;
    return p == plane;
  };
  for (const PlaneId c : map.circle) {
    if (look_at(c)) return plane;
  }
  for (const SphereDirection& d : map.direction) {
    if (look_at(d.p) || look_at(d.q)) return plane;
  }
  return like;
}

bool all_are(const std::vector<Mark>& marks, Mark mark) {
  for (const Mark m : marks) {
    if (m != mark) return false;
  }
  return true;
}

/// Whether the map consists of two opposite points with the mark of the centre, joined by arcs.
bool is_edge(const PlaneTable& planes, const SphereMap& map) {
  if (map.point_count() != 2 || !all_are(map.point_mark, map.centre_mark)) return false;
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (map.is_loop(a) || map.origin[2 * a] == map.origin[2 * a + 1]) return false;
  }
  return is_opposite(planes, map.direction[0], map.direction[1]);
}

}  // namespace

// Planes through the centre are distinguished by their ids, so the planes of the direction are
// first replaced by parallel ones of the map. If the direction is on no point or arc, the first
// cell that is met on the way to an arc bounds its face.
SphereCell locate(const PlaneTable& planes, const SphereMap& map, SphereDirection direction) {
  direction = {plane_like(planes, map, direction.p), plane_like(planes, map, direction.q)};
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (is_same(planes, map.direction[v], direction)) return SphereCell::point(v);
  }
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (is_on_arc(planes, map, a, direction)) return SphereCell::arc(a);
  }
  if (map.arc_count() == 0) return SphereCell::face(0);
  std::vector<PathHit> hits;
  walk_to_arc(planes, map, direction, 0, hits);
  PLUMB_CHECK(!hits.empty() && hits.front().entry.is_valid());
  return SphereCell::face(face_of(map, hits.front().entry));
}

PyramidKind classify(const PlaneTable& planes, const SphereMap& map) {
  if (map.point_count() == 0 && map.arc_count() == 0) {
    return map.face_mark[0] == map.centre_mark ? PyramidKind::Volume : PyramidKind::Vertex;
  }
  if (map.point_count() == 0 && map.arc_count() == 1) {
    return map.arc_mark[0] == map.centre_mark ? PyramidKind::Facet : PyramidKind::Vertex;
  }
  return is_edge(planes, map) ? PyramidKind::Edge : PyramidKind::Vertex;
}

}  // namespace plumb
