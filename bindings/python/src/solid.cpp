// plumb.Solid: sets of space (Nef3).
//
// The grammar of all sets is in set_grammar.h. Files are read by read_solid() and written by
// SolidText, as the program does, so that both say the same of what a file does not hold.
// Tests: tests/test_solid.py, tests/test_attributes.py, tests/test_laws.py.
#include <nanobind/stl/map.h>

#include <filesystem>
#include <map>

#include "attributes.h"
#include "page.h"
#include "plumb/base/set_expression.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/text/files.h"
#include "plumb/space/canonical.h"
#include "plumb/space/repair_mesh.h"
#include "set_grammar.h"

namespace plumb::python {

template <>
struct SetTraits<Nef3> {
  static constexpr std::size_t kDimension = 3;
  static constexpr const char* kShootDoc =
      "Return the first marked cell that the ray from `origin` meets, and the first point of this "
      "cell on the ray, or None.";

  static RationalPoint3 point_of(const Exact<3>& p) { return {p.value[0], p.value[1], p.value[2]}; }
  static std::vector<Rational> coordinates(const RationalPoint3& p) { return {p.x, p.y, p.z}; }
  static Cell cell_of(const SpaceLocation& location) {
    static constexpr std::array kNames{"vertex", "edge", "facet", "volume"};
    const auto kind = static_cast<std::size_t>(location.item.kind());
    return {kNames[kind], location.item.index(), location.marked};
  }
  static std::string repr(const Nef3& set) {
    const SpaceCounts n = set.counts();
    return "<plumb.Solid: " + std::to_string(n.vertices) + " vertices, " + std::to_string(n.edges) +
           " edges, " + std::to_string(n.facets) + " facets, " + std::to_string(n.volumes) +
           " volumes (" + std::to_string(n.marked_volumes) + " marked)>";
  }
};

namespace {

using Mesh = std::pair<ArrayOut<double, 3>, ArrayOut<std::uint32_t, 3>>;

std::vector<RationalPoint3> points_of(const std::vector<Exact<3>>& points) {
  std::vector<RationalPoint3> result;
  result.reserve(points.size());
  for (const Exact<3>& p : points) result.push_back(SetTraits<Nef3>::point_of(p));
  return result;
}

Plane3 plane_of(const Exact<4>& p) { return {p.value[0], p.value[1], p.value[2], p.value[3]}; }

AffineMap3 map_of(const std::vector<Exact<4>>& rows) {
  if (rows.size() != 3) throw Error(ErrorCode::BadArgument, "the matrix must have three rows");
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) map.matrix[i][j] = rows[i].value[j];
    map.offset[i] = rows[i].value[3];
  }
  return map;
}

CountsOut counts_of(const Nef3& set) {
  const SpaceCounts n = set.counts();
  CountsOut result;
  result["vertices"] = n.vertices;
  result["edges"] = n.edges;
  result["facets"] = n.facets;
  result["volumes"] = n.volumes;
  result["marked_volumes"] = n.marked_volumes;
  return result;
}

// --- meshes -----------------------------------------------------------------------------------

Nef3 from_view(Context& context, const MeshView& mesh, const std::optional<std::string>& rule,
               bool surface, const AttributesIn& attributes) {
  FromMeshOptions options;
  options.rule = winding_rule(rule);
  options.surface = surface;
  return with_attributes(Nef3::from_mesh(mesh, options, context), mesh, attributes);
}

Nef3 from_mesh(Context& context, const Coordinates3& vertices, const Triangles& triangles,
               const std::optional<std::string>& rule, bool surface,
               const AttributesIn& attributes) {
  return from_view(context, mesh_of_triangles(vertices.span(), triangles.span()), rule, surface,
                   attributes);
}

Nef3 from_polygons(Context& context, const Coordinates3& vertices, const Indices& face_begin,
                   const Indices& corners, const std::optional<std::string>& rule, bool surface,
                   const AttributesIn& attributes) {
  return from_view(context, mesh_of_polygons(vertices.span(), face_begin.span(), corners.span()),
                   rule, surface, attributes);
}

PieceJoin join_of(const std::string& pieces) {
  if (pieces == "same-attributes") return PieceJoin::SameAttributes;
  if (pieces == "same-face") return PieceJoin::SameFace;
  if (pieces == "apart") return PieceJoin::None;
  throw Error(ErrorCode::BadArgument,
              "pieces must be 'same-attributes', 'same-face' or 'apart', not '" + pieces + "'");
}

