// Affine images: planes by the inverse transposed matrix, points by the matrix, and a correction of
// orientations.
//
// Only the ids of planes and points change: the image has the same cells and incidences. Three
// things may change: the positive side of a plane, the direction of n_p x n_q along an edge, and,
// if the map reverses orientation, the sense of all rotations. The comment above image_of() has the
// signs.
//
// A framed set is mapped together with its far box, R scaled such that the image encloses the cube,
// and cut back to the cube; a shift does not move far planes, which is right if the set meets the
// box in general position (docs/design/frame.md, "Affine maps: far boxes", Lemma 4).
//
// Tested by tests/space/transform_test.cpp.

#include "plumb/space/set/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/arithmetic/scaled.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/complex/tidy_tables.h"
#include "plumb/space/set/integer_map.h"

namespace plumb {
namespace {

/// Returns n M^-1, the image of a normal.
RationalRow image_of_normal(const RationalRow& n, const RationalMatrix& cofactors,
                            const Rational& determinant) {
  RationalRow image;
  for (std::size_t k = 0; k < 3; ++k) image[k] = dot(n, cofactors[k]) / determinant;
  return image;
}

/// A map, with doubles as numbers, in which each coordinate of the image depends on one coordinate.
/// Most maps that translate, mirror and scale along the axes are of this kind. It maps many points
/// to doubles.
class AxisMap {
 public:
  /// Returns the map, if it is of this kind and its numbers are doubles.
  static std::optional<AxisMap> of(const AffineMap3& map) {
    AxisMap result;
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalRow& row = map.matrix[k];
      if (std::count(row.begin(), row.end(), 0) != 2) return {};
      result.from_[k] = row[0] != 0 ? 0 : row[1] != 0 ? 1 : 2;
      result.factor_[k] = nearest_double(row[result.from_[k]]);
      result.offset_[k] = nearest_double(map.offset[k]);
      const bool is_exact = is_ordinary(result.factor_[k]) && is_ordinary(result.offset_[k]) &&
                            row[result.from_[k]] == result.factor_[k] &&
                            map.offset[k] == result.offset_[k];
      if (!is_exact) return {};
    }
    return result;
  }

  /// Returns the image of a point, if its coordinates are doubles.
  std::optional<Point3> operator()(const Point3& p) const {
    const std::array<double, 3> at{p.x, p.y, p.z};
    std::array<double, 3> image;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = at[from_[k]], m = factor_[k], t = offset_[k];
      const double y = m * x;
      if (!is_ordinary(x) || !is_ordinary(y)) return {};
      if (std::fma(m, x, -y) != 0) return {};
      // The rounding error of the sum (Knuth) is 0 if the sum is a double.
      image[k] = y + t;
      const double added = image[k] - y;
      if ((y - (image[k] - added)) + (t - added) != 0) return {};
    }
    return Point3{image[0], image[1], image[2]};
  }

 private:
  /// Whether x is 0, or so far from the ends of the range of doubles that the rounding error of a
  /// product or sum of two such numbers is a double.
  static bool is_ordinary(double x) {
    const double size = std::abs(x);
    return x == 0 || (size >= 0x1p-400 && size <= 0x1p400);
  }

  std::array<std::size_t, 3> from_{};
  std::array<double, 3> factor_{}, offset_{};
};

/// Maps planes and points into a new table, each once. Points go to M x + t, and a plane n.x + d =
/// 0 to (n M^-1).x + d - (n M^-1).t = 0. The columns of M^-1 are the cross products of rows of M,
/// divided by the determinant. R is mapped to `far_scale` R, and far planes are not shifted
/// (frame.h). A plane through three input points goes to the plane through their images, if the map
/// is an AxisMap that takes the three points to doubles: this needs no long numbers.
class Images {
 public:
  Images(const SpaceComplex& complex, const AffineMap3& map, Rational far_scale)
      : complex_(complex),
        map_(map),
        whole_map_(map),
        far_scale_(std::move(far_scale)),
        tables_(std::make_shared<SpaceTables>()),
        planes_(complex.planes().size()) {
    if (const std::optional<AxisMap> axis_map = AxisMap::of(map)) map_corners(*axis_map);
  }

