#include "plumb/sphere/sphere_pieces.h"

#include <algorithm>

namespace plumb {

namespace {
constexpr std::uint32_t kNone = SphereMap::kNone;
}  // namespace

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

/// A half-arc of a piece of map k's arc, at its origin: an end of the arc, or a stop inside it.
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

void SpherePieces::sort_ring(std::uint32_t point) {
  const SphereDirection u = map.direction[point];
  const OrientedPlane from = heading_of(map, ring_[0]);
  std::sort(ring_.begin(), ring_.end(), [&](std::uint32_t g, std::uint32_t h) {
    return is_before_at(*planes_, u, from, heading_of(map, h), heading_of(map, g));
  });
  ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
}

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

}  // namespace plumb
