// The vertices that cuts have made inside of edges.
//
// They are sorted by edge, and along each edge, by the lexicographic order of exact points. Equal
// vertices of an edge are merged into the first of them, so that every facet at the edge gets the
// same vertices. Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/cut_state.h"

#include <algorithm>

#include "plumb/predicates/point3_signs.h"

namespace plumb {

void EdgeCuts::sort() {
  std::sort(cuts_.begin(), cuts_.end(), [this](const Cut& a, const Cut& b) {
    if (a.first != b.first) return a.first < b.first;
    const Sign order = compare(a.second, b.second);
    return order == Sign::Zero ? a.second < b.second : order == Sign::Negative;
  });
  std::size_t kept = 0;
  for (const Cut& cut : cuts_) {
    const bool is_known = kept > 0 && cuts_[kept - 1].first == cut.first &&
                          compare(cuts_[kept - 1].second, cut.second) == Sign::Zero;
    if (is_known) {
      merged_.emplace_back(cut.second, cuts_[kept - 1].second);
    } else {
      cuts_[kept++] = cut;
    }
  }
  cuts_.resize(kept);
  std::sort(merged_.begin(), merged_.end());
}

VertexId EdgeCuts::merged(VertexId v) const {
  const auto found = std::lower_bound(merged_.begin(), merged_.end(), std::pair(v, VertexId(0)));
  return found != merged_.end() && found->first == v ? found->second : v;
}

bool EdgeCuts::has(EdgeId e) const {
  const auto [first, last] = of(e);
  return first != last;
}

void EdgeCuts::append_between(const RegionEdge& part, std::vector<VertexId>& vertices) const {
  const bool is_rising = compare(part.from, part.to) == Sign::Negative;
  const VertexId low = is_rising ? part.from : part.to, high = is_rising ? part.to : part.from;
  const auto [first, last] = of(part.edge);
  const auto begin = std::partition_point(
      first, last, [&](const Cut& c) { return compare(c.second, low) != Sign::Positive; });
  const auto end = std::partition_point(
      begin, last, [&](const Cut& c) { return compare(c.second, high) == Sign::Negative; });
  const std::size_t old = vertices.size();
  for (auto c = begin; c != end; ++c) vertices.push_back(c->second);
  if (!is_rising) std::reverse(vertices.begin() + static_cast<std::ptrdiff_t>(old), vertices.end());
}

Sign EdgeCuts::compare(VertexId v, VertexId w) const {
  if (v == w) return Sign::Zero;
  const SpaceComplex& c = complex_.get();
  return compare_xyz(c.points(), c.vertex_point[v], c.vertex_point[w]);
}

std::pair<std::vector<EdgeCuts::Cut>::const_iterator, std::vector<EdgeCuts::Cut>::const_iterator>
EdgeCuts::of(EdgeId e) const {
  const auto first =
      std::partition_point(cuts_.begin(), cuts_.end(), [&](const Cut& c) { return c.first < e; });
  const auto last =
      std::partition_point(first, cuts_.end(), [&](const Cut& c) { return c.first == e; });
  return {first, last};
}

bool has_channels(const CutState& state, const SourceTriangle& t) {
  return !state.sources.sources()[t.source].source->attributes.channels.empty();
}

}  // namespace plumb
