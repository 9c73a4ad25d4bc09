// Collecting, welding and writing of meshes, common to all formats.
//
// MeshCollector charges memory in steps, ahead of the lists that grow, so an exhausted limit is met
// before memory is allocated. Welding compares points by their bits (with -0 as 0), which is exact
// and does not depend on the floating-point environment; meshes with exact coordinates are welded
// through the tables of space, which compare rationals. The order of vertices afterwards is that of
// their first use, so it does not depend on hashing.
// Tested by tests/io/mesh_io_test.cpp and tests/io/stl_test.cpp.
#include "plumb/io/mesh/mesh_formats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/mesh/mesh_vertices.h"

namespace plumb {
namespace {

constexpr std::uint64_t kStep = 4096;  // This is the number of records between two charges.
constexpr std::uint64_t kMost = 0xffff'fffe - kStep;
constexpr std::uint64_t kGrowth = 2;  // Vectors grow by doubling.

void require_below_most(std::uint64_t count, const char* what) {
  if (count > kMost) {
    throw Error(ErrorCode::ResourceLimit, std::string("more than 2^32 ") + what);
  }
}

/// Returns the memory of three rationals: their entry, and six integers of at least one heap block
/// each.
std::uint64_t exact_bytes(const RationalPoint3& p) {
  constexpr std::uint64_t kBlock = 32;
  std::uint64_t bytes = kGrowth * sizeof(std::pair<std::uint32_t, RationalPoint3>);
  for (const Rational* q : {&p.x, &p.y, &p.z}) {
    const auto limbs = mpz_size(mpq_numref(q->mpq())) + mpz_size(mpq_denref(q->mpq()));
    bytes += 2 * kBlock + limbs * sizeof(mp_limb_t);
  }
  return bytes;
}

/// Whether three corners of a face are different.
bool has_three_corners(std::span<const std::uint32_t> face) {
  const auto second = std::ranges::find_if(face, [&](std::uint32_t v) { return v != face[0]; });
  return std::any_of(second, face.end(),
                     [&](std::uint32_t v) { return v != face[0] && v != *second; });
}

/// Adds a sentence that lists `items` after `begin`, unless the list is empty.
void add_sentence(std::string_view begin, const std::vector<std::string_view>& items,
                  std::vector<std::string>& sentences) {
  if (items.empty()) return;
  std::string sentence(begin);
  for (const std::string_view& item : items) {
    sentence.append(&item == items.data() ? "" : ", ").append(item);
  }
  sentences.push_back(std::move(sentence));
}

}  // namespace

void MeshCollector::expect(std::uint32_t points, std::uint32_t faces) {
  charge(points * sizeof(Point3) + faces * sizeof(std::uint32_t));
  charged_points_ = points;
  charged_faces_ = faces;
  mesh_.points.reserve(points);
  mesh_.face_begin.reserve(std::size_t{faces} + 1);
}

void MeshCollector::charge_points() {
  require_below_most(charged_points_, "vertices");
  charge(kStep * kGrowth * sizeof(Point3));
  charged_points_ += kStep;
}

void MeshCollector::charge_corners() {
  require_below_most(charged_corners_, "corners");
  charge(kStep * kGrowth * sizeof(std::uint32_t));
  charged_corners_ += kStep;
}

/// Adds a point. Its exact coordinates are stored in addition to the nearest doubles, unless these
/// are exact.
void MeshCollector::add_exact_point(const RationalPoint3& p) {
  const RoundedDouble x = round_to_double(p.x);
  const RoundedDouble y = round_to_double(p.y);
  const RoundedDouble z = round_to_double(p.z);
  if (x.error != Sign::Zero || y.error != Sign::Zero || z.error != Sign::Zero) {
    charge(exact_bytes(p));
    mesh_.exact.emplace_back(point_count(), p);
  }
  add_point({clamped_to_finite(x.value), clamped_to_finite(y.value), clamped_to_finite(z.value)});
}

void MeshCollector::add_missing_point() {
  charge(kGrowth * sizeof(std::uint32_t));
  missing_.push_back(point_count());
  add_point(Point3{});
}

std::optional<std::uint32_t> MeshCollector::needed_missing_point() const {
  if (missing_.empty()) return {};
  for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
    const auto face = mesh_.face(f);
    const auto found = std::ranges::find_if(
        face, [&](std::uint32_t v) { return std::ranges::binary_search(missing_, v); });
    if (found != face.end() && has_three_corners(face)) return *found;
  }
  return {};
}

MeshFile MeshCollector::take() {
  MeshFile file{std::move(mesh_), {}, {}, 0, {}};
  add_sentence("passed over: ", passed_, file.notes);
  if (!missing_.empty()) {
    file.notes.push_back("vertices that are not finite, used by no face with area: " +
                         std::to_string(missing_.size()));
  }
  add_sentence("geometry that was not read: ", left_out_, file.warnings);
  return file;
}

void MeshCollector::clear() {
  context_.release_memory(charged_bytes_);
  mesh_ = {};
  passed_.clear();
  left_out_.clear();
  missing_.clear();
  charged_bytes_ = charged_points_ = charged_corners_ = charged_faces_ = 0;
}

void MeshCollector::end_face() {
  if (mesh_.face_count() == charged_faces_) {
    charge(kStep * kGrowth * sizeof(std::uint32_t));
    charged_faces_ += kStep;
  }
  mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
}

