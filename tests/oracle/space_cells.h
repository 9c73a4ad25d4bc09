// Every cell that a set of whole planes cuts space into, each with a point in it: the vertices, the
// open edges between them, the open facets between those and the open volumes, unbounded ones
// included. By all pairs of planes, in integers.
//
//   lines     every pair of planes that is not parallel; cut by all other planes: vertices and
//             edges
//   facets    a step off every edge, within each plane through it; a plane without lines is one
//             facet
//   volumes   a step off every facet; no plane at all: one volume
//
// Each step keeps all signs but those it was meant to change, so a cell is known by the signs of
// all planes on it, and no cell is missed: every facet but a whole plane has an edge, every volume
// a facet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "plumb/testing/exact.h"

namespace plumb::testing {

struct CellVector {
  BigInt x;
  BigInt y;
  BigInt z;
  friend bool operator==(const CellVector&, const CellVector&) = default;
};
CellVector operator*(const BigInt& factor, const CellVector& v);
CellVector cross(const CellVector& u, const CellVector& v);
BigInt dot(const CellVector& u, const CellVector& v);
bool is_zero(const CellVector& v);
/// The sign of the first coordinate other than 0.
int direction_sign(const CellVector& v);
/// Divided by the greatest common divisor. Requires a vector other than 0.
CellVector reduced(const CellVector& v);

/// { n.x + d = 0 }, positive where n points to. In lowest terms.
struct CellPlane {
  CellVector n;
  BigInt d;
  friend bool operator==(const CellPlane&, const CellPlane&) = default;
};
bool operator<(const CellPlane& p, const CellPlane& q);
CellPlane opposite(const CellPlane& plane);
/// a x + b y + c z + d = 0; requires a normal other than 0.
CellPlane plane_of(const BigRational& a, const BigRational& b, const BigRational& c,
                   const BigRational& d);
/// Through p with this normal.
CellPlane plane_at(const ExactPoint3& p, const ExactPoint3& normal);
/// Positive where p, q, r are seen counter-clockwise; requires points that are not collinear.
CellPlane plane_through(const ExactPoint3& p, const ExactPoint3& q, const ExactPoint3& r);
/// The same plane, the first nonzero one of (a, b, c) positive.
CellPlane unoriented(const CellPlane& plane);

/// (x, y, z) / w in lowest terms, w > 0.
struct CellPoint3 {
  CellVector v;
  BigInt w;
};
CellPoint3 cell_point(const ExactPoint3& p);
ExactPoint3 exact_of(const CellPoint3& p);

/// The sign of n.x + d.
int side(const CellPlane& plane, const CellPoint3& p);

/// A line by its direction, in lowest terms, and any point on it x direction. Equal for equal
/// directed lines.
struct CellLine3 {
  CellVector direction;
  ExactPoint3 moment;
  friend bool operator==(const CellLine3&, const CellLine3&) = default;
};
bool operator<(const CellLine3& s, const CellLine3& t);
/// In direction n_p x n_q; requires planes that are not parallel.
CellLine3 line_of(const CellPlane& p, const CellPlane& q);
/// The same line, its direction lexicographically positive.
CellLine3 undirected(const CellLine3& line);

class SpaceCells {
 public:
  static constexpr std::size_t kMaxPlanes = 64;

  /// One bit for each plane.
  struct Signs {
    std::uint64_t positive = 0;
    std::uint64_t negative = 0;
    void set(std::size_t plane, int sign);
    int operator[](std::size_t plane) const;
    friend bool operator==(const Signs&, const Signs&) = default;
  };

  struct Cell {
    int dimension = 0;
    Signs signs{};
    CellPoint3 sample{};  ///< a point in the cell
    ExactPoint3 point{};  ///< the same
    bool unbounded = false;
    std::vector<std::size_t> faces{};  ///< cells of one dimension less in its closure
    std::vector<std::size_t>
        around{};  ///< cells of higher dimension whose closure contains this one
    std::vector<std::size_t> corners{};  ///< vertices in its closure
  };

  /// Planes may be given repeatedly and in any orientation. Throws std::length_error for more than
  /// kMaxPlanes different ones.
  explicit SpaceCells(std::vector<CellPlane> planes);

  const std::vector<CellPlane>& planes() const { return planes_; }  ///< unoriented, each once
  std::size_t size() const { return cells_.size(); }
  const Cell& operator[](std::size_t i) const { return cells_[i]; }

  /// The planes through a cell, one bit each.
  std::uint64_t planes_through(std::size_t cell) const {
    return all_planes() & ~(cells_[cell].signs.positive | cells_[cell].signs.negative);
  }
  /// The cell p lies in.
  std::size_t cell_of(const CellPoint3& p) const;
  std::size_t cell_of(const ExactPoint3& p) const { return cell_of(cell_point(p)); }
  /// The volume of a bounded cell of dimension 3.
  BigRational volume_of(std::size_t cell) const;

 private:
  struct SignsHash {
    std::size_t operator()(const Signs& s) const {
      return s.positive * 0x9e3779b97f4a7c15U ^ (s.negative * 0xc2b2ae3d27d4eb4fU >> 7U);
    }
  };

  std::uint64_t all_planes() const {
    return planes_.size() == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << planes_.size()) - 1;
  }
  Signs signs_at(const CellPoint3& p) const;
  std::size_t find_or_add(int dimension, const Signs& signs, CellPoint3 sample);
  void add_cells_of_line(std::size_t i, std::size_t j);
  void add_edge(CellPoint3 sample, bool unbounded, std::vector<std::size_t> ends);
  void add_facets_at(std::size_t edge);
  void add_facet_of_plane(std::size_t plane);
  void add_volumes_at(std::size_t facet);
  void add_beside(std::size_t cell, int dimension, const Signs& signs, const CellVector& direction);
  CellPoint3 beside(const CellPoint3& p, const CellVector& direction) const;
  void link();

  std::vector<CellPlane> planes_;
  std::vector<Cell> cells_;
  std::unordered_map<Signs, std::size_t, SignsHash> index_;
};

}  // namespace plumb::testing
