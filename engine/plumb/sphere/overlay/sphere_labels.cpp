// The phases "link" and "label" of an overlay of sphere maps.
//
// Linking: between two neighbouring stops of an arc, there are no other cells of either map.
// Therefore pieces of one circle that leave the same point in the same direction are equal. Around
// a point where both maps are present, half-arcs are sorted by heading.
//
// Labelling: going clockwise around a point that lies on map k, the face to the right of a half-arc
// of k contains what follows up to the next such half-arc. This face continues along pieces and
// over points that touch nothing of map k. So a flood labels every part that touches map k. The
// other parts get their face, and cycles are joined to faces, by the links of walks between parts
// (docs/design/sphere.md, Pieces and rings, Labels, Lemmas 2 and 3).
//
// Tested by tests/sphere/sphere_overlay_test.cpp.

#include "plumb/sphere/overlay/sphere_labels.h"

#include <algorithm>

namespace plumb {

/// Sorts stops by arc. The stops of one arc are sorted by their places from its origin; for a loop,
/// from any stop.
void SpherePieces::sort_stops(std::size_t k, SphereContacts& contacts) {
  using Stop = SphereContacts::Stop;
  std::vector<Stop>& stops = contacts.stops[k];
  std::sort(stops.begin(), stops.end(), [](const Stop& s, const Stop& t) {
    return s.arc != t.arc ? s.arc < t.arc : s.point < t.point;
  });
  for (auto first = stops.begin(); first != stops.end();) {
    const std::uint32_t a = first->arc;
    const auto last =
        std::find_if(first, stops.end(), [&](const Stop& stop) { return stop.arc != a; });
    if (last - first > 1) {
      const CirclePlace from =
          map_[k]->is_loop(a) ? first->place : origin_place(*planes_, *map_[k], 2 * a);
      std::sort(first, last, [&](const Stop& s, const Stop& t) {
        return is_before_on(*planes_, map_[k]->circle[a], from, s.place, t.place);
      });
    }
    first = last;
  }
}

/// Appends the pieces of arc a of map k. The first piece of a loop with stops starts at its last
/// stop. A loop without stops remains one piece.
void SpherePieces::cut_arc(std::size_t k, std::uint32_t a, const SphereContacts::Stop* first,
                           const SphereContacts::Stop* last, const SphereContacts& contacts) {
  const bool is_loop = map_[k]->is_loop(a);
  Piece piece{map_[k]->circle[a], kNone, kNone, {kNone, kNone}};
  piece.arc[k] = a;
  if (is_loop && first != last) piece.from = (last - 1)->point;
  if (!is_loop) piece.from = contacts.point_of[k][map_[k]->origin[2 * a]];
  for (; first != last; ++first) {
    piece.to = first->point;
    pieces_.push_back(piece);
    piece.from = piece.to;
  }
  if (!is_loop) piece.to = contacts.point_of[k][map_[k]->origin[2 * a + 1]];
  if (!is_loop || piece.from == kNone) pieces_.push_back(piece);
}

void SpherePieces::cut_arcs(std::size_t k, const SphereContacts& contacts) {
  const SphereContacts::Stop* stop = contacts.stops[k].data();
  const SphereContacts::Stop* end = stop + contacts.stops[k].size();
  for (std::uint32_t a = 0; a < map_[k]->arc_count(); ++a) {
    const SphereContacts::Stop* first = stop;
    while (stop != end && stop->arc == a) ++stop;
    cut_arc(k, a, first, stop, contacts);
  }
}

/// Sorts the pieces such that equal pieces are consecutive, and replaces equal pieces by one.
void SpherePieces::merge() {
  std::sort(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) {
    if (p.circle != q.circle) return p.circle < q.circle;
    return p.from != q.from ? p.from < q.from : p.arc < q.arc;
  });
  std::size_t count = 0;
  for (const Piece& piece : pieces_) {
    const bool is_same = count > 0 && pieces_[count - 1].circle == piece.circle &&
                         pieces_[count - 1].from == piece.from;
    if (!is_same) {
      pieces_[count++] = piece;
      continue;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      if (piece.arc[k] != kNone) pieces_[count - 1].arc[k] = piece.arc[k];
    }
  }
  pieces_.resize(count);
}

