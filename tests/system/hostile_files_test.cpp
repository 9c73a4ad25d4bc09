// Files that claim, or ask for, more than they hold: number bombs, counts, nesting and masses of
// next to nothing, in every format. Each is read or refused with an Error, what claims more than it
// holds always refused; the memory of it, numbers included, stays below what its format may take
// for a byte of the file and 100 kB, its time below 2 s for each MB (and half a second).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "generate/counted_checkpoints.h"
#include "generate/counted_memory.h"
#include "plumb/io/csg_reader.h"
#include "plumb/io/map_io.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/plane/dxf.h"
#include "plumb/io/plane/geojson.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid/half_space_reader.h"
#include "plumb/io/surface/scene_parser.h"
#include "plumb/io/svg_reader.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::hostile_files_test {
namespace {

constexpr std::size_t kMassBytes = 1'000'000;

using Read = void (*)(std::string_view text, const ReadOptions& options, Context& context);

template <PlaneFormat kFormat>
void read_plane(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_plane_set(text, kFormat, options, context);
}

void read_wkt_shapes(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_wkt(text, options, context);
}

void read_geojson_shapes(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_geojson(text, options, context);
}

template <MeshFormat kFormat>
void read_solid_mesh(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_mesh(text, kFormat, options, context);
}

void read_map_text(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_map(text, options, context);
}

void read_nef(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_nef3(text, options, context);
}

void read_planes(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_half_spaces(text, options, context);
}

void read_drawing(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_svg(text, options, 0.5, context);
}

void read_dxf_shapes(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_dxf(text, options, context);
}

void read_model(std::string_view text, const ReadOptions& options, Context& context) {
  (void)read_csg(options.name, text, {}, context);
}

void read_scene(std::string_view text, const ReadOptions& options, Context& context) {
  (void)parse_scene(text, options, context);
}

/// `with_number`: a file with @ where a number may be; `masses`: what may come again and again
/// between two texts; `claims`: counts and indices of what is not there.
struct Format {
  const char* name;
  Read read;
  std::string with_number;
  struct Mass {
    std::string before, unit, after;
  };
  std::vector<Mass> masses;
  std::vector<std::string> claims;
  double bytes_per_byte = 1;  ///< of memory, besides 100 kB
};

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> (8 * i)));
  return bytes;
}

std::string ply(const std::string& kind, const std::string& vertices, const std::string& faces) {
  return "ply\nformat " + kind + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uint uint vertex_indices\nend_header\n";
}

std::string strip(const std::string& vertices) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement tristrips 1\nproperty list uint int vertex_indices\n"
         "end_header\n0 0 0\n1 0 0\n0 1 0\n" +
         vertices;
}

std::string gltf(const std::string& count, const std::string& bytes) {
  return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": )" + bytes +
         R"(, "uri": "data:;base64,AAAAAAAAAAAAAAAA"}], "bufferViews": [{"buffer": 0, "byteLength": 12}],)"
         R"( "accessors": [{"bufferView": 0, "componentType": 5126, "count": )" +
         count +
         R"(, "type": "VEC3"}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],)"
         R"( "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]})";
}

std::vector<Format::Mass> masses_of_wkt() {
  return {{"", "GEOMETRYCOLLECTION(", ""},
          {"", "(", ""},
          {"MULTIPOLYGON (", "EMPTY,", "EMPTY)"},
          {"MULTIPOLYGON (", "(EMPTY),", "(EMPTY))"},
          {"POLYGON (", "(0 0,1 0,0 1,0 0),", "(0 0,1 0,0 1,0 0))"},
          {"", "POINT(0 0)\n", ""},
          {"MULTIPOINT (", "0 0,", "1 1)"},
          {"LINESTRING (", "0 0,", "1 1)"}};
}

std::vector<Format::Mass> masses_of_geojson() {
  return {{"", "[", ""},
          {R"({"type": "Polygon", "coordinates": )", "[", ""},
          {"", R"({"type":"GeometryCollection","geometries":[)", ""},
          {"", R"({"a":)", ""},
          {R"({"a": [)", "1,", R"(1], "type": "Point", "coordinates": [0, 0]})"},
          {R"({"type": "MultiPoint", "coordinates": [)", "[0,0],", "[0,0]]}"},
          {R"({"type": "MultiPolygon", "coordinates": [)", "[],", "[]]}"}};
}

