// The reader of fields of heights on arbitrary bytes: the matrix of a text, or an image.
//
// Either the reader throws an Error that names the file, a line and a column inside it, or the grid
// of a text has as many rows and columns as splitting its lines at blanks gives. Written as a text
// and read again, the grid is the same. A small field is a solid whose volume is that of the prisms
// below its squares.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "plumb/io/csg/height_image.h"
#include "plumb/io/csg/surface_file.h"
#include "plumb/space/nef3.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace plumb::fuzz {
namespace {

HeightGrid grid_of(std::string_view bytes, bool is_inverted) {
  Limits limits;
  limits.max_memory_bytes = 256U << 20U;
  Context context(limits);
  MemoryCharge charge(context);
  return read_heights(bytes, kFileName, is_inverted, charge, context);
}

/// Counts the rows and columns of a text that has no carriage returns.
void require_size(std::string_view bytes, const HeightGrid& grid) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  std::istringstream text{std::string(bytes)};
  std::size_t rows = 0, columns = 0;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string word;
    std::size_t count = 0;
    while (words >> word && !(count == 0 && word[0] == '#')) ++count;
    rows += count > 0 ? 1 : 0;
    columns = std::max(columns, count);
  }
  require(grid.rows == rows && grid.columns == columns, "a grid has the rows of its text");
}

void require_same_again(const HeightGrid& grid) {
  std::ostringstream text;
  text.precision(17);
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t c = 0; c < grid.columns; ++c) text << grid.at(row, c) << ' ';
    text << '\n';
  }
  const HeightGrid again = grid_of(text.str(), false);
  require(again.rows == grid.rows && again.columns == grid.columns && again.heights == grid.heights,
          "a grid survives its text");
}

void require_volume(const HeightGrid& grid) {
  Context context;
  MemoryCharge charge(context);
  const PolygonMesh mesh = surface_mesh(grid, true, charge, context);
  require((mesh.face_count() == 0) == (grid.rows < 2 || grid.columns < 2), "a field has faces");
  if (mesh.face_count() == 0) return;
  double bottom = 0;
  for (const double height : grid.heights) bottom = std::min(bottom, height - 1);
  Rational volume;
  for (std::size_t row = 1; row < grid.rows; ++row) {
    for (std::size_t c = 1; c < grid.columns; ++c) {
      const double corners[4] = {grid.at(row - 1, c - 1), grid.at(row - 1, c), grid.at(row, c - 1),
                                 grid.at(row, c)};
      const double mean = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
      Rational sum = Rational(mean) * 4;  // Four triangles have the middle, and each two corners.
      for (const double corner : corners) sum += Rational(corner) * 2;
      volume += sum / 12 - Rational(bottom);
    }
  }
  require(Nef3::from_mesh(mesh, {}, context).volume() == volume, "a field has its volume");
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  using namespace plumb::fuzz;
  begin_input();
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const HeightGrid grid = grid_of(bytes, data[0] % 2 != 0);
    oracle_reached();
    if (!is_png(bytes) && bytes.find_first_of("\r\v\f") == bytes.npos) require_size(bytes, grid);
    const bool is_tame = std::all_of(grid.heights.begin(), grid.heights.end(), [](double height) {
      return height == 0 || (std::fabs(height) < 1e100 && std::fabs(height) > 1e-100);
    });
    constexpr std::size_t kMostHeights = 400;
    if (!is_tame || grid.heights.size() > kMostHeights) return 0;
    if (grid.columns > 0) require_same_again(grid);
    require_volume(grid);
  } catch (const Error& error) {
    require_place(error, bytes);
  }
  return 0;
}
