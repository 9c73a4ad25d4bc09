// The package of a 3MF file: relationships, parts, other files; and the writer.
//
// A package is a ZIP archive whose parts are named by paths (Open Packaging Conventions, ECMA-376).
// Parts are read in the order in which they are named for the first time. A part that is named
// twice is read once. Tested by tests/io/threemf_test.cpp.
#include "plumb/io/mesh/threemf.h"

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/threemf_archive.h"
#include "plumb/io/mesh/threemf_build.h"
#include "plumb/io/mesh/threemf_model.h"
#include "plumb/io/mesh/threemf_settings.h"
#include "plumb/io/mesh/threemf_xml.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr const char* kRelationships = "_rels/.rels";
constexpr std::string_view kModelType =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// Finds the model part among the relationships of a package.
class RelationshipReader : public XmlListener {
 public:
  explicit RelationshipReader(const std::string& file)
      : stream_(threemf_text_name(file, kRelationships), *this) {}

  std::optional<std::string> read(ZipArchive& archive, std::uint64_t entry) {
    archive.read(entry, [this](std::string_view block) { stream_.feed(block); });
    stream_.finish();
    return target_;
  }

  void start(const XmlTag& tag) override {
    if (tag.name != "Relationship" || tag.attribute("Type") != kModelType || target_) return;
    target_ = threemf_part_name(tag.attribute("Target").value_or(""));
  }
  void end() override {}

 private:
  XmlStream stream_;
  std::optional<std::string> target_;
};

/// Returns the name of the model part. In archives without relationships, it has its usual name.
std::string start_part(ZipArchive& archive, const std::string& file) {
  constexpr const char* kUsual = "3D/3dmodel.model";
  std::optional<std::string> target;
  if (const auto entry = archive.find(kRelationships)) {
    target = RelationshipReader(file).read(archive, *entry);
  }
  if (target) return *target;
  if (archive.find(kUsual)) return kUsual;
  const std::vector<std::string> names = archive.names();
  const bool has_amf = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name.ends_with(".amf") || name.ends_with(".AMF");
  });
  throw Error(ErrorCode::UnknownFormat,
              has_amf ? "the ZIP archive is a packed AMF file; give it the extension .amf"
                      : "the ZIP archive has no 3D model, so it is no 3MF file",
              {file});
}

bool ends_with_any(std::string_view name, std::initializer_list<std::string_view> ends) {
  return std::any_of(ends.begin(), ends.end(),
                     [&](std::string_view end) { return name.ends_with(end); });
}

/// Notes the files of the archive that are not read.
void note_other_files(const ZipArchive& archive, ThreeMfScene& scene) {
  for (const std::string& path : archive.names()) {
    std::string_view name = path;
    take_prefix(name, "/");
    const bool is_read = scene.part_numbers.find(name) != scene.part_numbers.end();
    if (is_read || ends_with_any(name, {"/", ".rels", "[Content_Types].xml"})) continue;
    scene.passed.insert(ends_with_any(name, {".png", ".jpg", ".jpeg"}) ? "pictures"
                        : name.starts_with("Metadata/")                ? "settings of slicers"
                        : name.ends_with(".model") ? "models that nothing refers to"
                                                   : "other files of the archive");
  }
}

MeshFile read_package(std::string_view bytes, const ReadOptions& options, Context& context) {
  ZipArchive archive(bytes, context);
  ThreeMfScene scene(context);
  scene.looks.is_kept = options.attributes;
  scene.part_of(start_part(archive, options.name));
  for (std::uint32_t part = 0; part < scene.parts.size(); ++part) {
    read_threemf_model(archive, part, options, bytes.size(), scene, context);
  }
  const ThreeMfSettings settings = read_threemf_settings(archive, options.name, scene.charge);
  note_other_files(archive, scene);
  MeshFile file = build_threemf(scene, settings, options.name, context);
  scene.source.clear();
  return file;
}

}  // namespace

bool begins_like_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

MeshFile read_threemf(std::string_view bytes, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  try {
    return read_package(bytes, options, context);
  } catch (const Error& error) {
    if (!error.place().file.empty() || error.code() == ErrorCode::Cancelled) throw;
    throw Error(error.code(), error.message(), {options.name});
  }
}

// ---------------------------------------------------------------- writing

namespace {

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr std::string_view kPackageRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rel0" Target="/3D/3dmodel.model"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

constexpr std::string_view kThreeMfMaterials =
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view kThreeMfSets =
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";

void write_object(TextOutput& out, const PolygonMesh& mesh, const ThreeMfResources& looks) {
  out << "<object id=\"1\" type=\"model\"";
  looks.write_object(out);
  out << "><mesh>\n<vertices>\n";
  for (const Point3& p : mesh.points) {
    out << "<vertex x=\"" << p.x << "\" y=\"" << p.y << "\" z=\"" << p.z << "\"/>\n";
  }
  out << "</vertices>\n<triangles>\n";
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out << "<triangle v1=\"" << face[0] << "\" v2=\"" << face[1] << "\" v3=\"" << face[2] << '"';
    looks.write_triangle(out, f);
    out << "/>\n";
  }
  out << "</triangles>\n";
  looks.write_sets(out);
  out << "</mesh></object>\n";
}

/// Returns the model part. A mesh without faces is a model without objects: 3MF has no empty mesh.
std::string model_text(const PolygonMesh& mesh, const MeshAttributes& attributes) {
  std::ostringstream stream;
  TextOutput out(stream);
  const ThreeMfResources looks(mesh, attributes);
  const bool has_object = mesh.face_count() > 0;
  out << R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US"
 xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02")";
  if (looks.has_colors()) out << "\n xmlns:m=\"" << kThreeMfMaterials << '"';
  if (looks.has_sets()) out << "\n xmlns:t=\"" << kThreeMfSets << '"';
  out << ">\n<resources>\n";
  looks.write_groups(out);
  if (has_object) write_object(out, mesh, looks);
  out << "</resources>\n<build>\n"
      << (has_object ? "<item objectid=\"1\"/>\n" : "") << "</build>\n</model>\n";
  out.flush();
  return std::move(stream).str();
}

}  // namespace

void write_threemf(std::ostream& out, const PolygonMesh& mesh, const MeshAttributes& attributes) {
  require_doubles(mesh);
  require_triangles(mesh);
  const std::string model = model_text(mesh, attributes);
  const std::array<ZipEntry, 3> entries{
      ZipEntry{"[Content_Types].xml", kContentTypes},
      ZipEntry{kRelationships, kPackageRelationships},
      ZipEntry{"3D/3dmodel.model", model},
  };
  write_zip(out, entries);
}

}  // namespace plumb
