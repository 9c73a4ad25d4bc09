// Lines that several threads make are those that one loop writes, in its order.
#include "plumb/io/text/line_writer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "generate/meshes.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh_io.h"

namespace plumb::line_writer_test {
namespace {

Context with_threads(unsigned threads) { return Context({}, {}, {}, threads); }

/// Item i has i % 4 lines.
std::string text_of(std::size_t count, Context& context) {
  std::ostringstream text;
  write_lines(text, count, context, [](TextOutput& out, std::size_t i) {
    for (std::size_t line = 0; line < i % 4; ++line) out << std::uint64_t{i} << '\n';
  });
  return std::move(text).str();
}

TEST(LineWriter, WritesAllItemsInOrder) {
  for (const std::size_t count : {0U, 1U, 4095U, 8192U, 8193U, 100'003U, 300'000U}) {
    std::string expected;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t line = 0; line < i % 4; ++line) expected += std::to_string(i) + '\n';
    }
    for (const unsigned threads : {1U, 2U, 3U, 8U}) {
      Context context = with_threads(threads);
      EXPECT_EQ(text_of(count, context), expected) << count << " items, " << threads << " threads";
    }
  }
}

TEST(LineWriter, PassesOnTheErrorOfAnItem) {
  for (const unsigned threads : {1U, 4U}) {
    Context context = with_threads(threads);
    std::ostringstream text;
    const auto write = [](TextOutput&, std::size_t i) {
      if (i == 20'000) throw std::runtime_error("item");
    };
    EXPECT_THROW(write_lines(text, 30'000, context, write), std::runtime_error);
  }
}

TEST(LineWriter, MeshesHaveTheSameText) {
  PolygonMesh mesh = testing::icosphere_mesh(5, 1, {0.1, 0.2, 0.3});
  ASSERT_GT(mesh.points.size(), 8192U);
  for (const std::uint32_t v : {0U, 5000U, 10'000U}) {  // Coordinates that are not doubles.
    mesh.exact.emplace_back(v, RationalPoint3{Rational(1, 3), Rational(v + 1, 7), Rational(0)});
  }
  for (const MeshFormat format : {MeshFormat::Off, MeshFormat::ExactOff, MeshFormat::Obj}) {
    std::ostringstream expected;
    write_mesh(expected, mesh, format);
    for (const unsigned threads : {2U, 5U}) {
      Context context = with_threads(threads);
      std::ostringstream text;
      write_mesh(text, mesh, format, context);
      EXPECT_EQ(text.str(), expected.str()) << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace plumb::line_writer_test
