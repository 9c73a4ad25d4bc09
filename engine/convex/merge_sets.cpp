#include "plumb/convex/merge_sets.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "plumb/predicates/point3_signs.h"

namespace plumb {
namespace {

class SetMerger {
 public:
  SetMerger(std::vector<Nef3>& pieces, Context& context) : pieces_(pieces), context_(context) {}

  void run() {
    if (pieces_.size() < 2) return;
    for (std::size_t i = 0; i < pieces_.size(); ++i) add_facets(i);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      context_.checkpoint("merging", i, pieces_.size());
      std::size_t at = i;
      while (const std::optional<Match> match = match_of(at)) at = join(at, *match);
    }
    std::erase_if(pieces_, [](const Nef3& piece) { return piece.is_empty(); });
  }

 private:
  using Key = std::uint64_t;
  struct Match {
    std::size_t piece;
    Nef3 both;
  };
  struct Polygon {
    std::vector<std::size_t> pieces;  // whose facet it is, or was
    bool is_refused = false;          // by the pieces on both sides
  };

  static bool is_body(const Nef3& piece) {
    return piece.is_bounded() && piece.counts().marked_volumes == 1;
  }

  /// The sum of the corners' fingerprints.
  static Key key_of(const SpaceComplex& c, FacetId f) {
    Key sum = 0;
    for (const UseId first : c.cycles_of(f)) {
      UseId u = first;
      do {
        const SpacePoint p = c.vertex_point[c.use_origin(u).value()];
        sum += static_cast<Key>(std::hash<Fingerprint>{}(fingerprint(c.points(), p)));
        u = c.use_next[u.value()];
      } while (u != first);
    }
    return sum;
  }

  void add_facets(std::size_t i) {
    if (!is_body(pieces_[i])) return;
    const SpaceComplex& c = pieces_[i].complex();
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
      facets_[key_of(c, FacetId(f))].pieces.push_back(i);
    }
  }

  std::optional<Match> match_of(std::size_t i) {
    if (!is_body(pieces_[i])) return std::nullopt;
    const SpaceComplex& c = pieces_[i].complex();
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
      Polygon& polygon = facets_[key_of(c, FacetId(f))];
      for (const std::size_t j : polygon.pieces) {
        if (polygon.is_refused) break;
        if (j == i || !is_body(pieces_[j])) continue;  // gone, or its facet is
        if (std::optional<Nef3> both = union_of(i, j)) return Match{j, *std::move(both)};
        polygon.is_refused = true;
      }
    }
    return std::nullopt;
  }

  /// If it is convex.
  std::optional<Nef3> union_of(std::size_t i, std::size_t j) {
    const SpaceComplex &c = pieces_[i].complex(), &other = pieces_[j].complex();
    if (count_before(c, other) > 1 || count_before(other, c) > 1) return std::nullopt;
    Nef3 both = combine(pieces_[i], pieces_[j], kUnion, context_);
    if (both.counts().marked_volumes != 1 || !both.interior().is_convex()) return std::nullopt;
    return both;
  }

  /// Facets that have vertices of the other set before them: of neighbours the one between. 0 where tables differ.
  static int count_before(const SpaceComplex& c, const SpaceComplex& other) {
    if (c.tables != other.tables) return 0;
    int count = 0;
    for (std::size_t f = 0; f < c.facet_count() && count < 2; ++f) {
      const bool is_above = c.volume_mark[c.facet_volume[f][0].value()] == 1;
      const Sign before = is_above ? Sign::Negative : Sign::Positive;
      const auto is_before = [&](SpacePoint p) {
        return side(c.points(), p, c.facet_plane[f]) == before;
      };
      count += std::ranges::any_of(other.vertex_point, is_before) ? 1 : 0;
    }
    return count;
  }

  /// Where the union is.
  std::size_t join(std::size_t i, const Match& match) {
    const std::size_t into = std::min(i, match.piece), from = std::max(i, match.piece);
    pieces_[into] = match.both;
    pieces_[from] = Nef3::empty();
    add_facets(into);
    return into;
  }

  std::vector<Nef3>& pieces_;
  Context& context_;
  std::map<Key, Polygon> facets_;
};

}  // namespace

void merge_sets(std::vector<Nef3>& pieces, Context& context) { SetMerger(pieces, context).run(); }

}  // namespace plumb
