// Capabilities of space.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "jobs.h"
#include "plumb/io/solid_io.h"
#include "plumb/predicates/error.h"
#include "plumb/space/canonical.h"
#include "plumb/space/half_space_list.h"
#include "plumb/space/nef3.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/to_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::bench {
namespace {

std::size_t facets_of(const Nef3& set) { return set.complex().facet_count(); }

PolygonMesh triangles_of(const Nef3& set) {
  Context context;
  return mesh_of_complex(set.complex(), {MeshFaces::Triangles, false, false}, context).mesh;
}

Once union_of_meshes(const PolygonMesh& mesh) {
  return timed(
      [a = mesh, b = shifted(mesh)] {
        Context context;
        return triangles_of(boolean_op(testing::solid(a), testing::solid(b), kUnion, context));
      },
      [](const PolygonMesh& result) { return result.face_count(); });
}

/// A polyhedron from the union of a mesh and itself moved, as rounded triangles: what does rounding
/// do to it?
Once rounding_of(const PolygonMesh& mesh) {
  Context context;
  const Nef3 both =
      boolean_op(testing::solid(mesh), testing::solid(shifted(mesh)), kUnion, context);
  return timed_of(facets_of(both),
                  [result = mesh_of_complex(both.complex(), {.keeps_exact = true}, context).mesh] {
                    Context own;
                    return check_rounding(result, 10, own);
                  });
}

/// Points anywhere in the box of the mesh.
std::vector<Point3> points_around(const PolygonMesh& mesh, std::size_t count) {
  Point3 low = mesh.points[0], high = low;
  for (const Point3& p : mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  testing::Dice dice(7);
  const auto between = [&](double from, double to) {
    return from + 1e-6 * static_cast<double>(dice.between(0, 1000000)) * (to - from);
  };
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = between(low.x, high.x), y = between(low.y, high.y);
    points.push_back({x, y, between(low.z, high.z)});
  }
  return points;
}

/// Locator made, then 10,000 points.
Once location_in(const PolygonMesh& mesh) {
  return timed_of(10000, [set = testing::solid(mesh), points = points_around(mesh, 10000)] {
    const Nef3 fresh = !set;  // shares nothing with `set`
    std::vector<Mark> marks(points.size());
    fresh.contains(points, marks);
    return marks;
  });
}

Once shooting_in(const PolygonMesh& mesh) {
  return timed_of(1000, [set = testing::solid(mesh), points = points_around(mesh, 1000)] {
    const Nef3 fresh = !set;
    return std::ranges::count_if(points, [&](const Point3& p) {
      const RationalPoint3 from{Rational(p.x), Rational(p.y), Rational(p.z)};
      return fresh.shoot_to_boundary(from, {3, 2, 1}).has_value();
    });
  });
}

/// With the plane through the middle of the first triangle, as good as any.
Once section_of(const PolygonMesh& mesh) {
  const Point3 p = mesh.points[mesh.face(0)[0]];
  const Plane3 plane{3, 2, 1, -Rational(3 * p.x + 2 * p.y + p.z)};
  return timed(
      [set = testing::solid(mesh), plane] {
        Context context;
        return boolean_op(set, plane, Section::ClosedHalfSpace, kIntersection, context);
      },
      facets_of);
}

Once audit_of(const PolygonMesh& mesh) {
  const Nef3 set = testing::solid(mesh);
  return timed_of(facets_of(set), [set] {
    Context context;
    PLUMB_CHECK(!audit(set.complex(), AuditForm::Minimal, context));
    return true;
  });
}

Once comparison_of(const PolygonMesh& mesh) {
  const Nef3 set = testing::solid(mesh);
  return timed_of(facets_of(set), [set, same = testing::solid(mesh)] { return set == same; });
}

/// Of each capability that needs one mesh.
void add_mesh_jobs(std::vector<Job>& jobs, const std::string& input, bool is_real,
                   const std::function<PolygonMesh()>& make) {
  using Of = Once (*)(const PolygonMesh&);
  const auto add_of = [&](const char* capability, const std::string& of_what, const char* unit,
                          Of of) {
    jobs.push_back({capability, of_what, is_real, unit, [make, of] { return of(make()); }});
  };
  const auto add = [&](const char* capability, const char* unit, Of of) {
    add_of(capability, input, unit, of);
  };
  add("a set of a mesh", "facets", [](const PolygonMesh& mesh) {
    return timed([mesh] { return testing::solid(mesh); }, facets_of);
  });
  const std::string two = input + " and itself moved";
  add_of("space Boolean, mesh to triangles", two, "triangles", union_of_meshes);
  add_of("what rounding does", "union of " + two, "facets", rounding_of);
  add("section with a half-space", "facets", section_of);
  add("space topology: boundary of complement", "facets", [](const PolygonMesh& mesh) {
    return timed([set = testing::solid(mesh)] { return (!set).boundary(); }, facets_of);
  });
  add("space location, locator made", "points", location_in);
  add("space ray shooting, locator made", "rays", shooting_in);
  add("exact volume", "facets", [](const PolygonMesh& mesh) {
    const Nef3 set = testing::solid(mesh);
    return timed_of(facets_of(set), [set] { return *marked_volume(set.complex()); });
  });
  add("are two sets equal?", "facets", comparison_of);
  add("canonical form", "facets", [](const PolygonMesh& mesh) {
    return timed(
        [set = testing::solid(mesh)] {
          Context context;
          return canonical(set, context);
        },
        facets_of);
  });
  add("space audit", "facets", audit_of);
}

Once intersection_of_half_spaces(std::size_t count) {
  testing::Dice dice(1);
  std::vector<HalfSpace3> planes;
  while (planes.size() < count) {
    const std::int64_t a = dice.between(-1000, 1000), b = dice.between(-1000, 1000),
                       c = dice.between(-1000, 1000);
    if (a * a + b * b + c * c > 250000) planes.push_back({{a, b, c, -100000}, Boundary::Closed});
  }
  return timed(
      [planes] {
        Context context;
        return Nef3::intersection(planes, context);
      },
      facets_of);
}

}  // namespace

void add_solid_jobs(std::vector<Job>& jobs, const MacroOptions& options) {
  add_mesh_jobs(jobs, "corpus/solids/bunny.off", true,
                [] { return mesh_of("corpus/solids/bunny.off"); });
  const int depth = options.most < 50 ? 3 : 6;
  add_mesh_jobs(jobs, fmt::format("icosphere of 20 * 4^{}", depth), false, [depth] {
    return testing::icosphere_mesh(depth, 1, {0, 0, 0});
  });
  jobs.push_back(
      {"intersection of half-spaces", "corpus/solids/octahedron.txt", true, "facets", [] {
         Context context;
         const auto list = std::make_shared<const HalfSpaceList>(
             read_half_spaces_file("corpus/solids/octahedron.txt", {}, context));
         return timed(
             [list] {
               Context own;
               return intersection_of(*list, own);
             },
             facets_of);
       }});
  const std::size_t planes = options.size(10000, 100);
  jobs.push_back({"intersection of half-spaces", fmt::format("{} half-spaces", planes), false,
                  "facets", [planes] { return intersection_of_half_spaces(planes); }});
}

}  // namespace plumb::bench
