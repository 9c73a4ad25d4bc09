// facet_site() for facets of many corners, by a structure that is built once.
//
// Notation, in the plane of the facet
//   height    the coordinate `up`, place along it `across`: two axes of space that tell points of
//             the plane apart
//   columns   the different heights of the facet's vertices; slab i lies between columns i and i +
//             1
//
// The slabs are the leaves of a segment tree; an edge that spans the slabs of a node, and not those
// of its parent, is in the list of the node, in order across: edges do not cross.
//
// Main flow of site():
//  1. binary search for the column or slab; on a column, among its vertices and the edges between
//     them
//  2. in the list of each node above the slab (of a column, the slab after it) a binary search: an
//     edge that holds the point, or else how many lie beyond it. An odd number of all: inside
//
// Cost: O(n log^2 n) to build, O(log^2 n) a point; 4 bytes n log n besides 40 an edge.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A point among those of a complex: of its table, or of another one over the same planes.
class PlacedPoint {
 public:
  PlacedPoint(const Point3Table& own, const Point3Table& table, SpacePoint at)
      : own_(own), table_(table), at_(at), box_(table.box(at)) {}
  /// The order of a point of the complex and this one along a coordinate axis.
  Sign compare(SpacePoint x, std::size_t axis) const;
  Sign side(PlaneId plane) const { return plumb::side(table_, at_, plane); }

 private:
  const Point3Table& own_;
  const Point3Table& table_;
  SpacePoint at_;
  PointBox box_;
};

class FacetSlabs {
 public:
  /// Throws what the context's checkpoints throw; it is not kept.
  FacetSlabs(const SpaceComplex& complex, FacetId f, Context& context);

  /// As facet_site(): requires a point of the facet's plane.
  SpaceItem site(const PlacedPoint& x) const;

 private:
  /// A use that is not level.
  struct Rise {
    VertexId low;
    VertexId high;
    EdgeId edge;
    PlaneId plane;  ///< another plane through it
    Sign beyond;    ///< the side of that plane that lies beyond the edge, across
    std::uint32_t first_slab;
    std::uint32_t end_slab;
  };

  void make_columns(Context& context);
  void add_use(UseId u);
  void fill_lists(Context& context);
  template <class Visit>
  void for_nodes(const Rise& rise, const Visit& visit) const;
  std::uint32_t place_of(VertexId v) const;
  std::uint32_t column_of(std::uint32_t place) const;
  bool is_before(const Rise& e, const Rise& f) const;
  Sign beyond(const Rise& e, VertexId v) const;
  SpaceItem on_column(std::size_t column, const PlacedPoint& x) const;
  SpaceItem in_slab(std::size_t slab, const PlacedPoint& x) const;
  std::size_t slab_count() const { return column_begin_.size() - 2; }
  std::span<const std::uint32_t> list(std::size_t node) const {
    return std::span(entry_).subspan(begin_[node], begin_[node + 1] - begin_[node]);
  }

  const SpaceComplex& complex_;
  FacetId facet_;
  std::size_t up_ = 0;
  std::size_t across_ = 0;
  std::vector<VertexId> vertex_;             // by height, then across
  std::vector<std::uint32_t> column_begin_;  // one more than columns, into vertex_
  std::vector<std::uint32_t> place_;         // of the vertices in ascending order in vertex_
  std::vector<VertexId> ascending_;
  std::vector<EdgeId> level_;  // per vertex of vertex_: an edge to the next one
  std::vector<Rise> rise_;
  std::vector<std::uint32_t> begin_;  // per node, into entry_
  std::vector<std::uint32_t> entry_;  // numbers of rises
};

/// facet_site() of many points: large facets get slabs once they have been walked around often
/// enough to pay for them. Const members may be called from many threads.
class FacetSites {
 public:
  static constexpr std::size_t kFewCorners = 32;  ///< a walk is as quick

  /// `large`, ascending: facets of more corners. Keeps references to the complex and to the
  /// context, which slabs are charged to.
  FacetSites(const SpaceComplex& complex, std::span<const FacetId> large, Context& context);

  /// Of a point of the complex's tables that lies on the facet's plane. `own` is the context of the
  /// caller's job.
  SpaceItem site(FacetId f, SpacePoint x, Context& own) const;
  /// Of the common point of the facet's plane, p and q.
  SpaceItem site(FacetId f, PlaneId p, PlaneId q, Context& own) const;

