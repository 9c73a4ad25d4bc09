// The WKB reader against an encoder of its own, bytes that databases write, and malformed files.
#include "plumb/io/plane/wkb.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "plane_sets.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/predicates/error.h"

namespace plumb::wkb_test {
namespace {

using testing::Dice;

PlaneFile read(const std::string& bytes, Limits limits = {}) {
  Context context(limits);
  return read_wkb(bytes, {"some.file"}, context);
}

std::string as_wkt(const PlaneShapes& shapes) {
  std::ostringstream out;
  Context context;
  write_wkt(out, shapes, context);
  return out.str();
}

std::string hex_of(const std::string& bytes, bool upper) {
  const std::string digits = upper ? "0123456789ABCDEF" : "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += {digits[byte >> 4U], digits[byte & 15U]};
  }
  return text;
}

/// Writes geometries in random dialects: byte order, Z, M, SRID, ISO or EWKB codes for each head.
class Encoder {
 public:
  explicit Encoder(Dice& dice) : dice_(dice) {}

  /// Geometries for all shapes: one for each, or one of many, or a collection of all.
  std::string encode(const PlaneShapes& shapes) {
    shapes_ = &shapes;
    const bool is_collection = dice_.below(3) == 0;
    if (is_collection) {
      head(7);
      number(static_cast<std::uint32_t>(shapes.polygon_count() + shapes.line_count() +
                                        shapes.single_points.size()));
    }
    group(is_collection, 6, shapes.polygon_count(), [&](std::size_t p) { polygon(p); });
    group(is_collection, 5, shapes.line_count(), [&](std::size_t l) {
      head(2);
      positions(shapes.line(l), false);
    });
    group(is_collection, 4, shapes.single_points.size(), [&](std::size_t i) {
      head(1);
      position(shapes.single_points[i]);
    });
    return bytes_;
  }

 private:
  template <class Number>
  void number(Number value) {
    std::string raw(sizeof(Number), '\0');
    const auto bits = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      const bool is_native = is_big_ == (std::endian::native == std::endian::big);
      raw[i] = bits[is_native ? i : sizeof(Number) - 1 - i];
    }
    bytes_ += raw;
  }
  void head(std::uint32_t code) {
    is_big_ = dice_.below(2) == 0;
    has_z_ = dice_.below(3) == 0;
    has_m_ = dice_.below(3) == 0;
    bytes_ += is_big_ ? '\0' : '\1';
    if (dice_.below(2) == 0) return number(code + (has_z_ ? 1000U : 0U) + (has_m_ ? 2000U : 0U));
    const bool has_srid = dice_.below(2) == 0;
    number(code + (has_z_ ? 0x8000'0000U : 0U) + (has_m_ ? 0x4000'0000U : 0U) +
           (has_srid ? 0x2000'0000U : 0U));
    if (has_srid) number(std::uint32_t{4326});
  }
  void position(std::uint32_t i) {
    const Point2 p = shapes_->points.approx(i);
    number(p.x);
    number(p.y);
    if (has_z_) number(std::numeric_limits<double>::quiet_NaN());
    if (has_m_) number(std::numeric_limits<double>::infinity());
  }
  void positions(std::span<const std::uint32_t> chain, bool is_ring) {
    number(static_cast<std::uint32_t>(chain.size() + (is_ring ? 1 : 0)));
    for (const std::uint32_t i : chain) position(i);
    if (is_ring) position(chain.front());
  }
  void polygon(std::size_t p) {
    const std::uint32_t first = shapes_->polygon_begin[p], last = shapes_->polygon_begin[p + 1];
    head(last - first == 1 && dice_.below(3) == 0 ? 17 : 3);
    number(last - first);
    for (std::uint32_t r = first; r < last; ++r) positions(shapes_->ring(r), true);
  }
  template <class Item>
  void group(bool is_in_collection, std::uint32_t code, std::size_t count, Item item) {
    if (!is_in_collection && dice_.below(2) == 0) {
      head(code);
      number(static_cast<std::uint32_t>(count));
    }
    for (std::size_t i = 0; i < count; ++i) item(i);
  }

  Dice& dice_;
  const PlaneShapes* shapes_ = nullptr;
  std::string bytes_;
  bool is_big_ = false, has_z_ = false, has_m_ = false;
};

TEST(WkbReader, reads_the_shapes_that_were_encoded) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    const std::string wkt = testing::any_wkt(dice);
    SCOPED_TRACE(wkt);
    Context context;
    const PlaneShapes shapes = read_wkt(wkt, {}, context).shapes;
    const std::string bytes = Encoder(dice).encode(shapes);
    EXPECT_TRUE(begins_like_wkb(bytes));
    EXPECT_EQ(as_wkt(read(bytes).shapes), as_wkt(shapes));
    const std::string hex = hex_of(bytes, dice.below(2) == 0);
    EXPECT_TRUE(begins_like_wkb(hex));
    EXPECT_EQ(as_wkt(read("\\x" + hex + "\r\n").shapes), as_wkt(shapes));
  }
}

