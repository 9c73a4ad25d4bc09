// Facets that need no overlay: those that lie in one source triangle, or are a face of a source.
//
// A facet is whole if its plane has no source triangle, or one that contains all of its vertices.
// Most vertices are corners of the triangle by definition, which is known without arithmetic. A
// facet is a face of a source if its corners are the corners of the face, in the same cyclic order
// or in the opposite one. If the attributes may differ between the triangles of the face, the facet
// is divided into these triangles.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/whole_facets.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

/// Whether a point is known to be a corner of a triangle without arithmetic.
bool is_known_corner(const CutState& state, const SourceTriangle& triangle,
                     const CornerPoints& corners, SpacePoint p) {
  if (p.is_input()) {
    const std::array<InputPointId, 3>& input = triangle.input;
    if (std::find(input.begin(), input.end(), p.input()) != input.end()) return true;
    return corner_index(corners, state.tables().planes.point(p.input())) < 3;
  }
  std::size_t i = 0;
  while (i < 3 && !state.sources.has_definition_of(triangle, i, p)) ++i;
  return i < 3;
}

/// Whether all vertices of a facet are input points that are known as corners of a triangle.
bool has_only_corners(const SpaceComplex& c, FacetId f, const SourceTriangle& triangle) {
  bool is_corner = true;
  for_each_use(c, f, [&](UseId u) {
    const SpacePoint p = c.vertex_point[c.use_origin(u)];
    is_corner = is_corner && p.is_input() &&
                (p.input() == triangle.input[0] || p.input() == triangle.input[1] ||
                 p.input() == triangle.input[2]);
  });
  return is_corner;
}

/// Whether all vertices of a facet lie in a triangle of its plane. Vertices that are corners of the
/// triangle need no arithmetic; in general position most vertices are.
bool is_in_triangle(CutState& state, FacetId f, const SourceTriangle& triangle) {
  if (has_only_corners(state.complex(), f, triangle)) return true;
  state.sources.place_if_moved(triangle);
  const SpaceComplex& c = state.complex();
  const CornerPoints corners = state.sources.corner_points(triangle);
  // The points, and the edges that contain them.
  std::vector<std::pair<SpacePoint, std::size_t>> others;
  for_each_use(c, f, [&](UseId u) {
    const SpacePoint p = c.vertex_point[c.use_origin(u)];
    if (is_known_corner(state, triangle, corners, p)) return;
    others.emplace_back(p, state.sources.edge_of(triangle, corners, p));
  });
  if (others.empty()) return true;
  std::array<SpacePoint, 3> places{};
  for (std::size_t i = 0; i < 3; ++i) places[i] = state.sources.place(triangle, i);
  FlatPoints shown(state.tables().points);
  shown.reset(FlatView::of_plane(state.tables().planes, triangle.plane));
  for (const SpacePoint p : places) shown.push_back(p);
  const Sign turn = shown.orient(0, 1, 2);
  for (const auto& [p, edge] : others) {
    const std::uint32_t v = shown.size();
    shown.push_back(p);
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (i != edge && shown.orient(i, (i + 1) % 3, v) == -turn) return false;
    }
  }
  return true;
}

/// Returns the uses of a facet if it has only one cycle, with at most `most` uses, and no vertices
/// inside; otherwise nothing.
std::vector<UseId> short_cycle(const SpaceComplex& c, FacetId f, std::size_t most) {
  if (c.cycles_of(f).size() != 1 || !c.inner_of(f).empty()) return {};
  std::vector<UseId> uses;
  const UseId first = c.cycles_of(f)[0];
  UseId u = first;
  do {
    if (uses.size() == most) return {};
    uses.push_back(u);
    u = c.use_next[u];
  } while (u != first);
  return uses;
}

/// If the facet is exactly a face of a source and its corners are doubles, returns the use of the
/// facet at each corner of the face; otherwise nothing.
std::vector<UseId> uses_at_corners(CutState& state, FacetId f, const SourceTriangle& t) {
  const SpaceComplex& c = state.complex();
  const auto corners = state.sources.mesh_of(t).face(t.face);
  const std::size_t n = corners.size();
  std::vector<UseId> uses = short_cycle(c, f, n);
  if (uses.size() != n) return {};
  const auto is_at = [&](UseId u, std::uint32_t point) {
    const SpacePoint p = c.vertex_point[c.use_origin(u)];
    const Point3* const at = state.sources.doubles(t.source, point);
    return p.is_input() && at != nullptr && state.tables().planes.point(p.input()) == *at;
  };
  std::size_t first = 0;
  while (first < n && !is_at(uses[first], corners[0])) ++first;
  if (first == n) return {};
  std::rotate(uses.begin(), uses.begin() + static_cast<std::ptrdiff_t>(first), uses.end());
  if (!is_at(uses[1], corners[1])) std::reverse(uses.begin() + 1, uses.end());
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_at(uses[i], corners[i])) return {};
  }
  return uses;
}