namespace {

constexpr std::uint32_t kPointsPerCheckpoint = 4096;

/// Returns the bits of a point, where -0 becomes 0. Subnormal numbers do not become zero, even
/// under FTZ and DAZ.
std::array<std::uint64_t, 3> bits_of(const Point3& p) {
  const auto bits = [](double value) {
    const auto all = std::bit_cast<std::uint64_t>(value);
    return all << 1U == 0 ? 0 : all;
  };
  return {bits(p.x), bits(p.y), bits(p.z)};
}

/// Returns for each point the first point with its coordinates.
std::vector<std::uint32_t> first_equals(const PolygonMesh& mesh, Context& context) {
  std::vector<std::uint32_t> first;
  first.reserve(mesh.points.size());
  IdIndex known;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (i % kPointsPerCheckpoint == 0) context.checkpoint("weld", i, mesh.points.size());
    const auto bits = bits_of(mesh.points[i]);
    first.push_back(
        known.find_or_add(static_cast<std::uint32_t>(SeededHash{}(bits)), i,
                          [&](std::uint32_t j) { return bits_of(mesh.points[j]) == bits; }));
  }
  return first;
}

/// Computes the same result if some coordinates are not doubles. It is kNone for points that belong
/// to no face.
std::vector<std::uint32_t> first_exact_equals(const PolygonMesh& mesh) {
  SpaceTables tables;
  MeshVertices vertices = merge_equal_points(mesh, tables);
  for (std::uint32_t& v : vertices.of_point) {
    if (v != kNone) v = vertices.input[v];
  }
  return std::move(vertices.of_point);
}

/// Keeps and lists the faces that remain valid when corner v becomes first[v]. Returns the number
/// of the other faces.
std::size_t renumber_faces(PolygonMesh& mesh, const std::vector<std::uint32_t>& first,
                           std::vector<std::uint32_t>* list) {
  PolygonMesh kept;
  kept.corners.reserve(mesh.corners.size());
  kept.face_begin.reserve(mesh.face_begin.size());
  std::vector<std::uint32_t> face;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    face.clear();
    for (const std::uint32_t v : mesh.face(f)) face.push_back(first[v]);
    const bool is_sound =
        face.front() != face.back() && std::adjacent_find(face.begin(), face.end()) == face.end();
    if (!is_sound) continue;
    kept.add_face(face);
    if (list != nullptr) list->push_back(static_cast<std::uint32_t>(f));
  }
  const std::size_t dropped = mesh.face_count() - kept.face_count();
  mesh.face_begin = std::move(kept.face_begin);
  mesh.corners = std::move(kept.corners);
  return dropped;
}

std::size_t used_points(const PolygonMesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.points.size());
  for (const std::uint32_t corner : mesh.corners) is_used[corner] = 1;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 1));
}

/// Keeps points with corners, in the order of their first use.
void renumber_points(PolygonMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.points.size(), kNone);
  PolygonMesh used;
  used.points.reserve(used_points(mesh));
  for (std::uint32_t& corner : mesh.corners) {
    const std::uint32_t point = corner;
    std::uint32_t& now = number[point];
    if (now == kNone) {
      now = static_cast<std::uint32_t>(used.points.size());
      used.points.push_back(mesh.points[point]);
      const auto exact =
          std::lower_bound(mesh.exact.begin(), mesh.exact.end(), point,
                           [](const auto& entry, std::uint32_t p) { return entry.first < p; });
      const bool is_exact = exact != mesh.exact.end() && exact->first == point;
      if (is_exact) used.exact.emplace_back(now, exact->second);
    }
    corner = now;
  }
  mesh.points = std::move(used.points);
  mesh.exact = std::move(used.exact);
}

}  // namespace

std::size_t weld_vertices(PolygonMesh& mesh, Context& context, std::vector<std::uint32_t>* kept) {
  // The memory of a number, its place in a set that doubles, and a copy.
  constexpr std::uint64_t kPointBytes = 64;
  constexpr std::uint64_t kExactBytes = 320;  // The memory of three planes and numbers.
  constexpr std::uint64_t kCornerBytes = 4;   // The memory of a copy of the faces.
  constexpr std::uint64_t kTableBytes = 192;  // The memory of a point of a table with an index.
  const bool is_exact = !mesh.exact.empty();
  MemoryCharge charge(context);
  charge.add((kPointBytes + (is_exact ? kTableBytes : 0)) * mesh.points.size() +
                 kExactBytes * mesh.exact.size() +
                 kCornerBytes * (mesh.corners.size() + mesh.face_count()),
             "the vertices of the mesh");
  const std::size_t dropped =
      renumber_faces(mesh, is_exact ? first_exact_equals(mesh) : first_equals(mesh, context), kept);
  renumber_points(mesh);
  return dropped;
}

void write_coordinates(TextOutput& out, const Point3& p) { out << p.x << ' ' << p.y << ' ' << p.z; }

void write_face_line(TextOutput& out, std::span<const std::uint32_t> face) {
  out << std::uint64_t{face.size()};
  for (const std::uint32_t v : face) out << ' ' << v;
  out << '\n';
}

void write_face_lines(TextOutput& out, const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) write_face_line(out, mesh.face(f));
}

void require_doubles(const PolygonMesh& mesh) {
  for (const auto& [vertex, p] : mesh.exact) {
    for (const Rational* q : {&p.x, &p.y, &p.z}) {
      if (std::isfinite(nearest_double(*q))) continue;
      throw Error(ErrorCode::NumberOutOfRange, "a coordinate of vertex " + std::to_string(vertex) +
                                                   " is larger than the largest double");
    }
  }
}

void require_triangles(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() == 3) continue;
    throw Error(ErrorCode::BadArgument, "face " + std::to_string(f) + " is no triangle");
  }
}

}  // namespace plumb
