// The check is brute force in rationals. It shares no code with the search for crossings of the
// engine: two triangles meet in the convex hull of the points in which edges of one of them meet
// the other one, so it looks at these points only.
#include "oracle/valid_mesh_check.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "generate/near_solids.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/repair_mesh.h"

namespace plumb::testing {
namespace {

using Place = std::array<Rational, 3>;
using PlaceTriangle = std::array<Place, 3>;

Place from_to(const Place& a, const Place& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
Place at_part(const Place& a, const Place& d, const Rational& t) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}

Place place_of(const PolygonMesh& mesh, std::uint32_t v) {
  const auto found =
      std::ranges::lower_bound(mesh.exact, v, {}, [](const auto& e) { return e.first; });
  if (found != mesh.exact.end() && found->first == v) {
    return {found->second.x, found->second.y, found->second.z};
  }
  const Point3& p = mesh.points[v];
  return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
}

PlaceTriangle triangle_of(const PolygonMesh& mesh, std::span<const std::uint32_t> face) {
  return {place_of(mesh, face[0]), place_of(mesh, face[1]), place_of(mesh, face[2])};
}

Place normal_of(const PlaceTriangle& t) { return cross(from_to(t[0], t[1]), from_to(t[0], t[2])); }

/// Whether the boxes around the rounded corners of two faces are at most `bound` apart. Numbers
/// are below 2^30 here, so the roundings are within the slack.
bool have_near_boxes(const PolygonMesh& a, std::span<const std::uint32_t> f, const PolygonMesh& b,
                     std::span<const std::uint32_t> g, double bound) {
  constexpr double kSlack = 0x1p-18;
  for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
    const auto range = [axis](const PolygonMesh& mesh, std::span<const std::uint32_t> face) {
      double low = mesh.points[face[0]].*axis, high = low;
      for (const std::uint32_t v : face) {
        low = std::min(low, mesh.points[v].*axis);
        high = std::max(high, mesh.points[v].*axis);
      }
      return std::pair(low, high);
    };
    const auto [low_f, high_f] = range(a, f);
    const auto [low_g, high_g] = range(b, g);
    if (std::max(low_f - high_g, low_g - high_f) > 2 * bound + kSlack) return false;
  }
  return true;
}

// ---------------------------------------------------------------- crossings

/// Returns the ends of the part of a segment that is in a closed triangle: none, or two that may be
/// equal.
std::vector<Place> part_in_triangle(const Place& a, const Place& b, const PlaceTriangle& t) {
  const Place normal = normal_of(t), along = from_to(a, b);
  Rational low = 0, high = 1;
  const auto keep_where_not_negative = [&](const Rational& at_a, const Rational& at_b) {
    const Rational change = at_b - at_a;
    if (change.sign() == 0) {
      if (at_a.sign() < 0) high = -1;
      return;
    }
    const Rational root = -at_a / change;
    if (change.sign() > 0) low = std::max(low, root);
    if (change.sign() < 0) high = std::min(high, root);
  };
  const Rational height_a = dot(normal, from_to(t[0], a)), height_b = dot(normal, from_to(t[0], b));
  keep_where_not_negative(height_a, height_b);
  keep_where_not_negative(-height_a, -height_b);
  for (std::size_t i = 0; i < 3; ++i) {
    const Place& p = t[i];
    const Place inward = cross(normal, from_to(p, t[(i + 1) % 3]));
    keep_where_not_negative(dot(inward, from_to(p, a)), dot(inward, from_to(p, b)));
  }
  if (low > high) return {};
  return {at_part(a, along, low), at_part(a, along, high)};
}

/// Whether a triangle lies behind the plane through p, seen along the normal, where only corners in
/// `common` may lie in the plane.
bool lies_behind(const PlaceTriangle& triangle, const Place& p, const Place& normal,
                 const std::vector<Place>& common) {
  return std::ranges::all_of(triangle, [&](const Place& corner) {
    const int side = dot(normal, from_to(p, corner)).sign();
    return side < 0 || (side == 0 && std::ranges::find(common, corner) != common.end());
  });
}

/// Whether the plane of the triangle t, or a plane through a side of it that is perpendicular to t,
/// separates it from the triangle s. Then s and t meet at most in the hull of `common`.
bool is_separated(const PlaceTriangle& s, const PlaceTriangle& t,
                  const std::vector<Place>& common) {
  const Place normal = normal_of(t);
  if (lies_behind(s, t[0], normal, common)) return true;
  if (lies_behind(s, t[0], {-normal[0], -normal[1], -normal[2]}, common)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Place inward = cross(normal, from_to(t[i], t[(i + 1) % 3]));
    if (lies_behind(s, t[i], inward, common)) return true;
  }
  return false;
}

bool is_between(const Place& p, const Place& a, const Place& b) {
  const Place along = from_to(a, b), to = from_to(a, p), off = cross(along, to);
  const Rational at = dot(along, to);
  const bool is_on_line = off[0].sign() == 0 && off[1].sign() == 0 && off[2].sign() == 0;
  return is_on_line && at.sign() >= 0 && at <= dot(along, along);
}

// ---------------------------------------------------------------- distances

Rational squared_to_segment(const Place& p, const Place& a, const Place& b) {
  const Place d = from_to(a, b);
  Rational t = dot(from_to(a, p), d) / dot(d, d);
  t = std::clamp(t, Rational(0), Rational(1));
  const Place gap = from_to(at_part(a, d, t), p);
  return dot(gap, gap);
}

Rational squared_to_triangle(const Place& p, const PlaceTriangle& t) {
  const Place u = from_to(t[0], t[1]), v = from_to(t[0], t[2]), w = from_to(t[0], p);
  const Rational uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const Rational det = uu * vv - uv * uv;
  const Rational a = (wu * vv - wv * uv) / det, b = (wv * uu - wu * uv) / det;
  if (a.sign() >= 0 && b.sign() >= 0 && a + b <= 1) {
    const Place gap = from_to(at_part(at_part(t[0], u, a), v, b), p);
    return dot(gap, gap);
  }
  return std::min({squared_to_segment(p, t[0], t[1]), squared_to_segment(p, t[1], t[2]),
                   squared_to_segment(p, t[2], t[0])});
}

// ---------------------------------------------------------------- validity

std::string flaw_that_readers_find(const PolygonMesh& mesh) {
  const MeshReport report = complex_of_mesh(mesh).report;
  if (!report.is_closed()) return "the reader finds borders";
  if (report.crosses_itself()) return "the reader finds crossings";
  if (!report.degenerate.empty() || !report.trimmed.empty()) return "the reader drops faces";
  if (!report.doubled.empty()) return "the reader finds doubled faces";
  if (!report.not_planar.empty() || !report.not_simple.empty()) return "faces are not flat";
  return report.vertices_merged > 0 ? "vertices are equal" : "";
}

bool is_balanced(const PolygonMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    std::uint32_t from = face.back();
    for (const std::uint32_t to : face) {
      edges[std::minmax(from, to)] += from < to ? 1 : -1;
      from = to;
    }
  }
  return std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}

}  // namespace

