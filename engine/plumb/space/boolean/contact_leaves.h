// What the search for contacts (find_contacts.h) is made of: location in facets of many corners by
// slabs, and the leaves of its box trees.
//
// FacetSlabs answers facet_site() for facets of many corners, by a structure that is built once.
//
// Notation, in the plane of the facet
//   height    the coordinate `up`; the place along a column is the coordinate `across`. Both are
//             axes of space that distinguish the points of the plane
//   columns   the different heights of the facet's vertices; slab i lies between columns i and i +
//             1
//
// The slabs are the leaves of a segment tree (M. de Berg et al., Computational Geometry, 3rd
// edition, 2008, section 10.3). An edge that spans all slabs of a node, but not all slabs of its
// parent, is in the list of the node. Each list is in order across: edges do not cross.
//
// Main flow of site():
//  1. column  a binary search finds the column or slab of the point; on a column it looks among the
//             column's vertices and the edges between them
//  2. slab    in the list of each node above the slab (of a column: the slab after it) a binary
//             search finds an edge that holds the point, or else how many edges lie beyond it. If
//             the sum over all nodes is odd, the point is inside
//
// Cost: O(n log^2 n) to build, O(log^2 n) for a point. Memory: 4 bytes n log n, and 40 bytes an
// edge.
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
#include "plumb/space/bounds/occupied_cells.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A point to be located in a complex: a point of its table, or of another table over the same
/// planes.
class PlacedPoint {
 public:
  /// Takes point `at` of `table`; `own` is the table of the complex. Keeps references to both.
  PlacedPoint(const Point3Table& own, const Point3Table& table, SpacePoint at)
      : own_(own), table_(table), at_(at), box_(table.box(at)) {}
  /// Returns the order of a point x of the complex and this point along a coordinate axis.
  Sign compare(SpacePoint x, std::size_t axis) const;
  /// Returns the side of a plane on which the point lies.
  Sign side(PlaneId plane) const { return plumb::side(table_, at_, plane); }

 private:
  const Point3Table& own_;
  const Point3Table& table_;
  SpacePoint at_;
  PointBox box_;
};

/// The slabs of one facet. Immutable after construction, so several threads may ask at once.
class FacetSlabs {
 public:
  /// Builds the slabs. Keeps a reference to the complex, none to the context. Throws the errors of
  /// the Context.
  FacetSlabs(const SpaceComplex& complex, FacetId f, Context& context);

  /// Returns the vertex, edge or facet on which a point lies; invalid if it lies outside. Requires
  /// a point of the facet's plane, as facet_site() does.
  SpaceItem site(const PlacedPoint& x) const;

 private:
  /// An edge use (Weiler) of the facet whose ends have different heights.
  struct Rise {
    VertexId low;              ///< The lower end.
    VertexId high;             ///< The higher end.
    EdgeId edge;               ///< Its edge.
    PlaneId plane;             ///< Another plane through the edge.
    Sign beyond;               ///< The side of that plane that lies beyond the edge, across.
    std::uint32_t first_slab;  ///< The first slab that it spans.
    std::uint32_t end_slab;    ///< One more than the last slab that it spans.
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
  std::vector<VertexId> vertex_;             // All vertices, by height, then across.
  std::vector<std::uint32_t> column_begin_;  // Starts in vertex_, one more than columns.
  std::vector<std::uint32_t> place_;         // The index in vertex_ of each of ascending_.
  std::vector<VertexId> ascending_;          // All vertices, by id.
  std::vector<EdgeId> level_;  // The edge from each of vertex_ to the next one, if any.
  std::vector<Rise> rise_;
  std::vector<std::uint32_t> begin_;  // Starts in entry_, one for each node.
  std::vector<std::uint32_t> entry_;  // Indices of rises, the lists of all nodes.
};

/// Answers facet_site() for many points. A large facet gets slabs once it has been walked around
/// often enough to pay for them. Const members may be called from several threads at once.
class FacetSites {
 public:
  static constexpr std::size_t kFewCorners = 32;  ///< A walk around so few corners is as fast.

  /// Takes the facets of more than kFewCorners corners, ascending. Keeps references to the complex
  /// and to the context, to which slabs are charged.
  FacetSites(const SpaceComplex& complex, std::span<const FacetId> large, Context& context);

  /// Returns the cell of the facet on which a point lies, as facet_site() does. Requires a point of
  /// the complex's tables on the facet's plane. `own` is the context of the caller's job.
  SpaceItem site(FacetId f, SpacePoint x, Context& own) const;
  /// Returns the same for the common point of the facet's plane, p and q, without adding it to a
  /// table of the complex.
  SpaceItem site(FacetId f, PlaneId p, PlaneId q, Context& own) const;