/// If a piece is part of an arc of map k, notes its half-arc at its origin. The origin is an end of
/// that arc, or a stop inside of it.
void SpherePieces::note_leaving(std::uint32_t half, std::size_t k, const SphereContacts& contacts) {
  const std::uint32_t a = arc[half / 2][k];
  const std::uint32_t point = map.origin[half];
  if (a == kNone || point == kNone) return;
  if (contacts.cell[point][k].kind() == SphereCell::Kind::Point) {
    leaving_[k][2 * a + (half & 1U)] = half;
  } else {
    through_[k][point][half & 1U] = half;
  }
}

void SpherePieces::place_pieces(const SphereContacts& contacts) {
  map.clear();
  arc.clear();
  map.direction = contacts.direction;
  map.first_out.assign(map.direction.size(), kNone);
  map.point_face.assign(map.direction.size(), kNone);
  for (const Piece& piece : pieces_) {
    map.circle.push_back(piece.circle);
    map.origin.push_back(piece.from);
    map.origin.push_back(piece.to);
    arc.push_back(piece.arc);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    leaving_[k].assign(2 * map_[k]->arc_count(), kNone);
    through_[k].assign(map.direction.size(), {kNone, kNone});
    for (std::uint32_t h = 0; h < map.origin.size(); ++h) note_leaving(h, k, contacts);
  }
}

/// Appends the half-arcs of map k that leave a point, clockwise.
void SpherePieces::add_ring(std::size_t k, std::uint32_t point, const SphereContacts& contacts) {
  const SphereCell cell = contacts.cell[point][k];
  if (!cell.is_valid()) return;
  if (cell.kind() == SphereCell::Kind::Arc) {
    for (const std::uint32_t h : through_[k][point]) ring_.push_back(h);
    return;
  }
  const std::uint32_t first = map_[k]->first_out[cell.index()];
  if (first == kNone) return;
  std::uint32_t h = first;
  do {
    ring_.push_back(leaving_[k][h]);
    h = map_[k]->clockwise(h);
  } while (h != first);
}

/// Sorts the half-arcs of both maps clockwise. Where arcs overlap, one half-arc occurs twice.
void SpherePieces::sort_ring(std::uint32_t point) {
  const SphereDirection u = map.direction[point];
  const OrientedPlane from = heading_of(map, ring_[0]);
  std::sort(ring_.begin(), ring_.end(), [&](std::uint32_t g, std::uint32_t h) {
    return is_before_at(*planes_, u, from, heading_of(map, h), heading_of(map, g));
  });
  ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
}

/// The half-arc that arrives at the place where g leaves is followed by the next half-arc clockwise
/// that leaves.
void SpherePieces::link_rings(const SphereContacts& contacts) {
  map.next.resize(map.origin.size());
  for (std::uint32_t h = 0; h < map.origin.size(); ++h) {
    if (map.origin[h] == kNone) map.next[h] = h;
  }
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    ring_.clear();
    add_ring(0, v, contacts);
    const std::size_t of_a = ring_.size();
    add_ring(1, v, contacts);
    if (of_a > 0 && ring_.size() > of_a) sort_ring(v);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const std::size_t j = i + 1 < ring_.size() ? i + 1 : 0;
      map.next[SphereMap::twin(ring_[i])] = ring_[j];
    }
    if (!ring_.empty()) map.first_out[v] = ring_[0];
  }
}

void SpherePieces::trace() {
  cycle_count = 0;
  map.face.assign(map.origin.size(), kNone);
  for (std::uint32_t first = 0; first < map.origin.size(); ++first) {
    if (map.face[first] != kNone) continue;
    for (std::uint32_t h = first; map.face[h] == kNone; h = map.next[h]) map.face[h] = cycle_count;
    ++cycle_count;
  }
  std::uint32_t number = cycle_count;
  for (std::size_t v = 0; v < map.point_count(); ++v) {
    if (map.first_out[v] == kNone) map.point_face[v] = number++;
  }
}

void SpherePieces::build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
                         SphereContacts& contacts, SphereLimits* limits) {
  planes_ = &planes;
  map_ = {&a, &b};
  pieces_.clear();
  for (std::size_t k = 0; k < 2; ++k) {
    sort_stops(k, contacts);
    look(limits);
    cut_arcs(k, contacts);
    look(limits);
  }
  if (contacts.shares_circles) merge();
  place_pieces(contacts);
  look(limits);
  link_rings(contacts);
  look(limits);
  trace();
  look(limits);
}

