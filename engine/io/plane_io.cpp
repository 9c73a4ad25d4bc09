#include "plumb/io/plane_io.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "plumb/base/refused_memory.h"
#include "plumb/io/geojson_reader.h"
#include "plumb/io/geojson_writer.h"
#include "plumb/io/input.h"
#include "plumb/io/nef2_reader.h"
#include "plumb/io/nef2_writer.h"
#include "plumb/io/wkt_reader.h"
#include "plumb/io/wkt_writer.h"
#include "plumb/plane/nef2_parts.h"

namespace plumb {
namespace {

std::string to_text(const PlaneCounts& counts) {
  return std::to_string(counts.vertices) + " vertices, " + std::to_string(counts.edges) +
         " edges, " + std::to_string(counts.faces) + " faces";
}

}  // namespace

std::optional<PlaneFormat> plane_format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".wkt") return PlaneFormat::Wkt;
  if (extension == ".geojson" || extension == ".json") return PlaneFormat::GeoJson;
  if (extension == ".nef2") return PlaneFormat::Nef2;
  return {};
}

PlaneFormat guess_plane_format(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with('{') || text.starts_with('[')) return PlaneFormat::GeoJson;
  return text.starts_with("plumb-") ? PlaneFormat::Nef2 : PlaneFormat::Wkt;
}

Nef2 read_plane_set(std::string_view text, PlaneFormat format, const ReadOptions& options,
                    Context& context) try {
  switch (format) {
    case PlaneFormat::Nef2:
      return read_nef2(text, options, context);
    case PlaneFormat::GeoJson:
      return to_set(read_geojson(text, options, context), context);
    default:
      return to_set(read_wkt(text, options, context), context);
  }
} catch (...) {
  rethrow_refused_memory();
}

Nef2 read_plane_set_file(const std::string& path, std::optional<PlaneFormat> format,
                         ReadOptions options, Context& context) try {
  options.name = input_name(path);
  const std::string text = read_input(path, context);
  if (!format) format = plane_format_of(path);
  if (!format) format = guess_plane_format(text);
  Nef2 set = read_plane_set(text, *format, options, context);
  context.release_memory(text.size());
  return set;
} catch (...) {
  rethrow_refused_memory();
}

PlaneCounts counts_of(const Nef2& set) {
  const PlaneComplex& complex = set.complex();
  return {complex.vertex_count(), complex.edge_count(), complex.face_count()};
}

std::vector<std::string> PlaneLosses::sentences() const try {
  std::vector<std::string> list;
  if (unbounded) list.push_back("unbounded parts were left out; unbounded sets need .nef2");
  if (open) list.push_back("the set is not closed; its closure was written (.nef2 keeps marks)");
  if (reshaped) {
    list.push_back("rounding to doubles changed the shape: " + to_text((*reshaped)[0]) +
                   " became " + to_text((*reshaped)[1]) + " (.nef2 is exact)");
  }
  return list;
} catch (...) {
  rethrow_refused_memory();
}

PlaneText::PlaneText(const Nef2& set, PlaneFormat format, Context& context) try
    : set_(set), format_(format) {
  if (format == PlaneFormat::Nef2) return;
  const PlaneParts parts = parts_of(set, context);
  losses_.unbounded = parts.dropped_unbounded;
  losses_.open = parts.dropped_open;
  shapes_ = to_shapes(parts, context);
  if (shapes_.points.all_double()) return;
  const PlaneCounts before =
      counts_of(parts.dropped_unbounded ? to_set(shapes_, context) : set.closure());
  shapes_ = rounded(std::move(shapes_), context);
  const PlaneCounts after = counts_of(to_set(shapes_, context));
  if (before != after) losses_.reshaped = {before, after};
} catch (...) {
  rethrow_refused_memory();
}

void PlaneText::write(std::ostream& out, Context& context) const try {
  switch (format_) {
    case PlaneFormat::Nef2:
      return write_nef2(out, set_.complex(), context);
    case PlaneFormat::GeoJson:
      return write_geojson(out, shapes_, context);
    default:
      return write_wkt(out, shapes_, context);
  }
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
