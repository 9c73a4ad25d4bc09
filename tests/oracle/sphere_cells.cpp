#include "oracle/sphere_cells.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plumb::testing {
namespace {

CellVector scaled_sum(const BigInt& s, const CellVector& u, const BigInt& t, const CellVector& v) {
  return {s * u[0] + t * v[0], s * u[1] + t * v[1], s * u[2] + t * v[2]};
}

CellVector opposite(const CellVector& v) { return {-v[0], -v[1], -v[2]}; }

CellVector undirected(const CellVector& v) {
  const CellVector r = reduced(v);
  const CellVector zero{0, 0, 0};
  return r < zero ? opposite(r) : r;
}

}  // namespace

BigInt dot(const CellVector& u, const CellVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

CellVector cross(const CellVector& u, const CellVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

CellVector reduced(CellVector v) {
  const BigInt divisor = gcd(gcd(v[0], v[1]), v[2]);
  for (BigInt& x : v) x /= divisor;
  return v;
}

SphereCells::SphereCells(const std::vector<CellVector>& normals) {
  normals_ = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const CellVector& n : normals) normals_.push_back(undirected(n));
  std::sort(normals_.begin(), normals_.end());
  normals_.erase(std::unique(normals_.begin(), normals_.end()), normals_.end());
  if (normals_.size() > kMaxCircles) throw std::length_error("too many circles");
  add_points();
  for (std::size_t i = 0; i < normals_.size(); ++i) add_arcs_of(i);
  const std::size_t count = cells_.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (cells_[i].dimension == 1) add_faces_beside(i);
  }
  link();
}

SphereCells::Signs SphereCells::signs_at(const CellVector& direction) const {
  Signs signs;
  std::uint64_t bit = 1;
  for (const CellVector& n : normals_) {
    const int sign = dot(n, direction).sign();
    if (sign > 0) signs.positive |= bit;
    if (sign < 0) signs.negative |= bit;
    bit <<= 1U;
  }
  return signs;
}

std::size_t SphereCells::cell_of(const CellVector& direction) const {
  return index_.at(signs_at(direction));
}

void SphereCells::add(int dimension, const CellVector& sample, std::size_t circle) {
  const auto [at, is_new] = index_.emplace(signs_at(sample), cells_.size());
  if (!is_new) return;
  cells_.push_back({dimension, reduced(sample), circle, {}});
  signs_.push_back(at->first);
}

void SphereCells::add_points() {
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    for (std::size_t j = i + 1; j < normals_.size(); ++j) {
      const CellVector u = cross(normals_[i], normals_[j]);
      add(0, u, 0);
      add(0, opposite(u), 0);
    }
  }
}

/// Neighbours on the circle are less than half of it apart: their sum lies between them.
void SphereCells::add_arcs_of(std::size_t circle) {
  const CellVector& n = normals_[circle];
  std::vector<CellVector> on;
  for (const Cell& cell : cells_) {
    if (cell.dimension == 0 && dot(n, cell.sample) == 0) on.push_back(cell.sample);
  }
  for (const CellVector& u : on) {
    const CellVector* next = nullptr;
    for (const CellVector& v : on) {
      if (dot(n, cross(u, v)) <= 0) continue;
      if (next == nullptr || dot(n, cross(v, *next)) > 0) next = &v;
    }
    add(1, scaled_sum(1, u, 1, *next), circle);
  }
}

/// So near the arc that no other circle lies between.
void SphereCells::add_faces_beside(std::size_t arc) {
  const CellVector& n = normals_[cells_[arc].circle];
  BigInt widest = 0;
  for (const CellVector& m : normals_) widest = std::max(widest, BigInt(abs(dot(m, n))));
  const CellVector sample = cells_[arc].sample;
  add(2, scaled_sum(widest + 1, sample, 1, n), 0);
  add(2, scaled_sum(widest + 1, sample, -1, n), 0);
}

bool SphereCells::is_in_closure(std::size_t c, std::size_t d) const {
  return (signs_[c].positive & ~signs_[d].positive) == 0 &&
         (signs_[c].negative & ~signs_[d].negative) == 0;
}

void SphereCells::link() {
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (cells_[c].dimension == 2) continue;
    for (std::size_t d = 0; d < cells_.size(); ++d) {
      if (cells_[d].dimension > cells_[c].dimension && is_in_closure(c, d)) {
        cells_[c].around.push_back(d);
      }
    }
  }
}

namespace {

// Cells joined when they belong to one item.
class Merger {
 public:
  Merger(const SphereCells& cells, const CellMarks& marks)
      : cells_(cells), marks_(marks), parent_(cells.size()), dimension_(cells.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  SphereItems run() {
    for (std::size_t c = 0; c < cells_.size(); ++c) dimension_[c] = cells_[c].dimension;
    for (const int dimension : {1, 0}) {
      for (std::size_t c = 0; c < cells_.size(); ++c) {
        if (cells_[c].dimension == dimension) judge(c);
      }
    }
    return number();
  }

 private:
  std::size_t find(std::size_t c) const {
    while (parent_[c] != c) c = parent_[c];
    return c;
  }
  void join(std::size_t c, std::size_t d) { parent_[find(c)] = find(d); }

  /// Is everything around it like it?
  void judge(std::size_t c) {
    std::vector<std::size_t> arcs;  // that are no mere part of a face
    bool is_like_all = true;
    for (const std::size_t d : cells_[c].around) {
      if (marks_[d] != marks_[c]) is_like_all = false;
      if (dimension_[d] == 1) arcs.push_back(d);
    }
    if (is_like_all && arcs.empty()) {
      for (const std::size_t d : cells_[c].around) join(d, c);
      dimension_[c] = 2;
      return;
    }
    if (cells_[c].dimension == 0 && arcs.size() == 2 &&
        cells_[arcs[0]].circle == cells_[arcs[1]].circle && marks_[arcs[0]] == marks_[c] &&
        marks_[arcs[1]] == marks_[c]) {
      join(arcs[0], c);
      join(arcs[1], c);
      dimension_[c] = 1;
    }
  }

  SphereItems number() const {
    SphereItems items;
    std::map<std::size_t, SphereItems::Item> item_of_root;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto dimension = static_cast<std::size_t>(dimension_[c]);
      const auto [at, is_new] = item_of_root.try_emplace(
          find(c), SphereItems::Item{dimension_[c], items.count[dimension]});
      if (is_new) ++items.count[dimension];
      items.item_of.push_back(at->second);
    }
    return items;
  }

  const SphereCells& cells_;
  const CellMarks& marks_;
  std::vector<std::size_t> parent_;
  std::vector<int> dimension_;  // of the item that a cell belongs to
};

}  // namespace

SphereItems minimal_items(const SphereCells& cells, const CellMarks& marks) {
  return Merger(cells, marks).run();
}

}  // namespace plumb::testing
