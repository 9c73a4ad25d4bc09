// Minimal form, by merging in the arrays or by sphere maps.
//
// Which cells are superfluous is a local question (docs/design/boolean.md, Lemma 2). If no facet,
// free edge or isolated vertex is superfluous, then volumes stay, and only edges between two facets
// of one plane and vertices inside edges or facets are removed (docs/design/meshes.md, Lemma 4):
// facets are united across flat edges, edges are united across passed vertices, and every list is
// made again by walks around the removed cells. Otherwise, every map is simplified and the complex
// is assembled again. Both ways give the same complex, up to numbering.
//
// Invariant of the walks: from an edge use that stays, the next edge use along the united facet is
// found by turning around its end across flat edges; all corners of the result are found so, and a
// flat half-edge that no corner crosses belongs to a facet that lies all around its vertex.
//
// Tested by tests/space/simplify_test.cpp, which compares both ways.

#include "plumb/space/boolean/simplify.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/space/boolean/assemble.h"
#include "plumb/space/boolean/vertex_labels.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/planar/facet_site.h"
#include "plumb/sphere/arcs/sphere_arcs.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {
namespace {

constexpr std::uint64_t kBytesPerHalfedge = 2;  // The memory for finding the removed cells.
// The memory of the merged complex, and of the numbers of cells.
constexpr std::uint64_t kBytesPerMergedUse = 60;

}  // namespace

// If there are no flat edges, only a vertex with two edges can be removed. Sets that are minimal
// need no arrays at all.
CoplanarMerge::CoplanarMerge(const SpaceComplex& complex, Context& context)
    : memory_(context), in_(complex) {
  memory_.add(kBytesPerHalfedge * in_.origin.size(), "the minimal form");
  find_flat_edges();
  const bool has_flat = !is_flat_.empty();
  for (std::uint32_t v = 0; v < in_.vertex_count(); ++v) {
    if (v % 4096 == 0) context.checkpoint("simplify", v, in_.vertex_count());
    if (!has_flat && in_.star_of(VertexId(v)).size() != 2) continue;  // The vertex is kept.
    const Fate fate = fate_of(VertexId(v));
    if (fate == Fate::Kept) continue;
    fate_.resize(in_.vertex_count());
    fate_[v] = fate;
  }
  is_needed_ = has_flat || !fate_.empty();
  if (is_needed_) fate_.resize(in_.vertex_count());
}

/// Finds the flat edges. Makes no arrays if there are none, as in sets that are minimal.
void CoplanarMerge::find_flat_edges() {
  const auto count = static_cast<std::uint32_t>(in_.edge_count());
  std::uint32_t e = 0;
  while (e < count && !is_flat_edge(EdgeId(e))) ++e;
  if (e == count) return;
  is_crossed_.resize(in_.origin.size());
  is_flat_.resize(count);
  for (; e < count; ++e) is_flat_[e] = is_flat_edge(EdgeId(e)) ? 1 : 0;
}

SpaceComplex CoplanarMerge::run(Context& context) {
  memory_.add(kBytesPerMergedUse * in_.use_count(), "the minimal form");
  const auto checkpoint = [&context](std::uint64_t step) {
    context.checkpoint("simplify", step, 4);
  };
  checkpoint(0);
  number_vertices();
  make_edges();
  checkpoint(1);
  make_uses();
  checkpoint(2);
  make_facets();
  checkpoint(3);
  out_.list_stars(out_.vertex_count());
  gather_inner();
  out_.volume_mark = in_.volume_mark;
  return std::move(out_);
}

// ---------------------------------------------------------------- what is removed

bool CoplanarMerge::is_flat_edge(EdgeId e) const {
  const UseId first = in_.edge_use[e];
  if (!first.is_valid()) return false;
  const UseId second = in_.use_radial[first];
  if (second == first || in_.use_radial[second] != first) return false;
  const FacetId f = in_.use_facet[first], g = in_.use_facet[second];
  const Mark own = in_.edge_mark[e];
  return in_.facet_plane[f] == in_.facet_plane[g] && in_.facet_mark[f] == own &&
         in_.facet_mark[g] == own;
}

