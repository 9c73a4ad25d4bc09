// Rounds coordinates, and reports the damage that rounding the vertices of a mesh has caused.
//
// Before rounding the faces neither cross nor coincide. Faces without a rounded vertex do not
// change. So only faces with a rounded vertex, and faces near them, can be damaged. For most of
// these faces, doubtful_faces() proves with doubles that they are not damaged. check_faces() finds
// the defects of the others.
//
// Tested by tests/space/rounded_mesh_test.cpp and tests/space/to_mesh_test.cpp.

#include "plumb/space/rounded_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/predicates/error.h"
#include "plumb/space/mesh/check_faces.h"
#include "plumb/space/mesh/doubtful_faces.h"

namespace plumb {
namespace {

using Vector3 = std::array<double, 3>;

// The memory of a copy of the point, and of the place of its exact coordinates.
constexpr std::uint64_t kRoundedPointBytes = 32;
// The memory of a copy of near faces, and of lists of faces.
constexpr std::uint64_t kRoundedCornerBytes = 12;

Vector3 coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

}  // namespace

double nearest_coordinate(double value, CoordinateType type) {
  constexpr double kLargestDouble = std::numeric_limits<double>::max();
  constexpr double kLargestFloat = std::numeric_limits<float>::max();
  // The middle between kLargestFloat and 2^128.
  constexpr double kRoundsToInfinity = 0x1.ffffffp127;
  const double size = std::fabs(value);
  if (type == CoordinateType::Double) {
    if (size <= kLargestDouble) return value;
    throw Error(ErrorCode::NumberOutOfRange, "a coordinate is larger than the largest double");
  }
  if (size < kRoundsToInfinity) {
    return static_cast<float>(std::clamp(value, -kLargestFloat, kLargestFloat));
  }
  throw Error(ErrorCode::NumberOutOfRange, "a coordinate is larger than the largest float");
}

int last_digit_exponent(double value, CoordinateType type) {
  constexpr int kDoubleDigits = 52, kFloatDigits = 23, kLeastDouble = -1074, kLeastFloat = -149;
  const bool is_double = type == CoordinateType::Double;
  const int least = is_double ? kLeastDouble : kLeastFloat;
  if (value == 0) return least;
  return std::max(std::ilogb(value) - (is_double ? kDoubleDigits : kFloatDigits), least);
}

double round_point(Point3& point, bool is_constructed, CoordinateType type) {
  constexpr double kRoundingOfTheSum = 1 + 0x1p-48;
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const Vector3 before = coordinates(point);
  Vector3 after{}, move{};
  for (std::size_t k = 0; k < 3; ++k) after[k] = nearest_coordinate(before[k], type);
  if (!is_constructed && after == before) return 0;
  for (std::size_t k = 0; k < 3; ++k) {
    // The double nearest to a constructed coordinate is at most half a unit away from it.
    const int digit = last_digit_exponent(before[k], CoordinateType::Double);
    const double half = is_constructed ? std::max(std::ldexp(0.5, digit), kLeast) : 0;
    move[k] = half + std::fabs(after[k] - before[k]);
  }
  point = {after[0], after[1], after[2]};
  return std::hypot(move[0], move[1], move[2]) * kRoundingOfTheSum;
}

double round_points(PolygonMesh& mesh, CoordinateType type) {
  const RoundToNearest rounding;
  double largest = 0;
  std::vector<std::pair<std::uint32_t, RationalPoint3>> moved;
  auto exact = mesh.exact.begin();
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    const bool is_constructed = exact != mesh.exact.end() && exact->first == v;
    const Point3 before = mesh.points[v];
    largest = std::max(largest, round_point(mesh.points[v], is_constructed, type));
    if (is_constructed) {
      moved.push_back(std::move(*exact++));
    } else if (mesh.points[v] != before) {
      moved.emplace_back(v, RationalPoint3{before.x, before.y, before.z});
    }
  }
  mesh.exact = std::move(moved);
  return largest;
}

RoundingReport check_rounding(const PolygonMesh& mesh, std::uint64_t max_listed, Context& context) {
  MemoryCharge memory(context);
  memory.add(kRoundedPointBytes * mesh.points.size() + kRoundedCornerBytes * mesh.corners.size(),
             "a rounded mesh");
  RoundingReport report;
  std::vector<std::uint8_t> is_rounded(mesh.points.size(), 0);
  for (const auto& [v, exact] : mesh.exact) {
    is_rounded[v] = 1;
    const Point3& p = mesh.points[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      report.beyond_doubles.push_back(v);
    }
  }
  if (report.beyond_doubles.empty() && !mesh.exact.empty()) {
    const DoubtfulFaces doubtful = doubtful_faces(mesh, faces_at(mesh, is_rounded), context);
    report = check_faces(mesh, doubtful, max_listed, context);
  }
  report.rounded_vertices = mesh.exact.size();
  return report;
}

}  // namespace plumb
