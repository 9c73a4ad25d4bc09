// Files as sets of space: a file is read as a mesh or .nef, a mesh is repaired if the options ask
// for it, and becomes a set. Notes state the repairs.
//
// A mesh that is refused can often be read after a repair. remedy_for() does not derive a repair
// from the defects, but tries repairs, so each repair that it returns works. It tries the repair
// that changes least first, and the repair that changes most last. Steps that change nothing are
// left out of the answer.
//
// Tested by tests/io/solid_io_test.cpp.
#include "plumb/io/solid_io.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/solid/half_space_reader.h"
#include "plumb/io/text/charged_input.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/space/source_mesh.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/weld_points.h"

namespace plumb {
namespace {

void add_note(const std::string& what, const std::vector<std::uint32_t>& faces,
              std::vector<std::string>& notes) {
  if (!faces.empty()) notes.push_back(what + ": " + listed(faces));
}

std::string crossings_of(const MeshReport& report) {
  std::vector<std::string> pairs;
  for (const auto& [f, g] : report.crossings) {
    pairs.push_back(std::to_string(f) + " and " + std::to_string(g));
  }
  return "the mesh crosses itself and is cut there; " + std::to_string(report.crossing_count) +
         " pair(s) of faces, the first: " + listed(pairs);
}

/// Describes the repair of the mesh. Face numbers are 0-based, as in the file.
void describe(const MeshReport& report, std::vector<std::string>& notes) {
  add_note("faces without area, left out", report.degenerate, notes);
  add_note("faces with repeated corners or spikes, trimmed", report.trimmed, notes);
  add_note("faces that are not planar, triangulated", report.not_planar, notes);
  add_note("faces that are not simple polygons, triangulated", report.not_simple, notes);
  std::vector<std::uint32_t> doubled;
  for (const auto& [face, earlier] : report.doubled) doubled.push_back(face);
  add_note("faces with the boundary of an earlier one, merged with it", doubled, notes);
  if (report.crosses_itself()) notes.push_back(crossings_of(report));
  add_note("components that were inside out, turned; their first faces", report.turned, notes);
}

SolidRead read_nef_set(const std::string& bytes, const ReadOptions& text, Context& context) {
  SpaceComplex complex = read_nef3(bytes, text, context);
  if (const auto flaw = audit(complex, AuditForm::Minimal, context)) {
    throw Error(ErrorCode::BadShape, "no set of space: " + flaw->invariant + ": " + flaw->place,
                {text.name});
  }
  return {Nef3::from_minimal_unchecked(std::move(complex)), {}, {}};
}

/// Returns the set of a mesh. Errors of the mesh are reported with the name of its file.
Nef3 set_of(const PolygonMesh& mesh, const FromMeshOptions& reading, const std::string& name,
            Context& context) {
  try {
    return Nef3::from_mesh(mesh, reading, context);
  } catch (const OpenMesh& error) {
    throw OpenMesh(error.report(), {name});
  }
}

/// Refuses a file without faces, unless the set may be empty: then the set is empty, with a
/// warning.
void refuse_without_faces(const MeshFile& file, bool may_be_empty, const std::string& name,
                          std::vector<std::string>& warnings) {
  const std::string lack = lack_of_faces(file);
  if (lack.empty()) return;
  if (!may_be_empty) {
    throw Error(ErrorCode::BadShape,
                lack + "; export it as polygons; --surface reads it as the empty set", {name});
  }
  warnings.push_back(lack + "; the set is empty");
}

/// Repairs a mesh, and describes the repair. If faces are dropped, later notes number the remaining
/// faces.
void mend(PolygonMesh& mesh, const RepairOptions& options, const std::string& name,
          std::vector<std::string>& notes, Context& context) {
  const RepairReport report =
      with_place(WholeFile{name}, [&] { return repair_mesh(mesh, options, context); });
  for (std::string& note : sentences(report)) notes.push_back(std::move(note));
  if (!report.degenerate.empty() || !report.doubled.empty()) {
    notes.push_back("faces below are numbered without those dropped");
  }
}

/// Throws EnclosesNothing with the reason.
[[noreturn]] void refuse_empty(const PolygonMesh& mesh, const MeshReport& report,
                               const SolidReadOptions& options, const std::string& name) {
  const std::size_t count = mesh.face_count() - report.degenerate.size();
  if (count == 0) throw EnclosesNothing("none of its faces has an area", name);
  std::vector<std::uint32_t> doubled;
  for (const auto& [face, earlier] : report.doubled) {
    doubled.push_back(face);
    doubled.push_back(earlier);
  }
  std::ranges::sort(doubled);
  doubled.erase(std::unique(doubled.begin(), doubled.end()), doubled.end());
  if (doubled.size() == count) {
    throw EnclosesNothing("every face is there in both directions", name);
  }
  const WindingRule rule = options.rule.value_or(WindingRule::Positive);
  throw EnclosesNothing(
      std::string("no winding number is ") + (rule == WindingRule::EvenOdd   ? "odd"
                                              : rule == WindingRule::NonZero ? "other than 0"
                                                                             : "above 0"),
      name);
}

}  // namespace

namespace {

/// Returns the mesh and the attributes that are kept. Returns null if there are none and the faces
/// are not kept. The source has its points at the places to which a weld moves them, because faces
/// are found by their planes.
std::shared_ptr<const MeshSource> source_of(MeshFile& file, const SolidReadOptions& options,
                                            const std::string& name, Context& context) {
  MeshAttributes& attributes = file.attributes;
  keep_only(options.attributes, attributes);
  if (attributes.empty() && !options.keeps_faces) return nullptr;
  PolygonMesh mesh = file.mesh;
  if (options.repair.weld > 0) weld_points(mesh, options.repair.weld, context);
  return std::make_shared<const MeshSource>(
      MeshSource{name, std::move(mesh), std::move(attributes)});
}

}  // namespace

void keep_only(KeptAttributes kept, MeshAttributes& attributes) {
  if (kept == KeptAttributes::None) {
    attributes = {};
  } else if (kept == KeptAttributes::Colours) {
    attributes.face_id.clear();
    attributes.face_group.clear();
    attributes.groups.clear();
    std::erase_if(attributes.channels,
                  [](const MeshChannel& channel) { return channel.name != "color"; });
  } else if (kept == KeptAttributes::Ids) {
    attributes.face_material.clear();
    attributes.materials.clear();
    attributes.channels.clear();
  }
}

bool is_nef_file(const std::string& path, std::string_view bytes) {
  if (std::filesystem::path(path).extension() == ".nef") return true;
  take_prefix(bytes, "\xEF\xBB\xBF");
  return !mesh_format_of(path) && bytes.starts_with("plumb-nef3");
}

SolidRead read_solid(const std::string& path, const std::string& bytes,
                     const SolidReadOptions& options, Context& context) {
  ReadOptions text{input_name(path), options.exact_decimals};
  text.attributes = options.attributes != KeptAttributes::None;
  if (is_nef_file(path, bytes)) return read_nef_set(bytes, text, context);
  MeshFile file = read_mesh_of(path, bytes, text, context);
  std::vector<std::string> warnings = file.warnings;
  refuse_without_faces(file, options.surface || options.may_be_empty, text.name, warnings);
  std::vector<std::string> notes = std::move(file.notes);
  const bool must_enclose = !options.surface && !options.may_be_empty && file.mesh.face_count() > 0;
  const auto source = source_of(file, options, text.name, context);
  if (options.repair.asks()) mend(file.mesh, options.repair, text.name, notes, context);
  MeshReport report;
  const FromMeshOptions reading{
      .rule = options.rule, .surface = options.surface, .report = &report};
  Nef3 set = set_of(file.mesh, reading, text.name, context);
  if (must_enclose && set.is_empty()) refuse_empty(file.mesh, report, options, text.name);
  describe(report, notes);
  if (source != nullptr) set = set.with_source(source);
  return {std::move(set), std::move(notes), std::move(warnings)};
}

SolidRead read_solid_file(const std::string& path, const SolidReadOptions& options,
                          Context& context) {
  const ChargedInput input(path, context);
  return read_solid(path, input.bytes(), options, context);
}

namespace {

/// Tries repairs of a mesh.
class RemedySearch {
 public:
  RemedySearch(const PolygonMesh& mesh, const SolidReadOptions& options, Context& context)
      : mesh_(mesh), options_(options), context_(context) {}

