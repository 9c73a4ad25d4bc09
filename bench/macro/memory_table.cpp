// Bytes that structures hold for each element, beside what the sizes of their fields add up to.
//
//   memory_table [--most PERCENT] [--json FILE]
//
// Measured: what the allocator holds more once the structure is there and everything it was made
// with is gone. Predicted: arithmetic with the sizes of fields and the numbers of elements, as in
// the headers. Exit status 1 when one holds more than 10 % above that (where arrays grow element by
// element and may hold twice what is in them, 110 %), or less than half of it: then something was
// not counted.
#include <fmt/core.h>
#include <malloc.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/cpu_time.h"
#include "../complexity/plane_jobs.h"
#include "../text_of.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/sphere_families.h"
#include "generate/surface_meshes.h"
#include "macro_report.h"
#include "plumb/io/map_io.h"
#include "plumb/io/mesh_io.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/query/plane_locator.h"
#include "plumb/space/space_locator.h"
#include "plumb/sphere/arcs/sphere_bounds.h"
#include "plumb/sphere/sphere_locator.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/testing/map_families.h"
#include "plumb/testing/test_map.h"
#include "traced_polygons.h"

namespace plumb::bench {
namespace {

constexpr double kTolerance = 0.1;
constexpr double kLeastShare = 0.5;

template <class T>
constexpr auto kSize = static_cast<double>(sizeof(T));

double held_bytes() { return static_cast<double>(mallinfo2().uordblks); }

struct Row {
  std::string structure;
  std::string input;
  std::string unit;    ///< of elements
  bool grows = false;  ///< its arrays grow element by element
};

/// What a structure says of itself once it is there.
struct Facts {
  double elements;
  double predicted;  ///< bytes in all
};

class Table {
 public:
  explicit Table(nlohmann::ordered_json& rows) : rows_(rows) {}

  /// `make` returns the structure; what else it makes is gone by then.
  template <class Make, class Describe>
  void add(const Row& row, Make make, Describe describe) {
    { const auto once = make(); }  // tables that are made once, and freed memory to work in
    const double before = held_bytes();
    const auto structure = make();
    const double measured = held_bytes() - before;
    const Facts facts = describe(structure);
    const double most = ((row.grows ? 2 : 1) + kTolerance) * facts.predicted;
    const bool is_within = measured <= most && measured >= kLeastShare * facts.predicted;
    is_within_ = is_within_ && is_within;
    rows_.push_back({{"structure", row.structure},
                     {"input", row.input},
                     {"unit", row.unit},
                     {"elements", facts.elements},
                     {"measured", measured / facts.elements},
                     {"predicted", facts.predicted / facts.elements},
                     {"grows", row.grows},
                     {"within", is_within}});
    fmt::print("{:34} {:40} {:8.0f} {:11} {:8.1f} bytes each, predicted {:8.1f}{}\n", row.structure,
               row.input, facts.elements, row.unit, measured / facts.elements,
               facts.predicted / facts.elements, is_within ? "" : "  NOT WITHIN");
  }
  bool is_within() const { return is_within_; }

