// Welding of close points by a grid with a hash table.
//
// Equal points are merged first (mesh_vertices.h), so that the grid holds each place once. For a
// point, the cells of its coordinates, minus and plus the tolerance, are searched along each axis.
// If the spacing of doubles is small compared with the tolerance, these are at most two cells,
// because cells are four times as wide as the tolerance. Otherwise every double has a cell of its
// own, and the three values reach all doubles that are near enough. So a neighbour is never missed
// because of rounding: rounding keeps the order.
//
// Two distances are compared in doubles with a relative error bound, and with fractions where that
// does not decide, or where squares leave the range of doubles.
//
// Tested by tests/space/weld_points_test.cpp.

#include "plumb/space/weld_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/mesh/mesh_vertices.h"

namespace plumb {
namespace {

constexpr std::uint32_t kPointsPerCheckpoint = 4096;

using Vector3 = std::array<double, 3>;
using Cell = std::array<std::uint64_t, 3>;

/// Places of a mesh, and which of them are within the tolerance of each other.
class Nearness {
 public:
  Nearness(const MeshView& mesh, const MeshVertices& vertices, const Point3Table& table,
           double tolerance)
      : mesh_(mesh), vertices_(vertices), table_(table), tolerance_(tolerance) {
    const double square = tolerance * tolerance;
    if (square < 0x1p-900 || square > 0x1p1000) return;  // Fractions decide in this case.
    // The error of differences, squares and sums is less than 5 roundings of their values.
    surely_near_ = square * (1 - 0x1p-48);
    surely_far_ = square * (1 + 0x1p-48);
  }

  /// Returns the coordinates of a vertex, rounded.
  Vector3 at(std::uint32_t v) const {
    const Point3 p = mesh_.point(vertices_.input[v]);
    return {p.x, p.y, p.z};
  }

  /// Returns the squared distance in doubles.
  double square(std::uint32_t v, std::uint32_t w) const {
    const Vector3 p = at(v), q = at(w);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
    return sum;
  }

  /// Whether two vertices are at most the tolerance apart. `square` is that of square().
  bool are_near(std::uint32_t v, std::uint32_t w, double square) const {
    const SpacePoint p = vertices_.point[v], q = vertices_.point[w];
    if (p.is_input() && q.is_input()) {
      if (square < surely_near_) return true;
      if (square > surely_far_) return false;
    }
    const Rational e = exact_rational(tolerance_);
    return exact_square(p, q) <= e * e;
  }

  /// Returns the distance of two vertices that are near, rounded up. `square` is that of square().
  double distance(std::uint32_t v, std::uint32_t w, double square) const {
    const SpacePoint p = vertices_.point[v], q = vertices_.point[w];
    const bool is_sure = p.is_input() && q.is_input() && square > 0x1p-900 && square < 0x1p1000;
    if (!is_sure) square = round_to_double(exact_square(p, q), Rounding::Up).value;
    return std::min(std::sqrt(square) * (1 + 0x1p-48), tolerance_);
  }

 private:
  Rational exact_square(SpacePoint p, SpacePoint q) const {
    const RationalPoint3 a = exact(table_, p), b = exact(table_, q);
    const Rational x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
  }

  const MeshView& mesh_;
  const MeshVertices& vertices_;
  const Point3Table& table_;
  double tolerance_;
  double surely_near_ = 0;
  double surely_far_ = std::numeric_limits<double>::infinity();
};

/// The grid of the vertices that are kept.
class KeptGrid {
 public:
  explicit KeptGrid(double tolerance) : tolerance_(tolerance), width_(4 * tolerance) {}

  /// Calls visit(vertex) for all vertices that may be within the tolerance of a place.
  template <class Visit>
  void for_each_near(const Vector3& p, const Visit& visit) const {
    // The keys along each axis, without repetitions.
    std::array<std::array<std::uint64_t, 3>, 3> keys{};
    std::array<std::size_t, 3> count{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double x : {p[i] - tolerance_, p[i], p[i] + tolerance_}) {
        const std::uint64_t k = key(x);
        if (count[i] == 0 || keys[i][count[i] - 1] != k) keys[i][count[i]++] = k;
      }
    }
    for (std::size_t i = 0; i < count[0]; ++i) {
      for (std::size_t j = 0; j < count[1]; ++j) {
        for (std::size_t k = 0; k < count[2]; ++k) {
          visit_cell({keys[0][i], keys[1][j], keys[2][k]}, visit);
        }
      }
    }
  }

