// Several defects in one map, and defects far from 1.
#include <algorithm>

#include "plumb/testing/map_defects.h"

namespace plumb::testing {
namespace {

using Count = std::optional<std::uint64_t>;

Count sum(const Count& a, const Count& b) { return a && b ? Count(*a + *b) : std::nullopt; }

// As docs/maps.md has it; none when a count that matters is not known.
std::optional<MapVerdict> verdict_of(const DefectExpectation& e) {
  if (!e.duplicate) return std::nullopt;
  if (*e.duplicate > 0) return MapVerdict::NotAPlanarSubdivision;
  if (!e.open) return std::nullopt;
  if (*e.open > 0) return MapVerdict::Open;
  if (e.crossing.value_or(0) > 0 || e.twin.value_or(0) > 0 || e.mixed.value_or(0) > 0) {
    return MapVerdict::Superposed;
  }
  return e.crossing && e.twin && e.mixed ? std::optional(MapVerdict::Valid) : std::nullopt;
}

bool has_mixed_counted(const DefectExpectation& e) {
  return e.duplicate == 0U && e.open == 0U && e.crossing == 0U;
}

MapEdge moved(const MapEdge& e, std::uint32_t offset) { return {e.from + offset, e.to + offset}; }

void append(std::vector<MapEdge>& all, const std::vector<MapEdge>& edges, std::uint32_t offset) {
  for (const MapEdge& e : edges) all.push_back(moved(e, offset));
}

/// `offset` is added to vertices, `dx` to places.
void add(DefectExpectation& all, const DefectExpectation& part, std::uint32_t offset,
         const BigRational& dx) {
  if (all.refused.empty()) all.refused = part.refused;
  all.duplicate = sum(all.duplicate, part.duplicate);
  all.open = sum(all.open, part.open);
  all.crossing = sum(all.crossing, part.crossing);
  all.twin = sum(all.twin, part.twin);
  all.mixed = has_mixed_counted(all) ? sum(all.mixed, part.mixed) : std::nullopt;
  all.verdict = verdict_of(all);
  append(all.open_edges, part.open_edges, offset);
  append(all.duplicate_edges, part.duplicate_edges, offset);
  for (const auto& [e, f] : part.pairs) all.pairs.emplace_back(moved(e, offset), moved(f, offset));
  for (const ExactPoint& p : part.places) all.places.push_back({p.x + dx, p.y});
}

/// How far a map has to go to lie right of another.
BigRational way_beside(const TestMap& map, const TestMap& other) {
  if (map.points.empty() || other.points.empty()) return 0;
  const ExactPoint& least = *std::min_element(map.points.begin(), map.points.end());
  const ExactPoint& greatest = *std::max_element(other.points.begin(), other.points.end());
  return greatest.x + 1 - least.x;
}

}  // namespace

DefectiveMap combined(std::span<const DefectiveMap> parts) {
  DefectiveMap all;
  for (const DefectiveMap& part : parts) {
    const BigRational dx = way_beside(part.map, all.map);
    add(all.expected, part.expected, static_cast<std::uint32_t>(all.map.points.size()), dx);
    all.map = joined(all.map, translated(part.map, dx, 0));
  }
  return all;
}

DefectiveMap scaled(const DefectiveMap& defective, const BigRational& factor) {
  DefectiveMap result{scaled(defective.map, factor), defective.expected};
  for (ExactPoint& p : result.expected.places) p = {p.x * factor, p.y * factor};
  return result;
}

}  // namespace plumb::testing