// The remaining edges at v and the corners between them decide. If a flat half-edge is in no such
// corner, one facet lies all around v. Then v is removed if no edge is left and it has the mark of
// the facet; otherwise, it remains inside of the facet. If all flat half-edges are in corners, v is
// passed if two edges are left that continue each other.
CoplanarMerge::Fate CoplanarMerge::fate_of(VertexId v) {
  const std::span<const HalfedgeId> star = in_.star_of(v);
  if (star.empty() || in_.vertex_facet[v].is_valid()) return Fate::Kept;
  std::array<HalfedgeId, 2> left;
  std::size_t flat = 0, count = 0;
  for (const HalfedgeId h : star) {
    if (is_flat(h)) {
      ++flat;
    } else if (count++ < 2) {
      left[count - 1] = h;
    }
  }
  if (flat > 0 && cross_from_left(v) < flat) {
    const FacetId around = facet_around(v);
    if (count == 0 && in_.vertex_mark[v] == in_.facet_mark[around]) return Fate::Gone;
    inside_.emplace_back(v, around);
    return Fate::Kept;
  }
  return count == 2 && is_passed(v, left[0], left[1]) ? Fate::Passed : Fate::Kept;
}

/// Marks the flat half-edges at v in corners between remaining edges, and returns their number.
/// Each corner is crossed from the use that begins it.
std::size_t CoplanarMerge::cross_from_left(VertexId v) {
  std::size_t crossed = 0;
  for (const HalfedgeId h : in_.star_of(v)) {
    const UseId first = in_.edge_use[h.value() / 2];
    if (is_flat(h) || !first.is_valid()) continue;
    UseId u = first;
    do {
      if (in_.use_halfedge[u] == h) {
        // The corner of u extends counter-clockwise across flat edges up to an edge that remains.
        for (UseId w = in_.use_prev[u]; is_flat(w); w = prev_around(w)) {
          is_crossed_[SpaceComplex::twin(in_.use_halfedge[w])] = 1;
          ++crossed;
        }
      }
      u = in_.use_radial[u];
    } while (u != first);
  }
  return crossed;
}

/// Returns a part of the facet whose flat edges surround v, that is, edges that are in no corner.
/// Requires that there is such an edge.
FacetId CoplanarMerge::facet_around(VertexId v) const {
  const std::span<const HalfedgeId> star = in_.star_of(v);
  const HalfedgeId h = *std::ranges::find_if(
      star, [this](HalfedgeId g) { return is_flat(g) && is_crossed_[g] == 0; });
  return in_.use_facet[in_.edge_use[h.value() / 2]];
}

/// Whether two half-edges, the only ones left at v, and the facets of both continue each other
/// there. Facets in two planes have one line in common, so both edges are on it and, being
/// different, opposite; if all facets are in one plane, the directions are compared. A facet of
/// `other` alone would lie all around v, so h would run into it: so it is enough to look at the
/// facets of h.
bool CoplanarMerge::is_passed(VertexId v, HalfedgeId h, HalfedgeId other) const {
  const Mark mark = in_.vertex_mark[v];
  if (in_.edge_mark[h.value() / 2] != mark || in_.edge_mark[other.value() / 2] != mark)
    return false;
  PlaneId plane;
  bool has_two_planes = false;
  const UseId first = in_.edge_use[h.value() / 2];
  // Each facet of h must continue beyond v along `other`, forward if its use leaves v, and
  // otherwise backward.
  for (UseId u = first; u.is_valid();) {
    const bool leaves = in_.use_halfedge[u] == h;
    const UseId w = leaves ? prev_left(u) : next_left(u);
    if (in_.use_halfedge[w] != (leaves ? SpaceComplex::twin(other) : other)) return false;
    const PlaneId own = in_.facet_plane[in_.use_facet[u]];
    has_two_planes |= plane.is_valid() && own != plane;
    plane = own;
    u = in_.use_radial[u];
    if (u == first) break;
  }
  return has_two_planes ||
         is_opposite(in_.planes(), direction_of(in_, h), direction_of(in_, other));
}

