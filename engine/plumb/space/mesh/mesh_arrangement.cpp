// Layers of a mesh, their overlay, and components that face inwards.
//
// Three facets of one mesh may meet in a point; then the pairs of cells that name points in a
// Boolean are not unique. So facets are first coloured such that facets that cross have different
// colours. A layer consists of the facets of one colour, so it does not cross itself. Layers are
// overlaid by the Boolean's own steps, with marks under which nothing is simplified.
//
// Invariants: every facet of the overlay lies in exactly one facet of each layer or in none, so a
// bundle (sheets that lie upon each other) is a binary tree of pairs whose leaves are sheets, each
// at most once; the jump of a facet is the sum of the jumps of its sheets. Proof:
// docs/design/meshes.md, Lemmas 2 and 3.
//
// A component of negative volume is flipped only if one of its facets borders on volume 0. A
// component that other components enclose is a void.
//
// Tested by tests/space/mesh_arrangement_test.cpp.

#include "plumb/space/mesh/mesh_arrangement.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/space/boolean/boolean_op.h"
#include "plumb/space/mesh/link_facets.h"
#include "plumb/space/query/volumes.h"

namespace plumb {
namespace {

/// Lists of numbers, one list for each item, in one array.
struct Lists {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> entry;
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return std::span(entry).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// Returns for each facet those that it crosses.
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

/// Returns for each component its facets, ascending.
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

/// The greedy colouring. A layer is free for a facet if no facet that it crosses is there.
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
  /// Whether two facets of one component cross.
  bool crosses_itself(std::span<const std::uint32_t> facets) const {
    return std::ranges::any_of(facets, [this](std::uint32_t f) {
      return std::ranges::any_of(rivals_[f],
                                 [&](std::uint32_t g) { return component_[f] == component_[g]; });
    });
  }

  /// Puts all facets of a component into the least layer that is free for all of them.
  void keep_whole(std::span<const std::uint32_t> facets) {
    ++round_;
    for (const std::uint32_t f : facets) exclude_rivals(f);
    const std::uint32_t layer = least_free();
    for (const std::uint32_t f : facets) put(f, layer);
  }

  /// Visits the neighbours of a facet, breadth first, and keeps them in the same layer where this
  /// layer is free.
  void spread_from(std::uint32_t start) {
    if (layers_.of_facet[start] != kNone) return;
    put_near(start, kNone);
    queue_.assign(1, start);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      // Neighbours across an edge are those that follow in radial order.
      const UseId first = complex_.cycles_of(FacetId(queue_[i]))[0];
      UseId u = first;
      do {
        const std::uint32_t g = complex_.use_facet[complex_.use_radial[u]].value();
        if (layers_.of_facet[g] == kNone && component_[g] == component_[start]) {
          put_near(g, layers_.of_facet[queue_[i]]);
          queue_.push_back(g);
        }
        u = complex_.use_next[u];
      } while (u != first);
    }
  }

  /// Puts a facet into the wanted layer if it is free; otherwise into the least layer that is free.
  void put_near(std::uint32_t f, std::uint32_t wanted) {
    ++round_;
    exclude_rivals(f);
    put(f, wanted != kNone && excluded_[wanted] != round_ ? wanted : least_free());
  }

  /// Notes the layers that are not free for a facet. The number of the round replaces clearing the
  /// notes.
  void exclude_rivals(std::uint32_t f) {
    for (const std::uint32_t g : rivals_[f]) {
      if (layers_.of_facet[g] != kNone) excluded_[layers_.of_facet[g]] = round_;
    }
  }

  /// Returns the least layer that is not excluded in this round. It may be a new layer.
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
  std::vector<std::uint64_t> excluded_;  // The last round with a rival in each layer.
  std::uint64_t round_ = 0;
  std::vector<std::uint32_t> queue_;
};

/// Copies the facets to `out` and returns the vertices that take part, ascending.
std::vector<std::uint32_t> gather_corners(const SpaceComplex& complex,
                                          std::span<const FacetId> facets, MeshFacets& out) {
  for (const FacetId f : facets) {
    const UseId first = complex.cycles_of(f)[0];
    UseId u = first;
    do {
      out.corner.push_back(complex.use_origin(u).value());
      u = complex.use_next[u];
    } while (u != first);
    out.begin.push_back(static_cast<std::uint32_t>(out.corner.size()));
    out.plane.push_back(complex.facet_plane[f]);
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
                      const std::shared_ptr<SpaceTables>& tables, Context& context) {
  MeshFacets chosen;
  const std::vector<std::uint32_t> vertices = gather_corners(complex, facets, chosen);
  std::vector<SpacePoint> points;
  points.reserve(vertices.size());
  for (const std::uint32_t v : vertices) points.push_back(complex.vertex_point[v]);
  for (std::uint32_t& v : chosen.corner) {
    v = static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, v) - vertices.begin());
  }
  const MeshLinks links = link_corners(chosen, vertices.size());
  SpaceComplex layer = link_facets(chosen, links, points, tables);
  label_volumes(layer, context);
  return layer;
}

