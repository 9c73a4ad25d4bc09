// How finding contacts grows with two spheres of triangles in several positions (growth.h says how
// it is measured).
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "growth.h"
#include "plumb/space/boolean/find_contacts.h"
#include "plumb/space/from_mesh.h"

namespace plumb::bench {
namespace {

struct Operands {
  SpaceComplex a;
  SpaceComplex b;
  std::shared_ptr<SpaceTables> tables;
};

void refer_to(SpaceComplex& complex, const TableMap& map) {
  for (SpacePoint& p : complex.vertex_point) p = map(p);
  for (PlaneId& p : complex.facet_plane) p = map(p);
  for (auto& planes : complex.edge_planes) planes = {map(planes[0]), map(planes[1])};
}

Operands operands(const PolygonMesh& a, const PolygonMesh& b) {
  Context context;
  Operands result{
      complex_of_mesh(a, {}, context).complex, complex_of_mesh(b, {}, context).complex, {}};
  result.tables = copy(*result.a.tables);
  refer_to(result.b, merge(*result.tables, *result.b.tables));
  result.a.tables = result.b.tables = result.tables;
  return result;
}

struct Position {
  const char* name;
  PolygonMesh (*second)(const PolygonMesh&);
};
constexpr Position kPositions[] = {
    {"a-third-apart",
     [](const PolygonMesh& m) {
       return testing::moved(m, {0.21, 0.16, 0.19});
     }},
    {"apart",
     [](const PolygonMesh& m) {
       return testing::moved(m, {1.2, 1.2, 1.2});
     }},
    {"the-same", [](const PolygonMesh& m) { return m; }},
    {"turned-by-1e-12", [](const PolygonMesh& m) { return testing::turned(m, 1e-12); }},
    {"turned-by-0.5", [](const PolygonMesh& m) { return testing::turned(m, 0.5); }},
};

/// Every pair stands otherwise, a little.
Work meeting(const Position& position, std::size_t depth) {
  const PolygonMesh mesh = testing::icosphere_mesh(static_cast<int>(depth), 1, {0, 0, 0});
  const auto facets = static_cast<double>(mesh.face_count());
  std::vector<Operands> pairs;
  while (facets * static_cast<double>(pairs.size()) < kVariedElements) {
    const PolygonMesh first = testing::turned(mesh, 0.01 * static_cast<double>(pairs.size()));
    pairs.push_back(operands(first, position.second(first)));
  }
  return measured_in_turn(facets, std::move(pairs), [](const Operands& pair) {
    Context context;
    return find_contacts(pair.a, pair.b, *pair.tables, context);
  });
}

std::vector<Family> families() {
  std::vector<Family> result;
  for (const Position& position : kPositions) {
    result.push_back({position.name,
                      "contacts of two spheres, O((n + k) log n)",
                      "facets",
                      {1, 1},
                      {1, 2, 3, 4, 5, 6},
                      [&position](std::size_t depth) { return meeting(position, depth); },
                      1.15});
  }
  return result;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::growth_main("Growth of the meeting of two meshes", plumb::bench::families(),
                                   argc, argv);
}
