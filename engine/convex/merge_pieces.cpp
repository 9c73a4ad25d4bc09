#include "plumb/convex/merge_pieces.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "plumb/convex/decompose.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {
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

  void gather() {
    is_gone_.assign(s_.faces.size(), 0);
    piece_of_.assign(s_.faces.size(), 0);
    merged_.resize(pieces_.size());
    std::iota(merged_.begin(), merged_.end(), std::size_t{0});
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      for (const FaceId f : pieces_[p]) {
        piece_of_[f.value()] = p;
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
  SpacePoint point_of(HalfedgeId h) const { return s_.point[s_.half(h).origin.value()]; }
  bool is_gone(FaceId f) const { return is_gone_[f.value()] != 0; }

  std::size_t find(std::size_t p) {
    while (p != merged_[p]) p = merged_[p] = merged_[merged_[p]];
    return p;
  }

  /// Pairs the half-edges of both, which run against each other.
  bool match(FaceId low, FaceId high) {
    rim_.clear();
    if (find(piece_of_[low.value()]) == find(piece_of_[high.value()])) return false;
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

  /// With the two faces gone, is every edge between their neighbours convex?
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

  void join(FaceId low, FaceId high) {
    for (const auto& [h, k] : rim_) {
      const HalfedgeId a = s_.half(h).twin, b = s_.half(k).twin;
      s_.half(a).twin = b;
      s_.half(b).twin = a;
      s_.half(a).mark = s_.half(b).mark = s_.half(a).mark | s_.half(b).mark;
      s_.half(a).is_reflex = s_.half(b).is_reflex = false;
    }
    is_gone_[low.value()] = is_gone_[high.value()] = 1;
    const std::size_t p = find(piece_of_[low.value()]), q = find(piece_of_[high.value()]);
    const std::size_t into = std::min(p, q), from = std::max(p, q);
    merged_[from] = into;
    auto& target = pieces_[into];
    if (target.size() < pieces_[from].size()) target.swap(pieces_[from]);
    target.insert(target.end(), pieces_[from].begin(), pieces_[from].end());
    pieces_[from].clear();
    for (const auto& [h, k] : rim_) join_rings(s_.half(h).origin, h);
  }

  /// The ring of half-edges around a corner of the rim: one vertex, which one of the pieces owned.
  void join_rings(VertexId v, HalfedgeId h) {
    const HalfedgeId first = s_.half(s_.half(h).prev).twin;  // leaves v in the low piece
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
  std::vector<std::uint8_t> is_gone_;
  std::vector<std::size_t> piece_of_;
  std::vector<std::size_t> merged_;  // per piece: into which
  std::vector<std::pair<HalfedgeId, HalfedgeId>> rim_;
};

}  // namespace

void merge_pieces(CutSurface& surface, std::vector<std::vector<FaceId>>& pieces, Context& context) {
  Merger(surface, pieces, context).run();
}

}  // namespace plumb
