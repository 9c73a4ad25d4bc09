// The audit finds every kind of damage, and names it.
#include "plumb/space/space_audit.h"

#include <gtest/gtest.h>

#include <functional>
#include <stop_token>

#include "generate/meshes.h"
#include "generate/space_scenes.h"
#include "generate/space_solids.h"
#include "oracle/nef3_check.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/from_mesh.h"

namespace plumb::testing::space_audit_test {
namespace {

// ---------------------------------------------------------------- complexes to damage

Nef3 solid(const MeshLeaf& mesh) { return to_nef(*space_set(mesh)); }
Nef3 cube() { return solid(box({0, 0, 0}, {2, 2, 2})); }
Nef3 segment(const ExactPoint3& a, const ExactPoint3& b) {
  return to_nef(*space_set(ChainsLeaf{{{a, b}}}));
}
Nef3 point(const ExactPoint3& p) { return to_nef(*space_set(PointsLeaf{{p}})); }

// A cube with a sheet at one side, an antenna on top, a point missing from another side, and a
// point in the air.
SpaceComplex decorated_cube() {
  const Nef3 sheet = to_nef(*space_set(rectangle({2, 0, 0}, {4, 2, 0}, 2, 1)));
  return (cube() + sheet + segment({1, 1, 2}, {1, 1, 4}) + point({5, 5, 5}) - point({0, 1, 1}))
      .complex();
}
// Two plates side by side, each with a square hole and a mark beside it.
SpaceComplex plates() {
  Nef3 result;
  for (const int shift : {0, 5}) {
    const ExactPoint3 by{shift, 0, 0};
    const Nef3 plate = solid(moved(box({0, 0, 0}, {4, 4, 1}), by));
    const Nef3 hole = solid(moved(box({1, 1, 0}, {2, 2, 1}), by));
    result += plate - hole - point(ExactPoint3{3, 3, 1} + by);
  }
  return result.complex();
}
SpaceComplex cubes_at_an_edge() { return (cube() + solid(box({2, 2, 0}, {3, 3, 2}))).complex(); }
// A triangle that stands with one corner on a sheet.
SpaceComplex balanced_triangle() {
  return (to_nef(*space_set(rectangle({-4, -4, 0}, {4, 4, 0}, 2, 0))) +
          to_nef(*space_set(PolygonLeaf{{{0, 0, 0}, {1, 0, 1}, {-1, 0, 1}}})))
      .complex();
}
SpaceComplex half_space() { return to_nef(*testing::half_space(1, 1, 1, -1)).complex(); }

// ---------------------------------------------------------------- finding and making items

using Damage = std::function<void(SpaceComplex&)>;

std::uint32_t first_where(std::size_t count, const std::function<bool(std::uint32_t)>& is_it) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (is_it(i)) return i;
  }
  ADD_FAILURE() << "the complex has no such item";
  return 0;
}
// `count` when there is none.
std::uint32_t first_or(std::uint32_t count, const std::function<bool(std::uint32_t)>& is_it) {
  std::uint32_t i = 0;
  while (i < count && !is_it(i)) ++i;
  return i;
}
std::uint32_t free_edge(const SpaceComplex& c) {
  return first_where(c.edge_count(), [&](std::uint32_t e) { return !c.edge_use[e].is_valid(); });
}
std::uint32_t bound_edge(const SpaceComplex& c) {
  return first_where(c.edge_count(), [&](std::uint32_t e) { return c.edge_use[e].is_valid(); });
}
std::uint32_t inner_vertex(const SpaceComplex& c) {
  return first_where(c.vertex_count(), [&](std::uint32_t v) {
    return c.vertex_facet[v].is_valid() && c.star_of(VertexId(v)).empty();
  });
}
std::uint32_t lone_vertex(const SpaceComplex& c) {
  return first_where(c.vertex_count(),
                     [&](std::uint32_t v) { return c.vertex_volume[v].is_valid(); });
}
std::uint32_t sheet(const SpaceComplex& c) {
  return first_where(c.facet_count(),
                     [&](std::uint32_t f) { return c.facet_volume[f][0] == c.facet_volume[f][1]; });
}
std::uint32_t facet_with_holes(const SpaceComplex& c, std::uint32_t from = 0) {
  return first_where(c.facet_count(), [&](std::uint32_t f) {
    return f >= from && c.cycles_of(FacetId(f)).size() == 2;
  });
}
std::size_t ring_size(const SpaceComplex& c, UseId u) {
  std::size_t n = 0;
  UseId w = u;
  do {
    ++n;
    w = c.use_radial[w.value()];
  } while (w != u);
  return n;
}
std::uint32_t vertex_at(const SpaceComplex& c, const ExactPoint3& p) {
  return first_where(c.vertex_count(), [&](std::uint32_t v) {
    return exact_of(exact(c.points(), c.vertex_point[v])) == p;
  });
}

