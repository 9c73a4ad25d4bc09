// Every cell that a set of whole lines cuts the plane into, each with a point in it: the vertices,
// the open edges between them and the open faces, unbounded ones included. By all pairs, in
// integers.
//
// A cell is known by the signs of all lines on it: c lies in the closure of d exactly when every
// sign of c is that of d or zero.
#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "plumb/testing/exact.h"

namespace plumb::testing {

/// { a x + b y + c = 0 }; positive to the left of it. Made in lowest terms.
struct CellLine {
  BigInt a;
  BigInt b;
  BigInt c;
  friend bool operator==(const CellLine&, const CellLine&) = default;
};
bool operator<(const CellLine& s, const CellLine& t);

/// The line p -> q; requires two different points.
CellLine line_through(const ExactPoint& p, const ExactPoint& q);
/// The same line, in lowest terms and whichever way it ran: (b, -a), the way it runs, is
/// lexicographically positive.
CellLine undirected(CellLine line);
CellLine vertical_through(const ExactPoint& p);

/// (x / w, y / w) in lowest terms, w > 0.
struct CellPoint {
  BigInt x;
  BigInt y;
  BigInt w;
};
CellPoint cell_point(const ExactPoint& p);
ExactPoint exact_of(const CellPoint& p);

/// +1: p lies to the left of the line, 0: on it.
int side(const CellLine& line, const CellPoint& p);

class LineCells {
 public:
  static constexpr std::size_t kMaxLines = 192;

  struct Cell {
    int dimension = 0;
    CellPoint sample{};                 ///< a point in the cell
    ExactPoint point{};                 ///< the same
    BigRational area{};                 ///< of a bounded face
    std::optional<std::size_t> line{};  ///< of an edge: which line it lies on
    bool unbounded = false;
    std::vector<std::size_t>
        around{};  ///< cells of higher dimension whose closure contains this one
    std::vector<std::size_t> corners{};  ///< vertices in the closure of this cell
  };

  /// Lines may be given repeatedly and in any direction. Throws std::length_error for more than
  /// kMaxLines different ones.
  explicit LineCells(std::vector<CellLine> lines);

  const std::vector<CellLine>& lines() const { return lines_; }  ///< undirected, each once
  std::size_t size() const { return cells_.size(); }
  const Cell& operator[](std::size_t i) const { return cells_[i]; }

  /// The cell p lies in.
  std::size_t cell_of(const CellPoint& p) const;
  /// The face of the points (-r, -r^2) for all large r.
  std::size_t bottom() const;

 private:
  using Bits = std::bitset<kMaxLines>;
  struct Signs {
    Bits positive;
    Bits negative;
    void set(std::size_t line, int sign);
    bool in_closure_of(const Signs& other) const;
    friend bool operator==(const Signs&, const Signs&) = default;
  };
  struct SignsHash {
    std::size_t operator()(const Signs& s) const {
      return std::hash<Bits>()(s.positive) * 31 + std::hash<Bits>()(s.negative);
    }
  };

  Signs signs_at(const CellPoint& p) const;
  bool add(const Signs& signs, Cell cell);
  void add_vertices();
  void add_edges_of(std::size_t line);
  void add_edge(std::size_t line, CellPoint sample, bool unbounded);
  void add_face_beside(std::size_t edge, int sign);
  CellPoint beside(const Cell& edge, int sign) const;
  void link();
  BigRational area_of(const Cell& face) const;

  std::vector<CellLine> lines_;
  std::vector<Cell> cells_;
  std::vector<Signs> signs_;  ///< of each cell
  std::unordered_map<Signs, std::size_t, SignsHash> index_;
};

}  // namespace plumb::testing
