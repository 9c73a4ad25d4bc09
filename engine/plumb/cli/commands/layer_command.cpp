// The command `plumb map repair LAYER`: a layer of features without overlaps and gaps.
//
// The repaired layer goes to -o, and the report to standard output: as text, or as JSON with
// --json. With --dry-run there is only the report, and the exit code says whether the layer has
// overlaps, gaps, crossings or nestings. --changes writes the regions of the report as GeoJSON.
// Tested by tests/cli/layer_command_test.cpp.
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/cli/commands/layer_output.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/layer_properties.h"
#include "plumb/plane/layer.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {
namespace {

/// Returns the rule with the given name. Requires one of the five names, or an empty one.
OwnerRule owner_rule(std::string_view name) {
  if (name == "largest") return OwnerRule::Largest;
  if (name == "smallest") return OwnerRule::Smallest;
  return name == "first" || name == "lowest-id" ? OwnerRule::First : OwnerRule::LongestBorder;
}

class MapRepair : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("LAYER", file_, "A layer: GeoJSON, TopoJSON, WKT or WKB; - is standard input")
        ->required()
        ->type_name("");
    add_choice(app, "--rule", rule_,
               {"longest-border", "largest", "smallest", "first", "lowest-id"},
               "Which feature gets an overlap or a gap: the one with the longest common border "
               "(default), the largest, the smallest, the first one, or that of the lowest id");
    app.add_option("--prefer", preferences_,
                   "Feature A gets what could go to A or B; --rule decides the rest; ids or names")
        ->type_name("A B")
        ->allow_extra_args(false);
    app.add_option("--gaps-below", options_.gaps_below,
                   "Fill gaps whose width (twice the area over the perimeter) is less than W "
                   "(default: 1/10000 of the diagonal of the layer, and no small lakes)")
        ->check(CLI::Range(0.0, 1e300).description(""))
        ->type_name("W");
    app.add_flag("--enclosed-only", is_enclosed_only_,
                 "Leave gaps that open to the outside or into a hole");
    app.add_option("--object", read_options_.object, "The object of a TopoJSON file to read")
        ->type_name("NAME");
    app.add_option("--changes", changes_,
                   "Write overlaps, gaps, holes and other regions as GeoJSON")
        ->type_name("OUT");
    app.add_flag("--dry-run", is_dry_run_, "Only report; exit 1 if map check does");
  }

  ExitCode run(Session& session) override {
    open_outputs(session);
    options_.rule = owner_rule(rule_);
    options_.open_gaps = !is_enclosed_only_;
    session.expect({reading_map(), repairing_layer(), writing()});
    layer_ = read_layer_operand(session, file_, read_options_, crs_);
    set_owners();
    session.begin("repair");
    repaired_ = repair_layer(layer_, options_, session.context());
    session.deliver();
    if (repaired_.report.is_stopped) {
      session.note("open gaps may be left: after " + std::to_string(options_.most_rounds) +
                   " rounds, or because their fillings vanish when they are rounded");
    }
    return is_dry_run_ && repaired_.report.has_defects() ? ExitCode::No : ExitCode::Yes;
  }

 private:
  /// Stores the options that refer to features by their ids and names.
  void set_owners() {
    if (rule_ == "lowest-id") options_.rank = id_ranks(layer_);
    for (const auto& [winner, loser] : preferences_) {
      options_.preferences.push_back(
          {feature_called(layer_, winner), feature_called(layer_, loser)});
    }
  }

  /// Opens the outputs before the work, so that a path that cannot be written costs no time.
  void open_outputs(Session& session) {
    const CommonOptions& common = session.options();
    const bool is_written = !common.out.empty() || !common.format.empty();
    if (is_dry_run_ && is_written) throw Error(ErrorCode::Usage, "--dry-run writes no layer");
    const bool is_on_stdout = open_layer_output(
        session, [this]() -> const Layer& { return repaired_.layer; }, crs_);
    if (!changes_.empty()) {
      session.outputs().add(changes_, [this, &session](std::ostream& stream) {
        write_layer_report_geojson(stream, layer_, repaired_.report, crs_, session.context());
      });
    }
    if (common.json) {
      session.outputs().add("-", [this](std::ostream& stream) {
        write_layer_report_json(stream, layer_, repaired_.report);
      });
    } else if (changes_ != "-" && !is_on_stdout) {
      session.outputs().add("-", [this](std::ostream& stream) {
        write_layer_report_text(stream, layer_, repaired_.report);
      });
    }
  }

  std::string file_, rule_, changes_, crs_;
  std::vector<std::pair<std::string, std::string>> preferences_;
  bool is_dry_run_ = false, is_enclosed_only_ = false;
  LayerReadOptions read_options_;
  LayerRepairOptions options_;
  Layer layer_;
  RepairedLayer repaired_;
};

}  // namespace

std::unique_ptr<CommandBody> make_map_repair() { return std::make_unique<MapRepair>(); }

}  // namespace plumb::cli
