#include "plumb/io/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "plumb/io/plane_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/solid_sets.h"
#include "plumb/io/stl_reader.h"
#include "plumb/io/text_cursor.h"

namespace plumb {
namespace {

constexpr std::array<std::string_view, 7> kShapes{
    "POINT",           "LINESTRING",   "POLYGON",           "MULTIPOINT",
    "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"};
constexpr std::string_view kBlank = " \t\r";

/// The first line that is neither blank nor a comment.
std::string_view first_line(std::string_view text) {
  take_prefix(text, "\xEF\xBB\xBF");
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    if (!line.empty() && line.front() != '#') return line;
  }
  return {};
}

bool is_shape(std::string_view line) {
  std::string word;
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) == 0 || word.size() > 20) break;
    word += static_cast<char>(std::toupper(byte));
  }
  return std::ranges::find(kShapes, word) != kShapes.end();
}

/// Behind the string that begins at `at`.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
  return std::min(at + 1, text.size());
}

/// Has the outermost object of a JSON text "asset", as glTF must, and no "type", as GeoJSON must?
bool is_gltf_text(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  take_prefix(text, "\xEF\xBB\xBF");
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  if (!text.starts_with('{')) return false;
  std::size_t depth = 0;
  bool has_asset = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{' || text[i] == '[') ++depth;
    if ((text[i] == '}' || text[i] == ']') && --depth == 0) break;
    if (text[i] != '"') continue;
    const std::size_t end = end_of_string(text, i);
    const std::size_t next = text.find_first_not_of(kSpace, end);
    if (depth == 1 && next != text.npos && text[next] == ':') {
      const std::string_view key = text.substr(i, end - i);
      if (key == "\"type\"") return false;
      has_asset |= key == "\"asset\"";
    }
    i = end - 1;
  }
  return has_asset;
}

std::size_t count_words(std::string_view line) {
  std::size_t count = 0;
  while (!line.empty()) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    if (!line.empty()) ++count;
    line.remove_prefix(std::min(line.find_first_of(kBlank), line.size()));
  }
  return count;
}

}  // namespace

FileKind kind_of_file(const std::string& path, std::string_view bytes) {
  if (std::filesystem::path(path).extension() == ".map") return FileKind::Map;
  if (mesh_format_of(path) || is_nef_file(path, bytes)) return FileKind::Solid;
  if (plane_format_of(path)) return FileKind::PlaneSet;
  if (is_binary_stl(bytes) || is_gltf_text(bytes)) return FileKind::Solid;
  const std::string_view line = first_line(bytes);
  if (is_shape(line) || guess_plane_format(bytes) != PlaneFormat::Wkt) return FileKind::PlaneSet;
  const bool is_number = !line.empty() && '0' <= line.front() && line.front() <= '9';
  return is_number && count_words(line) == 2 ? FileKind::Map : FileKind::Solid;
}

}  // namespace plumb
