// Triangles of a face are made of vertices. A polygon that touches itself, as one with a hole and a
// bridge to it does, has several corners at one vertex, which may have different numbers. Around
// such a vertex, the triangles between the two edges of a corner belong to this corner. So each
// corner walks over the triangles from the edge that leaves it to the edge that ends at it. If a
// polygon is cut without one of these edges, as along a bridge, the corners there have the same
// vertex on both sides, and the first one stands for all.
//
// Tested by tests/space/mesh_with_attributes_test.cpp and tests/space/repair_mesh_test.cpp.
#include "plumb/space/mesh/face_corners.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "plumb/predicates/error.h"
#include "plumb/predicates/strong_id.h"

namespace plumb {

CornerFinder::CornerFinder(std::span<const std::uint32_t> vertices, std::uint32_t begin)
    : vertices_(vertices), begin_(begin) {
  for (std::uint32_t i = 0; i < vertices.size(); ++i) first_.emplace_back(vertices[i], i);
  std::sort(first_.begin(), first_.end());
  const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
  has_repeats_ = std::adjacent_find(first_.begin(), first_.end(), is_same) != first_.end();
}

void CornerFinder::add(std::uint32_t face, std::span<const VertexTriangle> triangles,
                       std::vector<FaceTriangle>& result) {
  const std::size_t first = result.size();
  for (const VertexTriangle& t : triangles) {
    result.push_back({face, {first_at(t[0]), first_at(t[1]), first_at(t[2])}});
  }
  if (has_repeats_) choose_corners(triangles, std::span(result).subspan(first));
}

std::uint32_t CornerFinder::first_at(std::uint32_t vertex) const {
  const auto at = std::partition_point(first_.begin(), first_.end(),
                                       [&](const auto& f) { return f.first < vertex; });
  return begin_ + at->second;
}

namespace {

/// A directed edge, and the corner of a triangle that it leaves.
struct Leaving {
  std::array<std::uint32_t, 2> edge;
  std::uint32_t corner;  // The number 3 t + i represents corner i of triangle t.
};

}  // namespace

/// Gives each corner the triangles between its edges.
void CornerFinder::choose_corners(std::span<const VertexTriangle> triangles,
                                  std::span<FaceTriangle> result) {
  std::vector<Leaving> leaving;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      leaving.push_back({{triangles[t][i], triangles[t][(i + 1) % 3]}, 3 * t + i});
    }
  }
  std::sort(leaving.begin(), leaving.end(),
            [](const Leaving& a, const Leaving& b) { return a.edge < b.edge; });
  std::vector<std::uint8_t> is_chosen(leaving.size(), 0);
  const std::size_t n = vertices_.size();
  for (std::uint32_t c = 0; c < n; ++c) {
    const std::uint32_t at = vertices_[c], last = vertices_[(c + n - 1) % n];
    std::uint32_t next = vertices_[(c + 1) % n];
    while (next != last) {
      const std::array edge{at, next};
      const auto found = std::partition_point(leaving.begin(), leaving.end(),
                                              [&](const Leaving& l) { return l.edge < edge; });
      if (found == leaving.end() || found->edge != edge) break;
      if (std::exchange(is_chosen[found->corner], std::uint8_t{1}) != 0) break;
      result[found->corner / 3].corner[found->corner % 3] = begin_ + c;
      next = triangles[found->corner / 3][(found->corner + 2) % 3];
    }
  }
}

namespace {

void require_size(std::size_t size, std::size_t needed, const char* what) {
  if (size != 0 && size != needed) {
    throw Error(ErrorCode::BadArgument,
                std::string("the attributes of a mesh need one entry for each ") + what);
  }
}

}  // namespace

void require_sizes(const MeshAttributes& attributes, std::size_t faces, std::size_t corners) {
  require_size(attributes.face_material.size(), faces, "face");
  require_size(attributes.face_group.size(), faces, "face");
  require_size(attributes.face_id.size(), faces, "face");
  for (const MeshChannel& channel : attributes.channels) {
    if (channel.width == 0) {
      throw Error(ErrorCode::BadArgument, "a channel needs at least one number for each corner");
    }
    require_size(channel.values.size(), corners * channel.width, "number of a corner");
  }
}

