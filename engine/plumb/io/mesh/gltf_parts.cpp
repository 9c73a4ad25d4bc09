// Parts of glTF files: the binary container, buffers that are given by uris, and triangles.
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
#include <iterator>
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

/// Returns the bytes of base64 text, or no value if the text is not base64. The characters that
/// fill up the last group may be missing.
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

/// Whether the name names a file of the same folder.
bool is_file_name(const std::string& name) {
  constexpr std::size_t kLongest = 255;  // The longest name that file systems allow.
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

std::string decoded_uri(std::string_view uri) {
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

std::string bytes_of_uri(std::string_view uri, const GltfLoader& loader, Context& context) {
  if (uri.starts_with("data:")) return from_data_uri(uri, context);
  std::string file = decoded_uri(uri);
  while (file.starts_with("./")) file.erase(0, 2);
  if (!is_file_name(file)) {
    throw Error(ErrorCode::CannotOpen,
                plumb::quoted(file) + ": only files of the same folder are read");
  }
  if (!loader) throw Error(ErrorCode::CannotOpen, "the folder of its file is not known");
  return loader(file);
}

namespace {

constexpr std::uint64_t kMostVertices = 0xffff'0000;

/// Returns the image of a normal under the inverse transpose of a map, with the length of the
/// normal. The inverse transpose is the matrix of cofactors divided by the determinant. Only the
/// sign of the determinant matters.
std::array<double, 3> mapped_normal(const GltfTransform& m, bool is_mirrored,
                                    const std::array<double, 4>& n) {
  const auto cofactor = [&m](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  std::array<double, 3> image{};
  for (std::size_t i = 0; i < 3; ++i) {
    image[i] = cofactor(i, 0) * n[0] + cofactor(i, 1) * n[1] + cofactor(i, 2) * n[2];
  }
  const double length = std::hypot(image[0], image[1], image[2]);
  const double factor = std::hypot(n[0], n[1], n[2]) / length * (is_mirrored ? -1 : 1);
  for (double& part : image) part = length > 0 ? part * factor : 0;
  return image;
}

}  // namespace

std::array<double, 4> GltfChannel::at(std::size_t vertex) const {
  if (width == 4) return values.numbers<4>(vertex);
  if (width == 3) {
    const auto [x, y, z] = values.numbers<3>(vertex);
    return {x, y, z, 1};
  }
  const auto [u, v] = values.numbers<2>(vertex);
  return {u, v, 1, 1};
}

void GltfTriangles::add(const GltfPrimitive& p, const GltfTransform& placed,
                        const std::string& where) {
  const std::uint64_t first = add_points(p.positions, placed, where);
  const auto corner = [&](std::size_t i) {
    const std::size_t index = p.indices ? p.indices->index(i) : i;
    if (index < p.positions.count) return static_cast<std::uint32_t>(first + index);
    fail(ErrorCode::BadIndex, where, "no vertex " + std::to_string(index));
  };
  // If there are points, they are finite, and the transform that moves them is finite, too.
  const bool is_mirrored = p.positions.count > 0 && mirrors(placed);
  const std::vector<Collected*> channels = channels_of(p);
  const std::size_t count = p.corner_count(), step = p.mode == GltfMode::kTriangles ? 3 : 1;
  for (std::size_t i = 0; i + 2 < count; i += step) {
    if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, count);
    const std::uint32_t a = corner(p.mode == GltfMode::kFan ? 0 : i);
    const std::uint32_t b = corner(i + 1), c = corner(i + 2);
    const bool turns = is_mirrored != (p.mode == GltfMode::kStrip && i % 2 == 1);
    add_triangle(a, b, c, turns);
    if (!keeps_materials_) continue;
    material_.push_back(p.material);
    if (channels.empty()) continue;
    const auto vertex = [&](std::uint32_t of) { return static_cast<std::size_t>(of - first); };
    add_values(p, channels, placed, is_mirrored,
               {vertex(a), vertex(turns ? c : b), vertex(turns ? b : c)});
  }
}

/// Returns the place where the channels of a primitive are collected, and reserves memory for its
/// corners. The corners before them have the values of gaps.
std::vector<GltfTriangles::Collected*> GltfTriangles::channels_of(const GltfPrimitive& p) {
  std::vector<Collected*> found;
  const std::size_t corners = mesh_.mesh().corners.size();
  const std::size_t added =
      p.mode == GltfMode::kTriangles ? p.corner_count() : 3 * (p.corner_count() - 2);
  for (const GltfChannel& channel : p.channels) {
    auto at = std::find_if(collected_.begin(), collected_.end(), [&](const Collected& each) {
      return each.channel.name == channel.name;
    });
    const bool is_color = channel.name == "color";
    if (at == collected_.end()) {
      collected_.push_back({{channel.name, is_color ? 4 : channel.width, {}}});
      at = std::prev(collected_.end());
    }
    std::vector<double>& values = at->channel.values;
    const std::size_t end = (corners + added) * at->channel.width;
    if (end > values.capacity()) {
      const std::size_t room = std::max(end, 2 * values.capacity());
      charge_.add(room * sizeof(double), "the attributes of the mesh");
      values.reserve(room);
    }
    values.resize(corners * at->channel.width, is_color ? 1 : 0);
    at->has_opacity = at->has_opacity || channel.width == 4;
    found.push_back(&*at);
  }
  return found;
}

/// Appends the numbers of the corners of a triangle. In glTF, v of a texture points down.
void GltfTriangles::add_values(const GltfPrimitive& p, const std::vector<Collected*>& channels,
                               const GltfTransform& placed, bool is_mirrored,
                               const std::array<std::size_t, 3>& vertices) {
  for (std::size_t k = 0; k < channels.size(); ++k) {
    MeshChannel& to = channels[k]->channel;
    for (const std::size_t vertex : vertices) {
      std::array<double, 4> values = p.channels[k].at(vertex);
      for (double& part : values) {
        not_finite_ += std::isfinite(part) ? 0 : 1;
        if (!std::isfinite(part)) part = 0;
      }
      if (to.name == "color") {
        for (double& part : values) part = part > 1 ? 1 : part < 0 ? 0 : part;
      } else if (to.name == "normal") {
        const auto [x, y, z] = mapped_normal(placed, is_mirrored, values);
        values = {x, y, z, 0};
      } else {
        values[1] = 1 - values[1];
      }
      for (std::size_t i = 0; i < to.width; ++i) {
        const bool is_finite = std::isfinite(values[i]);
        to.values.push_back(is_finite ? values[i] : 0);
        not_finite_ += is_finite ? 0 : 1;
      }
    }
  }
}

/// Returns a channel with the corners of the faces that were kept.
MeshChannel GltfTriangles::finished(Collected& from, const std::vector<std::uint32_t>& kept) {
  const std::size_t width = from.channel.width;
  const bool is_color = from.channel.name == "color";
  const std::size_t kept_width = is_color && !from.has_opacity ? 3 : width;
  MeshChannel result{std::move(from.channel.name), static_cast<std::uint32_t>(kept_width), {}};
  charge_.add(3 * kept.size() * kept_width * sizeof(double), "the attributes of the mesh");
  result.values.reserve(3 * kept.size() * kept_width);
  const std::vector<double>& values = from.channel.values;
  for (const std::uint32_t f : kept) {
    for (std::size_t c = 3 * std::size_t{f}; c < 3 * std::size_t{f} + 3; ++c) {
      for (std::size_t i = 0; i < kept_width; ++i) {
        const std::size_t at = c * width + i;
        result.values.push_back(at < values.size() ? values[at] : is_color ? 1 : 0);
      }
    }
  }
  return result;
}

void GltfTriangles::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turns) {
  for (const std::uint32_t v : {a, turns ? c : b, turns ? b : c}) mesh_.add_corner(v);
  mesh_.end_face();
}

/// Adds points and returns the number of the first. Primitives of one mesh often differ in their
/// materials alone and share their vertices, which are added once if these primitives follow each
/// other.
std::uint64_t GltfTriangles::add_points(const GltfElements& positions, const GltfTransform& m,
                                        const std::string& where) {
  const bool is_last = last_points_ && last_points_->m == m &&
                       last_points_->positions.bytes.data() == positions.bytes.data() &&
                       last_points_->positions.stride == positions.stride &&
                       last_points_->positions.count == positions.count &&
                       last_points_->positions.component == positions.component &&
                       last_points_->positions.is_normalized == positions.is_normalized;
  if (is_last) return last_points_->first;
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
  last_points_ = {positions, m, first};
  return first;
}

MeshFile GltfTriangles::take() {
  MeshFile file = mesh_.take();
  std::vector<std::uint32_t> kept;
  const std::size_t dropped =
      weld_vertices(file.mesh, context_, keeps_materials_ ? &kept : nullptr);
  for (const std::uint32_t f : kept) file.attributes.face_material.push_back(material_[f]);
  for (Collected& each : collected_) file.attributes.channels.push_back(finished(each, kept));
  if (not_finite_ > 0) {
    file.notes.push_back("numbers of vertices that are not finite, read as 0: " +
                         std::to_string(not_finite_));
  }
  if (dropped > 0) {
    file.notes.push_back(std::to_string(dropped) + (dropped == 1 ? " triangle" : " triangles") +
                         " with two equal corners left out");
  }
  file.faces_left_out = dropped;
  return file;
}

}  // namespace plumb
