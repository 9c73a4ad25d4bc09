// Location of points in large facets by slabs, and the leaves of the box trees of find_contacts().
//
// Slabs: between two neighbouring heights of vertices, no edge of the facet begins or ends. So the
// edges have one order along the axis across the heights, and a point is inside the facet if and
// only if an odd number of edges lies beyond it. A segment tree over the slabs stores each edge
// O(log n) times instead of once in every slab that it spans. Two edges in one list span a common
// slab. Their order is decided at the later of their lower ends. If this gives a tie, it is decided
// at the earlier of their higher ends. Two different edges share at most one end, so there is no
// tie at both.
//
// Every comparison is exact: heights by compare_axis(), sides by another plane through the edge,
// which exists because an edge has two planes. A point of another table is compared by its box
// first, then by copying both points to one table.
//
// Leaves: see the header. Invariant: every vertex and edge within reach belongs to exactly one
// leaf; owner() and edge_use decide to which.
//
// Tested by tests/space/facet_site_test.cpp (slabs) and tests/space/find_contacts_test.cpp
// (leaves).

#include "plumb/space/boolean/contact_leaves.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/planar/facet_site.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {

// For the exact comparison, both points must be in one table. Input points are in every table over
// the same planes.
Sign PlacedPoint::compare(SpacePoint x, std::size_t axis) const {
  if (&own_ == &table_) return compare_axis(own_, x, at_, axis);
  // In nearly all cases, the boxes in both tables decide.
  const FilteredSign s = rung::compare_axis_filter(own_.box(x), box_, axis);
  if (is_decided(s)) return decide(Predicate::CompareAxis, Rung::Filter, s);
  Point3Table both(own_.planes());
  const auto copied = [&both](const Point3Table& from, SpacePoint p) {
    return p.is_input() ? p : both.add(from.source(p), from.box(p));
  };
  const SpacePoint first = copied(own_, x), second = copied(table_, at_);
  return compare_axis(both, first, second, axis);
}

FacetSlabs::FacetSlabs(const SpaceComplex& complex, FacetId f, Context& context)
    : complex_(complex), facet_(f) {
  const FlatView view = FlatView::of_plane(complex.planes(), complex.facet_plane[f]);
  across_ = view.coordinate(0);
  up_ = view.coordinate(1);
  make_columns(context);
  level_.resize(vertex_.size());
  for (const UseId first : complex.cycles_of(f)) {
    UseId u = first;
    do {
      add_use(u);
      u = complex.use_next[u];
    } while (u != first);
  }
  fill_lists(context);
}

// ---------------------------------------------------------------- building

// Sorts the vertices exactly by height, and then by the coordinate across. A new column begins
// wherever the height changes.
void FacetSlabs::make_columns(Context& context) {
  const auto inner = complex_.inner_of(facet_);
  ascending_.assign(inner.begin(), inner.end());
  for (const UseId first : complex_.cycles_of(facet_)) {
    UseId u = first;
    do {
      ascending_.push_back(complex_.use_origin(u));
      u = complex_.use_next[u];
    } while (u != first);
  }
  std::sort(ascending_.begin(), ascending_.end());
  ascending_.erase(std::unique(ascending_.begin(), ascending_.end()), ascending_.end());
  const auto order = [this](VertexId v, VertexId w, std::size_t axis) {
    return compare_axis(complex_.points(), complex_.vertex_point[v], complex_.vertex_point[w],
                        axis);
  };
  vertex_ = ascending_;
  std::uint64_t compared = 0;
  std::sort(vertex_.begin(), vertex_.end(), [&](VertexId v, VertexId w) {
    if (++compared % 4096 == 0) context.checkpoint("slabs of a facet", 0, 0);
    const Sign height = order(v, w, up_);
    return (height != Sign::Zero ? height : order(v, w, across_)) == Sign::Negative;
  });
  // The array place_ is the inverse of the sorting permutation, so that a use finds its columns by
  // the ids of its ends.
  place_.resize(vertex_.size());
  for (std::uint32_t i = 0; i < vertex_.size(); ++i) {
    if (i == 0 || order(vertex_[i - 1], vertex_[i], up_) != Sign::Zero) column_begin_.push_back(i);
    place_[static_cast<std::size_t>(std::ranges::lower_bound(ascending_, vertex_[i]) -
                                    ascending_.begin())] = i;
  }
  column_begin_.push_back(static_cast<std::uint32_t>(vertex_.size()));
}

