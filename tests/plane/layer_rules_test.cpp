// Which feature gets an overlap or a gap: the rules, ranks and preferences, on random rectangles
// against a second computation that counts squares of a grid.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "plumb/plane/layer.h"
#include "plumb/predicates/error.h"
#include "random_layers.h"

namespace plumb::layer_test {
namespace {

using Square = std::pair<int, int>;

/// Owners of the regions of a grid, by counting.
class CountedOwners {
 public:
  CountedOwners(const GridCells& cells, const Layer& layer, const LayerRepairOptions& options)
      : cells_(cells), options_(options), area_(layer.feature_count(), 0) {
    for_each_square([&](Square s) {
      const Features& cover = cells_.cover(s.first, s.second);
      for (const std::uint32_t f : cover) ++area_[f];
      if (cover.size() == 1) owner_[region(s)] = cover.front();
      if (cover.size() == 1) is_alone_[cover.front()] = true;
    });
    own_overlaps();
    own_gaps();
  }

  /// Returns the owner of a square, or no entry.
  Features at(int x, int y) const {
    const auto found = owner_.find(region({x, y}));
    return found == owner_.end() ? Features() : Features{found->second};
  }

 private:
  int region(Square s) const { return cells_.region(s.first, s.second); }
  template <class Visit>
  static void for_each_square(const Visit& visit) {
    for (int y = 0; y < GridCells::kSide; ++y) {
      for (int x = 0; x < GridCells::kSide; ++x) visit(Square(x, y));
    }
  }

  /// Returns for each region the lengths of its borders with the owners that are known.
  std::map<int, std::map<std::uint32_t, int>> borders() const {
    std::map<int, std::map<std::uint32_t, int>> lengths;
    for_each_square([&](Square s) {
      for (const Square& step : {Square(1, 0), Square(-1, 0), Square(0, 1), Square(0, -1)}) {
        const Square t(s.first + step.first, s.second + step.second);
        if (std::min(t.first, t.second) < 0) continue;
        if (std::max(t.first, t.second) >= GridCells::kSide || region(s) == region(t)) continue;
        const Features beside = at(t.first, t.second);
        if (!beside.empty()) ++lengths[region(s)][beside.front()];
      }
    });
    return lengths;
  }

  std::uint32_t select(Features candidates, const std::map<std::uint32_t, int>& border) const {
    Features kept;
    for (const std::uint32_t f : candidates) {
      const bool loses = std::any_of(
          options_.preferences.begin(), options_.preferences.end(), [&](const OwnerPreference& p) {
            return p.loser == f && std::count(candidates.begin(), candidates.end(), p.winner) > 0;
          });
      if (!loses) kept.push_back(f);
    }
    if (kept.empty()) kept = candidates;
    const auto worth = [&](std::uint32_t f) {
      if (options_.rule == OwnerRule::Largest) return area_[f];
      if (options_.rule == OwnerRule::Smallest) return -area_[f];
      if (options_.rule == OwnerRule::LongestBorder) return border.count(f) ? border.at(f) : 0;
      return options_.rank.empty() ? 0 : -static_cast<int>(options_.rank[f]);
    };
    return *std::max_element(kept.begin(), kept.end(), [&](std::uint32_t f, std::uint32_t g) {
      return worth(f) != worth(g) ? worth(f) < worth(g) : f > g;
    });
  }

  void own_overlaps() {
    auto borders_of = borders();
    std::map<int, std::uint32_t> owners;
    for_each_square([&](Square s) {
      const Features& cover = cells_.cover(s.first, s.second);
      if (cover.size() < 2) return;
      const auto lost = std::find_if(cover.begin(), cover.end(),
                                     [&](std::uint32_t f) { return is_alone_.count(f) == 0; });
      owners[region(s)] = lost != cover.end() ? *lost : select(cover, borders_of[region(s)]);
    });
    owner_.insert(owners.begin(), owners.end());
  }