SpaceTables& own_tables(SpaceComplex& c) {
  const std::shared_ptr<SpaceTables> tables = copy(*c.tables);
  c.tables = tables;
  return *tables;
}

VertexId add_vertex(SpaceComplex& c, const ExactPoint3& p) {
  c.vertex_point.push_back(add_point(own_tables(c), to_rational(p)));
  c.vertex_mark.push_back(1);
  c.vertex_volume.push_back(VolumeId(0));
  c.vertex_facet.emplace_back();
  c.star_begin.push_back(c.star_begin.back());
  return VertexId(c.vertex_count() - 1);
}

void add_to_star(SpaceComplex& c, HalfedgeId h) {
  const std::size_t v = c.origin[h.value()].value();
  c.star.insert(c.star.begin() + c.star_begin[v + 1], h);
  for (std::size_t w = v + 1; w < c.star_begin.size(); ++w) ++c.star_begin[w];
  c.vertex_volume[v] = VolumeId();
}

ExactPoint3 place(const SpaceComplex& c, VertexId v) {
  return exact_of(exact(c.points(), c.vertex_point[v.value()]));
}

// The planes of an edge, with these normals.
std::array<PlaneId, 2> planes_along(SpaceComplex& c, VertexId from, VertexId to,
                                    const std::array<ExactPoint3, 2>& normals) {
  PlaneTable& planes = own_tables(c).planes;
  std::array<PlaneId, 2> through;
  bool is_turned = dot(cross(normals[0], normals[1]), place(c, to) - place(c, from)) < 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Plane3 plane = to_plane(plane_at(place(c, from), normals[i]));
    const OrientedPlane oriented = planes.intern(plane.a, plane.b, plane.c, plane.d);
    through[i] = oriented.plane();
    is_turned = is_turned != oriented.is_opposite();
  }
  if (is_turned) std::swap(through[0], through[1]);
  return through;
}

void add_free_edge(SpaceComplex& c, VertexId from, VertexId to, const ExactPoint3& n,
                   const ExactPoint3& m) {
  c.edge_planes.push_back(planes_along(c, from, to, {n, m}));
  c.edge_mark.push_back(1);
  c.edge_use.emplace_back();
  c.edge_volume.push_back(VolumeId(0));
  for (const VertexId v : {from, to}) {
    c.origin.push_back(v);
    add_to_star(c, HalfedgeId(c.origin.size() - 1));
  }
}

// To a place whose lines to the neighbours lie in planes of these normals.
void move_vertex(SpaceComplex& c, VertexId v, const ExactPoint3& p, const ExactPoint3& n) {
  c.vertex_point[v.value()] = add_point(own_tables(c), to_rational(p));
  for (const HalfedgeId h : c.star_of(v)) {
    const VertexId from = c.origin[h.value() & ~1U], to = c.origin[h.value() | 1U];
    c.edge_planes[h.value() / 2] =
        planes_along(c, from, to, {n, cross(place(c, to) - place(c, from), n)});
  }
}

template <class Id>
void erase_row(std::vector<std::uint32_t>& begin, std::vector<Id>& list, std::size_t from,
               std::size_t to) {
  const std::vector<Id> moved(list.begin() + begin[from], list.begin() + begin[from + 1]);
  list.erase(list.begin() + begin[from], list.begin() + begin[from + 1]);
  list.insert(list.begin() + begin[to + 1], moved.begin(), moved.end());
  for (std::size_t f = to + 1; f <= from; ++f) begin[f] += static_cast<std::uint32_t>(moved.size());
  begin.erase(begin.begin() + static_cast<std::ptrdiff_t>(from) + 1);
}

