// Operands: recognising files, reading numbers, solids and scenes.
//
// A file whose extension is unknown is recognised by its first line. A JSON file is recognised by
// the members of its outermost object. To find these members, the file is not parsed: strings are
// skipped, and only depth one is examined. Scenes may be repaired on request: generators of the
// homology are added to shapes that do not separate the surface (surface/surface_homology.h), and
// reported.
// Tested by tests/cli/program_test.cpp, tests/cli/view_command_test.cpp and
// tests/cli/surface_command_test.cpp.
#include "plumb/cli/files/operands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "plumb/base/internal/work_log.h"
#include "plumb/base/set_expression.h"
#include "plumb/cli/session/command.h"
#include "plumb/io/mesh/stl.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/text/charged_input.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/foreign_files.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/surface/surface_homology.h"

namespace plumb {
namespace {

constexpr std::string_view kBlank = " \t\r";

/// Returns the first line that is neither blank nor a comment.
std::string_view first_line(std::string_view text) {
  take_prefix(text, "\xEF\xBB\xBF");
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    if (!line.empty() && line.front() != '#') return line;
  }
  return {};
}

/// Returns the position behind the string that begins at `at`.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
  return std::min(at + 1, text.size());
}

/// Whether the outermost object of a JSON text has the member "asset", as glTF requires, but not
/// the member "type", as GeoJSON requires.
bool is_gltf_text(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  take_prefix(text, "\xEF\xBB\xBF");
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  if (!text.starts_with('{')) return false;
  std::size_t depth = 0;
  bool has_asset = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{' || text[i] == '[') ++depth;
    if ((text[i] == '}' || text[i] == ']') && --depth == 0) break;
    if (text[i] != '"') continue;
    const std::size_t end = end_of_string(text, i);
    const std::size_t next = text.find_first_not_of(kSpace, end);
    if (depth == 1 && next != text.npos && text[next] == ':') {
      const std::string_view key = text.substr(i, end - i);
      if (key == "\"type\"") return false;
      has_asset |= key == "\"asset\"";
    }
    i = end - 1;
  }
  return has_asset;
}

std::size_t count_words(std::string_view line) {
  std::size_t count = 0;
  while (!line.empty()) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    if (!line.empty()) ++count;
    line.remove_prefix(std::min(line.find_first_of(kBlank), line.size()));
  }
  return count;
}

}  // namespace

FileKind kind_of_file(const std::string& path, std::string_view bytes) {
  if (std::filesystem::path(path).extension() == ".map") return FileKind::Map;
  if (mesh_format_of(path) || is_nef_file(path, bytes)) return FileKind::Solid;
  if (plane_format_of(path)) return FileKind::PlaneSet;
  if (is_binary_stl(bytes) || is_gltf_text(bytes)) return FileKind::Solid;
  if (guess_mesh_format(bytes) == MeshFormat::Amf) return FileKind::Solid;
  const std::string_view line = first_line(bytes);
  if (begins_like_wkt(line) || guess_plane_format(bytes) != PlaneFormat::Wkt) {
    return FileKind::PlaneSet;
  }
  const bool is_number = !line.empty() && '0' <= line.front() && line.front() <= '9';
  return is_number && count_words(line) == 2 ? FileKind::Map : FileKind::Solid;
}

}  // namespace plumb

