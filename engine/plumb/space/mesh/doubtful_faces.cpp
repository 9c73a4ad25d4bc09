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
#include "plumb/space/bounds/packed_boxes.h"

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
  Vec3 m{};
  double size = 0;

  Form() = default;
  Form(const Vec3& x, const Vec3& y) : m(cross(x, y)), size(size_of(x) * size_of(y)) {}
  int sign(const Vec3& d) const { return known_sign(dot(m, d), kProductError * size * size_of(d)); }
};

bool contains_corner(Corners face, std::uint32_t v) {
  return std::find(face.begin(), face.end(), v) != face.end();
}

// ---------------------------------------------------------------- pairs of triangles

constexpr std::array<std::size_t, 3> kNextCorner{1, 2, 0};

/// A triangle with its places and its normal, which many pairs need.
struct FilteredTriangle {
  std::array<std::uint32_t, 3> corner{};
  std::array<Vec3, 3> at{};
  Form plane;              ///< Through at[0]: the signs of differences from at[0].
  bool is_usable = false;  ///< Whether the face has three different corners.
};

/// The test of one pair of triangles with the planes that are listed at the top of this file.
class FilteredPair {
 public:
  FilteredPair(const FilteredTriangle& a, const FilteredTriangle& b) : a_(a), b_(b) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const bool is_same = a.corner[i] == b.corner[j];
        in_b_[i] |= is_same;
        in_a_[j] |= is_same;
        common_ += is_same ? 1 : 0;
      }
    }
  }

  /// Whether it is certain that the triangles meet only in common vertices and edges.
  bool is_certain() const {
    if (common_ == 3) return false;
    return is_on_one_side(a_, b_, in_a_) || is_on_one_side(b_, a_, in_b_) ||
           is_beyond_edge(a_, in_b_, b_, in_a_) || is_beyond_edge(b_, in_a_, a_, in_b_) ||
           (common_ == 1 && are_separate()) || (common_ == 0 && have_gap());
  }

 private:
  using Flags = std::array<bool, 3>;

  /// Whether all vertices of `face` that are not vertices of t are on one side of the plane of t.
  static bool is_on_one_side(const FilteredTriangle& t, const FilteredTriangle& face,
                             const Flags& is_common) {
    int sign = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_common[j]) continue;
      const int next = t.plane.sign(minus(face.at[j], t.at[0]));
      if (next == 0 || next == -sign) return false;
      sign = next;
    }
    return true;
  }

  /// Whether `face` is outside an edge of t, seen along the normal of t or of the face.
  static bool is_beyond_edge(const FilteredTriangle& t, const Flags& in_face,
                             const FilteredTriangle& face, const Flags& in_t) {
    return is_beyond_edge(t, in_face, t.plane.m, face, in_t) ||
           is_beyond_edge(t, in_face, face.plane.m, face, in_t);
  }
  static bool is_beyond_edge(const FilteredTriangle& t, const Flags& in_face, const Vec3& direction,
                             const FilteredTriangle& face, const Flags& in_t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = kNextCorner[i], k = kNextCorner[j];
      if (in_face[k]) continue;  // So common vertices are ends of the edge.
      const Form plane(direction, minus(t.at[j], t.at[i]));
      const int inside = plane.sign(minus(t.at[k], t.at[i]));
      if (inside == 0) continue;
      const auto is_outside = [&](std::size_t l) {
        return in_t[l] || plane.sign(minus(face.at[l], t.at[i])) == -inside;
      };
      if (is_outside(0) && is_outside(1) && is_outside(2)) return true;
    }
    return false;
  }

  /// Whether a plane through the only common vertex and one edge of each triangle separates them.
  bool are_separate() const {
    const std::array<Vec3, 2> x = spokes(a_, in_b_), y = spokes(b_, in_a_);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const Form plane(x[i], y[j]);
        if (plane.sign(x[1 - i]) * plane.sign(y[1 - j]) < 0) return true;
      }
    }
    return false;
  }
  /// Returns the other two vertices of a triangle, relative to its common vertex.
  static std::array<Vec3, 2> spokes(const FilteredTriangle& t, const Flags& is_common) {
    const std::size_t i = is_common[0] ? 0 : is_common[1] ? 1 : 2;
    const std::size_t j = kNextCorner[i], k = kNextCorner[j];
    return {minus(t.at[j], t.at[i]), minus(t.at[k], t.at[i])};
  }

  /// Whether a plane that is parallel to an edge of each triangle separates them. An edge of a
  /// triangle is on the plane then, with all of the triangle on one side, so it suffices to
  /// look at planes through vertices.
  bool have_gap() const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = kNextCorner[i], k = kNextCorner[j];
      const Vec3 along = minus(a_.at[j], a_.at[i]), third = minus(a_.at[k], a_.at[i]);
      for (std::size_t l = 0; l < 3; ++l) {
        const Form plane(along, minus(b_.at[kNextCorner[l]], b_.at[l]));
        const int inside = plane.sign(third);
        const auto is_outside = [&](const Vec3& p) {
          return plane.sign(minus(p, a_.at[i])) == -inside;
        };
        if (inside != 0 && std::ranges::all_of(b_.at, is_outside)) return true;
      }
    }
    return false;
  }

  const FilteredTriangle &a_, &b_;
  Flags in_b_{}, in_a_{};  // Whether the corners of a are in b, and those of b in a.
  int common_ = 0;         // The number of common corners.
};

