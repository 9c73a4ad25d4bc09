#include "oracle/pieces_check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "plumb/convex/sum/volume_sum.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"

namespace plumb::testing {
namespace {

std::vector<RationalPoint3> finite_vertices(const SpaceComplex& c) {
  std::vector<RationalPoint3> vertices;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const SpacePoint x = c.vertex_point[v];
    if (c.vertex_mark[v] == kBeyond) continue;
    vertices.push_back(exact(c.points(), x));
  }
  return vertices;
}

/// n.x + d of the facet's canonical plane.
Rational height(const SpaceComplex& c, FacetId f, const RationalPoint3& p) {
  const IntegerRow row = c.planes().coefficients(c.facet_plane[f.value()]);
  return Rational(row[0]) * p.x + Rational(row[1]) * p.y + Rational(row[2]) * p.z +
         Rational(row[3]);
}

/// Of a piece with a volume: every vertex behind every facet.
bool is_supported(const SpaceComplex& c) {
  const std::vector<RationalPoint3> vertices = finite_vertices(c);
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    if (c.facet_mark[f] == kBeyond) continue;
    const auto& [above, below] = c.facet_volume[f];
    const bool is_above = c.volume_mark[above.value()] == 1;
    if (is_above == (c.volume_mark[below.value()] == 1)) return false;
    for (const RationalPoint3& p : vertices) {
      const Rational h = height(c, FacetId(f), p);
      if (is_above ? h < 0 : h > 0) return false;
    }
  }
  return true;
}

std::size_t count_marked(const std::vector<Mark>& marks) {
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), Mark{1}));
}

/// Of one dimension and, without its boundary, convex.
bool is_one_cell(const Nef3& piece) {
  const SpaceComplex& c = piece.complex();
  Context context;
  if (count_marked(c.volume_mark) > 0) {
    if (count_marked(c.volume_mark) > 1 || !piece.interior().is_convex()) return false;
    return piece.is_subset_of(piece.regularization()) && is_supported(c);
  }
  if (count_marked(c.facet_mark) > 0) {
    const SpaceMarks open{std::vector<Mark>(c.vertex_count(), 0),
                          std::vector<Mark>(c.edge_count(), 0), c.facet_mark, c.volume_mark};
    const Nef3 inside = piece.with_marks(open, context);
    return count_marked(c.facet_mark) == 1 && inside.is_convex() &&
           piece.is_subset_of(inside.closure());
  }
  if (count_marked(c.edge_mark) > 0)
    return count_marked(c.edge_mark) == 1 && piece.closure().is_convex();
  return count_marked(c.vertex_mark) == 1;
}

std::string name(const std::string& what, std::size_t piece) {
  return what + ": piece " + std::to_string(piece);
}

/// Do the least boxes along the axes meet? Of unbounded sets always.
class Boxes {
 public:
  explicit Boxes(const std::vector<Nef3>& pieces) {
    for (const Nef3& piece : pieces) {
      ranges_.emplace_back();
      if (!piece.is_bounded()) continue;
      const std::vector<RationalPoint3> vertices = finite_vertices(piece.complex());
      for (const auto axis : {&RationalPoint3::x, &RationalPoint3::y, &RationalPoint3::z}) {
        const auto [low, high] = std::ranges::minmax_element(vertices, {}, axis);
        ranges_.back().push_back({(*low).*axis, (*high).*axis});
      }
    }
  }
  bool meet(std::size_t i, std::size_t j) const {
    for (std::size_t axis = 0; axis < std::min(ranges_[i].size(), ranges_[j].size()); ++axis) {
      const auto& [low, high] = ranges_[i][axis];
      if (high < ranges_[j][axis][0] || ranges_[j][axis][1] < low) return false;
    }
    return true;
  }

 private:
  std::vector<std::vector<std::array<Rational, 2>>> ranges_;
};

std::string overlap(const std::vector<Nef3>& pieces, bool closed) {
  const Boxes boxes(pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes.meet(i, j)) continue;
      const Nef3 common =
          closed ? pieces[i].interior() * pieces[j].interior() : pieces[i] * pieces[j];
      if (!common.is_empty()) return name("overlaps piece " + std::to_string(j), i);
    }
  }
  return "";
}

}  // namespace

std::string flaw_of_pieces(const Nef3& set, const ConvexPieces& result, bool closed) {
  const std::vector<Nef3>& pieces = result.pieces;
  Rational volume = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SpaceComplex& c = pieces[i].complex();
    if (const auto flaw = audit(c, AuditForm::Minimal))
      return name(flaw->invariant + " at " + flaw->place, i);
    if (!is_one_cell(pieces[i])) return name("not one convex cell", i);
    if (set.is_bounded()) volume += *marked_volume(c);
  }
  Context context;
  const std::optional<bool> sum = do_volumes_add_up(set, pieces, context);
  if (set.is_bounded() && volume != *marked_volume(set.complex())) return "volumes do not add up";
  if (set.is_bounded() && sum != true) return "volumes add up, but do_volumes_add_up() says no";
  const Nef3 all = union_of(pieces, context);
  if (!(all == (closed ? set.closure() : set))) return "the union is another set";
  return overlap(pieces, closed);
}

std::size_t bound_of_cuts(std::size_t components, std::size_t r) {
  return components + (r * r + r) / 2;
}

}  // namespace plumb::testing
