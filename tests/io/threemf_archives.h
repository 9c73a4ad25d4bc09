// 3MF files for tests: archives made of parts.
#pragma once

#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/mesh/threemf_archive.h"

namespace plumb::testing {

inline const std::string kThreeMfRelationships =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Id=\"r\" Target=\"/3D/3dmodel.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

using ThreeMfParts = std::vector<std::pair<std::string, std::string>>;

inline std::string zip_of(const ThreeMfParts& parts) {
  std::vector<ZipEntry> entries;
  for (const auto& [name, text] : parts) entries.push_back({name, text});
  std::ostringstream out;
  write_zip(out, entries);
  return out.str();
}

/// An archive whose model part has this text.
inline std::string threemf_of(const std::string& model, const ThreeMfParts& others = {}) {
  ThreeMfParts parts{{"_rels/.rels", kThreeMfRelationships}, {"3D/3dmodel.model", model}};
  parts.insert(parts.end(), others.begin(), others.end());
  return zip_of(parts);
}

/// A model of these resources and build items; both are on lines of their own, the first is 2.
inline std::string threemf_model(const std::string& resources, const std::string& items,
                                 const std::string& attributes = "") {
  return "<model " + attributes +
         " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">\n"
         "<resources>" +
         resources + "</resources>\n<build>" + items + "</build></model>";
}

/// The tetrahedron with the corners 0, x, y and z.
inline const std::string kThreeMfTetrahedron =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices>"
    "<triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
    "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles>"
    "</mesh>";

inline std::string threemf_object(int id, const std::string& contents,
                                  const std::string& attributes = "") {
  return "<object id=\"" + std::to_string(id) + "\" " + attributes + ">" + contents + "</object>";
}

}  // namespace plumb::testing
