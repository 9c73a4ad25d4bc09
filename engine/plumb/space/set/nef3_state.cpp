// The members of Nef3 that make sets, locate points and shoot rays. They are declared in
// plumb/space/nef3.h.
//
// A mesh becomes a set in three steps: its arrangement, winding numbers of volumes, the closure of
// the volumes that the rule accepts (docs/design/meshes.md, "From numbers to a set"). Half-spaces
// and planes are Booleans with the empty set; bounded intersections of half-spaces are built as a
// polytope (half_space_hull.h). Segments and points are drafts with one or two vertices.
//
// A ray visits cells one after the other: from one hit to the next it stays in one cell, so the
// middle between two hits determines this cell.
//
// Tested by tests/space/nef3_test.cpp, tests/space/nef3_queries_test.cpp and
// tests/space/mesh_arrangement_test.cpp.

#include "plumb/space/set/nef3_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "plumb/base/internal/restarted_jobs.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/predicates/error.h"
#include "plumb/space/boolean/assemble.h"
#include "plumb/space/boolean/boolean_op.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/mesh/mesh_arrangement.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"
#include "plumb/space/query/volumes.h"
#include "plumb/space/set/half_space_hull.h"

namespace plumb {
namespace {

/// Whether the rule accepts a winding number.
bool is_inside(std::int32_t winding, WindingRule rule) {
  switch (rule) {
    case WindingRule::NonZero:
      return winding != 0;
    case WindingRule::EvenOdd:
      return winding % 2 != 0;
    case WindingRule::Positive:
      break;
  }
  return winding > 0;
}

/// Returns the intersection of the half-spaces that are needed, by Booleans.
template <class HalfSpaces>
Nef3 one_by_one(const HalfSpaces& half_spaces, const std::vector<std::uint32_t>& needed,
                Context& context) {
  std::vector<Nef3> sets;
  for (const std::uint32_t i : needed) {
    const HalfSpace3& half_space = half_spaces[i];
    sets.push_back(Nef3::half_space(half_space.plane, half_space.boundary));
  }
  return intersection_of(sets, context);
}

/// Whether all edges have facets, and all vertices have edges.
bool has_facets_everywhere(const SpaceComplex& c) {
  for (const UseId u : c.edge_use) {
    if (!u.is_valid()) return false;
  }
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    if (c.star_of(VertexId(v)).empty()) return false;
  }
  return true;
}

/// Marks facets, edges and vertices that have a marked volume beside them.
void close_volumes(SpaceComplex& c) {
  c.facet_mark.assign(c.facet_count(), 0);
  Mark all = 1;  // Whether all facets are marked, as the facets of a solid are.
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    const auto& [above, below] = c.facet_volume[f];
    c.facet_mark[f] = c.volume_mark[above] | c.volume_mark[below];
    all &= c.facet_mark[f];
  }
  const Mark initial = all != 0 && has_facets_everywhere(c) ? 1 : 0;
  c.edge_mark.assign(c.edge_count(), initial);
  c.vertex_mark.assign(c.vertex_count(), initial);
  if (initial != 0) return;
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    if (c.facet_mark[c.use_facet[u]] == 0) continue;
    const HalfedgeId h = c.use_halfedge[u];
    c.edge_mark[h.value() / 2] = 1;
    c.vertex_mark[c.origin[h.value()]] = 1;
  }
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    if (c.facet_mark[f] == 0) continue;
    for (const VertexId v : c.inner_of(FacetId(f))) c.vertex_mark[v] = 1;
  }
}

/// Returns the polygon through all points of a mesh without faces. Throws Error{BadShape} unless it
/// is planar and simple.
Nef3 only_facet(PolygonMesh mesh, Context& context) {
  std::vector<std::uint32_t> face(mesh.points.size());
  std::iota(face.begin(), face.end(), 0U);
  mesh.add_face(face);
  MeshOptions options;
  options.surface = true;
  MeshComplex made = complex_of_mesh(mesh, options, context);
  const MeshReport& report = made.report;
  if (!report.not_planar.empty() || !report.not_simple.empty() || !report.degenerate.empty()) {
    throw Error(ErrorCode::BadShape, "a facet must be a simple polygon in one plane");
  }
  return Nef3::from_facets(std::move(made), context);
}