namespace {

/// Sets the corners of a face that follows another face, forwards or backwards, and leaves out some
/// of its corners. Returns false if the face does not do this. `to` has the corners of the face,
/// and `from` those of the other one, whose first corner has the index `begin`.
///
/// A point may occur at several corners. The first corner of `from` at the first point of `to` is a
/// right start whichever corner was the start, because only corners that were left out lie between.
bool find_along(std::span<const std::uint32_t> from, std::uint32_t begin,
                std::span<const std::uint32_t> to, bool is_reversed,
                std::span<std::uint32_t> corner) {
  const std::size_t n = from.size();
  const auto start =
      static_cast<std::size_t>(std::find(from.begin(), from.end(), to[0]) - from.begin());
  std::size_t found = 0;
  for (std::size_t k = 0; k < n && found < to.size(); ++k) {
    const std::size_t i = (is_reversed ? start + n - k : start + k) % n;
    if (from[i] == to[found]) corner[found++] = begin + static_cast<std::uint32_t>(i);
  }
  return found == to.size();
}

}  // namespace

FaceOrigins origins_of(const PolygonMesh& before, const PolygonMesh& after,
                       std::span<const std::uint32_t> face) {
  FaceOrigins origins{{face.begin(), face.end()}, {}, {}};
  origins.is_reversed.assign(face.size(), 0);
  origins.corner.assign(after.corners.size(), kNone);
  for (std::size_t f = 0; f < face.size(); ++f) {
    std::uint32_t& from = origins.face[f];
    if (from >= before.face_count()) {
      from = kNone;
      continue;
    }
    const auto old = before.face(from), now = after.face(f);
    const std::uint32_t begin = before.face_begin[from];
    const std::span corner = std::span(origins.corner).subspan(after.face_begin[f], now.size());
    if (find_along(old, begin, now, false, corner)) continue;
    origins.is_reversed[f] = 1;
    PLUMB_CHECK(find_along(old, begin, now, true, corner));
  }
  return origins;
}

namespace {

/// Negates the normals of faces that were reversed.
void negate(const PolygonMesh& mesh, const FaceOrigins& origins, MeshChannel& normals) {
  for (std::size_t f = 0; f < origins.face.size(); ++f) {
    if (origins.is_reversed[f] == 0) continue;
    for (std::size_t i = 3 * std::size_t{mesh.face_begin[f]};
         i < 3 * std::size_t{mesh.face_begin[f + 1]}; ++i) {
      normals.values[i] = 0 - normals.values[i];
    }
  }
}

}  // namespace

MeshAttributes carried(const MeshAttributes& attributes, const PolygonMesh& after,
                       const FaceOrigins& origins) {
  MeshAttributes result;
  result.materials = attributes.materials;
  result.groups = attributes.groups;
  const auto of_faces = [&](const std::vector<std::uint32_t>& before) {
    std::vector<std::uint32_t> after;
    if (before.empty()) return after;
    after.reserve(origins.face.size());
    for (const std::uint32_t f : origins.face) {
      after.push_back(f == kNone ? MeshAttributes::kNone : before[f]);
    }
    return after;
  };
  result.face_material = of_faces(attributes.face_material);
  result.face_group = of_faces(attributes.face_group);
  result.face_id = of_faces(attributes.face_id);
  for (const MeshChannel& channel : attributes.channels) {
    result.channels.push_back({channel.name, channel.width, {}});
    MeshChannel& made = result.channels.back();
    if (channel.values.empty()) continue;
    made.values.assign(origins.corner.size() * channel.width, channel.name == "color" ? 1 : 0);
    for (std::size_t c = 0; c < origins.corner.size(); ++c) {
      if (origins.corner[c] == kNone) continue;
      const std::size_t from = std::size_t{origins.corner[c]} * channel.width;
      std::copy_n(&channel.values[from], channel.width, &made.values[c * channel.width]);
    }
    if (channel.name == "normal" && channel.width == 3) negate(after, origins, made);
  }
  return result;
}

}  // namespace plumb