// ---------------------------------------------------------------- the search

/// The cells of a coarse grid that boxes meet. Most faces are far from all faces to be checked, and
/// for these a few cells cost less than a tree.
class MarkedCells {
 public:
  /// Marks the cells of boxes. Requires that the box around them, `bounds`, has a finite extent.
  MarkedCells(const Box3& bounds, std::span<const Box3> boxes)
      : bounds_(bounds), grid_(bounds, kLast), rows_((kLast + 1) * (kLast + 1), 0) {
    for (const Box3& box : boxes) {
      for_rows(box, [](std::uint32_t& row, std::uint32_t cells) {
        row |= cells;
        return true;
      });
    }
  }
  /// Whether a box may meet one of the boxes. If it does not, it surely meets none.
  bool may_meet(const Box3& box) {
    if (!box.meets(bounds_)) return false;
    Box3 part;
    for (std::size_t i = 0; i < 3; ++i) {
      part.low[i] = std::max(box.low[i], bounds_.low[i]);
      part.high[i] = std::min(box.high[i], bounds_.high[i]);
    }
    bool is_near = false;
    for_rows(part, [&](std::uint32_t row, std::uint32_t cells) {
      is_near = (row & cells) != 0;
      return !is_near;
    });
    return is_near;
  }

 private:
  static constexpr std::uint32_t kLast = 31;  // A row of cells is a word.

  /// Calls visit(row, cells of the box in it) until it returns false.
  template <class Visit>
  void for_rows(const Box3& box, const Visit& visit) {
    const auto low = grid_.cell(box.low), high = grid_.cell(box.high);
    const std::uint32_t cells = (~0U << low[2]) & (~0U >> (kLast - high[2]));
    for (std::uint32_t x = low[0]; x <= high[0]; ++x) {
      for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
        if (!visit(rows_[(kLast + 1) * x + y], cells)) return;
      }
    }
  }

  Box3 bounds_;
  CellGrid grid_;
  std::vector<std::uint32_t> rows_;  // One bit for each cell.
};

class DoubtSearch {
 public:
  DoubtSearch(const PolygonMesh& mesh, std::span<const std::uint8_t> is_checked, Context& context)
      : mesh_(mesh), is_checked_(is_checked), context_(context) {}