/// Returns the index of a vertex in vertex_.
std::uint32_t FacetSlabs::place_of(VertexId v) const {
  return place_[static_cast<std::size_t>(std::ranges::lower_bound(ascending_, v) -
                                         ascending_.begin())];
}

/// Returns the column of an index in vertex_.
std::uint32_t FacetSlabs::column_of(std::uint32_t place) const {
  return static_cast<std::uint32_t>(std::ranges::upper_bound(column_begin_, place) -
                                    column_begin_.begin() - 1);
}

// Seen from the positive side, the facet is to the left of an edge use. To the left of an edge that
// leads upward are the points that precede it across. Therefore the turn of the other plane about
// the use determines the side beyond the edge. The sign is flipped if the use leads downward or
// along half-edge 2e + 1.
void FacetSlabs::add_use(UseId u) {
  const HalfedgeId h = complex_.use_halfedge[u];
  std::uint32_t from = place_of(complex_.origin[h]), to = place_of(complex_.target(h));
  const EdgeId e = SpaceComplex::edge_of(h);
  // No vertices lie inside of edges, so these are neighbours.
  if (column_of(from) == column_of(to)) {
    level_[std::min(from, to)] = e;
    return;
  }
  // The edge spans the slabs between the columns of its ends.
  const OtherPlane other = other_plane(complex_, e, complex_.facet_plane[facet_]);
  const bool runs_up = from < to;
  if (!runs_up) std::swap(from, to);
  const Sign right = SpaceComplex::is_reverse(h) == runs_up ? -other.turn : other.turn;
  rise_.push_back(
      {vertex_[from], vertex_[to], e, other.plane, right, column_of(from), column_of(to)});
}

/// Calls visit(node) for the nodes whose slabs the edge spans, but not all of their parents'. Leaf
/// i is node slab_count() + i, the parent of node k is k / 2. At most 2 log2(slabs) nodes.
template <class Visit>
void FacetSlabs::for_nodes(const Rise& rise, const Visit& visit) const {
  std::size_t first = rise.first_slab + slab_count(), end = rise.end_slab + slab_count();
  for (; first < end; first /= 2, end /= 2) {
    if (first % 2 == 1) visit(first++);
    if (end % 2 == 1) visit(--end);
  }
}

// Counts the entries of each node, places them, then sorts each list across.
void FacetSlabs::fill_lists(Context& context) {
  begin_.assign(2 * slab_count() + 1, 0);
  for (const Rise& rise : rise_) {
    for_nodes(rise, [this](std::size_t node) { ++begin_[node + 1]; });
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  entry_.resize(begin_.back());
  std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t i = 0; i < rise_.size(); ++i) {
    for_nodes(rise_[i], [&](std::size_t node) { entry_[at[node]++] = i; });
  }
  std::uint64_t compared = 0;
  for (std::size_t node = 0; node + 1 < begin_.size(); ++node) {
    std::sort(entry_.begin() + begin_[node], entry_.begin() + begin_[node + 1],
              [&](std::uint32_t i, std::uint32_t j) {
                if (++compared % 4096 == 0) context.checkpoint("slabs of a facet", 0, 0);
                return i != j && is_before(rise_[i], rise_[j]);
              });
  }
}

/// Returns where a vertex of the facet lies from an edge: Positive if beyond it, across.
Sign FacetSlabs::beyond(const Rise& e, VertexId v) const {
  if (v == e.low || v == e.high) return Sign::Zero;
  return e.beyond * side(complex_.points(), complex_.vertex_point[v], e.plane);
}

/// Whether e precedes f across. Requires two edges that span a common slab. Of their two lower
/// ends, the later one is at the height of a point of the other edge, so its side of that edge
/// decides. If it lies on that edge, both edges begin at the same vertex, and the earlier one of
/// the higher ends decides.
bool FacetSlabs::is_before(const Rise& e, const Rise& f) const {
  Sign order = e.first_slab >= f.first_slab ? -beyond(f, e.low) : beyond(e, f.low);
  if (order == Sign::Zero) {
    order = e.end_slab <= f.end_slab ? -beyond(f, e.high) : beyond(e, f.high);
  }
  return order == Sign::Positive;
}

// ---------------------------------------------------------------- queries