// Two facets of one plane become one.
void merge_coplanar_facets(SpaceComplex& c) {
  std::uint32_t to = 0;
  const std::uint32_t from = first_where(c.facet_count(), [&](std::uint32_t f) {
    to = first_or(f, [&](std::uint32_t g) { return c.facet_plane[f] == c.facet_plane[g]; });
    return to != f;
  });
  const auto renumbered = [&](FacetId f) {
    if (!f.is_valid() || f.value() < from) return f;
    return f.value() == from ? FacetId(to) : FacetId(f.value() - 1);
  };
  for (FacetId& f : c.use_facet) f = renumbered(f);
  for (FacetId& f : c.vertex_facet) f = renumbered(f);
  erase_row(c.cycle_begin, c.cycle, from, to);
  erase_row(c.inner_begin, c.inner, from, to);
  c.facet_plane.erase(c.facet_plane.begin() + from);
  c.facet_mark.erase(c.facet_mark.begin() + from);
  c.facet_volume.erase(c.facet_volume.begin() + from);
  c.facet_origin.erase(c.facet_origin.begin() + from);
}

// ---------------------------------------------------------------- damage

struct Row {
  const char* invariant;
  SpaceComplex (*complex)();
  Damage damage;
};

std::vector<Row> damaged_links() {
  return {
      {"arrays have one entry for each item", decorated_cube,
       [](SpaceComplex& c) { c.vertex_mark.pop_back(); }},
      {"there is a volume", [] { return Nef3().complex(); },
       [](SpaceComplex& c) { c.volume_mark.clear(); }},
      {"lists cover their arrays", decorated_cube, [](SpaceComplex& c) { c.star.pop_back(); }},
      {"marks are 0, 1 or beyond", decorated_cube, [](SpaceComplex& c) { c.edge_mark[0] = 3; }},
      {"a vertex has a point", decorated_cube,
       [](SpaceComplex& c) { c.vertex_point[0] = SpacePoint(); }},
      {"an edge has two planes", decorated_cube,
       [](SpaceComplex& c) { c.edge_planes[0][1] = PlaneId(); }},
      {"a facet has a plane", decorated_cube,
       [](SpaceComplex& c) { c.facet_plane[0] = PlaneId(c.planes().size()); }},
      {"ids name items that are there", decorated_cube,
       [](SpaceComplex& c) { c.use_next[0] = UseId(c.use_count()); }},
      {"ids name items that are there", decorated_cube,
       [](SpaceComplex& c) { c.use_prev[1] = UseId(); }},
      {"an edge has two ends", decorated_cube, [](SpaceComplex& c) { c.origin[1] = c.origin[0]; }},
      {"a star holds what leaves its vertex", decorated_cube,
       [](SpaceComplex& c) { std::swap(c.star.front(), c.star.back()); }},
      {"a star lists a half-edge once", decorated_cube,
       [](SpaceComplex& c) {
         const std::size_t first = c.star_begin[c.origin[2 * bound_edge(c)].value()];
         c.star[first + 1] = c.star[first];
       }},
      {"prev undoes next", decorated_cube,
       [](SpaceComplex& c) { std::swap(c.use_next[0], c.use_next[1]); }},
      {"a use starts where the one before ends", decorated_cube,
       [](SpaceComplex& c) {
         const std::uint32_t after = c.use_next[0].value();
         std::swap(c.use_next[0], c.use_next[after]);
         for (const std::uint32_t u : {0U, after}) c.use_prev[c.use_next[u].value()] = UseId(u);
       }},
      {"a cycle stays with its facet", decorated_cube,
       [](SpaceComplex& c) { c.use_facet[0] = FacetId(c.use_facet[0].value() == 0 ? 1 : 0); }},
      {"a radial cycle stays at its edge", decorated_cube,
       [](SpaceComplex& c) { std::swap(c.use_radial[0], c.use_radial[c.use_next[0].value()]); }},
      {"a radial cycle returns to its start", decorated_cube,
       [](SpaceComplex& c) {
         const UseId second = c.use_radial[c.edge_use[bound_edge(c)].value()];
         c.use_radial[second.value()] = second;
       }},
      {"the radial cycle of an edge has all its uses", decorated_cube,
       [](SpaceComplex& c) {
         const UseId first = c.edge_use[bound_edge(c)];
         c.use_radial[first.value()] = first;
       }},
      {"a facet has a boundary", decorated_cube, [](SpaceComplex& c) { c.cycle_begin[1] = 0; }},
      {"a facet lists its own cycles", decorated_cube,
       [](SpaceComplex& c) { std::swap(c.cycle[0], c.cycle[1]); }},
      {"a facet lists a cycle once", plates,
       [](SpaceComplex& c) {
         const std::size_t at = c.cycle_begin[facet_with_holes(c)];
         c.cycle[at + 1] = c.use_next[c.cycle[at].value()];
       }},
      {"each use is on a cycle of its facet", plates,
       [](SpaceComplex& c) {
         const std::uint32_t f = facet_with_holes(c);
         c.cycle.erase(c.cycle.begin() + c.cycle_begin[f] + 1);
         for (std::size_t g = f + 1; g < c.cycle_begin.size(); ++g) --c.cycle_begin[g];
       }},
      {"a facet lists the vertices inside it", decorated_cube,
       [](SpaceComplex& c) { c.vertex_facet[c.inner[0].value()] = FacetId(); }},
      {"a facet lists an inner vertex once", decorated_cube,
       [](SpaceComplex& c) {
         const VertexId v = c.inner[0];
         const std::size_t f = c.vertex_facet[v.value()].value();
         c.inner.insert(c.inner.begin(), v);
         for (std::size_t g = f + 1; g < c.inner_begin.size(); ++g) ++c.inner_begin[g];
       }},
      {"a vertex inside a facet is listed there", decorated_cube,
       [](SpaceComplex& c) { c.vertex_facet[lone_vertex(c)] = FacetId(0); }},
      {"an edge has uses or lies in a volume", decorated_cube,
       [](SpaceComplex& c) { c.edge_volume[bound_edge(c)] = VolumeId(0); }},
      {"a vertex alone lies in a volume", decorated_cube,
       [](SpaceComplex& c) { c.vertex_volume[lone_vertex(c)] = VolumeId(); }},
  };
}

