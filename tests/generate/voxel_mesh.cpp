#include "generate/voxel_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "generate/meshes.h"

namespace plumb::testing {

bool VoxelGrid::holds(int x, int y, int z) const {
  if (x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2]) return false;
  return is_full[static_cast<std::size_t>(x + size[0] * (y + size[1] * z))] != 0;
}

PolygonMesh voxel_mesh(const VoxelGrid& grid) {
  std::map<std::array<int, 3>, std::uint32_t> number;
  std::vector<Point3> points;
  std::vector<Face> faces;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = number.emplace(at, static_cast<std::uint32_t>(points.size()));
    if (is_new) {
      points.push_back(
          {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])});
    }
    return place->second;
  };
  const auto add_side = [&](const std::array<int, 3>& cell, std::size_t axis, bool is_high) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Face face;
    for (const auto& [du, dv] :
         {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
      std::array<int, 3> at = cell;
      at[axis] += is_high ? 1 : 0;
      at[u] += is_high ? du : dv;
      at[v] += is_high ? dv : du;
      face.push_back(corner(at));
    }
    faces.push_back(face);
  };
  for (int z = 0; z < grid.size[2]; ++z) {
    for (int y = 0; y < grid.size[1]; ++y) {
      for (int x = 0; x < grid.size[0]; ++x) {
        for (std::size_t axis = 0; axis < 3 && grid.holds(x, y, z); ++axis) {
          for (const int step : {-1, 1}) {
            std::array<int, 3> next{x, y, z};
            next[axis] += step;
            if (!grid.holds(next[0], next[1], next[2])) add_side({x, y, z}, axis, step > 0);
          }
        }
      }
    }
  }
  return make_mesh(std::move(points), faces);
}

VoxelGrid random_voxels(Dice& dice, const std::array<int, 3>& size, int tenths) {
  VoxelGrid grid(size);
  bool has_one = false;
  for (std::uint8_t& cell : grid.is_full) {
    cell = dice.below(10) < static_cast<std::uint32_t>(tenths) ? 1 : 0;
    has_one |= cell != 0;
  }
  if (!has_one) grid.is_full[0] = 1;
  return grid;
}

VoxelGrid pierced_plate(int holes) {
  const int side = 2 * holes + 1;
  VoxelGrid grid({side, side, 1});
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) grid.at(x, y, 0) = x % 2 == 1 && y % 2 == 1 ? 0 : 1;
  }
  return grid;
}

VoxelGrid random_terrain(Dice& dice, int width, int depth, int height) {
  VoxelGrid grid({width, depth, height});
  for (int y = 0; y < depth; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto top = static_cast<int>(dice.between(1, height));
      for (int z = 0; z < top; ++z) grid.at(x, y, z) = 1;
    }
  }
  return grid;
}

PolygonMesh star_prism(int tips) {
  std::vector<Point2> polygon;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = 3.14159265358979 * i / tips, radius = i % 2 == 0 ? 4 : 2;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return prism_mesh(polygon, 0, 1);
}

PolygonMesh cone_mesh(int sides, double height) {
  std::vector<Point3> points{{0, 0, height}, {0, 0, 0}};
  std::vector<Face> faces;
  const auto rim = [sides](int i) { return static_cast<std::uint32_t>(2 + i % sides); };
  for (int i = 0; i < sides; ++i) {
    const double angle = 6.28318530717958 * i / sides;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    faces.push_back({0, rim(i), rim(i + 1)});
    faces.push_back({1, rim(i + 1), rim(i)});
  }
  return make_mesh(std::move(points), faces);
}