MeshOut to_mesh_with_attributes(Context& context, const Nef3& set, const std::string& pieces,
                                bool polygons, bool floats) {
  if (polygons && floats) {
    throw Error(ErrorCode::BadArgument, "meshes of floats consist of triangles");
  }
  AttributeOptions options;
  options.join = join_of(pieces);
  options.faces = polygons ? MeshFaces::PlanarPolygons : MeshFaces::Triangles;
  options.type = floats ? CoordinateType::Float : CoordinateType::Double;
  return {mesh_with_attributes(set, options, context)};
}

std::vector<std::string> source_names(const Nef3& set) {
  std::vector<std::string> names;
  for (const PlacedSource& placed : set.sources()) names.push_back(placed.source->name);
  return names;
}

OutputRounding rounding_of(const std::string& name) {
  if (name == "valid") return OutputRounding::Valid;
  if (name == "nearest") return OutputRounding::Nearest;
  throw Error(ErrorCode::BadArgument, "rounding must be 'valid' or 'nearest', not '" + name + "'");
}

/// Returns the boundary with every coordinate rounded to the nearest double.
Mesh nearest_mesh(Context& context, const Nef3& set) {
  MeshOfComplex made =
      mesh_of_complex(set.complex(), {MeshFaces::Triangles, false, false}, context);
  if (made.report.is_unbounded) {
    throw Error(ErrorCode::BadArgument, "a mesh cannot hold an unbounded solid");
  }
  const std::span<const double> xyz = coordinates_of(made.mesh);
  return {{std::vector<double>(xyz.begin(), xyz.end())}, {std::move(made.mesh.corners)}};
}

Mesh to_mesh(Context& context, const Nef3& set, const std::string& rounding) {
  if (rounding_of(rounding) == OutputRounding::Nearest) return nearest_mesh(context, set);
  TriangleMesh mesh = set.to_mesh(context);
  return {{std::move(mesh.coordinates)}, {std::move(mesh.triangles)}};
}

using PolygonArrays = std::tuple<ArrayOut<double, 3>, ArrayOut<std::uint32_t, 1>,
                                 ArrayOut<std::uint32_t, 1>, ArrayOut<std::uint32_t, 1>>;

PolygonArrays to_polygons(Context& context, const Nef3& set) {
  MeshOfComplex made = set.to_polygons({}, context);
  if (made.report.is_unbounded) {
    throw Error(ErrorCode::BadArgument, "a mesh cannot hold an unbounded solid");
  }
  const std::span<const double> xyz = coordinates_of(made.mesh);
  std::vector<std::uint32_t> facets;
  facets.reserve(made.facet.size());
  for (const FacetId f : made.facet) facets.push_back(f.value());
  return {{std::vector<double>(xyz.begin(), xyz.end())},
          {std::move(made.mesh.face_begin)},
          {std::move(made.mesh.corners)},
          {std::move(facets)}};
}

ArrayOut<bool, 1> contains_points(Context& context, const Nef3& set, const Coordinates3& points) {
  const std::span<const double> xyz = points.span();
  std::vector<Point3> list;
  list.reserve(xyz.size() / 3);
  for (std::size_t i = 0; i < xyz.size(); i += 3) list.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
  std::vector<Mark> marks(list.size());
  set.contains(list, marks, context);
  return {std::move(marks)};
}

// --- files ------------------------------------------------------------------------------------

KeptAttributes kept_attributes(const std::string& keep) {
  if (keep == "none") return KeptAttributes::None;
  if (keep == "colours") return KeptAttributes::Colours;
  if (keep == "ids") return KeptAttributes::Ids;
  if (keep == "all") return KeptAttributes::All;
  throw Error(ErrorCode::BadArgument,
              "keep must be 'none', 'colours', 'ids' or 'all', not '" + keep + "'");
}

SolidReadOptions read_options(const std::optional<std::string>& rule, bool surface,
                              bool exact_decimals, const std::optional<double>& weld, bool reorient,
                              std::uint32_t fill_holes, double fill_holes_below,
                              const std::string& keep) {
  SolidReadOptions options;
  options.rule = winding_rule(rule);
  options.surface = surface;
  options.exact_decimals = exact_decimals;
  options.repair.weld = weld.value_or(0);
  options.repair.reorient = reorient;
  options.repair.fill_holes = fill_holes;
  options.repair.fill_holes_below = fill_holes_below;
  options.attributes = kept_attributes(keep);
  return options;
}