  DoubtfulFaces run() {
    find_checked();
    if (checked_.empty()) return {};
    if (!look_at_pairs()) add_all_near(BoxTree(boxes_));
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
    triangle_number_.assign(mesh_.face_count(), kNone);
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

  /// Marks the faces of pairs that may meet. Returns false if there are too many pairs. The packed
  /// tree is given up if it finds far more pairs than there are.
  bool look_at_pairs() {
    const PackedBoxTree packed(boxes_);
    const std::uint64_t most = kMostPairs * mesh_.face_count() + 4096;
    pairs_left_ = steps_left_ = most;
    if (packed.fits() && look_at_pairs_in(packed)) return true;
    pairs_left_ = most;
    return look_at_pairs_in(BoxTree(boxes_));
  }
  bool look_at_pairs_in(const PackedBoxTree& tree) {
    const auto may_go_on = [&] {
      if (steps_left_ > 0 && --steps_left_ % 4096 == 0) checkpoint(0);
      return pairs_left_ > 0 && steps_left_ > 0;
    };
    const auto look = [&](std::uint32_t i, std::uint32_t j) {
      if (!boxes_[i].meets(boxes_[j])) return;
      look_at(checked_[std::min(i, j)], checked_[std::max(i, j)]);
    };
    if (!tree.for_each_pair_inside(look, may_go_on)) return false;
    MarkedCells cells(tree.bounds(), boxes_);
    for (std::uint32_t g = 0; g < mesh_.face_count(); ++g) {
      if (g % 1024 == 0) checkpoint(g);
      if (is_checked_[g] != 0 || mesh_.face(g).empty()) continue;
      const Box3 box = box_of(g);
      if (!cells.may_meet(box)) continue;
      tree.for_each_meeting(box, [&](std::uint32_t i) {
        if (may_go_on() && boxes_[i].meets(box)) look_at(checked_[i], g);
      });
      if (pairs_left_ == 0 || steps_left_ == 0) return false;
    }
    return true;
  }
  bool look_at_pairs_in(const BoxTree& tree) {
    const Box3 all = tree.bounds();
    std::uint32_t checked_before = 0;  // The number of checked faces before g.
    for (std::uint32_t g = 0; g < mesh_.face_count() && pairs_left_ > 0; ++g) {
      if (g % 1024 == 0) checkpoint(g);
      const bool is_checked = checked_before < checked_.size() && checked_[checked_before] == g;
      const Box3 box = is_checked ? boxes_[checked_before] : box_of(g);
      checked_before += is_checked ? 1 : 0;
      if (!box.meets(all)) continue;
      tree.for_each_meeting(box, [&](std::uint32_t i) {
        const std::uint32_t f = checked_[i];
        if (!is_checked || f < g) look_at(f, g);  // Each pair of checked faces once.
        return pairs_left_ > 0;
      });
    }
    return pairs_left_ > 0;
  }
  void checkpoint(std::uint32_t g) {
    context_.checkpoint("faces near rounded vertices", g, mesh_.face_count());
  }

  /// Marks two faces whose boxes meet if they may meet. f is to be checked.
  void look_at(std::uint32_t f, std::uint32_t g) {
    if (pairs_left_ > 0) --pairs_left_;
    if (is_doubtful_[f] != 0 && is_doubtful_[g] != 0) return;
    if (!is_certain(f, g)) is_doubtful_[f] = is_doubtful_[g] = 1;
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
  bool is_certain(std::uint32_t f, std::uint32_t g) {
    const std::uint32_t i = triangle_of(f), j = triangle_of(g);
    const FilteredTriangle &a = triangles_[i], &b = triangles_[j];
    if (a.is_usable && b.is_usable) return FilteredPair(a, b).is_certain();
    return are_certain_polygons(mesh_.face(f), mesh_.face(g));
  }
  /// Returns the index of a face in triangles_, to which it is added if it is missing.
  std::uint32_t triangle_of(std::uint32_t f) {
    if (triangle_number_[f] == kNone) {
      triangle_number_[f] = static_cast<std::uint32_t>(triangles_.size());
      triangles_.push_back(triangle(mesh_.face(f)));
    }
    return triangle_number_[f];
  }
  FilteredTriangle triangle(Corners face) const {
    FilteredTriangle t;
    if (face.size() != 3) return t;
    for (std::size_t i = 0; i < 3; ++i) {
      t.corner[i] = face[i];
      t.at[i] = place(face[i]);
    }
    t.plane = Form(minus(t.at[1], t.at[0]), minus(t.at[2], t.at[0]));
    t.is_usable = face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
    return t;
  }

  /// Does the same for faces of which one may be a polygon.
  bool are_certain_polygons(Corners a, Corners b) const {
    std::uint32_t common = 0;
    for (const std::uint32_t v : b) common += contains_corner(a, v) ? 1 : 0;
    if (common > 2 || (common == 2 && !have_common_edge(a, b))) return false;
    return (a.size() == 3 && (is_on_one_side(a, b) || is_beyond_edge(a, b))) ||
           (b.size() == 3 && (is_on_one_side(b, a) || is_beyond_edge(b, a)));
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

  const PolygonMesh& mesh_;
  std::span<const std::uint8_t> is_checked_;
  Context& context_;
  std::vector<std::uint32_t> checked_;          // The faces to be checked.
  std::vector<Box3> boxes_;                     // Their boxes.
  std::vector<FilteredTriangle> triangles_;     // The triangles of the pairs looked at.
  std::vector<std::uint32_t> triangle_number_;  // The index there of each face, or kNone.
  std::uint64_t pairs_left_ = 0;                // Pairs that may still be looked at.
  std::uint64_t steps_left_ = 0;                // Steps that a packed tree may still take.
  std::vector<std::uint8_t> is_doubtful_;
  DoubtfulFaces result_;
};

}  // namespace

std::vector<std::uint8_t> faces_at(const PolygonMesh& mesh,
                                   std::span<const std::uint8_t> is_chosen) {
  std::vector<std::uint8_t> result(mesh.face_count(), 0);
  for (std::size_t f = 0; f < result.size(); ++f) {
    std::uint8_t any = 0;
    for (const std::uint32_t v : mesh.face(f)) any |= is_chosen[v];
    result[f] = any;
  }
  return result;
}

DoubtfulFaces doubtful_faces(const PolygonMesh& mesh, std::span<const std::uint8_t> is_checked,
                             Context& context) {
  return DoubtSearch(mesh, is_checked, context).run();
}

}  // namespace plumb
