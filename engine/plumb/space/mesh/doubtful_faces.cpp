// Finds the faces that rounding may have damaged.
//
// Most rounded vertices are corners of large triangles that meet at large angles. For these, a few
// products of doubles prove that rounding caused no damage. A triangle f and another face g meet
// only in their common vertices, or in a common edge, if one of these planes separates them:
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
// Most pairs of faces whose boxes meet have a common vertex. Most vertices have a *fan*: seen along
// some direction, the triangles around the vertex lie side by side, and go around it once. Then
// they meet only in the vertex and in common edges, and none of their pairs needs a test. Each fan
// is found by a few signs (docs/design/mesh-rounding.md, "Pairs that need no exact test").
//
// Errors. Each product m . (x x y) of a vector m and differences x, y of points takes at most seven
// roundings, so its error is at most 8 * 2^-53 |m| |x| |y|, where |v| is the sum of the absolute
// coordinates. If m is a difference, too, there are eight. kProductError is twice as large.
//
// Tested by tests/space/doubtful_faces_test.cpp, against exact numbers.
#include "plumb/space/mesh/doubtful_faces.h"

#include <algorithm>
#include <array>
#include <bit>
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
constexpr double kLeastProduct = 0x1p-960;  // Smaller products may have lost digits.
constexpr std::uint64_t kMostPairs = 64;    // For each face, the greatest number of pairs.

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
  bool has_edges = false;  ///< Whether `edge` is filled.
  /// For edge i, from at[i] to the next corner, the plane through the edge and the normal, if the
  /// third corner is certainly on its positive side. Otherwise, no sign is known.
  std::array<Form, 3> edge{};
  FilteredTriangle() = default;
  FilteredTriangle(const PolygonMesh& mesh, Corners face) {
    if (face.size() != 3) return;
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = face[i];
      const Point3& p = mesh.points[face[i]];
      at[i] = {p.x, p.y, p.z};
    }
    is_usable = face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
    plane = Form(minus(at[1], at[0]), minus(at[2], at[0]));
  }
  void find_edges() {
    has_edges = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = kNextCorner[i], k = kNextCorner[j];
      const Form side(plane.m, minus(at[j], at[i]));
      if (side.sign(minus(at[k], at[i])) > 0) edge[i] = side;
    }
  }
};

/// The test of one pair of triangles, with the planes that are listed at the top of this file.
/// Requires that has_edges is true for both.
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
           is_beyond_upright_edge(a_, in_b_, b_, in_a_) ||
           is_beyond_upright_edge(b_, in_a_, a_, in_b_) || is_beyond_edge(a_, in_b_, b_, in_a_) ||
           is_beyond_edge(b_, in_a_, a_, in_b_) || (common_ == 1 && are_separate()) ||
           (common_ == 0 && have_gap());
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

  /// Whether `face` is outside an edge of t, seen along the normal of t.
  static bool is_beyond_upright_edge(const FilteredTriangle& t, const Flags& in_face,
                                     const FilteredTriangle& face, const Flags& in_t) {
    for (std::size_t i = 0; i < 3; ++i) {
      // Therefore common vertices are ends of the edge.
      if (in_face[kNextCorner[kNextCorner[i]]]) continue;
      const auto is_outside = [&](std::size_t l) {
        return in_t[l] || t.edge[i].sign(minus(face.at[l], t.at[i])) < 0;
      };
      if (is_outside(0) && is_outside(1) && is_outside(2)) return true;
    }
    return false;
  }
  /// Whether `face` is outside an edge of t, seen along the normal of the face.
  static bool is_beyond_edge(const FilteredTriangle& t, const Flags& in_face,
                             const FilteredTriangle& face, const Flags& in_t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = kNextCorner[i], k = kNextCorner[j];
      if (in_face[k]) continue;  // Therefore common vertices are ends of the edge.
      const Form plane(face.plane.m, minus(t.at[j], t.at[i]));
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
  /// triangle then lies in such a plane, with the whole triangle on one side. So it is sufficient
  /// to test planes through vertices.
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
  Flags in_b_{}, in_a_{};  // Whether the corners of a occur in b, and those of b in a.
  int common_ = 0;         // The number of common corners.
};

// ---------------------------------------------------------------- cells