void tell(const SolidRead& read) {
  warn(read.warnings);
  note(read.notes);
}

const SolidFormat& format_of(const std::string& path, const std::optional<std::string>& name) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const SolidFormat& format : solid_formats()) {
    if (name ? format.name == *name : format.extension == extension) return format;
  }
  throw Error(ErrorCode::UnknownFormat,
              name ? "no format for solids is named '" + *name + "'"
                   : "the extension of " + path + " names no format for solids");
}

struct WrittenSolid {
  std::vector<std::string> losses;
  std::vector<std::string> remarks;
};

WrittenSolid write_solid(Context& context, const Nef3& set, const std::string& path,
                         const SolidFormat& format, OutputRounding rounding) {
  const SolidText text(set, format, rounding, context, material_library_of(path));
  text.write_file(path, context);
  WrittenSolid said{text.losses(), text.changes()};
  if (!text.dropped().empty()) said.remarks.push_back(text.dropped());
  return said;
}

std::string canonical_bytes(Context& context, const Nef3& set) {
  const Nef3 numbered = canonical(set, context);
  return written([&](std::ostream& out) { write_nef3(out, numbered.complex(), context); });
}

Nef3 from_bytes(Context& context, const std::string& bytes) {
  return read_solid("data", bytes, {}, context).set;
}

// --- convexity --------------------------------------------------------------------------------

DecomposeMethod method_of(const std::string& name) {
  if (name == "best") return DecomposeMethod::Best;
  if (name == "cuts") return DecomposeMethod::Cuts;
  if (name == "walls") return DecomposeMethod::Walls;
  throw Error(ErrorCode::BadArgument,
              "method must be 'best', 'cuts' or 'walls', not '" + name + "'");
}

std::vector<Nef3> pieces_of(Context& context, const Nef3& set, const std::string& method,
                            bool closed) {
  return decompose(set, {method_of(method), closed}, context).pieces;
}

std::vector<std::uint32_t> reflex_edges_of(Context&, const Nef3& set) {
  std::vector<std::uint32_t> result;
  for (const EdgeId e : reflex_edges(set.complex())) result.push_back(e.value());
  return result;
}

Nef3 half_spaces(Context& context, const std::vector<Exact<4>>& planes, bool closed) {
  std::vector<HalfSpace3> list;
  list.reserve(planes.size());
  for (const Exact<4>& plane : planes) list.push_back({plane_of(plane), boundary_of(closed)});
  return Nef3::intersection(list, context);
}

Nef3 box(Context& context, const Exact<3>& low, const Exact<3>& high, bool closed) {
  std::vector<HalfSpace3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Rational, 3> axis{0, 0, 0};
    axis[i] = 1;
    const Rational below(-high.value[i]);
    sides.push_back({Plane3{axis[0], axis[1], axis[2], below}, boundary_of(closed)});
    axis[i] = -1;
    sides.push_back({Plane3{axis[0], axis[1], axis[2], low.value[i]}, boundary_of(closed)});
  }
  return Nef3::intersection(sides, context);
}

// --- sections and expressions -------------------------------------------------------------------

Section side_of(const std::string& name) {
  if (name == "closed") return Section::ClosedHalfSpace;
  if (name == "open") return Section::OpenHalfSpace;
  if (name == "plane") return Section::PlaneOnly;
  throw Error(ErrorCode::BadArgument,
              "side must be 'closed', 'open' or 'plane', not '" + name + "'");
}

Nef3 section_of(Context& context, const Nef3& set, const Exact<4>& plane, const std::string& side,
                const std::string& keep) {
  if (keep != "inside" && keep != "outside") {
    throw Error(ErrorCode::BadArgument, "keep must be 'inside' or 'outside', not '" + keep + "'");
  }
  const MarkFunction f = keep == "inside" ? kIntersection : kDifference;
  return boolean_op(set, plane_of(plane), side_of(side), f, context);
}

MarkFunction function_of(SetOperator op) {
  switch (op) {
    case SetOperator::Union:
      return kUnion;
    case SetOperator::Intersection:
      return kIntersection;
    case SetOperator::Difference:
      return kDifference;
    default:
      return kSymmetricDifference;
  }
}

using NamedSolids = std::map<std::string, Nef3>;

