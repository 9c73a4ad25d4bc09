// The commands `plumb plane ...`: sets of the plane, combined, transformed and queried.
//
// The commands themselves are templates (set_command.h). This file contains the parts that are
// particular to the plane: formats, the facts that `info` prints, and the writing of results. If no
// format is named, a bounded set is written as WKT, and an unbounded set as .nef2, because WKT
// cannot represent it. Tested by tests/cli/plane_command_test.cpp.

#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/cli/commands/csg_command.h"
#include "plumb/cli/commands/plane_kind.h"
#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/session/command.h"
#include "plumb/convex/plane_minkowski.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/text_output.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/plane/plane_offset.h"
#include "plumb/plane/plane_simplify.h"
#include "plumb/plane/set_features.h"
#include "plumb/predicates/rounding.h"

namespace plumb::cli {
namespace {

/// Throws if the options round coordinates, but the format does not store doubles.
void require_no_rounding(const SetOutput& output) {
  const PlaneWriteOptions& options = output.rounding();
  if (options.grid || options.rounding == OutputRounding::Nearest) {
    throw Error(ErrorCode::Usage, "--raw and --grid are for WKT, GeoJSON, WKB and DXF");
  }
}

}  // namespace

using Json = nlohmann::ordered_json;

Json PlaneFacts::json() const {
  Json area_json = nullptr;
  if (area) area_json = {{"exact", format_exact(*area)}, {"double", nearest_double(*area)}};
  return {{"vertices", counts.vertices}, {"edges", counts.edges}, {"faces", counts.faces},
          {"bounded", area.has_value()}, {"empty", is_empty},     {"area", area_json}};
}

void PlaneFacts::write(std::ostream& out) const {
  out << counted(counts.vertices, "vertex", "vertices") << ", " << counted(counts.edges, "edge")
      << ", " << counted(counts.faces, "face") << '\n'
      << (area ? "bounded" : "unbounded") << (is_empty ? ", empty" : "") << '\n';
  if (area) out << "area " << readable(*area) << '\n';
}

ReadyFile Plane::ready(const Nef2& set, const SetOutput& output, Context& context) {
  const auto index = output.format();
  if (index && !kPlaneFormats[static_cast<std::size_t>(*index)].text) {
    require_no_rounding(output);
    return {[set, title = output.title(), &context](std::ostream& out) {
              write_nef2_svg(out, set, {.title = title, .context = &context});
            },
            {},
            {}};
  }
  const PlaneFormat by_itself = set.is_bounded() ? PlaneFormat::Wkt : PlaneFormat::Nef2;
  const PlaneFormat format =
      index ? *kPlaneFormats[static_cast<std::size_t>(*index)].text : by_itself;
  if (format == PlaneFormat::Nef2) require_no_rounding(output);
  const PlaneText text(set, format, output.rounding(), context);
  std::vector<std::string> changes;
  if (const std::string closing = text.losses().closing(); !closing.empty()) {
    changes.push_back(closing);
  }
  return {[text, &context](std::ostream& out) { text.write(out, context); },
          text.losses().sentences(), changes};
}

PlaneOperand PlaneInput::load(const std::string& file, const CommonOptions& options,
                              Context& context) const {
  ReadOptions read;
  read.exact_decimals = options.exact_decimals;
  read.rings = ring_rule();
  read.curve_tolerance = tolerance_;
  PlaneOperand operand;
  operand.are_kept = keeps_ids();
  if (!operand.are_kept) {
    PlaneRead plain = read_plane_set_file(file, {}, read, context);
    operand.set = std::move(plain.set);
    operand.notes = std::move(plain.notes);
    operand.warnings = std::move(plain.warnings);
    return operand;
  }
  if (options.exact_decimals) {
    throw Error(ErrorCode::Usage,
                "--keep ids reads decimals as the nearest doubles; leave out "
                "--exact-decimals");
  }
  const LayerText input = is_read_by_gdal(file) ? read_layer_text(file, {}, context)
                                                : LayerText{read_input(file, context), {}};
  const std::string& text = input.text;
  const PlaneFormat format = plane_format_of(file, text);
  read.name = input_name(file);
  read.attributes = true;
  PlaneRead plain = read_plane_set(text, format, read, context);
  operand.set = std::move(plain.set);
  operand.notes = std::move(plain.notes);
  operand.warnings = std::move(plain.warnings);
  operand.notes.insert(operand.notes.begin(), input.notes.begin(), input.notes.end());
  if (format != PlaneFormat::GeoJson) return operand;
  operand.features = read_layer(text, {read.name, {}}, context).layer;
  return operand;
}

void PlaneFeatures::add(PlaneOperand& operand) {
  are_kept = operand.are_kept;
  append_layer(layer, operand.features);
  operand.features = {};
}

/// Returns the features of a set as GeoJSON text, or the set if its features are not kept.
ReadyFile Plane::ready(const Nef2& set, const PlaneFeatures& features, const SetOutput& output,
                       Session& session) {
  Context& context = session.context();
  if (!features.are_kept) return ready(set, output, context);
  const auto index = output.format();
  if (!index || kPlaneFormats[static_cast<std::size_t>(*index)].text != PlaneFormat::GeoJson) {
    throw Error(ErrorCode::Usage, "--keep ids needs a GeoJSON file: -o OUT.geojson");
  }
  const PlaneWriteOptions& rounding = output.rounding();
  if (rounding.grid || rounding.rounding == OutputRounding::Nearest) {
    throw Error(ErrorCode::Usage, "--keep ids rounds to valid doubles; leave out --raw and --grid");
  }
  SetFeatures parts = set_features(set, features.layer, context);
  std::vector<std::string> losses, changes;
  if (parts.is_unbounded) losses.push_back("unbounded faces were left out");
  if (parts.has_thin_parts) {
    losses.push_back("lines and points were left out, because they belong to no feature");
  }
  if (!parts.vanished.empty()) {
    losses.push_back("the part of " + counted(parts.vanished.size(), "feature") +
                     " is too small for doubles, and was left out");
  }
  if (const std::string sentence = rounding_sentence(parts.rounding, {}); !sentence.empty()) {
    losses.push_back(sentence);
  }
  if (!set.is_closed()) changes.push_back("the set is not closed; its closure was written");
  const auto layer = std::make_shared<const Layer>(std::move(parts.layer));
  return {[layer, &context](std::ostream& out) { write_layer_geojson(out, *layer, context); },
          std::move(losses), std::move(changes)};
}

namespace {

std::string name_of_file(const std::string& path) { return file_name_of(path_of(path).filename()); }

/// Computes the Minkowski sum of two or more sets.
class PlaneSum : public PlaneOperation {
 private:
  bool may_keep() const override { return false; }
  void declare_operands(CLI::App& app) override {
    declare_first<Plane>(app, a_);
    app.add_option("B", others_, "The other sets")->required()->type_name("");
  }
  ProgressStages stages() const override { return stages_of_sets<Plane>(1 + others_.size(), 1); }
  Nef2 compute(Session& session) override {
    std::vector<std::string> files{a_};
    files.insert(files.end(), others_.begin(), others_.end());
    require_one_stdin(files);
    std::vector<Nef2> sets = read_all(files, session);
    session.begin("combine");
    Context& context = session.context();
    // The closure of the sum is the sum of the closures, which has far fewer parts.
    if (needs_closure_only(session)) {
      for (Nef2& set : sets) set = set.closure(context);
    }
    return minkowski_sum(sets, context);
  }

