// Merging of convex neighbours. Two convex pieces with a common wall are one convex piece if no
// edge of the wall's rim is reflex after the wall is removed. The reason: the union is closed,
// connected and locally convex off the rim, and a closed connected set that is locally convex is
// convex (H. Tietze, Mathematische Zeitschrift 28, 1928; docs/design/walls.md, section Cuts,
// "Merging").
//
// Common polygons are found without geometry: a face's key is the sum of the fingerprints of its
// corners, which does not depend on where the cycle begins or which way it runs. Merger, for pieces
// of one surface, verifies a match corner by corner and tests each rim edge by relinking its
// neighbours for a moment. SetMerger handles sets with tables of their own: it makes the union and
// tests it. Tested by tests/convex/convex_pieces_test.cpp.
#include "plumb/convex/part/merge_parts.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "plumb/convex/decompose.h"
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
    std::vector<std::size_t> pieces;  // Pieces whose facet this polygon is or was.
    // Whether it is known that the pieces on both sides cannot be merged.
    bool is_refused = false;
  };

  static bool is_body(const Nef3& piece) {
    return piece.is_bounded() && piece.counts().marked_volumes == 1;
  }

  /// Returns the sum of the corners' fingerprints.
  static Key key_of(const SpaceComplex& c, FacetId f) {
    Key sum = 0;
    for (const UseId first : c.cycles_of(f)) {
      UseId u = first;
      do {
        const SpacePoint p = c.vertex_point[c.use_origin(u)];
        sum += static_cast<Key>(std::hash<Fingerprint>{}(fingerprint(c.points(), p)));
        u = c.use_next[u];
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

  /// Tries the polygons of a piece until the union with the piece on the other side is convex.
  std::optional<Match> match_of(std::size_t i) {
    if (!is_body(pieces_[i])) return std::nullopt;
    const SpaceComplex& c = pieces_[i].complex();
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
      Polygon& polygon = facets_[key_of(c, FacetId(f))];
      for (const std::size_t j : polygon.pieces) {
        if (polygon.is_refused) break;
        // Piece j is piece i itself, or was merged into another piece.
        if (j == i || !is_body(pieces_[j])) continue;
        if (std::optional<Nef3> both = union_of(i, j)) return Match{j, *std::move(both)};
        polygon.is_refused = true;
      }
    }
    return std::nullopt;
  }

  /// Returns the union if it is convex.
  std::optional<Nef3> union_of(std::size_t i, std::size_t j) {
    const SpaceComplex &c = pieces_[i].complex(), &other = pieces_[j].complex();
    if (count_before(c, other) > 1 || count_before(other, c) > 1) return std::nullopt;
    Nef3 both = boolean_op(pieces_[i], pieces_[j], kUnion, context_);
    if (both.counts().marked_volumes != 1 || !both.interior().is_convex()) return std::nullopt;
    return both;
  }

  /// Returns the number of facets that have vertices of the other set before them, counted up to 2.
  /// If the union of two neighbours is convex, only the facet between them is such a facet. Returns
  /// 0 if the tables differ.
  static int count_before(const SpaceComplex& c, const SpaceComplex& other) {
    if (c.tables != other.tables) return 0;
    int count = 0;
    for (std::size_t f = 0; f < c.facet_count() && count < 2; ++f) {
      const bool is_above = c.volume_mark[c.facet_volume[f][0]] == 1;
      const Sign before = is_above ? Sign::Negative : Sign::Positive;
      const auto is_before = [&](SpacePoint p) {
        return side(c.points(), p, c.facet_plane[f]) == before;
      };
      count += std::ranges::any_of(other.vertex_point, is_before) ? 1 : 0;
    }
    return count;
  }

  /// Merges two pieces and returns the index of the union.
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

namespace {

class Merger {
 public:
  Merger(CutSurface& surface, std::vector<std::vector<FaceId>>& pieces, Context& context)
      : s_(surface), pieces_(pieces), context_(context) {}

  void run() {
    gather();
    for (std::size_t i = 0; i < low_.size(); ++i) {
      context_.checkpoint("merging", i, low_.size());
      const auto [begin, end] = high_.equal_range(key_of(low_[i]));
      for (auto at = begin; at != end; ++at) {
        if (is_gone(at->second) || !match(low_[i], at->second)) continue;
        if (is_rim_convex()) join(low_[i], at->second);
        break;
      }
    }
    std::erase_if(pieces_, [](const auto& piece) { return piece.empty(); });
    for (auto& piece : pieces_) std::erase_if(piece, [this](FaceId f) { return is_gone(f); });
  }

 private:
  /// A plane, and the sum of the corners' fingerprints.
  using Key = std::pair<std::uint32_t, std::uint64_t>;

  /// Collects the wall faces of all pieces. Faces with holes are left out: two convex pieces cannot
  /// share one.
  void gather() {
    is_gone_.assign(s_.faces.size(), 0);
    piece_of_.assign(s_.faces.size(), 0);
    merged_.resize(pieces_.size());
    std::iota(merged_.begin(), merged_.end(), std::size_t{0});
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      for (const FaceId f : pieces_[p]) {
        piece_of_[f] = p;
        const CutSurface::Face& face = s_.face(f);
        if (face.origin != kWallOrigin) continue;
        if (s_.half(face.cycle).next_cycle.is_valid()) continue;
        if (face.plane.is_opposite()) {
          high_.emplace(key_of(f), f);
        } else {
          low_.push_back(f);
        }
      }
    }
  }

  Key key_of(FaceId f) const {
    std::uint64_t sum = 0;
    s_.for_each_half(f, [&](HalfedgeId h) {
      const Fingerprint print = fingerprint(s_.points(), point_of(h));
      sum += static_cast<std::uint64_t>(std::hash<Fingerprint>{}(print));
    });
    return {s_.face(f).plane.plane().value(), sum};
  }
  SpacePoint point_of(HalfedgeId h) const { return s_.point[s_.half(h).origin]; }
  bool is_gone(FaceId f) const { return is_gone_[f] != 0; }

  std::size_t find(std::size_t p) {
    while (p != merged_[p]) p = merged_[p] = merged_[merged_[p]];
    return p;
  }

  /// Pairs the half-edges of both faces, which have opposite directions. Returns false if the
  /// polygons differ, or if they already belong to the same piece.
  bool match(FaceId low, FaceId high) {
    rim_.clear();
    if (find(piece_of_[low]) == find(piece_of_[high])) return false;
    const HalfedgeId first = s_.face(low).cycle;
    HalfedgeId k = s_.face(high).cycle;
    const HalfedgeId last = k;
    while (!equal(s_.points(), point_of(first), point_of(s_.half(k).next))) {
      k = s_.half(k).next;
      if (k == last) return false;
    }
    HalfedgeId h = first;
    do {
      if (!equal(s_.points(), point_of(h), point_of(s_.half(k).next))) return false;
      rim_.emplace_back(h, k);
      h = s_.half(h).next;
      k = s_.half(k).prev;
    } while (h != first);
    return true;
  }

  /// Whether all edges between the neighbours of the two faces are convex after the faces are
  /// removed.
  bool is_rim_convex() {
    for (const auto& [h, k] : rim_) {
      const HalfedgeId a = s_.half(h).twin, b = s_.half(k).twin;
      s_.half(a).twin = b;
      const bool is_reflex = s_.is_reflex_at(a);
      s_.half(a).twin = h;
      if (is_reflex) return false;
    }
    return true;
  }

  /// Links the neighbours of both faces across the rim. The shorter list of faces is appended to
  /// the longer one, so all merges together take O(n log n).
  void join(FaceId low, FaceId high) {
    for (const auto& [h, k] : rim_) {
      const HalfedgeId a = s_.half(h).twin, b = s_.half(k).twin;
      s_.half(a).twin = b;
      s_.half(b).twin = a;
      s_.half(a).mark = s_.half(b).mark = s_.half(a).mark | s_.half(b).mark;
      s_.half(a).is_reflex = s_.half(b).is_reflex = false;
    }
    is_gone_[low] = is_gone_[high] = 1;
    const std::size_t p = find(piece_of_[low]), q = find(piece_of_[high]);
    const std::size_t into = std::min(p, q), from = std::max(p, q);
    merged_[from] = into;
    auto& target = pieces_[into];
    if (target.size() < pieces_[from].size()) target.swap(pieces_[from]);
    target.insert(target.end(), pieces_[from].begin(), pieces_[from].end());
    pieces_[from].clear();
    for (const auto& [h, k] : rim_) join_rings(s_.half(h).origin, h);
  }

  /// Makes the ring of half-edges around a corner of the rim leave one vertex. One of the two
  /// pieces owned it, so the marks are joined.
  void join_rings(VertexId v, HalfedgeId h) {
    // This half-edge leaves v in the low piece.
    const HalfedgeId first = s_.half(s_.half(h).prev).twin;
    Mark mark = 0;
    HalfedgeId at = first;
    do {
      mark |= s_.half(at).origin_mark;
      at = s_.half(s_.half(at).prev).twin;
    } while (at != first);
    do {
      s_.half(at).origin = v;
      s_.half(at).origin_mark = mark;
      at = s_.half(s_.half(at).prev).twin;
    } while (at != first);
  }

  CutSurface& s_;
  std::vector<std::vector<FaceId>>& pieces_;
  Context& context_;
  std::vector<FaceId> low_;
  std::multimap<Key, FaceId> high_;
  IdVector<FaceId, std::uint8_t> is_gone_;
  IdVector<FaceId, std::size_t> piece_of_;
  std::vector<std::size_t> merged_;  // The piece into which each piece was merged.
  std::vector<std::pair<HalfedgeId, HalfedgeId>> rim_;
};

}  // namespace

void merge_pieces(CutSurface& surface, std::vector<std::vector<FaceId>>& pieces, Context& context) {
  Merger(surface, pieces, context).run();
}

}  // namespace plumb
