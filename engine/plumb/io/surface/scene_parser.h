// Scenes as they are written: steps 1 and 3 to 5 of scene_reader.h, for callers that have the text
// and the model.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/io/svg_reader.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/surface/surface.h"

namespace plumb {

/// A list of lists of indices, flat, with the place of each index in the text.
struct SceneLists {
  std::vector<std::uint32_t> begin = {0};
  std::vector<std::uint32_t> items;
  std::vector<std::size_t> places;
  std::size_t size() const { return begin.size() - 1; }
};

/// Points as they are written.
struct ScenePoints {
  std::vector<std::uint32_t> face;  ///< Face of the model.
  PointTable2 weights;              ///< (u, v), not outside of any face.
  /// Whether the point was written in decimals, so that it may be rounded.
  std::vector<std::uint8_t> rounds;
  std::vector<std::size_t> place;  ///< Byte of the text.
  std::size_t size() const { return face.size(); }
};

/// A scene as it is written; the indices of points and polygons are valid.
struct ParsedScene {
  using Lists = SceneLists;
  struct Level {
    SurfaceLevel level;
    std::size_t place;
  };

  struct Drawing {
    std::string file;  ///< Looked for beside the scene.
    double scale = 0;  ///< Units of the model for one unit of the drawing.
    double angle = 0;  ///< Degrees.
    std::optional<double> tolerance = {};
    std::size_t place = 0;  ///< Byte of the text.
  };

  std::string model;
  ScenePoints points;
  Lists polygons;
  std::optional<Lists> shapes;  ///< Shapes; without them each polygon is one.
  std::optional<std::uint32_t> outside;
  std::size_t outside_place = 0;
  bool has_shortest_paths = false;  ///< Whether "paths" is "shortest".
  std::vector<Level> levels;        ///< Levels; of existing shapes, unless there are drawings.
  std::vector<Drawing> drawings;
  ScenePoints centers;  ///< Centre of each drawing.
};

/// Returns the scene that a text describes (step 1).
ParsedScene parse_scene(std::string_view text, const ReadOptions& options, Context& context);

/// A drawing that has been read.
struct DrawingFile {
  std::string name;  ///< Name in messages.
  std::string text;  ///< The whole file: errors count its lines.
  SvgDrawing drawing;
};

/// Returns the scene (steps 3 to 5). `text` is the parsed text. `drawings` contains the file of
/// each drawing of the scene.
SurfaceScene make_scene(const ParsedScene& scene, std::shared_ptr<const SurfaceMesh> mesh,
                        std::string_view text, const ReadOptions& options, Context& context,
                        std::span<const DrawingFile* const> drawings = {});

// Points of scenes as they are written, [face, u, v], and the treatment of decimals
// (scene_reader.h).

/// Reads one point at a time from the events of a parser.
class ScenePointReader {
 public:
  /// `places` must outlive it.
  ScenePointReader(std::string_view text, const ReadOptions& options, JsonPlaces& places,
                   Context& context);

  /// Begins a point at its opening bracket.
  void begin(std::size_t place);
  bool needs_face() const { return numbers_ == 0; }
  void set_face(std::uint32_t face);
  /// Reads a weight, given as a token of the text.
  void read_weight(std::string_view token);
  /// Ends the point at its closing bracket and appends it.
  void end(ScenePoints& to);

 private:
  void add_near_side(const std::array<Rational, 2>& weights, bool is_decimal, ScenePoints& to);

  const char* text_;
  JsonPlaces& places_;
  NumberReader nearest_, exact_;
  bool exact_decimals_;
  Context& context_;
  std::size_t numbers_ = 0;
  std::size_t place_ = 0;
  std::uint32_t face_ = 0;
  std::array<std::string_view, 2> tokens_;
  std::array<ReadNumber, 2> weights_;
};

}  // namespace plumb