/// Returns two planes through a and b, different points, such that n_p x n_q runs from a to b.
SphereDirection line_through(PlaneTable& planes, const RationalPoint3& a, const RationalPoint3& b) {
  const std::array<Rational, 3> from{a.x, a.y, a.z}, d{b.x - a.x, b.y - a.y, b.z - a.z};
  std::size_t i = 0;
  while (i < 3 && d[i] == 0) ++i;
  PLUMB_CHECK(i < 3);
  // The normals are d x e_j and d x e_k. Their product is d (d . (e_j x e_k)) = d d_i for (i, j, k)
  // in cyclic order, and d_i is not 0.
  std::array<OrientedPlane, 2> sides;
  for (std::size_t s = 0; s < 2; ++s) {
    const std::size_t j = (i + 1 + s) % 3, k = (j + 1) % 3, l = (j + 2) % 3;
    std::array<Rational, 3> n;
    n[j] = 0;
    n[k] = d[l];
    n[l] = -d[k];
    const Rational offset = -(n[0] * from[0] + n[1] * from[1] + n[2] * from[2]);
    sides[s] = planes.intern(n[0], n[1], n[2], offset);
  }
  const Sign turn = sign_of(d[i]) * sides[0].orientation() * sides[1].orientation();
  const SphereDirection direction{sides[0].plane(), sides[1].plane()};
  return turn == Sign::Positive ? direction : direction.opposite();
}

/// Returns the map of a marked vertex with one marked free edge, or with none if `direction` is
/// null.
SphereMap lone_map(const SphereDirection* direction) {
  SphereMap map;
  map.centre_mark = 1;
  map.face_mark = {0};
  if (direction == nullptr) return map;
  map.direction = {*direction};
  map.point_mark = {1};
  map.first_out = {kNone};
  map.point_face = {0};
  return map;
}

}  // namespace

// The set is a Boolean of the empty set and a plane, which takes a single cut of an empty cube.
Nef3 Nef3::half_space(const Plane3& plane, Boundary boundary) {
  Context& context = unlimited_context();
  const Section section =
      boundary == Boundary::Closed ? Section::ClosedHalfSpace : Section::OpenHalfSpace;
  return boolean_op(empty(), plane, section, kUnion, context);
}

Nef3 Nef3::half_space(const Plane3& plane, const RationalPoint3& kept, Boundary boundary) {
  const Sign side =
      sign_of(Rational(plane.a * kept.x + plane.b * kept.y + plane.c * kept.z + plane.d));
  if (side == Sign::Zero) {
    throw Error(ErrorCode::BadArgument, "the point that says which side to keep is on the plane");
  }
  if (side == Sign::Negative) return half_space(plane, boundary);
  return half_space({-plane.a, -plane.b, -plane.c, -plane.d}, boundary);
}

Nef3 Nef3::plane(const Plane3& plane) {
  Context& context = unlimited_context();
  return boolean_op(empty(), plane, Section::PlaneOnly, kUnion, context);
}

Nef3 Nef3::intersection(std::span<const HalfSpace3> half_spaces, Context& context) {
  HalfSpaceHull hull = hull_of_half_spaces(half_spaces, context);
  if (hull.polytope) return Nef3(std::move(*hull.polytope));
  return one_by_one(half_spaces, hull.needed, context);
}

Nef3 intersection_of(const HalfSpaceList& half_spaces, Context& context) {
  HalfSpaceHull hull = hull_of_half_spaces(half_spaces, context);
  if (hull.polytope) return Nef3::from_complex(std::move(*hull.polytope), context);
  return one_by_one(half_spaces, hull.needed, context);
}

Nef3 Nef3::from_mesh(std::span<const double> xyz, std::span<const std::uint32_t> triangles,
                     const FromMeshOptions& options, Context& context) {
  return from_mesh(mesh_of_triangles(xyz, triangles), options, context);
}

Nef3 Nef3::from_mesh(const PolygonMesh& mesh, const FromMeshOptions& options, Context& context) {
  return from_mesh(MeshView(mesh), options, context);
}

// The report of an open mesh is stored before OpenMesh is thrown.
Nef3 Nef3::from_mesh(const MeshView& mesh, const FromMeshOptions& options, Context& context) {
  const WorkPhase phase("set from mesh");
  MeshOptions reading;
  reading.surface = options.surface;
  reading.joins_coplanar = true;
  reading.max_listed = options.max_listed;
  MeshComplex made = complex_of_mesh(mesh, reading, context);
  const auto report_to = [&](MeshReport report) {
    if (options.report != nullptr) *options.report = std::move(report);
  };
  if (!options.surface && !made.report.is_closed()) {
    report_to(made.report);
    throw OpenMesh(std::move(made.report));
  }
  if (!options.surface && !options.rule) {
    // If there is no rule, components that face inwards are flipped first.
    made.report.turned = turn_inside_out(made, context);
  }
  report_to(made.report);
  if (options.surface) return from_facets(std::move(made), context);
  return from_mesh_complex(std::move(made), options.rule.value_or(WindingRule::Positive), context);
}

