// Removes vertices at which a mesh is nearly flat or nearly folded along a straight line.
//
// Where a plane cuts a surface whose triangles are coplanar up to the last digit, it meets the
// edges between them. The points of intersection are vertices of the result, although they are not
// corners of its shape. If such vertices were kept, the number of nearly coplanar triangles would
// grow with each operation on a file.
//
// The triangles around a vertex v form a closed fan. The ends of its edges at v, its *link*, form a
// closed chain. After v has been removed, the chain is triangulated, in two parts if v is on a
// fold. Vertices are removed one by one. The error of a triangle bounds the distances between its
// points and the input: if v is removed, the error of each triangle that takes the place of the fan
// is the greatest error in the fan, plus a bound of the distance between both surfaces. If the
// points of a side are at most h away from one plane, and v is at most s away from the new edge,
// the distance is at most 2 h + s: above a common point of the projections into the plane the
// surfaces are at most 2 h apart, and the projections differ by a triangle whose points are at most
// s away from the edge.
//
// Tested by tests/space/drop_flat_vertices_test.cpp.
#include "plumb/space/mesh/drop_flat_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/strong_id.h"

namespace plumb {
namespace {

using Vector3 = std::array<double, 3>;

constexpr std::uint32_t kMostAround = 32;  // Triangulating a link takes cubic time.
constexpr double kMostError = 16;          // As a multiple of the width.
// The least altitude of a triangle, as a multiple of the width.
constexpr double kThinnest = 2;
/// A bound of the errors of 2 h + s per unit of the size of the link. Differences have a relative
/// error of 2^-53. So h has an error of 4 * 2^-53, and s has one of 5 * 2^-53, because the segment
/// is longer than its parts on both sides of v.
constexpr double kRounding = 0x1p-49;

Vector3 difference_of(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double norm(const Vector3& v) { return std::sqrt(dot(v, v)); }

/// The removal of vertices from one mesh. Corner 3 t + i is corner i of triangle t. The corners at
/// each vertex are a doubly linked list.
class FlatVertices {
 public:
  FlatVertices(const PolygonMesh& mesh, std::span<const std::uint8_t> is_removable,
               std::span<const std::uint8_t> is_near, double width, Context& context)
      : input_(mesh), is_removable_(is_removable.begin(), is_removable.end()), context_(context) {
    for (std::uint32_t f = 0; f < is_near.size(); ++f) {
      if (is_near[f] != 0) near_.push_back(f);
    }
    double largest = 0;
    for (const std::uint32_t f : near_) {
      for (const std::uint32_t v : mesh.face(f)) {
        const Point3& p = mesh.points[v];
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
      }
    }
    scale_ = largest > 0 ? std::ilogb(largest) : 0;
    width_ = std::ldexp(width, -scale_);
    factor_ = std::abs(scale_) < 1000 ? std::ldexp(1, -scale_) : 0;
  }

  FlattenedMesh run() {
    keep_corners_of_polygons();
    gather_triangles_at(is_removable_);
    std::vector<std::uint32_t> candidates = find_candidates();
    if (candidates.empty()) return {};
    gather_triangles_around();
    origin_ = face_;
    error_.assign(triangle_.size(), 0);
    is_changed_.assign(input_.face_count(), 0);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (i % 1024 == 0) context_.checkpoint("flat vertices of the mesh", i, candidates.size());
      const std::uint32_t v = candidates[i];
      if (!remove(v)) continue;
      for (const std::uint32_t w : link_) {
        if (is_removable_[w] != 0) candidates.push_back(w);
      }
    }
    return removed_ > 0 ? FlattenedMesh{result(), removed_} : FlattenedMesh{};
  }

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  /// The plane of the largest triangle of a side: a normal of length 1. The plane contains v.
  struct Side {
    std::size_t first, last;  ///< The indices in link_ at which it begins and ends.
    Vector3 normal{};
    double height = 0;  ///< A bound of the distances of its points from its plane.
  };

  // ---- corners

  void keep_corners_of_polygons() {
    for (const std::uint32_t f : near_) {
      const auto face = input_.face(f);
      if (face.size() == 3) continue;
      for (const std::uint32_t v : face) is_removable_[v] = 0;
    }
  }

  /// Collects all triangles at the chosen vertices, and links their corners there.
  void gather_triangles_at(const std::vector<std::uint8_t>& is_chosen) {
    triangle_.clear();
    face_.clear();
    for (const std::uint32_t f : near_) {
      const auto face = input_.face(f);
      if (face.size() != 3 || (is_chosen[face[0]] | is_chosen[face[1]] | is_chosen[face[2]]) == 0) {
        continue;
      }
      triangle_.push_back({face[0], face[1], face[2]});
      face_.push_back(f);
    }
    link_corners_at(is_chosen);
  }
  /// Collects all triangles at the vertices of the triangles that were collected before. The
  /// removal of vertices makes triangles only of these vertices.
  void gather_triangles_around() {
    std::vector<std::uint8_t> is_around(input_.points.size(), 0);
    for (const Triangle& t : triangle_) {
      for (const std::uint32_t v : t) is_around[v] = 1;
    }
    near_.resize(input_.face_count());
    std::iota(near_.begin(), near_.end(), 0U);
    gather_triangles_at(is_around);
  }
  void link_corners_at(const std::vector<std::uint8_t>& is_chosen) {
    head_.assign(input_.points.size(), kNone);
    degree_.assign(input_.points.size(), 0);
    next_.resize(3 * triangle_.size());
    prev_.resize(3 * triangle_.size());
    for (std::uint32_t t = 0; t < triangle_.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (is_chosen[triangle_[t][i]] != 0) link(3 * t + i);
      }
    }
  }
  std::uint32_t vertex(std::uint32_t corner) const { return triangle_[corner / 3][corner % 3]; }
  void link(std::uint32_t corner) {
    const std::uint32_t v = vertex(corner);
    next_[corner] = head_[v];
    prev_[corner] = kNone;
    if (head_[v] != kNone) prev_[head_[v]] = corner;
    head_[v] = corner;
    ++degree_[v];
  }
  void unlink(std::uint32_t corner) {
    const std::uint32_t v = vertex(corner), next = next_[corner], prev = prev_[corner];
    (prev == kNone ? head_[v] : next_[prev]) = next;
    if (next != kNone) prev_[next] = prev;
    --degree_[v];
  }