namespace {

/// Numbers for bundles of sheets that lie upon each other. A number below the count of sheets is
/// that sheet; any other one is a pair of numbers.
class Bundles {
 public:
  explicit Bundles(std::uint32_t sheets) : sheets_(sheets) {}

  /// Returns the number of the bundle that joins two bundles. Equal pairs get the same number.
  std::uint32_t of_both(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = key_of({a, b});
    const auto next = static_cast<std::uint32_t>(pairs_.size());
    const std::uint32_t found =
        numbers_.find_or_add(static_cast<std::uint32_t>(SeededHash()(key)), next,
                             [&](std::uint32_t i) { return key_of(pairs_[i]) == key; });
    if (found == next) pairs_.push_back({a, b});
    return sheets_ + found;
  }

  /// Appends the sheets of a bundle. Each sheet is in one layer, so no sheet occurs twice.
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
  static std::uint64_t key_of(const std::array<std::uint32_t, 2>& pair) {
    return std::uint64_t{std::min(pair[0], pair[1])} << 32U | std::max(pair[0], pair[1]);
  }

  std::uint32_t sheets_;
  std::vector<std::array<std::uint32_t, 2>> pairs_;
  IdIndex numbers_;  // Finds a pair in pairs_.
  std::vector<std::uint32_t> open_;
};

/// Gives a surface marks that prevent every simplification: kBeyond differs from the marks of
/// facets and volumes.
void mark_surface(SpaceComplex& complex) {
  complex.vertex_mark.assign(complex.vertex_count(), kBeyond);
  complex.edge_mark.assign(complex.edge_count(), kBeyond);
  complex.facet_mark.assign(complex.facet_count(), 1);
}

/// The overlay of all layers of one mesh, over a copy of its tables.
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
  /// Returns the overlay of layers first, ..., last - 1, as a balanced tree. Each facet takes part
  /// in O(log layers) overlays.
  SpaceComplex overlay(std::size_t first, std::size_t last) {
    if (last - first == 1) {
      SpaceComplex layer = layer_of(mesh_.complex, facets_[first], tables_, context_);
      mark_surface(layer);
      return layer;
    }
    const std::size_t middle = first + (last - first) / 2;
    const SpaceComplex a = overlay(first, middle), b = overlay(middle, last);
    // The union of facets with mark 1 in volumes with mark 0; a facet in both layers gets the
    // number of both bundles.
    return boolean_op_on(
        tables_, a, b, MarkTable(kUnion),
        [this](std::uint32_t i, std::uint32_t j) { return bundles_.of_both(i, j); }, context_);
  }

  const MeshComplex& mesh_;
  Context& context_;
  std::shared_ptr<SpaceTables> tables_;
  Bundles bundles_;
  std::vector<std::vector<FacetId>> facets_;  // The facets of each layer.
};

/// Lists each facet as its own sheet, for a mesh that does not cross itself.
void fill_sheets(MeshComplex& mesh) {
  const std::size_t n = mesh.complex.facet_count();
  mesh.sheet_begin.resize(n + 1);
  std::iota(mesh.sheet_begin.begin(), mesh.sheet_begin.end(), 0U);
  mesh.sheet.assign(mesh.sheet_begin.begin(), mesh.sheet_begin.end() - 1);
}

/// Replaces the bundles in facet_origin of `arranged` by the least input face of their sheets, and
/// lists the sheets.
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