std::vector<Row> damaged_places() {
  return {
      {"vertices have different points", decorated_cube,
       [](SpaceComplex& c) { c.vertex_point[lone_vertex(c)] = c.vertex_point[0]; }},
      {"the planes of an edge cross", decorated_cube,
       [](SpaceComplex& c) { c.edge_planes[0][1] = c.edge_planes[0][0]; }},
      {"the ends of an edge lie on its planes", decorated_cube,
       [](SpaceComplex& c) {
         c.vertex_point[c.origin[0].value()] = add_point(own_tables(c), {7, 8, 9});
       }},
      {"an edge runs as its planes say", cubes_at_an_edge,
       [](SpaceComplex& c) {
         const UseId u(first_where(c.use_count(),
                                   [&](std::uint32_t w) { return ring_size(c, UseId(w)) == 2; }));
         auto& planes = c.edge_planes[c.use_halfedge[u.value()].value() / 2];
         std::swap(planes[0], planes[1]);
       }},
      {"an edge runs as its planes say", decorated_cube,
       [](SpaceComplex& c) { std::swap(c.edge_planes[3][0], c.edge_planes[3][1]); }},
      {"the edges of a facet lie in its plane", decorated_cube,
       [](SpaceComplex& c) {
         c.facet_plane[0] = c.facet_plane[first_where(c.facet_count(), [&](std::uint32_t f) {
           return c.facet_plane[f] != c.facet_plane[0];
         })];
       }},
      {"facets turn counter-clockwise around an edge", decorated_cube,
       [](SpaceComplex& c) {
         const UseId a(first_where(c.use_count(),
                                   [&](std::uint32_t u) { return ring_size(c, UseId(u)) == 3; }));
         const UseId b = c.use_radial[a.value()], d = c.use_radial[b.value()];
         c.use_radial[a.value()] = d;
         c.use_radial[d.value()] = b;
         c.use_radial[b.value()] = a;
       }},
      {"edges leave a vertex in different directions", decorated_cube,
       [](SpaceComplex& c) {
         add_free_edge(c, VertexId(vertex_at(c, {1, 1, 2})), VertexId(vertex_at(c, {1, 1, 4})),
                       {1, 0, 0}, {0, 1, 0});
       }},
      {"a corner turns to the next edge in its plane", decorated_cube,
       [](SpaceComplex& c) {
         add_free_edge(c, VertexId(vertex_at(c, {0, 0, 0})), VertexId(vertex_at(c, {2, 2, 0})),
                       {0, 0, 1}, {1, -1, 0});
       }},
      {"a vertex inside a facet lies in its plane", decorated_cube,
       [](SpaceComplex& c) {
         const std::uint32_t v = lone_vertex(c);
         c.vertex_volume[v] = VolumeId();
         c.vertex_facet[v] = FacetId(0);
         c.inner.insert(c.inner.begin(), VertexId(v));
         for (std::size_t g = 1; g < c.inner_begin.size(); ++g) ++c.inner_begin[g];
       }},
      {"no corner passes the facet around its vertex", balanced_triangle,
       [](SpaceComplex& c) {
         move_vertex(c, VertexId(vertex_at(c, {1, 0, 1})), {2, 0, -1}, {0, 1, 0});
       }},
      {"no edge leaves a vertex within the facet around it", decorated_cube,
       [](SpaceComplex& c) {
         add_free_edge(c, VertexId(inner_vertex(c)), add_vertex(c, {0, 9, 1}), {1, 0, 0},
                       {0, 0, 1});
       }},
  };
}

