// Makes parts of a closed mesh that nearly touch meet in common vertices.
//
// A vertex v near the middle of an edge a b is inserted into this edge in all its faces, so the
// edge is replaced by the edges a v and v b everywhere, and the mesh stays closed. A triangle a b v
// then runs from v to b and back, and vanishes. Other triangles become polygons, which are
// triangulated again such that the worst triangle is as good as possible. Both new edges are
// shorter than a b, so a sequence of insertions among the same vertices ends. Faces with more than
// three corners get the vertex as a further corner.
//
// Points of faces move by at most the sum of two distances: of vertices that become one, and of
// vertices from the edges and triangles into which they are inserted. Distances are computed with
// coordinates below 2, so that no product overflows or vanishes.
//
// Tested by tests/space/snap_near_test.cpp.
#include "plumb/space/mesh/snap_near.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>

#include "plumb/base/internal/union_find.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/space/mesh/mesh_facets.h"

namespace plumb {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using FacePair = std::pair<std::uint32_t, std::uint32_t>;
using Vector3 = std::array<double, 3>;

/// At most so many vertices are inserted into an edge at once. The number of corners of a face then
/// suits cut(). Later rounds insert the other vertices into the shorter edges.
constexpr std::size_t kMostOnEdge = 16;

Vector3 difference(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double length(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

bool has_three_vertices(std::span<const std::uint32_t> t) {
  return t.size() == 3 && t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}
bool contains(std::span<const std::uint32_t> face, std::uint32_t v) {
  return std::ranges::find(face, v) != face.end();
}

/// A vertex that is inserted into an edge.
struct EdgePoint {
  Edge edge;  ///< The lesser vertex first.
  double at;  ///< The place along the edge, from 0 to 1.
  std::uint32_t vertex;
};

class Snapping {
 public:
  Snapping(const PolygonMesh& mesh, std::span<const std::uint8_t> is_damaged,
           std::span<const FacePair> pairs, double width)
      : input_(mesh), is_damaged_(is_damaged), pairs_(pairs) {
    double largest = 0;
    for (const std::uint32_t v : mesh.corners) {
      const Point3& p = mesh.points[v];
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    scale_ = largest > 0 ? std::ilogb(largest) : 0;
    for (const Point3& p : mesh.points) {
      at_.push_back({std::ldexp(p.x, -scale_), std::ldexp(p.y, -scale_), std::ldexp(p.z, -scale_)});
    }
    width_ = std::ldexp(width, -scale_);
  }

  ChangedMesh run() {
    merge_vertices();
    find_edge_points();
    find_face_points();
    const bool is_near =
        merged_.corners != input_.corners || !edge_points_.empty() || !face_points_.empty();
    if (!is_near) return {};
    result_.changed.assign(input_.face_count(), 0);
    for (std::uint32_t f = 0; f < input_.face_count(); ++f) rebuild(f);
    result_.mesh.points = input_.points;
    // This refers to a height that is computed with coordinates below 2.
    constexpr double kErrors = 0x1p-49;
    const double insertion = insertion_ > 0 ? insertion_ + kErrors : 0;
    result_.largest_move = std::ldexp(merging_ * (1 + kErrors) + insertion, scale_);
    return std::move(result_);
  }

 private:
  double distance(std::uint32_t a, std::uint32_t b) const {
    return length(difference(at_[a], at_[b]));
  }

  // ---- 1. vertices

  void merge_vertices() {
    UnionFind classes(input_.points.size());
    const auto unite_if_near = [&](std::uint32_t a, std::uint32_t b) {
      if (a != b && distance(a, b) <= width_) classes.unite(a, b);
    };
    for (std::uint32_t f = 0; f < input_.face_count(); ++f) {
      const auto t = input_.face(f);
      if (is_damaged_[f] == 0 || t.size() != 3) continue;
      for (std::size_t i = 0; i < 3; ++i) unite_if_near(t[i], t[(i + 1) % 3]);
    }
    for (const auto& [f, g] : pairs_) {
      for (const std::uint32_t v : input_.face(f)) {
        for (const std::uint32_t w : input_.face(g)) unite_if_near(v, w);
      }
    }
    merged_.face_begin = input_.face_begin;
    merged_.corners = input_.corners;
    for (std::uint32_t& v : merged_.corners) {
      const std::uint32_t root = classes.root(v);
      if (root != v) merging_ = std::max(merging_, distance(root, v));
      v = root;
    }
  }

  // ---- 2. vertices at edges

  /// Returns the place of v along the edge if v is near the middle of the edge.
  std::optional<EdgePoint> near_edge(std::uint32_t a, std::uint32_t b, std::uint32_t v) {
    const Edge edge = std::minmax(a, b);
    const Vector3 along = difference(at_[edge.second], at_[edge.first]);
    const Vector3 to = difference(at_[v], at_[edge.first]);
    const double square = dot(along, along), at = dot(to, along) / square;
    if (!(at > 0 && at < 1)) return {};
    const double height = length(cross(along, to)) / std::sqrt(square);
    const bool is_shorter =
        distance(edge.first, v) < std::sqrt(square) && distance(edge.second, v) < std::sqrt(square);
    if (!(height <= width_) || !is_shorter) return {};
    insertion_ = std::max({insertion_, height, std::numeric_limits<double>::min()});
    return EdgePoint{edge, at, v};
  }

  void find_edge_points() {
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t v) {
      if (const auto point = near_edge(a, b, v)) edge_points_.push_back(*point);
    };
    for (std::uint32_t f = 0; f < merged_.face_count(); ++f) {
      const auto t = merged_.face(f);
      if (is_damaged_[f] == 0 || !has_three_vertices(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) add(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
    }
    for (const auto& pair : pairs_) {
      for (const auto& [f, g] : {pair, FacePair(pair.second, pair.first)}) {
        const auto face = merged_.face(f), other = merged_.face(g);
        if (!has_three_vertices(face) || !has_three_vertices(other)) continue;
        for (const std::uint32_t v : face) {
          if (contains(other, v)) continue;
          for (std::size_t i = 0; i < 3; ++i) add(other[i], other[(i + 1) % 3], v);
        }
      }
    }
    const auto order = [](const EdgePoint& p) { return std::tuple(p.edge, p.at, p.vertex); };
    std::ranges::sort(edge_points_, {}, order);
    const auto is_same = [&](const EdgePoint& p, const EdgePoint& q) {
      return order(p) == order(q);
    };
    edge_points_.erase(std::unique(edge_points_.begin(), edge_points_.end(), is_same),
                       edge_points_.end());
    thin_out();
  }

  /// If an edge has more than kMostOnEdge points, keeps kMostOnEdge of them at equal steps.
  void thin_out() {
    std::vector<EdgePoint> kept;
    for (std::size_t i = 0, end = 0; i < edge_points_.size(); i = end) {
      while (end < edge_points_.size() && edge_points_[end].edge == edge_points_[i].edge) ++end;
      const std::size_t count = end - i, most = std::min(count, kMostOnEdge);
      for (std::size_t k = 0; k < most; ++k) kept.push_back(edge_points_[i + k * count / most]);
    }
    edge_points_ = std::move(kept);
  }

  /// Calls visit(vertex) for the vertices that are inserted between two corners.
  template <class Visit>
  void between(std::uint32_t from, std::uint32_t to, const Visit& visit) const {
    const Edge edge = std::minmax(from, to);
    const auto begin = std::ranges::lower_bound(edge_points_, edge, {}, &EdgePoint::edge);
    const auto end = std::ranges::upper_bound(edge_points_, edge, {}, &EdgePoint::edge);
    if (from < to) {
      for (auto p = begin; p != end; ++p) visit(p->vertex);
    } else {
      for (auto p = end; p != begin;) visit((--p)->vertex);
    }
  }

  // ---- 3. vertices inside faces

  void find_face_points() {
    for (const auto& pair : pairs_) {
      for (const auto& [f, g] : {pair, FacePair(pair.second, pair.first)}) {
        const auto face = merged_.face(f), t = merged_.face(g);
        if (!has_three_vertices(face) || !has_three_vertices(t)) continue;
        for (const std::uint32_t v : face) {
          if (!contains(t, v) && is_near_inside(t, v)) face_points_.emplace_back(g, v);
        }
      }
    }
    std::ranges::sort(face_points_);
  }
  bool is_near_inside(std::span<const std::uint32_t> t, std::uint32_t v) {
    const Vector3& o = at_[t[0]];
    const Vector3 u = difference(at_[t[1]], o), w = difference(at_[t[2]], o);
    const Vector3 to = difference(at_[v], o), normal = cross(u, w);
    const double square = dot(normal, normal);
    if (!(square > 0)) return false;
    const double b = dot(cross(to, w), normal) / square, c = dot(cross(u, to), normal) / square;
    const double height = std::fabs(dot(to, normal)) / std::sqrt(square);
    if (!(b > 0 && c > 0 && b + c < 1) || !(height <= width_)) return false;
    insertion_ = std::max({insertion_, height, std::numeric_limits<double>::min()});
    return true;
  }

  // ---- faces

  void rebuild(std::uint32_t f) {
    const auto before = merged_.face(f);
    corners_.clear();
    std::uint32_t from = before.empty() ? 0 : before.back();
    for (const std::uint32_t to : before) {
      between(from, to, [&](std::uint32_t v) { push_corner(corners_, 0, v); });
      push_corner(corners_, 0, to);
      from = to;
    }
    trim_ends(corners_, 0);
    const bool is_same = std::ranges::equal(corners_, input_.face(f));
    const auto inside = std::ranges::lower_bound(face_points_, f, {}, &FacePair::first);
    const bool has_inside = inside != face_points_.end() && inside->first == f;
    if (is_same && !has_inside) return add(corners_, f);
    result_.changed[f] = 1;
    if (corners_.size() < 3) return;
    if (before.size() > 3) {
      add(corners_, f);
    } else if (has_inside && std::ranges::equal(corners_, before)) {
      const std::array<std::uint32_t, 3> t{corners_[0], corners_[1], corners_[2]};
      for (std::size_t i = 0; i < 3; ++i) {
        add(std::array{t[i], t[(i + 1) % 3], inside->second}, f);
      }
    } else {
      cut(f);
    }
  }
  void add(std::span<const std::uint32_t> corners, std::uint32_t f) {
    result_.mesh.add_face(corners);
    result_.origin.push_back(f);
  }

  /// Cuts corners_ into triangles such that the worst one is as good as possible. The entry best_[i
  /// n + j] is the shape of the worst triangle between corners i and j, and apex_[i n + j] is the
  /// third corner of the triangle at these two.
  void cut(std::uint32_t f) {
    const std::size_t n = corners_.size();
    best_.assign(n * n, 1);
    apex_.assign(n * n, 0);
    for (std::size_t width = 2; width < n; ++width) {
      for (std::size_t i = 0; i + width < n; ++i) {
        const std::size_t j = i + width;
        best_[i * n + j] = -1;
        for (std::size_t k = i + 1; k < j; ++k) {
          const double worst = std::min({best_[i * n + k], best_[k * n + j],
                                         shape_of(corners_[i], corners_[k], corners_[j])});
          if (worst <= best_[i * n + j]) continue;
          best_[i * n + j] = worst;
          apex_[i * n + j] = k;
        }
      }
    }
    parts_.assign(1, {0, n - 1});
    while (!parts_.empty()) {
      const auto [i, j] = parts_.back();
      parts_.pop_back();
      if (j < i + 2) continue;
      const std::size_t k = apex_[i * n + j];
      const std::array t{corners_[i], corners_[k], corners_[j]};
      if (has_three_vertices(t)) add(t, f);
      parts_.emplace_back(i, k);
      parts_.emplace_back(k, j);
    }
  }
  /// Returns the ratio of the height of a triangle to its longest edge.
  double shape_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vector3 u = difference(at_[b], at_[a]), w = difference(at_[c], at_[a]);
    const Vector3 across = difference(at_[c], at_[b]);
    const double longest = std::max({dot(u, u), dot(w, w), dot(across, across)});
    return longest > 0 ? length(cross(u, w)) / longest : 0;
  }

  const PolygonMesh& input_;
  std::span<const std::uint8_t> is_damaged_;
  std::span<const FacePair> pairs_;
  int scale_ = 0;            // The exponent of the largest coordinate.
  double width_ = 0;         // The width divided by 2^scale_, like all distances in this class.
  std::vector<Vector3> at_;  // The points, divided by 2^scale_.
  PolygonMesh merged_;       // The faces of the input after vertices were merged.
  double merging_ = 0;       // The greatest distance of merged vertices.
  // The greatest distance of a vertex from the place where it was inserted.
  double insertion_ = 0;
  std::vector<EdgePoint> edge_points_;
  std::vector<FacePair> face_points_;  // A face, and the vertex inside it.
  std::vector<std::uint32_t> corners_;
  std::vector<double> best_;
  std::vector<std::size_t> apex_;
  std::vector<std::pair<std::size_t, std::size_t>> parts_;
  ChangedMesh result_;
};

}  // namespace

ChangedMesh snap_near(const PolygonMesh& mesh, std::span<const std::uint8_t> is_damaged,
                      std::span<const FacePair> pairs, double width) {
  return Snapping(mesh, is_damaged, pairs, width).run();
}

}  // namespace plumb