  Sign determinant() const { return whole_map_.determinant(); }
  std::shared_ptr<SpaceTables> tables() const { return tables_; }

  /// Returns the image of a plane, with the image of its positive side as its positive side.
  OrientedPlane operator()(PlaneId p) {
    OrientedPlane& image = planes_[p.value()];
    if (!image.is_valid()) image = image_of(p);
    return image;
  }

  /// Returns the image of the point of a vertex: a point of three planes by their images, a point
  /// of a line and a plane by the planes at the vertex, any other by its coordinates.
  SpacePoint operator()(VertexId v) {
    const SpacePoint p = complex_.vertex_point[v];
    const Point3Table& points = complex_.points();
    if (p.is_input()) {
      const SpacePoint known = image_of_corner(p.input());
      if (known.is_valid()) return known;
    } else if (const PointSource& source = points.source(p); source.is_line()) {
      const SpacePoint image = image_of_line_point(source, v);
      if (image.is_valid()) return image;
    } else {
      return tables_->points.add((*this)(source.plane(0)).plane(), (*this)(source.plane(1)).plane(),
                                 (*this)(source.plane(2)).plane());
    }
    return add_point(*tables_, whole_map_.image_of_point(homogeneous(points, p)));
  }

 private:
  static constexpr std::size_t kSample = 16;

  OrientedPlane image_of(PlaneId p) {
    if (complex_.planes().is_frame(p)) return image_of_far(p);
    return intern_row(tables_->planes,
                      reduced(whole_map_.image_of_plane(complex_.planes().coefficients(p))));
  }
  /// Returns a row without a common factor, unless the first rows had none. Rows that were mapped
  /// by a map and by its inverse have one, and become longer with each map if it is not removed.
  /// Nearly all other rows have none, and the search for it takes longer than the map.
  IntegerRow reduced(IntegerRow row) {
    if (rows_seen_ >= kSample && !has_factors_) return row;
    ++rows_seen_;
    IntegerRow shorter = primitive(row);
    for (std::size_t i = 0; i < 4; ++i) {
      // Powers of two need no search, because tables of planes remove them.
      if (row[i].is_zero()) continue;
      const int lost = bit_length(row[i]) - trailing_zeros(row[i]) - bit_length(shorter[i]) +
                       trailing_zeros(shorter[i]);
      has_factors_ = has_factors_ || lost > kLongFactor;
    }
    return shorter;
  }
  // The unit is a bit. Many rows have a small factor by chance.
  static constexpr int kLongFactor = 20;

  /// A plane of the frame becomes a far plane: its offset scales with R and is not shifted.
  OrientedPlane image_of_far(PlaneId p) {
    const IntegerRow row = complex_.planes().primitive(p);
    const RationalRow n{Rational(row[0]), Rational(row[1]), Rational(row[2])};
    const RationalRow image =
        image_of_normal(n, cofactors(map_.matrix), plumb::determinant(map_.matrix));
    return far_plane(tables_->planes, image, row[3] * far_scale_);
  }

  /// Returns the image of an input point if it is known to be an input point.
  SpacePoint image_of_corner(InputPointId p) const {
    return corners_.empty() ? SpacePoint() : corners_[p.value()];
  }

  /// Returns the image of the point of a line and a plane. It is a point of a line if the images of
  /// the ends are input points; otherwise the planes of edges at the vertex define it.
  SpacePoint image_of_line_point(const PointSource& source, VertexId v) {
    const SpacePoint a = image_of_corner(source.end(0)), b = image_of_corner(source.end(1));
    if (a.is_valid() && b.is_valid()) {
      return tables_->points.add(a.input(), b.input(), (*this)(source.plane(0)).plane());
    }
    std::optional<std::array<PlaneId, 2>> first;
    for (const HalfedgeId h : complex_.star_of(v)) {
      const auto& pair = complex_.edge_planes[SpaceComplex::edge_of(h)];
      if (!first) {
        first = {(*this)(pair[0]).plane(), (*this)(pair[1]).plane()};
        continue;
      }
      for (const PlaneId plane : pair) {
        const PlaneId third = (*this)(plane).plane();
        if (third == (*first)[0] || third == (*first)[1]) continue;
        const SpacePoint image = tables_->points.add((*first)[0], (*first)[1], third);
        if (image.is_valid()) return image;
      }
    }
    return {};
  }

