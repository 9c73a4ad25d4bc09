// Dispatch over mesh formats: names, extensions, guesses from content, files.
//
// A format is determined by an explicit name; otherwise by the extension; otherwise by the first
// bytes. Binary STL is recognised by its size or by its control characters, and all other formats
// by their first word. glTF files may name other files of their folder, so only reading by path can
// load these. Files are written through OutputFile, so a failed write leaves nothing behind.
// Formats: docs/formats.md, section Meshes. Tested by tests/io/mesh_io_test.cpp.
#include "plumb/io/mesh_io.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>

#include "plumb/base/internal/work_log.h"
#include "plumb/io/mesh/amf.h"
#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/mesh/glb.h"
#include "plumb/io/mesh/gltf.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/obj.h"
#include "plumb/io/mesh/off.h"
#include "plumb/io/mesh/ply.h"
#include "plumb/io/mesh/stl.h"
#include "plumb/io/mesh/threemf.h"
#include "plumb/io/text/charged_input.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/foreign_files.h"
#include "plumb/io/text/input_cursors.h"

namespace plumb {
namespace {

constexpr std::array<std::pair<std::string_view, MeshFormat>, 11> kNames{{
    {"off", MeshFormat::Off},
    {"off-exact", MeshFormat::ExactOff},
    {"obj", MeshFormat::Obj},
    {"stl", MeshFormat::Stl},
    {"stl-binary", MeshFormat::StlBinary},
    {"ply", MeshFormat::Ply},
    {"ply-text", MeshFormat::PlyText},
    {"gltf", MeshFormat::Gltf},
    {"glb", MeshFormat::Gltf},
    {"3mf", MeshFormat::ThreeMf},
    {"amf", MeshFormat::Amf},
}};

/// Returns the first word that does not belong to a comment.
std::string_view first_word(std::string_view text) {
  take_prefix(text, "\xEF\xBB\xBF");
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (!text.starts_with('#')) return text.substr(0, text.find_first_of(" \t\r\n"));
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

}  // namespace

std::optional<MeshFormat> mesh_format_named(std::string_view name) {
  for (const auto& [known, format] : kNames) {
    if (known == name) return format;
  }
  return {};
}

std::optional<MeshFormat> mesh_format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  const bool is_plain = extension.find('-') == extension.npos;
  return is_plain && !extension.empty() ? mesh_format_named(extension.substr(1)) : std::nullopt;
}

bool lists_triangles(MeshFormat format) {
  return format == MeshFormat::Stl || format == MeshFormat::StlBinary ||
         format == MeshFormat::Gltf || format == MeshFormat::ThreeMf || format == MeshFormat::Amf;
}

MeshFormat guess_mesh_format(std::string_view bytes) {
  if (begins_like_zip(bytes)) return MeshFormat::ThreeMf;
  if (begins_like_amf(bytes)) return MeshFormat::Amf;
  if (is_binary_stl(bytes) || is_text_stl(bytes)) return MeshFormat::Stl;
  const std::string_view word = first_word(bytes);
  if (word.starts_with("glTF") || word.starts_with('{')) return MeshFormat::Gltf;
  if (word == "ply") return MeshFormat::Ply;
  if (begins_off(word)) return MeshFormat::Off;
  return has_binary_content(bytes) ? MeshFormat::Stl : MeshFormat::Obj;
}

namespace {

/// Returns the name of the format in foreign_files.h.
std::string_view kind_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::Obj:
      return "OBJ";
    case MeshFormat::Stl:
    case MeshFormat::StlBinary:
      return "STL";
    case MeshFormat::Ply:
    case MeshFormat::PlyText:
      return "PLY";
    case MeshFormat::Gltf:
      return "glTF";
    case MeshFormat::ThreeMf:
      return "3MF";
    case MeshFormat::Amf:
      return "AMF";
    default:
      return "OFF";
  }
}

