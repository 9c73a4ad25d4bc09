// Numbering of distinct values of corners, and splitting of vertices.
//
// Values are compared by their bits, so no tolerance decides where a vertex is split, and equal
// corners of a written file are equal corners of the file that is read. Tables are searched by
// hashes that an input cannot foresee (seeded_hash.h), so the expected cost is linear also for a
// vertex with many corners.
// Tested by tests/io/mesh_attributes_test.cpp.
#include "plumb/io/mesh/attribute_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr double kLargestByte = 255;
constexpr std::uint32_t kNoCorner = MeshAttributes::kNone;

[[noreturn]] void fail_attributes(const std::string& what) {
  throw Error(ErrorCode::BadArgument, "attributes of a mesh: " + what);
}

void require_faces_below(const std::vector<std::uint32_t>& of_faces, std::size_t faces,
                         std::size_t entries, const char* what) {
  if (of_faces.empty()) return;
  if (of_faces.size() != faces) fail_attributes(std::string(what) + " are not one per face");
  const bool are_known = std::all_of(of_faces.begin(), of_faces.end(), [&](std::uint32_t entry) {
    return entry == MeshAttributes::kNone || entry < entries;
  });
  if (!are_known) fail_attributes(std::string(what) + " of faces are not in the list");
}

std::uint32_t hash_of(std::uint64_t start, std::span<const double> values) {
  std::uint64_t state = start;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::array<std::uint64_t, 3> key{state, std::bit_cast<std::uint64_t>(values[i]), i};
    state = SeededHash{}(key);
  }
  const std::array<std::uint64_t, 3> last{state, start, values.size()};
  return static_cast<std::uint32_t>(SeededHash{}(last));
}

bool have_equal_bits(std::span<const double> a, std::span<const double> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

/// Numbers corners such that two corners get the same number if and only if `is_same` holds.
template <class Hash, class IsSame>
DistinctCorners number_corners(std::size_t corners, Hash hash, IsSame is_same) {
  DistinctCorners numbers;
  numbers.of_corner.reserve(corners);
  IdIndex known;
  for (std::uint32_t c = 0; c < corners; ++c) {
    const auto next = static_cast<std::uint32_t>(numbers.corner.size());
    const std::uint32_t number = known.find_or_add(
        hash(c), next, [&](std::uint32_t n) { return is_same(numbers.corner[n], c); });
    if (number == next) numbers.corner.push_back(c);
    numbers.of_corner.push_back(number);
  }
  return numbers;
}

}  // namespace

void require_complete(const MeshAttributes& attributes, const PolygonMesh& mesh) {
  const std::size_t faces = mesh.face_count();
  require_faces_below(attributes.face_material, faces, attributes.materials.size(), "materials");
  require_faces_below(attributes.face_group, faces, attributes.groups.size(), "groups");
  require_faces_below(attributes.face_id, faces, MeshAttributes::kNone, "ids");
  for (const MeshChannel& channel : attributes.channels) {
    if (channel.width > 0 && channel.values.size() == channel.width * mesh.corners.size()) continue;
    fail_attributes("channel '" + channel.name + "' has not " + std::to_string(channel.width) +
                    " numbers per corner");
  }
}

void keep_used_materials(MeshAttributes& attributes) {
  const auto is_less = [](const MeshMaterial& a, const MeshMaterial& b) {
    return std::tie(a.name, a.color, a.texture) < std::tie(b.name, b.color, b.texture);
  };
  std::vector<bool> is_used(attributes.materials.size());
  for (const std::uint32_t material : attributes.face_material) {
    if (material != MeshAttributes::kNone) is_used[material] = true;
  }
  std::map<MeshMaterial, std::uint32_t, decltype(is_less)> known(is_less);
  std::vector<std::uint32_t> number(attributes.materials.size(), MeshAttributes::kNone);
  std::vector<MeshMaterial> kept;
  for (std::size_t m = 0; m < attributes.materials.size(); ++m) {
    if (!is_used[m]) continue;
    MeshMaterial& material = attributes.materials[m];
    const auto [at, is_new] = known.emplace(material, static_cast<std::uint32_t>(kept.size()));
    if (is_new) kept.push_back(std::move(material));
    number[m] = at->second;
  }
  attributes.materials = std::move(kept);
  for (std::uint32_t& material : attributes.face_material) {
    if (material != MeshAttributes::kNone) material = number[material];
  }
}

