#include "plumb/space/mesh_layers.h"

#include <algorithm>
#include <numeric>

#include "plumb/space/link_facets.h"
#include "plumb/space/volumes.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Lists of numbers, one for each of some items, in one array.
struct Lists {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> entry;
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return std::span(entry).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// Per facet those it crosses.
Lists rivals_of(std::size_t facets, std::span<const std::pair<FacetId, FacetId>> crossings) {
  Lists lists;
  lists.begin.assign(facets + 1, 0);
  for (const auto& [f, g] : crossings) {
    ++lists.begin[f.value() + 1];
    ++lists.begin[g.value() + 1];
  }
  std::partial_sum(lists.begin.begin(), lists.begin.end(), lists.begin.begin());
  lists.entry.resize(lists.begin.back());
  std::vector<std::uint32_t> at(lists.begin.begin(), lists.begin.end() - 1);
  for (const auto& [f, g] : crossings) {
    lists.entry[at[f.value()]++] = g.value();
    lists.entry[at[g.value()]++] = f.value();
  }
  return lists;
}

/// Per component its facets.
Lists facets_of(std::span<const std::uint32_t> component) {
  Lists lists;
  for (const std::uint32_t c : component) {
    if (c + 2 > lists.begin.size()) lists.begin.resize(c + 2, 0);
    ++lists.begin[c + 1];
  }
  std::partial_sum(lists.begin.begin(), lists.begin.end(), lists.begin.begin());
  lists.entry.resize(component.size());
  std::vector<std::uint32_t> at(lists.begin.begin(), lists.begin.end() - 1);
  for (std::uint32_t f = 0; f < component.size(); ++f) lists.entry[at[component[f]]++] = f;
  return lists;
}

class Colouring {
 public:
  Colouring(const SpaceComplex& complex, std::span<const std::uint32_t> component,
            std::span<const std::pair<FacetId, FacetId>> crossings)
      : complex_(complex),
        component_(component),
        rivals_(rivals_of(complex.facet_count(), crossings)) {
    layers_.of_facet.assign(complex.facet_count(), kNone);
  }

  MeshLayers run() {
    const Lists components = facets_of(component_);
    for (std::size_t c = 0; c + 1 < components.begin.size(); ++c) {
      if (crosses_itself(components[c])) {
        for (const std::uint32_t f : components[c]) spread_from(f);
      } else {
        keep_whole(components[c]);
      }
    }
    return std::move(layers_);
  }

 private:
  bool crosses_itself(std::span<const std::uint32_t> facets) const {
    return std::ranges::any_of(facets, [this](std::uint32_t f) {
      return std::ranges::any_of(rivals_[f],
                                 [&](std::uint32_t g) { return component_[f] == component_[g]; });
    });
  }

  void keep_whole(std::span<const std::uint32_t> facets) {
    ++round_;
    for (const std::uint32_t f : facets) exclude_rivals(f);
    const std::uint32_t layer = least_free();
    for (const std::uint32_t f : facets) put(f, layer);
  }

  /// Goes from a facet to its neighbours, breadth first, staying in one layer where that is free.
  void spread_from(std::uint32_t start) {
    if (layers_.of_facet[start] != kNone) return;
    put_near(start, kNone);
    queue_.assign(1, start);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const UseId first = complex_.cycles_of(FacetId(queue_[i]))[0];
      UseId u = first;
      do {
        const std::uint32_t g = complex_.use_facet[complex_.use_radial[u.value()].value()].value();
        if (layers_.of_facet[g] == kNone && component_[g] == component_[start]) {
          put_near(g, layers_.of_facet[queue_[i]]);
          queue_.push_back(g);
        }
        u = complex_.use_next[u.value()];
      } while (u != first);
    }
  }

  void put_near(std::uint32_t f, std::uint32_t wanted) {
    ++round_;
    exclude_rivals(f);
    put(f, wanted != kNone && excluded_[wanted] != round_ ? wanted : least_free());
  }

  void exclude_rivals(std::uint32_t f) {
    for (const std::uint32_t g : rivals_[f]) {
      if (layers_.of_facet[g] != kNone) excluded_[layers_.of_facet[g]] = round_;
    }
  }

  std::uint32_t least_free() const {
    const auto free = std::ranges::find_if(excluded_, [this](auto r) { return r != round_; });
    return static_cast<std::uint32_t>(free - excluded_.begin());
  }

  void put(std::uint32_t f, std::uint32_t layer) {
    layers_.of_facet[f] = layer;
    if (layer < layers_.count) return;
    layers_.count = layer + 1;
    excluded_.resize(layers_.count, 0);
  }

  const SpaceComplex& complex_;
  std::span<const std::uint32_t> component_;
  Lists rivals_;
  MeshLayers layers_;
  std::vector<std::uint64_t> excluded_;  // per layer: the round in which a rival was seen there
  std::uint64_t round_ = 0;
  std::vector<std::uint32_t> queue_;
};

/// The vertices that take part, ascending.
std::vector<std::uint32_t> gather_corners(const SpaceComplex& complex,
                                          std::span<const FacetId> facets, MeshFacets& out) {
  for (const FacetId f : facets) {
    const UseId first = complex.cycles_of(f)[0];
    UseId u = first;
    do {
      out.corner.push_back(complex.use_origin(u).value());
      u = complex.use_next[u.value()];
    } while (u != first);
    out.begin.push_back(static_cast<std::uint32_t>(out.corner.size()));
    out.plane.push_back(complex.facet_plane[f.value()]);
    out.origin.push_back(f.value());
  }
  std::vector<std::uint32_t> vertices = out.corner;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

MeshLayers find_layers(const SpaceComplex& complex, std::span<const std::uint32_t> component,
                       std::span<const std::pair<FacetId, FacetId>> crossings) {
  return Colouring(complex, component, crossings).run();
}

SpaceComplex layer_of(const SpaceComplex& complex, std::span<const FacetId> facets,
                      std::shared_ptr<SpaceTables> tables, Context& context) {
  MeshFacets chosen;
  const std::vector<std::uint32_t> vertices = gather_corners(complex, facets, chosen);
  std::vector<SpacePoint> points;
  points.reserve(vertices.size());
  for (const std::uint32_t v : vertices) points.push_back(complex.vertex_point[v]);
  for (std::uint32_t& v : chosen.corner) {
    v = static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, v) - vertices.begin());
  }
  const MeshLinks links = link_corners(chosen, vertices.size());
  SpaceComplex layer = link_facets(chosen, links, points, std::move(tables));
  label_volumes(layer, context);
  return layer;
}

}  // namespace plumb
