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
#include "plumb/space/set/fixed_map.h"
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
/// divided by the determinant. R goes to `far_scale` R, and far planes are not shifted (frame.h).
/// A plane through three input points goes to the plane through their images, if the map is an
/// AxisMap that takes the three points to doubles: this needs no long numbers. Other planes and
/// input points are mapped by a FixedMap, and what is too long for it by the IntegerMap.
class Images {
 public:
  Images(const SpaceComplex& complex, const AffineMap3& map, Rational far_scale)
      : complex_(complex),
        map_(map),
        whole_map_(map),
        far_scale_(std::move(far_scale)),
        tables_(std::make_shared<SpaceTables>()),
        planes_(complex.planes().size()),
        corners_(complex.planes().points().size()) {
    if (const std::optional<AxisMap> axis_map = AxisMap::of(map)) map_corners(*axis_map);
    has_factors_ = rows_have_factors();
    if (has_factors_) return;
    if (const std::optional<FixedMap> fixed_map = FixedMap::of(whole_map_)) map_ahead(*fixed_map);
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
      if (!across_.empty() && across_[v][0].is_valid()) {
        return tables_->points.add(across_[v][0], across_[v][1], across_[v][2]);
      }
    } else if (const PointSource& source = points.source(p); source.is_line()) {
      const SpacePoint image = image_of_line_point(source, v);
      if (image.is_valid()) return image;
    } else {
      std::array<PlaneId, 3> planes;
      for (std::size_t i = 3; i-- > 0;) planes[i] = (*this)(source.plane(i)).plane();
      return tables_->points.add(planes[0], planes[1], planes[2]);
    }
    return add_point(*tables_, whole_map_.image_of_point(homogeneous(points, p)));
  }

 private:
  static constexpr std::size_t kBlock = 64;  // Planes for one inversion. They stay in the cache.

  OrientedPlane image_of(PlaneId p) {
    if (complex_.planes().is_frame(p)) return image_of_far(p);
    IntegerRow row = whole_map_.image_of_plane(complex_.planes().coefficients(p));
    const bool is_reduced = has_factors_ || is_across_axis(p);
    return intern_row(tables_->planes, is_reduced ? primitive(row) : std::move(row));
  }

  /// Whether a plane is across an axis, as far as doubles tell. The numbers of its image have a
  /// common factor that comes from the map alone.
  bool is_across_axis(PlaneId p) const {
    const auto& n = complex_.planes().row(p).n;
    return std::count(n.begin(), n.end(), 0) == 2;
  }

  /// Whether half of the rows have a long common factor, as rows have after a map and its inverse;
  /// they become longer with each map if it stays. Nearly all other rows have none, and the search
  /// for it takes longer than the map. So it is searched in some rows only.
  bool rows_have_factors() const {
    constexpr std::size_t kSample = 16;
    constexpr int kLongFactor = 20;  // Bits. Many rows have a small factor by chance.
    const PlaneTable& planes = complex_.planes();
    const std::size_t step = std::max<std::size_t>(complex_.facet_count() / kSample, 1);
    std::size_t seen = 0, found = 0;
    for (std::size_t f = 0; f < complex_.facet_count(); f += step) {
      const PlaneId p = complex_.facet_plane[f];
      if (planes.is_frame(p) || is_across_axis(p)) continue;
      Integer common = 0;
      for (const Integer& x : whole_map_.image_of_plane(planes.coefficients(p))) {
        common = gcd(common, x);
      }
      // Powers of two cost nothing, as tables of planes take them out.
      ++seen;
      found += bit_length(common) - trailing_zeros(common) > kLongFactor ? 1 : 0;
    }
    return found > 0 && 2 * found >= seen;
  }

  /// A plane of the frame becomes a far plane: its offset scales with R and is not shifted.
  OrientedPlane image_of_far(PlaneId p) {
    const IntegerRow row = complex_.planes().primitive(p);
    const RationalRow n{Rational(row[0]), Rational(row[1]), Rational(row[2])};
    const RationalRow image =
        image_of_normal(n, cofactors(map_.matrix), plumb::determinant(map_.matrix));
    return far_plane(tables_->planes, image, row[3] * far_scale_);
  }

  /// Returns the image of an input point if it is known to be an input point.
  SpacePoint image_of_corner(InputPointId p) const { return corners_[p.value()]; }
  /// Whether the ends of a line are known to go to input points.
  bool has_known_ends(const PointSource& source) const {
    return image_of_corner(source.end(0)).is_valid() && image_of_corner(source.end(1)).is_valid();
  }

  /// Returns the image of the point of a line and a plane. It is a point of a line if the images of
  /// the ends are input points; otherwise the planes of edges at the vertex define it.
  SpacePoint image_of_line_point(const PointSource& source, VertexId v) {
    if (has_known_ends(source)) {
      return tables_->points.add(image_of_corner(source.end(0)).input(),
                                 image_of_corner(source.end(1)).input(),
                                 (*this)(source.plane(0)).plane());
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

  /// Maps planes and input points in blocks, in the order in which image_of() will ask for them. An
  /// image of a point whose coordinates are not doubles is the common point of three planes across
  /// the axes. Points with too many bits for the map are left out.
  void map_ahead(const FixedMap& map) {
    Block block(planes_.size());
    for (std::size_t v = 0; v < complex_.vertex_count(); ++v) {
      const SpacePoint p = complex_.vertex_point[VertexId(v)];
      if (p.is_input()) {
        map_point(map, VertexId(v), p.input(), block);
      } else {
        map_planes_of(map, complex_.points().source(p), VertexId(v), block);
      }
    }
    for (const auto& pair : complex_.edge_planes) {
      for (const PlaneId p : pair) map_plane(map, p, block);
    }
    for (const PlaneId p : complex_.facet_plane) map_plane(map, p, block);
    intern(block);
  }

  /// Planes that are interned together, and what they are for.
  struct Block {
    explicit Block(std::size_t planes) : is_queued(planes, 0) {}

    std::vector<exact3::LongPlane> images;
    std::vector<OrientedPlane*> result;   // A plane of planes_, or null.
    std::vector<PlaneId*> across;         // A plane of across_, or null.
    std::vector<std::uint8_t> is_queued;  // For each plane.
  };

  void intern(Block& block) {
    std::vector<OrientedPlane> found(block.images.size());
    tables_->planes.intern_coefficients(block.images, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (block.result[i] != nullptr) *block.result[i] = found[i];
      if (block.across[i] != nullptr) *block.across[i] = found[i].plane();
    }
    block.images.clear();
    block.result.clear();
    block.across.clear();
  }

  void add(const exact3::LongPlane& image, OrientedPlane* result, PlaneId* across, Block& block) {
    block.images.push_back(image);
    block.result.push_back(result);
    block.across.push_back(across);
    if (block.images.size() == kBlock) intern(block);
  }

  void map_plane(const FixedMap& map, PlaneId p, Block& block) {
    if (planes_[p.value()].is_valid() || complex_.planes().is_frame(p)) return;
    if (std::exchange(block.is_queued[p.value()], 1) != 0) return;
    exact3::LongPlane image;
    if (map.image_of_plane(exact3::operand(complex_.planes(), p), image)) {
      add(image, &planes_[p.value()], nullptr, block);
    } else {
      intern(block);  // Keeps the order.
      planes_[p.value()] = image_of(p);
    }
  }

  /// Maps the planes that define the image of a constructed point.
  void map_planes_of(const FixedMap& map, const PointSource& source, VertexId v, Block& block) {
    if (!source.is_line() || has_known_ends(source)) {
      for (std::size_t i = source.plane_count(); i-- > 0;) map_plane(map, source.plane(i), block);
      return;
    }
    const std::array<PlaneId, 2>* first = nullptr;
    for (const HalfedgeId h : complex_.star_of(v)) {
      const auto& pair = complex_.edge_planes[SpaceComplex::edge_of(h)];
      if (first == nullptr) first = &pair;
      for (const PlaneId p : pair) {
        map_plane(map, p, block);
        if (p != (*first)[0] && p != (*first)[1]) return;
      }
    }
  }

  void map_point(const FixedMap& map, VertexId v, InputPointId p, Block& block) {
    if (!map.maps_points() || image_of_corner(p).is_valid()) return;
    FixedMap::Point image;
    if (!map.image_of_point(complex_.planes().point(p), complex_.planes().grid(p), image)) return;
    if (const std::optional<Point3> at = image.as_doubles()) {
      corners_[p.value()] = SpacePoint(tables_->planes.add_point(*at));
      return;
    }
    if (across_.empty()) across_.resize(complex_.vertex_count());
    for (std::size_t k = 0; k < 3; ++k) {
      add(image.plane_across(k), nullptr, &across_[v][k], block);
    }
  }

  const SpaceComplex& complex_;
  const AffineMap3& map_;
  IntegerMap whole_map_;
  Rational far_scale_;
  std::shared_ptr<SpaceTables> tables_;
  std::vector<OrientedPlane> planes_;
  std::vector<SpacePoint> corners_;  // Images of input points; not valid if not known.
  // For vertices at input points whose images are no input points: planes across the axes.
  IdVector<VertexId, std::array<PlaneId, 3>> across_;
  bool has_factors_ = false;  // Whether rows have a long common factor.
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
