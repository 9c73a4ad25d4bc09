// What shapes that were read from a file keep on their way to a set and back: for fuzz targets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "oracle/shape_oracle.h"
#include "plumb/io/plane/geojson.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/io/plane_io.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace plumb::fuzz {

inline void require_sound(const Nef2& set) {
  const auto flaw = set.audit();
  if (!flaw) return;
  std::fprintf(stderr, "%s at %s\n", flaw->invariant.c_str(), flaw->place.c_str());
  require(false, "a set passes its audit");
}

inline std::string text_of(const PlaneText& ready) {
  std::ostringstream out;
  Context context;
  ready.write(out, context);
  return out.str();
}

inline Nef2 read_back(const std::string& text, PlaneFormat format) {
  Context context;
  return read_plane_set(text, format, {"written"}, context).set;
}

/// Read, written, read: the same set; written again: the same bytes.
inline void require_nef2_round(const Nef2& set) {
  Context context;
  const std::string text = text_of(PlaneText(set, PlaneFormat::Nef2, context));
  const Nef2 copy = read_back(text, PlaneFormat::Nef2);
  require_sound(copy);
  require(copy == set, "a set survives .nef2");
  require(text_of(PlaneText(copy, PlaneFormat::Nef2, context)) == text,
          "a set is written as it was read");
}

/// Requires a bounded closed set: it comes back as it was rounded, and then nothing changes.
inline void require_text_round(const Nef2& set, PlaneFormat format) {
  Context context;
  try {
    const PlaneText ready(set, format, context);
    const PlaneLosses& losses = ready.losses();
    require(!losses.open && !losses.unbounded, "nothing of a closed bounded set is left out");
    const Nef2 copy = read_back(text_of(ready), format);
    require_sound(copy);
    require(copy == round_to_doubles(set, context).set, "a file has the rounded set");
    require(!PlaneText(copy, format, context).losses().any(), "a set of doubles loses nothing");
    if (to_shapes(set.parts(), context).points.all_double()) {
      require(copy == set, "a set of doubles survives WKT, GeoJSON and WKB");
    }
  } catch (const Error& error) {
    require(error.code() == ErrorCode::NumberOutOfRange, "only far coordinates cannot be written");
  }
}

inline void require_members(const PlaneShapes& shapes, const Nef2& set) {
  constexpr std::size_t kMostSamples = 30;
  const testing::ShapeTwin twin(shapes);
  for (const testing::ExactPoint& p : testing::telling_points(shapes, kMostSamples)) {
    const testing::ShapePlace place = twin.place(p);
    if (place == testing::ShapePlace::OnRing) continue;
    const bool is_in =
        set.contains(RationalPoint2{testing::to_rational(p.x), testing::to_rational(p.y)});
    require(is_in == (place == testing::ShapePlace::Inside), "a set holds what its shapes mean");
  }
}

inline bool is_small(const PlaneShapes& shapes) {
  constexpr std::size_t kMostPoints = 60;  // crossings are quadratic, and so is the twin
  if (shapes.points.size() > kMostPoints) return false;
  constexpr std::size_t kMostDigits = 400;
  for (std::uint32_t i = 0; i < shapes.points.size(); ++i) {
    if (shapes.points.is_double(i)) continue;
    const RationalPoint2 p = shapes.points.exact(i);
    if (p.x.str().size() + p.y.str().size() > kMostDigits) return false;
  }
  return true;
}

inline void judge_shapes(const PlaneShapes& shapes) {
  if (!is_small(shapes)) return;
  oracle_reached();
  Context context;
  const Nef2 set = to_set(shapes, context);
  require_sound(set);
  require(set.is_bounded() && set.is_closed(), "shapes are bounded closed sets");
  require_members(shapes, set);
  require_nef2_round(set);
  require_text_round(set, PlaneFormat::Wkt);
  require_text_round(set, PlaneFormat::GeoJson);
  require_text_round(set, PlaneFormat::Wkb);
}

/// Both formats hold the same shapes: written in one and the other, they read as the same set.
inline void require_formats_agree(const PlaneShapes& shapes) {
  if (!is_small(shapes)) return;
  try {
    Context context;
    const PlaneShapes doubles = with_nearest_doubles(shapes, context);
    std::ostringstream wkt;
    std::ostringstream geojson;
    write_wkt(wkt, doubles, context);
    write_geojson(geojson, doubles, context);
    require(
        read_back(wkt.str(), PlaneFormat::Wkt) == read_back(geojson.str(), PlaneFormat::GeoJson),
        "WKT and GeoJSON say the same");
  } catch (const Error& error) {
    require(error.code() == ErrorCode::NumberOutOfRange, "only far coordinates cannot be written");
  }
}

/// What a file of `bytes` bytes may be charged at most: shapes come in steps of 2^17 bytes; "1/3
/// 2," (6 bytes) takes 28 + 32 + 64.
inline Limits limits_for(std::size_t bytes) {
  Limits limits;
  limits.max_memory_bytes = 32 * bytes + (std::size_t{1} << 18U);
  return limits;
}

using RequirePlace = void (*)(const Error& error, std::string_view text);

/// The shapes that `read(text, options, context)` finds, or none with a placed error.
template <class Read>
std::optional<PlaneShapes> shapes_of(Read read, std::string_view text, bool exact_decimals,
                                     RequirePlace require_its_place) {
  Context context(limits_for(text.size()));
  try {
    return read(text, ReadOptions{kFileName, exact_decimals}, context).shapes;
  } catch (const Error& error) {
    const bool is_expansion = error.code() == ErrorCode::ResourceLimit;
    require(!is_expansion || exact_decimals, "memory charged is in proportion to the input");
    require_its_place(error, text);
    return {};
  }
}

/// A reader on arbitrary bytes: the first says how decimals are read, the rest is the text.
template <class Read>
void judge_reader(Read read, const std::uint8_t* data, std::size_t size,
                  RequirePlace require_its_place = require_place) {
  begin_input();
  if (size == 0) return;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::optional<PlaneShapes> shapes =
      shapes_of(read, text, (data[0] & 1U) != 0, require_its_place);
  if (!shapes) return;
  judge_shapes(*shapes);
  require_formats_agree(*shapes);
}

}  // namespace plumb::fuzz