  /// Maps the input points that vertices or planes of the complex need, and then the planes all of
  /// whose corners have doubles as images.
  void map_corners(const AxisMap& map) {
    const PlaneTable& planes = complex_.planes();
    corners_.resize(planes.points().size());
    std::vector<std::uint8_t> is_seen(corners_.size(), 0);
    const auto image = [&](InputPointId p) {
      if (std::exchange(is_seen[p.value()], 1) == 0) {
        if (const std::optional<Point3> at = map(planes.point(p))) {
          corners_[p.value()] = SpacePoint(tables_->planes.add_point(*at));
        }
      }
      return corners_[p.value()];
    };
    std::vector<std::uint8_t> is_used(planes.size(), 0);
    const auto use = [&](PlaneId p) { is_used[p.value()] = 1; };
    for (const PlaneId p : complex_.facet_plane) use(p);
    for (const auto& pair : complex_.edge_planes) {
      for (const PlaneId p : pair) use(p);
    }
    for (const SpacePoint p : complex_.vertex_point) {
      if (p.is_input()) {
        image(p.input());
        continue;
      }
      const PointSource& source = complex_.points().source(p);
      for (std::size_t i = 0; i < source.plane_count(); ++i) use(source.plane(i));
      for (std::size_t i = 0; source.is_line() && i < 2; ++i) image(source.end(i));
    }
    intern_corners(is_used, image);
  }

  template <class Image>
  void intern_corners(const std::vector<std::uint8_t>& is_used, const Image& image) {
    std::vector<std::array<InputPointId, 3>> triangles;
    std::vector<std::uint32_t> ids;
    for (std::uint32_t p = 0; p < is_used.size(); ++p) {
      const PlaneSource& source = complex_.planes().source(PlaneId(p));
      if (is_used[p] == 0 || source.is_explicit()) continue;
      std::array<SpacePoint, 3> at;
      for (std::size_t i = 0; i < 3; ++i) at[i] = image(InputPointId(source.code[i]));
      if (!at[0].is_valid() || !at[1].is_valid() || !at[2].is_valid()) continue;
      // A map that reverses orientation makes the corners clockwise.
      if (determinant() == Sign::Negative) std::swap(at[1], at[2]);
      triangles.push_back({at[0].input(), at[1].input(), at[2].input()});
      ids.push_back(p);
    }
    std::vector<OrientedPlane> found(triangles.size());
    tables_->planes.intern_triangles(triangles, found);
    for (std::size_t i = 0; i < ids.size(); ++i) planes_[ids[i]] = found[i];
  }

  const SpaceComplex& complex_;
  const AffineMap3& map_;
  IntegerMap whole_map_;
  Rational far_scale_;
  std::shared_ptr<SpaceTables> tables_;
  std::vector<OrientedPlane> planes_;
  // The images of input points. An id is invalid if the image is not known.
  std::vector<SpacePoint> corners_;
  std::size_t rows_seen_ = 0;  // The number of rows in which a common factor was searched.
  bool has_factors_ = false;   // Whether one of these rows had a long factor.
};

/// Reverses the uses of facets whose plane is now seen from its other side.
void reverse_uses(SpaceComplex& c, const std::vector<std::uint8_t>& is_reversed) {
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    if (is_reversed[c.use_facet[u].value()] == 0) continue;
    c.use_halfedge[u] = SpaceComplex::twin(c.use_halfedge[u]);
    std::swap(c.use_next[u], c.use_prev[u]);
  }
}

