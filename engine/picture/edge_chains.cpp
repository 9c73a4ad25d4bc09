#include "plumb/picture/edge_chains.h"

#include <cmath>

namespace plumb {
namespace {

class ChainWalker {
 public:
  ChainWalker(const PlaneComplex& complex, std::span<const std::uint8_t> kind, std::uint8_t wanted)
      : complex_(complex), degree_(complex.vertex_count()), is_left_(complex.edge_count()) {
    for (std::size_t e = 0; e < is_left_.size(); ++e) {
      if (kind[e] != wanted) continue;
      is_left_[e] = true;
      ++left_;
      const HalfedgeId h = first_half(EdgeId(e));
      ++degree_[complex.dcel.origin(h).value()];
      ++degree_[complex.dcel.target(h).value()];
    }
  }

  std::size_t left() const { return left_; }
  bool is_left(EdgeId e) const { return is_left_[e.value()]; }
  bool begins_chain(HalfedgeId h) const { return degree_[complex_.dcel.origin(h).value()] != 2; }

  /// Takes the chain that begins with h. (Of a closed one: once around.)
  void append(HalfedgeId h, std::span<const Point2> at, PathData& path) {
    path.move_to(at[complex_.dcel.origin(h).value()]);
    while (h.is_valid()) {
      is_left_[edge_of(h).value()] = false;
      --left_;
      path.line_to(at[complex_.dcel.target(h).value()]);
      h = following(h);
    }
  }

 private:
  HalfedgeId following(HalfedgeId h) const {
    const VertexId v = complex_.dcel.target(h);
    if (degree_[v.value()] != 2) return {};
    for (const HalfedgeId g : complex_.dcel.around(v)) {
      if (!complex_.is_frame(g) && is_left(edge_of(g))) return g;
    }
    return {};
  }

  const PlaneComplex& complex_;
  std::vector<std::uint32_t> degree_;  ///< per vertex: edges of the kind
  std::vector<bool> is_left_;
  std::size_t left_ = 0;
};

}  // namespace

std::size_t append_chains(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                          std::uint8_t wanted, std::span<const Point2> at, std::size_t max_points,
                          PathData& path) {
  ChainWalker walker(complex, kind, wanted);
  for (const bool is_open : {true, false}) {  // first what has ends, then rings
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      for (const HalfedgeId h : {first_half(EdgeId(e)), twin(first_half(EdgeId(e)))}) {
        if (path.points() >= max_points) return walker.left();
        if (!walker.is_left(EdgeId(e)) || (is_open && !walker.begins_chain(h))) continue;
        walker.append(h, at, path);
      }
    }
  }
  return 0;
}

double total_length(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                    std::uint8_t wanted, std::span<const Point2> at) {
  double sum = 0;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (kind[e] != wanted) continue;
    const HalfedgeId h = first_half(EdgeId(e));
    const Point2 a = at[complex.dcel.origin(h).value()], b = at[complex.dcel.target(h).value()];
    sum += std::hypot(a.x - b.x, a.y - b.y);
  }
  return sum;
}

}  // namespace plumb