std::vector<Row> damaged_cycles() {
  return {
      {"cycles of a facet have no common vertex", cubes_at_an_edge, merge_coplanar_facets},
      {"a cycle after the first runs around a hole", plates, merge_coplanar_facets},
      {"the first cycle runs around its facet", plates,
       [](SpaceComplex& c) {
         const std::size_t at = c.cycle_begin[facet_with_holes(c)];
         std::swap(c.cycle[at], c.cycle[at + 1]);
       }},
      {"an inner vertex lies inside its facet", plates,
       [](SpaceComplex& c) {
         const VertexId v = c.inner[0], w = c.inner[1];
         std::swap(c.vertex_facet[v.value()], c.vertex_facet[w.value()]);
         std::swap(c.inner[0], c.inner[1]);
       }},
      {"a hole lies in its facet and in no other hole", plates,
       [](SpaceComplex& c) {
         const std::uint32_t f = facet_with_holes(c);
         const std::uint32_t g = first_where(c.facet_count(), [&](std::uint32_t i) {
           return i > f && c.facet_plane[i] == c.facet_plane[f];
         });
         UseId& one = c.cycle[c.cycle_begin[f] + 1];
         UseId& two = c.cycle[c.cycle_begin[g] + 1];
         for (const auto& [cycle, facet] : {std::pair{one, g}, std::pair{two, f}}) {
           UseId u = cycle;
           do {
             c.use_facet[u.value()] = FacetId(facet);
             u = c.use_next[u.value()];
           } while (u != cycle);
         }
         std::swap(one, two);
       }},
  };
}

std::vector<Row> damaged_meetings() {
  return {
      {"no vertex lies inside an edge", decorated_cube,
       [](SpaceComplex& c) {
         add_vertex(c, {1, 0, 0});
       }},
      {"no vertex lies inside a facet unlisted", decorated_cube,
       [](SpaceComplex& c) {
         add_vertex(c, {1, 1, 0});
       }},
      {"edges do not cross", decorated_cube,
       [](SpaceComplex& c) {
         const VertexId from = add_vertex(c, {0, 1, 3});
         add_free_edge(c, from, add_vertex(c, {2, 1, 3}), {0, 1, 0}, {0, 0, 1});
       }},
      {"no edge passes through a facet", decorated_cube,
       [](SpaceComplex& c) {
         const VertexId from = add_vertex(c, {{3, 2}, 1, 1});
         add_free_edge(c, from, add_vertex(c, {{3, 2}, 1, 3}), {1, 0, 0}, {0, 1, 0});
       }},
  };
}