Nef3 value_of(Context& context, const std::string& expression, const NamedSolids& solids) {
  const SetExpression parsed = parse_set_expression(expression, SetOperators::WithSums);
  std::vector<Nef3> operands;
  for (const std::string& name : parsed.names) {
    const auto found = solids.find(name);
    if (found == solids.end()) {
      throw Error(ErrorCode::BadArgument, "there is no solid called '" + name + "'");
    }
    operands.push_back(found->second);
  }
  return plumb::evaluate<Nef3>(
      parsed, [&](std::uint32_t name) { return operands[name]; },
      [&](const Nef3& a) { return a.complement(context); },
      [&](SetOperator op, const Nef3& a, const Nef3& b) {
        if (op == SetOperator::MinkowskiSum) return minkowski_sum(a, b, context);
        return boolean_op(a, b, function_of(op), context);
      });
}

// --- the class --------------------------------------------------------------------------------

void def_makers(nb::class_<Nef3>& c) {
  def_run_static(
      c, "from_mesh", &from_mesh,
      "Return the solid that triangles bound. vertices: float64 (n, 3). triangles: uint32 (m, 3), "
      "counter-clockwise seen from outside. The mesh may cross itself. `rule` selects the winding "
      "numbers that are inside: 'positive', 'nonzero' or 'evenodd'. If it is None, components "
      "that are inside out are flipped first, and the rule is 'positive'. If `surface` is true, "
      "return the union of the faces instead. Raise OpenMesh if the mesh is not closed and "
      "`surface` is false. The solid and all results of operations on it keep the `attributes` of "
      "faces and corners:\n\n"
      "    paint = plumb.MeshAttributes(face_id=range(len(triangles)))\n"
      "    solid = plumb.Solid.from_mesh(vertices, triangles, attributes=paint)\n"
      "    (solid - other).to_mesh_with_attributes().face_id",
      "vertices"_a, "triangles"_a, "rule"_a = nb::none(), "surface"_a = false,
      "attributes"_a = nb::none());
  def_run_static(
      c, "from_polygons", &from_polygons,
      "Return the solid that polygons bound. vertices: float64 (n, 3). face_begin: uint32 (faces "
      "+ 1,), the indices in `corners` at which the corners of each face begin. corners: uint32 "
      "(k,). The other parameters are the same as for from_mesh().",
      "vertices"_a, "face_begin"_a, "corners"_a, "rule"_a = nb::none(), "surface"_a = false,
      "attributes"_a = nb::none());
  def_run_static(c, "half_spaces", &half_spaces,
                 "Return the intersection of half-spaces a x + b y + c z + d <= 0, or < 0 if not "
                 "`closed`. Each plane is given by four exact numbers (a, b, c, d).",
                 "planes"_a, "closed"_a = true);
  def_run_static(
      c, "half_space",
      +[](Context&, const Exact<4>& plane, bool closed, const AttributesIn& attributes) {
        const Plane3 boundary = plane_of(plane);
        return with_plane_source(Nef3::half_space(boundary, boundary_of(closed)), boundary,
                                 attributes);
      },
      "Return the points with a x + b y + c z + d <= 0, or < 0 if not `closed`. `attributes` "
      "describes the boundary, which is one face without channels. Faces of results that the "
      "half-space cuts have the attributes of this face:\n\n"
      "    cuts = plumb.MeshAttributes(name='saw', face_id=[7])\n"
      "    solid & plumb.Solid.half_space((0, 0, 1, -1), attributes=cuts)",
      "plane"_a, "closed"_a = true, "attributes"_a = nb::none());
  def_run_static(
      c, "plane", +[](Context&, const Exact<4>& plane) { return Nef3::plane(plane_of(plane)); },
      "Return the points with a x + b y + c z + d = 0.", "plane"_a);
  def_run_static(c, "box", &box, "Return the box between two exact corners.", "low"_a, "high"_a,
                 "closed"_a = true);
  def_run_static(
      c, "ball",
      +[](Context& k, double radius, unsigned rounds) {
        return polyhedral_ball(radius, rounds, k);
      },
      "Return a polyhedron of 8 * 4**rounds triangles that approximates a ball around the origin.",
      "radius"_a, "rounds"_a = 3U);
  def_run_static(
      c, "facet",
      +[](Context& k, const std::vector<Exact<3>>& corners) {
        return Nef3::facet(points_of(corners), k);
      },
      "Return the closed polygon with these exact corners, which must lie in one plane.",
      "corners"_a);
  def_run_static(
      c, "polyline",
      +[](Context& k, const std::vector<Exact<3>>& points) {
        return Nef3::polyline(points_of(points), k);
      },
      "Return the union of the closed segments from each exact point to the next.", "points"_a);
  def_run_static(
      c, "points",
      +[](Context& k, const std::vector<Exact<3>>& points) {
        return Nef3::points(points_of(points), k);
      },
      "Return the set of these exact points.", "points"_a);
}