/// Whether all triangles come from one face of a source.
bool are_of_one_face(const SourceTriangles& sources, TriangleRange triangles) {
  const SourceTriangle& first = sources[triangles.first];
  for (std::uint32_t t = triangles.first; t != triangles.end; ++t) {
    if (sources[t].source != first.source || sources[t].face != first.face) return false;
  }
  return true;
}

std::uint32_t add_piece(CutState& state, const FacetSide& side, std::uint32_t triangle) {
  const bool is_flipped =
      triangle != kNone && state.sources[triangle].is_opposite != side.is_reversed;
  state.pieces.push_back({side.facet, triangle, is_flipped, PieceCover::Triangle});
  return static_cast<std::uint32_t>(state.pieces.size() - 1);
}

void add_whole(CutState& state, const FacetSide& side, std::uint32_t triangle) {
  const std::uint32_t piece = add_piece(state, side, triangle);
  state.regions.push_back(
      {piece, side.is_reversed, state.complex().facet_plane[side.facet], kNone});
}

/// Adds the triangles of a face of a source as regions of a facet that is this face. `uses` are
/// those of uses_at_corners().
void add_triangles_of_face(CutState& state, const FacetSide& side, std::span<const UseId> uses,
                           TriangleRange triangles) {
  const SpaceComplex& c = state.complex();
  const PlaneId plane = c.facet_plane[side.facet];
  for (std::uint32_t t = triangles.first; t != triangles.end; ++t) {
    const SourceTriangle& triangle = state.sources[t];
    const std::uint32_t begin = state.sources.mesh_of(triangle).face_begin[triangle.face];
    std::array<UseId, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = uses[triangle.corner[i] - begin];
    // The corners are counter-clockwise seen from outside of the set that the source bounds.
    const bool runs_along = c.use_next[uses[0]] == uses[1];
    if (!runs_along) std::swap(at[1], at[2]);
    std::vector<RegionEdge> edges;
    for (std::size_t i = 0; i < 3; ++i) {
      const UseId from = at[i], to = at[(i + 1) % 3];
      const bool is_side = c.use_next[from] == to;
      edges.push_back({c.use_origin(from), c.use_origin(to),
                       is_side ? SpaceComplex::edge_of(c.use_halfedge[from]) : EdgeId()});
    }
    const std::uint32_t piece = add_piece(state, side, t);
    state.add_region(piece, side.is_reversed, plane, {std::move(edges), {}});
  }
}

/// Adds the regions of a facet that is exactly one polygon of a source, whose triangles are given.
/// Returns false for any other facet.
bool add_untouched(CutState& state, const FacetSide& side, TriangleRange triangles) {
  const SourceTriangle& first = state.sources[triangles.first];
  if (state.sources.is_plane(first) || !are_of_one_face(state.sources, triangles)) return false;
  const std::vector<UseId> uses = uses_at_corners(state, side.facet, first);
  if (uses.empty()) return false;
  const bool is_joined = state.options.join != PieceJoin::None;
  const bool stays_polygon = state.options.faces != MeshFaces::Triangles && is_joined;
  if ((has_channels(state, first) || !is_joined) && !stays_polygon) {
    add_triangles_of_face(state, side, uses, triangles);
    return true;
  }
  add_whole(state, side, triangles.first);
  state.pieces.back().cover = PieceCover::Face;
  return true;
}

}  // namespace

bool add_without_overlay(CutState& state, const FacetSide& side) {
  const TriangleRange near = state.sources.in_plane(state.complex().facet_plane[side.facet]);
  if (near.is_empty()) {
    add_whole(state, side, kNone);
    return true;
  }
  if (near.size() > 1) return add_untouched(state, side, near);
  const SourceTriangle& only = state.sources[near.first];
  if (!state.sources.is_plane(only) && !is_in_triangle(state, side.facet, only)) return false;
  add_whole(state, side, near.first);
  return true;
}

bool add_triangles_of_cut_face(CutState& state, const Region& region) {
  const BoundaryPiece piece = state.pieces[region.piece];
  if (piece.cover != PieceCover::Face) return false;
  const SourceTriangle& first = state.sources[piece.triangle];
  if (!has_channels(state, first)) return false;
  const auto triangles = state.sources.in_plane(region.plane);
  const std::vector<UseId> uses = uses_at_corners(state, piece.facet, first);
  add_triangles_of_face(state, {piece.facet, region.is_reversed}, uses, triangles);
  return true;
}

}  // namespace plumb