MeshFile read_mesh_as(std::string_view bytes, MeshFormat format, const ReadOptions& options,
                      Context& context) {
  switch (format) {
    case MeshFormat::Obj:
      return read_obj(bytes, options, context);
    case MeshFormat::Stl:
    case MeshFormat::StlBinary:
      return read_stl(bytes, options, context);
    case MeshFormat::Ply:
    case MeshFormat::PlyText:
      return read_ply(bytes, options, context);
    case MeshFormat::Gltf:
      return read_gltf(bytes, {}, options, context);
    case MeshFormat::ThreeMf:
      return read_threemf(bytes, options, context);
    case MeshFormat::Amf:
      return read_amf(bytes, options, context);
    default:
      return read_off(bytes, options, context);
  }
}

}  // namespace

MeshFile read_mesh(std::string_view bytes, MeshFormat format, const ReadOptions& options,
                   Context& context) {
  return naming_foreign_files(bytes, kind_of(format), options.name,
                              [&] { return read_mesh_as(bytes, format, options, context); });
}

namespace {

/// Reads a file in a known folder, so that the file may refer to other files.
MeshFile read_placed_mesh(const std::string& path, std::string_view bytes, MeshFormat format,
                          const ReadOptions& options, Context& context) {
  const bool names_files =
      format == MeshFormat::Gltf || (format == MeshFormat::Obj && options.attributes);
  if (!names_files || path == "-") return read_mesh(bytes, format, options, context);
  const auto load = [&](const std::string& name) {
    return read_input(named_file(path, name, options.named_files), context);
  };
  return naming_foreign_files(bytes, kind_of(format), options.name, [&] {
    return format == MeshFormat::Obj ? read_obj(bytes, options, context, load)
                                     : read_gltf(bytes, load, options, context);
  });
}

/// Refuses a binary file if neither its name nor its length indicates STL.
[[noreturn]] void refuse_unknown(std::string_view bytes, const std::string& name) {
  constexpr std::string_view kNoReader = "-";
  const auto kind = foreign_kind(bytes, kNoReader, FileReaders::Solids);
  throw Error(ErrorCode::UnknownFormat,
              kind.value_or("a binary file of a kind that is not known; if it is STL, give it the "
                            "extension .stl"),
              {.file = name});
}

}  // namespace

MeshFile read_mesh_of(const std::string& path, std::string_view bytes, const ReadOptions& options,
                      Context& context) {
  const WorkPhase phase("mesh from text");
  const std::optional<MeshFormat> named = mesh_format_of(path);
  const MeshFormat format = named.value_or(guess_mesh_format(bytes));
  const bool is_any_binary =
      format == MeshFormat::Stl && !is_binary_stl(bytes) && !is_text_stl(bytes);
  if (!named && path != "-" && is_any_binary) refuse_unknown(bytes, options.name);
  return read_placed_mesh(path, bytes, format, options, context);
}

std::string lack_of_faces(const MeshFile& file) {
  const std::size_t points = file.mesh.points.size();
  const bool is_empty = points == 0 && file.notes.empty() && file.warnings.empty();
  if (file.mesh.face_count() > 0 || is_empty) return {};
  std::string text = "the file has no faces";
  if (points > 0) {
    text = "the file has " + std::to_string(points) + (points == 1 ? " vertex" : " vertices") +
           " but no faces";
  }
  for (const auto* sentences : {&file.notes, &file.warnings}) {
    for (const std::string& sentence : *sentences) text += "; " + sentence;
  }
  return text;
}

MeshFile read_mesh_file(const std::string& path, std::optional<MeshFormat> format,
                        ReadOptions options, Context& context) {
  options.name = input_name(path);
  const ChargedInput input(path, context);
  return format ? read_placed_mesh(path, input.bytes(), *format, options, context)
                : read_mesh_of(path, input.bytes(), options, context);
}

