// Adversarial families of twelve points: the corners of four planes. Fixed seeds; every coordinate
// is finite.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "plumb/predicates/point.h"

namespace plumb::cases {

using Corners = std::array<Point3, 12>;  // of plane i: 3i, 3i + 1, 3i + 2
using Random = std::mt19937_64;

inline double uniform(Random& r, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(r);
}
inline int integer(Random& r, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(r);
}

inline Point3 uniform_point(Random& r, double size) {
  return {uniform(r, -size, size), uniform(r, -size, size), uniform(r, -size, size)};
}
/// On the grid of unit 2^-bits, |coordinate| <= size: sums of such points are exact.
inline Point3 grid_point(Random& r, int bits, int size) {
  const auto one = [&] { return std::ldexp(integer(r, -(size << bits), size << bits), -bits); };
  return {one(), one(), one()};
}
inline Point3 operator+(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point3 scaled(const Point3& p, double s) { return {p.x * s, p.y * s, p.z * s}; }

inline Corners map_all(Corners c, auto f) {
  for (Point3& p : c) p = f(p);
  return c;
}

inline Corners random_points(Random& r) {
  return map_all({}, [&](const Point3&) { return uniform_point(r, 1); });
}
inline Corners small_integers(Random& r) {
  const int size = integer(r, 1, 6);
  return map_all({}, [&](const Point3&) {
    return Point3{double(integer(r, -size, size)), double(integer(r, -size, size)),
                  double(integer(r, -size, size))};
  });
}
inline Corners full_mantissas(Random& r) {
  return map_all({}, [&](const Point3&) {
    return Point3{uniform(r, 1, 2), uniform(r, 1, 2), uniform(r, 1, 2)};
  });
}
/// All planes hold one point exactly.
inline Corners one_point(Random& r) {
  const int bits = integer(r, 0, 24);
  const Point3 c = grid_point(r, bits, 2);
  Corners result = map_all({}, [&](const Point3&) { return c + grid_point(r, bits, 3); });
  for (std::size_t i = 0; i < 12; i += 3)
    result[i + static_cast<std::size_t>(integer(r, 0, 2))] = c;
  return result;
}
/// Three planes hold one line exactly.
inline Corners one_line(Random& r) {
  const int bits = integer(r, 0, 24);
  const Point3 a = grid_point(r, bits, 2), step = grid_point(r, bits, 2);
  Corners result = map_all({}, [&](const Point3&) { return a + grid_point(r, bits, 3); });
  for (std::size_t i = 0; i < 9; i += 3) {
    result[i] = a + scaled(step, integer(r, -2, 2));
    result[i + 1] = a + scaled(step, integer(r, 3, 5));
  }
  return result;
}
/// Nearly horizontal planes.
inline Corners near_parallel(Random& r) {
  const double flat = std::ldexp(1.0, -integer(r, 20, 60));
  return map_all({}, [&](const Point3&) {
    const Point3 p = uniform_point(r, 1);
    return Point3{p.x, p.y, 0.25 + p.z * flat};
  });
}
/// Corners of a common tetrahedron-like figure, off by a few units in the last place.
inline Corners kettner_grid(Random& r) {
  constexpr std::array<Point3, 3> kBase = {{{0.5, 0.5, 0.5}, {12, 12, 12}, {24, 24, 24}}};
  const double ulp = 0x1p-53;
  Corners result;
  for (std::size_t i = 0; i < 12; ++i) {
    const Point3& b = kBase[i % 3];
    result[i] = {b.x + integer(r, 0, 255) * ulp * (i % 3 == 0 ? 1 : 16),
                 b.y + integer(r, 0, 255) * ulp * (i % 3 == 0 ? 1 : 16),
                 i % 3 == 2 ? uniform(r, 20, 28) : b.z + integer(r, 0, 255) * ulp * 16};
  }
  return result;
}
/// The same two or three planes again and again, through other corners.
inline Corners coplanar(Random& r) {
  const Point3 a = grid_point(r, 4, 2), u = grid_point(r, 4, 2), v = grid_point(r, 4, 2);
  Corners result = one_point(r);
  const auto planes = static_cast<std::size_t>(integer(r, 2, 4));
  for (std::size_t i = 0; i < 3 * planes; ++i) {
    result[i] = a + scaled(u, integer(r, -4, 4)) + scaled(v, integer(r, -4, 4));
  }
  return result;
}
inline Corners bit_patterns(Random& r) {
  const auto one = [&] {
    double d = 0;
    do {
      d = std::bit_cast<double>(r());
    } while (!std::isfinite(d));
    return d;
  };
  return map_all({}, [&](const Point3&) { return Point3{one(), one(), one()}; });
}
inline Corners subnormals(Random& r) {
  const int size = 1 << integer(r, 1, 30);
  const auto one = [&] { return integer(r, -size, size) * 0x1p-1074; };
  return map_all({}, [&](const Point3&) { return Point3{one(), one(), one()}; });
}
/// Coordinates of different magnitudes: the widths beyond the first.
inline Corners spread(Random& r) {
  const int width = integer(r, 4, 80);
  const auto one = [&] { return std::ldexp(uniform(r, -1, 1), integer(r, -width, 0)); };
  return map_all({}, [&](const Point3&) { return Point3{one(), one(), one()}; });
}
inline Corners huge(Random& r) {
  const auto one = [&] {
    return integer(r, 0, 3) == 0 ? std::numeric_limits<double>::max() * (integer(r, 0, 1) * 2 - 1)
                                 : std::ldexp(uniform(r, -1, 1), integer(r, 1000, 1024));
  };
  return map_all({}, [&](const Point3&) { return Point3{one(), one(), one()}; });
}

struct Family {
  const char* name;
  Corners (*make)(Random&);
  unsigned weight;  ///< wide numbers are slow to judge, so rarer
};
inline constexpr std::array<Family, 12> kFamilies = {{{"random", random_points, 30},
                                                      {"small integers", small_integers, 30},
                                                      {"full mantissas", full_mantissas, 20},
                                                      {"one point", one_point, 30},
                                                      {"one line", one_line, 20},
                                                      {"near parallel", near_parallel, 20},
                                                      {"Kettner grid", kettner_grid, 20},
                                                      {"coplanar", coplanar, 20},
                                                      {"spread", spread, 10},
                                                      {"subnormals", subnormals, 10},
                                                      {"bit patterns", bit_patterns, 1},
                                                      {"huge", huge, 2}}};

/// One coordinate moved to the next double.
inline void move_by_an_ulp(Random& r, Corners& c) {
  Point3& p = c[static_cast<std::size_t>(integer(r, 0, 11))];
  double& x = integer(r, 0, 2) == 0 ? p.x : (integer(r, 0, 1) == 0 ? p.y : p.z);
  const double to = integer(r, 0, 1) == 0 ? -std::numeric_limits<double>::max()
                                          : std::numeric_limits<double>::max();
  x = std::nextafter(x, to);
}

struct Case {
  std::string family;
  Corners corners;
};

inline const Family& pick_family(Random& r) {
  unsigned total = 0;
  for (const Family& f : kFamilies) total += f.weight;
  int left = integer(r, 0, static_cast<int>(total) - 1);
  std::size_t i = 0;
  while (left >= static_cast<int>(kFamilies[i].weight)) {
    left -= static_cast<int>(kFamilies[i++].weight);
  }
  return kFamilies[i];
}

/// A family, then one of: as it is; an ulp away; scaled by 2^k; translated.
inline Case any(Random& r) {
  const Family& family = pick_family(r);
  Case c{family.name, family.make(r)};
  const bool is_tame = family.weight >= 20;
  switch (integer(r, 0, 5)) {
    case 0:
      move_by_an_ulp(r, c.corners);
      c.family += ", an ulp away";
      break;
    case 1: {
      if (!is_tame) break;
      const int k = integer(r, 200, 1000) * (integer(r, 0, 1) * 2 - 1);
      c.corners =
          map_all(c.corners, [&](const Point3& p) { return scaled(p, std::ldexp(1.0, k)); });
      c.family += ", scaled by 2^" + std::to_string(k);
      break;
    }
    case 2: {
      if (!is_tame) break;
      const Point3 by = grid_point(r, 0, 1000);
      c.corners = map_all(c.corners, [&](const Point3& p) { return p + by; });
      c.family += ", translated";
      break;
    }
    default:
      break;
  }
  return c;
}

}  // namespace plumb::cases
