// Sets of the plane as a kind of sets (set_command.h): formats, and the facts that `info` prints.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/io/plane_io.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_measure.h"

namespace plumb::cli {

/// The facts that `info` prints.
struct PlaneFacts {
  PlaneFacts(const Nef2& set, Context& context) : counts(set.counts()), is_empty(set.is_empty()) {
    if (set.is_bounded()) area = marked_area(set.complex(), context);
  }
  nlohmann::ordered_json json() const;
  void write(std::ostream& out) const;

  PlaneCounts counts;
  bool is_empty;
  std::optional<Rational> area;  ///< Area of a bounded set.
};

struct PlaneOutputFormat {
  std::string_view name;
  std::string_view extension;
  std::optional<PlaneFormat> text;  ///< Format of text; empty for a picture.
};

inline constexpr std::array kPlaneFormats{
    PlaneOutputFormat{"wkt", ".wkt", PlaneFormat::Wkt},
    PlaneOutputFormat{"geojson", ".geojson", PlaneFormat::GeoJson},
    PlaneOutputFormat{"json", ".json", PlaneFormat::GeoJson},
    PlaneOutputFormat{"wkb", ".wkb", PlaneFormat::Wkb},
    PlaneOutputFormat{"dxf", ".dxf", PlaneFormat::Dxf},
    PlaneOutputFormat{"nef2", ".nef2", PlaneFormat::Nef2},
    PlaneOutputFormat{"svg", ".svg", std::nullopt},
};

/// A set that was read, with the features of its file.
struct PlaneOperand {
  Nef2 set;
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
  Layer features;
  bool are_kept = false;  ///< Whether --keep ids was given.
};

/// The options by which files are read as sets of the plane.
class PlaneInput {
 public:
  void declare(CLI::App& app) {
    add_choice(app, "--rule", rule_, {"odd", "nonzero", "positive", "negative"},
               "Winding rule (default: odd, polygon by polygon)");
    app.add_option("--curve-tolerance", tolerance_,
                   "Largest distance of a curve of .dxf or .svg from its chords")
        ->type_name("D")
        ->check(CLI::PositiveNumber);
  }
  /// Declares --keep, for commands that write sets.
  void declare_keep(CLI::App& app) {
    add_choice(app, "--keep", keep_, {"ids", "none"},
               "ids: divide a GeoJSON result into the features of the operands, with their ids and "
               "properties (default: none)");
  }
  bool keeps_ids() const { return keep_ == "ids"; }
  /// Returns a set with the features of its file, if they are kept.
  PlaneOperand load(const std::string& file, const CommonOptions& options, Context& context) const;

 private:
  RingRule ring_rule() const {
    if (rule_ == "nonzero") return RingRule::NonZero;
    if (rule_ == "positive") return RingRule::Positive;
    return rule_ == "negative" ? RingRule::Negative : RingRule::Odd;
  }

  std::string rule_;
  std::string keep_ = "none";
  std::optional<double> tolerance_;
};

/// The features of all operands of a command, in the order of the operands.
struct PlaneFeatures {
  /// Takes the features of an operand.
  void add(PlaneOperand& operand);

  Layer layer;
  bool are_kept = false;  ///< Whether --keep ids was given.
};

/// The kind of sets of the plane, for set_command.h.
struct Plane {
  using Set = Nef2;
  using Input = PlaneInput;
  using Features = PlaneFeatures;
  static constexpr const char* kHelp =
      "A set: .wkt, .geojson, .json, .wkb, .dxf, .svg, .nef2; - is standard input";
  static constexpr std::array<const char*, 2> kAxes{"X", "Y"};
  static constexpr bool kHasGrid = true;

  static ProgressStage reading() { return reading_plane(); }
  static ProgressStage combining() { return combining_plane(); }
  static ProgressStage measuring() { return measuring_plane(); }
  static ProgressStage locating() { return locating_plane(); }
  static ProgressStages writing(const SetOutput& output) {
    const auto index = output.format();
    if (!index) return writing_plane_text();
    const auto format = kPlaneFormats[static_cast<std::size_t>(*index)].text;
    if (!format) return writing_plane_picture();
    return *format == PlaneFormat::Nef2 ? writing_nef2() : writing_plane_text();
  }
  static const auto& formats() { return kPlaneFormats; }
  static bool keeps_marks(const SetOutput& output) {
    const auto index = output.format();
    if (!index) return false;  // WKT if the set is bounded, as a sum is.
    const auto format = kPlaneFormats[static_cast<std::size_t>(*index)].text;
    return !format || *format == PlaneFormat::Nef2;  // A picture shows marks, too.
  }
  /// Returns the set as a file. Without a name for the format it is WKT if the set is bounded, else
  /// .nef2.
  static ReadyFile ready(const Nef2& set, const SetOutput& output, Context& context);
  /// Returns the set as a file of its features if they are kept and the format is GeoJSON.
  static ReadyFile ready(const Nef2& set, const PlaneFeatures& features, const SetOutput& output,
                         Session& session);
  static PlaneFacts facts(const Nef2& set, Context& context) { return {set, context}; }
  static std::pair<const char*, bool> locate(const Nef2& set, const std::array<Rational, 2>& p) {
    const PlaneLocation place = set.locate(RationalPoint2{p[0], p[1]});
    return {place.vertex.is_valid() ? "vertex"
            : place.edge.is_valid() ? "edge"
                                    : "face",
            place.marked};
  }
};

using PlaneOperation = SetOperation<Plane>;

}  // namespace plumb::cli
