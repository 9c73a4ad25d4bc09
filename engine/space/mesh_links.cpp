#include "plumb/space/mesh_links.h"

#include <algorithm>
#include <utility>

namespace plumb {
namespace {

void link_cycles(const MeshFacets& facets, MeshLinks& links) {
  links.next.resize(facets.corner.size());
  links.facet.resize(facets.corner.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    for (std::uint32_t u = facets.begin[f]; u < facets.begin[f + 1]; ++u) {
      links.next[u] = u + 1;
      links.facet[u] = f;
    }
    links.next[facets.begin[f + 1] - 1] = facets.begin[f];
  }
}

/// Uses in buckets by their lesser vertex; in each (greater vertex, use) as one word.
struct Buckets {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint64_t> entry;
};

Buckets bucket_uses(const MeshFacets& facets, const MeshLinks& links, std::size_t vertex_count) {
  Buckets b;
  b.begin.assign(vertex_count + 2, 0);
  const auto lesser = [&](std::uint32_t u) {
    return std::min(facets.corner[u], facets.corner[links.next[u]]);
  };
  const auto count = static_cast<std::uint32_t>(facets.corner.size());
  for (std::uint32_t u = 0; u < count; ++u) ++b.begin[lesser(u) + 2];
  for (std::size_t v = 2; v < b.begin.size(); ++v) b.begin[v] += b.begin[v - 1];
  b.entry.resize(count);
  for (std::uint32_t u = 0; u < count; ++u) {
    const std::uint32_t from = facets.corner[u], to = facets.corner[links.next[u]];
    b.entry[b.begin[std::min(from, to) + 1]++] = std::uint64_t{std::max(from, to)} << 32U | u;
  }
  return b;
}

}  // namespace

MeshLinks link_corners(const MeshFacets& facets, std::size_t vertex_count) {
  MeshLinks links;
  link_cycles(facets, links);
  Buckets buckets = bucket_uses(facets, links, vertex_count);
  links.end.reserve(facets.corner.size() / 2 + 1);
  links.begin.reserve(facets.corner.size() / 2 + 2);
  links.use.reserve(facets.corner.size());
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const auto first = buckets.entry.begin() + buckets.begin[v];
    const auto last = buckets.entry.begin() + buckets.begin[v + 1];
    std::sort(first, last);
    std::uint32_t known = ~std::uint32_t{0};  // the other end of the last edge of v
    for (auto i = first; i != last; ++i) {
      const auto other = static_cast<std::uint32_t>(*i >> 32U);
      if (other != known) {
        links.begin.push_back(static_cast<std::uint32_t>(links.use.size()));
        links.end.push_back({v, other});
        known = other;
      }
      links.use.push_back(static_cast<std::uint32_t>(*i));
    }
  }
  links.begin.push_back(static_cast<std::uint32_t>(links.use.size()));
  return links;
}

// ---------------------------------------------------------------- doubled facets

namespace {

class Doubles {
 public:
  Doubles(const MeshFacets& facets, const MeshLinks& links) : facets_(facets), links_(links) {}

  /// Per facet: an earlier one with the same boundary, or itself. Empty: there is none.
  std::vector<std::uint32_t> find() {
    for (std::size_t e = 0; e < links_.edge_count(); ++e) {
      const auto uses = links_.uses_of(e);
      for (std::size_t j = 1; j < uses.size(); ++j) {
        if (is_first(uses[j])) compare_with_earlier(uses.first(j), uses[j]);
      }
    }
    return std::move(same_);
  }

 private:
  /// Each cycle starts at its least vertex, so equal ones start with equal uses.
  bool is_first(std::uint32_t use) const { return facets_.begin[links_.facet[use]] == use; }

  void compare_with_earlier(std::span<const std::uint32_t> earlier, std::uint32_t use) {
    const std::uint32_t g = links_.facet[use];
    for (const std::uint32_t other : earlier) {
      const std::uint32_t f = links_.facet[other];
      if (!is_first(other) || facets_.plane[f] != facets_.plane[g]) continue;
      if (!std::ranges::equal(facets_.corners(f), facets_.corners(g))) continue;
      if (same_.empty()) {
        for (std::uint32_t i = 0; i < facets_.size(); ++i) same_.push_back(i);
      }
      same_[g] = f;
      return;
    }
  }

  const MeshFacets& facets_;
  const MeshLinks& links_;
  std::vector<std::uint32_t> same_;
};

/// The facets that are their own `same`, with the jumps of the others.
MeshFacets merged(const MeshFacets& facets, std::span<const std::uint32_t> same) {
  MeshFacets kept;
  kept.loose = facets.loose;
  std::vector<std::uint32_t> place(facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    place[f] = same[f] == f ? static_cast<std::uint32_t>(kept.size()) : place[same[f]];
    if (same[f] != f) {
      kept.jump[place[f]] += facets.jump[f];
      continue;
    }
    const auto corners = facets.corners(f);
    kept.corner.insert(kept.corner.end(), corners.begin(), corners.end());
    kept.begin.push_back(static_cast<std::uint32_t>(kept.corner.size()));
    kept.plane.push_back(facets.plane[f]);
    kept.jump.push_back(facets.jump[f]);
    kept.origin.push_back(facets.origin[f]);
  }
  return kept;
}

}  // namespace

std::vector<MeshReport::FacePair> merge_doubled(MeshFacets& facets, MeshLinks& links,
                                                std::size_t vertex_count) {
  std::vector<MeshReport::FacePair> doubled;
  const std::vector<std::uint32_t> same = Doubles(facets, links).find();
  for (std::uint32_t f = 0; f < same.size(); ++f) {
    if (same[f] != f) doubled.emplace_back(facets.origin[f], facets.origin[same[f]]);
  }
  if (!doubled.empty()) {
    facets = merged(facets, same);
    links = link_corners(facets, vertex_count);
  }
  return doubled;
}

}  // namespace plumb