void def_reading(nb::class_<Nef3>& c) {
  c.def("counts", &counts_of, "Return the numbers of vertices, edges, facets and volumes.");
  c.def("is_bounded", &Nef3::is_bounded, "Whether the set lies in some ball.");
  c.def("is_simple", &Nef3::is_simple, "Whether the boundary is a 2-manifold around the set.");
  c.def("is_convex", &Nef3::is_convex,
        "Whether the set contains the segment between any two of "
        "its points.");
  def_run(c, "to_mesh", &to_mesh,
          "Return the boundary of regularization() as arrays: vertices float64 (n, 3), triangles "
          "uint32 (m, 3). With rounding='valid', the triangles meet only in common corners and "
          "edges even after rounding. With rounding='nearest', coordinates are the nearest "
          "doubles, even if triangles then cross.",
          "rounding"_a = "valid");
  def_run(
      c, "to_polygons", &to_polygons,
      "Return the boundary of regularization() as polygons: vertices float64 (n, 3), face_begin "
      "uint32 (faces + 1,), corners uint32 (k,), facet uint32 (faces,).");
  def_run(
      c, "to_mesh_with_attributes", &to_mesh_with_attributes,
      "Return the boundary of regularization(), valid after rounding, as MeshWithAttributes. For "
      "each face, it states the source from which the face was made, and its material, group and "
      "id. It also has interpolated numbers at the corners. A facet consists of parts, each of "
      "which lies in one triangle of a source. `pieces` states which parts are joined to one "
      "face. With 'same-attributes', neighbouring parts with the same attributes are joined. "
      "With 'same-face', they are joined only if they also lie in one face of a source. With "
      "'apart', no parts are joined. If `polygons` is true, planar faces stay polygons. If "
      "`floats` is true, coordinates are rounded to float32 numbers, and stored as float64.\n\n"
      "    made = (red - blue).to_mesh_with_attributes()\n"
      "    from_blue = made.triangles[made.source == 1]",
      "pieces"_a = "same-attributes", "polygons"_a = false, "floats"_a = false);
  c.def("sources", &source_names,
        "Return the names of the meshes with attributes from which the solid was made, in the "
        "order of the operands. Bytes and pickles have no sources.");
  def_run(c, "contains_points", &contains_points,
          "Return for each point, a row of a float64 array (n, 3), whether it belongs to the set: "
          "bool (n,).",
          "points"_a);
  def_run(
      c, "volume", +[](Context& k, const Nef3& set) { return set.volume(k); },
      "Return the exact volume as a Fraction, or None if it is infinite.");
}

