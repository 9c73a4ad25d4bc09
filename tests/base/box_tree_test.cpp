// Every query of a box tree against a loop over all boxes.
#include "plumb/base/internal/box_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace plumb::box_tree_test {
namespace {

using Random = std::mt19937_64;

double uniform(Random& r, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(r);
}

Box3 small_box(Random& r, double space, double size) {
  Box3 b;
  for (std::size_t i = 0; i < 3; ++i) {
    b.low[i] = uniform(r, -space, space);
    b.high[i] = b.low[i] + uniform(r, 0, size);
  }
  return b;
}
Box3 on_grid(Random& r) {
  Box3 b;
  for (std::size_t i = 0; i < 3; ++i) {
    b.low[i] = std::floor(uniform(r, -4, 4));
    b.high[i] = b.low[i] + std::floor(uniform(r, 0, 3));
  }
  return b;
}
Box3 unbounded(Random& r) {
  Box3 b = small_box(r, 1, 0.3);
  for (std::size_t i = 0; i < 3; ++i) {
    if (r() % 4 == 0) b.low[i] = -Box3::kInfinity;
    if (r() % 4 == 0) b.high[i] = Box3::kInfinity;
  }
  return b;
}
/// Clusters of one place at any scale.
Box3 clustered(Random& r) {
  Box3 b = small_box(r, 1, 0.1);
  const double scale = std::pow(10.0, -static_cast<double>(r() % 5) * 60);
  for (std::size_t i = 0; i < 3; ++i) {
    b.low[i] = 1 * (scale < 0.5 ? 0 : 1) + b.low[i] * scale;
    b.high[i] = 1 * (scale < 0.5 ? 0 : 1) + b.high[i] * scale;
  }
  return b;
}

struct Family {
  const char* name;
  Box3 (*make)(Random&);
};
const Family kFamilies[] = {
    {"small", [](Random& r) { return small_box(r, 1, 0.2); }},
    {"large", [](Random& r) { return small_box(r, 1, 2); }},
    {"far away", [](Random& r) { return small_box(r, 1e300, 1e299); }},
    {"subnormal", [](Random& r) { return small_box(r, 1e-310, 1e-311); }},
    {"all of the range", [](Random& r) { return small_box(r, 8e307, 9e307); }},
    {"points in one place",
     [](Random&) {
       return Box3{{1, 2, 3}, {1, 2, 3}};
     }},
    {"grid", on_grid},
    {"unbounded", unbounded},
    {"clusters", clustered},
};

std::vector<Box3> boxes(Random& r, const Family& family, std::size_t n) {
  std::vector<Box3> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(family.make(r));
  return result;
}

constexpr std::size_t kSizes[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 33, 64, 65, 130, 257};

TEST(BoxTree, FindsTheBoxesThatMeetABox) {
  Random r(1);
  for (const Family& family : kFamilies) {
    for (const std::size_t n : kSizes) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(n));
      const std::vector<Box3> all = boxes(r, family, n);
      const BoxTree tree(all);
      ASSERT_EQ(tree.size(), n);
      for (int query = 0; query < 20; ++query) {
        const Box3 q = query == 0 ? Box3{{-Box3::kInfinity, -Box3::kInfinity, -Box3::kInfinity},
                                         {Box3::kInfinity, Box3::kInfinity, Box3::kInfinity}}
                                  : family.make(r);
        std::vector<std::uint32_t> found, expected;
        tree.for_each_meeting(q, [&](std::uint32_t i) { found.push_back(i); });
        for (std::uint32_t i = 0; i < n; ++i) {
          if (all[i].meets(q)) expected.push_back(i);
        }
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected);
        std::size_t visited = 0;
        tree.for_each_meeting(q, [&](std::uint32_t) { return ++visited < 3; });
        ASSERT_EQ(visited, std::min<std::size_t>(3, expected.size()));
      }
    }
  }
}

TEST(BoxTree, FindsThePairsOfTwoTrees) {
  Random r(2);
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  for (const Family& family : kFamilies) {
    for (const std::size_t n : kSizes) {
      const std::vector<Box3> a = boxes(r, family, n);
      const std::vector<Box3> b = boxes(r, r() % 2 == 0 ? family : kFamilies[0], 1 + r() % 99);
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(n));
      Pairs found, expected;
      BoxTree::for_each_pair(BoxTree(a), BoxTree(b),
                             [&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); });
      for (std::uint32_t i = 0; i < a.size(); ++i) {
        for (std::uint32_t j = 0; j < b.size(); ++j) {
          if (a[i].meets(b[j])) expected.emplace_back(i, j);
        }
      }
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, FindsThePairsInsideATree) {
  Random r(6);
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  for (const Family& family : kFamilies) {
    for (const std::size_t n : kSizes) {
      const std::vector<Box3> a = boxes(r, family, n);
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(n));
      Pairs found, expected;
      BoxTree(a).for_each_pair_inside([&](std::uint32_t i, std::uint32_t j) {
        found.emplace_back(std::min(i, j), std::max(i, j));
      });
      for (std::uint32_t i = 0; i < a.size(); ++i) {
        for (std::uint32_t j = i + 1; j < a.size(); ++j) {
          if (a[i].meets(a[j])) expected.emplace_back(i, j);
        }
      }
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
    }
  }
}

