// Meshes: arrays in and out, files, mending, and reports.
//
// A mesh is checked when it is made of arrays: indices are in range, and coordinates are finite, so
// that writers, which check neither, may take any handle.
// Tested by tests/c/interface_test.c.
#include "files.h"
#include "handles.h"
#include "plumb/convex/convexity.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/repair_mesh.h"

struct plumb_mesh_report {
  static constexpr std::size_t kLists = PLUMB_MESH_HOLES + 1;
  std::array<std::vector<std::uint32_t>, kLists> lists;
  std::array<std::vector<std::uint32_t>, kLists> begins;  // Of lists of chains; else empty.
  std::uint64_t crossings = 0;
};

namespace plumb::c {

MeshFormat written_format(const std::string& name) {
  const std::optional<MeshFormat> format = mesh_format_named(name);
  if (!format || name == "gltf") {
    fail_format(name, "off, off-exact, obj, stl, stl-binary, ply, ply-text, glb, 3mf");
  }
  return *format;
}

namespace {

PolygonMesh checked_mesh(const MeshView& view) {
  const std::size_t points = view.point_count();
  PolygonMesh mesh;
  mesh.points.reserve(points);
  for (std::size_t i = 0; i < points; ++i) mesh.points.push_back(view.point(i));
  const auto is_bad = [points](std::uint32_t corner) { return corner >= points; };
  if (std::any_of(view.corners.begin(), view.corners.end(), is_bad)) {
    throw Error(ErrorCode::BadIndex, "a corner is no index of a point");
  }
  mesh.face_begin.reserve(view.face_count() + 1);
  mesh.corners.reserve(view.corners.size());
  for (std::size_t f = 0; f < view.face_count(); ++f) mesh.add_face(view.face(f));
  return mesh;
}

std::vector<std::uint32_t> flat(const std::vector<MeshReport::FacePair>& pairs) {
  std::vector<std::uint32_t> values;
  values.reserve(2 * pairs.size());
  for (const auto& [a, b] : pairs) {
    values.push_back(a);
    values.push_back(b);
  }
  return values;
}

void set_chains(const std::vector<std::vector<std::uint32_t>>& chains, std::size_t list,
                plumb_mesh_report& report) {
  report.begins[list].push_back(0);
  for (const std::vector<std::uint32_t>& chain : chains) {
    report.lists[list].insert(report.lists[list].end(), chain.begin(), chain.end());
    report.begins[list].push_back(static_cast<std::uint32_t>(report.lists[list].size()));
  }
}

plumb_mesh_report report_of(const MeshReport& found) {
  plumb_mesh_report report;
  report.lists[PLUMB_MESH_DEGENERATE] = found.degenerate;
  report.lists[PLUMB_MESH_TRIMMED] = found.trimmed;
  report.lists[PLUMB_MESH_NOT_PLANAR] = found.not_planar;
  report.lists[PLUMB_MESH_NOT_SIMPLE] = found.not_simple;
  report.lists[PLUMB_MESH_DOUBLED] = flat(found.doubled);
  report.lists[PLUMB_MESH_CROSSINGS] = flat(found.crossings);
  report.lists[PLUMB_MESH_FLIPPED] = found.flipped;
  report.lists[PLUMB_MESH_ONE_SIDED] = found.one_sided;
  report.lists[PLUMB_MESH_INSIDE_OUT] = found.inside_out;
  set_chains(found.borders, PLUMB_MESH_BORDERS, report);
  set_chains(found.holes, PLUMB_MESH_HOLES, report);
  report.crossings = found.crossing_count;
  return report;
}

plumb_mesh mesh_of_file(MeshFile file, plumb_notes& notes) {
  add_notes(notes, file.notes);
  add_warnings(notes, file.warnings);
  return {std::move(file.mesh), {}, std::move(file.attributes)};
}

plumb_repair_report report_of(const RepairReport& found) {
  plumb_repair_report report = PLUMB_REPAIR_REPORT_INIT;
  report.equal = found.equal;
  report.welded = found.welded;
  report.farthest = found.farthest;
  report.unused = found.unused;
  report.trimmed = found.trimmed;
  report.degenerate = found.degenerate.size();
  report.doubled = found.doubled.size();
  report.flipped = found.flipped.size();
  report.turned = found.turned.size();
  report.filled = found.filled.size();
  report.added = found.added;
  report.holes = found.holes.size();
  report.is_closed = found.is_closed();
  return report;
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

plumb_status plumb_mesh_from_triangles(const double* xyz, std::size_t point_count,
                                       const std::uint32_t* triangles, std::size_t triangle_count,
                                       plumb_mesh** out, plumb_error** error) {
  return make(out, error, [&] {
    return checked_mesh(mesh_of_triangles(finite(xyz, point_count, "xyz", 3),
                                          array(triangles, triangle_count, "triangles", 3)));
  });
}

plumb_status plumb_mesh_from_polygons(const double* xyz, std::size_t point_count,
                                      const std::uint32_t* face_begin, std::size_t face_count,
                                      const std::uint32_t* corners, std::size_t corner_count,
                                      plumb_mesh** out, plumb_error** error) {
  return make(out, error, [&] {
    return checked_mesh(mesh_of_polygons(finite(xyz, point_count, "xyz", 3),
                                         offsets(face_begin, face_count, "face_begin"),
                                         array(corners, corner_count, "corners")));
  });
}

plumb_status plumb_mesh_read(const char* bytes, std::size_t size, const plumb_read_options* options,
                             plumb_mesh** out, plumb_notes** notes, const plumb_context* context,
                             plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const std::string name = name_of(options);
    return mesh_of_file(
        read_mesh_of(name, bytes_of(bytes, size), read_options(options, name), call), told);
  });
}

plumb_status plumb_mesh_read_file(const char* path, const plumb_read_options* options,
                                  plumb_mesh** out, plumb_notes** notes,
                                  const plumb_context* context, plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const std::string name = text(path, "path");
    return mesh_of_file(read_mesh_file(name, {}, read_options(options, name), call), told);
  });
}