  std::optional<RepairOptions> run() {
    RepairOptions turned = options_.repair;
    turned.reorient = true;
    PolygonMesh merged = mesh_;
    weld_points(merged, options_.repair.weld, context_);
    const bool is_torn = has_loose_faces(merged);
    std::size_t longest = 0;  // The number of edges of the longest hole.
    if (!is_torn) {
      if (auto found = tried(turned, &longest)) return found;
      RepairOptions single = turned;
      single.doubled = DoubledFaces::Drop;
      std::size_t longest_of_single = 0;
      if (auto found = tried(single, &longest_of_single)) return found;
      // A mesh that is closed because it is double-sided may have a hole in each side.
      if (longest == 0) return filled(single, longest_of_single);
    }
    if (auto found = welded(turned, is_torn)) return found;
    return is_torn ? std::nullopt : filled(turned, longest);
  }

 private:
  std::optional<RepairOptions> filled(RepairOptions repair, std::size_t longest) const {
    repair.fill_holes = static_cast<std::uint32_t>(longest);
    return longest > options_.repair.fill_holes ? tried(repair) : std::nullopt;
  }

  /// Whether so many edges have only one face that the mesh is a collection of loose faces, such as
  /// an STL file whose corners differ in the last bits. A repair of such a mesh would be slow and
  /// useless.
  static bool has_loose_faces(const PolygonMesh& mesh) {
    constexpr std::size_t kMostShare = 8;
    std::vector<std::uint64_t> edges;
    edges.reserve(mesh.corners.size());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t a = face[i], b = face[i + 1 < face.size() ? i + 1 : 0];
        if (a != b) edges.push_back(std::uint64_t{std::min(a, b)} << 32U | std::max(a, b));
      }
    }
    std::ranges::sort(edges);
    std::size_t lonely = 0;
    for (std::size_t i = 0; i < edges.size();) {
      const std::size_t first = i;
      while (i < edges.size() && edges[i] == edges[first]) ++i;
      if (i == first + 1) ++lonely;
    }
    return lonely > 100 && lonely > edges.size() / kMostShare;
  }