BoxRay ray(const std::array<double, 3>& o, const std::array<double, 3>& d) {
  return {{o, o}, {d, d}};
}

/// A ray from anywhere through a point of the box, and the t of that point.
std::pair<BoxRay, double> ray_through(Random& r, const Box3& box) {
  std::array<double, 3> o, d;
  const double t = std::ldexp(1.0, static_cast<int>(r() % 8) - 4);
  for (std::size_t i = 0; i < 3; ++i) {
    const double low = std::max(box.low[i], -1e308), high = std::min(box.high[i], 1e308);
    const double at = r() % 4 == 0 ? low : low / 2 + high / 2;
    d[i] = r() % 4 == 0 ? 0 : std::floor(uniform(r, -4, 4));
    o[i] = at - t * d[i];
  }
  BoxRay result = ray(o, d);
  for (std::size_t i = 0; i < 3; ++i) {  // the rounding of o
    result.origin.low[i] -= 1e-15 * (8 * t + std::fabs(o[i]));
    result.origin.high[i] += 1e-15 * (8 * t + std::fabs(o[i]));
  }
  return {result, t};
}

TEST(BoxTree, MissesNoBoxAlongARay) {
  Random r(3);
  for (const Family& family : kFamilies) {
    for (const std::size_t n : kSizes) {
      if (n == 0) continue;
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(n));
      const std::vector<Box3> all = boxes(r, family, n);
      const BoxTree tree(all);
      for (int query = 0; query < 20; ++query) {
        const auto aim = static_cast<std::uint32_t>(r() % n);
        const auto aimed = ray_through(r, all[aim]);
        const BoxRay& line = aimed.first;
        const double t = aimed.second;
        std::vector<std::uint32_t> found, expected;
        bool is_hit = false;
        tree.for_each_along(line, t, [&](std::uint32_t i, double entry) {
          found.push_back(i);
          EXPECT_LE(entry, t);
          is_hit |= i == aim;
          return t;
        });
        EXPECT_TRUE(is_hit);
        double entry = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
          if (can_enter(line, all[i], t, entry)) expected.push_back(i);
        }
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected);
      }
    }
  }
}

TEST(BoxTree, RaysMissWhatLiesElsewhere) {
  const Box3 box{{1, 1, 1}, {2, 2, 2}};
  double t = 0;
  EXPECT_TRUE(can_enter(ray({0, 0, 0}, {1, 1, 1}), box, 10, t));
  EXPECT_NEAR(t, 1, 1e-12);
  EXPECT_TRUE(can_enter(ray({5, 1, 2}, {-2, 0, 0}), box, 10, t));
  EXPECT_NEAR(t, 1.5, 1e-12);
  EXPECT_TRUE(can_enter(ray({1.5, 1.5, 1.5}, {-1, 0, 0}), box, 10, t));
  EXPECT_EQ(t, 0);
  EXPECT_FALSE(can_enter(ray({0, 0, 0}, {1, 1, 1}), box, 0.9, t));
  EXPECT_FALSE(can_enter(ray({0, 0, 0}, {-1, -1, -1}), box, 10, t));
  EXPECT_FALSE(can_enter(ray({5, 0.9, 2}, {-2, 0, 0}), box, 10, t));
  EXPECT_FALSE(can_enter(ray({0, 0, 0}, {1, 1, 3}), box, 10, t));
  // A cone of directions.
  const BoxRay cone{{{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 3, 3}}};
  EXPECT_TRUE(can_enter(cone, box, 10, t));
  EXPECT_FALSE(can_enter(cone, {{1, 4, 1}, {1, 5, 1}}, 10, t));
}

TEST(BoxTree, ALimitEndsTheRay) {
  std::vector<Box3> row;
  for (int i = 0; i < 1000; ++i) row.push_back({{double(i), 0, 0}, {i + 0.5, 1, 1}});
  const BoxTree tree(row);
  std::size_t visited = 0;
  double nearest = 1e9;
  tree.for_each_along(ray({1e4, 0.5, 0.5}, {-1, 0, 0}), 1e9, [&](std::uint32_t, double entry) {
    ++visited;
    return nearest = std::min(nearest, entry);
  });
  EXPECT_NEAR(nearest, 1e4 - 999.5, 1e-6);
  EXPECT_LE(visited, 4U);
}

}  // namespace
}  // namespace plumb::box_tree_test
