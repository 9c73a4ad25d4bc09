// The files in which slicers state that volumes of a 3MF model are no parts of the shape.
//
// PrusaSlicer and programs like it store all volumes of an object in one mesh, and list ranges of
// its triangles in Metadata/Slic3r_PE_model.config. Bambu Studio and OrcaSlicer store each volume
// as an object, and list the components of an object in Metadata/model_settings.config.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh/threemf_archive.h"

namespace plumb {

/// The volumes that are no parts of the shape: supports, modifiers and negative volumes.
struct ThreeMfSettings {
  /// Triangles of an object of the first part.
  struct Range {
    std::uint32_t object = 0;
    std::uint32_t first = 0;  ///< The first triangle, counted from 0.
    std::uint32_t last = 0;   ///< The last triangle.
    std::string_view called;  ///< The kind of volume, for a warning.
  };

  std::vector<Range> ranges;
  /// For pairs of an object of the first part and the object that a component of it places: the
  /// kind of volume.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string_view> components;
};

/// Reads the settings of an archive. Throws the errors of ZipArchive and XmlStream, and Syntax.
ThreeMfSettings read_threemf_settings(ZipArchive& archive, const std::string& file,
                                      MemoryCharge& charge);

}  // namespace plumb