// The mesh is arranged, volumes get winding numbers, the volumes that the rule accepts are marked,
// and the set is closed.
Nef3 Nef3::from_mesh_complex(MeshComplex mesh, WindingRule rule, Context& context) {
  if (!mesh.report.is_closed()) throw OpenMesh(std::move(mesh.report));
  WorkPhase phase("volumes of the mesh");
  arrange(mesh, context);
  SpaceComplex& c = mesh.complex;
  const std::vector<std::int32_t> winding = winding_numbers(c, facet_jumps(mesh));
  for (std::size_t v = 0; v < winding.size(); ++v) {
    c.volume_mark[v] = is_inside(winding[v], rule) ? 1 : 0;
  }
  close_volumes(c);
  phase.next("minimal complex");
  return from_complex(std::move(c), context);
}

std::vector<Nef3> Nef3::from_meshes(std::span<const PolygonMesh> meshes,
                                    const FromMeshOptions& options, Context& context) {
  if (options.report != nullptr) {
    throw Error(ErrorCode::BadArgument, "one report cannot serve several meshes");
  }
  std::vector<Nef3> sets(meshes.size());
  run_restarted_jobs(context, meshes.size(), [&](std::size_t i, Context& own) {
    sets[i] = from_mesh(meshes[i], options, own);
  });
  return sets;
}

// Makes all facets with their boundaries, in volumes without marks.
Nef3 Nef3::from_facets(MeshComplex mesh, Context& context) {
  if (!mesh.complex.tables) {
    throw Error(ErrorCode::BadShape, "the mesh is open and was not read as a surface");
  }
  arrange(mesh, context);
  SpaceComplex& c = mesh.complex;
  c.facet_mark.assign(c.facet_count(), 1);
  c.edge_mark.assign(c.edge_count(), 1);
  c.vertex_mark.assign(c.vertex_count(), 1);
  return from_complex(std::move(c), context);
}

Nef3 Nef3::facet(std::span<const Point3> corners, Context& context) {
  PolygonMesh mesh;
  mesh.points.assign(corners.begin(), corners.end());
  return only_facet(std::move(mesh), context);
}

Nef3 Nef3::facet(std::span<const RationalPoint3> corners, Context& context) {
  PolygonMesh mesh;
  mesh.points.resize(corners.size());  // These are not read, because all points are exact.
  for (std::uint32_t i = 0; i < corners.size(); ++i) mesh.exact.emplace_back(i, corners[i]);
  return only_facet(std::move(mesh), context);
}

Nef3 Nef3::segment(const RationalPoint3& a, const RationalPoint3& b) {
  if (a.x == b.x && a.y == b.y && a.z == b.z) return point(a);
  Context& context = unlimited_context();
  const auto tables = std::make_shared<SpaceTables>();
  SpaceDraft draft(tables);
  const SphereDirection to_b = line_through(tables->planes, a, b), to_a = to_b.opposite();
  draft.add(add_point(*tables, a), lone_map(&to_b), false, {});
  draft.add(add_point(*tables, b), lone_map(&to_a), false, {});
  // The two points face each other.
  draft.twin = {1, 0};
  return Nef3(assemble(std::move(draft), context));
}

Nef3 Nef3::polyline(std::span<const RationalPoint3> points, Context& context) {
  const std::array<std::uint32_t, 2> begin{0, static_cast<std::uint32_t>(points.size())};
  return polylines(points, begin, context);
}

Nef3 Nef3::polylines(std::span<const RationalPoint3> points, std::span<const std::uint32_t> begin,
                     Context& context) {
  if (begin.empty() || begin.front() != 0 || begin.back() != points.size() ||
      !std::is_sorted(begin.begin(), begin.end())) {
    throw Error(ErrorCode::BadArgument, "polylines do not follow each other in their points");
  }
  std::vector<Nef3> parts;
  for (std::size_t line = 0; line + 1 < begin.size(); ++line) {
    const std::size_t end = begin[line + 1];
    if (begin[line] + std::size_t{1} == end) parts.push_back(point(points[begin[line]]));
    for (std::size_t i = begin[line]; i + 1 < end; ++i) {
      parts.push_back(segment(points[i], points[i + 1]));
    }
  }
  return union_of(parts, context);
}

Nef3 Nef3::point(const RationalPoint3& at) {
  Context& context = unlimited_context();
  const auto tables = std::make_shared<SpaceTables>();
  SpaceDraft draft(tables);
  draft.add(add_point(*tables, at), lone_map(nullptr), false, {});
  return Nef3(assemble(std::move(draft), context));
}

Nef3 Nef3::points(std::span<const RationalPoint3> points, Context& context) {
  std::vector<Nef3> sets;
  for (const RationalPoint3& p : points) sets.push_back(point(p));
  return union_of(sets, context);
}

