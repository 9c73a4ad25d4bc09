// Reads scenes: polygons on a mesh (docs/formats.md, "Scenes").
//
//   {"model": FILE, "points": [[face, u, v], ..], "polygons": [[point, ..], ..],
//    "shapes"?: [[polygon, ..], ..], "outside"?: face, "levels"?: [[shape, face, label], ..],
//    "svg"?: {"file": FILE, "center": [face, u, v], "scale": length, "angle"?: degrees, "tolerance"?: length}}
//
// Indices count from 0; u, v are the weights of the second and the third vertex of the face, as the model lists
// them, larger polygons cut into fans in order. FILE is sought beside the scene. A weight is a JSON number or
// a string with a fraction: "1/3". Members of other names mean nothing.
//
// Main flow of read_scene_file:
//  1. parse      the text, each index and weight with its place
//  2. model      by any reader of meshes (solid_io.h); triangles; SurfaceMesh
//  3. points     on a vertex, an edge or in a face, exactly (below)
//  4. trace      polygons from point to point (trace.h); straight in the face that both points name
//  5. draw       each "svg" (one, or a list): read once (svg_reader.h), its points put onto the surface by straight lines
//                from the centre (exponential_map.h), joined by traces; a shape for each of its elements, after
//                those of the scene
//
// Where a point lies is decided by the numbers as they are written, decimals too: [f, 0.3, 0.7] is on the edge,
// and the same as [g, 0.7, 0] across it, though no doubles add up to that. Then what a decimal gave is rounded to
// the nearest double, once, unless that would move the point off its edge, onto one, or out of its face. With a
// decimal among them u + v misses 1 by up to 2^-52 where 1 is meant: then it is. And nothing that lies outside by
// that much is refused.
//
// Cost: O(bytes), and the tracing. Errors, with their place: those of JSON and of the model; BadIndex; BadShape
// for a point outside its face, for control points that no path joins, and for
// points of drawings beyond the border; ResourceLimit; Cancelled.
#pragma once

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
#include "plumb/io/svg_drawing.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/space/polygon_mesh.h"
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
  std::vector<std::uint32_t> face;   ///< of the model
  PointTable2 weights;               ///< (u, v), not outside of any face
  std::vector<std::uint8_t> rounds;  ///< written in decimals: may be rounded
  std::vector<std::size_t> place;    ///< byte of the text
  std::size_t size() const { return face.size(); }
};

/// A scene as it is written; indices of points and of polygons are right.
struct ParsedScene {
  using Lists = SceneLists;
  struct Level {
    SurfaceLevel level;
    std::size_t place;
  };

  struct Drawing {
    std::string file;  ///< sought beside the scene
    double scale = 0;  ///< the units of the model that one of the drawing is
    double angle = 0;  ///< degrees
    std::optional<double> tolerance = {};
    std::size_t place = 0;  ///< byte of the text
  };

  std::string model;
  ScenePoints points;
  Lists polygons;
  std::optional<Lists> shapes;  ///< none: one shape per polygon
  std::optional<std::uint32_t> outside;
  std::size_t outside_place = 0;
  std::vector<Level> levels;  ///< of shapes that there are, unless there are drawings
  std::vector<Drawing> drawings;
  ScenePoints centers;  ///< one of each drawing
};

/// Step 1.
ParsedScene parse_scene(std::string_view text, const ReadOptions& options, Context& context);

/// A drawing that has been read.
struct DrawingFile {
  std::string name;  ///< in messages
  std::string text;  ///< the whole file: errors count its lines
  SvgDrawing drawing;
};

/// Steps 3 to 5. `text` is what was parsed; `drawings` has what each of those of the scene is.
SurfaceScene make_scene(const ParsedScene& scene, std::shared_ptr<const SurfaceMesh> mesh,
                        std::string_view text, const ReadOptions& options, Context& context,
                        std::span<const DrawingFile* const> drawings = {});

/// Polygons as fans of triangles, in order. Errors: those of SurfaceMesh.
SurfaceMesh fanned_surface(const PolygonMesh& mesh);

struct SceneFile {
  SurfaceScene scene;
  std::string model;  ///< its path
  std::vector<std::string>
      notes;  ///< of the readers of mesh and drawings, with their files, for people
};

/// The whole of it; "-" is standard input. `options.name` is ignored.
SceneFile read_scene_file(const std::string& path, ReadOptions options, Context& context);

}  // namespace plumb