namespace {

/// Throws Error{BadIndex} if a corner of a face refers to no point.
void require_corners(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const std::uint32_t corner : mesh.face(f)) {
      if (corner < mesh.points.size()) continue;
      throw Error(ErrorCode::BadIndex, "face " + std::to_string(f) + " has a corner " +
                                           std::to_string(corner) + ", but there are " +
                                           std::to_string(mesh.points.size()) + " points, from 0");
    }
  }
}

/// Throws Error{BadArgument} if the format is only read.
void require_written(MeshFormat format) {
  if (format != MeshFormat::Amf) return;
  throw Error(ErrorCode::BadArgument, "AMF is not written; 3MF holds the same");
}

}  // namespace

void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat format) {
  write_mesh(out, mesh, format, unlimited_context());
}

void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat format, Context& context) {
  require_written(format);
  require_corners(mesh);
  switch (format) {
    case MeshFormat::ExactOff:
      return write_off(out, mesh, MeshNumbers::Exact, context);
    case MeshFormat::Obj:
      return write_obj(out, mesh, context);
    case MeshFormat::Stl:
      return write_stl_text(out, mesh);
    case MeshFormat::StlBinary:
      return write_stl_binary(out, mesh);
    case MeshFormat::Ply:
      return write_ply_binary(out, mesh);
    case MeshFormat::PlyText:
      return write_ply_text(out, mesh);
    case MeshFormat::Gltf:
      return write_glb(out, mesh);
    case MeshFormat::ThreeMf:
      return write_threemf(out, mesh);
    default:
      return write_off(out, mesh, MeshNumbers::Nearest, context);
  }
}

void write_mesh(std::ostream& out, const PolygonMesh& mesh, const MeshAttributes& attributes,
                MeshFormat format, const std::string& library) {
  require_corners(mesh);
  require_complete(attributes, mesh);
  switch (format) {
    case MeshFormat::Off:
      return write_off(out, mesh, attributes);
    case MeshFormat::ExactOff:
      return write_off(out, mesh, attributes, MeshNumbers::Exact);
    case MeshFormat::Obj:
      return write_obj(out, mesh, attributes, library);
    case MeshFormat::Ply:
      return write_ply_binary(out, mesh, attributes);
    case MeshFormat::PlyText:
      return write_ply_text(out, mesh, attributes);
    case MeshFormat::Gltf:
      return write_glb(out, mesh, attributes);
    case MeshFormat::ThreeMf:
      return write_threemf(out, mesh, attributes);
    default:
      return write_mesh(out, mesh, format);
  }
}

void write_material_library(std::ostream& out, const MeshAttributes& attributes) {
  write_obj_library(out, attributes);
}