  // ---- the fan of a vertex

  /// Finds the fan of a vertex: fan_[i] is the triangle of v, link_[i] and link_[i + 1]. Returns
  /// false if the triangles at v are not one closed fan.
  bool find_fan(std::uint32_t v) {
    fan_.clear();
    link_.clear();
    if (degree_[v] < 3 || degree_[v] > kMostAround) return false;
    spokes_.clear();
    for (std::uint32_t c = head_[v]; c != kNone; c = next_[c]) {
      const Triangle& t = triangle_[c / 3];
      spokes_.push_back({t[(c % 3 + 1) % 3], t[(c % 3 + 2) % 3], c / 3});
    }
    std::size_t at = 0;
    do {
      fan_.push_back(spokes_[at].triangle);
      link_.push_back(spokes_[at].from);
      const std::uint32_t to = spokes_[at].to;
      for (at = 0; at < spokes_.size() && spokes_[at].from != to;) ++at;
    } while (at != 0 && at < spokes_.size() && fan_.size() < spokes_.size());
    if (at != 0 || fan_.size() != spokes_.size()) return false;
    from_.clear();
    const Vector3 origin = place(v);
    for (const std::uint32_t w : link_) from_.push_back(difference_of(place(w), origin));
    return true;
  }
  Vector3 place(std::uint32_t v) const {
    const Point3& p = input_.points[v];
    if (factor_ != 0) return {p.x * factor_, p.y * factor_, p.z * factor_};
    return {std::ldexp(p.x, -scale_), std::ldexp(p.y, -scale_), std::ldexp(p.z, -scale_)};
  }

  /// Returns the distance of v from the line through two vertices of the link if v lies between
  /// them; otherwise a number greater than width_.
  double distance_from_line(std::size_t i, std::size_t j) const {
    constexpr double kFar = 8;  // All coordinates are less than 2.
    if (!(dot(from_[i], from_[j]) < 0)) return kFar;
    return norm(cross(from_[i], from_[j])) / norm(difference_of(from_[i], from_[j]));
  }
  /// Whether v is near a segment between two vertices of its link.
  bool is_on_line() const {
    for (std::size_t i = 0; i < from_.size(); ++i) {
      for (std::size_t j = i + 1; j < from_.size(); ++j) {
        if (may_be_near_line(i, j) && distance_from_line(i, j) <= width_) return true;
      }
    }
    return false;
  }
  /// Returns false only if distance_from_line() exceeds width_. This test needs no roots and no
  /// quotient.
  bool may_be_near_line(std::size_t i, std::size_t j) const {
    constexpr double kLeastSquare = 0x1p-1000;  // Smaller squares may have lost digits.
    if (!(dot(from_[i], from_[j]) < 0)) return false;
    const Vector3 area = cross(from_[i], from_[j]), along = difference_of(from_[i], from_[j]);
    return !(dot(area, area) > 2 * width_ * width_ * dot(along, along) + kLeastSquare);
  }