bool has_area(const PolygonMesh& mesh, std::span<const std::uint32_t> triangle) {
  const Place normal = normal_of(triangle_of(mesh, triangle));
  return dot(normal, normal).sign() != 0;
}

bool meet_elsewhere(const PolygonMesh& mesh, std::span<const std::uint32_t> a,
                    std::span<const std::uint32_t> b) {
  std::vector<Place> common;
  for (const std::uint32_t v : a) {
    if (std::ranges::find(b, v) != b.end()) common.push_back(place_of(mesh, v));
  }
  if (common.size() == 3) return true;
  const auto is_common = [&](const Place& p) {
    if (common.size() == 2) return is_between(p, common[0], common[1]);
    return common.size() == 1 && p == common[0];
  };
  const PlaceTriangle s = triangle_of(mesh, a), t = triangle_of(mesh, b);
  if (is_separated(s, t, common) || is_separated(t, s, common)) return false;
  const std::array<std::pair<const PlaceTriangle*, const PlaceTriangle*>, 2> orders{
      std::pair(&s, &t), std::pair(&t, &s)};
  for (const auto& [edges, other] : orders) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto ends = part_in_triangle((*edges)[i], (*edges)[(i + 1) % 3], *other);
      if (!std::ranges::all_of(ends, is_common)) return true;
    }
  }
  return false;
}