// A point on a column that is not a vertex and not on a level edge is located in the slab after the
// column. An edge through the point spans that slab, and the number of edges beyond the point is
// the number of edges beyond the points directly above it.
SpaceItem FacetSlabs::site(const PlacedPoint& x) const {
  const auto below = [&](std::uint32_t place) {
    return x.compare(complex_.vertex_point[vertex_[place]], up_);
  };
  const auto columns = std::span(column_begin_).first(column_begin_.size() - 1);
  const auto next = std::partition_point(columns.begin(), columns.end(), [&](std::uint32_t place) {
    return below(place) == Sign::Negative;
  });
  // `next` is the first column that is not below the point. The point is on this column, or in the
  // slab before it.
  auto column = static_cast<std::size_t>(next - columns.begin());
  if (next != columns.end() && below(*next) == Sign::Zero) {
    if (const SpaceItem item = on_column(column, x); item.is_valid()) return item;
    ++column;
  }
  return column == 0 || column > slab_count() ? SpaceItem() : in_slab(column - 1, x);
}

/// Returns the vertex or level edge of a column on which the point lies, or an invalid item.
SpaceItem FacetSlabs::on_column(std::size_t column, const PlacedPoint& x) const {
  const auto before = [&](VertexId v) { return x.compare(complex_.vertex_point[v], across_); };
  const auto begin = vertex_.begin() + column_begin_[column];
  const auto end = vertex_.begin() + column_begin_[column + 1];
  const auto at =
      std::partition_point(begin, end, [&](VertexId v) { return before(v) == Sign::Negative; });
  if (at != end && before(*at) == Sign::Zero) return *at;
  if (at == begin || at == end) return {};
  // The point lies between two neighbouring vertices of the column; a level edge may join them.
  const EdgeId e = level_[static_cast<std::size_t>(at - vertex_.begin()) - 1];
  return e.is_valid() ? SpaceItem(e) : SpaceItem();
}

/// Returns the edge of a slab on which the point lies, or the facet if the point lies inside, or an
/// invalid item. In each list, the point lies beyond the first edges, which are counted, and before
/// the others.
SpaceItem FacetSlabs::in_slab(std::size_t slab, const PlacedPoint& x) const {
  std::size_t beyond = 0;
  for (std::size_t node = slab + slab_count(); node > 0; node /= 2) {
    const auto edges = list(node);
    const auto side_of = [&](std::uint32_t i) { return rise_[i].beyond * x.side(rise_[i].plane); };
    // The sign Positive means that the point lies beyond the edge. In the order across, these edges
    // come first.
    const auto at = std::partition_point(
        edges.begin(), edges.end(), [&](std::uint32_t i) { return side_of(i) == Sign::Positive; });
    if (at != edges.end() && side_of(*at) == Sign::Zero) return rise_[*at].edge;
    beyond += static_cast<std::size_t>(edges.end() - at);
  }
  return beyond % 2 == 1 ? SpaceItem(facet_) : SpaceItem();
}

// ---------------------------------------------------------------- many facets

FacetSites::FacetSites(const SpaceComplex& complex, std::span<const FacetId> large,
                       Context& context)
    : complex_(complex),
      context_(context),
      large_(large.begin(), large.end()),
      state_(std::make_unique<Large[]>(large.size())) {}

/// Returns the slabs of a facet. Returns null for small facets. For other facets, returns null as
/// long as the walks so far took less time than the slabs would take.
const FacetSlabs* FacetSites::slabs_of(FacetId f, Context& own) const {
  constexpr std::uint32_t kWalks = 48;
  const auto at = std::ranges::lower_bound(large_, f);
  if (at == large_.end() || *at != f) return nullptr;
  Large& large = state_[static_cast<std::size_t>(at - large_.begin())];
  if (large.walks.load(std::memory_order_relaxed) < kWalks) {
    large.walks.fetch_add(1, std::memory_order_relaxed);
    return nullptr;
  }
  if (!large.is_made.load(std::memory_order_acquire)) make(f, large, own);
  return &*large.slabs;
}

