// Finds the faces that rounding may have damaged.
//
// Most rounded vertices are corners of large triangles that meet at large angles. For these a few
// products of doubles prove that nothing has happened. A triangle f and another face g meet only in
// their common vertices, or in a common edge, if one of these planes separates them:
//
//  - the plane of f, if all other vertices of g are on one side of it;
//  - the plane through an edge of f and a direction, if the third vertex of f is on one side of it,
//    all other vertices of g are on the other side, and all common vertices are ends of the edge.
//    Directions are the normals of f and g;
//  - the plane through a common vertex v, an edge of f at v and an edge of g at v, if the third
//    vertices of f and g are on different sides of it;
//  - a plane that is parallel to an edge of f and an edge of g, if they have no common vertices.
//
// The tests are also made with f and g exchanged. A sign is known if the product exceeds a bound of
// its error. A pair without a known plane is doubtful, and so is a polygon that is to be checked.
//
// Errors. Each product m . (x x y) of a vector m and differences x, y of points takes at most seven
// roundings, so its error is at most 8 * 2^-53 |m| |x| |y|, where |v| is the sum of the absolute
// coordinates. If m is a difference, too, there are eight. kProductError is twice as large.
//
// Tested by tests/space/doubtful_faces_test.cpp, against exact numbers.
#include "plumb/space/mesh/doubtful_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/strong_id.h"

namespace plumb {
namespace {

using Vec3 = std::array<double, 3>;
using Corners = std::span<const std::uint32_t>;

constexpr double kProductError = 0x1p-49;
constexpr double kLeastProduct = 0x1p-960;  // Products below it may have lost digits.
constexpr std::uint64_t kMostPairs = 64;    // For each face.

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double size_of(const Vec3& v) { return std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]); }

/// Returns the sign of a product with this error, or 0 if it is unknown.
int known_sign(double product, double error) {
  if (product > error + kLeastProduct) return 1;
  return product < -error - kLeastProduct ? -1 : 0;
}

/// The signs of m . d for vectors d, where m is a product of vectors with the sum of the absolute
/// terms `size`.
struct Form {
  Vec3 m;
  double size;

  Form(const Vec3& x, const Vec3& y) : m(cross(x, y)), size(size_of(x) * size_of(y)) {}
  int sign(const Vec3& d) const { return known_sign(dot(m, d), kProductError * size * size_of(d)); }
};

bool contains_corner(Corners face, std::uint32_t v) {
  return std::find(face.begin(), face.end(), v) != face.end();
}

class DoubtSearch {
 public:
  DoubtSearch(const PolygonMesh& mesh, std::span<const std::uint8_t> is_checked, Context& context)
      : mesh_(mesh), is_checked_(is_checked), context_(context) {}

  DoubtfulFaces run() {
    find_checked();
    if (checked_.empty()) return {};
    const BoxTree tree(boxes_);
    if (!look_at_pairs(tree)) add_all_near(tree);
    for (std::uint32_t f = 0; f < is_doubtful_.size(); ++f) {
      if (is_doubtful_[f] != 0) result_.faces.push_back(f);
    }
    return std::move(result_);
  }

 private:
  // ---- faces to be checked