std::vector<Format::Mass> masses_of_svg() {
  return {{"<svg>", "<g>", ""},
          {"<svg>", "<g/>", "</svg>"},
          {"<svg ", "a", "='1'></svg>"},
          {"<svg><path d='", "M0 0z", "'/></svg>"},
          {"<svg><path d='M0 0", "h1", "'/></svg>"},
          {"<svg><path d='M0 0", "h1z", "'/></svg>"},
          {"<svg viewBox='0 0 9 9'><path d='M0 0", "c9 9 0 9 0 0", "'/></svg>"},
          {"<svg ", "a='' ", "></svg>"},
          {"<svg><g transform='", "scale(9)", "'><path d='M0 0h1v1z'/></g></svg>"},
          {"<!DOCTYPE svg [<!ENTITY a '", "&a;&a;", "'>]><svg>&a;</svg>"}};
}

std::vector<Format> flat_formats() {
  const std::string most = "4294967294", half = "2147483647";
  const std::string wkt = "POLYGON ((0 0, @ 0, 0 1, 0 0))";
  const std::string geojson =
      R"({"type": "Polygon", "coordinates": [[[0, 0], [@, 0], [0, 1], [0, 0]]]})";
  return {
      {"map",
       read_map_text,
       "3 2\n0 0\n@ 0\n0 1\n1 2 3\n3 2 1\n",
       {{"", "\n", ""}, {"", "# \n", ""}, {"3 1\n0 0\n1 0\n0 1\n", "1 ", "\n"}},
       {half + " 1\n0 0\n", "3 " + half + "\n0 0\n1 0\n0 1\n1 2 3\n", most + " " + most + "\n"}},
      {"WKT", read_wkt_shapes, wkt, masses_of_wkt(), {}, 10},
      {"WKT to set", read_plane<PlaneFormat::Wkt>, wkt, masses_of_wkt(), {}, 50},
      {"GeoJSON", read_geojson_shapes, geojson, masses_of_geojson(), {}, 6},
      {"GeoJSON to set", read_plane<PlaneFormat::GeoJson>, geojson, masses_of_geojson(), {}, 50},
      {".nef2",
       read_plane<PlaneFormat::Nef2>,
       "plumb-nef2 1\n3 0 1 2 0\n0 0\n@ 0\n0 1\n1 1\n1 0 1 2 1 1 0\n1 0 1 3 1 0 1\n",
       {{"plumb-nef2 1\n", "# \n", ""}, {"plumb-nef2 1\n", "1 ", "\n"}},
       {"plumb-nef2 1\n" + half + " 0 1 2 0\n0 0\n",
        "plumb-nef2 1\n3 " + most + " 1 2 0\n0 0\n1 0\n0 1\n",
        "plumb-nef2 1\n3 0 " + most + " " + most + " " + most + "\n0 0\n1 0\n0 1\n"}},
      {"SVG",
       read_drawing,
       R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M0 0L@ 0 0 1z"/></svg>)",
       masses_of_svg(),
       {},
       35},
      {"DXF",
       read_dxf_shapes,
       "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n10\n@\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n",
       {{"0\nSECTION\n2\nENTITIES\n", "0\nCIRCLE\n10\n0\n20\n0\n40\n1\n", "0\nENDSEC\n0\nEOF\n"},
        {"0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n70\n1\n", "10\n0\n20\n0\n",
         "0\nENDSEC\n0\nEOF\n"},
        {"", "0\n", ""},
        {"", "999\n\n", "0\nEOF\n"}},
       {},
       80},
      {".csg",
       read_model,
       "cube(size = [1, @, 1]);\n",
       {{"", "cube();", ""},
        {"", "union(){", ""},
        {"polygon(points = [", "[0,0],", "[0,0]]);"},
        {"", "// \n", ""},
        {"cube(size = ", "[", ""}},
       {},
       60},
      {"scene",
       read_scene,
       R"({"model": "m.obj", "points": [[0, @, 0.5]], "polygons": [[0]]})",
       {{"", "[", ""},
        {R"({"model": "m.obj", "points": [)", "[0,0,0],", "[0,0,0]]}"},
        {R"({"model": "m.obj", "polygons": [)", "[],", "[]]}"},
        {"", R"({"a":)", ""}},
       {},
       15},
  };
}