  std::string a_;
  std::vector<std::string> others_;
};

/// Grows or shrinks a set by a distance.
class PlaneOffset : public PlaneOperation {
 private:
  bool may_keep() const override { return false; }
  void declare_operands(CLI::App& app) override {
    declare_first<Plane>(app, a_);
    app.add_option("--by", by_, "The distance; a negative one shrinks the set")
        ->required()
        ->type_name("D");
    add_choice(app, "--join", join_, {"round", "mitre", "square", "bevel"},
               "The shape at convex corners (default: round)");
    app.add_option("--mitre-limit", mitre_limit_, "Cut mitres longer than LIMIT * D (default 2)")
        ->type_name("LIMIT");
    app.add_option("--chord-error", chord_error_,
                   "Largest distance of an arc from its chords (default: a thousandth of D)")
        ->type_name("E");
    app.add_option("--segments", segments_, "Chords of a full circle, instead of --chord-error")
        ->type_name("N");
  }
  Nef2 compute(Session& session) override {
    const double by = number(by_, "--by", session);
    OffsetOptions options;
    options.join = join_ == "mitre"    ? OffsetJoin::Mitre
                   : join_ == "square" ? OffsetJoin::Square
                   : join_ == "bevel"  ? OffsetJoin::Bevel
                                       : OffsetJoin::Round;
    options.mitre_limit = number(mitre_limit_, "--mitre-limit", session);
    options.chord_error = number(chord_error_, "--chord-error", session);
    options.circle_segments = segments_;
    const Nef2 set = read(a_, session);
    session.begin("combine");
    return offset(set, by, options, session.context());
  }
  static double number(const std::string& text, const char* name, Session& session) {
    return nearest_double(read_number_argument(text, name, session));
  }