namespace {

SphereCell face_cell(std::uint32_t face) {
  return face == kNone ? SphereCell() : SphereCell::face(face);
}

}  // namespace

// ---------------------------------------------------------------- labels from the contacts

void SphereLabels::take_known(const SphereContacts& contacts) {
  point_cell_ = contacts.cell;
  const SphereMap& map = pieces_->map;
  for (std::size_t k = 0; k < 2; ++k) {
    label_[k].assign(map.arc_count(), kNone);
    stack_.clear();
    for (std::uint32_t v = 0; v < map.point_count(); ++v) {
      if (point_cell_[v][k].is_valid() && map.first_out[v] != kNone) label_around(k, v);
    }
    flood(k);
  }
}

/// Assigns a face of map k to the piece of a half-arc, unless the piece is part of an arc of k or
/// already has a face.
void SphereLabels::set_label(std::size_t k, std::uint32_t half, std::uint32_t face) {
  const std::uint32_t piece = half / 2;
  if (face == kNone || pieces_->arc[piece][k] != kNone || label_[k][piece] != kNone) return;
  label_[k][piece] = face;
  stack_.push_back(piece);
}

/// Labels the pieces around a point that lies on map k. Going clockwise, the face to the right of a
/// half-arc of k contains what follows. If the point is isolated in k, its face contains all
/// pieces. Otherwise, a second round is needed for the pieces before the first half-arc of k.
void SphereLabels::label_around(std::size_t k, std::uint32_t point) {
  const SphereMap& map = pieces_->map;
  const SphereCell cell = point_cell_[point][k];
  std::uint32_t face = kNone;
  if (cell.kind() == SphereCell::Kind::Point) face = map_[k]->point_face[cell.index()];
  const std::uint32_t first = map.first_out[point];
  const int rounds = face == kNone ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    std::uint32_t h = first;
    do {
      const std::uint32_t a = pieces_->arc[h / 2][k];
      if (a != kNone) {
        face = map_[k]->face[2 * a + ((h & 1U) ^ 1U)];
      } else {
        set_label(k, h, face);
      }
      h = map.clockwise(h);
    } while (h != first);
  }
}

/// A point that is not on map k lies in the face of any piece that ends there, and so do all other
/// pieces around it.
void SphereLabels::flood(std::size_t k) {
  const SphereMap& map = pieces_->map;
  while (!stack_.empty()) {
    const std::uint32_t piece = stack_.back();
    stack_.pop_back();
    for (const std::uint32_t start : {2 * piece, 2 * piece + 1}) {
      const std::uint32_t v = map.origin[start];
      if (point_cell_[v][k].is_valid()) continue;
      point_cell_[v][k] = SphereCell::face(label_[k][piece]);
      std::uint32_t h = start;
      do {
        set_label(k, h, label_[k][piece]);
        h = map.clockwise(h);
      } while (h != start);
    }
  }
}

// ---------------------------------------------------------------- connected parts

std::uint32_t SphereLabels::cycle_of(SphereSlot slot) const {
  return slot.half_arc != kNone ? pieces_->map.face[slot.half_arc]
                                : pieces_->map.point_face[slot.point];
}

void SphereLabels::join_cycles() {
  make_singles(class_, pieces_->cycle_count + pieces_->map.point_count());
  for (const SphereParts::Link& l : parts_.links()) {
    unite(class_, cycle_of(l.first), cycle_of(l.second));
  }
  if (pieces_->map.arc_count() == 0) std::fill(class_.begin(), class_.end(), 0U);
}

SphereCell SphereLabels::half_cell(std::size_t k, std::uint32_t half) const {
  const std::uint32_t a = pieces_->arc[half / 2][k];
  return face_cell(a != kNone ? map_[k]->face[2 * a + (half & 1U)] : label_[k][half / 2]);
}