TEST(WkbReader, reads_what_databases_write) {
  const std::string point = "0101000000000000000000F03F0000000000000040";
  const std::string empty = "0101000000000000000000F87F000000000000F87F";
  const std::vector<std::pair<std::string, std::string>> cases{
      {point, "POINT (1 2)\n"},
      {"00000000013FF00000000000004000000000000000", "POINT (1 2)\n"},
      {"0x0101000020e6100000000000000000f03f0000000000000040", "POINT (1 2)\n"},
      {"\\x01E9030000000000000000F03F00000000000000400000000000000840", "POINT (1 2)\n"},
      {empty, "GEOMETRYCOLLECTION EMPTY\n"},
      {"# points\n\n" + point + "\n" + empty + " " + point + "\n", "MULTIPOINT ((1 2), (1 2))\n"},
      {"010300000000000000", "GEOMETRYCOLLECTION EMPTY\n"},
      {"01030000000100000004000000"
       "00000000000000000000000000000000"
       "0000000000001040"
       "0000000000000000"
       "00000000000010400000000000000840"
       "00000000000000000000000000000000",
       "POLYGON ((0 0, 4 0, 4 3, 0 0))\n"},
  };
  for (const auto& [text, wkt] : cases) EXPECT_EQ(as_wkt(read(text).shapes), wkt) << text;
  EXPECT_EQ(read("01010000A0E6100000000000000000F03F00000000000000400000000000000840").notes,
            std::vector<std::string>{"passed over: coordinate reference systems, heights (Z)"});
  EXPECT_TRUE(read(point).notes.empty());
}

TEST(WkbReader, closes_rings_with_a_note) {
  const PlaneFile file = read(
      "010300000001000000030000000000000000000000000000000000000000000000000010400000000000000000"
      "00000000000010400000000000000840");
  EXPECT_EQ(as_wkt(file.shapes), "POLYGON ((0 0, 4 0, 4 3, 0 0))\n");
  EXPECT_EQ(file.notes, std::vector<std::string>{
                            "closed by an edge: rings that end elsewhere than they start (1)"});
}

std::string bytes(std::initializer_list<int> values) {
  std::string all;
  for (const int value : values) all += static_cast<char>(value);
  return all;
}

std::string zeros(std::size_t count) { return std::string(count, '\0'); }

