// Fields of heights: the text, and the mesh.
//
// The mesh is OpenSCAD's, so that volumes agree: coordinates are sums of halves, and the middle of
// a square is the mean of its corners, added in the order of OpenSCAD.
//
// Tested by tests/io/surface_file_test.cpp; tests/system/openscad_test.py compares with OpenSCAD.
#include "plumb/io/csg/surface_file.h"

#include <algorithm>
#include <array>

#include "plumb/io/csg/height_image.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

// The memory of the rows, and of their copy while they grow.
constexpr std::uint64_t kHeightBytes = 3 * sizeof(double);

/// The rows of a text, which may have different lengths.
struct RaggedRows {
  std::vector<double> numbers;
  std::vector<std::size_t> ends;
  std::size_t columns = 0;
};

double next_height(TextCursor& cursor, NumberReader& numbers) {
  ReadNumber number;
  numbers.read_next(cursor, number);
  return number.is_double() ? number.as_double() : nearest_double(number.exact());
}

RaggedRows read_rows(std::string_view text, const std::string& name, MemoryCharge& charge,
                     Context& context) {
  constexpr std::size_t kStep = 4096;
  TextCursor cursor(text, name);
  NumberReader numbers(context, false, text.size());
  RaggedRows rows;
  while (cursor.next_line()) {
    const std::size_t begin = rows.numbers.size();
    while (!cursor.at_line_end()) {
      if (rows.numbers.size() % kStep == 0) {
        context.checkpoint("read", cursor.bytes_read(), text.size());
        with_place(cursor, [&] { charge.add(kStep * kHeightBytes, "a surface"); });
      }
      rows.numbers.push_back(next_height(cursor, numbers));
    }
    rows.ends.push_back(rows.numbers.size());
    rows.columns = std::max(rows.columns, rows.numbers.size() - begin);
  }
  return rows;
}

HeightGrid read_height_text(std::string_view text, const std::string& name, MemoryCharge& charge,
                            Context& context) {
  const RaggedRows rows = read_rows(text, name, charge, context);
  HeightGrid grid;
  grid.rows = rows.ends.size();
  grid.columns = rows.columns;
  if (grid.columns > 0 && grid.rows > kMostHeights / grid.columns) {
    throw Error(ErrorCode::ResourceLimit, "a surface has at most 2^24 heights", {name, 1, 1});
  }
  require_room_for_solid(grid.rows, grid.columns, context);
  charge.add(grid.rows * grid.columns * sizeof(double), "a surface");
  grid.heights.assign(grid.rows * grid.columns, 0);
  std::size_t begin = 0;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    std::copy(rows.numbers.begin() + static_cast<std::ptrdiff_t>(begin),
              rows.numbers.begin() + static_cast<std::ptrdiff_t>(rows.ends[row]),
              grid.heights.begin() + static_cast<std::ptrdiff_t>(row * grid.columns));
    begin = rows.ends[row];
  }
  return grid;
}