std::string lost_attributes(const MeshAttributes& attributes, MeshFormat format) {
  std::vector<std::string> lost;
  const auto add = [&](bool is_lost, const std::string& what) {
    if (is_lost && std::find(lost.begin(), lost.end(), what) == lost.end()) lost.push_back(what);
  };
  const bool is_off = format == MeshFormat::Off || format == MeshFormat::ExactOff;
  const bool is_ply = format == MeshFormat::Ply || format == MeshFormat::PlyText;
  const bool is_obj = format == MeshFormat::Obj;
  const bool is_glb = format == MeshFormat::Gltf;
  const bool is_3mf = format == MeshFormat::ThreeMf;
  const bool has_colors = is_off || is_ply || is_obj || is_glb || is_3mf;
  const std::vector<const MeshChannel*> of_glb =
      is_glb ? glb_channels(attributes) : std::vector<const MeshChannel*>();
  const bool has_texcoords = !of_glb.empty() && of_glb.back()->name.starts_with("texcoord_");
  if (!attributes.face_material.empty()) {
    for (const MeshMaterial& material : attributes.materials) {
      add(material.color && !has_colors, "colours of faces");
      const bool is_index = is_off && is_off_color_index(material);
      add(!material.name.empty() && !is_obj && !is_glb && !is_3mf && !is_index,
          "names of materials");
      add(!material.texture.empty() && !is_obj && !has_texcoords, "textures");
    }
  }
  add(!attributes.face_group.empty() && !is_obj && !is_3mf, "groups");
  add(!attributes.face_id.empty() && !is_ply, "ids of faces");
  for (const MeshChannel& channel : attributes.channels) {
    const bool is_color = channel.name == "color" && (channel.width == 3 || channel.width == 4);
    const bool is_usual = is_color || (channel.name == "normal" && channel.width == 3) ||
                          (channel.name == "texcoord_0" && channel.width == 2);
    const bool is_held = is_ply || ((is_off || is_obj) && is_usual) || (is_3mf && is_color) ||
                         std::any_of(of_glb.begin(), of_glb.end(), [&](const MeshChannel* written) {
                           return written->name == channel.name;
                         });
    add(!is_held, "channel '" + channel.name + "'");
    add(is_obj && is_color && channel.width == 4, "opacity of vertices");
  }
  std::string sentence;
  for (const std::string& what : lost) {
    sentence +=
        (sentence.empty() ? "not written, because the format does not hold them: " : ", ") + what;
  }
  return sentence;
}

namespace {

/// Returns the format that the caller or the extension states. A .gltf file is text, which plumb
/// does not write; it does not write AMF either.
MeshFormat format_to_write(const std::string& path, std::optional<MeshFormat> format) {
  if (!format && !path.ends_with(".gltf")) format = mesh_format_of(path);
  if (format && *format != MeshFormat::Amf) return *format;
  throw Error(ErrorCode::UnknownFormat,
              "the extension names no format that is written: .off, .obj, .stl, .ply, .glb, "
              ".3mf",
              {path});
}

}  // namespace

void write_mesh_file(const std::string& path, const PolygonMesh& mesh,
                     const MeshAttributes& attributes, std::optional<MeshFormat> format) {
  const MeshFormat used = format_to_write(path, format);
  const bool has_library =
      used == MeshFormat::Obj && !attributes.face_material.empty() && !path.ends_with(".mtl");
  std::optional<OutputFile> library;
  std::string name;
  if (has_library) {
    const std::filesystem::path file = path_of(path).replace_extension(".mtl");
    name = file_name_of(file.filename());
    library.emplace(file_name_of(file));
    write_material_library(library->stream(), attributes);
    library->finish();
  }
  OutputFile file(path);
  write_mesh(file.stream(), mesh, attributes, used, name);
  file.finish();
  if (library) library->commit();
  file.commit();
}

void write_mesh_file(const std::string& path, const PolygonMesh& mesh,
                     std::optional<MeshFormat> format) {
  const MeshFormat used = format_to_write(path, format);
  OutputFile file(path);
  write_mesh(file.stream(), mesh, used);
  file.finish();
  file.commit();
}

void write_mesh_file(const std::string& path, const TriangleMesh& mesh,
                     std::optional<MeshFormat> format) {
  PolygonMesh polygons;
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    const double* const p = &mesh.coordinates[3 * i];
    polygons.points.push_back({p[0], p[1], p[2]});
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    polygons.add_face(std::span(mesh.triangles).subspan(3 * t, 3));
  }
  write_mesh_file(path, polygons, format);
}

PolygonMesh as_written(PolygonMesh mesh, MeshFormat format) {
  if (format == MeshFormat::ExactOff) return mesh;
  if (format == MeshFormat::Gltf) require_faces(mesh);
  if (lists_triangles(format)) require_triangles(mesh);
  const bool has_floats = format == MeshFormat::StlBinary || format == MeshFormat::Gltf;
  if (has_floats) return rounded_to_floats(std::move(mesh));
  require_doubles(mesh);
  mesh.exact.clear();
  return mesh;
}

}  // namespace plumb