plumb_status plumb_mesh_write(const plumb_mesh* mesh, const char* format, plumb_bytes** out,
                              plumb_error** error) {
  return make(out, error, [&] {
    const MeshFormat wanted = written_format(text(format, "format"));
    need(mesh, "mesh");
    return written([&](std::ostream& stream) {
             write_mesh(stream, mesh->mesh, mesh->attributes, wanted);
           })
        .bytes;
  });
}

plumb_status plumb_mesh_write_file(const plumb_mesh* mesh, const char* path, const char* format,
                                   plumb_error** error) {
  return guarded(error, [&] {
    std::optional<MeshFormat> wanted;
    if (format != nullptr) wanted = written_format(format);
    const plumb_mesh& written = need(mesh, "mesh");
    write_mesh_file(text(path, "path"), written.mesh, written.attributes, wanted);
  });
}

std::size_t plumb_mesh_point_count(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.points.size() : 0;
}
std::size_t plumb_mesh_face_count(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.face_count() : 0;
}
std::size_t plumb_mesh_corner_count(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.corners.size() : 0;
}
const double* plumb_mesh_points(const plumb_mesh* mesh) {
  return mesh != nullptr ? coordinates_of(mesh->mesh).data() : nullptr;
}
const std::uint32_t* plumb_mesh_face_begin(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.face_begin.data() : nullptr;
}
const std::uint32_t* plumb_mesh_corners(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.corners.data() : nullptr;
}
const std::uint32_t* plumb_mesh_facets(const plumb_mesh* mesh) {
  return mesh != nullptr && !mesh->facets.empty() ? mesh->facets.data() : nullptr;
}

plumb_status plumb_mesh_exact_point(const plumb_mesh* mesh, std::size_t point, plumb_numbers** out,
                                    plumb_error** error) {
  return make(out, error, [&] {
    const PolygonMesh& of = need(mesh, "mesh").mesh;
    if (point >= of.points.size()) throw Error(ErrorCode::BadIndex, "there is no such point");
    const auto is_before = [](const auto& entry, std::size_t i) { return entry.first < i; };
    const auto entry = std::lower_bound(of.exact.begin(), of.exact.end(), point, is_before);
    const Point3& near = of.points[point];
    const bool is_exact = entry == of.exact.end() || entry->first != point;
    return numbers_of(is_exact ? RationalPoint3{near.x, near.y, near.z} : entry->second);
  });
}