/// The cells of a grid that boxes meet. Most faces are far from all faces to be checked. For these,
/// a few cells take less time than a tree. Cells 1 to 62 along each axis divide the box around the
/// boxes, up to rounding; cells 0 and 63 are outside.
class MarkedCells {
 public:
  /// Marks the cells of boxes. Requires that the box around them, `bounds`, has a finite extent.
  MarkedCells(const Box3& bounds, std::span<const Box3> boxes)
      : low_(bounds.low), rows_(kCells * kCells, 0), near_(kCells * kCells, 0) {
    // The scale is a positive double even if there is no extent, so that a cell is never a NaN.
    for (std::size_t i = 0; i < 3; ++i) {
      scale_[i] = std::min((kCells - 3) / (bounds.high[i] - low_[i]), 0x1p900);
      low_[i] -= 1 / scale_[i];
    }
    for (const Box3& box : boxes) {
      for_rows(cell(box.low), cell(box.high), [&](std::uint32_t row, std::uint64_t cells) {
        rows_[row] |= cells;
        return true;
      });
    }
    find_near_cells();
  }
  /// Returns the cell of a point, one byte for each axis, and kIsNear if a marked cell is at most
  /// two cells below it or one cell above it along each axis.
  std::uint32_t code(const Vec3& at) const {
    const std::uint32_t c = cell(at);
    const std::uint64_t row = near_[kCells * (c & kByte) + (c >> 8 & kByte)];
    return c | ((row >> (c >> 16) & 1) != 0 ? kIsNear : 0);
  }
  /// Whether a face may meet one of the boxes. If the result is false, the face certainly meets
  /// none. `codes` has the codes of all points.
  bool may_meet(Corners face, std::span<const std::uint32_t> codes) const {
    // Nearly all faces are small and far away from the boxes.
    const std::uint32_t a = codes[face[0]];
    if (face.size() == 3 && (a & kIsNear) == 0 && are_close(a, codes[face[1]]) &&
        are_close(a, codes[face[2]])) {
      return false;
    }
    return meets_marked_cells(face, codes);
  }

 private:
  static constexpr std::uint32_t kCells = 64;  // One word stores a row of cells.
  static constexpr std::uint32_t kByte = 0xff, kCellMask = 0xffffff, kIsNear = 0x1000000;

  /// Returns the cell of a point. It is monotone in every coordinate, because each step of the
  /// arithmetic is.
  std::uint32_t cell(const Vec3& at) const {
    std::uint32_t cell = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double place = std::min(std::max((at[i] - low_[i]) * scale_[i], 0.0), kCells - 1.0);
      cell |= static_cast<std::uint32_t>(static_cast<std::int32_t>(place)) << (8 * i);
    }
    return cell;
  }
  /// Whether b is at most two cells below a and one cell above a along each axis, for points that
  /// are not near. The difference of cells, -1 to 2, is stored with 64 added, so bits 2 to 7 tell.
  static bool are_close(std::uint32_t a, std::uint32_t b) {
    constexpr std::uint32_t kOffset = 0x414141, kHighBits = 0xfcfcfc, kExpected = 0x404040;
    return ((a + kOffset - (b & kCellMask)) & kHighBits) == kExpected;
  }
  bool meets_marked_cells(Corners face, std::span<const std::uint32_t> codes) const {
    std::uint32_t low = codes[face[0]] & kCellMask, high = low;
    for (const std::uint32_t v : face.subspan(1)) {
      const std::uint32_t at = codes[v] & kCellMask;
      low ^= (low ^ at) & ~bytes_not_above(low, at);
      high ^= (high ^ at) & bytes_not_above(high, at);
    }
    return !for_rows(low, high, [&](std::uint32_t row, std::uint64_t cells) {
      return (rows_[row] & cells) == 0;
    });
  }
  /// Returns the bytes, filled with ones, in which a is not greater than b. Requires bytes below
  /// 128.
  static std::uint32_t bytes_not_above(std::uint32_t a, std::uint32_t b) {
    constexpr std::uint32_t kHighBits = 0x808080;
    return (((b | kHighBits) - a) & kHighBits) / 128 * kByte;
  }

  /// Calls visit(row, cells in it) for the cells from `low` to `high` until it returns false.
  /// Returns whether it never returned false.
  template <class Visit>
  static bool for_rows(std::uint32_t low, std::uint32_t high, const Visit& visit) {
    const std::uint32_t high_x = high & kByte, high_y = high >> 8 & kByte;
    const std::uint64_t cells =
        (~std::uint64_t{0} << (low >> 16)) & (~std::uint64_t{0} >> (kCells - 1 - (high >> 16)));
    for (std::uint32_t x = low & kByte; x <= high_x; ++x) {
      for (std::uint32_t y = low >> 8 & kByte; y <= high_y; ++y) {
        if (!visit(kCells * x + y, cells)) return false;
      }
    }
    return true;
  }
  /// Fills near_ with the cells that have a marked cell from two cells below to one cell above.
  void find_near_cells() {
    for (std::uint32_t row = 0; row < rows_.size(); ++row) {
      const std::uint64_t r = rows_[row];
      if (r == 0) continue;
      const std::uint64_t cells = r << 2 | r << 1 | r | r >> 1;
      const std::uint32_t x = row / kCells, y = row % kCells;
      for (std::uint32_t i = x - std::min(x, 1U); i <= std::min(x + 2, kCells - 1); ++i) {
        for (std::uint32_t j = y - std::min(y, 1U); j <= std::min(y + 2, kCells - 1); ++j) {
          near_[kCells * i + j] |= cells;
        }
      }
    }
  }

  Vec3 low_;  // One step above the end of cell 0.
  Vec3 scale_{};
  std::vector<std::uint64_t> rows_;  // For each cell, one bit states whether the cell is marked,
  std::vector<std::uint64_t> near_;  // and one bit states whether a marked cell is near it.
};

