// Merging equal points by a hash table, and sorting a mesh along a space-filling curve.
//
// Two points are equal if their coordinates are, as numbers; doubles are compared by their bits,
// with -0 replaced by 0, so that flushing of subnormals to zero has no influence. A rational point
// whose coordinates are doubles goes to the table of doubles; all others go to a sorted map. So
// every place is found in exactly one of the two tables, and a vertex has the number of the least
// point there.
//
// Points of a mesh that was sorted by cells need no hash table: equal points are in one cell, and a
// cell contains few points. If a cell of a mesh is crowded, the mesh is merged like any other mesh.
//
// Hashes are computed 256 points ahead and the entries of the table prefetched: the table is larger
// than the caches, and nearly the whole cost of merging is the cost of looking up.
//
// Tested by tests/space/mesh_vertices_test.cpp and tests/space/from_mesh_test.cpp.

#include "plumb/space/mesh/mesh_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>

#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/bounds/packed_boxes.h"

namespace plumb {
namespace {

/// The number of points whose hashes are computed ahead.
constexpr std::size_t kBlock = 256;

/// Returns the value, where -0 becomes 0. The bits decide, so subnormal numbers do not change, even
/// under FTZ and DAZ.
double without_negative_zero(double value) {
  return std::bit_cast<std::uint64_t>(value) << 1U == 0 ? 0.0 : value;
}

/// Returns the point without negative zeros.
Point3 without_negative_zeros(const Point3& p) {
  return {without_negative_zero(p.x), without_negative_zero(p.y), without_negative_zero(p.z)};
}

using Bits = std::array<std::uint64_t, 3>;

Bits bits_of(const Point3& p) { return std::bit_cast<Bits>(p); }

std::uint32_t hash_of(const Point3& p) {
  return static_cast<std::uint32_t>(SeededHash{}(bits_of(p)));
}

/// The lexicographic order of rational points.
struct RationalLess {
  bool operator()(const RationalPoint3& a, const RationalPoint3& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

/// Adds points one after the other. Each place is stored once.
class VertexMaker {
 public:
  VertexMaker(const MeshView& mesh, SpaceTables& tables) : mesh_(mesh), tables_(tables) {}

  MeshVertices make() {
    mark_used();
    doubles_.reserve(std::min(mesh_.point_count(), mesh_.corners.size()));
    // A vertex of a closed mesh of triangles has six corners on average.
    const std::size_t expected = std::min(mesh_.point_count(), mesh_.corners.size() / 6 + 16);
    inputs_.reserve(expected);
    vertex_of_input_.reserve(expected);
    result_.point.reserve(expected);
    result_.input.reserve(expected);
    const auto* exact = mesh_.exact.data();
    const auto* const exact_end = exact + mesh_.exact.size();
    for (std::uint32_t i = 0; i < mesh_.point_count(); ++i) {
      if (i % kBlock == 0) look_ahead(i);
      while (exact != exact_end && exact->first < i) ++exact;
      if (result_.of_point[i] == kNone) continue;
      const bool is_exact = exact != exact_end && exact->first == i;
      result_.of_point[i] = is_exact ? find_or_add(i, exact->second) : find_or_add(i);
    }
    add_points();
    return std::move(result_);
  }

 private:
  /// Replaces the number kNone of used points by 0, and checks all corners.
  void mark_used() {
    result_.of_point.assign(mesh_.point_count(), kNone);
    for (const std::uint32_t c : mesh_.corners) {
      if (c >= mesh_.point_count()) {
        throw Error(ErrorCode::BadIndex, "a face names vertex " + std::to_string(c) + " of " +
                                             std::to_string(mesh_.point_count()));
      }
      result_.of_point[c] = 0;
    }
  }

  /// Returns the vertex `known`. If it is not new, counts the point as merged.
  std::uint32_t take(std::uint32_t known, std::uint32_t next) {
    if (known != next) ++result_.merged;
    return known;
  }

  /// Returns point i without negative zeros.
  Point3 place(std::uint32_t i) const { return without_negative_zeros(mesh_.point(i)); }

  /// Computes the hashes of the next block and prefetches their entries in the index.
  void look_ahead(std::uint32_t first) {
    const std::size_t count = std::min(kBlock, mesh_.point_count() - first);
    for (std::uint32_t k = 0; k < count; ++k) {
      hashes_[k] = hash_of(place(first + k));
      doubles_.prefetch(hashes_[k]);
    }
  }

  std::uint32_t find_or_add(std::uint32_t i) {
    const Point3 p = place(i);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw Error(ErrorCode::NotFinite, "vertex " + std::to_string(i) + " is not finite");
    }
    return find_or_add(i, p, hashes_[i % kBlock]);
  }

  std::uint32_t find_or_add(std::uint32_t i, const Point3& p, std::uint32_t hash) {
    const std::uint32_t next = count();
    const auto next_input = static_cast<std::uint32_t>(inputs_.size());
    const std::uint32_t input = doubles_.find_or_add(
        hash, next_input, [&](std::uint32_t k) { return bits_of(inputs_[k]) == bits_of(p); });
    if (input == next_input) {
      result_.input.push_back(i);
      inputs_.push_back(p);
      vertex_of_input_.push_back(next);
      result_.point.emplace_back();
    }
    return take(vertex_of_input_[input], next);
  }

  /// Finds or adds a rational point. If doubles can represent it, it is searched among the doubles,
  /// so that equal points have one place.
  std::uint32_t find_or_add(std::uint32_t i, const RationalPoint3& p) {
    const Point3 near{nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
    if (is_exactly(near.x, p.x) && is_exactly(near.y, p.y) && is_exactly(near.z, p.z)) {
      return find_or_add(i, near, hash_of(near));
    }
    const std::uint32_t next = count();
    const auto [at, is_new] = rationals_.try_emplace(p, next);
    if (is_new) {
      result_.input.push_back(i);
      result_.point.push_back(add_point(tables_, p));
    }
    return take(at->second, next);
  }

  /// Whether a double equals a rational number.
  static bool is_exactly(double near, const Rational& x) {
    return std::isfinite(near) && exact_rational(near) == x;
  }

  /// Adds the points that are doubles to the table, all at once, in the order of the vertices.
  void add_points() {
    std::uint32_t id = tables_.planes.add_points(inputs_).value();
    for (SpacePoint& p : result_.point) {
      if (!p.is_valid()) p = SpacePoint(InputPointId(id++));
    }
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(result_.input.size()); }

  const MeshView& mesh_;
  SpaceTables& tables_;
  MeshVertices result_;
  std::vector<Point3> inputs_;                  // The vertices whose coordinates are doubles.
  std::vector<std::uint32_t> vertex_of_input_;  // The vertex of each of inputs_.
  IdIndex doubles_;                             // Finds a point in inputs_.
  std::array<std::uint32_t, kBlock> hashes_{};  // The hashes of the points of this block.
  std::map<RationalPoint3, std::uint32_t, RationalLess> rationals_;
};

}  // namespace

MeshVertices merge_equal_points(const MeshView& mesh, SpaceTables& tables) {
  return VertexMaker(mesh, tables).make();
}

std::vector<std::uint32_t> drop_unused_points(PolygonMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.points.size(), kNone);
  for (const std::uint32_t v : mesh.corners) number[v] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    mesh.points[count] = mesh.points[v];
    number[v] = count++;
  }
  mesh.points.resize(count);
  std::erase_if(mesh.exact, [&](const auto& entry) { return number[entry.first] == kNone; });
  for (auto& [v, p] : mesh.exact) v = number[v];
  for (std::uint32_t& v : mesh.corners) v = number[v];
  return number;
}

namespace {

/// Whether all faces have three corners.
bool has_only_triangles(const MeshView& mesh) {
  for (std::size_t f = 1; f < mesh.face_begin.size(); ++f) {
    if (mesh.face_begin[f] != 3 * f) return false;
  }
  return true;
}

/// Whether all corners refer to points, and all coordinates are finite.
bool is_sound(const MeshView& mesh) {
  const std::size_t points = mesh.point_count();
  return std::ranges::all_of(mesh.corners, [=](std::uint32_t c) { return c < points; }) &&
         std::ranges::all_of(mesh.coordinates, [](double x) { return std::isfinite(x); });
}

/// Returns the Morton code of each point's cell; empty if the extent of the points overflows.
std::vector<std::uint32_t> places_of(const MeshView& mesh) {
  constexpr std::uint32_t kLast = 1023;
  const auto at = [&](std::size_t i) {
    const Point3 p = mesh.point(i);
    return std::array{p.x, p.y, p.z};
  };
  Box3 around;
  for (std::size_t i = 0; i < mesh.point_count(); ++i) around.add({at(i), at(i)});
  const CellGrid grid(around, kLast);
  std::vector<std::uint32_t> places;
  if (!grid.is_finite()) return places;
  places.reserve(mesh.point_count());
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    places.push_back(morton_code(grid.cell(at(i))));
  }
  return places;
}

/// Returns 0, ..., n - 1 sorted by code_of(i). Equal codes keep their order.
template <class CodeOf>
std::vector<MortonCoded> sorted(std::size_t n, CodeOf&& code_of) {
  std::vector<MortonCoded> items;
  items.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) items.push_back({code_of(i), i});
  sort_by_code(items);
  return items;
}

}  // namespace