/// Makes the mesh of a grid.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const HeightGrid& grid, bool is_centred, Context& context)
      : grid_(grid),
        origin_{is_centred ? -static_cast<double>(grid.columns - 1) / 2 : 0.0,
                is_centred ? -static_cast<double>(grid.rows - 1) / 2 : 0.0},
        context_(context) {}

  PolygonMesh build() {
    find_bottom();
    add_points();
    for (std::size_t row = 1; row < grid_.rows; ++row) {
      context_.checkpoint("surface", row, grid_.rows);
      for (std::size_t column = 1; column < grid_.columns; ++column) add_square(row, column);
    }
    add_walls();
    return std::move(mesh_);
  }

 private:
  std::uint32_t top(std::size_t row, std::size_t column) const {
    return static_cast<std::uint32_t>(row * grid_.columns + column);
  }

  void find_bottom() {
    for (const double height : grid_.heights) bottom_ = std::min(height - 1, bottom_);
  }

  void add_points() {
    for (std::size_t row = 0; row < grid_.rows; ++row) {
      context_.checkpoint("surface", 0, grid_.rows);
      for (std::size_t column = 0; column < grid_.columns; ++column) {
        mesh_.points.push_back(point(row, column, grid_.at(row, column)));
      }
    }
    // The corners of the border, from the first row up the first column and on.
    for (std::size_t row = 0; row + 1 < grid_.rows; ++row) add_to_border(row, 0);
    for (std::size_t c = 0; c + 1 < grid_.columns; ++c) add_to_border(grid_.rows - 1, c);
    for (std::size_t r = grid_.rows; --r > 0;) add_to_border(r, grid_.columns - 1);
    for (std::size_t c = grid_.columns; --c > 0;) add_to_border(0, c);
  }

  Point3 point(std::size_t row, std::size_t column, double z) const {
    return {origin_[0] + static_cast<double>(column), origin_[1] + static_cast<double>(row), z};
  }

  void add_to_border(std::size_t row, std::size_t column) {
    border_.push_back(top(row, column));
    floor_.push_back(static_cast<std::uint32_t>(mesh_.points.size()));
    mesh_.points.push_back(point(row, column, bottom_));
  }

  /// Adds the four triangles of the square between a corner and the previous corner in both
  /// directions.
  void add_square(std::size_t row, std::size_t column) {
    const std::array corners{top(row - 1, column - 1), top(row - 1, column), top(row, column),
                             top(row, column - 1)};
    const double mean = (grid_.heights[corners[0]] + grid_.heights[corners[1]] +
                         grid_.heights[corners[3]] + grid_.heights[corners[2]]) /
                        4;
    const auto middle = static_cast<std::uint32_t>(mesh_.points.size());
    mesh_.points.push_back({origin_[0] + static_cast<double>(column) - 0.5,
                            origin_[1] + static_cast<double>(row) - 0.5, mean});
    for (std::size_t i = 0; i < 4; ++i) {
      mesh_.add_face(std::array{corners[i], corners[(i + 1) % 4], middle});
    }
  }

  void add_walls() {
    for (std::size_t i = 0; i < border_.size(); ++i) {
      const std::size_t next = (i + 1) % border_.size();
      mesh_.add_face(std::array{border_[i], border_[next], floor_[next], floor_[i]});
    }
    mesh_.add_face(floor_);
  }

  const HeightGrid& grid_;
  std::array<double, 2> origin_;
  Context& context_;
  double bottom_ = 0;
  PolygonMesh mesh_;
  std::vector<std::uint32_t> border_;  // The corners of the field, clockwise when seen from above.
  std::vector<std::uint32_t> floor_;   // The points below these corners.
};

}  // namespace

void require_room_for_solid(std::size_t rows, std::size_t columns, Context& context) {
  // Less than what Nef3::from_mesh() charges for the four triangles of a square.
  constexpr std::uint64_t kSquareBytes = 2000;
  if (rows < 2 || columns < 2) return;
  MemoryCharge probe(context);
  probe.add(kSquareBytes * (rows - 1) * (columns - 1), "the solid of a surface");
}

HeightGrid read_heights(std::string_view bytes, const std::string& name, bool is_inverted,
                        MemoryCharge& charge, Context& context) {
  return is_png(bytes) ? read_height_image(bytes, name, is_inverted, charge, context)
                       : read_height_text(bytes, name, charge, context);
}

PolygonMesh surface_mesh(const HeightGrid& grid, bool is_centred, MemoryCharge& charge,
                         Context& context) {
  if (grid.rows < 2 || grid.columns < 2) return {};
  require_room_for_solid(grid.rows, grid.columns, context);
  constexpr std::uint64_t kBytes = 2 * sizeof(Point3) + 16 * sizeof(std::uint32_t);
  charge.add(2 * kBytes * grid.heights.size(), "a surface");
  return SurfaceBuilder(grid, is_centred, context).build();
}

}  // namespace plumb
