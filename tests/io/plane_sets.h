// Random sets of the plane, as files may hold them: shapes on a small grid, where degeneracy is the
// rule, and what the operations make of them.
#pragma once

#include <cstdint>
#include <string>

#include "plumb/plane/nef2.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

inline std::string any_position(Dice& dice) {
  const std::string x = std::to_string(dice.between(0, 6));
  return x + ' ' + std::to_string(dice.between(0, 6));
}

/// A closed ring of 3 to 6 corners anywhere: it crosses itself more often than not.
inline std::string any_ring(Dice& dice) {
  const std::string first = any_position(dice);
  std::string ring = '(' + first;
  for (std::int64_t i = dice.between(2, 5); i > 0; --i) ring += ", " + any_position(dice);
  return ring + ", " + first + ')';
}

inline std::string any_polygon(Dice& dice) {
  std::string polygon = "POLYGON (" + any_ring(dice);
  for (std::int64_t i = dice.between(0, 2); i > 1; --i) polygon += ", " + any_ring(dice);
  return polygon + ")\n";
}

inline std::string any_line(Dice& dice) {
  std::string line = "LINESTRING (" + any_position(dice);
  for (std::int64_t i = dice.between(1, 3); i > 0; --i) line += ", " + any_position(dice);
  return line + ")\n";
}

/// One to four geometries, one a line.
inline std::string any_wkt(Dice& dice) {
  std::string text;
  for (std::int64_t i = dice.between(1, 4); i > 0; --i) {
    const std::uint32_t kind = dice.below(6);
    text += kind < 4    ? any_polygon(dice)
            : kind == 4 ? any_line(dice)
                        : "POINT (" + any_position(dice) + ")\n";
  }
  return text;
}

inline Line2 any_directed_line(Dice& dice) {
  for (;;) {
    const RationalPoint2 a{dice.between(0, 6), dice.between(0, 6)};
    const RationalPoint2 b{dice.between(0, 6), dice.between(0, 6)};
    if (!(a == b)) return {a, b};
  }
}

/// Open or closed, a half-plane, a ray or a line.
inline Nef2 any_unbounded(Dice& dice) {
  const Boundary boundary = dice.below(2) == 0 ? Boundary::Open : Boundary::Closed;
  const Line2 line = any_directed_line(dice);
  const std::uint32_t kind = dice.below(4);
  if (kind == 0) return Nef2::line(line);
  return kind == 1 ? Nef2::ray(line, boundary) : Nef2::half_plane(line, boundary);
}

/// `set`, changed by one of the operations.
inline Nef2 changed(const Nef2& set, const Nef2& other, Dice& dice) {
  switch (dice.below(7)) {
    case 0:
      return set.complement();
    case 1:
      return set.interior();
    case 2:
      return set.boundary();
    case 3:
      return set + other;
    case 4:
      return set * other;
    case 5:
      return set - other;
    default:
      return set ^ other;
  }
}

}  // namespace plumb::testing
