#include "plumb/convex/plane_optimal.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/convex/corner_sight.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr std::uint32_t kNever = 1U << 30U;  // a cost; two of them do not overflow

/// A chain from i to j.
struct Chain {
  std::uint32_t first;   ///< its first corner after i
  std::uint32_t last;    ///< its last one before j
  std::uint32_t before;  ///< the chain from i to `last`; kNone: a link, or links in a row
};

class Dissection {
 public:
  Dissection(PlaneRegion& region, Context& context)
      : r_(region),
        context_(context),
        memory_(context),
        corners_(corners_of(region)),
        n_(static_cast<std::uint32_t>(corners_.size())),
        seen_(lesser_corners_seen(region, context)) {
    memory_.add(std::uint64_t{n_} * n_ * sizeof(Cell), "optimal convex partition");
    cells_.resize(std::size_t{n_} * n_);
  }

  void run() {
    for (std::uint32_t k = 1; k < n_; ++k) {
      for (const std::uint32_t j : seen_[k]) {
        if (j + 1 == k) cell(j, k).link = cell(j, k).row = 0;
      }
    }
    for (std::uint32_t length = 2; length < n_; ++length) {
      for (std::uint32_t i = 0; i + length < n_; ++i) chains_between(i, i + length);
      context_.checkpoint("convex partition", length, n_);
    }
    cut();
  }

 private:
  /// What is known of corners i < j.
  struct Cell {
    std::uint32_t cost = kNever;       ///< of the best chains
    std::uint32_t begin = 0, end = 0;  ///< those of them that are kept, in chains_
    std::uint32_t link = kNever;       ///< cost of the link
    std::uint32_t row = kNever;        ///< of the link, or of links in a row
    std::uint32_t row_last = kNone;    ///< in a row: the last corner before j
  };

  Cell& cell(std::uint32_t i, std::uint32_t j) { return cells_[std::size_t{i} * n_ + j]; }
  std::uint32_t point(std::uint32_t corner) const { return r_.point(r_.start(corners_[corner])); }
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return orient2d(r_.points.inputs, point(i), point(j), point(k));
  }
  /// Of three in a row.
  bool is_between(std::uint32_t j, std::uint32_t i, std::uint32_t k) const {
    const PointTable2& p = r_.points.inputs;
    return compare_xy(p, point(i), point(j)) == compare_xy(p, point(j), point(k));
  }

  void chains_between(std::uint32_t i, std::uint32_t k) {
    Cell& at = cell(i, k);
    found_.clear();
    const std::vector<std::uint32_t>& lesser = seen_[k];
    const auto first = std::ranges::upper_bound(lesser, i);
    for (auto j = first; j != lesser.end(); ++j) extend(i, *j, k, at);
    at.begin = static_cast<std::uint32_t>(chains_.size());
    chains_.insert(chains_.end(), found_.begin(), found_.end());
    at.end = static_cast<std::uint32_t>(chains_.size());
    const bool is_link = first != lesser.begin() && *(first - 1) == i;
    if (!is_link || (i == 0 && k + 1 == n_)) return;
    PLUMB_CHECK(at.cost < kNever);
    at.link = at.row = at.cost + 1;
    at.row_last = kNone;
  }

  /// Chains from i to j, and on to k.
  void extend(std::uint32_t i, std::uint32_t j, std::uint32_t k, Cell& at) {
    const Cell &way = cell(i, j), &link = cell(j, k);
    if (link.link >= kNever) return;
    const Sign side = turn(i, j, k);
    if (side == Sign::Negative) return;
    if (side == Sign::Zero) {
      if (is_between(j, i, k)) {
        if (way.row + link.link >= at.row) return;
        at.row = way.row + link.link;
        at.row_last = j;
      } else if (is_between(k, i, j) && way.begin < way.end) {
        offer(at, way.cost + link.link, {chains_[way.end - 1].first, j, way.end - 1});
      }
      return;
    }
    const std::uint32_t before = steepest(way, j, k);
    if (before != kNone && turn(i, chains_[before].first, k) != Sign::Negative) {
      offer(at, way.cost + link.link, {chains_[before].first, j, before});
    } else if (way.row < kNever) {
      offer(at, way.row + link.link, {j, j, kNone});
    }
  }
  /// The last chain to j that may go on to k. They turn less and less there.
  std::uint32_t steepest(const Cell& way, std::uint32_t j, std::uint32_t k) const {
    const auto begin = chains_.begin() + way.begin, end = chains_.begin() + way.end;
    const auto stop = std::partition_point(
        begin, end, [&](const Chain& c) { return turn(c.last, j, k) != Sign::Negative; });
    return stop == begin ? kNone : static_cast<std::uint32_t>(stop - chains_.begin() - 1);
  }

  void offer(Cell& at, std::uint32_t cost, const Chain& chain) {
    if (cost > at.cost) return;
    if (cost < at.cost) found_.clear();
    at.cost = cost;
    if (found_.empty() || chain.first > found_.back().first) found_.push_back(chain);
  }

  // ---------------------------------------------------------------- back

  void cut() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces{{0, n_ - 1}};
    PLUMB_CHECK(cell(0, n_ - 1).cost < kNever);
    while (!pieces.empty()) {
      const auto [i, end] = pieces.back();
      pieces.pop_back();
      std::uint32_t k = end;
      const auto go_back_to = [&](std::uint32_t j) {
        if (k - j > 1) {
          add_diagonal(j, k);
          pieces.emplace_back(j, k);
        }
        k = j;
      };
      for (std::uint32_t c = cell(i, k).begin; c != kNone; c = chains_[c].before) {
        go_back_to(chains_[c].last);
      }
      while (cell(i, k).row_last != kNone) go_back_to(cell(i, k).row_last);
      go_back_to(i);
    }
  }

  void add_diagonal(std::uint32_t i, std::uint32_t k) {
    const Heading along = r_.from_to(r_.start(corners_[i]), r_.start(corners_[k]));
    const HalfedgeId from = corner_towards(i, along), to = corner_towards(k, along.reversed());
    r_.add_edge(from, to, along);
  }
  /// A corner is by now parted by diagonals.
  HalfedgeId corner_towards(std::uint32_t corner, Heading x) const {
    HalfedgeId h = corners_[corner];
    while (!r_.leads_into(h, x)) h = twin(r_.before(h));
    return h;
  }

  PlaneRegion& r_;
  Context& context_;
  MemoryCharge memory_;
  std::vector<HalfedgeId> corners_;
  std::uint32_t n_;
  std::vector<std::vector<std::uint32_t>> seen_;
  std::vector<Cell> cells_;
  std::vector<Chain> chains_;
  std::vector<Chain> found_;
};

}  // namespace

void cut_optimally(PlaneRegion& region, Context& context) { Dissection(region, context).run(); }

}  // namespace plumb
