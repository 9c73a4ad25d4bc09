// The cells around a corner are found from its flags: a corner v, the direction r of a line of two
// planes through v, the direction s within one of the planes through that line, and a direction t
// across that plane. The point v + e r + e^2 s + e^3 t lies in a full-dimensional cell for every
// small e > 0, and the sign of a plane at it is the first sign that is not 0 of the plane at v and
// of its normal along r, s and t.
//
// Bounds: normals are below 2^22 and offsets below 2^36 (index_of() checks it), so determinants of
// three normals are below 2^69, those with an offset below 2^83, and their sums with a plane below
// 2^107.
#include "oracle/model_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <unordered_map>

namespace plumb::testing {
namespace {

__extension__ typedef __int128 WideInteger;
using WideVector = std::array<WideInteger, 3>;

int sign_of_wide(WideInteger x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

WideVector widened(const std::array<std::int64_t, 3>& v) { return {v[0], v[1], v[2]}; }
WideInteger wide_dot(const WideVector& a, const WideVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
WideVector wide_cross(const WideVector& a, const WideVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
WideVector scaled_wide(const WideVector& v, int factor) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}
bool is_zero_wide(const WideVector& v) { return v == WideVector{0, 0, 0}; }

BigInt big_of(WideInteger x) {
  const bool is_negative = x < 0;
  __extension__ typedef unsigned __int128 Unsigned;
  const Unsigned magnitude = is_negative ? -static_cast<Unsigned>(x) : static_cast<Unsigned>(x);
  BigInt value = static_cast<std::uint64_t>(magnitude >> 64U);
  value = (value << 64U) + static_cast<std::uint64_t>(magnitude);
  return is_negative ? BigInt(-value) : value;
}

/// A point with homogeneous coordinates, w > 0.
struct WidePoint {
  WideVector p{};
  WideInteger w = 1;
};

WideInteger value_at(const IntegerPlane& plane, const WidePoint& v) {
  return wide_dot(widened(plane.normal), v.p) + plane.offset * v.w;
}

ExactPoint3 exact_point(const WidePoint& v) {
  const BigInt w = big_of(v.w);
  return {BigRational(big_of(v.p[0]), w), BigRational(big_of(v.p[1]), w),
          BigRational(big_of(v.p[2]), w)};
}

/// A full-dimensional cell at a corner.
struct Flag {
  WidePoint corner;
  WideVector r, s, t;
};

/// Enumerates the cells.
class CellFinder {
 public:
  explicit CellFinder(std::span<const IntegerPlane> planes) : planes_(planes) {
    for (const IntegerPlane& plane : planes) normals_.push_back(widened(plane.normal));
  }

  ModelCells run() {
    const auto count = static_cast<std::uint32_t>(planes_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = i + 1; j < count; ++j) {
        const WideVector line = wide_cross(normals_[i], normals_[j]);
        if (is_zero_wide(line)) continue;
        for (std::uint32_t k = j + 1; k < count; ++k) add_corner({i, j, k}, line);
      }
    }
    for (std::uint32_t c = 0; c < found_.cells.size(); ++c) {
      found_.cells[c].inside = inside_of(c);
    }
    return std::move(found_);
  }

 private:
  using Triple = std::array<std::uint32_t, 3>;

  /// Adds the corner where three planes meet, unless other planes through it come first.
  void add_corner(const Triple& t, const WideVector& line) {
    const WideInteger determinant = wide_dot(line, normals_[t[2]]);
    if (determinant == 0) return;
    const WidePoint v = meeting_point(t, determinant);
    std::vector<std::uint32_t> through;
    CellSigns signs;
    for (std::uint32_t p = 0; p < planes_.size(); ++p) {
      const int sign = sign_of_wide(value_at(planes_[p], v));
      signs[p] = sign > 0;
      if (sign == 0) through.push_back(p);
    }
    if (!is_first(t, through)) return;
    found_.corners.push_back({exact_point(v), {}});
    add_flags(v, through, signs);
    std::vector<std::uint32_t>& cells = found_.corners.back().cells;
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  }

  WidePoint meeting_point(const Triple& t, WideInteger determinant) const {
    const WideVector &a = normals_[t[0]], &b = normals_[t[1]], &c = normals_[t[2]];
    const WideVector bc = wide_cross(b, c), ca = wide_cross(c, a), ab = wide_cross(a, b);
    WidePoint v;
    const int sign = determinant > 0 ? 1 : -1;
    v.w = sign * determinant;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v.p[axis] = -sign * (planes_[t[0]].offset * bc[axis] + planes_[t[1]].offset * ca[axis] +
                           planes_[t[2]].offset * ab[axis]);
    }
    return v;
  }

  /// Whether no other three of the planes through a point come before these ones.
  bool is_first(const Triple& t, const std::vector<std::uint32_t>& through) const {
    if (through[0] != t[0] || through[1] != t[1]) return false;
    const WideVector line = wide_cross(normals_[t[0]], normals_[t[1]]);
    const auto third = std::find_if(through.begin() + 2, through.end(), [&](std::uint32_t p) {
      return wide_dot(line, normals_[p]) != 0;
    });
    return *third == t[2];
  }

  void add_flags(const WidePoint& v, const std::vector<std::uint32_t>& through, CellSigns signs) {
    for (const std::uint32_t p : through) {
      for (const std::uint32_t q : through) {
        if (p >= q) continue;
        const WideVector line = wide_cross(normals_[p], normals_[q]);
        for (const int r : {1, -1}) add_flags_along(v, through, scaled_wide(line, r), signs);
      }
    }
  }

  void add_flags_along(const WidePoint& v, const std::vector<std::uint32_t>& through,
                       const WideVector& r, const CellSigns& signs) {
    for (const std::uint32_t m : through) {
      if (wide_dot(normals_[m], r) != 0) continue;
      const WideVector across = wide_cross(normals_[m], r);
      for (const int s : {1, -1}) {
        for (const int t : {1, -1}) {
          add_flag({v, r, scaled_wide(across, s), scaled_wide(normals_[m], t)}, through, signs);
        }
      }
    }
  }

  void add_flag(const Flag& flag, const std::vector<std::uint32_t>& through, CellSigns signs) {
    for (const std::uint32_t p : through) {
      int sign = sign_of_wide(wide_dot(normals_[p], flag.r));
      if (sign == 0) sign = sign_of_wide(wide_dot(normals_[p], flag.s));
      if (sign == 0) sign = sign_of_wide(wide_dot(normals_[p], flag.t));
      signs[p] = sign > 0;
    }
    const auto [known, is_new] =
        index_.try_emplace(signs, static_cast<std::uint32_t>(found_.cells.size()));
    if (is_new) {
      found_.cells.push_back({signs, {}});
      flags_.emplace_back();
    }
    flags_[known->second].push_back(flag);
    found_.corners.back().cells.push_back(known->second);
  }

  // -------------------------------------------------------------- points of cells

  /// Returns a point of a cell: a mean of corners, moved into the cell by several distances until
  /// it has the signs of the cell.
  ExactPoint3 inside_of(std::uint32_t cell) const {
    for (const double by : {0.0, 1.0, 0.0625}) {
      const IntegerPoint p = mean_of(flags_[cell], by);
      if (has_signs(p, found_.cells[cell].signs)) {
        const BigRational unit = power_of_two(-kFineBits);
        return {unit * p[0], unit * p[1], unit * p[2]};
      }
    }
    return moved_into(flags_[cell][0], found_.cells[cell].signs);
  }

  /// Returns the mean of the corners of flags, each moved into the cell, as a multiple of 2^-20.
  static IntegerPoint mean_of(const std::vector<Flag>& flags, double by) {
    std::array<double, 3> sum{};
    for (const Flag& flag : flags) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sum[axis] += static_cast<double>(flag.corner.p[axis]) / static_cast<double>(flag.corner.w);
        sum[axis] += by * (unit(flag.r, axis) + unit(flag.s, axis) / 4 + unit(flag.t, axis) / 16);
      }
    }
    IntegerPoint mean{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      mean[axis] =
          std::llround(std::ldexp(sum[axis] / static_cast<double>(flags.size()), kFineBits));
    }
    return mean;
  }
  static double unit(const WideVector& v, std::size_t axis) {
    const double length =
        std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
    return static_cast<double>(v[axis]) / length;
  }