PolygonMesh comb_prism(int teeth) {
  std::vector<Point2> polygon{{0, -1}, {2.0 * teeth, -1}, {2.0 * teeth, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = 2 * i;
    polygon.insert(polygon.end(), {{x + 1, 0}, {x + 1, 10}, {x, 10}, {x, 0}});
  }
  return prism_mesh(polygon, 0, 1);
}

namespace {

/// The outline of one side of a comb, from low to high t: (t, height) with notches.
std::vector<std::pair<double, double>> outline(int notches, double base, double depth) {
  std::vector<std::pair<double, double>> line{{0, base}};
  for (int i = 0; i < notches; ++i) {
    line.emplace_back(i + 0.75, base);
    line.emplace_back(i + 1, base - depth - depth * i / (8.0 * notches));
    line.emplace_back(i + 1.25, base);
  }
  line.emplace_back(notches + 1, base);
  return line;
}

/// A side of saddle_block(): from corner to corner over n notches, whose bottoms lie at z = slope t
/// + lift for t = 1 .. n. Walls rise by `steep` for each unit to the side, so that they are planes.
/// `place(t, z)` is a point of it.
template <class Place>
std::vector<std::uint32_t> notched_side(PolygonMesh& mesh, int n, double slope, double lift,
                                        double level, double steep, Place place) {
  std::vector<std::uint32_t> corners;
  const auto add = [&](double t, double z) {
    corners.push_back(static_cast<std::uint32_t>(mesh.points.size()));
    mesh.points.push_back(place(t, z));
  };
  add(0, level);
  for (int t = 1; t <= n; ++t) {
    const double bottom = slope * t + lift;
    const double half = std::fabs(level - bottom) / steep;
    add(t - half, level);
    add(t, bottom);
    add(t + half, level);
  }
  add(n + 1.0, level);
  return corners;
}

}  // namespace

PolygonMesh comb_block(int top, int bottom) {
  const auto upper = outline(top, 4, 2), lower = outline(bottom, -4, -2);
  const double width = top + 1.0, depth = bottom + 1.0;
  std::vector<Point3> points;
  const auto add = [&](double x, double y, double z) {
    points.push_back({x, y, z});
    return static_cast<std::uint32_t>(points.size() - 1);
  };
  // The profile of the top at y = 0 and y = depth, that of the bottom at x = 0 and x = width.
  std::array<std::vector<std::uint32_t>, 2> across, along;
  for (const auto& [x, z] : upper) {
    across[0].push_back(add(x, 0, z));
    across[1].push_back(add(x, depth, z));
  }
  for (const auto& [y, z] : lower) {
    along[0].push_back(add(0, y, z));
    along[1].push_back(add(width, y, z));
  }
  std::vector<Face> faces;
  for (std::size_t i = 0; i + 1 < upper.size(); ++i) {
    faces.push_back({across[0][i], across[0][i + 1], across[1][i + 1], across[1][i]});
  }
  for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
    faces.push_back({along[0][i], along[0][i + 1], along[1][i + 1], along[1][i]});
  }
  const auto end = [&](const std::vector<std::uint32_t>& profile, std::uint32_t a, std::uint32_t b,
                       bool is_reversed) {
    Face face(profile.begin(), profile.end());
    if (is_reversed) face.assign(profile.rbegin(), profile.rend());
    face.push_back(a);
    face.push_back(b);
    faces.push_back(face);
  };
  end(across[0], along[0].front(), along[1].front(), true);
  end(across[1], along[1].back(), along[0].back(), false);
  end(along[0], across[0].front(), across[1].front(), true);
  end(along[1], across[1].back(), across[0].back(), false);
  return make_mesh(std::move(points), faces);
}

PolygonMesh saddle_block(int n) {
  PolygonMesh mesh;
  const double side = n + 1.0, top = side * side + 1;
  const double steep = std::exp2(std::ceil(std::log2(4 * top + 8)));  // notches stay apart
  const auto upper = [&](double x) {
    return notched_side(mesh, n, x, 0.25, top, steep, [x](double y, double z) {
      return Point3{x, y, z};
    });
  };
  const auto lower = [&](double y) {
    return notched_side(mesh, n, y, -0.25, -1, steep, [y](double x, double z) {
      return Point3{x, y, z};
    });
  };
  const auto left = upper(0), right = upper(side), front = lower(0), back = lower(side);
  for (std::size_t i = 0; i + 1 < left.size(); ++i) {
    mesh.add_face(std::array{left[i], right[i], right[i + 1], left[i + 1]});
    mesh.add_face(std::array{front[i], back[i], back[i + 1], front[i + 1]});
  }
  const auto add_end = [&](std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t> profile,
                           bool is_reversed) {
    if (is_reversed) std::ranges::reverse(profile);
    profile.insert(profile.begin(), {a, b});
    mesh.add_face(profile);
  };
  add_end(back.front(), front.front(), left, false);
  add_end(front.back(), back.back(), right, true);
  add_end(right.front(), left.front(), front, false);
  add_end(left.back(), right.back(), back, true);
  return mesh;
}

}  // namespace plumb::testing