namespace {

// For more points, comparing them takes more time than hashing them.
constexpr std::size_t kCrowd = 16;

/// Whether no cell has more than kCrowd points.
bool has_no_crowd(std::span<const std::uint32_t> cell) {
  for (std::size_t i = kCrowd; i < cell.size(); ++i) {
    if (cell[i] == cell[i - kCrowd]) return false;
  }
  return true;
}

}  // namespace

// The points of an ordered mesh are finite, and its corners refer to points.
MeshVertices merge_equal_points(const OrderedMesh& ordered, SpaceTables& tables) {
  const MeshView mesh = ordered.view();
  if (!has_no_crowd(ordered.cell)) return merge_equal_points(mesh, tables);
  MeshVertices result;
  result.of_point.assign(mesh.point_count(), kNone);
  for (const std::uint32_t c : mesh.corners) result.of_point[c] = 0;
  std::vector<Point3> places;  // The point of each vertex.
  places.reserve(mesh.point_count());
  result.input.reserve(mesh.point_count());
  std::uint32_t cell = kNone;
  std::size_t first = 0;  // The first vertex in the cell of the current point.
  for (std::uint32_t i = 0; i < mesh.point_count(); ++i) {
    if (ordered.cell[i] != cell) first = places.size();
    cell = ordered.cell[i];
    if (result.of_point[i] == kNone) continue;
    const Point3 p = without_negative_zeros(mesh.point(i));
    std::size_t v = first;
    while (v < places.size() && bits_of(places[v]) != bits_of(p)) ++v;
    result.of_point[i] = static_cast<std::uint32_t>(v);
    if (v < places.size()) {
      ++result.merged;
    } else {
      result.input.push_back(i);
      places.push_back(p);
    }
  }
  const std::uint32_t id = tables.planes.add_points(places).value();
  result.point.resize(places.size());
  for (std::uint32_t v = 0; v < places.size(); ++v)
    result.point[v] = SpacePoint(InputPointId(id + v));
  return result;
}

