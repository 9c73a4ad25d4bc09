// Small structures for the tests, and the tables from_cycles wants.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "plumb/dcel/dcel.h"

namespace plumb::test {

/// Listed cycles with the tables from_cycles needs, the twins found by a plain map.
struct Listing {
  std::size_t vertices = 0;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> cycle_begin = {0};
  std::vector<std::uint32_t> face_of_cycle;
  std::vector<Dcel::IsolatedVertex> isolated;

  void add(const std::vector<std::uint32_t>& cycle, std::uint32_t face) {
    corners.insert(corners.end(), cycle.begin(), cycle.end());
    cycle_begin.push_back(static_cast<std::uint32_t>(corners.size()));
    face_of_cycle.push_back(face);
  }

  std::uint32_t next_corner(std::size_t c, std::uint32_t p) const {
    return corners[p + 1 < cycle_begin[c + 1] ? p + 1 : cycle_begin[c]];
  }

  std::vector<std::uint32_t> twins() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> position;
    for (std::uint32_t c = 0; c < face_of_cycle.size(); ++c) {
      for (std::uint32_t p = cycle_begin[c]; p < cycle_begin[c + 1]; ++p) {
        position[{corners[p], next_corner(c, p)}] = p;
      }
    }
    std::vector<std::uint32_t> twin(corners.size());
    for (const auto& [edge, p] : position) twin[p] = position.at({edge.second, edge.first});
    return twin;
  }

  DcelFromCycles build() const {
    return Dcel::from_cycles(vertices, corners, cycle_begin, twins(), face_of_cycle, isolated);
  }
};

/// n x n squares and their outer cycle; face 0 is the outside, cycle 0 its boundary.
inline Listing grid(std::uint32_t n) {
  Listing g;
  g.vertices = (n + 1) * (n + 1);
  const auto at = [n](std::uint32_t x, std::uint32_t y) { return y * (n + 1) + x; };
  std::vector<std::uint32_t> outer;
  for (std::uint32_t y = 0; y < n; ++y) outer.push_back(at(0, y));
  for (std::uint32_t x = 0; x < n; ++x) outer.push_back(at(x, n));
  for (std::uint32_t y = n; y > 0; --y) outer.push_back(at(n, y));
  for (std::uint32_t x = n; x > 0; --x) outer.push_back(at(x, 0));
  g.add(outer, 0);
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      g.add({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)}, y * n + x + 1);
    }
  }
  return g;
}

/// Two triangles sharing vertex 0, their outer boundaries listed apart.
inline Listing pinched() {
  Listing g;
  g.vertices = 5;
  g.add({0, 1, 2}, 1);
  g.add({0, 2, 1}, 0);
  g.add({0, 3, 4}, 2);
  g.add({0, 4, 3}, 0);
  return g;
}

/// A triangle with a triangular hole, an island in the hole, and two lone points.
inline Listing nested() {
  Listing g;
  g.vertices = 12;  // 11 is used nowhere
  g.add({0, 1, 2}, 1);
  g.add({2, 1, 0}, 0);
  g.add({5, 4, 3}, 1);
  g.add({3, 4, 5}, 2);
  g.add({6, 8, 7}, 2);
  g.add({6, 7, 8}, 3);
  g.isolated = {{VertexId(9), FaceId(0)}, {VertexId(10), FaceId(3)}};
  return g;
}

}  // namespace plumb::test
