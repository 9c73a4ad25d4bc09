// This file adds the cube, drops the cube, and cuts a complex to a far box.
//
// Adding the cube adds 8 vertices whose maps are known; the vertices of the set go into the draft
// with their own maps and twins, so no predicate is needed before the complex is assembled.
// Dropping it copies all vertices but those of the cube.
//
// Far planes are made as pencils of planes of the frame and planes through the origin, so that R
// occurs in the column of offsets only and every sign stays linear in R (docs/design/frame.md,
// Lemma 2). A box in general position is found by trying the cube, then random normals with growing
// entries: bad normals lie on finitely many surfaces. Lemma 4 of that page proves that a shift of a
// set in general position does not change the traces on the box.
//
// Tested by tests/space/transform_test.cpp and tests/space/nef3_test.cpp.

#include "plumb/space/boolean/frame.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "plumb/predicates/error.h"
#include "plumb/space/boolean/assemble.h"
#include "plumb/space/boolean/boolean_op.h"
#include "plumb/space/local_maps.h"

namespace plumb {

namespace {

/// Adds the vertices that `is_kept` accepts to the draft, each with its map, and pairs the
/// half-edges between them. Requires that no edge leads from an accepted vertex to another one.
template <class IsKept>
void copy_vertices(const SpaceComplex& complex, IsKept is_kept, SpaceDraft& draft,
                   Context& context) {
  IdVector<HalfedgeId, std::uint32_t> point_of(complex.origin.size(), kNone);
  std::vector<std::uint32_t> origin_ids;
  LocalMap local;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    if (v % 4096 == 0) context.checkpoint("frame", v, complex.vertex_count());
    if (!is_kept(VertexId(v))) continue;
    local_map(complex, VertexId(v), local);
    origin_ids.clear();
    for (const FacetId f : local.facet) origin_ids.push_back(complex.facet_origin[f]);
    const auto offsets = draft.add(complex.vertex_point[v], local.map, false, origin_ids);
    for (std::uint32_t i = 0; i < local.halfedge.size(); ++i) {
      point_of[local.halfedge[i]] = offsets.point + i;
    }
  }
  // Both ends of an edge were added, so that they can face each other.
  for (std::uint32_t h = 0; h < point_of.size(); ++h) {
    if (point_of[h] != kNone) draft.twin[point_of[h]] = point_of[h ^ 1U];
  }
}

/// A corner of the cube: for each axis, whether it lies at +R.
using Corner = std::array<bool, 3>;

/// Returns the map of a corner. Point k leads along axis k, arc k lies in the plane of axis k; face
/// 0 is the inside of the cube, face 1 the beyond. `plane` has the plane of each axis at this
/// corner.
SphereMap corner_map(const Corner& corner, const std::array<PlaneId, 3>& plane, Mark inside) {
  SphereMap map;
  map.centre_mark = kBeyond;
  map.face_mark = {inside, kBeyond};
  map.origin.resize(6);
  map.next.resize(6);
  map.face.resize(6);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t i = (k + 1) % 3, j = (k + 2) % 3;
    // All frame planes have the axis as their normal, so n_i x n_j has the direction +k. The edge
    // leads inwards, which is against the axis if the corner lies at +R.
    const SphereDirection along{plane[i], plane[j]};
    map.direction.push_back(corner[k] ? along.opposite() : along);
    map.point_mark.push_back(kBeyond);
    map.point_face.push_back(kNone);
    map.circle.push_back(plane[k]);
    map.arc_mark.push_back(kBeyond);
    // Seen from +k, the arc is counter-clockwise from axis i to axis j if both edges have the same
    // direction along their axes. Otherwise, it is counter-clockwise from j to i.
    const bool is_turned = corner[i] != corner[j];
    map.origin[2 * k] = is_turned ? j : i;
    map.origin[2 * k + 1] = is_turned ? i : j;
    map.face[2 * k] = corner[k] ? 1 : 0;
    map.face[2 * k + 1] = corner[k] ? 0 : 1;
  }
  // Each face has three half-arcs, one along each arc. Therefore the next half-arc of a face is the
  // only one that starts where this one ends.
  map.first_out.resize(3);
  for (std::uint32_t h = 0; h < 6; ++h) {
    map.first_out[map.origin[h]] = h;
    for (std::uint32_t g = 0; g < 6; ++g) {
      if (g / 2 != h / 2 && map.face[g] == map.face[h] && map.origin[g] == map.target(h)) {
        map.next[h] = g;
      }
    }
  }
  return map;
}

