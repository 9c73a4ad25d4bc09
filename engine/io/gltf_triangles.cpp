#include "plumb/io/gltf_triangles.h"

#include <array>
#include <bit>
#include <cmath>

#include "plumb/io/weld_vertices.h"

namespace plumb {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

constexpr std::size_t kItemsPerCheckpoint = 4096;
constexpr std::uint64_t kMostVertices = 0xffff'0000;

}  // namespace

void GltfTriangles::add(const GltfPrimitive& p, const GltfTransform& placed,
                        const std::string& where) {
  const std::uint64_t first = add_points(p.positions, placed, where);
  const auto corner = [&](std::size_t i) {
    const std::size_t index = p.indices ? p.indices->index(i) : i;
    if (index < p.positions.count) return static_cast<std::uint32_t>(first + index);
    fail(ErrorCode::BadIndex, where, "no vertex " + std::to_string(index));
  };
  // Where there are points, they are finite, and so is what moves them.
  const bool turns = p.positions.count > 0 && mirrors(placed);
  const std::size_t count = p.corner_count(), step = p.mode == GltfMode::kTriangles ? 3 : 1;
  for (std::size_t i = 0; i + 2 < count; i += step) {
    if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, count);
    const std::uint32_t a = corner(p.mode == GltfMode::kFan ? 0 : i);
    const std::uint32_t b = corner(i + 1), c = corner(i + 2);
    add_triangle(a, b, c, turns != (p.mode == GltfMode::kStrip && i % 2 == 1));
  }
}

void GltfTriangles::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turns) {
  for (const std::uint32_t v : {a, turns ? c : b, turns ? b : c}) mesh_.add_corner(v);
  if (!mesh_.end_face().empty()) ++dropped_;
}

/// Returns the number of the first.
std::uint64_t GltfTriangles::add_points(const GltfElements& positions, const GltfTransform& m,
                                        const std::string& where) {
  const std::uint64_t first = mesh_.point_count();
  if (positions.count > kMostVertices - first) {
    fail(ErrorCode::ResourceLimit, where, "more than 2^32 vertices");
  }
  const bool moves = m != kGltfIdentity;
  for (std::size_t i = 0; i < positions.count; ++i) {
    if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, positions.count);
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = positions.at<float>(i, k);
    const std::array<double, 3> q = moves ? applied(m, p) : p;
    if (!std::isfinite(q[0]) || !std::isfinite(q[1]) || !std::isfinite(q[2])) {
      fail(ErrorCode::NumberOutOfRange, where,
           "vertex " + std::to_string(i) + " has a coordinate that is not finite");
    }
    mesh_.add_point({q[0], q[1], q[2]});
  }
  return first;
}

MeshFile GltfTriangles::take() {
  MeshFile file = mesh_.take();
  dropped_ += weld_vertices(file.mesh, context_);
  if (dropped_ > 0) {
    file.notes.push_back(std::to_string(dropped_) + (dropped_ == 1 ? " triangle" : " triangles") +
                         " with two equal corners left out");
  }
  return file;
}

}  // namespace plumb