// ---------------------------------------------------------------- walks

/// Returns the other half-edge that remains at a passed vertex.
HalfedgeId CoplanarMerge::other_left(VertexId v, HalfedgeId h) const {
  const std::span<const HalfedgeId> star = in_.star_of(v);
  return *std::ranges::find_if(star, [&](HalfedgeId g) { return g != h && !is_flat(g); });
}

/// Returns the next use along the united facet. The walk crosses flat edges around their ends.
UseId CoplanarMerge::next_left(UseId u) const {
  UseId w = in_.use_next[u];
  while (is_flat(w)) w = in_.use_next[in_.use_radial[w]];
  return w;
}

/// Returns the previous use along the united facet.
UseId CoplanarMerge::prev_left(UseId u) const {
  UseId w = in_.use_prev[u];
  while (is_flat(w)) w = prev_around(w);
  return w;
}

/// Returns the use that arrives where the given flat use arrives, in the facet on the other side.
UseId CoplanarMerge::prev_around(UseId flat) const { return in_.use_prev[in_.use_radial[flat]]; }

// ---------------------------------------------------------------- what is left

void CoplanarMerge::number_vertices() {
  out_.tables = in_.tables;
  vertex_number_.resize(in_.vertex_count());
  for (std::uint32_t v = 0; v < in_.vertex_count(); ++v) {
    if (fate_[v] == Fate::Gone || fate_[v] == Fate::Passed) continue;
    vertex_number_[v] = VertexId(out_.vertex_count());
    out_.vertex_point.push_back(in_.vertex_point[v]);
    out_.vertex_mark.push_back(in_.vertex_mark[v]);
    out_.vertex_volume.push_back(in_.vertex_volume[v]);
  }
}

// A chain keeps the planes, the mark and the direction of its first edge.
void CoplanarMerge::make_edges() {
  number_.resize(in_.edge_count());
  for (std::uint32_t e = 0; e < in_.edge_count(); ++e) {
    if (is_flat(EdgeId(e)) || number_[e].is_valid()) continue;
    const EdgeId number(out_.edge_count());
    first_.push_back(EdgeId(e));
    out_.edge_planes.push_back(in_.edge_planes[e]);
    out_.edge_mark.push_back(in_.edge_mark[e]);
    out_.edge_volume.push_back(in_.edge_volume[e]);
    // The chain is followed from its first edge to both ends, because this edge may be in its
    // middle.
    const VertexId to = end_of_chain(HalfedgeId(2 * e), number);
    const VertexId from = end_of_chain(HalfedgeId(2 * e + 1), number);
    out_.origin.push_back(vertex_number_[from]);
    out_.origin.push_back(vertex_number_[to]);
  }
}

/// Numbers the edges of a chain from that of h on, in its direction, and returns the vertex at
/// which it ends.
VertexId CoplanarMerge::end_of_chain(HalfedgeId h, EdgeId number) {
  for (;;) {
    number_[h.value() / 2] = number;
    const VertexId v = in_.target(h);
    if (fate_[v] != Fate::Passed) return v;
    h = other_left(v, SpaceComplex::twin(h));
  }
}

