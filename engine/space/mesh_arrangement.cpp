#include "plumb/space/mesh_arrangement.h"

#include <tsl/robin_map.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "plumb/predicates/seeded_hash.h"
#include "plumb/space/combine.h"
#include "plumb/space/mesh_layers.h"
#include "plumb/space/volumes.h"

namespace plumb {
namespace {

/// Numbers for sheets that lie upon each other: those below count() - pairs are sheets, others pairs of numbers.
class Bundles {
 public:
  explicit Bundles(std::uint32_t sheets) : sheets_(sheets) {}

  std::uint32_t of_both(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
    const auto next = static_cast<std::uint32_t>(sheets_ + pairs_.size());
    const auto [at, is_new] = numbers_.try_emplace(key, next);
    if (is_new) pairs_.push_back({a, b});
    return at->second;
  }

  /// Adds the sheets of a bundle. Each is in one layer, so none comes twice.
  void unfold(std::uint32_t bundle, std::vector<std::uint32_t>& sheets) {
    open_.assign(1, bundle);
    while (!open_.empty()) {
      const std::uint32_t b = open_.back();
      open_.pop_back();
      if (b < sheets_) {
        sheets.push_back(b);
      } else {
        const auto& pair = pairs_[b - sheets_];
        open_.insert(open_.end(), pair.begin(), pair.end());
      }
    }
  }

 private:
  std::uint32_t sheets_;
  std::vector<std::array<std::uint32_t, 2>> pairs_;
  tsl::robin_map<std::uint64_t, std::uint32_t, SeededHash> numbers_;
  std::vector<std::uint32_t> open_;
};

/// A surface in which nothing can be simplified.
void mark_surface(SpaceComplex& complex) {
  complex.vertex_mark.assign(complex.vertex_count(), kBeyond);
  complex.edge_mark.assign(complex.edge_count(), kBeyond);
  complex.facet_mark.assign(complex.facet_count(), 1);
}

class Arranger {
 public:
  Arranger(const MeshComplex& mesh, Context& context)
      : mesh_(mesh),
        context_(context),
        tables_(copy(*mesh.complex.tables)),
        bundles_(static_cast<std::uint32_t>(mesh.complex.facet_count())) {}

  SpaceComplex run() {
    const MeshLayers layers = find_layers(mesh_.complex, mesh_.component, mesh_.crossings);
    facets_.resize(layers.count);
    for (std::uint32_t f = 0; f < layers.of_facet.size(); ++f) {
      facets_[layers.of_facet[f]].push_back(FacetId(f));
    }
    return overlay(0, layers.count);
  }

  Bundles& bundles() { return bundles_; }

 private:
  /// Of the layers from `first` to before `last`.
  SpaceComplex overlay(std::size_t first, std::size_t last) {
    if (last - first == 1) {
      SpaceComplex layer = layer_of(mesh_.complex, facets_[first], tables_, context_);
      mark_surface(layer);
      return layer;
    }
    const std::size_t middle = first + (last - first) / 2;
    const SpaceComplex a = overlay(first, middle), b = overlay(middle, last);
    return combine_on(
        tables_, a, b, MarkTable(kUnion),
        [this](std::uint32_t i, std::uint32_t j) { return bundles_.of_both(i, j); }, context_);
  }

  const MeshComplex& mesh_;
  Context& context_;
  std::shared_ptr<SpaceTables> tables_;
  Bundles bundles_;
  std::vector<std::vector<FacetId>> facets_;  // per layer
};

/// Facets are the sheets themselves.
void fill_sheets(MeshComplex& mesh) {
  const std::size_t n = mesh.complex.facet_count();
  mesh.sheet_begin.resize(n + 1);
  std::iota(mesh.sheet_begin.begin(), mesh.sheet_begin.end(), 0U);
  mesh.sheet.assign(mesh.sheet_begin.begin(), mesh.sheet_begin.end() - 1);
}

/// facet_origin of `arranged` are bundles; they become input faces.
void unfold_sheets(SpaceComplex& arranged, Bundles& bundles, MeshComplex& mesh) {
  const std::vector<std::uint32_t>& face = mesh.complex.facet_origin;
  mesh.sheet_begin.assign(1, 0);
  for (std::uint32_t& origin : arranged.facet_origin) {
    const auto first = static_cast<std::ptrdiff_t>(mesh.sheet.size());
    bundles.unfold(origin, mesh.sheet);
    std::sort(mesh.sheet.begin() + first, mesh.sheet.end());
    mesh.sheet_begin.push_back(static_cast<std::uint32_t>(mesh.sheet.size()));
    const auto sheets = std::span(mesh.sheet).subspan(static_cast<std::size_t>(first));
    origin = face[sheets.front()];
    for (const std::uint32_t s : sheets) origin = std::min(origin, face[s]);
  }
}

}  // namespace

void arrange(MeshComplex& mesh, Context& context) {
  if (mesh.is_arranged()) return;
  const std::vector<std::uint8_t> has_fan = std::exchange(mesh.has_fan, {});
  if (mesh.crossings.empty()) {
    label_volumes(mesh.complex, context, has_fan);
    fill_sheets(mesh);
    return;
  }
  Arranger arranger(mesh, context);
  SpaceComplex arranged = arranger.run();
  unfold_sheets(arranged, arranger.bundles(), mesh);
  mesh.complex = std::move(arranged);
}

std::vector<std::int32_t> facet_jumps(const MeshComplex& mesh) {
  std::vector<std::int32_t> jumps;
  jumps.reserve(mesh.complex.facet_count());
  for (std::uint32_t f = 0; f < mesh.complex.facet_count(); ++f) {
    std::int32_t sum = 0;
    for (const std::uint32_t s : mesh.sheets_of(FacetId(f))) sum += mesh.jump[s];
    jumps.push_back(sum);
  }
  return jumps;
}

}  // namespace plumb
