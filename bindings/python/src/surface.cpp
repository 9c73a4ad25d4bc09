// plumb.Surface and plumb.SurfaceDivision: orientable triangle meshes, geodesics on them, and their
// division by closed polygons.
//
// A point of a surface is the index of a vertex, or (face, u, v) with the weights of the second and
// the third corner of the face. The corners of a flipped face are exchanged (surface_mesh.h); the
// weights are those of the triangle as it was given.
// Tests: tests/test_surface.py.
#include "plumb/surface/surface.h"

#include <cmath>
#include <memory>

#include "page.h"
#include "plumb/base/set_expression.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/surface_writer.h"
#include "plumb/io/text/files.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/surface/surface_arrays.h"
#include "plumb/surface/trace.h"
#include "plumb/surface/triangulation.h"

namespace plumb::python {

/// A point of a surface as a user gives it.
struct Spot {
  std::uint32_t index = 0;  ///< The vertex, or the face.
  std::optional<std::pair<Rational, Rational>> weights;
  std::exception_ptr problem;
};

/// Reads a point of a surface; throws TypeError, and Error{NotFinite} and Error{BadIndex}.
void read_spot(nb::handle source, Spot& spot) {
  std::uint32_t index = 0;
  const bool is_vertex = PyLong_Check(source.ptr()) || PyIndex_Check(source.ptr());
  if (!is_vertex && (!nb::hasattr(source, "__len__") || nb::len(source) != 3)) {
    nb::raise_type_error("A point of a surface is a vertex, or (face, u, v).");
  }
  const Rational number = rational_of(is_vertex ? nb::borrow(source) : nb::object(source[0]));
  if (!nb::try_cast(fraction_of(number).attr("__int__")(), index) || number != index) {
    throw Error(ErrorCode::BadIndex, "there is no vertex or face " + number.str());
  }
  spot.index = index;
  if (!is_vertex) spot.weights = std::pair(rational_of(source[1]), rational_of(source[2]));
}

}  // namespace plumb::python

namespace nanobind::detail {

template <>
struct type_caster<plumb::python::Spot> {
  NB_TYPE_CASTER(plumb::python::Spot,
                 const_name("int | tuple[int, float | fractions.Fraction, float | "
                            "fractions.Fraction]"))
  bool from_python(handle source, std::uint32_t, cleanup_list*) noexcept {
    try {
      plumb::python::read_spot(source, value);
    } catch (...) {
      value.problem = std::current_exception();
    }
    return true;
  }
};

}  // namespace nanobind::detail

namespace plumb::python {
namespace {

using Polygon = std::vector<Spot>;

/// A mesh that divisions share.
struct Surface {
  std::shared_ptr<const SurfaceMesh> mesh;
};

/// A locally shortest path.
struct Geodesic {
  std::vector<double> points;
  std::vector<std::uint32_t> faces;

