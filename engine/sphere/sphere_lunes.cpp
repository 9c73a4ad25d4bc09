#include "plumb/sphere/sphere_lunes.h"

#include <array>

#include "plumb/sphere/sphere_directions.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = SphereMap::kNone;

bool is_circle(const SphereMap& map) {
  return map.point_count() == 0 && map.arc_count() == 1 && map.is_loop(0);
}

bool are_lunes(const SphereMap& map) {
  if (map.point_count() != 2 || map.arc_count() == 0) return false;
  if (map.direction[1] != map.direction[0].opposite()) return false;
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (map.is_loop(a) || map.origin[2 * a] == map.origin[2 * a + 1]) return false;
  }
  return true;
}

/// Half-circle i of the lunes becomes arcs 2i and 2i + 1, which run as it does: of a half of it, the one that leaves the
/// same point.
std::uint32_t leaving_half(std::uint32_t half) { return 4 * (half / 2) + (half % 2 == 0 ? 0 : 3); }

}  // namespace

SphereLunes::Pair SphereLunes::pair(SphereCell of_lunes, SphereCell of_circle) const {
  return has_lunes_first_ ? Pair{of_lunes, of_circle} : Pair{of_circle, of_lunes};
}

/// What lies on a side of the circle in its own map.
SphereCell SphereLunes::face_on(Sign side) const {
  return SphereCell::face(circle_->face[side == Sign::Positive ? 0 : 1]);
}

/// Of the point that half-circle i starts at, going counter-clockwise.
Sign SphereLunes::start_side(std::uint32_t i) const {
  return lunes_->origin[2 * i] == 0 ? first_side_ : -first_side_;
}

/// The ends of the half-circles, then crossings. About c, what comes from the positive side of q crosses it at c x q.
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

/// Clockwise around the point on its positive side; pieces run the other way, from the half-circle that comes after a lune.
void SphereLunes::cut_circle() {
  const auto first_piece = static_cast<std::uint32_t>(out_->circle.size());
  const auto last_piece = first_piece + static_cast<std::uint32_t>(lunes_->arc_count()) - 1;
  lune_of_piece_.clear();
  out_->next.resize(2 * (std::size_t{last_piece} + 1));
  const std::uint32_t start = lunes_->first_out[first_side_ == Sign::Positive ? 0 : 1];
  std::uint32_t h = start;
  for (std::uint32_t piece = first_piece; piece <= last_piece; ++piece) {
    const std::uint32_t after = lunes_->clockwise(h);
    const std::uint32_t lune = lunes_->face[SphereMap::twin(h)];  // to the right of h
    lune_of_piece_.push_back(lune);
    add_arc(circle_->circle[0], 2 + after / 2, 2 + h / 2,
            pair(SphereCell::face(lune), SphereCell::arc(0)));
    link_crossing(h / 2, piece == first_piece ? last_piece : piece - 1, piece);
    h = after;
  }
}

/// Around the crossing with half-circle i, where one piece of the circle leaves and another arrives.
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

void SphereLunes::link_ends() {
  for (std::uint32_t h = 0; h < lunes_->next.size(); ++h) {
    out_->next[SphereMap::twin(leaving_half(h))] = leaving_half(lunes_->clockwise(h));
  }
  for (const std::size_t p : {0U, 1U}) out_->first_out[p] = leaving_half(lunes_->first_out[p]);
}

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

}  // namespace plumb