  /// Finds the plane of the triangles from link_[first] to link_[last]. Returns false if a point is
  /// farther away than the width.
  bool find_plane(Side& side) const {
    double most = 0;
    for (std::size_t i = side.first; i < side.last; ++i) {
      const Vector3 normal = cross(from_[i % link_.size()], from_[(i + 1) % link_.size()]);
      const double size = norm(normal);
      if (size <= most) continue;
      most = size;
      side.normal = {normal[0] / size, normal[1] / size, normal[2] / size};
    }
    for (std::size_t i = side.first; i <= side.last; ++i) {
      side.height = std::max(side.height, std::fabs(dot(from_[i % link_.size()], side.normal)));
    }
    return most > 0 && side.height <= width_;
  }

  /// Returns the vertices that are flat or on a fold, in ascending order. Most vertices are not
  /// near any line, whatever the order of the triangles around them is, so their fans are not
  /// needed.
  std::vector<std::uint32_t> find_candidates() {
    std::vector<std::uint32_t> result;
    for (std::uint32_t v = 0; v < is_removable_.size(); ++v) {
      if (is_removable_[v] == 0 || degree_[v] < 3 || degree_[v] > kMostAround) continue;
      find_spokes(v);
      if (is_on_line() && find_fan(v)) result.push_back(v);
    }
    return result;
  }
  /// Lists the differences from v to the first of the other two vertices of each triangle at v. If
  /// the triangles are one closed fan, these vertices are its link.
  void find_spokes(std::uint32_t v) {
    from_.clear();
    const Vector3 origin = place(v);
    for (std::uint32_t c = head_[v]; c != kNone; c = next_[c]) {
      const Triangle& t = triangle_[c / 3];
      from_.push_back(difference_of(place(t[(c % 3 + 1) % 3]), origin));
    }
  }

  // ---- removal

  /// Removes a vertex if this is possible. Afterwards, link_ lists its former neighbours.
  bool remove(std::uint32_t v) {
    if (!find_fan(v)) return false;
    for (std::size_t i = 0; i < link_.size(); ++i) {
      for (std::size_t j = i + 1; j < link_.size(); ++j) {
        const double distance = distance_from_line(i, j);
        if (distance <= width_ && remove_from_line(i, j, distance)) return true;
      }
    }
    return false;
  }

  bool remove_from_line(std::size_t i, std::size_t j, double distance) {
    std::array<Side, 2> sides{Side{i, j}, Side{j, i + link_.size()}};
    made_.clear();
    double height = 0;
    for (Side& side : sides) {
      // A side of one triangle is flat up to the distance of v from the line.
      if (side.last - side.first == 1) continue;
      if (!find_plane(side) || !triangulate(side)) return false;
      height = std::max(height, side.height);
    }
    double reach = 0, error = 0;
    for (const Vector3& d : from_) reach = std::max(reach, norm(d));
    for (const std::uint32_t t : fan_) error = std::max(error, error_[t]);
    error += 2 * height + distance + kRounding * reach;
    if (error > kMostError * width_ || makes_edge_twice()) return false;
    replace(error);
    ++removed_;
    return true;
  }

  /// Adds the triangles of a side without v to made_. Of all triangulations, it uses the one whose
  /// worst triangle has the best shape. Returns false if one of them would be too thin or flipped.
  bool triangulate(const Side& side) {
    const std::size_t n = side.last - side.first + 1;
    best_.assign(n * n, 1);
    apex_.assign(n * n, 0);
    for (std::size_t width = 2; width < n; ++width) {
      for (std::size_t a = 0; a + width < n; ++a) {
        const std::size_t c = a + width;
        best_[a * n + c] = -1;
        for (std::size_t b = a + 1; b < c; ++b) {
          const double worst =
              std::min({best_[a * n + b], best_[b * n + c], shape_of(side, a, b, c)});
          if (worst <= best_[a * n + c]) continue;
          best_[a * n + c] = worst;
          apex_[a * n + c] = b;
        }
      }
    }
    if (best_[n - 1] <= 0) return false;
    parts_.assign(1, {0, n - 1});
    while (!parts_.empty()) {
      const auto [a, c] = parts_.back();
      parts_.pop_back();
      if (c < a + 2) continue;
      const std::size_t b = apex_[a * n + c];
      made_.push_back({at(side, a), at(side, b), at(side, c)});
      parts_.emplace_back(a, b);
      parts_.emplace_back(b, c);
    }
    return true;
  }
  std::uint32_t at(const Side& side, std::size_t i) const {
    return link_[(side.first + i) % link_.size()];
  }
  /// Returns the ratio of the least altitude of a triangle to its longest edge, or -1 if the
  /// triangle is too thin or flipped.
  double shape_of(const Side& side, std::size_t a, std::size_t b, std::size_t c) const {
    const std::size_t n = link_.size();
    const Vector3 &p = from_[(side.first + a) % n], &q = from_[(side.first + b) % n],
                  &r = from_[(side.first + c) % n];
    const Vector3 u = difference_of(q, p), w = difference_of(r, p), across = difference_of(r, q);
    const double longest = std::sqrt(std::max({dot(u, u), dot(w, w), dot(across, across)}));
    const double altitude = dot(cross(u, w), side.normal) / longest;
    return altitude >= kThinnest * width_ ? altitude / longest : -1;
  }