  double length() const {
    double sum = 0;
    for (std::size_t i = 3; i < points.size(); i += 3) {
      sum += std::hypot(points[i] - points[i - 3], points[i + 1] - points[i - 2],
                        points[i + 2] - points[i - 1]);
    }
    return sum;
  }
};

Surface surface_from_arrays(Context&, const Coordinates3& vertices, const Triangles& triangles) {
  const MeshView mesh = mesh_of_triangles(vertices.span(), triangles.span());
  return {std::make_shared<SurfaceMesh>(surface_of(mesh))};
}

SurfacePointId add_spot(SurfacePointTable& table, const Spot& spot) {
  const SurfaceMesh& mesh = table.mesh();
  if (!spot.weights) {
    if (spot.index >= mesh.vertex_count()) {
      throw Error(ErrorCode::BadIndex, "there is no vertex " + std::to_string(spot.index));
    }
    return table.add_vertex(VertexId(spot.index));
  }
  if (spot.index >= mesh.face_count()) {
    throw Error(ErrorCode::BadIndex, "there is no face " + std::to_string(spot.index));
  }
  const FaceId face(spot.index);
  const auto& [u, v] = *spot.weights;
  return mesh.is_flipped(face) ? table.add_in_face(face, v, u) : table.add_in_face(face, u, v);
}

void append(std::vector<double>& to, const Point3& p) { to.insert(to.end(), {p.x, p.y, p.z}); }

std::optional<Geodesic> geodesic(Context& context, const Surface& surface, const Spot& from,
                                 const Spot& to, bool is_shortest) {
  SurfacePointTable table(*surface.mesh);
  const SurfacePointId a = add_spot(table, from);
  const SurfacePointId b = add_spot(table, to);
  Tracer tracer(*surface.mesh, is_shortest ? PathChoice::Shortest : PathChoice::Local);
  const std::optional<SurfacePath> path = tracer.trace(table, a, b, context);
  if (!path) return std::nullopt;
  Geodesic result;
  for (const SurfacePointId p : path->points) append(result.points, table.position(p));
  for (const FaceId f : path->faces) result.faces.push_back(f.value());
  return result;
}

SurfaceDivision divided(Context& context, const Surface& surface,
                        const std::vector<Polygon>& polygons,
                        const std::optional<std::vector<std::vector<std::uint32_t>>>& shapes,
                        const std::optional<std::uint32_t>& outside) {
  SurfaceScene scene{surface.mesh, SurfacePolygons(*surface.mesh), shapes, FaceId(), {}};
  Tracer tracer(*surface.mesh);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    std::vector<SurfacePointId> control;
    for (const Spot& spot : polygons[i]) control.push_back(add_spot(scene.polygons.points, spot));
    if (const auto at = add_traced_polygon(tracer, control, scene.polygons, context)) {
      throw Error(ErrorCode::BadShape, "polygon " + std::to_string(i) +
                                           ": no path leads on from its point " +
                                           std::to_string(*at));
    }
  }
  if (outside) {
    if (*outside >= surface.mesh->face_count()) {
      throw Error(ErrorCode::BadIndex, "there is no face " + std::to_string(*outside));
    }
    scene.outside = FaceId(*outside);
  }
  return SurfaceDivision(std::move(scene), context);
}

CellId cell_at(const SurfaceDivision& division, std::uint32_t cell) {
  if (cell >= division.cell_count()) {
    throw Error(ErrorCode::BadIndex, "there is no cell " + std::to_string(cell));
  }
  return CellId(cell);
}

std::vector<std::pair<std::uint32_t, std::int64_t>> labels_of(const SurfaceDivision& division,
                                                              std::uint32_t cell) {
  std::vector<std::pair<std::uint32_t, std::int64_t>> result;
  for (const SignedEntry& entry : division.labels(cell_at(division, cell))) {
    result.emplace_back(entry.id, entry.value);
  }
  return result;
}

/// Selected cells, with their borders.
struct Region {
  std::vector<std::uint8_t> cells;
  double area = 0;
  std::vector<std::vector<double>> borders;
};

Region region_of(Context& context, const SurfaceDivision& division, const std::string& expression,
                 const std::string& rule) {
  const SurfaceResult found =
      division.evaluate(parse_set_expression(expression), winding_rule(rule), context);
  Region result{found.region.is_selected, found.region.area, {}};
  for (std::size_t p = 0; p < found.borders.size(); ++p) {
    std::vector<double>& loop = result.borders.emplace_back();
    for (const SurfacePointId id : found.borders.points_of(p)) {
      append(loop, found.borders.points.position(id));
    }
  }
  return result;
}

using CellMesh =
    std::tuple<ArrayOut<double, 3>, ArrayOut<std::uint32_t, 3>, ArrayOut<std::uint32_t, 1>>;

CellMesh triangles_of(Context& context, const SurfaceDivision& division) {
  const SurfaceTriangulation made = triangulate_surface(division, context);
  CellMesh result;
  auto& [points, triangles, cells] = result;
  for (const Point3& p : made.points) append(points.values, p);
  for (const SurfaceTriangle& t : made.triangles) {
    triangles.values.insert(triangles.values.end(), {t[0], t[1], t[2]});
  }
  for (const CellId c : made.cell) cells.values.push_back(c.value());
  return result;
}

std::monostate write_cells(Context& context, const SurfaceDivision& division, const Path& path) {
  const bool is_ply = path.extension() == ".ply";
  if (!is_ply && path.extension() != ".obj") {
    throw Error(ErrorCode::UnknownFormat, "a divided surface is written as .obj or .ply");
  }
  const SurfaceTriangulation made = triangulate_surface(division, context);
  OutputFile file(path.string());
  if (is_ply) {
    write_surface_ply(file.stream(), made, {});
  } else {
    write_surface_obj(file.stream(), made, division.cell_count(), {});
  }
  file.finish();
  file.commit();
  return {};
}

CountsOut surface_counts(const SurfaceDivision& division) {
  const SurfaceCounts n = division.counts();
  CountsOut result;
  result["triangles"] = n.triangles;
  result["segments"] = n.segments;
  result["crossings"] = n.crossings;
  result["cells"] = n.cells;
  result["cell_edges"] = n.cell_edges;
  return result;
}

void bind_surface_class(nb::module_& m) {
  nb::class_<Surface> c(m, "Surface",
                        "An orientable manifold of triangles, with or without a border. A point "
                        "is given by the index of a vertex, or by (face, u, v). Here u and v are "
                        "the exact weights of the second and the third corner of the face.");
  def_run_static(c, "from_mesh", &surface_from_arrays,
                 "Return the surface of triangles. vertices: float64 (n, 3). triangles: uint32 "
                 "(m, 3).",
                 "vertices"_a, "triangles"_a);
  def_run(c, "geodesic", &geodesic,
          "Return a locally shortest path between two points, or None if no path joins them. If "
          "`shortest` is true, the path is globally shortest: no other path is shorter by more "
          "than 2**-40 of its length. This takes longer.",
          "start"_a, "end"_a, "shortest"_a = false);
  def_run(
      c, "divide", &divided,
      "Divide the surface by closed polygons. A polygon is a list of points, which are joined by "
      "geodesics. `shapes` lists the polygons of each shape; by default, each polygon is a shape. "
      "Labels are 0 at the first corner of the face `outside`.",
      "polygons"_a, "shapes"_a = nb::none(), "outside"_a = nb::none());
  c.def_prop_ro(
      "vertex_count", [](const Surface& s) { return s.mesh->vertex_count(); },
      "The number of vertices.");
  c.def_prop_ro(
      "face_count", [](const Surface& s) { return s.mesh->face_count(); },
      "The number of triangles.");
  c.def_prop_ro(
      "component_count", [](const Surface& s) { return s.mesh->component_count(); },
      "The number of connected components.");
  c.def("__repr__", [](const Surface& s) {
    return "<plumb.Surface: " + std::to_string(s.mesh->vertex_count()) + " vertices, " +
           std::to_string(s.mesh->face_count()) + " faces>";
  });
}

void bind_paths(nb::module_& m) {
  nb::class_<Geodesic> path(m, "Geodesic", "A locally shortest path on a surface.");
  path.def_prop_ro(
      "points", [](const Geodesic& g) { return ArrayOut<double, 3>{g.points}; },
      "The rounded points of the path: float64 (k, 3).");
  path.def_prop_ro(
      "faces", [](const Geodesic& g) { return ArrayOut<std::uint32_t, 1>{g.faces}; },
      "The face of each segment: uint32 (k - 1,).");
  path.def_prop_ro("length", &Geodesic::length, "The rounded length.");
  nb::class_<Region> region(m, "SurfaceRegion", "Selected cells of a divided surface.");
  region.def_prop_ro(
      "cells", [](const Region& r) { return ArrayOut<bool, 1>{r.cells}; },
      "Whether each cell is selected: bool (cells,).");
  region.def_ro("area", &Region::area, "The rounded area of the selected cells.");
  region.def_prop_ro(
      "borders",
      [](const Region& r) {
        std::vector<ArrayOut<double, 3>> loops;
        for (const std::vector<double>& loop : r.borders) loops.push_back({loop});
        return loops;
      },
      "The borders of the region as rounded closed polygons, each float64 (k, 3). The region lies "
      "to their left.");
}

void bind_division(nb::module_& m) {
  nb::class_<SurfaceDivision> c(m, "SurfaceDivision", "A surface that polygons divide into cells.");
  c.def_static(
      "read",
      [](const Path& path, unsigned threads, std::optional<double> timeout,
         std::optional<std::uint64_t> memory_limit, nb::object progress) {
        auto [division, notes, warnings] =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)}, [&](Context& k) {
              SceneFile file = read_scene_file(path.string(), {}, k);
              return std::tuple(SurfaceDivision(std::move(file.scene), k), std::move(file.notes),
                                std::move(file.warnings));
            });
        warn(warnings);
        note(notes);
        return std::move(division);
      },
      "path"_a, nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(),
      "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits("Read a scene (a mesh and polygons on it) and divide the surface."));
  c.def("counts", &surface_counts,
        "Return the numbers of triangles, segments, crossings and cells.");
  c.def_prop_ro("cell_count", &SurfaceDivision::cell_count, "The number of cells.");
  c.def_prop_ro("shape_count", &SurfaceDivision::shape_count, "The number of shapes.");
  c.def("labels", &labels_of, "cell"_a,
        "Return the labels of a cell that are not 0, as pairs (shape, value).");
  c.def(
      "area", [](const SurfaceDivision& d, std::uint32_t cell) { return d.area(cell_at(d, cell)); },
      "cell"_a, "Return the rounded area of a cell.");
  c.def(
      "separates",
      [](const SurfaceDivision& d, std::uint32_t shape) {
        if (shape >= d.shape_count()) {
          throw Error(ErrorCode::BadIndex, "there is no shape " + std::to_string(shape));
        }
        return d.shape_separation(shape).over_z;
      },
      "shape"_a, "Whether the shape has an integer label, so that it has an inside.");
  def_run(c, "select", &region_of,
          "Return the cells that satisfy an expression over the shapes A, B, C, ..., such as "
          "'A * !B'.",
          "expression"_a, "rule"_a = "positive");
  def_run(c, "to_mesh", &triangles_of,
          "Return triangles that follow the polygons: points float64 (n, 3), triangles uint32 "
          "(m, 3), and the cell of each triangle, uint32 (m,).");
  def_run(c, "write", &write_cells,
          "Write the triangles with their cells as .obj or .ply. If writing fails, no incomplete "
          "file remains.",
          "path"_a);
  c.def("__repr__",
        [](const SurfaceDivision& d) { return "<plumb.SurfaceDivision: " + facts_of(d) + ">"; });
  def_page(c);
}

}  // namespace

void bind_surface(nb::module_& m) {
  bind_paths(m);
  bind_surface_class(m);
  bind_division(m);
}

}  // namespace plumb::python