OrderedMesh ordered_in_space(const MeshView& mesh) {
  OrderedMesh ordered;
  if (mesh.face_count() == 0 || !mesh.exact.empty()) return ordered;
  if (!has_only_triangles(mesh) || !is_sound(mesh)) return ordered;
  const std::vector<std::uint32_t> place = places_of(mesh);
  if (place.empty()) return ordered;

  std::vector<std::uint32_t> number(place.size());  // The new number of each point.
  ordered.coordinates.resize(3 * place.size());
  ordered.cell.resize(place.size());
  std::uint32_t next = 0;
  for (const MortonCoded& p : sorted(place.size(), [&](std::uint32_t i) { return place[i]; })) {
    std::copy_n(mesh.coordinates.data() + 3 * std::size_t{p.item}, 3,
                ordered.coordinates.data() + 3 * std::size_t{next});
    ordered.cell[next] = p.code;
    number[p.item] = next++;
  }
  const auto corners_of = [&](std::uint32_t f) {
    return mesh.corners.subspan(3 * std::size_t{f}, 3);
  };
  const auto place_of_face = [&](std::uint32_t f) {
    const auto c = corners_of(f);
    return std::min({place[c[0]], place[c[1]], place[c[2]]});
  };
  ordered.corners.resize(mesh.corners.size());
  ordered.face.resize(mesh.face_count());
  std::uint32_t face = 0;
  for (const MortonCoded& f : sorted(mesh.face_count(), place_of_face)) {
    const auto c = corners_of(f.item);
    for (std::size_t i = 0; i < 3; ++i) ordered.corners[3 * std::size_t{face} + i] = number[c[i]];
    ordered.face[face++] = f.item;
  }
  return ordered;
}

}  // namespace plumb