std::vector<Format> space_formats() {
  const std::string most = "4294967294", half = "2147483647";
  return {
      {"OFF",
       read_solid_mesh<MeshFormat::Off>,
       "OFF\n4 4 6\n0 0 0\n@ 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
       {{"OFF\n", "# \n", ""},
        {"OFF\n1 0 0\n0 0 0\n", "# \n", ""},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000 ", "0 1 2 ", "\n"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ", "0 ", "\n"},
        {"OFF\n3 1 0\n0 0 0 ", "0 ", "\n"}},
       {"OFF\n" + half + " 1 0\n0 0 0\n", "OFF\n1 " + most + " 0\n0 0 0\n",
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + most + " 0 1 2\n"},
       5},
      {"OBJ",
       read_solid_mesh<MeshFormat::Obj>,
       "v 0 0 0\nv @ 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
       {{"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "f 1 2 3\n", ""},
        {"", "v 0 0 0\n", "f 1 2 3\n"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf", " 1 2 3", "\n"},
        {"", "o a\n", ""},
        {"v 0 0 0 ", "\\\n", ""}},
       {"v 0 0 0\nv 1 0 0\nf 1 2 " + half + "\n"},
       8},
      {"STL",
       read_solid_mesh<MeshFormat::Stl>,
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex @ 0 0\nvertex 0 1 0\nendloop\n"
       "endfacet\nendsolid\n",
       {{"solid\n", "\n", ""}, {"solid ", "a", "\n"}},
       {}},
      {"binary STL",
       read_solid_mesh<MeshFormat::StlBinary>,
       "",
       {},
       {std::string(80, 'a') + little_endian(0xFFFFFFFF),
        std::string(80, 'a') + little_endian(0x7FFFFFFF) + std::string(70, '\0')}},
      {"PLY",
       read_solid_mesh<MeshFormat::PlyText>,
       ply("ascii", "3", "1") + "0 0 0\n@ 0 0\n0 1 0\n3 0 1 2\n",
       {{"ply\n", "comment a\n", ""},
        {"ply\nformat ascii 1.0\n", "element a 1\nproperty int b\n", ""},
        {ply("ascii", "0", "1"), "1 ", "\n"},
        {"ply\n", "stray\n", ""},
        {strip("400000 "), "0 1 2 ", "\n"}},
       {ply("ascii", most, "1"), ply("ascii", "3", most) + "0 0 0\n1 0 0\n0 1 0\n",
        ply("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n" + most + " 0 1 2\n"},
       16},  // A vertex of a strip is a triangle.
      {"binary PLY",
       read_solid_mesh<MeshFormat::Ply>,
       "",
       {},
       {ply("binary_little_endian", most, "1"), ply("binary_little_endian", "0", most),
        ply("binary_little_endian", "0", "1") + little_endian(0xFFFFFFFE)}},
      {"glTF",
       read_solid_mesh<MeshFormat::Gltf>,
       "",
       {{"", "[", ""},
        {R"({"asset": {"version": "2.0"}, "nodes": [)", "{},", "{}]}"},
        {R"({"asset": {"version": "2.0"}, "nodes": [{"children": [)", "0,", "0]}]}"},
        {R"({"asset": {"version": "2.0"}, "a": )", R"({"a":)", ""}},
       {gltf("1000000000", "12"), gltf("1", "4000000000"), gltf("18446744073709551615", "12"),
        "glTF" + little_endian(2) + little_endian(0xFFFFFFFF) + little_endian(0xFFFFFFF0) + "JSON"},
       10},
      {".nef",
       read_nef,
       "plumb-nef3 1\n@ 0 0\n",
       {{"plumb-nef3 1\n", "# \n", ""}, {"plumb-nef3 1\n", "1 ", "\n"}},
       {"plumb-nef3 1\n" + half + " " + half + " " + half + " " + half + "\n",
        "plumb-nef3 1\nplanes " + most + "\n"}},
      {"half-spaces",
       read_planes,
       "1 1 @ -1 open\n",
       {{"", "1 0 0 0 open\n", ""}, {"", "# \n", ""}},
       {},
       5},
  };
}

std::vector<std::string> number_bombs() {
  const std::string million(1'000'000, '7');
  return {"1/0",           "1e999999999",
          "1e-999999999",  "-1e99999999999999999999",
          million,         "0." + million,
          "1/" + million,  million + "/3",
          "1e" + million,  "0/0",
          "nan",           "1e4096/3",
          "1e-4096",       "1e308",
          "4e-324",        "1/3e9999",
          million + "e-9", "-" + million + "." + million};
}

std::string replaced(std::string text, const std::string& number) {
  return text.replace(text.find('@'), 1, number);
}

std::string repeated_to(const Format::Mass& mass, std::size_t bytes) {
  std::string text = mass.before;
  while (text.size() < bytes) text += mass.unit;
  return text + mass.after;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Sanitizers slow down and keep what was freed; they look for other things here.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif
constexpr double kSlack = kSanitized ? 20 : 1;

/// The length of a file that is read for its checkpoints, which any build counts alike: sanitizers
/// read a quarter of it.
constexpr std::size_t long_file(std::size_t bytes) { return kSanitized ? bytes / 4 : bytes; }

/// What was most seen in a format.
struct Worst {
  double bytes = 0;    // of memory, for a byte of a file that is not small
  double seconds = 0;  // for each MB
};

/// Returns whether it was refused.
bool expect_bounded(const Format& format, const std::string& file, bool exact, Worst& worst) {
  SCOPED_TRACE(std::string(format.name) + ", " + std::to_string(file.size()) +
               " bytes: " + file.substr(0, 200));
  CountedMemory& memory = counted_memory();
  const std::int64_t held = memory.peak_bytes = memory.held_bytes;
  const double start = cpu_seconds();
  bool is_refused = false;
  try {
    ReadOptions options;
    options.exact_decimals = exact;
    Context context;
    format.read(file, options, context);
  } catch (const Error& error) {
    is_refused = true;
    EXPECT_FALSE(error.place().file.empty()) << error.what();
    EXPECT_NE(error.code(), ErrorCode::Cancelled);
  }
  const double seconds = cpu_seconds() - start;
  const auto bytes = static_cast<double>(memory.peak_bytes - held);
  const auto size = static_cast<double>(file.size());
  EXPECT_LE(bytes, format.bytes_per_byte * size + 100e3);
  EXPECT_LE(seconds, kSlack * (2e-6 * size + 0.5));
  if (size > 5e5) worst.bytes = std::max(worst.bytes, bytes / size);
  worst.seconds = std::max(worst.seconds, seconds / (size / 1e6 + 0.25));
  return is_refused;
}

void expect_bounded(const std::vector<Format>& formats) {
  for (const Format& format : formats) {
    Worst worst;
    for (const std::string& number :
         format.with_number.empty() ? std::vector<std::string>{} : number_bombs()) {
      for (const bool exact : {false, true}) {
        expect_bounded(format, replaced(format.with_number, number), exact, worst);
      }
    }
    for (const std::string& claim : format.claims) {
      EXPECT_TRUE(expect_bounded(format, claim, false, worst)) << format.name << ": " << claim;
    }
    for (const Format::Mass& mass : format.masses) {
      expect_bounded(format, repeated_to(mass, kMassBytes), false, worst);
    }
    std::printf("%-14s %6.1f bytes of memory for a byte, %5.2f s/MB\n", format.name, worst.bytes,
                worst.seconds);
  }
}

/// A rule for every reader: at most ten times the file and 64 MB. Drawings take more than ten times
/// a small one.
TEST(HostileFiles, LargeDrawings) {
  if (kSanitized) GTEST_SKIP() << "memory is judged where no sanitizer takes some";
  constexpr std::size_t kLargeBytes = 12'000'000;
  constexpr double kOfAnyFile = 64e6;
  CountedMemory& memory = counted_memory();
  bool is_refused = false;
  for (const Format::Mass& mass : masses_of_svg()) {
    const std::string file = repeated_to(mass, kLargeBytes);
    SCOPED_TRACE(file.substr(0, 100));
    const std::int64_t held = memory.peak_bytes = memory.held_bytes;
    try {
      Context context;
      read_drawing(file, {}, context);
    } catch (const Error& error) {
      is_refused |= error.code() == ErrorCode::ResourceLimit;
    }
    EXPECT_LE(static_cast<double>(memory.peak_bytes - held),
              10 * static_cast<double>(file.size()) + kOfAnyFile);
  }
  EXPECT_TRUE(is_refused);  // as it has to be for so many points
}

/// A stop does not wait for the end of a number.
TEST(HostileFiles, LongNumbersHaveCheckpoints) {
  constexpr std::size_t kDigits = long_file(8'000'000), kBytesPerCheckpoint = std::size_t{1} << 20U;
  std::vector<Format> formats = flat_formats();
  for (const Format& format : space_formats()) formats.push_back(format);
  CountedCheckpoints& counted = counted_checkpoints();
  for (const Format& format : formats) {
    if (format.with_number.empty()) continue;
    for (const char digit : {'0', '7'}) {
      SCOPED_TRACE(std::string(format.name) + ", digits " + digit);
      const std::string number = "1" + std::string(kDigits, digit);
      const std::string file = replaced(format.with_number, number);
      Context context;
      const std::uint64_t before = counted.passed;
      counted.begin();
      EXPECT_THROW(format.read(file, {}, context), Error);
      counted.end();
      EXPECT_GE(counted.passed - before, kDigits / kBytesPerCheckpoint);
    }
  }
}

/// A stop does not wait for the end of a mass, nor for what is made of it. Long lists in one record
/// are masses, too.
TEST(HostileFiles, MassesHaveCheckpoints) {
  constexpr std::size_t kBytes = long_file(4'000'000);
  constexpr double kLongest = 0.2;  // Seconds of CPU time.
  std::vector<Format> formats = flat_formats();
  for (const Format& format : space_formats()) formats.push_back(format);
  CountedCheckpoints& counted = counted_checkpoints();
  for (const Format& format : formats) {
    double longest = 0;
    std::string where;
    for (const Format::Mass& mass : format.masses) {
      const std::string file = repeated_to(mass, kBytes);
      Context context;
      counted.begin();
      try {
        format.read(file, {}, context);
      } catch (const Error&) {  // Whether it is refused is tested elsewhere.
      }
      counted.end();
      EXPECT_LE(counted.longest_gap, kSlack * kLongest)
          << format.name << ", '" << mass.unit << "' again and again: " << counted.before << " ... "
          << counted.after;
      if (counted.longest_gap <= longest) continue;
      longest = counted.longest_gap;
      where = mass.before.substr(0, 40) + mass.unit;
    }
    std::printf("%-14s longest gap %.3f s: %s\n", format.name, longest, where.c_str());
  }
}

/// Numbers of results take longer to read than their bytes.
TEST(HostileFiles, LongFractionsHaveCheckpoints) {
  const std::string digits(8'000, '7'), fraction = digits + "/" + digits + "1";
  std::string file = "OFF\n100 0 0\n";
  for (int i = 0; i < 100; ++i) file += fraction + " " + fraction + " " + fraction + "\n";
  CountedCheckpoints& counted = counted_checkpoints();
  const std::uint64_t before = counted.passed;
  Context context;
  counted.begin();
  read_solid_mesh<MeshFormat::Off>(file, {}, context);
  counted.end();
  EXPECT_GE(counted.passed - before, file.size() / 100'000);
}

TEST(HostileFiles, FlatFormats) { expect_bounded(flat_formats()); }
TEST(HostileFiles, SpaceFormats) { expect_bounded(space_formats()); }

}  // namespace
}  // namespace plumb::testing::hostile_files_test

int main(int argc, char** argv) {
  plumb::testing::count_numbers();
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