/// Returns the face of map k at a slot; kNone if its part touches nothing of map k.
std::uint32_t SphereLabels::face_at(std::size_t k, SphereSlot slot) const {
  if (slot.half_arc != kNone) {
    const SphereCell cell = half_cell(k, slot.half_arc);
    return cell.is_valid() ? cell.index() : kNone;
  }
  const SphereCell cell = point_cell_[slot.point][k];
  if (!cell.is_valid()) return kNone;
  return cell.kind() == SphereCell::Kind::Point ? map_[k]->point_face[cell.index()] : cell.index();
}

/// If the part at `to` needs a label, assigns the label of the part at `from` to it. Returns
/// whether a label was assigned.
bool SphereLabels::pass_label(std::size_t k, SphereSlot from, SphereSlot to) {
  std::uint32_t& label = part_label_[k][parts_.of(to)];
  if (label != kNone || face_at(k, to) != kNone) return false;
  label = face_at(k, from);
  if (label == kNone) label = part_label_[k][parts_.of(from)];
  return label != kNone;
}

/// Gives parts that touch nothing of map k the face of the parts with which they are linked:
/// between the two, nothing of map k was met. Repeats until nothing changes.
void SphereLabels::label_parts(std::size_t k, SphereLimits* limits) {
  part_label_[k].assign(parts_.bound(), kNone);
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    look(limits);
    for (const SphereParts::Link& l : parts_.links()) {
      if (pass_label(k, l.first, l.second)) goes_on = true;
      if (pass_label(k, l.second, l.first)) goes_on = true;
    }
  }
  // The remaining parts lie in face 0, because map k has no points and arcs, or there are only
  // isolated points.
  for (std::uint32_t& label : part_label_[k]) {
    if (label == kNone) label = 0;
  }
}

// ---------------------------------------------------------------- faces and cells

/// Numbers each class of joined cycles when it is first met, and sets the faces of half-arcs and
/// isolated points.
void SphereLabels::number_faces(SphereOrigins& cells) {
  SphereMap& map = pieces_->map;
  face_number_.assign(class_.size() + 1, kNone);
  const auto number = [&](SphereSlot slot) {
    std::uint32_t& face = face_number_[find_root(class_, cycle_of(slot))];
    if (face == kNone) {
      face = static_cast<std::uint32_t>(cells.face.size());
      SphereOrigins::Pair pair;
      for (std::size_t k = 0; k < 2; ++k) {
        const std::uint32_t f = face_at(k, slot);
        pair[k] = SphereCell::face(f != kNone ? f : part_label_[k][parts_.of(slot)]);
      }
      cells.face.push_back(pair);
    }
    return face;
  };
  for (std::uint32_t h = 0; h < map.face.size(); ++h) map.face[h] = number({h, kNone});
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (map.first_out[v] == kNone) map.point_face[v] = number({kNone, v});
  }
  if (cells.face.empty()) cells.face.push_back({SphereCell::face(0), SphereCell::face(0)});
}

void SphereLabels::fill_cells(SphereOrigins& cells) {
  const SphereMap& map = pieces_->map;
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    SphereOrigins::Pair pair = point_cell_[v];
    for (std::size_t k = 0; k < 2; ++k) {
      if (!pair[k].is_valid()) pair[k] = SphereCell::face(part_label_[k][parts_.of_point(v)]);
    }
    cells.point.push_back(pair);
  }
  for (std::uint32_t i = 0; i < map.arc_count(); ++i) {
    SphereOrigins::Pair pair;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t a = pieces_->arc[i][k];
      const std::uint32_t face = label_[k][i];
      pair[k] = a != kNone
                    ? SphereCell::arc(a)
                    : SphereCell::face(face != kNone ? face : part_label_[k][parts_.of_arc(i)]);
    }
    cells.arc.push_back(pair);
  }
}

void SphereLabels::build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
                         const SphereContacts& contacts, SpherePieces& pieces, SphereOrigins& cells,
                         SphereLimits* limits) {
  planes_ = &planes;
  map_ = {&a, &b};
  pieces_ = &pieces;
  for (auto* pairs : {&cells.point, &cells.arc, &cells.face}) pairs->clear();
  take_known(contacts);
  parts_.find(planes, pieces.map, [&] { look(limits); });
  look(limits);
  join_cycles();
  look(limits);
  for (std::size_t k = 0; k < 2; ++k) {
    label_parts(k, limits);
    look(limits);
  }
  number_faces(cells);
  fill_cells(cells);
  look(limits);
}

}  // namespace plumb