namespace {

/// Whether the mesh is one closed surface in which every vertex has a fan, or at least one ring of
/// corners, and which does not cross itself. Such a vertex has edges of two facets only, so the
/// surface bounds two volumes.
bool is_one_shell(const MeshComplex& mesh, std::span<const std::uint8_t> has_fan) {
  if (mesh.is_inside_out.size() != 1 || !mesh.report.is_closed() || !mesh.crossings.empty() ||
      mesh.jump[0] == 0 || has_fan.size() != mesh.complex.vertex_count()) {
    return false;
  }
  for (std::uint32_t v = 0; v < has_fan.size(); ++v) {
    if (has_fan[v] == 0 && !has_one_ring(mesh.complex, VertexId(v))) return false;
  }
  return true;
}

/// Gives the facets of one shell the volumes that label_volumes() finds. The sign of the volume of
/// the shell states whether winding numbers increase towards its inside. The sign of a jump states
/// on which side of its facet they are greater.
void label_sides(const MeshComplex& mesh, SpaceComplex& complex) {
  constexpr VolumeId outside(0), inside(1);
  const bool is_inside_out = mesh.is_inside_out[0] != 0;
  complex.facet_volume.resize(complex.facet_count());
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    const bool is_outside_above = (mesh.jump[f] < 0) != is_inside_out;
    complex.facet_volume[f] =
        is_outside_above ? std::array{outside, inside} : std::array{inside, outside};
  }
  complex.edge_volume.assign(complex.edge_count(), VolumeId());
  complex.vertex_volume.assign(complex.vertex_count(), VolumeId());
  complex.volume_mark.assign(2, 0);
}

}  // namespace

void arrange(MeshComplex& mesh, Context& context) {
  if (mesh.is_arranged()) return;
  // Fans state which sphere maps are connected. After facets have been cut, they are no longer
  // valid.
  const std::vector<std::uint8_t> has_fan = std::exchange(mesh.has_fan, {});
  if (mesh.crossings.empty()) {
    if (is_one_shell(mesh, has_fan)) {
      label_sides(mesh, mesh.complex);
    } else {
      label_volumes(mesh.complex, context, has_fan);
    }
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

namespace {

/// Returns 1 for each component that borders on volume 0. The component borders on it alone at some
/// place, or together with other components none of which borders on it alone.
std::vector<std::uint8_t> find_outermost(const MeshComplex& mesh) {
  const auto component_of = [&](std::uint32_t sheet) { return mesh.component[sheet]; };
  std::vector<std::uint8_t> is_outermost(mesh.is_inside_out.size(), 0);
  std::vector<std::uint32_t> shared;  // Facets in which sheets of several components lie.
  for (std::uint32_t f = 0; f < mesh.complex.facet_count(); ++f) {
    const auto& sides = mesh.complex.facet_volume[f];
    // Only facets that border on volume 0 are considered.
    if (sides[0] != VolumeId(0) && sides[1] != VolumeId(0)) continue;
    const auto sheets = mesh.sheets_of(FacetId(f));
    const std::uint32_t first = component_of(sheets[0]);
    if (std::ranges::all_of(sheets, [&](auto s) { return component_of(s) == first; })) {
      is_outermost[first] = 1;
    } else {
      shared.push_back(f);
    }
  }
  // A shared facet decides only if none of its components borders on volume 0 alone at another
  // place.
  std::vector<std::uint8_t> result = is_outermost;
  for (const std::uint32_t f : shared) {
    const auto sheets = mesh.sheets_of(FacetId(f));
    if (std::ranges::any_of(sheets, [&](auto s) { return is_outermost[component_of(s)] != 0; })) {
      continue;
    }
    for (const std::uint32_t s : sheets) result[component_of(s)] = 1;
  }
  return result;
}

}  // namespace

std::vector<std::uint32_t> turn_inside_out(MeshComplex& mesh, Context& context) {
  std::vector<std::uint32_t> turned;
  if (mesh.report.inside_out.empty()) return turned;
  arrange(mesh, context);
  std::vector<std::uint8_t> is_turned = find_outermost(mesh);
  auto face = mesh.report.inside_out.begin();  // The faces of components of negative volume.
  for (std::size_t c = 0; c < is_turned.size(); ++c) {
    if (mesh.is_inside_out[c] == 0) {
      is_turned[c] = 0;
      continue;
    }
    if (is_turned[c] != 0) turned.push_back(*face);
    ++face;
  }
  for (std::size_t s = 0; s < mesh.jump.size(); ++s) {
    if (is_turned[mesh.component[s]] != 0) mesh.jump[s] = -mesh.jump[s];
  }
  return turned;
}

}  // namespace plumb
