// Lines that several threads make are those that one loop writes, in its order. Texts that wait are
// charged, and a stop ends the work.
#include "plumb/io/text/line_writer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <stop_token>
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

/// Writes `count` lines of 1,000 bytes. Returns the code of the error that ended the work, if any.
std::optional<ErrorCode> code_of_writing(std::size_t count, Context& context) {
  const std::string line(999, 'x');
  std::ostream nowhere(nullptr);
  try {
    write_lines(nowhere, count, context,
                [&](TextOutput& out, std::size_t) { out << line << '\n'; });
  } catch (const Error& error) {
    return error.code();
  }
  return std::nullopt;
}

TEST(LineWriter, ChargesTextsThatWait) {
  constexpr std::uint64_t kMegabyte = 1'000'000;
  // Each of two threads may hold 8 texts of 4 MB, each in a buffer of up to twice its size.
  Context small({.max_memory_bytes = 32 * kMegabyte}, {}, {}, 2);
  EXPECT_EQ(code_of_writing(100'000, small), ErrorCode::ResourceLimit);
  Context large({.max_memory_bytes = 200 * kMegabyte}, {}, {}, 2);
  EXPECT_EQ(code_of_writing(100'000, large), std::nullopt);
  Context alone({.max_memory_bytes = kMegabyte});
  EXPECT_EQ(code_of_writing(100'000, alone), std::nullopt);
  // Nothing stays charged, neither after an error nor after success.
  EXPECT_NO_THROW(small.charge_memory(32 * kMegabyte, "all"));
  EXPECT_NO_THROW(large.charge_memory(200 * kMegabyte, "all"));
}

TEST(LineWriter, AStopEndsTheWork) {
  std::stop_source stop;
  stop.request_stop();
  for (const unsigned threads : {1U, 4U}) {
    Context context({}, stop.get_token(), {}, threads);
    EXPECT_EQ(code_of_writing(30'000, context), ErrorCode::Cancelled);
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
