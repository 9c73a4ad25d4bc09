// The model parts of a 3MF file: objects with meshes, components, build items and properties.
//
// A scene has flat arrays. An object is a mesh, which is a range of the points and faces of
// `source`, or a list of components, which is a range of `placements`. Coordinates and transforms
// stay in the units of their part until the scene is built (threemf_build.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/threemf_archive.h"
#include "plumb/io/mesh/threemf_looks.h"
#include "plumb/io/read_options.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational.h"

namespace plumb {

/// An affine map as 3MF lists it: the point (x, y, z) goes to x' = m[0] x + m[3] y + m[6] z + m[9],
/// and so on.
using ThreeMfTransform = std::array<Rational, 12>;

/// A component of an object, or an item of the build.
struct ThreeMfPlacement {
  static constexpr std::uint32_t kNoTransform = 0xffffffff;

  std::uint32_t stated_in = 0;  ///< The part that states it.
  std::uint32_t part = 0;       ///< The part of the object that is placed.
  std::uint32_t object = 0;     ///< The id of this object.
  std::uint32_t transform = kNoTransform;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// The purpose of an object.
enum class ThreeMfType : std::uint8_t { Model, Support, Surface, Other };

/// An object of a part. Ranges are half open.
struct ThreeMfObject {
  std::uint32_t part = 0;
  std::uint32_t id = 0;
  ThreeMfType type = ThreeMfType::Model;
  std::uint32_t first_point = 0, end_point = 0;
  std::uint32_t first_face = 0, end_face = 0;
  std::uint32_t first_component = 0, end_component = 0;
  std::uint32_t name = ThreeMfLook::kNone;  ///< The index of its name in ThreeMfLooks::names.
};

/// A part of the archive that describes a model.
struct ThreeMfPart {
  std::string name;                      ///< The path in the archive.
  Rational unit = 1;                     ///< Millimetres.
  std::string unit_name = "millimeter";  ///< Empty if no note shall name the unit.
};

/// All that the model parts of a file state.
struct ThreeMfScene {
  explicit ThreeMfScene(Context& context) : source(context), charge(context) {}

  std::vector<ThreeMfPart> parts;  ///< The package starts with the first of them.
  std::vector<ThreeMfObject> objects;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> object_of;  ///< (part, id).
  std::vector<ThreeMfPlacement> components;
  std::vector<ThreeMfPlacement> items;  ///< The build of the first part.
  bool has_lost_items = false;          ///< Whether items were left out because of a setting.
  std::deque<ThreeMfTransform> transforms;
  MeshCollector source;            ///< Points and faces of all objects.
  ThreeMfLooks looks;              ///< Materials and names, if they are kept.
  std::set<std::string> passed;    ///< What no mesh holds, for a note.
  std::set<std::string> left_out;  ///< Geometry that is not read, for a warning.
  std::map<std::string, std::uint32_t, std::less<>> part_numbers;  ///< Of the names of parts.
  MemoryCharge charge;

  /// Returns the number of a part, which is added if the scene does not have it.
  std::uint32_t part_of(const std::string& name);
};

/// Returns the name of a part in messages: "FILE(PART)", or "FILE" if the part has no name.
std::string threemf_text_name(const std::string& file, const std::string& part);
/// Returns the path in the archive of a part that a text names: without the slash at its front and
/// with %20 and the like decoded.
std::string threemf_part_name(std::string_view uri);

/// Reads part number `part` of the scene. Parts that it names are added to the scene and are still
/// to be read. Throws the errors of ZipArchive and XmlStream; CannotOpen if there is no such part;
/// UnknownFormat if it is no model of 3MF, or requires an extension that is not supported; Syntax,
/// BadIndex, BadShape and NumberOutOfRange, with their places.
void read_threemf_model(ZipArchive& archive, std::uint32_t part, const ReadOptions& options,
                        std::size_t archive_bytes, ThreeMfScene& scene, Context& context);

}  // namespace plumb
