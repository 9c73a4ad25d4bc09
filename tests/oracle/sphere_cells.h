// Every cell that great circles cut the sphere into, each with a direction in it: points, open arcs
// and open faces. By all pairs, in integers: a cell is a cone of homogeneous linear inequalities.
//
// The three coordinate circles are always among the circles. So no cell is longer or wider than a
// quarter, and a cell is known by the signs of all normals on it: c lies in the closure of d
// exactly when every sign of c is that of d or zero.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "oracle/cell_marks.h"
#include "plumb/testing/exact.h"

namespace plumb::testing {

using CellVector = std::array<BigInt, 3>;

BigInt dot(const CellVector& u, const CellVector& v);
CellVector cross(const CellVector& u, const CellVector& v);
/// In lowest terms. Requires other than zero.
CellVector reduced(CellVector v);

class SphereCells {
 public:
  struct Cell {
    int dimension = 0;
    CellVector sample{};                ///< a direction in the cell
    std::size_t circle = 0;             ///< of an arc: which circle it lies on
    std::vector<std::size_t> around{};  ///< cells of higher dimension whose closure holds this one
  };

  static constexpr std::size_t kMaxCircles = 64;

  /// Throws std::length_error for more than kMaxCircles. The circles orthogonal to these normals,
  /// given repeatedly and in any direction.
  explicit SphereCells(const std::vector<CellVector>& normals);

  const std::vector<CellVector>& normals() const { return normals_; }
  std::size_t size() const { return cells_.size(); }
  const Cell& operator[](std::size_t i) const { return cells_[i]; }
  /// The cell that a direction lies in.
  std::size_t cell_of(const CellVector& direction) const;

 private:
  /// One bit for each circle.
  struct Signs {
    std::uint64_t positive = 0;
    std::uint64_t negative = 0;
    friend auto operator<=>(const Signs&, const Signs&) = default;
  };

  Signs signs_at(const CellVector& direction) const;
  void add(int dimension, const CellVector& sample, std::size_t circle);
  bool is_in_closure(std::size_t c, std::size_t d) const;
  void add_points();
  void add_arcs_of(std::size_t circle);
  void add_faces_beside(std::size_t arc);
  void link();

  std::vector<CellVector> normals_;
  std::vector<Cell> cells_;
  std::vector<Signs> signs_;  ///< of each cell
  std::map<Signs, std::size_t> index_;
};

/// The items of the minimal form: what the cells merge into.
struct SphereItems {
  struct Item {
    int dimension;
    std::size_t index;
    friend auto operator<=>(const Item&, const Item&) = default;
  };
  std::vector<Item> item_of;           ///< per cell
  std::array<std::size_t, 3> count{};  ///< points, arcs (loops too), faces
};
SphereItems minimal_items(const SphereCells& cells, const CellMarks& marks);

}  // namespace plumb::testing