namespace plumb::cli {

namespace {

Rational read_argument(const std::string& text, const std::string& name, bool exact_decimals,
                       Session& session) {
  const RoundToNearest rounding;
  ReadNumber number;
  try {
    TextCursor cursor(text, name);
    const bool is_blank = !cursor.next_line();
    const std::string_view token = is_blank ? std::string_view() : cursor.token();
    if (token.size() != text.size()) {
      throw Error(ErrorCode::Usage, "expected a number, found " + plumb::quoted(text));
    }
    NumberReader numbers(session.context(), exact_decimals, text.size());
    numbers.read(cursor, token, number);
  } catch (const Error& error) {
    const bool is_stop =
        error.code() == ErrorCode::ResourceLimit || error.code() == ErrorCode::Cancelled;
    if (is_stop) throw;
    throw Error(ErrorCode::Usage, name + ": " + error.message());
  }
  return number.exact();
}

}  // namespace

Rational read_number_argument(const std::string& text, const std::string& name, Session& session) {
  return read_argument(text, name, session.options().exact_decimals, session);
}

void RoundingOptions::declare(CLI::App& app, bool has_grid) {
  app.add_flag("--raw", is_raw_, "Write the nearest numbers without repair");
  if (!has_grid) return;
  app.add_option("--grid", grid_, "Round to multiples of STEP, such as 0.001 or 1/8")
      ->type_name("STEP");
}

/// A decimal step is exact: 0.1 means one tenth, because the user wants multiples of one tenth.
PlaneWriteOptions RoundingOptions::read(Session& session) const {
  PlaneWriteOptions options;
  if (is_raw_) options.rounding = OutputRounding::Nearest;
  if (grid_.empty()) return options;
  if (is_raw_) throw Error(ErrorCode::Usage, "--raw and --grid exclude each other");
  options.grid = read_argument(grid_, "--grid", true, session);
  if (options.grid->sign() <= 0) {
    throw Error(ErrorCode::Usage, "--grid: the step must be positive, found " + grid_);
  }
  return options;
}

std::string readable(const Rational& value) {
  constexpr std::size_t kLongest = 60;
  constexpr int kDigits = 17;
  std::string exact = format_exact(value);
  if (exact.size() <= kLongest) return exact;
  const double nearest = nearest_double(value);
  const bool is_ordinary = std::isnormal(nearest);
  const auto digits = std::ranges::count_if(exact, [](char c) { return '0' <= c && c <= '9'; });
  return (is_ordinary ? format_double(nearest) : decimal_text(value, kDigits)) +
         " (rounded; the exact number has " + std::to_string(digits) + " digits, --json has them)";
}

Nef2 read_plane(const std::string& file, const std::string& bytes, Session& session) {
  const PlaneFormat format = plane_format_of(file, bytes);
  const ReadOptions options{input_name(file), session.options().exact_decimals};
  PlaneRead read = read_plane_set(bytes, format, options, session.context());
  print_notes(file, read, session);
  return std::move(read.set);
}

namespace {

/// Returns the reason why a distance is invalid; nothing if it is finite and not negative.
std::string flaw_of_distance(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_number = !text.empty() && *end == '\0';
  return is_number && std::isfinite(value) && value >= 0
             ? std::string()
             : "expected a distance that is not negative, found " + text;
}

}  // namespace

void RepairFlags::declare(CLI::App& app) {
  app.add_option("--weld", weld_, "Merge vertices that are at most EPS apart")
      ->type_name("EPS")
      ->check(flaw_of_distance);
  app.add_flag("--one-side", one_side_, "Keep one of several faces with the same corners");
  app.add_flag("--reorient", reorients_, "Flip faces oriented opposite to their neighbours");
  app.add_option("--fill-holes", fill_holes_, "Fill holes of at most N edges")->type_name("N");
  app.add_option("--fill-holes-below", fill_holes_below_,
                 "Fill holes whose box has a diagonal of at most D")
      ->type_name("D")
      ->check(flaw_of_distance);
}

RepairOptions RepairFlags::options() const {
  return {.weld = weld_,
          .doubled = one_side_ ? DoubledFaces::Drop : DoubledFaces::Keep,
          .reorient = reorients_,
          .fill_holes = fill_holes_,
          .fill_holes_below = fill_holes_below_};
}

std::string words_of(const RepairOptions& repair) {
  std::string words;
  const auto add = [&words](const std::string& word) {
    words += (words.empty() ? "" : " ") + word;
  };
  if (repair.weld > 0) add("--weld " + format_double(repair.weld));
  if (repair.doubled == DoubledFaces::Drop) add("--one-side");
  if (repair.reorient) add("--reorient");
  if (repair.fill_holes > 0) add("--fill-holes " + std::to_string(repair.fill_holes));
  if (repair.fill_holes_below > 0) {
    add("--fill-holes-below " + format_double(repair.fill_holes_below));
  }
  return words;
}

void SolidInput::declare(CLI::App& app) {
  add_choice(app, "--rule", rule_, {"positive", "nonzero", "odd"},
             "Winding rule (default: positive)");
  app.add_flag("--surface", surface_, "Read a mesh, open or not, as the set of its facets");
  app.add_flag("--allow-empty", allows_empty_, "Read a mesh that encloses nothing as empty");
  repair_.declare(app);
}

void SolidInput::declare_keep(CLI::App& app) {
  keep_ = "all";
  const bool is_taken = app.get_option_no_throw("--keep") != nullptr;
  add_choice(app, is_taken ? "--attributes" : "--keep", keep_, {"all", "colours", "ids", "none"},
             "Attributes of meshes that are kept (default: all)");
}

void SolidInput::declare_keep_faces(CLI::App& app) {
  app.add_flag("--keep-faces", keeps_faces_, "Do not merge faces of meshes in one plane");
}

KeptAttributes SolidInput::kept() const {
  return keep_ == "none"      ? KeptAttributes::None
         : keep_ == "colours" ? KeptAttributes::Colours
         : keep_ == "ids"     ? KeptAttributes::Ids
                              : KeptAttributes::All;
}

SolidReadOptions SolidInput::read_options(const CommonOptions& common) const {
  SolidReadOptions options;
  options.exact_decimals = common.exact_decimals;
  options.surface = surface_;
  options.may_be_empty = allows_empty_;
  options.repair = repair_.options();
  options.attributes = kept();
  options.keeps_faces = keeps_faces_;
  if (!rule_.empty()) {
    options.rule = rule_ == "odd"       ? WindingRule::EvenOdd
                   : rule_ == "nonzero" ? WindingRule::NonZero
                                        : WindingRule::Positive;
  }
  return options;
}

void require_solid(const std::string& file, const std::string& bytes) {
  const FileKind kind = kind_of_file(file, bytes);
  if (kind == FileKind::Solid) return;
  // An XML file may be taken for a drawing, and any other text for WKT.
  constexpr std::string_view kPlaneKinds = "SVG GeoJSON TopoJSON WKT WKB DXF nef2";
  if (const auto foreign = foreign_kind(bytes, kPlaneKinds, FileReaders::Solids)) {
    throw Error(ErrorCode::UnknownFormat, *foreign, {.file = input_name(file)});
  }
  const std::string what = kind == FileKind::Map ? "a map" : "a set of the plane";
  throw Error(
      ErrorCode::UnknownFormat,
      what + ", where a solid is needed: .off, .obj, .stl, .ply, .glb, .gltf, .3mf, .amf, .nef",
      {.file = input_name(file)});
}

namespace {

/// Returns the message of a refused mesh, with the options that would make the mesh readable. The
/// search for these options may exceed a limit that was sufficient for reading. In this case, the
/// message names no options.
std::string with_hints(const Error& error, const std::string& file, const std::string& bytes,
                       const SolidReadOptions& options, Context& context) {
  std::string words;
  try {
    const ReadOptions text{input_name(file), options.exact_decimals};
    const MeshFile mesh = read_mesh_of(file, bytes, text, context);
    if (const auto remedy = remedy_for(mesh.mesh, options, context)) words = words_of(*remedy);
  } catch (const Error& other) {
    if (other.code() != ErrorCode::ResourceLimit) throw;
  }
  std::string text = error.message();
  if (!words.empty()) text += "; " + words + " mends it";
  text += "; --surface reads it as the set of its facets";
  const bool is_empty = dynamic_cast<const EnclosesNothing*>(&error) != nullptr;
  return is_empty ? text + "; --allow-empty reads it as the empty set" : text;
}

}  // namespace

SolidRead SolidInput::load(const std::string& file, const CommonOptions& options,
                           Context& context) const {
  const WorkPhase phase("reading");
  const ChargedInput input(file, context);
  return load(file, input.bytes(), options, context);
}

SolidRead SolidInput::load(const std::string& file, const std::string& bytes,
                           const CommonOptions& common, Context& context) const {
  require_solid(file, bytes);
  const SolidReadOptions options = read_options(common);
  const auto refuse = [&](const Error& error) {
    throw Error(error.code(), with_hints(error, file, bytes, options, context), error.place());
  };
  try {
    return read_solid(file, bytes, options, context);
  } catch (const OpenMesh& error) {
    refuse(error);
  } catch (const EnclosesNothing& error) {
    refuse(error);
  }
  return {};
}

Nef3 SolidInput::read(const std::string& file, Session& session) const {
  const ChargedInput input(file, session.context());
  return read(file, input.bytes(), session);
}

Nef3 SolidInput::read(const std::string& file, const std::string& bytes, Session& session) const {
  SolidRead solid = load(file, bytes, session.options(), session.context());
  print_notes(file, solid, session);
  return std::move(solid.set);
}

void SolidInput::require_plain() const {
  if (is_plain()) return;
  throw Error(ErrorCode::Usage,
              "--rule, --surface and the options that mend a mesh are for meshes");
}

Nef2 SolidInput::read_plane(const std::string& file, const std::string& bytes,
                            Session& session) const {
  require_plain();
  return cli::read_plane(file, bytes, session);
}

namespace {

/// Adds generators of the homology to shapes until every shape separates the surface.
std::vector<SurfaceRepair> repair(SurfaceScene& scene, Context& context) {
  const SurfaceHomology homology(*scene.mesh, context);
  if (!scene.shapes) {
    scene.shapes.emplace();
    for (std::uint32_t p = 0; p < scene.polygons.size(); ++p) scene.shapes->push_back({p});
  }
  std::vector<SurfaceRepair> repairs;
  for (std::uint32_t s = 0; s < scene.shapes->size(); ++s) {
    std::vector<std::uint32_t>& shape = (*scene.shapes)[s];
    if (s % 64 == 0) context.checkpoint("homology", s, scene.shapes->size());
    std::vector<std::int64_t> before = homology.class_of(scene.polygons, shape, context);
    if (std::ranges::all_of(before, [](std::int64_t k) { return k == 0; })) continue;
    std::vector<std::uint32_t> added = homology.add_repair(shape, scene.polygons, context);
    context.charge_memory(before.size() * sizeof(std::int64_t), "loops that repair");
    shape.insert(shape.end(), added.begin(), added.end());
    repairs.push_back({s, std::move(before), std::move(added)});
  }
  return repairs;
}

}  // namespace

void SurfaceInput::declare(CLI::App& app) {
  declare_file(app);
  app.add_flag("--repair", repairs_,
               "Add loops around handles to shapes, so that they separate the surface");
}

void SurfaceInput::declare_file(CLI::App& app) {
  app.add_option("SCENE", file_, "A scene: .json; - is standard input")->required()->type_name("");
  app.add_flag("--anywhere", reads_anywhere_, "The scene may name files outside of its folder");
}

void SurfaceInput::declare_expression(CLI::App& app, bool is_required) {
  CLI::Option* const op =
      app.add_option("--op", expression_,
                     "+ union, * intersection, - difference, ^ symmetric, ! complement of shapes "
                     "A, B .. or s0, s1 ..")
          ->type_name("EXPR");
  if (is_required) op->required();
  app.add_option("--rule", rule_, "Winding rule: evenodd (default), nonzero, positive")
      ->type_name("RULE")
      ->check(CLI::IsMember({"evenodd", "nonzero", "positive"}).description(""));
}

SceneFile SurfaceInput::read_undivided(Session& session) const {
  session.begin("read");
  ReadOptions options;
  options.exact_decimals = session.options().exact_decimals;
  if (reads_anywhere_) options.named_files = NamedFiles::Anywhere;
  SceneFile file = read_scene_file(file_, options, session.context());
  for (const std::string& note : file.notes) session.note(note);
  for (const std::string& warning : file.warnings) session.warn(file.model, warning);
  return file;
}

DividedScene SurfaceInput::read(Session& session) const {
  SceneFile file = read_undivided(session);
  std::vector<SurfaceRepair> repairs;
  if (repairs_) repairs = repair(file.scene, session.context());
  session.begin("divide");
  return {SurfaceDivision(std::move(file.scene), session.context()), file.model,
          std::move(repairs)};
}

SurfaceResult SurfaceInput::evaluate(const SurfaceDivision& division, Context& context) const {
  const WindingRule rule = rule_ == "nonzero"    ? WindingRule::NonZero
                           : rule_ == "positive" ? WindingRule::Positive
                                                 : WindingRule::EvenOdd;
  try {
    return division.evaluate(parse_set_expression(expression_), rule, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadArgument && error.code() != ErrorCode::Syntax) throw;
    throw Error(ErrorCode::Usage, "--op '" + expression_ + "': " + error.message());
  }
}

}  // namespace plumb::cli