// ---------------------------------------------------------------- fans

/// Finds the vertices that have fans, as described at the top of this file.
///
/// Let all triangles around v be seen from the same side along a direction d: then each corner at v
/// turns counter-clockwise, by less than half a turn. If the corners are a closed chain, they go
/// around v a whole number of times. An edge *rises* if its direction w has e . w > 0, for a vector
/// e that is orthogonal to d. The edges that rise fill an open half of the view, which no corner
/// can jump over. So the corners go around once if and only if there is one corner that begins at
/// an edge that does not rise and ends at one that does.
class Fans {
 public:
  /// The corners of a triangle at which there is a fan, side by side. The other corners are
  /// replaced by kNone.
  using Corners4 __attribute__((vector_size(16))) = std::uint32_t;

  /// Finds the fans at numbered vertices. `number` has the number of each corner of each triangle,
  /// or kNone for a vertex without a number. `has_polygon` tells for each number whether some face
  /// at the vertex is no triangle. Requires all triangles at each vertex with a number.
  Fans(std::span<const FilteredTriangle> triangles,
       std::span<const std::array<std::uint32_t, 3>> number, std::vector<std::uint8_t> has_polygon)
      : triangles_(triangles), number_(number), has_fan_(std::move(has_polygon)) {
    for (std::uint8_t& flag : has_fan_) flag = flag == 0 ? 1 : 0;
    list_corners();
    for (std::uint32_t v = 0; v < has_fan_.size(); ++v) {
      if (has_fan_[v] != 0) has_fan_[v] = is_fan(v) ? 1 : 0;
    }
  }
  /// Returns the corners of triangle t that have a fan.
  Corners4 corners(std::size_t t) const {
    Corners4 result{kNone, kNone, kNone, kNone};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = number_[t][i];
      if (v != kNone && has_fan_[v] != 0) result[i] = v;
    }
    return result;
  }
  /// Whether two triangles have a common corner with a fan.
  static bool share(Corners4 s, Corners4 t) {
    const Corners4 none{kNone, kNone, kNone, kNone};
    const auto equal = (s == t) | (s == __builtin_shufflevector(t, t, 1, 2, 0, 3)) |
                       (s == __builtin_shufflevector(t, t, 2, 0, 1, 3));
    const auto shared = std::bit_cast<std::array<std::uint64_t, 2>>(equal & (s != none));
    return (shared[0] | shared[1]) != 0;
  }

 private:
  static constexpr std::uint32_t kMostCorners = 16;  // Chains are followed in quadratic time.
  static constexpr int kUnknown = 2;

  /// Lists the corners at each vertex: 4 t + i is corner i of triangle t.
  void list_corners() {
    begin_.assign(has_fan_.size() + 1, 0);
    for (const auto& vertices : number_) {
      for (const std::uint32_t v : vertices) begin_[v == kNone ? 0 : v + 1] += v == kNone ? 0 : 1;
    }
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    corners_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t t = 0; t < number_.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (number_[t][i] != kNone) corners_[next[number_[t][i]]++] = 4 * t + i;
      }
    }
  }

  /// The direction of a view, with the coordinates -1, 0 and 1, and a vector that is orthogonal to
  /// it. The two coordinates of this vector that may not be 0 are at i and j.
  struct View {
    Vec3 along{};
    std::size_t i = 0, j = 1;
    double at_i = 0, at_j = 0;
  };

  bool is_fan(std::uint32_t v) const {
    const auto around = std::span(corners_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
    if (around.size() < 3 || around.size() > kMostCorners) return false;
    const View view = view_of(around);
    return is_seen_from_one_side(around, view) && goes_around_once(around, view);
  }
  /// Returns a view such that most normals around a vertex have the opposite direction.
  View view_of(std::span<const std::uint32_t> around) const {
    Vec3 sum{};
    for (const std::uint32_t c : around) {
      const Form& plane = triangles_[c / 4].plane;
      const double factor = plane.size > 0 ? 1 / plane.size : 0;
      for (std::size_t k = 0; k < 3; ++k) sum[k] += factor * plane.m[k];
    }
    constexpr double kFlatter = 0.375;  // As a part of the largest coordinate.
    const double least =
        kFlatter * std::max({std::fabs(sum[0]), std::fabs(sum[1]), std::fabs(sum[2])});
    View view;
    for (std::size_t k = 0; k < 3; ++k) {
      view.along[k] = sum[k] > least ? 1 : sum[k] < -least ? -1 : 0;
    }
    // The vector is (d_j, -d_i) in two coordinates that are not both 0.
    if (view.along[0] == 0 && view.along[1] == 0) view.i = 2;
    view.at_i = view.along[view.j];
    view.at_j = -view.along[view.i];
    return view;
  }
  bool is_seen_from_one_side(std::span<const std::uint32_t> around, const View& view) const {
    return std::ranges::all_of(around, [&](std::uint32_t c) {
      const Form& plane = triangles_[c / 4].plane;
      return known_sign(dot(plane.m, view.along), 4 * kProductError * plane.size) > 0;
    });
  }
  /// Whether all corners form one closed chain of edges that goes around the vertex once.
  bool goes_around_once(std::span<const std::uint32_t> around, const View& view) const {
    std::array<std::uint32_t, kMostCorners> begins{}, ends{};
    std::array<int, kMostCorners> rises{};  // The edges at which corners begin.
    for (std::size_t n = 0; n < around.size(); ++n) {
      const FilteredTriangle& t = triangles_[around[n] / 4];
      const std::size_t i = around[n] % 4, j = kNextCorner[i];
      begins[n] = t.corner[j];
      ends[n] = t.corner[kNextCorner[j]];
      rises[n] = rise(t.at[i], t.at[j], view);
      if (rises[n] == kUnknown) return false;
    }
    const auto last = begins.begin() + static_cast<std::ptrdiff_t>(around.size());
    std::size_t at = 0, length = 0, count = 0;
    do {
      const auto found = std::find(begins.begin(), last, ends[at]);
      if (found == last) return false;
      const auto next = static_cast<std::size_t>(found - begins.begin());
      count += rises[at] <= 0 && rises[next] > 0 ? 1 : 0;
      at = next;
    } while (++length < around.size() && at != 0);
    return at == 0 && length == around.size() && count == 1;
  }
  /// Returns the sign of the rise of an edge, or kUnknown.
  static int rise(const Vec3& from, const Vec3& to, const View& view) {
    const double x = view.at_i * (to[view.i] - from[view.i]);
    const double y = view.at_j * (to[view.j] - from[view.j]);
    const int sign = known_sign(x + y, kProductError * (std::fabs(x) + std::fabs(y)));
    return sign == 0 && (x != 0 || y != 0) ? kUnknown : sign;
  }
  std::span<const FilteredTriangle> triangles_;
  std::span<const std::array<std::uint32_t, 3>> number_;
  std::vector<std::uint8_t> has_fan_;
  std::vector<std::uint32_t> begin_;    // The index at which the corners of each vertex begin.
  std::vector<std::uint32_t> corners_;  // The corners of all vertices.
};

