#include "oracle/sign_oracle.h"

#include <algorithm>
#include <cmath>

namespace plumb::testing {
namespace {

using Row = std::vector<BigInt>;

// value == mantissa * 2^exponent
struct Scaled {
  std::int64_t mantissa;
  int exponent;
};

Scaled split(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  return {mantissa, mantissa == 0 ? 1024 : exponent - 53};
}

double coordinate(const Point3& p, int axis) { return axis == 0 ? p.x : (axis == 1 ? p.y : p.z); }

Row minus(const Row& a, const Row& b) {
  Row result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

}  // namespace

std::vector<Row> on_common_grid(const std::vector<Point3>& points, int dimension) {
  int least = 1024;
  for (const Point3& p : points) {
    for (int axis = 0; axis < dimension; ++axis) {
      least = std::min(least, split(coordinate(p, axis)).exponent);
    }
  }
  std::vector<Row> result;
  for (const Point3& p : points) {
    Row& row = result.emplace_back();
    for (int axis = 0; axis < dimension; ++axis) {
      const Scaled s = split(coordinate(p, axis));
      const BigInt magnitude = BigInt(std::abs(s.mantissa)) << (s.exponent - least);
      row.push_back(s.mantissa < 0 ? BigInt(-magnitude) : magnitude);
    }
  }
  return result;
}

BigInt determinant(const std::vector<Row>& rows) {
  if (rows.size() == 1) return rows[0][0];
  BigInt sum = 0;
  for (std::size_t column = 0; column < rows.size(); ++column) {
    std::vector<Row> minor(rows.begin() + 1, rows.end());
    for (Row& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    const BigInt term = rows[0][column] * determinant(minor);
    sum += column % 2 == 0 ? term : BigInt(-term);
  }
  return sum;
}

Sign simplex_sign(const std::vector<Point3>& points, int dimension, bool lifted) {
  const std::vector<Row> grid = on_common_grid(points, dimension);
  std::vector<Row> rows;
  for (std::size_t i = 0; i + 1 < grid.size(); ++i) {
    Row row = minus(grid[i], grid.back());
    BigInt square = 0;
    for (const BigInt& difference : row) square += difference * difference;
    if (lifted) row.push_back(square);
    rows.push_back(std::move(row));
  }
  return sign_of(determinant(rows).sign());
}

Sign cross_sign_oracle(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const std::vector<Row> grid = on_common_grid({a, b, c, d}, 2);
  return sign_of(determinant({minus(grid[1], grid[0]), minus(grid[3], grid[2])}).sign());
}

}  // namespace plumb::testing