plumb_status plumb_mesh_triangulate(const plumb_mesh* mesh, plumb_mesh** out,
                                    const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const plumb_mesh& from = need(mesh, "mesh");
    MeshAttributes attributes = from.attributes;
    PolygonMesh cut = triangulated(from.mesh, attributes, call);
    return plumb_mesh{std::move(cut), {}, std::move(attributes)};
  });
}

plumb_status plumb_mesh_repair(const plumb_mesh* mesh, const plumb_repair_options* options,
                               plumb_mesh** out, plumb_repair_report* report, plumb_notes** notes,
                               const plumb_context* context, plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const plumb_mesh& from = need(mesh, "mesh");
    plumb_mesh mended{from.mesh, {}, from.attributes};
    const RepairReport done =
        repair_mesh(mended.mesh, mended.attributes, repair_options(options), call);
    add_notes(told, sentences(done));
    if (report != nullptr) fill(report, report_of(done), "report");
    return mended;
  });
}

plumb_status plumb_mesh_find_repair(const plumb_mesh* mesh, plumb_repair_options* options,
                                    bool* found, const plumb_context* context,
                                    plumb_error** error) {
  return guarded(error, [&] {
    need(options, "options");
    need(found, "found");
    Call call(context);
    const std::optional<RepairOptions> remedy = remedy_for(need(mesh, "mesh").mesh, {}, call);
    if (remedy) {
      fill(options,
           {0, remedy->weld, static_cast<int>(remedy->doubled), remedy->reorient,
            remedy->fill_holes, remedy->fill_holes_below},
           "options");
    }
    *found = remedy.has_value();
  });
}

void plumb_mesh_free(plumb_mesh* mesh) { delete mesh; }

plumb_status plumb_mesh_check(const plumb_mesh* mesh, std::uint64_t max_listed,
                              plumb_mesh_report** out, const plumb_context* context,
                              plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    MeshOptions options;
    options.max_listed = max_listed;
    const MeshComplex found = complex_of_mesh(need(mesh, "mesh").mesh, options, call);
    return report_of(found.report);
  });
}

const std::uint32_t* plumb_mesh_report_list(const plumb_mesh_report* report, int list,
                                            std::size_t* count) {
  const bool is_there =
      report != nullptr && list >= 0 && static_cast<std::size_t>(list) < report->lists.size();
  if (count != nullptr)
    *count = is_there ? report->lists[static_cast<std::size_t>(list)].size() : 0;
  return is_there ? report->lists[static_cast<std::size_t>(list)].data() : nullptr;
}

const std::uint32_t* plumb_mesh_report_chains(const plumb_mesh_report* report, int list,
                                              std::size_t* count) {
  const bool is_there =
      report != nullptr && (list == PLUMB_MESH_BORDERS || list == PLUMB_MESH_HOLES);
  if (count != nullptr) {
    *count = is_there ? report->begins[static_cast<std::size_t>(list)].size() - 1 : 0;
  }
  return is_there ? report->begins[static_cast<std::size_t>(list)].data() : nullptr;
}

bool plumb_mesh_report_is_closed(const plumb_mesh_report* report) {
  return report != nullptr && report->lists[PLUMB_MESH_BORDERS].empty();
}
std::uint64_t plumb_mesh_report_crossing_count(const plumb_mesh_report* report) {
  return report != nullptr ? report->crossings : 0;
}
void plumb_mesh_report_free(plumb_mesh_report* report) { delete report; }

plumb_status plumb_mesh_convexity(const plumb_mesh* mesh, bool* is_convex,
                                  std::uint64_t* reflex_edges, plumb_indices** failing,
                                  const plumb_context* context, plumb_error** error) {
  if (failing != nullptr) *failing = nullptr;
  return guarded(error, [&] {
    need(is_convex, "is_convex");
    Call call(context);
    const ConvexityEvidence found = convexity_of_mesh(need(mesh, "mesh").mesh, call);
    deliver(found, is_convex, reflex_edges, failing);
  });
}