  /// Returns the options without the steps that have no effect, if the repaired mesh can be read.
  /// Adds the edges of remaining holes to `open_edges`.
  std::optional<RepairOptions> tried(RepairOptions repair, std::size_t* longest = nullptr,
                                     std::size_t* open_edges = nullptr) const {
    PolygonMesh mesh = mesh_;
    const RepairReport report = repair_mesh(mesh, repair, context_);
    for (const auto& hole : report.holes) {
      if (longest != nullptr) *longest = std::max(*longest, hole.size());
      if (open_edges != nullptr) *open_edges += hole.size();
    }
    if (!report.is_closed() || !is_read(mesh)) return {};
    const RepairOptions& given = options_.repair;
    if (report.doubled.empty()) repair.doubled = given.doubled;
    const bool turns = !report.turned.empty() || (!report.flipped.empty() && report.filled.empty());
    if (!turns) repair.reorient = given.reorient;
    return repair;
  }

  bool is_read(const PolygonMesh& mesh) const {
    try {
      return !Nef3::from_mesh(mesh, {.rule = options_.rule}, context_).is_empty();
    } catch (const OpenMesh&) {
      return false;
    }
  }

  /// Tries tolerances that are powers of ten, beginning with the least. Above 1e-5 of the size of
  /// the mesh, a tolerance must be much shorter than every edge, so that welding removes no detail.
  /// If no tolerance is sufficient and the mesh is torn, the holes are filled that remain after
  /// welding with the tolerance that leaves the fewest open edges.
  std::optional<RepairOptions> welded(RepairOptions repair, bool fills) const {
    constexpr int kSafe = 5, kLast = 3;
    constexpr double kMostOfEdge = 0.125;
    const double size = extent();
    if (!(size > 0) || !std::isfinite(size)) return {};
    const int exponent = static_cast<int>(std::floor(std::log10(size)));
    std::optional<RepairOptions> nearly;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    std::size_t longest = 0;  // The number of edges of the longest hole that then remains.
    for (int digits = 9; digits >= kLast; --digits) {
      const std::string text = "1e" + std::to_string(exponent - digits);
      repair.weld = std::strtod(text.c_str(), nullptr);
      if (!(repair.weld > options_.repair.weld)) continue;
      if (digits < kSafe && !(repair.weld < kMostOfEdge * shortest_edge())) break;
      PolygonMesh mesh = mesh_;
      const bool moves = weld_points(mesh, repair.weld, context_).moved > 0;
      if (!moves || has_loose_faces(mesh)) continue;
      std::size_t longest_here = 0, open_edges = 0;
      if (auto found = tried(repair, &longest_here, &open_edges)) return found;
      if (open_edges >= fewest) continue;
      nearly = repair;
      fewest = open_edges;
      longest = longest_here;
    }
    return fills && nearly ? filled(*nearly, longest) : std::nullopt;
  }

  /// Returns the length of the shortest edge between different points, or 0 if there is none. The
  /// last edge of a face is left out.
  double shortest_edge() const {
    double least = HUGE_VAL;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      std::optional<Point3> before;
      for (const std::uint32_t v : mesh_.face(f)) {
        const Point3 p = mesh_.points[v];
        const Point3 q = std::exchange(before, p).value_or(p);
        const double length = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
        if (length > 0) least = std::min(least, length);
      }
    }
    return std::isfinite(least) ? least : 0;
  }

  /// Returns the largest extent along an axis.
  double extent() const {
    double most = 0;
    for (double Point3::*const axis : {&Point3::x, &Point3::y, &Point3::z}) {
      const auto [low, high] = std::ranges::minmax_element(
          mesh_.points, {}, [axis](const Point3& p) { return p.*axis; });
      if (low != mesh_.points.end()) most = std::max(most, (*high).*axis - (*low).*axis);
    }
    return most;
  }

  const PolygonMesh& mesh_;
  const SolidReadOptions& options_;
  Context& context_;
};

}  // namespace

std::optional<RepairOptions> remedy_for(const PolygonMesh& mesh, const SolidReadOptions& options,
                                        Context& context) {
  return RemedySearch(mesh, options, context).run();
}

HalfSpaceList read_half_spaces_file(const std::string& path, ReadOptions options,
                                    Context& context) {
  options.name = input_name(path);
  const ChargedInput input(path, context);
  return read_half_spaces(input.bytes(), options, context);
}

}  // namespace plumb