/// Builds the slabs, unless another thread has built them in the meantime. If this throws, the next
/// caller tries again.
void FacetSites::make(FacetId f, Large& large, Context& own) const {
  const std::lock_guard lock(large.making);
  if (large.slabs) return;
  std::uint64_t corners = complex_.inner_of(f).size();
  for (const UseId first : complex_.cycles_of(f)) {
    UseId u = first;
    do {
      ++corners;
      u = complex_.use_next[u];
    } while (u != first);
  }
  const auto levels = static_cast<std::uint64_t>(std::bit_width(corners));
  large.memory.emplace(context_).add(corners * (100 + 8 * levels), "slabs of a facet");
  large.slabs.emplace(complex_, f, own);
  large.is_made.store(true, std::memory_order_release);
}

SpaceItem FacetSites::site(FacetId f, SpacePoint x, Context& own) const {
  const FacetSlabs* slabs = large_.empty() ? nullptr : slabs_of(f, own);
  if (slabs == nullptr) return facet_site(complex_, f, x);
  return slabs->site(PlacedPoint(complex_.points(), complex_.points(), x));
}

// The point is made in a separate table, because this code runs in several threads, and most of the
// points are not needed later.
SpaceItem FacetSites::site(FacetId f, PlaneId p, PlaneId q, Context& own) const {
  const FacetSlabs* slabs = large_.empty() ? nullptr : slabs_of(f, own);
  if (slabs == nullptr) return facet_site(complex_, f, p, q);
  Point3Table crossing(complex_.planes());
  const SpacePoint x = crossing.add(p, q, complex_.facet_plane[f]);
  return slabs->site(PlacedPoint(complex_.points(), crossing, x));
}

// ---------------------------------------------------------------- leaves

/// Counts corners, and checks the limits of a context after each few thousand corners.
class ContactLeaves::CornerCount {
 public:
  explicit CornerCount(const Context* context) : context_(context) {}

  void add() {
    constexpr std::size_t kCornersPerCheck = 8192;
    if (++count_ % kCornersPerCheck == 0 && context_ != nullptr)
      context_->check_limits("box trees");
  }

 private:
  const Context* context_;
  std::size_t count_ = 0;
};

ContactLeaves::ContactLeaves(const SpaceComplex& complex, const Box3& reach, const Context* context)
    : complex_(complex), reach_(reach) {
  CornerCount count(context);
  leaves_.reserve(complex.facet_count());
  boxes_.reserve(complex.facet_count());
  for (std::size_t f = 0; f < complex.facet_count(); ++f) add_facet(FacetId(f), count);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.edge_use[e].is_valid()) continue;
    add({FacetId(), EdgeId(e), UseId(), 0}, box_of(complex, EdgeId(e)));
  }
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    if (!complex.star_of(VertexId(v)).empty()) continue;
    add({FacetId(), VertexId(v), UseId(), 0}, box_of(complex, VertexId(v)));
  }
  leaves_.shrink_to_fit();
  boxes_.shrink_to_fit();
}

// The whole facet lies in the box of its outer cycle.
void ContactLeaves::add_facet(FacetId f, CornerCount& count) {
  const std::span<const UseId> cycles = complex_.cycles_of(f);
  if (cycles.empty()) return;
  Box3 box;
  std::uint32_t corners = 0;
  UseId u = cycles.front();
  do {
    add_point(complex_.points(), complex_.vertex_point[complex_.use_origin(u)], box);
    ++corners;
    count.add();
    u = complex_.use_next[u];
  } while (u != cycles.front());
  if (!box.meets(reach_)) return;
  // A facet with few corners is one leaf. Any other facet has one leaf for its surface, and leaves
  // for some of its corners.
  if (cycles.size() == 1 && corners <= LeafItems::kMostCorners) {
    return add({f, SpaceItem(), u, corners}, box);
  }
  add({f, SpaceItem(), UseId(), 0}, box);
  // Inner vertices of the facet are not corners. They have their own leaves, or belong to their
  // edges.
  corners = 0;
  for (const UseId first : cycles) corners += add_corners(first, count);
  if (corners > FacetSites::kFewCorners) large_facets_.push_back(f);
}

/// Adds leaves for the corners of one cycle, eight at a time, and returns how many corners it has,
/// whether they belong to these leaves or not.
std::uint32_t ContactLeaves::add_corners(UseId first, CornerCount& count) {
  LeafItems items;
  std::uint32_t corners = 0;
  UseId u = first;
  do {
    ContactLeaf leaf{FacetId(), SpaceItem(), u, 0};
    Box3 box = box_of(complex_, complex_.use_origin(u));
    do {
      u = complex_.use_next[u];
      box.add(box_of(complex_, complex_.use_origin(u)));
      ++leaf.count;
      count.add();
    } while (u != first && leaf.count < LeafItems::kMostCorners);
    corners += leaf.count;
    items.fill(complex_, leaf);
    // If there are no vertices, all cells belong to neighbours.
    if (!items.vertices().empty()) add(leaf, box);
  } while (u != first);
  return corners;
}

