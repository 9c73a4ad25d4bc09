// Meshes as arrays: from files and to files, checked and mended. plumb/_mesh.py makes plumb.Mesh of
// these functions.
//
// Tests: tests/test_mesh.py.
#include <optional>

#include "attributes.h"
#include "plumb/io/mesh_io.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/repair_mesh.h"
#include "set_grammar.h"

namespace plumb::python {
namespace {

using Flat = ArrayOut<std::uint32_t, 1>;
using Chains = std::vector<std::vector<std::uint32_t>>;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
using MeshArrays = std::tuple<ArrayOut<double, 3>, Flat, Flat>;

MeshArrays arrays_of(PolygonMesh mesh) {
  const std::span<const double> xyz = coordinates_of(mesh);
  return {{std::vector<double>(xyz.begin(), xyz.end())},
          {std::move(mesh.face_begin)},
          {std::move(mesh.corners)}};
}

MeshView view_of(const Coordinates3& vertices, const Indices& face_begin, const Indices& corners) {
  return mesh_of_polygons(vertices.span(), face_begin.span(), corners.span());
}

MeshFile read_file(Context& context, const Path& path, bool exact_decimals, bool attributes) {
  ReadOptions options{path.string(), exact_decimals};
  options.attributes = attributes;
  return read_mesh_file(path.string(), {}, options, context);
}

std::optional<MeshFormat> written_format(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  const std::optional<MeshFormat> format = mesh_format_named(*name);
  if (!format || *name == "gltf") {
    throw Error(ErrorCode::UnknownFormat, "no format for meshes is named '" + *name + "'");
  }
  return format;
}

/// Returns a remark on the attributes that the file does not hold, or an empty text.
std::string write_file(Context&, const Path& path, const Coordinates3& vertices,
                       const Indices& face_begin, const Indices& corners, const AttributesIn& given,
                       const std::optional<std::string>& format) {
  const MeshView view = view_of(vertices, face_begin, corners);
  const MeshAttributes attributes = fitted_attributes(given, view);
  const std::optional<MeshFormat> wanted = written_format(format);
  write_mesh_file(path.string(), copied_mesh(view), attributes, wanted);
  const std::optional<MeshFormat> used = wanted ? wanted : mesh_format_of(path.string());
  return used ? lost_attributes(attributes, *used) : std::string();
}

using ReportLists = std::tuple<std::uint64_t, std::vector<Flat>, Pairs, Pairs, Chains, Chains>;

ReportLists check(Context& context, const Coordinates3& vertices, const Indices& face_begin,
                  const Indices& corners, std::uint64_t max_listed) {
  MeshOptions options;
  options.max_listed = max_listed;
  MeshReport found =
      complex_of_mesh(view_of(vertices, face_begin, corners), options, context).report;
  std::vector<Flat> lists;
  for (auto* const list : {&found.degenerate, &found.trimmed, &found.not_planar, &found.not_simple,
                           &found.flipped, &found.one_sided, &found.inside_out}) {
    lists.push_back({std::move(*list)});
  }
  return {found.crossing_count,       std::move(lists),         std::move(found.doubled),
          std::move(found.crossings), std::move(found.borders), std::move(found.holes)};
}

DoubledFaces doubled_of(const std::string& name) {
  if (name == "keep") return DoubledFaces::Keep;
  if (name == "drop-if-better") return DoubledFaces::DropIfBetter;
  if (name == "drop") return DoubledFaces::Drop;
  throw Error(ErrorCode::BadArgument,
              "doubled must be 'keep', 'drop-if-better' or 'drop', not '" + name + "'");
}

using Mended = std::tuple<MeshArrays, MeshAttributes, std::vector<std::string>>;

Mended mend(Context& context, const Coordinates3& vertices, const Indices& face_begin,
            const Indices& corners, const AttributesIn& given, double weld,
            const std::string& doubled, bool reorient, std::uint32_t fill_holes,
            double fill_holes_below) {
  const MeshView view = view_of(vertices, face_begin, corners);
  PolygonMesh mesh = copied_mesh(view);
  MeshAttributes attributes = fitted_attributes(given, view);
  const RepairOptions options{weld, doubled_of(doubled), reorient, fill_holes, fill_holes_below};
  const RepairReport done = repair_mesh(mesh, attributes, options, context);
  return {arrays_of(std::move(mesh)), std::move(attributes), sentences(done)};
}

void def_files(nb::module_& m) {
  m.def(
      "read_mesh_arrays",
      [](const Path& path, bool exact_decimals, bool attributes, unsigned threads,
         std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        MeshFile file =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                [&](Context& k) { return read_file(k, path, exact_decimals, attributes); });
        warn(file.warnings);
        note(file.notes);
        return std::pair(arrays_of(std::move(file.mesh)),
                         AttributesOut{std::move(file.attributes)});
      },
      "path"_a, "exact_decimals"_a, "attributes"_a, nb::kw_only(), "threads"_a = 1U,
      "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      "Return the arrays and the attributes of a file.");
  m.def("write_mesh_arrays", with_context(&write_file), "path"_a, "vertices"_a, "face_begin"_a,
        "corners"_a, "attributes"_a.none(), "format"_a.none(), nb::kw_only(), "threads"_a = 1U,
        "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
        "Write a file. Return a sentence about the attributes that the format cannot represent, "
        "or ''.");
}

}  // namespace

void bind_meshes(nb::module_& m) {
  def_files(m);
  m.def("check_mesh_arrays", with_context(&check), "vertices"_a, "face_begin"_a, "corners"_a,
        "max_listed"_a, nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(),
        "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
        "Return a report on the defects "
        "of a mesh.");
  m.def(
      "repair_mesh_arrays",
      [](const Coordinates3& vertices, const Indices& face_begin, const Indices& corners,
         const AttributesIn& attributes, double weld, const std::string& doubled, bool reorient,
         std::uint32_t fill_holes, double fill_holes_below, unsigned threads,
         std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        auto [mesh, kept, done] =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)}, [&](Context& k) {
              return mend(k, vertices, face_begin, corners, attributes, weld, doubled, reorient,
                          fill_holes, fill_holes_below);
            });
        return std::tuple(std::move(mesh), AttributesOut{std::move(kept)}, std::move(done));
      },
      "vertices"_a, "face_begin"_a, "corners"_a, "attributes"_a, "weld"_a, "doubled"_a,
      "reorient"_a, "fill_holes"_a, "fill_holes_below"_a, nb::kw_only(), "threads"_a = 1U,
      "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      "Return a repaired mesh, its attributes, and sentences that describe the repairs.");
}

}  // namespace plumb::python