/// Adds the 8 corners of the cube. Edge k of corner c leads to the corner that differs in bit k.
void add_cube(SpaceDraft& draft, SpaceTables& tables, Mark inside) {
  const std::array<PlaneId, 6> frame = tables.planes.intern_frame();
  const std::array<std::uint32_t, 3> no_origins{kNone, kNone, kNone};
  std::array<std::uint32_t, 8> first{};
  for (std::uint32_t c = 0; c < 8; ++c) {
    const Corner corner{(c & 1U) != 0, (c & 2U) != 0, (c & 4U) != 0};
    std::array<PlaneId, 3> plane;
    for (std::size_t k = 0; k < 3; ++k) plane[k] = frame[2 * k + (corner[k] ? 1 : 0)];
    const SpacePoint at = tables.points.add(plane[0], plane[1], plane[2]);
    first[c] = draft.add(at, corner_map(corner, plane, inside), false, no_origins).point;
  }
  for (std::uint32_t c = 0; c < 8; ++c) {
    for (std::uint32_t k = 0; k < 3; ++k) draft.twin[first[c] + k] = first[c ^ (1U << k)] + k;
  }
}

}  // namespace

bool has_frame(const SpaceComplex& complex) {
  return !complex.volume_mark.empty() && complex.volume_mark[0] == kBeyond;
}

std::vector<std::uint8_t> unbounded_volumes(const SpaceComplex& complex) {
  IdVector<VolumeId, std::uint8_t> is_far(complex.volume_count(), 0);
  if (!is_far.empty()) is_far[0] = 1;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    if (complex.facet_mark[f] != kBeyond) continue;
    for (const VolumeId v : complex.facet_volume[f]) is_far[v] = 1;
  }
  return is_far;
}

SpaceComplex with_frame(const SpaceComplex& complex, const std::shared_ptr<SpaceTables>& tables,
                        Context& context) {
  SpaceDraft draft(tables);
  copy_vertices(
      complex, [](VertexId) { return true; }, draft, context);
  add_cube(draft, *tables, complex.volume_mark[0]);
  return assemble(std::move(draft), context);
}

namespace {

/// Whether an edge or facet of the set ends on the frame.
bool is_reached(const SpaceComplex& c) {
  const auto is_beyond = [&c](std::size_t h) { return c.vertex_mark[c.origin[h]] == kBeyond; };
  for (std::size_t h = 0; h < c.origin.size(); ++h) {
    if (c.edge_mark[h / 2] != kBeyond && is_beyond(h)) return true;
  }
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    if (c.facet_mark[c.use_facet[u]] != kBeyond && is_beyond(c.use_halfedge[u].value())) {
      return true;
    }
  }
  return false;
}

}  // namespace

SpaceComplex without_idle_frame(SpaceComplex complex, Context& context) {
  if (!has_frame(complex)) return complex;
  const auto is_kept = [&complex](VertexId v) { return complex.vertex_mark[v] != kBeyond; };
  if (is_reached(complex)) return complex;
  // If there are no cells inside, the result has no vertices, and the mark of the whole space is
  // the mark of the volume in the cube.
  Mark inside = kBeyond;
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    for (const VolumeId v : complex.facet_volume[f]) {
      if (complex.facet_mark[f] == kBeyond && v != VolumeId(0)) {
        inside = complex.volume_mark[v];
      }
    }
  }
  SpaceDraft draft(complex.tables);
  copy_vertices(complex, is_kept, draft, context);
  SpaceComplex result = assemble(std::move(draft), context);
  if (result.vertex_count() == 0) result.volume_mark[0] = inside;
  return result;
}