 private:
  struct Large {
    std::atomic<std::uint32_t> walks{0};
    std::atomic<bool> is_made{false};
    std::mutex making;
    std::optional<MemoryCharge> memory;
    std::optional<FacetSlabs> slabs;
  };
  const FacetSlabs* slabs_of(FacetId f, Context& own) const;
  void make(FacetId f, Large& large, Context& own) const;

  const SpaceComplex& complex_;
  Context& context_;
  std::vector<FacetId> large_;
  std::unique_ptr<Large[]> state_;  // per large facet
};

// What the box trees of meet() are made of. Every vertex and edge of a complex belongs to one leaf,
// so that it is tested against an item of the other complex once and not from every facet around
// it.
//
//   facet         its surface, with those of its corners and edges that are its own
//   large facet   one leaf for the surface, further ones for its corners, eight at a time, where
//                 something is their own; so it is with holes
//   free edge     with those of its ends that are its own
//   vertex        isolated or inside a facet
//
// An edge belongs to the facet of edge_use, a vertex to that of its first edge with facets, else to
// its first edge. Few leaves ever meet another one: what is a leaf's own is looked up when it does
// (LeafItems).
//
// Cost: O(complex). Memory: about 60 bytes a facet within reach.

/// An edge of a leaf; its ends by their place among the leaf's vertices.
struct LeafEdge {
  EdgeId edge;
  std::uint8_t from;
  std::uint8_t to;
  bool is_flat;  ///< it has no two facets in different planes
};

struct MeetLeaf {
  FacetId facet;        ///< the surface; invalid: none
  SpaceItem bare;       ///< a free edge or a vertex without facets; else invalid
  UseId first;          ///< corners: of this use ...
  std::uint32_t count;  ///< ... and those that follow it, so many in all
};

/// The vertices and edges that belong to a leaf.
class LeafItems {
 public:
  static constexpr std::size_t kMostCorners = 8;
  static constexpr std::size_t kMostVertices = 3 * kMostCorners;

  void fill(const SpaceComplex& complex, const MeetLeaf& leaf);

  /// Those that belong to the leaf, then the other ends of its edges.
  std::span<const VertexId> vertices() const { return std::span(vertices_).first(vertex_count_); }
  std::span<const VertexId> own_vertices() const { return std::span(vertices_).first(own_); }
  std::span<const LeafEdge> edges() const { return std::span(edges_).first(edge_count_); }
  bool has_flat_edges() const { return has_flat_edges_; }

 private:
  void take_bare(const SpaceComplex& complex, SpaceItem bare);
  void take_vertex(VertexId v);
  void take_edge(const SpaceComplex& complex, EdgeId e, bool is_flat);
  std::uint8_t place_of(VertexId v);

  std::array<VertexId, kMostVertices> vertices_;
  std::array<LeafEdge, kMostCorners> edges_;
  std::size_t own_ = 0;
  std::size_t vertex_count_ = 0;
  std::size_t edge_count_ = 0;
  bool has_flat_edges_ = false;
};

class MeetLeaves {
 public:
  /// Of what the box `reach` meets. Keeps a reference to the complex.
  MeetLeaves(const SpaceComplex& complex, const Box3& reach);

  const SpaceComplex& complex() const { return complex_; }
  std::span<const Box3> boxes() const { return boxes_; }
  /// Of more than FacetSites::kFewCorners corners; ascending.
  std::span<const FacetId> large_facets() const { return large_facets_; }
  const MeetLeaf& operator[](std::size_t i) const { return leaves_[i]; }

 private:
  void add_facet(FacetId f);
  std::uint32_t add_corners(UseId first);
  void add(const MeetLeaf& leaf, const Box3& box);

  const SpaceComplex& complex_;
  Box3 reach_;
  std::vector<MeetLeaf> leaves_;
  std::vector<Box3> boxes_;
  std::vector<FacetId> large_facets_;
};

/// The items of the leaves that were asked for last.
class LeafCache {
 public:
  explicit LeafCache(const MeetLeaves& leaves) : leaves_(leaves) { known_.fill(kNone); }

  /// Valid until the next call.
  const LeafItems& operator[](std::size_t leaf) {
    const std::size_t place = leaf % kPlaces;
    if (known_[place] != leaf) {
      known_[place] = leaf;
      items_[place].fill(leaves_.complex(), leaves_[leaf]);
    }
    return items_[place];
  }

 private:
  static constexpr std::size_t kPlaces = 64;
  static constexpr std::size_t kNone = ~std::size_t{0};

  const MeetLeaves& leaves_;
  std::array<std::size_t, kPlaces> known_;
  std::array<LeafItems, kPlaces> items_;
};

}  // namespace plumb
