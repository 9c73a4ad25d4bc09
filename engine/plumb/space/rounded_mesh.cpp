// Finds what rounding the vertices of a mesh has broken.
//
// Before rounding the faces neither cross nor coincide. Faces without a rounded vertex stay as they
// are, so only faces with one, and those whose boxes meet them, have to be looked at: they are read
// again as a mesh of their own, with rounded coordinates, and complex_of_mesh() reports what is
// wrong with it. Merged vertices are counted against those that coincided before.
//
// A face is flipped if the scalar product of its area vectors before and after is negative. Doubles
// decide unless the face is so small that rounding may have turned it; then rationals do.
//
// Tested by tests/space/to_mesh_test.cpp.

#include "plumb/space/rounded_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plumb/base/internal/box_tree.h"
#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/mesh_vertices.h"

namespace plumb {
namespace {

using Vector3 = std::array<double, 3>;

constexpr std::uint64_t kRoundedPointBytes = 32;   // A copy of it, and the place of its exact one.
constexpr std::uint64_t kRoundedCornerBytes = 12;  // A copy of near faces, and lists of faces.

Vector3 coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

/// The check of one mesh.
class RoundingCheck {
 public:
  RoundingCheck(const PolygonMesh& mesh, std::uint64_t max_listed, Context& context)
      : mesh_(mesh), max_listed_(max_listed), context_(context) {}

  RoundingReport run() {
    MemoryCharge memory(context_);
    memory.add(
        kRoundedPointBytes * mesh_.points.size() + kRoundedCornerBytes * mesh_.corners.size(),
        "a rounded mesh");
    report_.rounded_vertices = mesh_.exact.size();
    note_rounded();
    if (!report_.beyond_doubles.empty() || mesh_.exact.empty()) return std::move(report_);
    select_faces();
    judge();
    for (const std::uint32_t f : moved_) {
      if (is_flipped(f)) report_.flipped.push_back(f);
    }
    return std::move(report_);
  }

 private:
  /// Notes which vertices were rounded, and which of them to infinity.
  void note_rounded() {
    exact_of_.assign(mesh_.points.size(), kNone);
    for (std::uint32_t k = 0; k < mesh_.exact.size(); ++k) {
      const std::uint32_t v = mesh_.exact[k].first;
      exact_of_[v] = k;
      const Point3& p = mesh_.points[v];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        report_.beyond_doubles.push_back(v);
      }
    }
  }

  // ---------------------------------------------------------------- 1. faces