namespace {

/// The function of two marks that returns the first.
constexpr MarkFunction kFirst{false, true, false, true};

/// Returns the normal of a plane, up to a factor.
RationalRow normal_of(const PlaneTable& planes, PlaneId p) {
  const IntegerRow row = planes.coefficients(p);
  return {Rational(row[0]), Rational(row[1]), Rational(row[2])};
}

/// Whether a line of direction d leaves the box through an edge. This is the case if the two
/// largest of |n_i.d| are equal, because the line then reaches both sides at the same distance.
bool runs_towards_edge(const RationalMatrix& normal, const RationalRow& d) {
  RationalRow reach;
  for (std::size_t i = 0; i < 3; ++i) reach[i] = abs(dot(normal[i], d));
  std::sort(reach.begin(), reach.end());
  return reach[1] == reach[2];
}

/// Whether a plane with normal m is parallel to a diagonal c of the box, n_i.c = +1 or -1, that is
/// m.c = 0. Let m = sum of a_i n_i; then m.c = sum of +-a_i, which is 0 for some signs if and only
/// if the largest |a_i| is the sum of the two others. The a_i are computed up to one common factor.
bool holds_diagonal(const RationalMatrix& dual, const RationalRow& m) {
  RationalRow share;
  for (std::size_t i = 0; i < 3; ++i) share[i] = abs(dot(dual[i], m));
  std::sort(share.begin(), share.end());
  return share[0] + share[1] == share[2];
}

/// Whether a vertex lies on the frame.
bool is_beyond(const SpaceComplex& c, VertexId v) { return c.vertex_mark[v] == kBeyond; }

/// Returns the planes of all facets that reach the frame, ascending, each once.
std::vector<PlaneId> far_planes(const SpaceComplex& c) {
  std::vector<PlaneId> planes;
  for (std::uint32_t u = 0; u < c.use_count(); ++u) {
    const FacetId f = c.use_facet[u];
    if (c.facet_mark[f] != kBeyond && is_beyond(c, c.use_origin(UseId(u)))) {
      planes.push_back(c.facet_plane[f]);
    }
  }
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  return planes;
}

/// Returns pseudorandom normals whose entries x grow with each attempt: 0 <= x < 16 *
/// 2^min(attempt, 24). A linear congruential generator makes them, so results are reproducible.
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

/// Returns the box with these normals that is half as large as the largest one that fits into the
/// cube. The box |n_i.x| <= s has the corners x = N^-1 c for c_i = +-s. Their j-th coordinate is at
/// most s times the sum of magnitudes of row j of N^-1 = cofactors / determinant.
FarBox box_in_cube(const RationalMatrix& normal) {
  const RationalMatrix columns = cofactors(normal);
  Rational reach = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    reach = std::max(reach, sum_of_magnitudes({columns[0][j], columns[1][j], columns[2][j]}));
  }
  return {normal, abs(determinant(normal)) / (2 * reach)};
}

/// Returns n and d, times their common denominator.
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

/// Whether the plane is one of the sides of the frame that the complex has.
bool is_framed_by(const SpaceComplex& c, PlaneId plane) {
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    if (c.facet_plane[f] == plane && c.facet_mark[f] == kBeyond) return true;
  }
  return false;
}

}  // namespace

// The planes x_i + R = 0 and x_i - R = 0 of the frame span a pencil with n_i x_i + d R = 0. That
// plane and the plane n_j x_j + n_k x_k = 0 through the origin span a pencil with the wanted one.
// Interning scales rows, so the factors of the second pencil use the coefficients a and b that the
// two rows have in the table.
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

// Edges that reach the frame must not have the direction of an edge of the box, and planes of
// facets that reach it must not contain a diagonal.
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

// An attempt fails with small probability, because the bad normals lie on finitely many surfaces,
// and the range of entries doubles each time.
FarBox general_box(const SpaceComplex& complex) {
  if (is_general(complex, frame_box().normal)) return frame_box();
  for (std::uint64_t attempt = 1;; ++attempt) {
    const RationalMatrix normal = some_normals(attempt);
    if (determinant(normal) != 0 && is_general(complex, normal)) return box_in_cube(normal);
  }
}

// A side that is already a side of the frame cuts off no part, and is skipped.
SpaceComplex inside(SpaceComplex complex, const FarBox& box,
                    const std::shared_ptr<SpaceTables>& tables, Context& context) {
  complex.tables = tables;
  for (std::uint64_t i = 0; i < 6; ++i) {
    context.checkpoint("far box", i, 6);
    const RationalRow& n = box.normal[i / 2];
    const Rational offset = i % 2 == 0 ? Rational(-box.size) : box.size;
    // First n.x - s R <= 0 is kept, then n.x + s R >= 0.
    const OrientedPlane plane = far_plane(tables->planes, n, offset);
    if (is_framed_by(complex, plane.plane())) continue;
    const PlaneSet outside = i % 2 == 0 ? PlaneSet::BeyondAbove : PlaneSet::BeyondBelow;
    complex = boolean_op_with_plane(std::move(complex), plane, outside, kFirst, tables, context);
  }
  return complex;
}

}  // namespace plumb
