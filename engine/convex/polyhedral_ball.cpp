#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/convex/minkowski.h"

namespace plumb {
namespace {

constexpr unsigned kMaxRounds = 7;
constexpr double kLeastRadius = 0x1p-900;  // coordinates keep all their bits

/// An octahedron of radius 1 whose triangles are divided in four, again and again.
class BallMesh {
 public:
  BallMesh() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        std::array<double, 3> p{};
        p[axis] = sign;
        mesh_.points.push_back({p[0], p[1], p[2]});
      }
    }
    // Vertices 2 axis + (0: positive, 1: negative).
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const std::uint32_t x = octant & 1U, y = octant >> 1U & 1U, z = octant >> 2U & 1U;
      const bool is_mirrored = (x + y + z) % 2 == 1;
      triangle_.push_back(is_mirrored ? Triangle{x, 4 + z, 2 + y} : Triangle{x, 2 + y, 4 + z});
    }
  }

  void divide() {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangle_) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangle_ = std::move(finer);
  }

  PolygonMesh mesh(double radius) && {
    for (Point3& p : mesh_.points) p = {p.x * radius, p.y * radius, p.z * radius};
    for (const Triangle& t : triangle_) mesh_.add_face(t);
    return std::move(mesh_);
  }

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(mesh_.points.size());
    const auto [at, is_new] = middle_.try_emplace(std::minmax(a, b), next);
    if (is_new) {
      const Point3 p = mesh_.points[a], q = mesh_.points[b];
      const std::array<double, 3> m{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
      const double scale = 1 / std::hypot(m[0], m[1], m[2]);
      mesh_.points.push_back({m[0] * scale, m[1] * scale, m[2] * scale});
    }
    return at->second;
  }

  PolygonMesh mesh_;
  std::vector<Triangle> triangle_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_;
};

}  // namespace

Nef3 polyhedral_ball(double radius, unsigned rounds, Context& context) try {
  if (!std::isfinite(radius) || !(radius > 0)) {
    throw Error(ErrorCode::BadArgument, "a ball needs a positive radius");
  }
  if (rounds > 0 && radius < kLeastRadius) {
    throw Error(ErrorCode::BadArgument, "a ball too small to round its vertices to doubles");
  }
  if (rounds > kMaxRounds) {
    throw Error(ErrorCode::ResourceLimit, "a ball of more than 7 rounds of subdivision");
  }
  BallMesh ball;
  for (unsigned i = 0; i < rounds; ++i) ball.divide();
  return Nef3::mesh(std::move(ball).mesh(radius), WindingRule::Positive, context);
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