TEST(WkbReader, refuses_malformed_bytes_with_their_place) {
  const std::string infinite = bytes({0, 0, 0, 0, 0, 0, 0xf0, 0x7f});
  const std::string one = bytes({0, 0, 0, 0, 0, 0, 0xf0, 0x3f});
  const std::string collection = bytes({1, 7, 0, 0, 0, 1, 0, 0, 0});
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += collection;
  const auto tin = [&](const std::string& z) {
    return bytes({1, 0xf8, 3, 0, 0, 1, 0, 0, 0}) +
           bytes({1, 0xf9, 3, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0}) + zeros(24) + one + zeros(16) +
           zeros(8) + one + z + zeros(24);
  };
  EXPECT_NO_THROW(read(tin(zeros(8))));
  const std::vector<std::pair<std::string, std::string>> cases{
      {bytes({1}), "at byte 0: the bytes end"},
      {bytes({1, 1, 0, 0, 0}) + zeros(15), "at byte 5: the bytes end"},
      {bytes({1, 9, 9, 9, 9}), "at byte 1: no geometry has the code"},
      {bytes({1, 8, 0, 0, 0, 0, 0, 0, 0}), "at byte 0: code 8: curves are not read"},
      {bytes({1, 12, 0, 0, 0, 1, 0, 0, 0}) + bytes({1, 10, 0, 0, 0, 0, 0, 0, 0}),
       "at byte 9: code 10: curves are not read"},
      {bytes({1, 2, 0, 0, 0, 2, 0, 0, 0}) + zeros(31), "at byte 5: 2 items"},
      {bytes({1, 3, 0, 0, 0, 255, 255, 255, 255}), "at byte 5: 4294967295 items"},
      {bytes({1, 4, 0, 0, 0, 1, 0, 0, 0}) + bytes({1, 3, 0, 0, 0, 0, 0, 0, 0}),
       "at byte 9: a geometry of code 3 among others"},
      {bytes({1, 1, 0, 0, 0}) + one + infinite, "at byte 5: a coordinate that is not finite"},
      {bytes({1, 2, 0, 0, 0, 1, 0, 0, 0}) + zeros(16), "at byte 25: a line of one position"},
      {bytes({1, 3, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}) + zeros(24) + one,
       "at byte 45: a ring of 2 positions"},
      {bytes({1, 1, 0, 0, 0}) + zeros(16) + bytes({7}), "at byte 21: the bytes end"},
      {bytes({1, 1, 0, 0, 0}) + zeros(16) + bytes({7, 0, 0, 0, 0}), "at byte 21: expected a byte"},
      {deep, "at byte 585: geometries nested more than 64 deep"},
      {tin(one), "heights differ"},
      {"", "1:1: the file has no content"},
      {"# nothing\n", "2:1: the file has no content"},
      {"0101\n01zz\n", "1:1: at byte 0: the bytes end"},
      {"01010000000000000000000000000000000000000000\n", "1:1: at byte 21: the bytes end"},
      {"\n  01g1", "2:3: expected WKB"},
      {"010", "1:1: expected WKB"},
      {"0x", "1:1: expected WKB"},
      {"POINT (1 2)", "1:1: expected WKB"},
      {"\xff\xfe", "1:1: byte 0xff"},
  };
  for (const auto& [text, message] : cases) {
    SCOPED_TRACE(message);
    try {
      read(text);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.place().file, "some.file");
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

std::string written(const PlaneShapes& shapes) {
  std::ostringstream out;
  Context context;
  write_wkb(out, shapes, context);
  return out.str();
}

TEST(WkbWriter, writes_what_the_standard_says) {
  PlaneShapes point;
  point.points.push_back({1, -2});
  point.single_points = {0};
  EXPECT_EQ(hex_of(written(point), true), "0101000000000000000000F03F00000000000000C0");
  EXPECT_EQ(hex_of(written({}), false), "010700000000000000");
}

TEST(WkbWriter, writes_what_the_reader_reads) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Context context;
    const PlaneShapes shapes = read_wkt(testing::any_wkt(dice), {}, context).shapes;
    EXPECT_EQ(as_wkt(read(written(shapes)).shapes), as_wkt(shapes));
  }
}

TEST(WkbReader, keeps_to_its_limits) {
  std::string many = bytes({1, 2, 0, 0, 0, 0x20, 0x4e, 0, 0}) + zeros(16 * 20000);
  Limits limits;
  limits.max_memory_bytes = 10000 * sizeof(Point2);
  EXPECT_THROW(read(many, limits), Error);
  limits.max_memory_bytes *= 8;
  EXPECT_EQ(read(many, limits).shapes.line_count(), 1U);
  EXPECT_EQ(read(hex_of(many, true), limits).shapes.line_count(), 1U);
  std::stop_source source;
  source.request_stop();
  Context context({}, source.get_token());
  EXPECT_THROW(read_wkb(many, {}, context), Error);
}

TEST(WkbReader, knows_how_its_files_begin) {
  for (const std::string& other :
       {std::string(), zeros(100), std::string("0 0\n"), std::string("8 6 12"),
        std::string("01010000"), bytes({1, 1}), std::string("POINT (1 2)"), std::string("\\x"),
        bytes({1, 1, 1, 1, 1, 1}), std::string("plumb-nef2 1")}) {
    EXPECT_FALSE(begins_like_wkb(other));
  }
}

}  // namespace
}  // namespace plumb::wkb_test