  /// Selects the faces with a rounded vertex, and those whose boxes meet the boxes of these.
  void select_faces() {
    std::vector<Box3> boxes;
    std::vector<std::uint8_t> is_moved(mesh_.face_count(), 0);
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      const auto corners = mesh_.face(f);
      if (!std::ranges::any_of(corners, [&](std::uint32_t v) { return exact_of_[v] != kNone; })) {
        continue;
      }
      is_moved[f] = 1;
      moved_.push_back(f);
      boxes.push_back(box_of(f));
    }
    const BoxTree tree(boxes);
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      bool is_near = is_moved[f] != 0;
      if (!is_near) tree.for_each_meeting(box_of(f), [&](std::uint32_t) { is_near = true; });
      if (is_near) selected_.push_back(f);
    }
  }
  Box3 box_of(std::uint32_t f) const {
    Box3 box;
    for (const std::uint32_t v : mesh_.face(f)) {
      const Vector3 p = coordinates(mesh_.points[v]);
      box.add({p, p});
    }
    return box;
  }

  // ---------------------------------------------------------------- 2. what is wrong with them

  /// Reads the selected faces as a mesh and reports what is wrong with it.
  void judge() {
    PolygonMesh near;
    near.points = mesh_.points;
    for (const std::uint32_t f : selected_) near.add_face(mesh_.face(f));
    MeshOptions options;
    options.surface = true;
    options.max_listed = max_listed_;
    const MeshReport found = complex_of_mesh(near, options, context_).report;
    report_.vertices_merged = found.vertices_merged - merged_before(near);
    report_.degenerate = faces(found.degenerate);
    report_.not_simple = faces(found.not_simple);
    report_.not_planar = faces(found.not_planar);
    report_.doubled = faces(found.doubled);
    report_.crossing_count = found.crossing_count;
    report_.crossings = faces(found.crossings);
  }
  /// Returns how many vertices coincide before rounding: they were split on purpose.
  std::uint64_t merged_before(PolygonMesh& near) const {
    near.exact = mesh_.exact;
    SpaceTables tables;
    return merge_equal_points(near, tables).merged;
  }
  /// Returns the faces of the mesh for selected ones.
  std::vector<std::uint32_t> faces(std::vector<std::uint32_t> near) const {
    for (std::uint32_t& f : near) f = selected_[f];
    return near;
  }
  std::vector<RoundingReport::FacePair> faces(std::vector<RoundingReport::FacePair> near) const {
    for (auto& [f, g] : near) {
      f = selected_[f];
      g = selected_[g];
    }
    return near;
  }

  // ---------------------------------------------------------------- 3. flipped

  /// Whether the area vectors of a face before and after rounding point apart. Doubles decide,
  /// unless the face is so small that rounding could have turned it.
  bool is_flipped(std::uint32_t f) const {
    const auto corners = mesh_.face(f);
    const Vector3 o = coordinates(mesh_.points[corners[0]]);
    Vector3 sum{}, before{};
    double reach = 0, largest = 0;
    for (const std::uint32_t v : corners) {
      const Vector3 p = coordinates(mesh_.points[v]);
      const Vector3 d{p[0] - o[0], p[1] - o[1], p[2] - o[2]};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        sum[k] += before[i] * d[j] - before[j] * d[i];
        reach = std::max(reach, std::fabs(d[k]));
        largest = std::max(largest, std::fabs(p[k]));
      }
      before = d;
    }
    // Coordinates moved by half a unit in the last place of the largest one, which counts twice in
    // a difference. If the largest component of the sum is more than twice the error, the vector
    // before rounding has the same sign there and is longer than what the others can have changed.
    const double count = static_cast<double>(corners.size());
    const double step = 0x1p-51 * largest + 0x1p-1000;
    const double error =
        8 * count * step * (reach + step) + count * count * 0x1p-49 * reach * reach;
    const double size = std::max({std::fabs(sum[0]), std::fabs(sum[1]), std::fabs(sum[2])});
    return !(size > 2 * error) && is_flipped_exactly(f);
  }
  /// Decides the same with rationals.
  bool is_flipped_exactly(std::uint32_t f) const {
    const std::array<Rational, 3> now = area(f, false), then = area(f, true);
    return now[0] * then[0] + now[1] * then[1] + now[2] * then[2] < 0;
  }
  /// Returns twice the area vector of a face, with exact or rounded vertices.
  std::array<Rational, 3> area(std::uint32_t f, bool is_exact) const {
    std::array<Rational, 3> sum;
    std::array<Rational, 3> before = point(mesh_.face(f).back(), is_exact);
    for (const std::uint32_t v : mesh_.face(f)) {
      const std::array<Rational, 3> p = point(v, is_exact);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        sum[k] += before[i] * p[j] - before[j] * p[i];
      }
      before = p;
    }
    return sum;
  }
  std::array<Rational, 3> point(std::uint32_t v, bool is_exact) const {
    if (is_exact && exact_of_[v] != kNone) {
      const RationalPoint3& p = mesh_.exact[exact_of_[v]].second;
      return {p.x, p.y, p.z};
    }
    const Point3& p = mesh_.points[v];
    return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
  }

  const PolygonMesh& mesh_;
  std::uint64_t max_listed_;
  Context& context_;
  RoundingReport report_;
  std::vector<std::uint32_t> exact_of_;  // The index in mesh.exact of each vertex, or kNone.
  std::vector<std::uint32_t> moved_;     // Faces with a rounded vertex.
  std::vector<std::uint32_t> selected_;  // These and the faces near them.
};

}  // namespace

double nearest_coordinate(double value, CoordinateType type) {
  constexpr double kLargestDouble = std::numeric_limits<double>::max();
  constexpr double kLargestFloat = std::numeric_limits<float>::max();
  constexpr double kRoundsToInfinity = 0x1.ffffffp127;  // The middle of kLargestFloat and 2^128.
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

double round_points(PolygonMesh& mesh, CoordinateType type) {
  const RoundToNearest rounding;
  constexpr double kRoundingOfTheSum = 1 + 0x1p-48;
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  double largest = 0;
  std::vector<std::pair<std::uint32_t, RationalPoint3>> moved;
  auto exact = mesh.exact.begin();
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    const bool is_constructed = exact != mesh.exact.end() && exact->first == v;
    const Vector3 before = coordinates(mesh.points[v]);
    Vector3 after{}, move{};
    for (std::size_t k = 0; k < 3; ++k) {
      after[k] = nearest_coordinate(before[k], type);
      // The double nearest to a constructed coordinate is at most half a unit away from it.
      const int digit = last_digit_exponent(before[k], CoordinateType::Double);
      const double half = std::max(std::ldexp(0.5, digit), kLeast);
      move[k] = (is_constructed ? half : 0) + std::fabs(after[k] - before[k]);
    }
    if (is_constructed) {
      moved.push_back(std::move(*exact++));
    } else if (after != before) {
      moved.emplace_back(v, RationalPoint3{before[0], before[1], before[2]});
    } else {
      continue;
    }
    mesh.points[v] = {after[0], after[1], after[2]};
    largest = std::max(largest, std::hypot(move[0], move[1], move[2]));
  }
  mesh.exact = std::move(moved);
  return largest * kRoundingOfTheSum;
}

RoundingReport check_rounding(const PolygonMesh& mesh, std::uint64_t max_listed, Context& context) {
  return RoundingCheck(mesh, max_listed, context).run();
}

}  // namespace plumb
