// Parts of glTF files: the binary container, buffers behind uris, and triangles.
//
// The container is validated chunk by chunk: lengths are compared with the bytes that exist before
// they are used, and unknown chunks are skipped. A uri is base64 data or the name of a file in the
// same folder; a name that could lead elsewhere ("..", a slash, even encoded as %2f) is refused, so
// that a model cannot read other files. Triangles of strips alternate in orientation, and a
// transform that mirrors reverses all, which an exact sign of its determinant decides. Format: glTF
// 2.0 Specification (Khronos Group), sections on GLB, buffers and meshes; docs/formats.md, section
// glTF.
// Tested by tests/io/gltf_test.cpp.
#include "plumb/io/mesh/gltf_parts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/input_cursors.h"

namespace plumb {
namespace {

constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::size_t kDigitsPerCheckpoint = 65536;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBytesChunk = 0x004e4942;

std::optional<std::uint32_t> digit_of(char c) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = kDigits.find(c);
  if (at == kDigits.npos) return {};
  return static_cast<std::uint32_t>(at);
}

/// Returns the bytes of base64 text, or no value if it is none. The signs that fill up the last
/// group may be missing.
std::optional<std::string> from_base64(std::string_view text, Context& context) {
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return {};
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t group = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i % kDigitsPerCheckpoint == 0) context.checkpoint("read", i, text.size());
    const auto digit = digit_of(text[i]);
    if (!digit) return {};
    group = group << 6U | *digit;
    if (i % 4 == 1) bytes += static_cast<char>(group >> 4U & 0xffU);
    if (i % 4 == 2) bytes += static_cast<char>(group >> 2U & 0xffU);
    if (i % 4 == 3) bytes += static_cast<char>(group & 0xffU);
  }
  return bytes;
}

std::optional<std::uint32_t> hex_of(char c) {
  if ('0' <= c && c <= '9') return static_cast<std::uint32_t>(c - '0');
  if ('a' <= c && c <= 'f') return static_cast<std::uint32_t>(c - 'a') + 10;
  if ('A' <= c && c <= 'F') return static_cast<std::uint32_t>(c - 'A') + 10;
  return {};
}

/// Returns a uri with codes such as %20 replaced. What is no code stays.
std::string decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_code = uri[i] == '%' && i + 2 < uri.size();
    const auto high = is_code ? hex_of(uri[i + 1]) : std::nullopt;
    const auto low = is_code ? hex_of(uri[i + 2]) : std::nullopt;
    if (high && low) {
      text += static_cast<char>(*high << 4U | *low);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// Whether the name names a file of the same folder.
bool is_file_name(const std::string& name) {
  constexpr std::size_t kLongest = 255;  // Longest name that file systems allow.
  return !name.empty() && name.size() <= kLongest && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == name.npos;
}

/// Reads the chunks of a binary file. Its header is "glTF", version, length; a chunk is length,
/// kind, bytes. Unknown kinds are skipped.
void read_chunks(GltfContainer& out) {
  BinaryInput in(out.file, 0, std::endian::little, out.name);
  if (in.bytes_left() < kHeader) in.fail(ErrorCode::CountMismatch, "cut off");
  in.skip(4);
  if (in.take<std::uint32_t>() != 2) in.fail(ErrorCode::UnknownFormat, "not version 2 of glTF", 4);
  const std::size_t length = in.take<std::uint32_t>();
  if (length > out.file.size()) {
    in.fail(ErrorCode::CountMismatch,
            std::to_string(length) + " bytes are announced, " + std::to_string(out.file.size()) +
                " are there",
            8);
  }
  if (length < kHeader + kChunkHeader) in.fail(ErrorCode::CountMismatch, "no chunk of JSON", 8);
  for (bool is_first = true; in.position() < length; is_first = false) {
    const std::size_t at = in.position();
    if (length - at < kChunkHeader) in.fail(ErrorCode::CountMismatch, "a chunk is cut off", at);
    const std::size_t size = in.take<std::uint32_t>();
    const auto kind = in.take<std::uint32_t>();
    if (size > length - in.position()) {
      in.fail(ErrorCode::CountMismatch, "a chunk is longer than the file", at);
    }
    const std::string_view chunk = out.file.substr(in.position(), size);
    if (is_first != (kind == kJsonChunk)) {
      in.fail(ErrorCode::Syntax, "the first chunk, and no other, is JSON", at);
    }
    if (is_first) out.json = chunk;
    if (kind == kBytesChunk && !out.chunk) out.chunk = chunk;
    in.skip(size);
  }
}

std::string from_data_uri(std::string_view uri, Context& context) {
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64")) {
    throw Error(ErrorCode::UnknownFormat, "data that is not base64");
  }
  context.charge_memory(uri.size(), "a buffer");
  auto bytes = from_base64(uri.substr(comma + 1), context);
  if (!bytes) throw Error(ErrorCode::Syntax, "data that is not base64");
  context.release_memory(uri.size() - bytes->size());
  return std::move(*bytes);
}

}  // namespace