// The uses of the first edge represent a chain. The next use of the result is found by stepping
// over the other edges of the chain.
void CoplanarMerge::make_uses() {
  use_number_.resize(in_.use_count());
  for (std::uint32_t u = 0; u < in_.use_count(); ++u) {
    if (is_flat(UseId(u)) || !stands_for_chain(edge(UseId(u)))) continue;
    use_number_[u] = UseId(out_.use_count());
    const HalfedgeId h = in_.use_halfedge[u];
    const std::uint32_t e = number_[h.value() / 2].value();
    out_.use_halfedge.push_back(HalfedgeId(2 * e + (h.value() & 1U)));
  }
  out_.use_next.resize(out_.use_count());
  out_.use_prev.resize(out_.use_count());
  out_.use_radial.resize(out_.use_count());
  out_.use_facet.resize(out_.use_count());
  for (std::uint32_t u = 0; u < in_.use_count(); ++u) {
    const UseId own = use_number_[u];
    if (!own.is_valid()) continue;
    // Uses of later edges of the same chain have no number of their own and are stepped over.
    UseId next = next_left(UseId(u));
    while (!use_number_[next].is_valid()) next = next_left(next);
    out_.use_next[own] = use_number_[next];
    out_.use_prev[use_number_[next]] = own;
    out_.use_radial[own] = use_number_[in_.use_radial[u]];
  }
  for (const EdgeId e : first_) {
    const UseId use = in_.edge_use[e];
    out_.edge_use.push_back(use.is_valid() ? use_number_[use] : UseId());
  }
}

// Facets are numbered by their least part. Its cycles are traced along use_next; if there are
// several, exactly one of them is outer, and it is moved to the front.
void CoplanarMerge::make_facets() {
  UnionFind& classes = classes_.emplace(in_.facet_count());
  for (std::uint32_t e = 0; e < in_.edge_count(); ++e) {
    if (!is_flat(EdgeId(e))) continue;
    const UseId u = in_.edge_use[e];
    classes.unite(in_.use_facet[u].value(), in_.use_facet[in_.use_radial[u]].value());
  }
  facet_number_.resize(in_.facet_count());
  for (std::uint32_t f = 0; f < in_.facet_count(); ++f) {
    const std::uint32_t root = classes.root(f);
    // The root of each class of UnionFind is its least element, so the root already has its number.
    if (root != f) {
      facet_number_[f] = facet_number_[root];
      continue;
    }
    facet_number_[f] = FacetId(out_.facet_count());
    out_.facet_plane.push_back(in_.facet_plane[f]);
    out_.facet_mark.push_back(in_.facet_mark[f]);
    out_.facet_volume.push_back(in_.facet_volume[f]);
  }
  name_facets();
  std::vector<UseId> first_uses;  // One use of each cycle.
  out_.cycle_begin.assign(out_.facet_count() + 1, 0);
  for (std::uint32_t u = 0; u < in_.use_count(); ++u) {
    const UseId first = use_number_[u];
    if (!first.is_valid() || out_.use_facet[first].is_valid()) continue;
    const FacetId f = facet_number_[in_.use_facet[u]];
    first_uses.push_back(first);
    ++out_.cycle_begin[f.value() + 1];
    for (UseId w = first; !out_.use_facet[w].is_valid(); w = out_.use_next[w]) {
      out_.use_facet[w] = f;
    }
  }
  std::partial_sum(out_.cycle_begin.begin(), out_.cycle_begin.end(), out_.cycle_begin.begin());
  out_.cycle.resize(first_uses.size());
  IdVector<FacetId, std::uint32_t> at(out_.cycle_begin.begin(), out_.cycle_begin.end() - 1);
  for (const UseId u : first_uses) out_.cycle[at[out_.use_facet[u]]++] = u;
  for (std::uint32_t f = 0; f < out_.facet_count(); ++f) {
    const auto begin = out_.cycle.begin() + out_.cycle_begin[f];
    const auto end = out_.cycle.begin() + out_.cycle_begin[f + 1];
    // A facet with one cycle has only the outer cycle, so no sign is needed.
    if (end - begin < 2) continue;
    const auto outer = std::find_if(begin, end, [&](UseId u) { return is_outer(out_, u); });
    PLUMB_CHECK(outer != end);
    std::rotate(begin, outer, outer + 1);
  }
}

/// Gives each facet the least facet_origin of the parts at its corners. These parts are those whose
/// uses leave a kept vertex along a kept edge. Sphere maps would give the same result.
void CoplanarMerge::name_facets() {
  out_.facet_origin.assign(out_.facet_count(), ~std::uint32_t{0});
  for (std::uint32_t u = 0; u < in_.use_count(); ++u) {
    if (is_flat(UseId(u)) || fate_[in_.use_origin(UseId(u))] != Fate::Kept) continue;
    const FacetId piece = in_.use_facet[u];
    std::uint32_t& name = out_.facet_origin[facet_number_[piece]];
    name = std::min(name, in_.facet_origin[piece]);
  }
}