 private:
  nlohmann::ordered_json& rows_;
  bool is_within_ = true;
};

/// Half-edges hold origin, next, prev, loop; loops first, face, next, prev; vertices and faces one
/// id.
double bytes_of(const Dcel& d) {
  return 4 * kSize<HalfedgeId> * static_cast<double>(d.halfedge_slots()) +
         kSize<VertexId> * static_cast<double>(d.vertex_slots()) +
         4 * kSize<LoopId> * static_cast<double>(d.loop_slots()) +
         kSize<LoopId> * static_cast<double>(d.face_slots());
}

/// Points that doubles hold; crossings; the half-edge structure; a point for each vertex, a line
/// for each edge, marks.
double bytes_of(const PlaneComplex& c) {
  return kSize<Point2> * static_cast<double>(c.points.inputs.size()) +
         kSize<Crossing2> * static_cast<double>(c.points.crossings.size()) + bytes_of(c.dcel) +
         (kSize<std::uint32_t> + 1) * static_cast<double>(c.vertex_count()) +
         (kSize<PlaneLine> + 1) * static_cast<double>(c.edge_count()) +
         static_cast<double>(c.face_count());
}

/// Nodes of a segment tree over [begin, end) that [from, to) is made of.
double nodes_of(std::size_t begin, std::size_t end, std::size_t from, std::size_t to) {
  if (to <= begin || end <= from) return 0;
  if (from <= begin && end <= to) return 1;
  const std::size_t middle = begin + (end - begin) / 2;
  return nodes_of(begin, middle, from, to) + nodes_of(middle, end, from, to);
}

/// A locator of a complex whose vertices are at different abscissae, and bounded: columns, and a
/// list for each of four nodes a slab.
double locator_bytes_of(const PlaneComplex& c) {
  const std::size_t slabs = c.vertex_count() + 1;
  double entries = 0;
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    entries += nodes_of(0, slabs, c.dcel.origin(h).value() + std::size_t{1},
                        c.dcel.target(h).value() + std::size_t{1});
  }
  constexpr double kColumn = 12, kId = kSize<std::uint32_t>;
  return (kColumn + kId) * static_cast<double>(c.vertex_count()) +
         kId * (static_cast<double>(c.edge_count()) + entries) +
         4 * kSize<std::vector<EdgeId>> * static_cast<double>(slabs);
}

/// Planes with their rows, fingerprints, sources and two slots of an index; input points with their
/// grids.
double bytes_of(const PlaneTable& planes) {
  return static_cast<double>(planes.points().size()) *
         (kSize<Point3> + kSize<Grid>)+static_cast<double>(planes.size()) *
         (kSize<PlaneRow> + kSize<Fingerprint> + kSize<PlaneSource> + 36);
}

/// Of the set itself: the fields of space_complex.h. Tables: planes; constructed points with boxes
/// and sources.
double bytes_of(const SpaceComplex& c) {
  const auto vertices = static_cast<double>(c.vertex_count()),
             edges = static_cast<double>(c.edge_count()), uses = static_cast<double>(c.use_count()),
             facets = static_cast<double>(c.facet_count()),
             cycles = static_cast<double>(c.cycle.size()),
             inner = static_cast<double>(c.inner.size());
  constexpr double kId = kSize<std::uint32_t>;
  double bytes = vertices * (4 * kId + kSize<Mark>)+2 * edges * kId;          // with star
  bytes += edges * (4 * kId + kSize<Mark>)+2 * edges * kId + 5 * uses * kId;  // with origin
  bytes += facets * (6 * kId + kSize<Mark>)+cycles * kId + inner * kId;
  bytes += static_cast<double>(c.volume_count()) * kSize<Mark>;
  bytes += bytes_of(c.planes());
  return bytes + static_cast<double>(c.points().size()) * (kSize<PointBox> + kSize<PointSource>);
}

double bytes_of(const SphereMap& m) {
  constexpr double kId = kSize<std::uint32_t>;
  return static_cast<double>(m.direction.size()) *
             (kSize<SphereDirection> + kSize<Mark> + 2 * kId) +
         static_cast<double>(m.circle.size()) *
             (kSize<PlaneId> + kSize<Mark>)+static_cast<double>(m.origin.size()) * 3 * kId +
         static_cast<double>(m.face_mark.size()) * kSize<Mark>;
}

template <class... T>
double bytes_of(const std::vector<T>&... arrays) {
  return ((kSize<T> * static_cast<double>(arrays.size())) + ...);
}

double bytes_of(const SurfaceArrangement& a) {
  double bytes = bytes_of(a.node_point, a.corner_vertex, a.crossings, a.node_of_entry, a.slot_face,
                          a.slot_of_face, a.side_begin, a.piece_begin);
  bytes += bytes_of(a.origin, a.twin, a.next, a.piece, a.arc, a.piece_slot, a.piece_share,
                    a.loop_begin, a.loop, a.arc_halfedge, a.arc_bundle);
  for (std::size_t b = 0; b < a.bundles.size(); ++b) {
    bytes += kSize<std::uint32_t> + kSize<SignedEntry> * static_cast<double>(a.bundles[b].size());
  }
  return bytes;
}

double bytes_of(const SurfaceCells& c) {
  return bytes_of(c.of_piece, c.of_face, c.area, c.component, c.is_at_border, c.edges);
}

double bytes_of(const PolygonMesh& m) {
  return kSize<Point3> * static_cast<double>(m.points.size()) +
         kSize<std::uint32_t> * static_cast<double>(m.corners.size() + m.face_begin.size());
}

void add_plane(Table& table, const MacroOptions& options) {
  const auto faces = static_cast<std::uint32_t>(options.size(100000, 1000));
  const testing::TestMap hexagons = testing::map_family("hexagons").make(faces);
  table.add(
      {"Map", fmt::format("hexagons, {} faces, as read", faces), "corners"},
      [&] {
        Context context;
        return read_map(text_of([&](std::ostream& out) { write_map(out, to_map(hexagons)); }), {},
                        context);
      },
      [](const Map& map) {
        const auto corners = static_cast<double>(map.corners.size());
        return Facts{corners,
                     kSize<Point2> * static_cast<double>(map.points.size()) +
                         kSize<std::uint32_t> *
                             static_cast<double>(map.corners.size() + map.cycle_begin.size())};
      });
  table.add(
      {"Dcel", fmt::format("hexagons, {} faces", faces), "half-edges"},
      [&] {
        Context context;
        return to_dcel(check_map(to_map(hexagons), {}, context)).dcel;
      },
      [](const Dcel& d) {
        return Facts{static_cast<double>(d.halfedge_count()), bytes_of(d)};
      });
  const std::size_t n = options.size(1000, 200);
  const SegmentScene scene = scene_of(testing::long_segments(n));
  table.add(
      {"PlaneComplex", fmt::format("{} long segments", n), "crossings"},
      [&] { return arranged(scene).complex; },
      [](const PlaneComplex& c) {
        return Facts{static_cast<double>(c.points.crossings.size()), bytes_of(c)};
      });
  const std::size_t corners = options.size(10000, 100);
  const Nef2 star = Nef2::polygon(testing::star_polygon(corners, 1));
  table.add(
      {"PlaneLocator", fmt::format("star of {} corners", corners), "edges", true},
      [&] { return std::make_unique<PlaneLocator>(star.complex()); },
      [&](const auto&) {
        return Facts{static_cast<double>(star.complex().edge_count()),
                     locator_bytes_of(star.complex())};
      });
}

void add_space(Table& table, const MacroOptions& options) {
  const int depth = options.most < 50 ? 3 : 5;
  const PolygonMesh mesh = testing::icosphere_mesh(depth, 1, {0, 0, 0});
  const std::string sphere = fmt::format("icosphere of {}", mesh.face_count());
  const auto describe = [](const Nef3& set) {
    const SpaceComplex& c = set.complex();
    return Facts{static_cast<double>(c.facet_count()), bytes_of(c)};
  };
  table.add(
      {"PolygonMesh", sphere + ", as read", "faces"},
      [&] {
        Context context;
        const std::string text =
            text_of([&](std::ostream& out) { write_mesh(out, mesh, MeshFormat::Off); });
        return read_mesh(text, MeshFormat::Off, {}, context).mesh;
      },
      [](const PolygonMesh& m) {
        return Facts{static_cast<double>(m.face_count()), bytes_of(m)};
      });
  table.add(
      {"Nef3 with its tables", sphere, "facets"}, [&] { return testing::solid(mesh); }, describe);
  table.add(
      {"Nef3 with its tables", "union of two of these", "facets"},
      [&] {
        Context context;
        return boolean_op(testing::solid(mesh),
                          testing::solid(testing::moved(mesh, {0.3, 0.2, 0.1})), kUnion, context);
      },
      describe);
  const Nef3 set = testing::solid(mesh);
  table.add(
      {"SpaceLocator with its grid", sphere, "facets"},
      [&] {
        auto locator = std::make_unique<SpaceLocator>(set.complex());
        locator->locate(Point3{0.1, 0.2, 0.3});
        return locator;
      },
      [&](const auto&) {
        const auto facets = static_cast<double>(set.complex().facet_count());
        const double along = std::cbrt(4 * facets) + 2;  // cells of the grid, with the outer ones
        return Facts{facets, 76 * facets + 4 * along * along * along};  // as the headers say
      });
}

void add_drawn_surface(Table& table, const MacroOptions& options) {
  const SurfaceMesh mesh = testing::sphere_surface(options.most < 50 ? 3 : 5);
  const std::size_t count = options.size(100, 5);
  const std::string input = fmt::format("{} polygons on {} triangles", count, mesh.face_count());
  const SurfacePolygons polygons = traced_polygons(mesh, count);
  table.add(
      {"SurfaceArrangement", input, "half-edges", true},
      [&] {
        Context context;
        return slice(polygons, context);
      },
      [](const SurfaceArrangement& a) {
        return Facts{static_cast<double>(a.halfedge_count()), bytes_of(a)};
      });
  Context context;
  const SurfaceArrangement arrangement = slice(polygons, context);
  table.add(
      {"SurfaceCells", input, "cells"},
      [&] {
        Context own;
        return make_cells(mesh, arrangement, own);
      },
      [](const SurfaceCells& c) {
        return Facts{static_cast<double>(c.size()), bytes_of(c)};
      });
}

void add_sphere_and_surface(Table& table, const MacroOptions& options) {
  const std::size_t n = options.size(10000, 1000) / 2 * 2;
  table.add(
      {"SphereMap", fmt::format("crown of {} corners", n), "arcs"},
      [&] {
        const NefSphere set = testing::crown(n, 0, 0.5, 1.5);
        return SphereMap(set.map());
      },
      [](const SphereMap& m) {
        return Facts{static_cast<double>(m.arc_count()), bytes_of(m)};
      });
  const NefSphere crown = testing::crown(n, 0, 0.5, 1.5);
  table.add(
      {"NefSphere with its planes", fmt::format("crown of {} corners", n), "arcs", true},
      [&] { return testing::crown(n, 0, 0.5, 1.5); },
      [](const NefSphere& set) {
        return Facts{static_cast<double>(set.map().arc_count()),
                     bytes_of(set.map()) + bytes_of(set.planes())};
      });
  table.add(
      {"SphereLocator", fmt::format("crown of {} corners", n), "arcs and points", true},
      [&] { return SphereLocator(crown); },
      [&](const SphereLocator&) {
        const auto items = static_cast<double>(crown.map().arc_count() + crown.map().point_count());
        // Bounds, boxes, order, walks; at most a node of 88 bytes an item; and its own planes.
        const double each = kSize<SphereBound> + kSize<Box3> + 2 * kSize<std::uint32_t> + 88;
        return Facts{items, each * items + bytes_of(crown.planes())};
      });
  const int depth = options.most < 50 ? 4 : 6;
  const SurfaceMesh made = testing::sphere_surface(depth);
  table.add(
      {"SurfaceMesh", fmt::format("sphere of 20 * 4^{}", depth), "triangles"},
      [&] {
        std::vector<Point3> points(made.vertex_count());
        for (std::size_t i = 0; i < points.size(); ++i) points[i] = made.point(VertexId(i));
        std::vector<SurfaceTriangle> triangles(made.face_count());
        for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = made.corners(FaceId(i));
        return SurfaceMesh(std::move(points), std::move(triangles));
      },
      [](const SurfaceMesh& m) {
        const auto faces = static_cast<double>(m.face_count());
        constexpr double kId = kSize<std::uint32_t>;
        // corners, flipped, component; per half-edge twin and edge; per edge one; per vertex point
        // and half-edge
        return Facts{faces, faces * (kSize<SurfaceTriangle> + 1 + kId) + 3 * faces * 2 * kId +
                                1.5 * faces * kId +
                                static_cast<double>(m.vertex_count()) * (kSize<Point3> + kId)};
      });
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  using namespace plumb::bench;
  keep_freed_memory();  // mapped blocks are not counted
  return macro_main("memory", "Memory of structures", argc, argv,
                    [](const MacroOptions& options, nlohmann::ordered_json& rows) {
                      Table table(rows);
                      add_plane(table, options);
                      add_space(table, options);
                      add_sphere_and_surface(table, options);
                      add_drawn_surface(table, options);
                      return table.is_within() ? 0 : 1;
                    });
}