void GltfContainer::fail(std::size_t byte, ErrorCode code, const std::string& what) const {
  byte = std::min(byte, json.size());
  if (is_binary) {
    const auto at = static_cast<std::size_t>(json.data() - file.data()) + byte;
    throw Error(code, "at byte " + std::to_string(at) + ": " + what, {name});
  }
  TextCursor cursor(file, name);
  cursor.move_to(json.data() + byte);
  cursor.fail(code, what);
}

GltfContainer open_gltf(std::string_view bytes, const std::string& name) {
  if (bytes.find_first_not_of(" \t\r\n") == bytes.npos) {
    TextCursor cursor(bytes, name);
    cursor.next_line();
    cursor.fail(ErrorCode::CountMismatch, "the file has no content");
  }
  GltfContainer out{bytes, name, bytes.starts_with("glTF"), bytes, {}};
  if (out.is_binary) {
    read_chunks(out);
  } else {
    take_prefix(out.json, "\xEF\xBB\xBF");
  }
  return out;
}

std::string bytes_of_uri(std::string_view uri, const GltfLoader& loader, Context& context) {
  if (uri.starts_with("data:")) return from_data_uri(uri, context);
  const std::string file = decoded(uri);
  if (!is_file_name(file)) {
    throw Error(ErrorCode::CannotOpen,
                plumb::quoted(file) + ": only files of the same folder are read");
  }
  if (!loader) throw Error(ErrorCode::CannotOpen, "the folder of its file is not known");
  return loader(file);
}

namespace {

constexpr std::uint64_t kMostVertices = 0xffff'0000;

}  // namespace

void GltfTriangles::add(const GltfPrimitive& p, const GltfTransform& placed,
                        const std::string& where) {
  const std::uint64_t first = add_points(p.positions, placed, where);
  const auto corner = [&](std::size_t i) {
    const std::size_t index = p.indices ? p.indices->index(i) : i;
    if (index < p.positions.count) return static_cast<std::uint32_t>(first + index);
    fail(ErrorCode::BadIndex, where, "no vertex " + std::to_string(index));
  };
  // If there are points they are finite, and so is the transform that moves them.
  const bool turns = p.positions.count > 0 && mirrors(placed);
  const std::size_t count = p.corner_count(), step = p.mode == GltfMode::kTriangles ? 3 : 1;
  for (std::size_t i = 0; i + 2 < count; i += step) {
    if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, count);
    const std::uint32_t a = corner(p.mode == GltfMode::kFan ? 0 : i);
    const std::uint32_t b = corner(i + 1), c = corner(i + 2);
    add_triangle(a, b, c, turns != (p.mode == GltfMode::kStrip && i % 2 == 1));
    if (keeps_materials_) material_.push_back(p.material);
  }
}

void GltfTriangles::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turns) {
  for (const std::uint32_t v : {a, turns ? c : b, turns ? b : c}) mesh_.add_corner(v);
  mesh_.end_face();
}

/// Adds points and returns the number of the first.
std::uint64_t GltfTriangles::add_points(const GltfElements& positions, const GltfTransform& m,
                                        const std::string& where) {
  const std::uint64_t first = mesh_.point_count();
  if (positions.count > kMostVertices - first) {
    fail(ErrorCode::ResourceLimit, where, "more than 2^32 vertices");
  }
  const bool moves = m != kGltfIdentity;
  for (std::size_t i = 0; i < positions.count; ++i) {
    if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, positions.count);
    const std::array<double, 3> p = positions.numbers<3>(i);
    const std::array<double, 3> q = moves ? applied(m, p) : p;
    if (!std::isfinite(q[0]) || !std::isfinite(q[1]) || !std::isfinite(q[2])) {
      fail(ErrorCode::NumberOutOfRange, where,
           "vertex " + std::to_string(i) + " has a coordinate that is not finite");
    }
    mesh_.add_point({q[0], q[1], q[2]});
  }
  return first;
}

MeshFile GltfTriangles::take() {
  MeshFile file = mesh_.take();
  std::vector<std::uint32_t> kept;
  const std::size_t dropped =
      weld_vertices(file.mesh, context_, keeps_materials_ ? &kept : nullptr);
  for (const std::uint32_t f : kept) file.attributes.face_material.push_back(material_[f]);
  if (dropped > 0) {
    file.notes.push_back(std::to_string(dropped) + (dropped == 1 ? " triangle" : " triangles") +
                         " with two equal corners left out");
  }
  file.faces_left_out = dropped;
  return file;
}

}  // namespace plumb