  std::string a_;
  std::string by_;
  std::string join_;
  std::string mitre_limit_ = "2";
  std::string chord_error_ = "0";
  std::uint32_t segments_ = 0;
};

/// Reduces the number of corners of a set.
class PlaneSimplify : public PlaneOperation {
 private:
  bool may_keep() const override { return false; }
  void declare_operands(CLI::App& app) override {
    declare_first<Plane>(app, a_);
    app.add_option("--tolerance", tolerance_, "Remove corners whose triangle has at most this area")
        ->check(CLI::Range(0.0, 1e300).description(""))
        ->type_name("AREA");
    app.add_option("--percent", percent_, "Keep P percent of the corners that may be removed")
        ->check(CLI::Range(0.0, 100.0).description(""))
        ->type_name("P");
    app.add_option("--within", within_, "Move no point of a border farther than this distance")
        ->check(CLI::Range(0.0, 1e300).description(""))
        ->type_name("D");
  }
  Nef2 compute(Session& session) override {
    if (!tolerance_ && !percent_ && !within_) {
      throw Error(ErrorCode::Usage,
                  "plane simplify needs --tolerance AREA, --percent P or --within D");
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const LayerSimplifyOptions options{tolerance_.value_or(kInfinity), percent_.value_or(0) / 100,
                                       within_.value_or(kInfinity)};
    const Nef2 set = read(a_, session);
    if (!set.is_bounded()) {
      throw Error(ErrorCode::BadArgument, "only bounded sets can be simplified",
                  {.file = input_name(a_)});
    }
    session.begin("combine");
    SimplifiedSet simplified = simplify_borders(set, options, session.context());
    session.note(std::to_string(simplified.corners_after) + " of " +
                 counted(simplified.corners_before, "corner") +
                 " left; no border moved by more than " + format_double(simplified.borders_moved));
    const std::string rounding = rounding_sentence(simplified.rounding, {});
    if (!rounding.empty()) session.note(input_name(a_) + ": warning: " + rounding);
    return std::move(simplified.set);
  }

  std::string a_;
  std::optional<double> tolerance_, percent_, within_;
};

class PlaneInfo : public SetInfo<Plane> {
 public:
  void declare(CLI::App& app) override {
    SetInfo<Plane>::declare(app);
    app.add_option("--svg", svg_, "Draw the set")->type_name("OUT");
  }

 private:
  void prepare(const Nef2& set, const std::string& file, Session& session) override {
    if (svg_.empty()) return;
    session.outputs().add(
        svg_, [&set, &session, title = name_of_file(input_name(file))](std::ostream& out) {
          write_nef2_svg(out, set, {.title = title, .context = &session.context()});
        });
  }

  std::string svg_;
};

}  // namespace

std::unique_ptr<CommandBody> make_plane_union() {
  return std::make_unique<NaryOperation<Plane>>(NaryFunction::Union);
}
std::unique_ptr<CommandBody> make_plane_intersection() {
  return std::make_unique<NaryOperation<Plane>>(NaryFunction::Intersection);
}
std::unique_ptr<CommandBody> make_plane_difference() {
  return std::make_unique<BinaryOperation<Plane>>(kDifference);
}
std::unique_ptr<CommandBody> make_plane_symmetric_difference() {
  return std::make_unique<BinaryOperation<Plane>>(kSymmetricDifference);
}
std::unique_ptr<CommandBody> make_plane_csg() { return std::make_unique<CsgOperation<Plane>>(); }
std::unique_ptr<CommandBody> make_plane_complement() {
  return std::make_unique<UnaryOperation<Plane>>(&Nef2::complement);
}
std::unique_ptr<CommandBody> make_plane_interior() {
  return std::make_unique<UnaryOperation<Plane>>(&Nef2::interior);
}
std::unique_ptr<CommandBody> make_plane_closure() {
  return std::make_unique<UnaryOperation<Plane>>(&Nef2::closure);
}
std::unique_ptr<CommandBody> make_plane_boundary() {
  return std::make_unique<UnaryOperation<Plane>>(&Nef2::boundary);
}
std::unique_ptr<CommandBody> make_plane_regularize() {
  return std::make_unique<UnaryOperation<Plane>>(&Nef2::regularization);
}
std::unique_ptr<CommandBody> make_plane_minkowski() { return std::make_unique<PlaneSum>(); }
std::unique_ptr<CommandBody> make_plane_offset() { return std::make_unique<PlaneOffset>(); }
std::unique_ptr<CommandBody> make_plane_simplify() { return std::make_unique<PlaneSimplify>(); }
std::unique_ptr<CommandBody> make_plane_info() { return std::make_unique<PlaneInfo>(); }
std::unique_ptr<CommandBody> make_plane_locate() { return std::make_unique<SetLocate<Plane>>(); }

}  // namespace plumb::cli