std::vector<Row> damaged_marks() {
  return {
      {"volumes are the connected parts between facets", decorated_cube,
       [](SpaceComplex& c) { std::swap(c.facet_volume[0][0], c.facet_volume[0][1]); }},
      {"volumes are the connected parts between facets", decorated_cube,
       [](SpaceComplex& c) { c.edge_volume[free_edge(c)] = VolumeId(1); }},
      {"volumes are the connected parts between facets", decorated_cube,
       [](SpaceComplex& c) { c.volume_mark.push_back(0); }},
      {"only volume 0 is beyond", decorated_cube,
       [](SpaceComplex& c) { c.volume_mark[1] = kBeyond; }},
      {"facets of the frame, and no others, have the beyond on one side", decorated_cube,
       [](SpaceComplex& c) { c.facet_mark[0] = kBeyond; }},
      {"edges of the frame, and no others, bound its facets", half_space,
       [](SpaceComplex& c) { c.edge_mark[0] = 1; }},
      {"vertices of the frame, and no others, are ends of its edges", half_space,
       [](SpaceComplex& c) { c.vertex_mark[0] = 1; }},
      {"nothing is in the beyond",
       [] {
         return segment({0, 0, 0}, {1, 0, 0}).complex();
       },
       [](SpaceComplex& c) { c.volume_mark[0] = kBeyond; }},
      {"a frame is there only if something reaches it", [] { return cube().complex(); },
       [](SpaceComplex& c) {
         Context context;
         const std::shared_ptr<SpaceTables> tables = copy(*c.tables);
         c = with_frame(c, tables, context);
       }},
      {"no item can go without changing the set", decorated_cube,
       [](SpaceComplex& c) { c.facet_mark[sheet(c)] = 0; }},
      {"no item can go without changing the set", decorated_cube,
       [](SpaceComplex& c) { c.edge_mark[free_edge(c)] = 0; }},
      {"no item can go without changing the set", decorated_cube,
       [](SpaceComplex& c) { c.vertex_mark[lone_vertex(c)] = 0; }},
  };
}

// ---------------------------------------------------------------- facets that cross

// The facets of a mesh as they are, whatever they cross.
SpaceComplex raw_facets(const std::vector<Chain3>& faces) {
  PolygonMesh mesh;
  for (const Chain3& face : faces) {
    std::vector<std::uint32_t> corners;
    for (const ExactPoint3& p : face) {
      corners.push_back(static_cast<std::uint32_t>(mesh.points.size()));
      EXPECT_TRUE(as_double(p, mesh.points.emplace_back()));
    }
    mesh.add_face(corners);
  }
  MeshOptions options;
  options.surface = true;
  Context context;
  SpaceComplex c = complex_of_mesh(mesh, options, context).complex;
  c.volume_mark = {0};
  c.facet_volume.assign(c.facet_count(), {VolumeId(0), VolumeId(0)});
  c.edge_volume.assign(c.edge_count(), VolumeId());
  c.vertex_volume.assign(c.vertex_count(), VolumeId());
  return c;
}

const char* found_in(const std::vector<Chain3>& faces, std::optional<SpaceFlaw>& flaw) {
  flaw = audit(raw_facets(faces), AuditForm::Any);
  return flaw ? flaw->invariant.c_str() : "";
}

TEST(SpaceAudit, FindsWhereFacetsCross) {
  struct CrossingRow {
    const char* invariant;
    std::vector<Chain3> faces;
  };
  const Chain3 flat{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const CrossingRow rows[] = {
      {"", {flat, {{0, 0, 0}, {4, 0, 0}, {2, 0, 3}}}},
      {"", {flat, {{4, 4, 0}, {5, 5, 0}, {5, 6, 0}}}},
      // Two squares around one diagonal: no edge meets anything.
      {"corners do not cross", {flat, {{0, 0, 0}, {2, 2, 3}, {4, 4, 0}, {2, 2, -3}}}},
      {"no edge passes through a facet", {flat, {{1, 1, -1}, {2, 1, 1}, {1, 2, 1}}}},
      {"edges do not cross", {flat, {{-1, 1, -1}, {1, 1, 1}, {1, 1, 3}}}},
      {"edges do not cross", {flat, {{2, 2, 0}, {6, 1, 0}, {6, 3, 0}}}},
      {"no vertex lies inside an edge", {flat, {{2, 0, 0}, {3, -1, 1}, {1, -1, 1}}}},
      {"no vertex lies inside a facet unlisted", {flat, {{2, 2, 0}, {3, 1, 1}, {1, 1, 1}}}},
      {"no vertex lies inside a facet unlisted", {flat, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}},
      {"a corner turns to the next edge in its plane", {flat, {{0, 0, 0}, {2, 1, 0}, {1, 2, 0}}}},
      {"facets turn counter-clockwise around an edge", {flat, {{0, 0, 0}, {4, 0, 0}, {2, 6, 0}}}},
  };
  for (const CrossingRow& row : rows) {
    std::optional<SpaceFlaw> flaw;
    EXPECT_STREQ(found_in(row.faces, flaw), row.invariant) << (flaw ? flaw->place : "");
  }
}

// Neither shows where a vertex or an edge is tested against a facet that it does not bound.
TEST(SpaceAudit, FindsAFacetThatMeetsItself) {
  const auto flaw_of = [](const std::vector<RationalPoint3>& corners) -> std::string {
    SpaceScene scene;
    scene.add_facet(corners);
    const auto flaw = audit(complex_of(scene), AuditForm::Any);
    return flaw ? flaw->invariant : "";
  };
  const auto at = [](int x, int y) { return rational_point(x, y, 0); };
  EXPECT_EQ(flaw_of({at(0, 0), at(4, 0), at(4, 4), at(2, 1), at(0, 4)}), "");
  EXPECT_EQ(flaw_of({at(0, 0), at(4, 0), at(4, 4), at(2, 0), at(0, 4)}),
            "no vertex lies inside an edge");
  EXPECT_EQ(flaw_of({at(0, 0), at(4, 0), at(4, 4), at(2, -1), at(0, 4)}), "edges do not cross");
}

// ---------------------------------------------------------------- tests

void expect_named(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    SCOPED_TRACE(row.invariant);
    SpaceComplex c = row.complex();
    const std::optional<SpaceFlaw> before = audit(c, AuditForm::Minimal);
    ASSERT_FALSE(before) << before->invariant << " at " << before->place;
    row.damage(c);
    const std::optional<SpaceFlaw> flaw = audit(c, AuditForm::Minimal);
    ASSERT_TRUE(flaw);
    EXPECT_EQ(flaw->invariant, row.invariant) << "at " << flaw->place;
    EXPECT_NE(flaw->place, "");
  }
}