  /// Whether an edge of made_ would have more than two faces.
  bool makes_edge_twice() {
    edges_.clear();
    for (const Triangle& t : made_) {
      for (std::size_t i = 0; i < 3; ++i) edges_.emplace_back(t[i], t[(i + 1) % 3]);
    }
    std::ranges::sort(edges_);
    return std::ranges::any_of(edges_, [&](const auto& edge) {
      const std::pair reverse(edge.second, edge.first);
      return edge.first < edge.second && std::ranges::binary_search(edges_, reverse) &&
             has_edge(edge.first, edge.second);
    });
  }
  /// Whether a triangle outside the fan has both vertices.
  bool has_edge(std::uint32_t a, std::uint32_t b) const {
    if (degree_[a] > degree_[b]) std::swap(a, b);
    for (std::uint32_t c = head_[a]; c != kNone; c = next_[c]) {
      if (std::ranges::find(triangle_[c / 3], b) == triangle_[c / 3].end()) continue;
      if (std::ranges::find(fan_, c / 3) == fan_.end()) return true;
    }
    return false;
  }

  /// Replaces the fan by made_.
  void replace(double error) {
    std::uint32_t origin = kNone;
    for (const std::uint32_t t : fan_) {
      origin = std::min(origin, origin_[t]);
      is_changed_[face_[t]] = 1;
      for (std::uint32_t i = 0; i < 3; ++i) unlink(3 * t + i);
    }
    for (std::size_t k = 0; k < fan_.size(); ++k) {
      const std::uint32_t t = fan_[k];
      triangle_[t] = k < made_.size() ? made_[k] : Triangle{kNone, kNone, kNone};
      if (k >= made_.size()) continue;
      origin_[t] = origin;
      error_[t] = error;
      largest_ = std::max(largest_, error);
      for (std::uint32_t i = 0; i < 3; ++i) link(3 * t + i);
    }
  }

  ChangedMesh result() {
    ChangedMesh result;
    result.changed = std::move(is_changed_);
    result.largest_move = std::ldexp(largest_, scale_);
    result.mesh.points = input_.points;
    std::uint32_t t = 0;
    for (std::uint32_t f = 0; f < input_.face_count(); ++f) {
      const bool is_triangle = t < face_.size() && face_[t] == f;
      if (!is_triangle) {
        result.mesh.add_face(input_.face(f));
        result.origin.push_back(f);
      } else if (triangle_[t][0] != kNone) {
        result.mesh.add_face(triangle_[t]);
        result.origin.push_back(origin_[t]);
      }
      t += is_triangle ? 1 : 0;
    }
    return result;
  }

  struct Spoke {
    std::uint32_t from, to, triangle;
  };

  const PolygonMesh& input_;
  std::vector<std::uint8_t> is_removable_;
  Context& context_;
  std::vector<std::uint32_t> near_;  // The faces in which triangles are searched.
  int scale_ = 0;                    // The exponent of the largest coordinate of the faces near_.
  // The width divided by 2^scale_, like all distances in this class.
  double width_ = 0;
  double factor_ = 0;  // The value 2^-scale_, or 0 if it may not be a double.
  std::vector<Triangle> triangle_;
  std::vector<std::uint32_t> face_;    // The face of the input of each triangle.
  std::vector<std::uint32_t> origin_;  // The least face from which each triangle was made.
  std::vector<double> error_;          // A bound of the distance of each triangle from the input.
  std::vector<std::uint32_t> head_, degree_, next_, prev_;  // The lists of corners.
  std::vector<std::uint8_t> is_changed_;
  double largest_ = 0;         // The largest error.
  std::uint32_t removed_ = 0;  // The number of removed vertices.
  // The fan of a vertex, and the places of its link relative to the vertex.
  std::vector<Spoke> spokes_;
  std::vector<std::uint32_t> fan_, link_;
  std::vector<Vector3> from_;
  // The triangulation of a side: the worst triangle between two vertices, and its third vertex.
  std::vector<double> best_;
  std::vector<std::size_t> apex_;
  std::vector<std::pair<std::size_t, std::size_t>> parts_;
  std::vector<Triangle> made_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;
};

}  // namespace

FlattenedMesh drop_flat_vertices(const PolygonMesh& mesh,
                                 std::span<const std::uint8_t> is_removable,
                                 std::span<const std::uint8_t> is_near, double width,
                                 Context& context) {
  return FlatVertices(mesh, is_removable, is_near, width, context).run();
}

}  // namespace plumb