  bool has_signs(const IntegerPoint& p, const CellSigns& signs) const {
    const WidePoint v{widened(p), WideInteger(1) << kFineBits};
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      if (sign_of_wide(value_at(planes_[i], v)) != (signs[i] ? 1 : -1)) return false;
    }
    return true;
  }

  /// Returns v + e r + e^2 s + e^3 t for an e that is small enough.
  ExactPoint3 moved_into(const Flag& flag, const CellSigns& signs) const {
    const ExactPoint3 v = exact_point(flag.corner);
    const ExactPoint3 r = exact_point({flag.r, 1}), s = exact_point({flag.s, 1}),
                      t = exact_point({flag.t, 1});
    for (int bits = 8;; bits += 8) {
      const BigRational e = power_of_two(-bits);
      const ExactPoint3 p = v + e * (r + e * (s + e * t));
      bool is_inside = true;
      for (std::size_t i = 0; is_inside && i < planes_.size(); ++i) {
        const IntegerPlane& plane = planes_[i];
        const BigRational value =
            plane.normal[0] * p.x + plane.normal[1] * p.y + plane.normal[2] * p.z + plane.offset;
        is_inside = signs[i] ? value > 0 : value < 0;
      }
      if (is_inside) return p;
    }
  }

  static constexpr int kFineBits = 20;

  std::span<const IntegerPlane> planes_;
  std::vector<WideVector> normals_;
  ModelCells found_;
  std::unordered_map<CellSigns, std::uint32_t> index_;
  std::vector<std::vector<Flag>> flags_;  // Of each cell.
};