void ContactLeaves::keep_near(const OccupiedCells& others) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    if (!others.may_meet(boxes_[i])) continue;
    leaves_[count] = leaves_[i];
    boxes_[count++] = boxes_[i];
  }
  leaves_.resize(count);
  boxes_.resize(count);
}

void ContactLeaves::add(const ContactLeaf& leaf, const Box3& box) {
  if (!box.meets(reach_)) return;
  leaves_.push_back(leaf);
  boxes_.push_back(box);
}

// ---------------------------------------------------------------- items of a leaf

namespace {

/// Whether all facets around the edge of a use lie in one plane.
bool is_flat(const SpaceComplex& complex, UseId u) {
  const PlaneId plane = complex.facet_plane[complex.use_facet[u]];
  for (UseId v = complex.use_radial[u]; v != u; v = complex.use_radial[v]) {
    if (complex.facet_plane[complex.use_facet[v]] != plane) return false;
  }
  return true;
}

/// Returns the use that begins at the vertex and whose leaf contains the vertex. It is invalid if
/// the vertex has only free edges.
UseId owner(const SpaceComplex& complex, VertexId v) {
  for (const HalfedgeId h : complex.star_of(v)) {
    const UseId u = complex.edge_use[SpaceComplex::edge_of(h)];
    if (!u.is_valid()) continue;
    return complex.use_halfedge[u] == h ? u : complex.use_next[u];
  }
  return UseId();
}

}  // namespace

// Vertices are stored first, so that own_vertices() is a prefix of vertices().
void LeafItems::fill(const SpaceComplex& complex, const ContactLeaf& leaf) {
  own_ = vertex_count_ = edge_count_ = 0;
  has_flat_edges_ = false;
  if (leaf.bare.is_valid()) return take_bare(complex, leaf.bare);
  UseId u = leaf.first;
  for (std::uint32_t i = 0; i < leaf.count; ++i, u = complex.use_next[u]) {
    const VertexId v = complex.use_origin(u);
    if (owner(complex, v) == u) take_vertex(v);
  }
  u = leaf.first;
  for (std::uint32_t i = 0; i < leaf.count; ++i, u = complex.use_next[u]) {
    const EdgeId e = SpaceComplex::edge_of(complex.use_halfedge[u]);
    if (complex.edge_use[e] == u) take_edge(complex, e, is_flat(complex, u));
  }
}

/// Adds a free edge with the ends whose first half-edge it is, or adds a vertex.
void LeafItems::take_bare(const SpaceComplex& complex, SpaceItem bare) {
  if (bare.kind() == SpaceItem::Kind::Vertex) return take_vertex(bare.vertex());
  for (const std::uint32_t h : {2 * bare.index(), 2 * bare.index() + 1}) {
    const VertexId v = complex.origin[h];
    const bool is_own = complex.star_of(v).front() == HalfedgeId(h);
    if (is_own && !owner(complex, v).is_valid()) take_vertex(v);
  }
  take_edge(complex, bare.edge(), true);
}

void LeafItems::take_vertex(VertexId v) {
  vertices_[vertex_count_++] = v;
  ++own_;
}

void LeafItems::take_edge(const SpaceComplex& complex, EdgeId e, bool is_flat) {
  const std::uint8_t from = place_of(complex.origin[2 * e.value()]);
  const std::uint8_t to = place_of(complex.origin[2 * e.value() + 1]);
  edges_[edge_count_++] = {e, from, to, is_flat};
  has_flat_edges_ |= is_flat;
}

/// Returns the index of a vertex among vertices(). A new vertex is appended.
std::uint8_t LeafItems::place_of(VertexId v) {
  const auto known = vertices();
  const auto place = static_cast<std::size_t>(std::ranges::find(known, v) - known.begin());
  if (place == vertex_count_) vertices_[vertex_count_++] = v;
  return static_cast<std::uint8_t>(place);
}

}  // namespace plumb