  void add(std::uint32_t vertex, const Vector3& p) {
    const Cell cell{key(p[0]), key(p[1]), key(p[2])};
    const auto next = static_cast<std::uint32_t>(cells_.size());
    const std::uint32_t c = index_.find_or_add(
        hash_of(cell), next, [&](std::uint32_t known) { return cells_[known] == cell; });
    if (c == next) {
      cells_.push_back(cell);
      first_.push_back(kNone);
    }
    entries_.push_back({vertex, first_[c]});
    first_[c] = static_cast<std::uint32_t>(entries_.size() - 1);
  }

 private:
  struct Entry {
    std::uint32_t vertex;
    std::uint32_t next;  ///< The next entry of the cell, or kNone.
  };

  static std::uint32_t hash_of(const Cell& cell) {
    return static_cast<std::uint32_t>(SeededHash{}(cell));
  }

  /// Returns the cell along an axis. It is monotone in x. Beyond 2^52 cells, where the spacing of
  /// doubles is at least half the tolerance, each double has its own cell.
  std::uint64_t key(double x) const {
    const double cell = x / width_;
    const double value = std::fabs(cell) < 0x1p52 ? std::floor(cell) : x;
    return std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value);
  }

  template <class Visit>
  void visit_cell(const Cell& cell, const Visit& visit) const {
    const std::uint32_t c =
        index_.find(hash_of(cell), [&](std::uint32_t known) { return cells_[known] == cell; });
    if (c == kNone) return;
    for (std::uint32_t e = first_[c]; e != kNone; e = entries_[e].next) visit(entries_[e].vertex);
  }

  double tolerance_;
  double width_;
  IdIndex index_;                     // Finds a cell in cells_.
  std::vector<Cell> cells_;           // The cells that have a vertex.
  std::vector<std::uint32_t> first_;  // The last entry that was added to each cell.
  std::vector<Entry> entries_;
};

/// For each vertex, returns the vertex into which it is merged.
std::vector<std::uint32_t> welded(const Nearness& near, std::size_t count, double tolerance,
                                  PointWeld& report, Context& context) {
  std::vector<std::uint32_t> becomes(count);
  KeptGrid grid(tolerance);
  for (std::uint32_t v = 0; v < count; ++v) {
    if (v % kPointsPerCheckpoint == 0) context.checkpoint("weld", v, count);
    const Vector3 p = near.at(v);
    std::uint32_t best = kNone;
    double least = std::numeric_limits<double>::infinity();
    grid.for_each_near(p, [&](std::uint32_t w) {
      const double square = near.square(v, w);
      const bool is_better = square < least || (square == least && w < best);
      if (!is_better || !near.are_near(v, w, square)) return;
      best = w;
      least = square;
    });
    becomes[v] = best == kNone ? v : best;
    if (best == kNone) {
      grid.add(v, p);
    } else {
      ++report.moved;
      report.farthest = std::max(report.farthest, near.distance(v, best, least));
    }
  }
  return becomes;
}

}  // namespace

PointWeld weld_points(PolygonMesh& mesh, double tolerance, Context& context) {
  if (!std::isfinite(tolerance) || tolerance < 0) {
    throw Error(ErrorCode::BadArgument, "the tolerance must be a finite number, 0 or more");
  }
  constexpr std::uint64_t kBytesPerPoint = 160;
  MemoryCharge charge(context);
  charge.add(kBytesPerPoint * mesh.points.size(), "the points of the mesh");
  SpaceTables tables;
  const MeshView view(mesh);
  const MeshVertices vertices = merge_equal_points(view, tables);
  PointWeld report;
  report.equal = vertices.merged;
  std::vector<std::uint32_t> becomes;
  if (tolerance > 0) {
    const Nearness near(view, vertices, tables.points, tolerance);
    becomes = welded(near, vertices.input.size(), tolerance, report, context);
  }
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const std::uint32_t v = vertices.of_point[i];
    const bool is_used = v != kNone;
    report.kept.push_back(is_used ? vertices.input[becomes.empty() ? v : becomes[v]] : i);
  }
  for (std::uint32_t& corner : mesh.corners) corner = report.kept[corner];
  return report;
}

}  // namespace plumb