bool is_within(const PolygonMesh& mesh, const PolygonMesh& triangles, double bound) {
  const Rational limit = exact_rational(bound) * exact_rational(bound);
  std::vector<std::uint32_t> used = mesh.corners;
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return std::ranges::all_of(used, [&](std::uint32_t v) {
    const Place p = place_of(mesh, v);
    for (std::size_t f = 0; f < triangles.face_count(); ++f) {
      const auto face = triangles.face(f);
      if (!have_near_boxes(mesh, {&v, 1}, triangles, face, bound)) continue;
      if (squared_to_triangle(p, triangle_of(triangles, face)) <= limit) return true;
    }
    return false;
  });
}

std::string invalid_mesh(const PolygonMesh& mesh, CoordinateType type) {
  if (!mesh.exact.empty()) return "there are exact coordinates";
  for (const Point3& p : mesh.points) {
    for (const double c : {p.x, p.y, p.z}) {
      if (c != nearest_coordinate(c, type)) return "a coordinate is not a number of the type";
    }
  }
  if (!is_balanced(mesh)) return "an edge is not balanced";
  const PolygonMesh cut = triangulated(mesh);
  for (std::size_t f = 0; f < cut.face_count(); ++f) {
    if (!has_area(cut, cut.face(f))) return "a face has no area";
  }
  for (std::size_t f = 0; f < cut.face_count(); ++f) {
    for (std::size_t g = 0; g < f; ++g) {
      if (!have_near_boxes(cut, cut.face(f), cut, cut.face(g), 0)) continue;
      if (meet_elsewhere(cut, cut.face(f), cut.face(g))) return "two faces cross";
    }
  }
  return flaw_that_readers_find(mesh);
}

std::string valid_mesh_disagreement(const Nef3& set, CoordinateType type, MeshFaces faces,
                                    ValidMesh* result) {
  const ValidMesh valid = valid_mesh(set, {.faces = faces}, type);
  if (result != nullptr) *result = valid;
  const PolygonMesh& mesh = valid.made.mesh;
  if (valid.made.facet.size() != mesh.face_count()) return "faces have no facets";
  if (std::string flaw = invalid_mesh(mesh, type); !flaw.empty()) return flaw;
  const MeshOfComplex exact =
      mesh_of_complex(set.complex(), {.faces = MeshFaces::Triangles, .keeps_exact = true});
  if (!is_within(mesh, exact.mesh, valid.repair.largest_move)) return "the mesh is too far away";
  const bool has_same_topology = valid.repair.rounds == 0;
  if (has_same_topology && !is_within(exact.mesh, triangulated(mesh), valid.repair.largest_move)) {
    return "the exact boundary is too far away";
  }
  const Nef3 read = Nef3::from_mesh(mesh, {.rule = WindingRule::Positive});
  const ValidMesh again = valid_mesh(read, {.faces = faces}, type);
  if (again.repair.rounds + again.repair.rounded_vertices + again.repair.dropped_vertices > 0) {
    return "rounding again changes the mesh";
  }
  return Nef3::from_mesh(again.made.mesh) == read ? "" : "rounding again changes the set";
}

std::string valid_mesh_of_program_disagreement(std::span<const std::uint8_t> program) {
  Nef3 set;
  for (std::size_t i = 0; i + kNearSolidRecord <= program.size(); i += kNearSolidRecord) {
    const auto record = program.subspan(i, kNearSolidRecord);
    set = apply_near_solid(set, record);
    const NearSolidOutput out = near_solid_output(record);
    ValidMesh valid;
    std::string wrong = valid_mesh_disagreement(set, out.type, out.faces, &valid);
    if (!wrong.empty()) return "step " + std::to_string(i / kNearSolidRecord) + ": " + wrong;
    if (out.is_read_again) {
      set = Nef3::from_mesh(valid.made.mesh, {.rule = WindingRule::Positive});
    }
  }
  return "";
}

}  // namespace plumb::testing
