#include "plumb/testing/test_map.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace plumb::testing {
namespace {

std::uint64_t edge_key(std::uint32_t from, std::uint32_t to) {
  return (std::uint64_t{from} << 32) | to;
}

std::unordered_set<std::uint64_t> directed_edges(const TestMap& map) {
  std::unordered_set<std::uint64_t> used;
  used.reserve(map.corner_count());
  for (const Cycle& cycle : map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      used.insert(edge_key(cycle[i], cycle[(i + 1) % cycle.size()]));
    }
  }
  return used;
}

// origin -> end of the twins that no cycle uses, in the order of the listing.
std::vector<std::pair<std::uint32_t, std::uint32_t>> missing_twins(const TestMap& map) {
  const auto used = directed_edges(map);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> missing;
  for (const Cycle& cycle : map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::uint32_t to = cycle[(i + 1) % cycle.size()];
      if (!used.contains(edge_key(to, cycle[i]))) missing.emplace_back(to, cycle[i]);
    }
  }
  return missing;
}

}  // namespace

std::uint32_t TestMap::add_point(BigRational x, BigRational y) {
  points.push_back({std::move(x), std::move(y)});
  return static_cast<std::uint32_t>(points.size() - 1);
}

std::size_t TestMap::corner_count() const {
  std::size_t corners = 0;
  for (const Cycle& cycle : cycles) corners += cycle.size();
  return corners;
}

std::string to_text(const TestMap& map) {
  std::string text = std::to_string(map.points.size()) + " " + std::to_string(map.cycles.size());
  for (const ExactPoint& p : map.points) text += "\n" + p.x.str() + " " + p.y.str();
  for (const Cycle& cycle : map.cycles) {
    text += "\n";
    for (const std::uint32_t v : cycle) text += std::to_string(v + 1) + " ";
    text.pop_back();
  }
  return text + "\n";
}

BigRational doubled_area(const TestMap& map, const Cycle& cycle) {
  BigRational sum = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const ExactPoint& p = map.points[cycle[i]];
    const ExactPoint& q = map.points[cycle[(i + 1) % cycle.size()]];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

void append_missing_cycles(TestMap& map) {
  const auto missing = missing_twins(map);
  std::unordered_map<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : missing) next.emplace(from, to);
  for (const auto& [from, to] : missing) {
    Cycle cycle;
    std::uint32_t v = from;
    for (auto step = next.find(v); step != next.end(); step = next.find(v)) {
      cycle.push_back(v);
      v = step->second;
      next.erase(step);
    }
    if (!cycle.empty()) map.cycles.push_back(std::move(cycle));
  }
}

TestMap relabelled(const TestMap& map, const std::vector<std::uint32_t>& order) {
  TestMap result = map;
  for (std::size_t v = 0; v < order.size(); ++v) result.points[order[v]] = map.points[v];
  for (Cycle& cycle : result.cycles) {
    for (std::uint32_t& v : cycle) v = order[v];
  }
  return result;
}

TestMap reordered(const TestMap& map, const std::vector<std::uint32_t>& order) {
  TestMap result = map;
  for (std::size_t c = 0; c < order.size(); ++c) result.cycles[order[c]] = map.cycles[c];
  return result;
}

TestMap rotated(const TestMap& map, std::uint32_t by) {
  TestMap result = map;
  for (Cycle& cycle : result.cycles) {
    const auto shift = static_cast<std::ptrdiff_t>(by % cycle.size());
    std::rotate(cycle.begin(), cycle.begin() + shift, cycle.end());
  }
  return result;
}

TestMap scaled(const TestMap& map, const BigRational& factor) {
  TestMap result = map;
  for (ExactPoint& p : result.points) {
    p.x *= factor;
    p.y *= factor;
  }
  return result;
}

TestMap translated(const TestMap& map, const BigRational& dx, const BigRational& dy) {
  TestMap result = map;
  for (ExactPoint& p : result.points) {
    p.x += dx;
    p.y += dy;
  }
  return result;
}

TestMap axes_swapped(const TestMap& map) {
  TestMap result = map;
  for (ExactPoint& p : result.points) std::swap(p.x, p.y);
  for (Cycle& cycle : result.cycles) std::reverse(cycle.begin(), cycle.end());
  return result;
}

TestMap joined(const TestMap& first, const TestMap& second) {
  TestMap result = first;
  const auto offset = static_cast<std::uint32_t>(first.points.size());
  result.points.insert(result.points.end(), second.points.begin(), second.points.end());
  for (Cycle cycle : second.cycles) {
    for (std::uint32_t& v : cycle) v += offset;
    result.cycles.push_back(std::move(cycle));
  }
  return result;
}

}  // namespace plumb::testing