TEST(SpaceAudit, NamesDamagedLinks) { expect_named(damaged_links()); }
TEST(SpaceAudit, NamesDamagedPlaces) { expect_named(damaged_places()); }
TEST(SpaceAudit, NamesDamagedCycles) { expect_named(damaged_cycles()); }
TEST(SpaceAudit, NamesDamagedMeetings) { expect_named(damaged_meetings()); }
TEST(SpaceAudit, NamesDamagedMarks) { expect_named(damaged_marks()); }

/// Fingerprints are residues modulo 2^61 - 1, for which 2^61 is 1.
TEST(SpaceAudit, TellsItemsOfOneFingerprintApart) {
  Nef3 result;
  const BigRational much = std::int64_t{1} << 61;
  for (const BigRational& x : {BigRational(1), much, BigRational(much * much)}) {
    result += point({x, 0, 0}) + segment({x, 1, 0}, {x, 2, 0});
  }
  SpaceComplex c = result.complex();
  EXPECT_FALSE(audit(c, AuditForm::Minimal));
  const std::uint32_t first = vertex_at(c, {1, 0, 0}), last = vertex_at(c, {much * much, 0, 0});
  c.vertex_point[last] = c.vertex_point[first];
  const std::optional<SpaceFlaw> flaw = audit(c, AuditForm::Minimal);
  ASSERT_TRUE(flaw);
  EXPECT_EQ(flaw->invariant, "vertices have different points");
}

/// The facet in z = 1 of a plate 1 high that has a corner there.
FacetId top_at(const SpaceComplex& c, const ExactPoint3& corner) {
  const VertexId v(vertex_at(c, corner));
  return c.use_facet[first_where(c.use_count(), [&](std::uint32_t u) {
    const IntegerRow plane = c.planes().coefficients(c.facet_plane[c.use_facet[u].value()]);
    return c.use_origin(UseId(u)) == v && plane[0] == 0 && plane[1] == 0;
  })];
}
void give_hole(SpaceComplex& c, FacetId from, FacetId to) {
  const UseId hole = c.cycles_of(from)[1];
  c.cycle.erase(c.cycle.begin() + c.cycle_begin[from.value()] + 1);
  for (std::size_t f = from.value() + 1; f <= c.facet_count(); ++f) --c.cycle_begin[f];
  c.cycle.insert(c.cycle.begin() + c.cycle_begin[to.value() + 1], hole);
  for (std::size_t f = to.value() + 1; f <= c.facet_count(); ++f) ++c.cycle_begin[f];
  UseId u = hole;
  do {
    c.use_facet[u.value()] = to;
    u = c.use_next[u.value()];
  } while (u != hole);
}
/// The hole of a plate given to another one, in whose box it is: to one with a hole around it, and
/// to one with a notch.
TEST(SpaceAudit, FindsTheHoleThatIsNotInItsFacet) {
  const auto plate = [](int low, int high) { return solid(box({low, low, 0}, {high, high, 1})); };
  const Nef3 pierced = plate(5, 9) - plate(6, 8);
  for (const int end : {11, 10}) {
    SCOPED_TRACE(end);
    SpaceComplex c = (plate(0, end) - plate(4, 10) + pierced).complex();
    EXPECT_FALSE(audit(c, AuditForm::Minimal));
    give_hole(c, top_at(c, {5, 5, 1}), top_at(c, {4, 4, 1}));
    const std::optional<SpaceFlaw> flaw = audit(c, AuditForm::Minimal);
    ASSERT_TRUE(flaw);
    EXPECT_EQ(flaw->invariant, "a hole lies in its facet and in no other hole");
  }
}