// Points and rays in a set.

namespace {

/// Throws Error{NotFinite} unless the coordinates are finite.
void require_finite(const Point3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    throw Error(ErrorCode::NotFinite, "the coordinates of a point must be finite");
  }
}

/// Whether a cell belongs to the set.
bool is_marked(const SpaceComplex& c, SpaceItem item) {
  switch (item.kind()) {
    case SpaceItem::Kind::Vertex:
      return c.vertex_mark[item.index()] == 1;
    case SpaceItem::Kind::Edge:
      return c.edge_mark[item.index()] == 1;
    case SpaceItem::Kind::Facet:
      return c.facet_mark[item.index()] == 1;
    case SpaceItem::Kind::Volume:
      break;
  }
  return c.volume_mark[item.index()] == 1;
}

/// Returns p + d.
RationalPoint3 along(const RationalPoint3& p, const RationalPoint3& d) {
  return {p.x + d.x, p.y + d.y, p.z + d.z};
}

/// Returns the middle of two points.
RationalPoint3 middle(const RationalPoint3& p, const RationalPoint3& q) {
  return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
}

}  // namespace

// The first of several threads makes the locator, and the others wait for it.
const SpaceLocator& Nef3::locator() const {
  std::call_once(state_->locator_made,
                 [this] { state_->locator = std::make_unique<SpaceLocator>(state_->complex); });
  return *state_->locator;
}

SpaceLocation Nef3::locate(const RationalPoint3& p, Context& context) const {
  context.checkpoint("locate", 0, 0);
  const SpaceItem item = locator().locate(p);
  return {item, is_marked(complex(), item)};
}

SpaceLocation Nef3::locate(const Point3& p, Context& context) const {
  require_finite(p);
  context.checkpoint("locate", 0, 0);
  const SpaceItem item = locator().locate(p);
  return {item, is_marked(complex(), item)};
}

void Nef3::contains(std::span<const Point3> points, std::span<Mark> marked,
                    Context& context) const {
  if (points.size() != marked.size()) {
    throw Error(ErrorCode::BadArgument, "one mark is needed for each point");
  }
  constexpr std::size_t kPointsPerCheckpoint = 256;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kPointsPerCheckpoint == 0) context.checkpoint("locate", i, points.size());
    require_finite(points[i]);
    marked[i] = is_marked(complex(), locator().locate(points[i])) ? 1 : 0;
  }
}

bool Nef3::has_on_boundary(const RationalPoint3& p, Context& context) const {
  context.checkpoint("locate", 0, 0);
  return locator().on_item(p).is_valid();
}

bool Nef3::has_on_boundary(const Point3& p, Context& context) const {
  require_finite(p);
  context.checkpoint("locate", 0, 0);
  return locator().on_item(p).is_valid();
}

// Between two hits the ray stays in one cell, so locating any point in between finds that cell. The
// loop ends because each hit is farther along the ray and a complex is finite.
std::optional<SpaceHit> Nef3::shoot_if(const RationalPoint3& origin,
                                       const RationalPoint3& direction,
                                       const std::function<bool(SpaceItem)>& accepts,
                                       Context& context) const {
  if (direction.x == 0 && direction.y == 0 && direction.z == 0) {
    throw Error(ErrorCode::BadArgument, "the direction of a ray must not be zero");
  }
  const auto hit = [this](SpaceItem item, const RationalPoint3& point) {
    return SpaceHit{{item, is_marked(complex(), item)}, point};
  };
  SpaceItemHit at{locator().locate(origin), origin};
  for (;;) {
    context.checkpoint("shoot", 0, 0);
    if (accepts(at.item)) return hit(at.item, at.point);
    // The cell that the ray enters after this point is the cell of the middle between this point
    // and the next hit.
    const std::optional<SpaceItemHit> next = locator().shoot(at.point, direction);
    const RationalPoint3 beyond = next ? middle(at.point, next->point) : along(at.point, direction);
    const SpaceItem entered = locator().locate(beyond);
    if (accepts(entered)) return hit(entered, at.point);
    if (!next) return std::nullopt;
    at = *next;
  }
}

std::optional<SpaceHit> Nef3::shoot(const RationalPoint3& origin, const RationalPoint3& direction,
                                    Context& context) const {
  return shoot_if(
      origin, direction, [this](SpaceItem item) { return is_marked(complex(), item); }, context);
}

std::optional<SpaceHit> Nef3::shoot_to_boundary(const RationalPoint3& origin,
                                                const RationalPoint3& direction,
                                                Context& context) const {
  return shoot_if(
      origin, direction, [](SpaceItem item) { return item.kind() != SpaceItem::Kind::Volume; },
      context);
}

}  // namespace plumb