/// Returns the plane through three points; its normal is zero if they are collinear.
IntegerPlane plane_of_points(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c) {
  const auto minus = [](const IntegerPoint& p, const IntegerPoint& q) {
    return IntegerPoint{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  };
  const IntegerPoint u = minus(b, a), v = minus(c, a);
  IntegerPlane plane;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
    plane.normal[axis] = u[next] * v[last] - u[last] * v[next];
  }
  const std::int64_t common = std::gcd(std::gcd(plane.normal[0], plane.normal[1]), plane.normal[2]);
  if (common == 0) return plane;
  const auto leading =
      std::find_if(plane.normal.begin(), plane.normal.end(), [](std::int64_t x) { return x != 0; });
  const std::int64_t factor = *leading > 0 ? common : -common;
  for (std::int64_t& x : plane.normal) x /= factor;
  for (std::size_t axis = 0; axis < 3; ++axis) plane.offset -= plane.normal[axis] * a[axis];
  return plane;
}

}  // namespace

std::size_t ModelPlanes::index_of(const IntegerPlane& plane) {
  const auto known = std::find(planes_.begin(), planes_.end(), plane);
  if (known != planes_.end()) return static_cast<std::size_t>(known - planes_.begin());
  constexpr std::int64_t kMostNormal = std::int64_t{1} << 22, kMostOffset = std::int64_t{1} << 36;
  bool is_small = std::abs(plane.offset) < kMostOffset && planes_.size() < kMostModelPlanes;
  for (const std::int64_t x : plane.normal) is_small = is_small && std::abs(x) < kMostNormal;
  if (!is_small) std::abort();
  planes_.push_back(plane);
  return planes_.size() - 1;
}

IntegerPolytope ModelPlanes::hull_of(std::span<const IntegerPoint> points) {
  IntegerPolytope hull;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const IntegerPlane plane = plane_of_points(points[i], points[j], points[k]);
        if (plane.normal == IntegerPoint{}) continue;
        bool is_any_above = false, is_any_below = false;
        for (const IntegerPoint& p : points) {
          const std::int64_t value = plane.normal[0] * p[0] + plane.normal[1] * p[1] +
                                     plane.normal[2] * p[2] + plane.offset;
          is_any_above = is_any_above || value > 0;
          is_any_below = is_any_below || value < 0;
        }
        if (is_any_above == is_any_below) continue;
        const std::size_t index = index_of(plane);
        hull.planes.set(index);
        hull.above[index] = is_any_above;
      }
    }
  }
  return hull;
}

ModelCells cells_of(std::span<const IntegerPlane> planes) { return CellFinder(planes).run(); }

}  // namespace plumb::testing