const MeshChannel* channel_of(const MeshAttributes& attributes, std::string_view name,
                              std::uint32_t least, std::uint32_t most) {
  for (const MeshChannel& channel : attributes.channels) {
    if (channel.name == name && least <= channel.width && channel.width <= most) return &channel;
  }
  return nullptr;
}

DistinctCorners distinct_values(const MeshChannel& channel, std::size_t corners) {
  return number_corners(
      corners, [&](std::uint32_t c) { return hash_of(0, values_at(channel, c)); },
      [&](std::uint32_t a, std::uint32_t b) {
        return have_equal_bits(values_at(channel, a), values_at(channel, b));
      });
}

SplitMesh split_vertices(const PolygonMesh& mesh, const std::vector<const MeshChannel*>& channels) {
  const auto hash = [&](std::uint32_t c) {
    std::uint32_t all = mesh.corners[c];
    for (const MeshChannel* channel : channels) all = hash_of(all, values_at(*channel, c));
    return all;
  };
  const auto is_same = [&](std::uint32_t a, std::uint32_t b) {
    const auto agrees = [&](const MeshChannel* channel) {
      return have_equal_bits(values_at(*channel, a), values_at(*channel, b));
    };
    return mesh.corners[a] == mesh.corners[b] &&
           std::all_of(channels.begin(), channels.end(), agrees);
  };
  const DistinctCorners numbers = number_corners(mesh.corners.size(), hash, is_same);
  if (mesh.points.size() + numbers.corner.size() >= kNoCorner) {
    throw Error(ErrorCode::ResourceLimit, "more than 2^32 vertices");
  }
  SplitMesh split{mesh, std::vector<std::uint32_t>(mesh.points.size(), kNoCorner)};
  std::vector<std::uint32_t> vertex_of;
  vertex_of.reserve(numbers.corner.size());
  for (const std::uint32_t corner : numbers.corner) {
    const std::uint32_t v = mesh.corners[corner];
    if (split.corner_of_vertex[v] == kNoCorner) {
      split.corner_of_vertex[v] = corner;
      vertex_of.push_back(v);
      continue;
    }
    const auto copy = static_cast<std::uint32_t>(split.mesh.points.size());
    split.mesh.points.push_back(mesh.points[v]);
    const auto exact = std::lower_bound(
        mesh.exact.begin(), mesh.exact.end(), v,
        [](const auto& entry, std::uint32_t point) { return entry.first < point; });
    if (exact != mesh.exact.end() && exact->first == v) {
      split.mesh.exact.emplace_back(copy, exact->second);
    }
    split.corner_of_vertex.push_back(corner);
    vertex_of.push_back(copy);
  }
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    split.mesh.corners[c] = vertex_of[numbers.of_corner[c]];
  }
  return split;
}

std::uint32_t byte_of(double part) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(part, 0.0, 1.0) * kLargestByte));
}

bool are_bytes(std::span<const double> colors) {
  return std::all_of(colors.begin(), colors.end(),
                     [](double part) { return part == byte_of(part) / kLargestByte; });
}

std::vector<double> values_of_vertex(const MeshChannel& channel, std::uint32_t corner) {
  if (corner == kNoCorner) return std::vector<double>(channel.width);
  const auto values = values_at(channel, corner);
  return {values.begin(), values.end()};
}

void write_numbers(TextOutput& out, std::span<const double> numbers) {
  for (const double number : numbers) out << ' ' << number;
}

}  // namespace plumb
