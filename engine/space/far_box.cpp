#include "plumb/space/far_box.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plumb/space/combine.h"

namespace plumb {
namespace {

/// What a function of marks makes of two is the first.
constexpr MarkFunction kFirst{false, true, false, true};

RationalRow normal_of(const PlaneTable& planes, PlaneId p) {
  const IntegerRow row = planes.coefficients(p);
  return {Rational(row[0]), Rational(row[1]), Rational(row[2])};
}

/// Are two of |n_i.d| equal and the largest?
bool runs_towards_edge(const RationalMatrix& normal, const RationalRow& d) {
  RationalRow reach;
  for (std::size_t i = 0; i < 3; ++i) reach[i] = abs(dot(normal[i], d));
  std::sort(reach.begin(), reach.end());
  return reach[1] == reach[2];
}

/// A plane with normal m holds a corner direction c, n_i.c = +1 or -1, if m.c = 0. With m as a
/// combination of the n_i: if its three coefficients add up to 0 for some signs.
bool holds_diagonal(const RationalMatrix& dual, const RationalRow& m) {
  RationalRow share;
  for (std::size_t i = 0; i < 3; ++i) share[i] = abs(dot(dual[i], m));
  std::sort(share.begin(), share.end());
  return share[0] + share[1] == share[2];
}

bool is_beyond(const SpaceComplex& c, VertexId v) { return c.vertex_mark[v.value()] == kBeyond; }

/// The planes of facets that reach the frame, each once.
std::vector<PlaneId> far_planes(const SpaceComplex& c) {
  std::vector<PlaneId> planes;
  for (std::uint32_t u = 0; u < c.use_count(); ++u) {
    const std::size_t f = c.use_facet[u].value();
    if (c.facet_mark[f] != kBeyond && is_beyond(c, c.use_origin(UseId(u)))) {
      planes.push_back(c.facet_plane[f]);
    }
  }
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  return planes;
}

/// Normals with small entries that look random, and larger ones at every try.
RationalMatrix some_normals(std::uint64_t attempt) {
  RationalMatrix normal;
  std::uint64_t state = attempt;
  for (RationalRow& row : normal) {
    for (Rational& x : row) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      x = static_cast<std::int64_t>(state >> 33U) %
          (std::int64_t{16} << std::min(attempt, std::uint64_t{24}));
    }
  }
  return normal;
}

/// Half as large as would still fit into the cube.
FarBox box_in_cube(const RationalMatrix& normal) {
  const RationalMatrix columns = cofactors(normal);
  Rational reach = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    reach = std::max(reach, sum_of_magnitudes({columns[0][j], columns[1][j], columns[2][j]}));
  }
  return {normal, abs(determinant(normal)) / (2 * reach)};
}

IntegerRow whole(const RationalRow& n, const Rational& d) {
  const Integer common =
      lcm(lcm(denominator(n[0]), denominator(n[1])), lcm(denominator(n[2]), denominator(d)));
  IntegerRow row;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational& x = i < 3 ? n[i] : d;
    row[i] = numerator(x) * (common / denominator(x));
  }
  return row;
}

bool is_framed_by(const SpaceComplex& c, PlaneId plane) {
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    if (c.facet_plane[f] == plane && c.facet_mark[f] == kBeyond) return true;
  }
  return false;
}

}  // namespace

// Of x_i + R and x_i - R comes n_i x_i + d R; of that and the plane n_j x_j + n_k x_k = 0 the rest.
OrientedPlane far_plane(PlaneTable& planes, const RationalRow& normal, const Rational& d) {
  const IntegerRow n = whole(normal, d);
  std::size_t i = 0;
  while (n[i] == 0) ++i;
  const std::array<PlaneId, 6> frame = planes.intern_frame();
  const OrientedPlane along_axis =
      planes.intern(Pencil{frame[2 * i], frame[2 * i + 1], n[3] - n[i], n[i] + n[3]});
  std::size_t j = i + 1;
  while (j < 3 && n[j] == 0) ++j;
  if (j == 3) return along_axis;
  IntegerRow rest = n;
  rest[i] = rest[3] = 0;
  const PlaneId first = along_axis.plane();
  const PlaneId second = planes.intern(0, Rational(rest[1]), Rational(rest[2]), 0).plane();
  const Integer a = planes.coefficients(first)[i], b = planes.coefficients(second)[j];
  const Integer sign = (a < 0) == (b < 0) ? 1 : -1;
  return planes.intern(Pencil{first, second, -sign * n[j] * a, sign * n[i] * b});
}

FarBox frame_box() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1}; }

bool is_general(const SpaceComplex& complex, const RationalMatrix& normal) {
  const PlaneTable& planes = complex.planes();
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.edge_mark[e] == kBeyond) continue;
    if (!is_beyond(complex, complex.origin[2 * e]) &&
        !is_beyond(complex, complex.origin[2 * e + 1])) {
      continue;
    }
    const auto& [p, q] = complex.edge_planes[e];
    if (runs_towards_edge(normal, cross(normal_of(planes, p), normal_of(planes, q)))) return false;
  }
  const RationalMatrix dual = cofactors(normal);
  for (const PlaneId p : far_planes(complex)) {
    if (holds_diagonal(dual, normal_of(planes, p))) return false;
  }
  return true;
}

FarBox general_box(const SpaceComplex& complex) {
  if (is_general(complex, frame_box().normal)) return frame_box();
  for (std::uint64_t attempt = 1;; ++attempt) {
    const RationalMatrix normal = some_normals(attempt);
    if (determinant(normal) != 0 && is_general(complex, normal)) return box_in_cube(normal);
  }
}

SpaceComplex inside(SpaceComplex complex, const FarBox& box,
                    const std::shared_ptr<SpaceTables>& tables, Context& context) {
  complex.tables = tables;
  for (std::uint64_t i = 0; i < 6; ++i) {
    context.checkpoint("far box", i, 6);
    const RationalRow& n = box.normal[i / 2];
    const Rational offset = i % 2 == 0 ? Rational(-box.size) : box.size;
    // n.x - s R <= 0, then n.x + s R >= 0
    const OrientedPlane plane = far_plane(tables->planes, n, offset);
    if (is_framed_by(complex, plane.plane())) continue;
    const PlaneSet outside = i % 2 == 0 ? PlaneSet::BeyondAbove : PlaneSet::BeyondBelow;
    complex = combine_with_plane(std::move(complex), plane, outside, kFirst, tables, context);
  }
  return complex;
}

}  // namespace plumb