// ---------------------------------------------------------------- the search

/// The search. The faces to be checked have the first numbers, and the other faces near them have
/// the following ones, both in ascending order.
class DoubtSearch {
 public:
  DoubtSearch(const PolygonMesh& mesh, std::span<const std::uint8_t> is_checked, Context& context)
      : mesh_(mesh), is_checked_(is_checked), context_(context) {}

  DoubtfulFaces run() {
    find_checked();
    if (checked_ == 0) return {};
    number_vertices();
    const PackedBoxTree packed(boxes_);
    find_near();
    find_fans();
    if (!look_at_pairs(packed)) add_all_near();
    for (std::uint32_t i = 0; i < is_doubtful_.size(); ++i) {
      if (is_doubtful_[i] != 0) result_.faces.push_back(face_[i]);
    }
    std::ranges::sort(result_.faces);
    return std::move(result_);
  }

 private:
  // ---- faces to be checked

  void find_checked() {
    for (std::uint32_t f = 0; f < is_checked_.size(); ++f) {
      if (is_checked_[f] != 0 && !mesh_.face(f).empty()) face_.push_back(f);
    }
    checked_ = face_.size();
    // Half a unit of the last digit of a coordinate is at most 2^-53 or 2^-24 times the coordinate.
    // It counts twice in a difference, and a factor of 2 remains as a margin.
    const bool are_floats = has_floats_only();
    const double step = are_floats ? 0x1p-22 : 0x1p-51, least = are_floats ? 0x1p-148 : 0x1p-1000;
    boxes_.reserve(checked_);
    triangles_.reserve(2 * checked_);
    is_doubtful_.reserve(2 * checked_);
    for (std::uint32_t i = 0; i < checked_; ++i) {
      const Corners face = mesh_.face(face_[i]);
      boxes_.push_back(box_of(face));
      triangles_.emplace_back(mesh_, face);
      const bool is_thin = may_be_flipped(face, triangles_[i], step, least);
      if (is_thin) result_.flipped.push_back(face_[i]);
      is_doubtful_.push_back(is_thin || face.size() != 3 ? 1 : 0);
    }
  }
  bool has_floats_only() const {
    for (const std::uint32_t f : face_) {
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
  Box3 box_of(Corners face) const {
    Box3 box;
    for (const std::uint32_t v : face) {
      const Vec3 p = place(v);
      box.add({p, p});
    }
    return box;
  }

  /// Whether the orientation of a face may have changed when its corners moved, or the face may
  /// have no area. In differences, coordinates have moved by at most `step` times the largest one
  /// plus `least`.
  bool may_be_flipped(Corners face, const FilteredTriangle& t, double step, double least) const {
    double largest = 0;
    for (const std::uint32_t v : face) {
      for (const double c : place(v)) largest = std::max(largest, std::fabs(c));
    }
    const double move = 3 * (step * largest + least);
    const double error = kProductError * static_cast<double>(face.size());
    Vec3 normal = t.plane.m;
    double change = 0;
    if (face.size() == 3) {
      const double u = size_of(minus(t.at[1], t.at[0])), w = size_of(minus(t.at[2], t.at[0]));
      change = move * (2 * u + w + 3 * move) + error * u * w;
    } else {
      const Vec3 o = place(face[0]);
      Vec3 u{};
      for (const std::uint32_t v : face) {
        const Vec3 w = minus(place(v), o), part = cross(u, w);
        for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
        change += move * (size_of(u) + size_of(w) + move) + error * size_of(u) * size_of(w);
        u = w;
      }
    }
    // Before and after, each coordinate of the normal differs by less than a quarter of the largest
    // one. So the scalar product of both is positive.
    const double length =
        std::max({std::fabs(normal[0]), std::fabs(normal[1]), std::fabs(normal[2])});
    return !(length > 4 * change + kLeastProduct);
  }

  // ---- other faces

  /// Numbers the vertices of faces to be checked.
  void number_vertices() {
    vertex_.assign(mesh_.points.size(), kNone);
    for (const std::uint32_t f : face_) {
      for (const std::uint32_t v : mesh_.face(f)) {
        if (vertex_[v] == kNone) vertex_[v] = vertices_++;
      }
    }
  }

  /// Adds the other faces that may meet the boxes of faces to be checked. If there are few others,
  /// all of them are added.
  void find_near() {
    Box3 bounds;
    for (const Box3& box : boxes_) bounds.add(box);
    if (mesh_.face_count() - checked_ < checked_ || !std::isfinite(bounds.extent())) {
      return add_others([](Corners) { return true; });
    }
    const MarkedCells cells(bounds, boxes_);
    std::vector<std::uint32_t> codes(mesh_.points.size());
    for (std::size_t v = 0; v < codes.size(); ++v) {
      codes[v] = cells.code(place(static_cast<std::uint32_t>(v)));
    }
    add_others([&](Corners face) { return cells.may_meet(face, codes); });
  }
  template <class IsNear>
  void add_others(const IsNear& is_near) {
    for (std::uint32_t g = 0; g < mesh_.face_count(); ++g) {
      if (g % 4096 == 0) checkpoint(g);
      if (is_checked_[g] != 0) continue;
      const Corners face = mesh_.face(g);
      if (!face.empty() && is_near(face)) add_near(g, face);
    }
  }
  void add_near(std::uint32_t g, Corners face) {
    face_.push_back(g);
    boxes_.push_back(box_of(face));
    triangles_.emplace_back(mesh_, face);
    is_doubtful_.push_back(0);
  }

  /// Finds the fans at the vertices of faces to be checked. All faces at these vertices are listed,
  /// because their boxes meet.
  void find_fans() {
    std::vector<std::array<std::uint32_t, 3>> numbers(face_.size(), {kNone, kNone, kNone});
    std::vector<std::uint8_t> has_polygon(vertices_, 0);
    for (std::size_t i = 0; i < face_.size(); ++i) {
      const Corners face = mesh_.face(face_[i]);
      if (triangles_[i].is_usable) {
        for (std::size_t k = 0; k < 3; ++k) numbers[i][k] = vertex_[face[k]];
      } else {
        for (const std::uint32_t v : face) {
          if (vertex_[v] != kNone) has_polygon[vertex_[v]] = 1;
        }
      }
    }
    const Fans fans(triangles_, numbers, std::move(has_polygon));
    fan_corners_.reserve(face_.size());
    for (std::size_t i = 0; i < face_.size(); ++i) fan_corners_.push_back(fans.corners(i));
  }

  // ---- pairs

  /// Marks the faces of pairs that may meet. Returns false if there are too many pairs. The packed
  /// tree is abandoned if it finds far more pairs than there are.
  bool look_at_pairs(const PackedBoxTree& packed) {
    const std::uint64_t most = kMostPairs * mesh_.face_count() + 4096;
    pairs_left_ = steps_left_ = most;
    if (packed.fits() && look_at_pairs_in(packed)) return true;
    pairs_left_ = most;
    return look_at_pairs_in(BoxTree(boxes_of_checked()));
  }
  bool look_at_pairs_in(const PackedBoxTree& tree) {
    const auto may_go_on = [&] {
      if (steps_left_ == 0) return false;
      if (--steps_left_ % 4096 == 0) checkpoint(0);
      return true;
    };
    const auto look = [&](std::uint32_t i, std::uint32_t j) { look_at(i, j); };
    if (!tree.for_each_pair_inside(look, may_go_on)) return false;
    for (auto j = static_cast<std::uint32_t>(checked_); j < face_.size(); ++j) {
      if (j % 1024 == 0) checkpoint(face_[j]);
      tree.for_each_meeting(boxes_[j], [&](std::uint32_t i) {
        if (may_go_on()) look_at(i, j);
      });
      if (pairs_left_ == 0 || steps_left_ == 0) return false;
    }
    return true;
  }
  bool look_at_pairs_in(const BoxTree& tree) {
    for (std::uint32_t j = 0; j < face_.size() && pairs_left_ > 0; ++j) {
      if (j % 1024 == 0) checkpoint(face_[j]);
      tree.for_each_meeting(boxes_[j], [&](std::uint32_t i) {
        if (i < j) look_at(i, j);  // Each pair of checked faces is visited once.
        return pairs_left_ > 0;
      });
    }
    return pairs_left_ > 0;
  }
  void checkpoint(std::uint32_t g) {
    context_.checkpoint("faces near rounded vertices", g, mesh_.face_count());
  }

  /// Marks two faces if they may meet. Face i is to be checked.
  void look_at(std::uint32_t i, std::uint32_t j) {
    if (Fans::share(fan_corners_[i], fan_corners_[j]) || !boxes_[i].meets(boxes_[j])) return;
    if (pairs_left_ > 0 && --pairs_left_ == 0) steps_left_ = 0;
    if (is_doubtful_[i] != 0 && is_doubtful_[j] != 0) return;
    if (!is_certain(i, j)) is_doubtful_[i] = is_doubtful_[j] = 1;
  }
  void add_all_near() {
    const BoxTree tree(boxes_of_checked());
    for (std::uint32_t j = 0; j < face_.size(); ++j) {
      if (is_doubtful_[j] != 0) continue;
      tree.for_each_meeting(boxes_[j], [&](std::uint32_t) {
        is_doubtful_[j] = 1;
        return false;
      });
    }
  }

  std::span<const Box3> boxes_of_checked() const {
    return std::span<const Box3>(boxes_).first(checked_);
  }

  /// Whether it is certain that two faces meet only in common vertices and edges.
  bool is_certain(std::uint32_t i, std::uint32_t j) {
    FilteredTriangle &a = triangles_[i], &b = triangles_[j];
    if (!a.has_edges) a.find_edges();
    if (!b.has_edges) b.find_edges();
    if (a.is_usable && b.is_usable) return FilteredPair(a, b).is_certain();
    return are_certain_polygons(mesh_.face(face_[i]), mesh_.face(face_[j]));
  }

  /// Computes the same result for faces, one of which may be a polygon.
  bool are_certain_polygons(Corners a, Corners b) const {
    std::uint32_t common = 0;
    for (const std::uint32_t v : b) common += contains_corner(a, v) ? 1 : 0;
    if (common > 2 || (common == 2 && !have_common_edge(a, b))) return false;
    return (a.size() == 3 && (is_on_one_side(a, b) || is_beyond_edge(a, b))) ||
           (b.size() == 3 && (is_on_one_side(b, a) || is_beyond_edge(b, a)));
  }

  /// Whether two corners of a face are consecutive and are corners of the other face. Requires that
  /// there are two such corners.
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
  // For each number of a face: the face, its box, its triangle, and its corners with fans.
  std::vector<std::uint32_t> face_;
  std::vector<Box3> boxes_;
  std::vector<FilteredTriangle> triangles_;
  std::vector<Fans::Corners4> fan_corners_;
  std::vector<std::uint8_t> is_doubtful_;
  std::size_t checked_ = 0;            // The number of faces to be checked.
  std::vector<std::uint32_t> vertex_;  // The vertices of faces to be checked, as numbers.
  std::uint32_t vertices_ = 0;         // The number of these vertices.
  std::uint64_t pairs_left_ = 0;       // The number of pairs that may still be tested.
  std::uint64_t steps_left_ = 0;       // The number of steps that a packed tree may still take.
  DoubtfulFaces result_;
};

}  // namespace

std::vector<std::uint8_t> faces_at(const PolygonMesh& mesh,
                                   std::span<const std::uint8_t> is_chosen) {
  std::vector<std::uint8_t> result(mesh.face_count(), 0);
  for (std::size_t f = 0; f < result.size(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() == 3) {
      result[f] = is_chosen[face[0]] | is_chosen[face[1]] | is_chosen[face[2]];
    } else {
      for (const std::uint32_t v : face) result[f] |= is_chosen[v];
    }
  }
  return result;
}

DoubtfulFaces doubtful_faces(const PolygonMesh& mesh, std::span<const std::uint8_t> is_checked,
                             Context& context) {
  return DoubtSearch(mesh, is_checked, context).run();
}

}  // namespace plumb