/// Lists the vertices inside of facets in ascending order: the old ones, and those that are now
/// inside.
void CoplanarMerge::gather_inner() {
  out_.vertex_facet.resize(out_.vertex_count());
  for (std::uint32_t v = 0; v < in_.vertex_count(); ++v) {
    const FacetId f = in_.vertex_facet[v];
    if (!f.is_valid()) continue;
    out_.vertex_facet[vertex_number_[v]] = facet_number_[f];
  }
  for (const auto& [v, f] : inside_) {
    out_.vertex_facet[vertex_number_[v]] = facet_number_[f];
  }
  std::vector<std::pair<FacetId, VertexId>> inner;
  for (std::uint32_t v = 0; v < out_.vertex_count(); ++v) {
    if (out_.vertex_facet[v].is_valid()) inner.emplace_back(out_.vertex_facet[v], v);
  }
  std::ranges::sort(inner);
  out_.inner_begin.assign(out_.facet_count() + 1, 0);
  for (const auto& [f, v] : inner) {
    ++out_.inner_begin[f.value() + 1];
    out_.inner.push_back(v);
  }
  std::partial_sum(out_.inner_begin.begin(), out_.inner_begin.end(), out_.inner_begin.begin());
}

namespace {

// The memory of the draft and of the assembled complex.
constexpr std::uint64_t kBytesPerUse = 110;

/// Whether a facet, a free edge or an isolated vertex is superfluous, so that sphere maps are
/// needed.
class MapChanges {
 public:
  explicit MapChanges(const SpaceComplex& complex) : c_(complex) {}

  bool exist() const {
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (has_mark(c_.facet_volume[f][0], c_.facet_mark[f]) &&
          has_mark(c_.facet_volume[f][1], c_.facet_mark[f])) {
        return true;
      }
    }
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (!c_.edge_use[e].is_valid() && has_mark(c_.edge_volume[e], c_.edge_mark[e])) return true;
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.star_of(VertexId(v)).empty() && goes_alone(v)) return true;
    }
    return false;
  }

 private:
  /// Whether the volume has this mark.
  bool has_mark(VolumeId v, Mark mark) const { return c_.volume_mark[v] == mark; }
  /// Whether a vertex without edges has the mark of the cells around it.
  bool goes_alone(std::uint32_t v) const {
    const FacetId f = c_.vertex_facet[v];
    if (f.is_valid()) return c_.facet_mark[f] == c_.vertex_mark[v];
    return has_mark(c_.vertex_volume[v], c_.vertex_mark[v]);
  }

  const SpaceComplex& c_;
};

}  // namespace

SpaceComplex simplified_by_maps(const SpaceComplex& complex, Context& context) {
  MemoryCharge memory(context);
  memory.add(kBytesPerUse * complex.use_count(), "the minimal form");
  SpaceDraft draft(complex.tables);
  SphereOverlay overlay(complex.planes());
  VertexCarrier carrier(complex, draft, overlay);
  LocalMap local;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    if (v % 4096 == 0) context.checkpoint("simplify", v, complex.vertex_count());
    local_map(complex, VertexId(v), local);
    carrier.add_simplified(VertexId(v), local);
  }
  carrier.face_ends();
  SpaceComplex result = assemble(std::move(draft), context);
  if (result.vertex_count() == 0) result.volume_mark[0] = complex.volume_mark[0];
  return result;
}

SpaceComplex simplified(SpaceComplex complex, Context& context) {
  context.checkpoint("simplify", 0, complex.vertex_count());
  if (MapChanges(complex).exist()) return simplified_by_maps(complex, context);
  CoplanarMerge merge(complex, context);
  if (!merge.is_needed()) return complex;
  return merge.run(context);
}

}  // namespace plumb
