// Affine images: planes by the inverse transposed matrix, points by the matrix, and a correction of
// orientations.
//
// Everything but ids of planes and points stays: the image has the same cells and incidences. What
// changes is which side of a plane is positive, which way n_p x n_q runs along an edge, and, if the
// map reverses orientation, the sense of all rotations. The comment above image_of() has the signs.
//
// A framed set is mapped together with its far box, R scaled such that the image encloses the cube,
// and cut back to the cube; a shift leaves far planes where they are, which is right if the set
// meets the box in general position (docs/design/frame.md, "Affine maps: far boxes", Lemma 4).
//
// Tested by tests/space/transform_test.cpp.

#include "plumb/space/set/transform.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
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

/// Maps planes and points into a new table, each once. Points go to M x + t, and a plane n.x + d =
/// 0 to (n M^-1).x + d - (n M^-1).t = 0. The columns of M^-1 are the cross products of rows of M,
/// divided by the determinant. R goes to `far_scale` R, and far planes are not shifted (frame.h).
class Images {
 public:
  Images(const SpaceComplex& complex, const AffineMap3& map, Rational far_scale)
      : complex_(complex),
        map_(map),
        whole_map_(map),
        far_scale_(std::move(far_scale)),
        tables_(std::make_shared<SpaceTables>()),
        planes_(complex.planes().size()) {}

  Sign determinant() const { return whole_map_.determinant(); }
  std::shared_ptr<SpaceTables> tables() const { return tables_; }

  /// Returns the image of a plane, with the image of its positive side as its positive side.
  OrientedPlane operator()(PlaneId p) {
    OrientedPlane& image = planes_[p.value()];
    if (!image.is_valid()) image = image_of(p);
    return image;
  }

  /// Returns the image of a point: a point of three planes by their images, any other by its
  /// coordinates.
  SpacePoint operator()(SpacePoint p) {
    const Point3Table& points = complex_.points();
    const bool is_of_planes = !p.is_input() && !points.source(p).is_line();
    if (is_of_planes) {
      const PointSource& source = points.source(p);
      return tables_->points.add((*this)(source.plane(0)).plane(), (*this)(source.plane(1)).plane(),
                                 (*this)(source.plane(2)).plane());
    }
    return add_point(*tables_, whole_map_.image_of_point(homogeneous(points, p)));
  }

 private:
  OrientedPlane image_of(PlaneId p) {
    if (complex_.planes().is_frame(p)) return image_of_far(p);
    return intern_row(tables_->planes,
                      primitive(whole_map_.image_of_plane(complex_.planes().coefficients(p))));
  }
  /// A plane of the frame becomes a far plane: its offset scales with R and is not shifted.
  OrientedPlane image_of_far(PlaneId p) {
    const IntegerRow row = complex_.planes().primitive(p);
    const RationalRow n{Rational(row[0]), Rational(row[1]), Rational(row[2])};
    const RationalRow image =
        image_of_normal(n, cofactors(map_.matrix), plumb::determinant(map_.matrix));
    return far_plane(tables_->planes, image, row[3] * far_scale_);
  }

  const SpaceComplex& complex_;
  const AffineMap3& map_;
  IntegerMap whole_map_;
  Rational far_scale_;
  std::shared_ptr<SpaceTables> tables_;
  std::vector<OrientedPlane> planes_;
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
  for (SpacePoint& p : out.vertex_point) p = image(p);
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

/// Returns the image of a framed complex: cut to a box in general position, mapped, cut to the
/// cube.
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