/// Whichever corner of a triangle it is that touches a sheet.
TEST(SpaceAudit, FindsEveryCornerInAFacet) {
  const Nef3 triangle = to_nef(*space_set(PolygonLeaf{{{0, 0, 1}, {1, 0, 2}, {-1, 0, 2}}}));
  const Nef3 floor = to_nef(*space_set(PolygonLeaf{{{-9, -9, 0}, {9, -8, 0}, {0, 9, 0}}}));
  const SpaceComplex apart = (triangle + floor).complex();
  EXPECT_FALSE(audit(apart, AuditForm::Minimal));
  const std::vector<std::pair<ExactPoint3, ExactPoint3>> moves{
      {{0, 0, 1}, {0, 0, 0}}, {{1, 0, 2}, {3, 0, 0}}, {{-1, 0, 2}, {-3, 0, 0}}};
  for (const auto& [from, to] : moves) {
    SpaceComplex c = apart;
    move_vertex(c, VertexId(vertex_at(c, from)), to, {0, 1, 0});
    const std::optional<SpaceFlaw> flaw = audit(c, AuditForm::Minimal);
    ASSERT_TRUE(flaw);
    EXPECT_EQ(flaw->invariant, "no vertex lies inside a facet unlisted");
  }
}

/// A triangle that defines its plane, run around the other way.
TEST(SpaceAudit, FindsTheTriangleThatIsTurned) {
  Context context;
  const PolygonMesh mesh = make_mesh({{0, 0, 0}, {2, 0, 1}, {0, 3, 1}}, {{0, 1, 2}});
  const Nef3 sheet = Nef3::from_facets(complex_of_mesh(mesh, {.surface = true}, context), context);
  SpaceComplex c = sheet.complex();
  ASSERT_EQ(c.use_count(), 3U);
  EXPECT_FALSE(audit(c, AuditForm::Minimal));
  std::swap(c.use_next, c.use_prev);
  for (HalfedgeId& h : c.use_halfedge) h = SpaceComplex::twin(h);
  const std::optional<SpaceFlaw> flaw = audit(c, AuditForm::Minimal);
  ASSERT_TRUE(flaw);
  EXPECT_EQ(flaw->invariant, "the first cycle runs around its facet");
}

// Marks that let items go are no flaw of a complex that need not be minimal.
TEST(SpaceAudit, AsksForTheMinimalFormOnlyWhenTold) {
  SpaceComplex c = decorated_cube();
  c.facet_mark[sheet(c)] = 0;
  EXPECT_FALSE(audit(c, AuditForm::Any));
}

/// Where one facet has it all, and where there are many.
TEST(SpaceAudit, KeepsToItsLimits) {
  Context context;
  std::vector<Point2> polygon;
  for (int i = 0; i < 300; ++i) polygon.push_back({1.0 * i, 1.0 * i * i});
  const Nef3 prism =
      Nef3::from_mesh(prism_mesh(polygon, 0, 1), {.rule = WindingRule::Positive}, context);
  const Nef3 ball =
      Nef3::from_mesh(icosphere_mesh(3, 1, {0, 0, 0}), {.rule = WindingRule::Positive}, context);
  Limits limits;
  limits.max_seconds = 1e-9;
  std::stop_source stop;
  stop.request_stop();
  for (const Nef3& set : {prism, !ball}) {
    EXPECT_FALSE(audit(set.complex(), AuditForm::Minimal, context));
    Context late(limits), stopped(Limits{}, stop.get_token());
    EXPECT_THROW(audit(set.complex(), AuditForm::Minimal, late), Error);
    EXPECT_THROW(audit(set.complex(), AuditForm::Minimal, stopped), Error);
  }
}

}  // namespace
}  // namespace plumb::testing::space_audit_test
