// Fields of heights. Heights of images are compared with those that OpenSCAD 2021.01 has for the
// same files, which it writes with six digits; volumes with prisms below triangles.
#include "plumb/io/csg/surface_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/io/csg/height_image.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"

namespace plumb::surface_file_test {
namespace {

std::string bytes_of(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

HeightGrid grid_of(const std::string& bytes, bool is_inverted = false) {
  Context context;
  MemoryCharge charge(context);
  return read_heights(bytes, "field", is_inverted, charge, context);
}

Nef3 solid_of(const HeightGrid& grid, bool is_centred = false) {
  Context context;
  MemoryCharge charge(context);
  return Nef3::from_mesh(surface_mesh(grid, is_centred, charge, context));
}

TEST(SurfaceFile, RowsMayHaveDifferentLengths) {
  const HeightGrid grid = grid_of("# c\n1 2\t3\r\n\n4 -5.5\n  1e1\n");
  EXPECT_EQ(grid.rows, 3U);
  EXPECT_EQ(grid.columns, 3U);
  EXPECT_EQ(grid.heights, (std::vector<double>{1, 2, 3, 4, -5.5, 0, 10, 0, 0}));
  EXPECT_EQ(grid_of("").rows, 0U);
}

TEST(SurfaceFile, TheVolumeIsThatOfThePrismsBelowTheTriangles) {
  const HeightGrid grid = grid_of("1 2 3\n4 -5 6\n7 8 0\n");
  // A triangle of a square has the area 1/4, and its prism the mean of its heights above -6.
  Rational volume;
  for (std::size_t row = 1; row < grid.rows; ++row) {
    for (std::size_t column = 1; column < grid.columns; ++column) {
      const Rational a(grid.at(row - 1, column - 1)), b(grid.at(row - 1, column)),
          c(grid.at(row, column)), d(grid.at(row, column - 1));
      volume += (a + b + c + d) / 4 + 6;
    }
  }
  const Nef3 solid = solid_of(grid);
  EXPECT_EQ(solid.volume(), volume);
  EXPECT_TRUE(solid.contains(Point3{1, 1, -5}) && !solid.contains(Point3{1, 1, -4.999}));
  EXPECT_TRUE(solid.contains(Point3{0, 2, 7}) && solid.contains(Point3{0.5, 0.5, 0.5}));
  EXPECT_TRUE(solid_of(grid, true).contains(Point3{-1, 1, 7}));
  EXPECT_EQ(solid_of(grid, true).volume(), volume);
}

TEST(SurfaceFile, TheBottomIsNotAbove0) {
  EXPECT_EQ(solid_of(grid_of("3 3\n3 3\n")).volume(), Rational(3));
  EXPECT_EQ(solid_of(grid_of("0.5 0.5\n0.5 0.5\n")).volume(), Rational(1));
}

TEST(SurfaceFile, OneRowHasNoFaces) {
  Context context;
  MemoryCharge charge(context);
  for (const char* text : {"1 2 3\n", "1\n2\n", "", "4"}) {
    EXPECT_EQ(surface_mesh(grid_of(text), true, charge, context).face_count(), 0U) << text;
  }
}

TEST(SurfaceFile, ErrorsHaveTheirPlace) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(grid_of(text));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("1 2\n1 2 x\n").find("field:2:5: expected a number"), 0U);
  EXPECT_EQ(refusal("1 nan\n").find("field:1:3: "), 0U);
  EXPECT_EQ(refusal("1 1e999\n").find("field:1:3: "), 0U);
  EXPECT_EQ(refusal("\x89PNG\r\n\x1a\nxyz").find("field:1:1: "), 0U);
  std::string long_and_high;  // 2^13 rows, of which the first has 2^13 columns.
  for (int i = 0; i < 1 << 13; ++i) long_and_high += "1 ";
  for (int i = 0; i < 1 << 13; ++i) long_and_high += "\n1";
  EXPECT_EQ(refusal(long_and_high).find("field:1:1: a surface has at most 2^24 heights"), 0U);
}

TEST(SurfaceFile, MemoryIsLimited) {
  Limits limits;
  limits.max_memory_bytes = 100'000;
  Context context(limits);
  MemoryCharge charge(context);
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "1 2\n";
  EXPECT_THROW(static_cast<void>(read_heights(text, "field", false, charge, context)), Error);
}

/// A large grid is refused before it is built, and only if its solid would be refused, too.
TEST(SurfaceFile, GridsWhoseSolidsDoNotFitAreRefusedAtOnce) {
  constexpr std::size_t kSide = 100;
  std::string text;
  for (std::size_t i = 0; i < kSide * kSide; ++i) text += i % kSide == 0 ? "\n1" : " 2";
  const auto refusal = [&](std::uint64_t bytes, auto&& make) -> std::string {
    Limits limits;
    limits.max_memory_bytes = bytes;
    Context context(limits);
    try {
      MemoryCharge charge(context);
      make(charge, context);
    } catch (const Error& error) {
      return error.message();
    }
    return "";
  };
  const HeightGrid grid = grid_of(text);
  const std::string read = refusal(15'000'000, [&](MemoryCharge& charge, Context& context) {
    (void)read_heights(text, "field", false, charge, context);
  });
  EXPECT_EQ(read.find("the solid of a surface needs "), 0U) << read;
  const std::string built = refusal(15'000'000, [&](MemoryCharge& charge, Context& context) {
    (void)surface_mesh(grid, false, charge, context);
  });
  EXPECT_EQ(built.find("the solid of a surface needs "), 0U) << built;
  const PolygonMesh mesh = [&] {
    Context context;
    MemoryCharge charge(context);
    return surface_mesh(grid, false, charge, context);
  }();
  // The estimate is below what the set charges, so nothing is refused that would fit.
  const std::string set = refusal(20'000'000, [&](MemoryCharge&, Context& context) {
    (void)Nef3::from_mesh(mesh, {}, context);
  });
  EXPECT_NE(set, "");
  EXPECT_EQ(refusal(20'000'000,
                    [&](MemoryCharge& charge, Context& context) {
                      (void)read_heights(text, "field", false, charge, context);
                    }),
            "");
}

/// An image of three columns and two rows, and its heights in OpenSCAD, the lower row first.
struct Image {
  std::string hex;
  std::vector<double> heights;
  double first_inverted;
};

TEST(SurfaceFile, ImagesHaveTheHeightsOfOpenScad) {
  const std::vector<Image> images{
      // Colours of 8 bits.
      {"89504e470d0a1a0a0000000d49484452000000030000000208020000001216f14d00000018494441"
       "54789c63f8cfc0c000c15c227227528cfeffff0f003c190795efc2c6d80000000049454e44ae4260"
       "82",
       {7.29255, 46.1373, 100, 21.26, 71.52, 7.22},
       -6.90039},
      // Grey of 16 bits.
      {"89504e470d0a1a0a0000000d4948445200000003000000021000000000e88fe58500000016494441"
       "54789c636060f8ff7f8e03032323f38b520300205e046d76f235050000000049454e44ae426082",
       {0.392157, 1.17647, 45.8824, 0, 100, 61.1765},
       0},
      // A palette with opacity.
      {"89504e470d0a1a0a0000000d4948445200000003000000020803000000aaaa962800000009504c54"
       "45ff0000008000070809cf8071300000000374524e530080ffecf7b3180000001049444154789c63"
       "606064626062640000002000071d2b70a00000000049454e44ae426082",
       {3.0822, 35.9002, 21.26, 21.26, 35.9002, 3.0822},
       -2.69004},
      // Grey with opacity.
      {"89504e470d0a1a0a0000000d4948445200000003000000020804000000377dae9100000016494441"
       "54789c63e062106990fbcfa0c16cc462c30a0011c2025e6c4ecef80000000049454e44ae426082",
       {15.6863, 19.6078, 23.5294, 3.92157, 7.84314, 11.7647},
       -15.2941},
  };
  for (const Image& image : images) {
    const std::string bytes = bytes_of(image.hex);
    SCOPED_TRACE(image.hex);
    std::optional<HeightGrid> grid;
    try {
      grid = grid_of(bytes);
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::UnknownFormat) << error.what();
      GTEST_SKIP() << "built without libpng";
    }
    ASSERT_EQ(grid->heights.size(), 6U);
    EXPECT_EQ(grid->rows, 2U);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(grid->heights[i], image.heights[i], 1e-4) << i;
    EXPECT_NEAR(grid_of(bytes, true).heights[0], image.first_inverted, 1e-4);
    EXPECT_THROW(static_cast<void>(grid_of(bytes.substr(0, bytes.size() - 20))), Error);
  }
}

}  // namespace
}  // namespace plumb::surface_file_test
