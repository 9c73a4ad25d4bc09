#include "plumb/space/transform.h"

#include <array>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/frame.h"

namespace plumb {
namespace {

using Row = std::array<Rational, 3>;
using Matrix = std::array<Row, 3>;

Rational dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Row cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Points go to M x + t, and a plane n.x + d = 0 to (n M^-1).x + d - (n M^-1).t = 0. Of M^-1 the columns are
/// the cross products of rows of M, divided by the determinant.
class Images {
 public:
  Images(const SpaceComplex& complex, const AffineMap3& map)
      : complex_(complex), map_(map), tables_(std::make_shared<SpaceTables>()) {
    const Matrix& m = map.matrix;
    cofactors_ = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    determinant_ = dot(m[0], cofactors_[0]);
    if (determinant_ == 0) throw Error(ErrorCode::BadArgument, "the matrix of the map is singular");
    planes_.resize(complex.planes().size());
  }

  Sign determinant() const { return sign_of(determinant_); }
  std::shared_ptr<SpaceTables> tables() const { return tables_; }

  /// With the side that was positive.
  OrientedPlane operator()(PlaneId p) {
    OrientedPlane& image = planes_[p.value()];
    if (!image.is_valid()) image = image_of(p);
    return image;
  }

  SpacePoint operator()(SpacePoint p) {
    const Point3Table& points = complex_.points();
    const bool is_of_planes = !p.is_input() && !points.source(p).is_line();
    if (is_of_planes) {
      const PointSource& source = points.source(p);
      return tables_->points.add((*this)(source.plane(0)).plane(), (*this)(source.plane(1)).plane(),
                                 (*this)(source.plane(2)).plane());
    }
    const RationalPoint3 at = exact(points, p);
    const Row from{at.x, at.y, at.z};
    return add_point(*tables_, {dot(map_.matrix[0], from) + map_.offset[0],
                                dot(map_.matrix[1], from) + map_.offset[1],
                                dot(map_.matrix[2], from) + map_.offset[2]});
  }

 private:
  OrientedPlane image_of(PlaneId p) {
    const IntegerRow row = complex_.planes().primitive(p);
    const Row n{Rational(row[0]), Rational(row[1]), Rational(row[2])};
    Row image;
    for (std::size_t k = 0; k < 3; ++k) image[k] = dot(n, cofactors_[k]) / determinant_;
    const Rational d = Rational(row[3]) - dot(image, map_.offset);
    return tables_->planes.intern(image[0], image[1], image[2], d);
  }

  const SpaceComplex& complex_;
  const AffineMap3& map_;
  std::shared_ptr<SpaceTables> tables_;
  Matrix cofactors_;
  Rational determinant_;
  std::vector<OrientedPlane> planes_;
};

/// The uses of a facet whose plane is now seen from its other side.
void reverse_uses(SpaceComplex& c, const std::vector<std::uint8_t>& is_reversed) {
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    if (is_reversed[c.use_facet[u].value()] == 0) continue;
    c.use_halfedge[u] = SpaceComplex::twin(c.use_halfedge[u]);
    std::swap(c.use_next[u], c.use_prev[u]);
  }
}

void reverse_radial(SpaceComplex& c) {
  std::vector<UseId> before(c.use_count());
  for (std::size_t u = 0; u < c.use_count(); ++u) before[c.use_radial[u].value()] = UseId(u);
  c.use_radial = std::move(before);
}

}  // namespace

// An edge along d = n_p x n_q goes to M d, and (M^-T n_p) x (M^-T n_q) = M d / det M. A facet lies to the left
// of d, in the direction n x d, as seen from n; its image is seen from M^-T n, and
// ((M^-T n) x (M d)).(M (n x d)) has the sign of det M: the same side if the image of n is the canonical
// normal and the map keeps orientation, or neither.
SpaceComplex transformed(const SpaceComplex& complex, const AffineMap3& map, Context& context) {
  if (has_frame(complex)) {
    throw Error(ErrorCode::BadArgument,
                "facets or edges that reach to infinity cannot be mapped yet");
  }
  Images image(complex, map);
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

}  // namespace plumb
