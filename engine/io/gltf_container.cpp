#include "plumb/io/gltf_container.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "plumb/io/binary_input.h"
#include "plumb/io/text_cursor.h"

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

/// None if it is no base64.
std::optional<std::string> from_base64(std::string_view text, Context& context) {
  if (text.size() % 4 != 0) return {};
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
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

/// %20 and such. What is no code stays.
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

bool is_file_name(const std::string& name) {
  constexpr std::size_t kLongest = 255;  // that systems know
  return !name.empty() && name.size() <= kLongest && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == name.npos;
}

/// Header: "glTF", version, length. Chunks: length, kind, bytes; unknown kinds are passed over.
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
    throw Error(ErrorCode::CannotOpen, "only files of the same folder are read");
  }
  if (!loader) throw Error(ErrorCode::CannotOpen, "the folder of its file is not known");
  return loader(file);
}

}  // namespace plumb
