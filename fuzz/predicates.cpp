// Every rung of every predicate on input doubles against Boost integers, and the constructed points
// of PointTable2 against Boost rationals; in any rounding mode, with and without flush-to-zero.
//
// Input: {predicate, environment, construction, scale}, then the coordinates, each {how, ...}; an
// input that is too short goes on with zeros.
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <tuple>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "oracle/segments.h"
#include "oracle/sign_oracle.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/testing/oracle_reached.h"

namespace plumb::testing {
namespace {

class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  std::int64_t number(int bytes) {  // signed, most significant byte first
    std::int64_t value = static_cast<std::int8_t>(byte());
    for (int i = 1; i < bytes; ++i) value = value * 256 + byte();
    return value;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

// ---------------------------------------------------------------- the environment

// Sets a rounding mode and flush-to-zero for its lifetime. The oracle must not run inside.
class Environment {
 public:
  explicit Environment(std::uint8_t choice) {
    static constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    std::fegetenv(&saved_);
    std::fesetround(kModes[choice % 4]);
#if defined(__SSE2__)
    constexpr unsigned kFlushToZeroAndDenormalsAreZero = 0x8040;
    if (choice / 4 % 2 == 1) _mm_setcsr(_mm_getcsr() | kFlushToZeroAndDenormalsAreZero);
#endif
  }
  ~Environment() { std::fesetenv(&saved_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::fenv_t saved_;
};

// ---------------------------------------------------------------- coordinates and points

double finite(double value) {
  if (std::isfinite(value)) return value;
  return std::signbit(value) ? -std::numeric_limits<double>::max()
                             : std::numeric_limits<double>::max();
}

double from_bits(std::uint64_t bits) {
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return finite(value);
}

double any_coordinate(ByteReader& in) {
  const std::uint8_t how = in.byte();
  switch (how % 6) {
    case 0:
      return static_cast<double>(in.number(1));
    case 1:
      return from_bits(static_cast<std::uint64_t>(in.number(8)));
    case 2:
      return std::ldexp(static_cast<double>(in.number(2)), static_cast<int>(in.number(1)));
    case 3:
      return static_cast<double>(in.number(1)) * std::numeric_limits<double>::denorm_min();
    case 4:
      return finite(
          std::ldexp(static_cast<double>(in.number(6)), 8 * static_cast<int>(in.number(1))));
    default:
      return how > 127 ? std::numeric_limits<double>::max() : 0.5 + 0x1p-52 * how;
  }
}

Point3 any_point(ByteReader& in) {
  const double x = any_coordinate(in);
  const double y = any_coordinate(in);
  return {x, y, any_coordinate(in)};
}

double moved_by_ulps(double value, int ulps) {
  const double to =
      ulps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::abs(ulps); ++i) value = std::nextafter(value, to);
  return finite(value);
}

// Near the line or plane of the others: an affine combination, rounded, then a few ulps away.
Point3 near_flat(const std::vector<Point3>& others, ByteReader& in) {
  const double s = static_cast<double>(in.number(1)) / 16;
  const double t = static_cast<double>(in.number(1)) / 16;
  const Point3 a = others[0], b = others[1], c = others[others.size() - 1];
  const auto mix = [&](double u, double v, double w) {
    return moved_by_ulps(finite(u + s * (v - u) + t * (w - u)),
                         static_cast<int>(in.byte() % 5) - 2);
  };
  return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
}

// x^2 + y^2 + z^2 = 65^2, in the plane and in space; moved, so that the centre is not the origin.
Point3 near_sphere(bool in_plane, ByteReader& in) {
  static constexpr double kCircle[][3] = {{16, 63, 0}, {25, 60, 0}, {33, 56, 0},
                                          {39, 52, 0}, {65, 0, 0},  {0, 65, 0}};
  static constexpr double kSphere[][3] = {{0, 39, 52}, {25, 36, 48}, {15, 20, 60},
                                          {33, 56, 0}, {0, 0, 65},   {36, 48, 25}};
  const std::uint8_t which = in.byte();
  const double* p = in_plane ? kCircle[which % 6] : kSphere[which % 6];
  const std::uint8_t signs = in.byte();
  const auto at = [&](int axis) {
    const double value = (signs >> axis) % 2 == 0 ? p[axis] : -p[axis];
    const bool is_moved = signs >= 224;
    return moved_by_ulps(value + 7 * axis + 1, is_moved ? which % 3 - 1 : 0);
  };
  return {at(0), at(1), at(2)};
}

std::vector<Point3> any_points(std::size_t count, std::uint8_t construction, bool in_plane,
                               ByteReader& in) {
  std::vector<Point3> points;
  while (points.size() < count) {
    if (construction % 4 == 2) {
      points.push_back(near_sphere(in_plane, in));
    } else if (construction % 4 == 1 && points.size() + 1 == count && count > 2) {
      points.push_back(near_flat(points, in));
    } else {
      points.push_back(any_point(in));
    }
  }
  return points;
}

void scale(std::vector<Point3>& points, std::uint8_t scale) {
  static constexpr int kPowers[] = {0, 0, 0, 0, 200, -200, 500, -500, 900, -900, -1000, -1060};
  const int power = kPowers[scale % std::size(kPowers)];
  for (Point3& p : points) {
    p = {finite(std::ldexp(p.x, power)), finite(std::ldexp(p.y, power)),
         finite(std::ldexp(p.z, power))};
  }
}

// ---------------------------------------------------------------- judging

[[noreturn]] void report(const char* what, int got, int wanted, const std::vector<Point3>& points) {
  std::fprintf(stderr, "%s: got %d, expected %d, of\n", what, got, wanted);
  for (const Point3& p : points) std::fprintf(stderr, "  %a %a %a\n", p.x, p.y, p.z);
  std::abort();
}

struct Rungs {
  FilteredSign filter;
  FilteredSign exact;
  Sign big;
  Sign whole;
};

void judge(const char* what, const Rungs& got, Sign wanted, const std::vector<Point3>& points) {
  const auto number = [](auto sign) { return static_cast<int>(sign); };
  const auto expect = [&](const char* rung, int sign) {
    if (sign == number(wanted) || sign == number(FilteredSign::Unsure)) return;
    std::fprintf(stderr, "%s, ", what);
    report(rung, sign, number(wanted), points);
  };
  expect("filter", number(got.filter));
  expect("exact", number(got.exact));
  expect("big", number(got.big));
  expect("whole", number(got.whole));
}

Point2 flat(const Point3& p) { return {p.x, p.y}; }

Rungs rungs_of(int predicate, const std::vector<Point3>& p) {
  const Point2 a = flat(p[0]), b = flat(p[1]), c = flat(p[2]), d = flat(p[3]);
  switch (predicate) {
    case 0:
      return {rung::orient2d_filter(a, b, c), rung::orient2d_exact(a, b, c),
              rung::orient2d_big(a, b, c), orient2d(a, b, c)};
    case 1:
      return {rung::cross_sign_filter(a, b, c, d), rung::cross_sign_exact(a, b, c, d),
              rung::cross_sign_big(a, b, c, d), cross_sign(a, b, c, d)};
    case 2:
      return {rung::orient3d_filter(p[0], p[1], p[2], p[3]),
              rung::orient3d_exact(p[0], p[1], p[2], p[3]),
              rung::orient3d_big(p[0], p[1], p[2], p[3]), orient3d(p[0], p[1], p[2], p[3])};
    case 3:
      return {rung::incircle_filter(a, b, c, d), rung::incircle_exact(a, b, c, d),
              rung::incircle_big(a, b, c, d), incircle(a, b, c, d)};
    default:
      return {rung::insphere_filter(p[0], p[1], p[2], p[3], p[4]),
              rung::insphere_exact(p[0], p[1], p[2], p[3], p[4]),
              rung::insphere_big(p[0], p[1], p[2], p[3], p[4]),
              insphere(p[0], p[1], p[2], p[3], p[4])};
  }
}

Sign wanted_sign(int predicate, const std::vector<Point3>& p) {
  switch (predicate) {
    case 0:
      return simplex_sign(p, 2, false);
    case 1:
      return cross_sign_oracle(p[0], p[1], p[2], p[3]);
    case 2:
      return simplex_sign(p, 3, false);
    case 3:
      return simplex_sign(p, 2, true);
    default:
      return simplex_sign(p, 3, true);
  }
}

void judge_input_predicate(int predicate, std::uint8_t environment, std::uint8_t construction,
                           std::uint8_t scaling, ByteReader& in) {
  static constexpr const char* kNames[] = {"orient2d", "cross_sign", "orient3d", "incircle",
                                           "insphere"};
  static constexpr std::size_t kCounts[] = {3, 4, 4, 4, 5};
  const bool in_plane = predicate != 2 && predicate != 4;
  std::vector<Point3> points = any_points(kCounts[predicate], construction, in_plane, in);
  scale(points, scaling);
  fuzz::oracle_reached();
  const Sign wanted = wanted_sign(predicate, points);
  std::vector<Point3> padded = points;
  padded.resize(5);
  const Rungs got = [&] {
    const Environment set(environment);
    return rungs_of(predicate, padded);
  }();
  judge(kNames[predicate], got, wanted, points);
}

// ---------------------------------------------------------------- constructed points

struct Table {
  PointTable2 points;
  std::vector<ExactPoint> exact;
};

// Points 0-3 and 4-7 are pairs of lines; now and then a coordinate is a fraction.
Table any_table(std::uint8_t construction, std::uint8_t scaling, ByteReader& in) {
  std::vector<Point3> doubles = any_points(8, construction, true, in);
  scale(doubles, scaling);
  Table table;
  for (const Point3& p : doubles) {
    ExactPoint exact = exact_of(flat(p));
    const std::uint8_t divisor = in.byte();
    if (divisor > 192) exact.x /= divisor;
    table.exact.push_back(exact);
    if (divisor > 192) {
      table.points.push_back(to_rational(exact.x), to_rational(exact.y));
    } else {
      table.points.push_back(flat(p));
    }
  }
  return table;
}

using Lines = IntegerPoints;

BigInt cross_of(const Lines& lines, std::size_t a) {
  return cross(lines.points[a], lines.points[a + 1], lines.points[a + 2], lines.points[a + 3]);
}

ExactPoint crossing_of(const Lines& lines, std::size_t a) {
  const IntegerPoint& p = lines.points[a];
  const IntegerPoint& q = lines.points[a + 1];
  const IntegerPoint& r = lines.points[a + 2];
  BigInt den = cross_of(lines, a);
  BigInt num = cross(p, r, r, lines.points[a + 3]);
  if (den < 0) {
    den = -den;
    num = -num;
  }
  const BigRational t(num, den);
  return {(p.x + t * (q.x - p.x)) / lines.denominator, (p.y + t * (q.y - p.y)) / lines.denominator};
}

Sign order(const ExactPoint& p, const ExactPoint& q) {
  return p == q ? Sign::Zero : (p < q ? Sign::Negative : Sign::Positive);
}

Sign side(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p) {
  return sign_of(BigRational((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)).sign());
}

bool is_near(const Crossing2& c, const ExactPoint& p) {
  if (!std::isfinite(c.radius)) return true;
  const BigRational radius = exact_of(c.radius);
  return abs(BigRational(p.x - exact_of(c.x))) <= radius &&
         abs(BigRational(p.y - exact_of(c.y))) <= radius;
}

void expect(const char* what, bool holds, const Table& table) {
  if (holds) return;
  std::fprintf(stderr, "%s is wrong, of\n", what);
  for (const ExactPoint& p : table.exact) {
    std::fprintf(stderr, "  %s %s\n", p.x.str().c_str(), p.y.str().c_str());
  }
  std::abort();
}

void judge_table(const Table& t, std::uint8_t environment) {
  const PointTable2& p = t.points;
  const auto [turn, by_x, cross] = [&] {
    const Environment set(environment);
    return std::tuple(orient2d(p, 0, 1, 2), compare_xy(p, 3, 4), cross_sign(p, 0, 1, 2, 3));
  }();
  expect("orient2d by index", turn == side(t.exact[0], t.exact[1], t.exact[2]), t);
  expect("compare_xy by index", by_x == order(t.exact[3], t.exact[4]), t);
  expect("cross_sign by index",
         cross == sign_of(cross_of(over_common_denominator(t.exact), 0).sign()), t);
}

void judge_crossings(const Table& t, const Lines& lines, std::uint8_t environment) {
  const PointTable2& table = t.points;
  const ExactPoint p = crossing_of(lines, 0);
  const ExactPoint q = crossing_of(lines, 4);
  const auto [c, d, by_vertex, by_crossing, itself, turn] = [&] {
    const Environment set(environment);
    const Crossing2 first = make_crossing(table, 0, 1, 2, 3);
    const Crossing2 second = make_crossing(table, 4, 5, 6, 7);
    return std::tuple(first, second, compare_xy(table, first, 4), compare_xy(table, first, second),
                      compare_xy(table, first, first), orient2d(table, 4, 5, first));
  }();
  expect("the box of a crossing", is_near(c, p) && is_near(d, q), t);
  expect("the exact crossing", exact_of(exact(table, c)) == p, t);
  expect("a crossing against a vertex", by_vertex == order(p, t.exact[4]), t);
  expect("a crossing against a crossing", by_crossing == order(p, q), t);
  expect("a crossing against itself", itself == Sign::Zero, t);
  expect("the side of a crossing", turn == side(t.exact[4], t.exact[5], p), t);
}

void judge_point_table(std::uint8_t environment, std::uint8_t construction, std::uint8_t scaling,
                       ByteReader& in) {
  const Table table = any_table(construction, scaling, in);
  fuzz::oracle_reached();
  judge_table(table, environment);
  const Lines lines = over_common_denominator(table.exact);
  if (cross_of(lines, 0) != 0 && cross_of(lines, 4) != 0) {
    judge_crossings(table, lines, environment);
  }
}

void run(ByteReader in) {
  const int predicate = in.byte() % 7;
  const std::uint8_t environment = in.byte();
  const std::uint8_t construction = in.byte();
  const std::uint8_t scaling = in.byte();
  if (predicate < 5) {
    judge_input_predicate(predicate, environment, construction, scaling, in);
  } else {
    judge_point_table(environment, construction, scaling, in);
  }
}

}  // namespace
}  // namespace plumb::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  plumb::testing::run({data, size});
  return 0;
}