/// Reverses the radial order around every edge.
void reverse_radial(SpaceComplex& c) {
  std::vector<UseId> before(c.use_count());
  for (std::size_t u = 0; u < c.use_count(); ++u) before[c.use_radial[u].value()] = UseId(u);
  c.use_radial = std::move(before);
}

// An edge along d = n_p x n_q goes to M d, and (M^-T n_p) x (M^-T n_q) = M d / det M. A facet lies
// to the left of d, in the direction n x d, as seen from n; its image is seen from M^-T n, and
// ((M^-T n) x (M d)).(M (n x d)) has the sign of det M: the same side if the image of n is the
// canonical normal and the map keeps orientation, or neither.
SpaceComplex image_of(const SpaceComplex& complex, Images& image, Context& context) {
  SpaceComplex out = complex;
  out.tables = image.tables();
  context.checkpoint("transform", 0, 3);
  for (std::size_t v = 0; v < out.vertex_count(); ++v)
    out.vertex_point[VertexId(v)] = image(VertexId(v));
  context.checkpoint("transform", 1, 3);
  for (auto& [p, q] : out.edge_planes) {
    const OrientedPlane first = image(p), second = image(q);
    p = first.plane();
    q = second.plane();
    const Sign along = image.determinant() * first.orientation() * second.orientation();
    if (along == Sign::Negative) std::swap(p, q);
  }
  context.checkpoint("transform", 2, 3);
  std::vector<std::uint8_t> is_reversed(out.facet_count(), 0);
  for (std::size_t f = 0; f < out.facet_count(); ++f) {
    const OrientedPlane plane = image(out.facet_plane[f]);
    out.facet_plane[f] = plane.plane();
    if (plane.is_opposite()) std::swap(out.facet_volume[f][0], out.facet_volume[f][1]);
    is_reversed[f] = image.determinant() * plane.orientation() == Sign::Negative ? 1 : 0;
  }
  reverse_uses(out, is_reversed);
  if (image.determinant() == Sign::Negative) reverse_radial(out);
  return out;
}

/// Returns the scale of R under which the image of a far box encloses the cube: the one that makes
/// it the cube itself if there is one, else twice as large as needed.
Rational enclosing_scale(const FarBox& box, const AffineMap3& map) {
  const RationalMatrix dual = cofactors(map.matrix);
  const Rational det = determinant(map.matrix);
  Rational largest = 0;
  bool is_cube = true;
  for (const RationalRow& n : box.normal) {
    const RationalRow image = image_of_normal(n, dual, det);
    const Rational reach = sum_of_magnitudes(image);
    is_cube &= std::count(image.begin(), image.end(), 0) == 2 && (largest == 0 || largest == reach);
    largest = std::max(largest, reach);
  }
  return (is_cube ? 1 : 2) * largest / box.size;
}

/// Whether the map has no translation.
bool is_linear(const AffineMap3& map) {
  return std::count(map.offset.begin(), map.offset.end(), 0) == 3;
}

/// Returns the image of a framed complex. The complex is cut to a box in general position, mapped,
/// and cut to the cube.
SpaceComplex framed_image(const SpaceComplex& complex, const AffineMap3& map, Context& context) {
  const FarBox box = is_linear(map) ? frame_box() : general_box(complex);
  const SpaceComplex cut = inside(complex, box, copy(*complex.tables), context);
  Images images(cut, map, enclosing_scale(box, map));
  SpaceComplex image = image_of(cut, images, context);
  return with_used_tables(inside(std::move(image), frame_box(), images.tables(), context));
}

}  // namespace

SpaceComplex transformed(const SpaceComplex& complex, const AffineMap3& map, Context& context) {
  if (determinant(map.matrix) == 0) {
    throw Error(ErrorCode::BadArgument, "the matrix of the map is singular");
  }
  if (has_frame(complex)) return framed_image(complex, map, context);
  Images images(complex, map, 1);
  return image_of(complex, images, context);
}

}  // namespace plumb