  void own_gaps() {
    std::map<int, std::uint32_t> owners;
    auto borders_of = borders();
    for_each_square([&](Square s) {
      const bool is_gap =
          cells_.cover(s.first, s.second).empty() && !cells_.is_outside(s.first, s.second);
      if (!is_gap) return;
      Features candidates;
      for (const auto& [f, length] : borders_of[region(s)]) candidates.push_back(f);
      owners[region(s)] = select(candidates, borders_of[region(s)]);
    });
    owner_.insert(owners.begin(), owners.end());
  }

  const GridCells& cells_;
  const LayerRepairOptions& options_;
  std::vector<int> area_;
  std::map<std::uint32_t, bool> is_alone_;
  std::map<int, std::uint32_t> owner_;
};

/// Options with a rule, a random order, and random preferences.
LayerRepairOptions random_options(Dice& dice, OwnerRule rule, std::size_t features) {
  LayerRepairOptions options{rule, 100.0, false};
  if (dice.below(2) == 0) {
    options.rank.resize(features);
    std::iota(options.rank.begin(), options.rank.end(), 0U);
    for (std::size_t i = features; i > 1; --i) {
      std::swap(options.rank[i - 1], options.rank[dice.below(i)]);
    }
  }
  for (std::uint64_t i = dice.below(4); features > 1 && i > 0; --i) {
    const auto winner = static_cast<std::uint32_t>(dice.below(features));
    const auto loser =
        static_cast<std::uint32_t>((winner + 1 + dice.below(features - 1)) % features);
    options.preferences.push_back({winner, loser});
  }
  return options;
}

TEST(LayerRules, owners_are_those_that_counting_says) {
  constexpr std::array kRules{OwnerRule::LongestBorder, OwnerRule::Largest, OwnerRule::Smallest,
                              OwnerRule::First};
  std::map<OwnerRule, int> decided;  // Squares of regions with a choice.
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer layer = random_rectangles(dice);
    const OwnerRule rule = kRules[seed % kRules.size()];
    const LayerRepairOptions options = random_options(dice, rule, layer.feature_count());
    const GridCells cells(layer);
    const CountedOwners expected(cells, layer, options);
    const Layer repaired = repair_layer(layer, options).layer;
    for (int y = 0; y < GridCells::kSide; ++y) {
      for (int x = 0; x < GridCells::kSide; ++x) {
        ASSERT_EQ(features_at(repaired, GridCells::centre(x, y)), expected.at(x, y))
            << x << ' ' << y;
        if (cells.cover(x, y).size() != 1 && !expected.at(x, y).empty()) ++decided[rule];
      }
    }
  }
  for (const OwnerRule rule : kRules) EXPECT_GT(decided[rule], 500);
}

TEST(LayerRules, preferences_come_before_the_rule) {
  const Layer layer = layer_of({box(0, 0, 10, 2), box(8, 0, 12, 9)});
  LayerRepairOptions options{OwnerRule::Largest};
  EXPECT_EQ(repair_layer(layer, options).report.regions[0].owner, 1U);
  options.preferences = {{0, 1}};
  EXPECT_EQ(repair_layer(layer, options).report.regions[0].owner, 0U);
  options.preferences = {{0, 1}, {1, 0}};
  EXPECT_EQ(repair_layer(layer, options).report.regions[0].owner, 1U) << "both lose: the rule";
}

TEST(LayerRules, refuses_ranks_and_preferences_of_other_features) {
  const Layer layer = layer_of({box(0, 0, 1, 1), box(1, 0, 2, 1)});
  for (const LayerRepairOptions& options :
       {LayerRepairOptions{.rank = {0}}, LayerRepairOptions{.preferences = {{0, 2}}},
        LayerRepairOptions{.preferences = {{1, 1}}}}) {
    EXPECT_THROW(repair_layer(layer, options), Error);
    EXPECT_THROW(check_layer(layer, options), Error);
  }
}

}  // namespace
}  // namespace plumb::layer_test