 private:
  /// The state of a large facet. `is_made` is set with release order after `slabs`, so that who
  /// reads it with acquire order may read the slabs without the lock.
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
  std::unique_ptr<Large[]> state_;  // One for each large facet.
};

// The leaves of the box trees of find_contacts(). Every vertex and edge of a complex belongs to one
// leaf, so that it is tested against a cell of the other complex once and not from every facet
// around it.
//
//   facet         one leaf: its surface, with those of its corners and edges that belong to it
//   large facet   one leaf for the surface, and further ones for its corners, eight at a time,
//                 unless nothing there belongs to the facet; likewise a facet with holes
//   free edge     one leaf: the edge, with those of its ends that belong to it
//   vertex        one leaf if it has no edges: isolated or inside a facet
//
// An edge belongs to the facet of edge_use. A vertex belongs to the facet of its first edge with
// facets, else to its first edge. Few leaves meet another leaf. So the items of a leaf are looked
// up only if the leaf meets another leaf (LeafItems).
//
// Cost: O(complex). Memory: about 60 bytes a facet within reach.

/// An edge of a leaf. Its ends are given by their indices among the leaf's vertices.
struct LeafEdge {
  EdgeId edge;        ///< The edge.
  std::uint8_t from;  ///< The origin of half-edge 2 edge.
  std::uint8_t to;    ///< Its target.
  bool is_flat;       ///< Whether it has no two facets in different planes.
};

/// A leaf of a box tree.
struct ContactLeaf {
  FacetId facet;        ///< The facet whose surface belongs to it, or invalid.
  SpaceItem bare;       ///< A free edge or a vertex without edges, or invalid.
  UseId first;          ///< The use of the first corner that it covers.
  std::uint32_t count;  ///< The number of corners that it covers along the cycle.
};

/// The vertices and edges that belong to a leaf.
class LeafItems {
 public:
  static constexpr std::size_t kMostCorners = 8;  ///< The largest number of corners of a leaf.
  static constexpr std::size_t kMostVertices = 3 * kMostCorners;  ///< A bound of its vertices.

  /// Replaces the contents by the contents of a leaf. O(corners, and the degrees of their
  /// vertices).
  void fill(const SpaceComplex& complex, const ContactLeaf& leaf);

  /// Returns the vertices that belong to the leaf, then the other ends of its edges.
  std::span<const VertexId> vertices() const { return std::span(vertices_).first(vertex_count_); }
  /// Returns the vertices that belong to the leaf.
  std::span<const VertexId> own_vertices() const { return std::span(vertices_).first(own_); }
  /// Returns the edges that belong to the leaf.
  std::span<const LeafEdge> edges() const { return std::span(edges_).first(edge_count_); }
  /// Whether one of these edges is flat. Free edges are.
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

/// The leaves of one complex with their boxes.
class ContactLeaves {
 public:
  /// Collects the leaves whose boxes meet the box `reach`. Keeps a reference to the complex. If
  /// `context` is not null, its limits are checked.
  ContactLeaves(const SpaceComplex& complex, const Box3& reach, const Context* context = nullptr);

  /// Drops the leaves whose boxes occupy no cell of `others`. O(leaves).
  void keep_near(const OccupiedCells& others);

  const SpaceComplex& complex() const { return complex_; }
  /// Returns the box of each leaf.
  std::span<const Box3> boxes() const { return boxes_; }
  /// Returns the facets of more than FacetSites::kFewCorners corners, ascending.
  std::span<const FacetId> large_facets() const { return large_facets_; }
  const ContactLeaf& operator[](std::size_t i) const { return leaves_[i]; }

 private:
  class CornerCount;

  void add_facet(FacetId f, CornerCount& count);
  std::uint32_t add_corners(UseId first, CornerCount& count);
  void add(const ContactLeaf& leaf, const Box3& box);

  const SpaceComplex& complex_;
  Box3 reach_;
  std::vector<ContactLeaf> leaves_;
  std::vector<Box3> boxes_;
  std::vector<FacetId> large_facets_;
};

/// Keeps the items of the leaves that were asked for last, one for each of 64 residues of their
/// indices: a descent of two trees asks for the same leaves again and again.
class LeafCache {
 public:
  /// Starts empty. Keeps a reference to the leaves.
  explicit LeafCache(const ContactLeaves& leaves) : leaves_(leaves) { known_.fill(kNone); }

  /// Returns the items of a leaf, valid until the next call.
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

  const ContactLeaves& leaves_;
  std::array<std::size_t, kPlaces> known_;
  std::array<LeafItems, kPlaces> items_;
};

}  // namespace plumb