  void find_checked() {
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (is_checked_[f] != 0 && !mesh_.face(f).empty()) checked_.push_back(f);
    }
    // Half a unit of the last digit of a coordinate is at most 2^-53 or 2^-24 times the coordinate.
    // It counts twice in a difference, and a factor of 2 is left.
    const bool are_floats = has_floats_only();
    const double step = are_floats ? 0x1p-22 : 0x1p-51, least = are_floats ? 0x1p-148 : 0x1p-1000;
    is_doubtful_.assign(mesh_.face_count(), 0);
    boxes_.reserve(checked_.size());
    for (const std::uint32_t f : checked_) {
      const Corners face = mesh_.face(f);
      boxes_.push_back(box_of(f));
      const bool is_thin = may_be_flipped(face, step, least);
      if (is_thin) result_.flipped.push_back(f);
      if (is_thin || face.size() != 3) is_doubtful_[f] = 1;
    }
  }
  bool has_floats_only() const {
    for (const std::uint32_t f : checked_) {
      for (const std::uint32_t v : mesh_.face(f)) {
        for (const double c : place(v)) {
          if (!(std::fabs(c) <= 0x1.fffffep127) || static_cast<float>(c) != c) return false;
        }
      }
    }
    return true;
  }
  Vec3 place(std::uint32_t v) const {
    const Point3& p = mesh_.points[v];
    return {p.x, p.y, p.z};
  }
  Box3 box_of(std::uint32_t f) const {
    Box3 box;
    for (const std::uint32_t v : mesh_.face(f)) {
      const Vec3 p = place(v);
      box.add({p, p});
    }
    return box;
  }

  /// Whether a face may have had another direction before its corners moved, or may have no area.
  /// In differences, coordinates have moved by at most `step` times the largest one plus `least`.
  bool may_be_flipped(Corners face, double step, double least) const {
    double largest = 0;
    for (const std::uint32_t v : face) {
      for (const double c : place(v)) largest = std::max(largest, std::fabs(c));
    }
    const double move = 3 * (step * largest + least);
    const double error = kProductError * static_cast<double>(face.size());
    const Vec3 o = place(face[0]);
    Vec3 normal{}, u{};
    double change = 0;
    for (const std::uint32_t v : face) {
      const Vec3 w = minus(place(v), o), part = cross(u, w);
      for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
      change += move * (size_of(u) + size_of(w) + move) + error * size_of(u) * size_of(w);
      u = w;
    }
    // Before and after, each coordinate of the normal differs by less than a quarter of the largest
    // one. So the scalar product of both is positive.
    const double length =
        std::max({std::fabs(normal[0]), std::fabs(normal[1]), std::fabs(normal[2])});
    return !(length > 4 * change + kLeastProduct);
  }

  // ---- pairs

  /// Marks the faces of pairs that may meet. Returns false if there are too many pairs.
  bool look_at_pairs(const BoxTree& tree) {
    const Box3 all = tree.bounds();
    std::uint64_t left = kMostPairs * mesh_.face_count() + 4096;
    std::uint32_t checked_before = 0;  // The number of checked faces before g.
    for (std::uint32_t g = 0; g < mesh_.face_count() && left > 0; ++g) {
      if (g % 1024 == 0) context_.checkpoint("faces near rounded vertices", g, mesh_.face_count());
      const bool is_checked = checked_before < checked_.size() && checked_[checked_before] == g;
      const Box3 box = is_checked ? boxes_[checked_before] : box_of(g);
      checked_before += is_checked ? 1 : 0;
      if (!box.meets(all)) continue;
      tree.for_each_meeting(box, [&](std::uint32_t i) {
        const std::uint32_t f = checked_[i];
        if (is_checked && f >= g) return true;  // Each pair of checked faces once.
        --left;
        if (!is_certain(f, g)) is_doubtful_[f] = is_doubtful_[g] = 1;
        return left > 0;
      });
    }
    return left > 0;
  }
  void add_all_near(const BoxTree& tree) {
    for (std::uint32_t g = 0; g < mesh_.face_count(); ++g) {
      if (is_doubtful_[g] != 0 || mesh_.face(g).empty()) continue;
      tree.for_each_meeting(box_of(g), [&](std::uint32_t) {
        is_doubtful_[g] = 1;
        return false;
      });
    }
  }

  /// Whether it is certain that two faces meet only in common vertices and edges.
  bool is_certain(std::uint32_t f, std::uint32_t g) const {
    const Corners a = mesh_.face(f), b = mesh_.face(g);
    std::uint32_t common = 0, vertex = kNone;
    for (const std::uint32_t v : b) {
      if (!contains_corner(a, v)) continue;
      ++common;
      vertex = v;
    }
    if (common > 2 || (common == 2 && !have_common_edge(a, b))) return false;
    if (a.size() == 3 && is_on_one_side(a, b)) return true;
    if (b.size() == 3 && is_on_one_side(b, a)) return true;
    if (a.size() == 3 && is_beyond_edge(a, b)) return true;
    if (b.size() == 3 && is_beyond_edge(b, a)) return true;
    if (a.size() != 3 || b.size() != 3) return false;
    return (common == 1 && are_separate_at(vertex, a, b)) || (common == 0 && have_gap(a, b));
  }

  /// Whether two corners of a face that are corners of the other one follow each other. Requires
  /// that there are two.
  static bool have_common_edge(Corners a, Corners b) {
    const auto has_pair = [](Corners face, Corners other) {
      std::uint32_t from = face.back();
      for (const std::uint32_t to : face) {
        if (contains_corner(other, from) && contains_corner(other, to)) return true;
        from = to;
      }
      return false;
    };
    return has_pair(a, b) && has_pair(b, a);
  }

  /// Whether all vertices of a face that are not vertices of the triangle t are on one side of its
  /// plane.
  bool is_on_one_side(Corners t, Corners face) const {
    const Vec3 o = place(t[0]);
    const Form plane(minus(place(t[1]), o), minus(place(t[2]), o));
    int sign = 0;
    for (const std::uint32_t v : face) {
      if (v == t[0] || v == t[1] || v == t[2]) continue;
      const int next = plane.sign(minus(place(v), o));
      if (next == 0 || next == -sign) return false;
      sign = next;
    }
    return sign != 0;
  }

  /// Whether a face is outside an edge of the triangle t, seen along the normal of t or of the
  /// face.
  bool is_beyond_edge(Corners t, Corners face) const {
    const std::array<Vec3, 3> p{place(t[0]), place(t[1]), place(t[2])};
    const Vec3 normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    if (is_beyond_edge(t, p, normal, face)) return true;
    const Vec3 o = place(face[0]);
    return is_beyond_edge(t, p, cross(minus(place(face[1]), o), minus(place(face[2]), o)), face);
  }
  bool is_beyond_edge(Corners t, const std::array<Vec3, 3>& p, const Vec3& direction,
                      Corners face) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if (contains_corner(face, t[k])) continue;
      const Form plane(direction, minus(p[j], p[i]));
      const int inside = plane.sign(minus(p[k], p[i]));
      if (inside == 0) continue;
      const auto is_outside = [&](std::uint32_t v) {
        return v == t[i] || v == t[j] || plane.sign(minus(place(v), p[i])) == -inside;
      };
      if (std::all_of(face.begin(), face.end(), is_outside)) return true;
    }
    return false;
  }

  /// Whether a plane through the only common vertex of two triangles and one edge of each separates
  /// them.
  bool are_separate_at(std::uint32_t vertex, Corners a, Corners b) const {
    const std::array<Vec3, 2> x = spokes(vertex, a), y = spokes(vertex, b);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const Form plane(x[i], y[j]);
        if (plane.sign(x[1 - i]) * plane.sign(y[1 - j]) < 0) return true;
      }
    }
    return false;
  }
  /// Returns the other two vertices of a triangle, relative to one of its vertices.
  std::array<Vec3, 2> spokes(std::uint32_t vertex, Corners t) const {
    std::size_t i = 0;
    while (t[i] != vertex) ++i;
    const Vec3 o = place(vertex);
    return {minus(place(t[(i + 1) % 3]), o), minus(place(t[(i + 2) % 3]), o)};
  }

  /// Whether a plane that is parallel to an edge of each triangle separates them. An edge of a
  /// triangle is on the plane then, with all of the triangle on one side, so it suffices to
  /// look at planes through vertices.
  bool have_gap(Corners a, Corners b) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 p = place(a[i]), along = minus(place(a[(i + 1) % 3]), p);
      const Vec3 third = minus(place(a[(i + 2) % 3]), p);
      for (std::size_t j = 0; j < 3; ++j) {
        const Vec3 q = place(b[j]);
        const Form plane(along, minus(place(b[(j + 1) % 3]), q));
        const int inside = plane.sign(third);
        const auto is_outside = [&](std::uint32_t v) {
          return plane.sign(minus(place(v), p)) == -inside;
        };
        if (inside != 0 && std::all_of(b.begin(), b.end(), is_outside)) return true;
      }
    }
    return false;
  }

  const PolygonMesh& mesh_;
  std::span<const std::uint8_t> is_checked_;
  Context& context_;
  std::vector<std::uint32_t> checked_;  // The faces to be checked.
  std::vector<Box3> boxes_;             // Their boxes.
  std::vector<std::uint8_t> is_doubtful_;
  DoubtfulFaces result_;
};

}  // namespace

DoubtfulFaces doubtful_faces(const PolygonMesh& mesh, std::span<const std::uint8_t> is_checked,
                             Context& context) {
  return DoubtSearch(mesh, is_checked, context).run();
}

}  // namespace plumb
