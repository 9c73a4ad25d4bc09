#include "plumb/space/volumes.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/parallel.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/shell_nodes.h"
#include "plumb/space/space_locator.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {

namespace {

constexpr SphereDirection kLeft{kPlaneZ, kPlaneY};  // -x
constexpr SphereDirection kRight{kPlaneY, kPlaneZ};

class Labeller {
 public:
  Labeller(const SpaceComplex& complex, Context& context, std::span<const std::uint8_t> connected)
      : complex_(complex),
        context_(context),
        connected_(connected),
        pieces_(complex.vertex_count()) {}

  VolumeLabels run() {
    run_jobs(context_, 2, [this](std::size_t i, Context&) {
      if (i == 0) {
        shells_.emplace(complex_, connected_);
      } else {
        find_pieces();
      }
    });
    nest_pieces();
    return numbered();
  }

 private:
  // ---- connected pieces

  void find_pieces() {
    for (std::uint32_t h = 0; h < complex_.origin.size(); h += 2) {
      pieces_.unite(complex_.origin[h].value(), complex_.origin[h + 1].value());
    }
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      const auto cycles = complex_.cycles_of(FacetId(f));
      const std::uint32_t first = complex_.use_origin(cycles[0]).value();
      for (const UseId u : cycles.subspan(1)) pieces_.unite(first, complex_.use_origin(u).value());
      for (const VertexId v : complex_.inner_of(FacetId(f))) pieces_.unite(first, v.value());
    }
    std::vector<std::uint32_t> number(complex_.vertex_count(), SphereMap::kNone);
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      std::uint32_t& piece = number[pieces_.root(v)];
      if (piece == SphereMap::kNone) {
        piece = static_cast<std::uint32_t>(least_.size());
        least_.push_back(VertexId(v));
      } else if (compare_xyz(complex_.points(), complex_.vertex_point[v],
                             complex_.vertex_point[least_[piece].value()]) == Sign::Negative) {
        least_[piece] = VertexId(v);
      }
    }
  }

  /// The node that faces a direction at an item.
  std::uint32_t node_towards(SpaceItem item, SphereDirection direction) {
    local_map(complex_, item, local_);
    std::vector<std::uint32_t> node;
    shells_->face_nodes(local_, item, node);
    const SphereCell cell = locate(complex_.planes(), local_.map, direction);
    PLUMB_CHECK(cell.kind() == SphereCell::Kind::Face && node[cell.index()] != ShellNodes::kNone);
    return node[cell.index()];
  }

  /// One piece holds the least vertex of all; every other finds what is to its left.
  void nest_pieces() {
    std::optional<SpaceLocator> locator;
    for (const VertexId v : least_) {
      const std::uint32_t outer = node_towards(v, kLeft);
      SpaceItem hit;
      if (least_.size() > 1) {
        if (!locator) locator.emplace(complex_);
        hit = locator->shoot_left(complex_.vertex_point[v.value()]);
      }
      if (hit.is_valid()) {
        shells_->unite(outer, node_towards(hit, kRight));
      } else {
        outermost_.push_back(outer);
      }
      context_.checkpoint("volumes", v.value(), complex_.vertex_count());
    }
    for (const std::uint32_t node : outermost_) shells_->unite(outermost_[0], node);
  }

  // ---- numbering

  VolumeLabels numbered() {
    VolumeLabels labels;
    std::vector<VolumeId> number(shells_->size());
    const auto volume_of = [&](std::uint32_t node) {
      VolumeId& volume = number[shells_->root(node)];
      if (!volume.is_valid()) volume = VolumeId(labels.count++);
      return volume;
    };
    volume_of(outermost_[0]);
    labels.facet.reserve(complex_.facet_count());
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      labels.facet.push_back({volume_of(2 * f), volume_of(2 * f + 1)});
    }
    labels.edge.resize(complex_.edge_count());
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      const std::uint32_t node = shells_->free_node(EdgeId(e));
      if (node != ShellNodes::kNone) labels.edge[e] = volume_of(node);
    }
    labels.vertex.resize(complex_.vertex_count());
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      const bool is_alone = complex_.star_of(VertexId(v)).empty();
      if (is_alone && !complex_.vertex_facet[v].is_valid()) {
        labels.vertex[v] = volume_of(shells_->vertex_node(VertexId(v)));
      }
    }
    return labels;
  }

  const SpaceComplex& complex_;
  Context& context_;
  std::span<const std::uint8_t> connected_;
  std::optional<ShellNodes> shells_;
  UnionFind pieces_;
  std::vector<VertexId> least_;           // per piece
  std::vector<std::uint32_t> outermost_;  // nodes of volume 0
  LocalMap local_;
};

}  // namespace

VolumeLabels find_volumes(const SpaceComplex& complex, Context& context,
                          std::span<const std::uint8_t> connected) {
  if (complex.vertex_count() == 0) return {{}, {}, {}, 1};
  return Labeller(complex, context, connected).run();
}

void label_volumes(SpaceComplex& complex, Context& context,
                   std::span<const std::uint8_t> connected) {
  complex.volume_mark.clear();
  complex.facet_volume.clear();
  complex.edge_volume.clear();
  complex.vertex_volume.clear();
  VolumeLabels labels = find_volumes(complex, context, connected);
  complex.facet_volume = std::move(labels.facet);
  complex.edge_volume = std::move(labels.edge);
  complex.vertex_volume = std::move(labels.vertex);
  complex.volume_mark.assign(labels.count, 0);
}

std::vector<std::int32_t> winding_numbers(const SpaceComplex& complex,
                                          std::span<const std::int32_t> jump) {
  // The graph of volumes, facets being its edges, in compressed rows.
  const std::size_t volumes = complex.volume_count();
  std::vector<std::uint32_t> begin(volumes + 1, 0);
  for (const auto& sides : complex.facet_volume) {
    for (const VolumeId v : sides) ++begin[v.value() + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> facet(begin.back()), at(begin.begin(), begin.end() - 1);
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    for (const VolumeId v : complex.facet_volume[f]) facet[at[v.value()]++] = f;
  }
  std::vector<std::int32_t> winding(volumes, 0);
  std::vector<std::uint8_t> is_reached(volumes, 0);
  std::vector<std::uint32_t> open{0};
  is_reached[0] = 1;
  while (!open.empty()) {
    const std::uint32_t v = open.back();
    open.pop_back();
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
      const auto& sides = complex.facet_volume[facet[i]];
      const bool is_positive_side = sides[0].value() == v;
      const std::uint32_t other = sides[is_positive_side ? 1 : 0].value();
      if (is_reached[other] != 0) continue;
      is_reached[other] = 1;
      winding[other] = winding[v] + (is_positive_side ? -jump[facet[i]] : jump[facet[i]]);
      open.push_back(other);
    }
  }
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    const auto& [above, below] = complex.facet_volume[f];
    PLUMB_CHECK(winding[above.value()] - winding[below.value()] == jump[f]);
  }
  return winding;
}

}  // namespace plumb