void def_operations(nb::class_<Nef3>& c) {
  def_run(
      c, "transformed",
      +[](Context& k, const Nef3& set, const std::vector<Exact<4>>& rows) {
        return set.transformed(map_of(rows), k);
      },
      "Return the exact image under an invertible affine map, which is given by three rows (a, b, "
      "c, d).",
      "matrix"_a);
  def_run(
      c, "translated",
      +[](Context& k, const Nef3& set, const Exact<3>& by) {
        return set.translated(SetTraits<Nef3>::point_of(by), k);
      },
      "Return the set moved by an exact vector.", "by"_a);
  def_run(c, "section", &section_of,
          "Return the points of the set on one side of the plane a x + b y + c z + d = 0, which "
          "is given by four exact numbers (a, b, c, d). `side` is 'closed' (<= 0), 'open' (< 0) "
          "or 'plane' (= 0). With keep='outside', return the other points of the set.",
          "plane"_a, "side"_a = "closed", "keep"_a = "inside");
  def_run_static(c, "evaluate", &value_of,
                 "Return the value of an expression such as '(A + B) * !C'. The operators are + "
                 "(union), * (intersection), - (difference), ^ (symmetric difference), ! "
                 "(complement) and @ (Minkowski sum), which binds more tightly than *. `solids` "
                 "contains the solid for each name.",
                 "expression"_a, "solids"_a);
  def_run(c, "decompose", &pieces_of,
          "Return the convex parts of the set. `method` is 'best', 'cuts' or 'walls'. If `closed` "
          "is true, return the closures of the parts. The parts keep attributes; faces on cuts "
          "have none.",
          "method"_a = "best", "closed"_a = false);
  def_run(c, "reflex_edges", &reflex_edges_of,
          "Return the edges around which the solid spans more than half a turn.");
  def_run(
      c, "minkowski_sum",
      +[](Context& k, const Nef3& a, const Nef3& b) { return minkowski_sum(a, b, k); },
      "Return the Minkowski sum: the set of all sums of a point of this set and a point of the "
      "other set.",
      "other"_a);
  def_run(
      c, "minkowski_erosion",
      +[](Context& k, const Nef3& a, const Nef3& b) { return minkowski_erosion(a, b, k); },
      "Return the set of the vectors by which the other set can be translated so that it lies in "
      "this set.",
      "other"_a);
  def_run(
      c, "distance", &distance_of<Nef3>,
      "Return the distance between the closures of this set and another set, with nearest points "
      "and the cells that contain these points. One of the sets must be bounded.",
      "other"_a);
}

void def_files(nb::class_<Nef3>& c) {
  c.def_static(
      "read",
      [](const Path& path, const std::optional<std::string>& rule, bool surface,
         bool exact_decimals, const std::optional<double>& weld, bool reorient,
         std::uint32_t fill_holes, double fill_holes_below, const std::string& keep,
         unsigned threads, std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        const SolidReadOptions options = read_options(rule, surface, exact_decimals, weld, reorient,
                                                      fill_holes, fill_holes_below, keep);
        SolidRead read =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                [&](Context& k) { return read_solid_file(path.string(), options, k); });
        tell(read);
        return std::move(read.set);
      },
      "path"_a, "rule"_a = nb::none(), "surface"_a = false, "exact_decimals"_a = false,
      "weld"_a = nb::none(), "reorient"_a = false, "fill_holes"_a = 0U, "fill_holes_below"_a = 0.0,
      nb::kw_only(), "keep"_a = "none", "threads"_a = 1U, "timeout"_a = nb::none(),
      "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits("Read a solid from OFF, OBJ, STL, PLY, glTF, 3MF or .nef. `weld`, `reorient`, "
                  "`fill_holes` (a number of edges) and `fill_holes_below` (a length) repair a "
                  "mesh first. `keep` selects the attributes of the mesh that the solid keeps: "
                  "'none', 'colours', 'ids' or 'all'. A FileWarning reports geometry that the set "
                  "does not represent."));
  c.def(
      "write",
      [](const Nef3& set, const Path& path, const std::optional<std::string>& format,
         const std::string& rounding, unsigned threads, std::optional<double> timeout,
         std::optional<std::uint64_t> memory_limit, nb::object progress) {
        const SolidFormat& chosen = format_of(path.string(), format);
        const OutputRounding mode = rounding_of(rounding);
        const WrittenSolid said =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                [&](Context& k) { return write_solid(k, set, path.string(), chosen, mode); });
        warn(said.losses);
        note(said.remarks);
      },
      "path"_a, "format"_a = nb::none(), "rounding"_a = "valid", nb::kw_only(), "threads"_a = 1U,
      "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits(
          "Write the solid as a mesh, or exactly as .nef. The format is `format` if it is given; "
          "otherwise the extension determines it. If writing fails, no incomplete file remains. A "
          "FileWarning reports properties of the solid that the file does not represent. A mesh "
          "has those attributes of the sources that the format can represent. The materials of an "
          "OBJ file are written to a file .mtl beside it."));
}

}  // namespace

void bind_solid(nb::module_& m) {
  nb::class_<Nef3> c(m, "Solid",
                     "A set of points of space that can be made from half-spaces by unions, "
                     "intersections and complements. It may be bounded or unbounded, open or "
                     "closed, and may have dangling parts. The set is immutable and exact.");
  def_set(c);
  def_bytes(c, &canonical_bytes, &from_bytes);
  def_makers(c);
  def_reading(c);
  def_operations(c);
  def_models(c);
  def_files(c);
  def_page(c);
}

}  // namespace plumb::python
