// Finds the volumes of a complex: classes of sides of facets, then rays of pieces.
//
// Two sides bound the same volume near an edge if they follow each other in radial order, and near
// a vertex if they bound one face of its sphere map. If the map is connected, the first rule unites
// all sides that the second rule would unite. So maps are made only at irregular vertices: vertices
// whose map is not connected, has a loop, or has points without arcs. A vertex whose corners make
// one ring through all edges, as nearly all do, is recognized by walking around it.
//
// Invariant (docs/design/boolean.md, Lemmas 6 and 7): a class is one shell, the whole boundary of a
// volume on one piece; at most one shell of a volume has it on an inner side of its piece. So
// uniting the outer shell of every piece with what its ray hits gives the volumes.
//
// Tested by tests/space/mesh_arrangement_test.cpp, tests/space/space_locator_test.cpp and
// tests/io/nef3_reader_test.cpp.

#include "plumb/space/query/volumes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "plumb/base/internal/box_tree.h"
#include "plumb/base/internal/parallel.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_locator.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

namespace {

/// Checks the limits of a context, unless it is null, at some steps i of a loop.
void check_at(std::size_t i, const Context* context) {
  constexpr std::size_t kStepsPerCheck = 16'384;
  if (i % kStepsPerCheck == 0 && context != nullptr) context->check_limits("volumes");
}

}  // namespace

ShellNodes::ShellNodes(const SpaceComplex& complex, std::span<const std::uint8_t> connected,
                       const Context* context)
    : complex_(complex),
      classes_(2 * complex.facet_count() + complex.vertex_count()),
      free_node_(complex.edge_count(), kNone) {
  unite_around_edges(context);
  unite_at_irregular_vertices(connected, context);
}

/// Unites the side after each use with the side before the next use.
void ShellNodes::unite_around_edges(const Context* context) {
  for (std::uint32_t u = 0; u < complex_.use_count(); ++u) {
    check_at(u, context);
    classes_.unite(node_after(UseId(u)), node_before(complex_.use_radial[u]));
  }
}

namespace {

/// Returns the number of consecutive corners around the vertex from `first` on, across edges with
/// two facets. Returns a number greater than `most` if there are more corners, or if an edge has
/// another number of facets.
std::size_t count_corners(const SpaceComplex& complex, UseId first, std::size_t most) {
  std::size_t count = 0;
  UseId corner = first;
  // The edge across which the walk leaves the corner: the edge of its use, or otherwise the edge
  // before.
  HalfedgeId over = complex.use_halfedge[corner];
  do {
    const UseId own = complex.use_halfedge[corner] == over ? corner : complex.use_prev[corner];
    // The edge must have exactly two uses. The walk crosses it to the other facet.
    const UseId other = complex.use_radial[own];
    if (complex.use_radial[other] != own || other == own || ++count > most) return most + 1;
    const bool leaves = complex.use_halfedge[other] == over;
    corner = leaves ? other : complex.use_next[other];
    const HalfedgeId at_end = complex.use_halfedge[corner];
    over = leaves ? SpaceComplex::twin(complex.use_halfedge[complex.use_prev[corner]]) : at_end;
  } while (corner != first);
  return count;
}

}  // namespace

bool has_one_ring(const SpaceComplex& complex, VertexId v) {
  const auto star = complex.star_of(v);
  if (star.empty() || complex.vertex_facet[v].is_valid()) return false;
  const UseId use = complex.edge_use[star[0].value() / 2];
  if (!use.is_valid()) return false;
  const UseId corner = complex.use_halfedge[use] == star[0] ? use : complex.use_next[use];
  return count_corners(complex, corner, star.size()) == star.size();
}

/// Returns the vertices whose sphere map is not connected, has a loop or has points without arcs.
/// For vertices without a single ring, one union-find over all corners decides.
std::vector<VertexId> ShellNodes::irregular_vertices(std::span<const std::uint8_t> connected,
                                                     const Context* context) const {
  std::vector<VertexId> doubtful, irregular;
  for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
    check_at(v, context);
    if (!connected.empty() && connected[v] != 0) continue;
    if (!has_one_ring(complex_, VertexId(v))) doubtful.push_back(VertexId(v));
  }
  if (doubtful.empty()) return irregular;
  UnionFind link(complex_.origin.size());  // The half-edges of a vertex, joined by corners.
  for (std::uint32_t u = 0; u < complex_.use_count(); ++u) {
    check_at(u, context);
    const HalfedgeId back = SpaceComplex::twin(complex_.use_halfedge[complex_.use_prev[u]]);
    link.unite(complex_.use_halfedge[u].value(), back.value());
  }
  for (const VertexId v : doubtful) {
    const auto star = complex_.star_of(v);
    bool is_regular = !star.empty() && !complex_.vertex_facet[v].is_valid() &&
                      complex_.edge_use[star[0].value() / 2].is_valid();
    for (std::size_t i = 1; i < star.size() && is_regular; ++i) {
      is_regular = link.root(star[i].value()) == link.root(star[0].value());
    }
    if (!is_regular) irregular.push_back(v);
  }
  return irregular;
}

void ShellNodes::face_nodes(const LocalMap& local, SpaceItem item,
                            std::vector<std::uint32_t>& node) const {
  std::uint32_t own = kNone;
  if (item.kind() == SpaceItem::Kind::Vertex) own = vertex_node(item.vertex());
  if (item.kind() == SpaceItem::Kind::Edge) own = free_node(item.edge());
  node.assign(local.map.face_count(), own);
  for (std::uint32_t h = 0; h < local.map.face.size(); ++h) {
    node[local.map.face[h]] = facet_node(local.facet[h / 2], (h & 1U) != 0);
  }
}

/// Unites the nodes in every face of the map of an irregular vertex, including free edges.
void ShellNodes::unite_at_irregular_vertices(std::span<const std::uint8_t> connected,
                                             const Context* context) {
  LocalMap local;
  std::vector<std::uint32_t> node;
  for (const VertexId v : irregular_vertices(connected, context)) {
    // The map of a vertex takes longer than other steps.
    if (context != nullptr) context->check_limits("volumes");
    local_map(complex_, v, local);
    face_nodes(local, v, node);
    for (std::uint32_t h = 0; h < local.map.face.size(); ++h) {
      classes_.unite(node[local.map.face[h]], facet_node(local.facet[h / 2], (h & 1U) != 0));
    }
    // At both ends, a free edge has the node of the face that contains its point.
    for (std::size_t i = 0; i < local.halfedge.size(); ++i) {
      if (local.map.first_out[i] != kNone) continue;
      std::uint32_t& known = free_node_[local.halfedge[i].value() / 2];
      const std::uint32_t here = node[local.map.point_face[i]];
      if (known == kNone) known = here;
      classes_.unite(known, here);
    }
  }
}

namespace {

constexpr SphereDirection kLeft{kPlaneZ, kPlaneY};   // The direction of -x.
constexpr SphereDirection kRight{kPlaneY, kPlaneZ};  // The direction of x.

// ---- connected pieces

/// Bounds of the numbers x, y, z, x + y, x - y, y + z, y - z, z + x and z - x. Parallel bars
/// between the sides of a box can have boxes within each other, but seldom bounds of all these
/// numbers.
class Extents {
 public:
  static constexpr std::size_t kCount = 9;

  /// Returns the bounds of a point in a box.
  static Extents of(const Box3& box) {
    Extents result;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      result.set(i, box.low[i], box.high[i]);
      result.set_rounded(3 + 2 * i, box.low[i] + box.low[j], box.high[i] + box.high[j]);
      result.set_rounded(4 + 2 * i, box.low[i] - box.high[j], box.high[i] - box.low[j]);
    }
    return result;
  }

  std::array<double, kCount> low{}, high{};

 private:
  void set(std::size_t k, double least, double most) {
    low[k] = least;
    high[k] = most;
  }
  /// Sets bounds that were rounded in any direction. Unknown ones are infinite.
  void set_rounded(std::size_t k, double least, double most) {
    constexpr double kRounding = 0x1p-52, kFlushed = 0x1p-1000;
    const double lower = least - (std::fabs(least) * kRounding + kFlushed);
    const double upper = most + (std::fabs(most) * kRounding + kFlushed);
    set(k, std::isfinite(lower) ? lower : -Box3::kInfinity,
        std::isfinite(upper) ? upper : Box3::kInfinity);
  }
};

/// A connected piece.
struct Piece {
  VertexId least;  ///< Its lexicographically least vertex.
  Box3 box;        ///< Contains the piece.
  /// The least and greatest numbers of the piece are within these bounds (outer) or reach them
  /// surely (inner).
  Extents outer, inner;

  explicit Piece(VertexId v) : least(v) {
    outer.low.fill(Box3::kInfinity);
    outer.high.fill(-Box3::kInfinity);
    inner = outer;
  }
  void add(const Box3& vertex) {
    box.add(vertex);
    const Extents at = Extents::of(vertex);
    for (std::size_t k = 0; k < Extents::kCount; ++k) {
      outer.low[k] = std::min(outer.low[k], at.low[k]);
      outer.high[k] = std::max(outer.high[k], at.high[k]);
      inner.low[k] = std::min(inner.low[k], at.high[k]);
      inner.high[k] = std::max(inner.high[k], at.low[k]);
    }
  }
  /// Whether the piece surely has a point outside of the convex hull of another one.
  bool sticks_out_of(const Piece& other) const {
    for (std::size_t k = 0; k < Extents::kCount; ++k) {
      if (inner.low[k] < other.outer.low[k] || inner.high[k] > other.outer.high[k]) return true;
    }
    return false;
  }
};

/// Returns the connected pieces. Edges and facets connect vertices. Pieces are in the order of
/// their first vertices.
std::vector<Piece> find_pieces(const SpaceComplex& complex, const Context& context) {
  UnionFind roots(complex.vertex_count());
  for (std::uint32_t h = 0; h < complex.origin.size(); h += 2) {
    roots.unite(complex.origin[h].value(), complex.origin[h + 1].value());
  }
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    check_at(f, &context);
    const auto cycles = complex.cycles_of(FacetId(f));
    const std::uint32_t first = complex.use_origin(cycles[0]).value();
    for (const UseId u : cycles.subspan(1)) roots.unite(first, complex.use_origin(u).value());
    for (const VertexId v : complex.inner_of(FacetId(f))) roots.unite(first, v.value());
  }
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> number(complex.vertex_count(), kNone);
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    check_at(v, &context);
    std::uint32_t& known = number[roots.root(v)];
    if (known == kNone) {
      known = static_cast<std::uint32_t>(pieces.size());
      pieces.emplace_back(VertexId(v));
    } else if (VertexId& least = pieces[known].least;
               compare_xyz(complex.points(), complex.vertex_point[v],
                           complex.vertex_point[least]) == Sign::Negative) {
      least = VertexId(v);
    }
  }
  for (std::uint32_t v = 0; v < complex.vertex_count() && pieces.size() > 1; ++v) {
    check_at(v, &context);
    pieces[number[roots.root(v)]].add(box_of(complex, VertexId(v)));
  }
  return pieces;
}

/// Tells by boxes that pieces lie in volume 0.
class OutermostPieces {
 public:
  explicit OutermostPieces(std::span<const Piece> pieces) : pieces_(pieces) {
    std::vector<Box3> boxes;
    boxes.reserve(pieces.size());
    for (const Piece& piece : pieces) boxes.push_back(piece.box);
    tree_ = BoxTree(boxes);
  }

  /// Whether the boxes show that the outer side of a piece faces volume 0. Looks at a few boxes
  /// only.
  bool has(const SpaceComplex& complex, std::size_t piece) const {
    constexpr int kMostBoxes = 64;
    int left = kMostBoxes;
    bool is_outermost = true;
    tree_.for_each_meeting(box_of(complex, pieces_[piece].least), [&](std::uint32_t other) {
      is_outermost = other == piece || (left-- > 0 && pieces_[piece].sticks_out_of(pieces_[other]));
      return is_outermost;
    });
    return is_outermost;
  }

 private:
  std::span<const Piece> pieces_;
  BoxTree tree_;
};

/// Returns the node that faces a direction at a cell. `local` is memory that is reused.
std::uint32_t node_towards(const SpaceComplex& complex, const ShellNodes& shells, SpaceItem item,
                           SphereDirection direction, LocalMap& local) {
  local_map(complex, item, local);
  std::vector<std::uint32_t> node;
  shells.face_nodes(local, item, node);
  const SphereCell cell = locate(complex.planes(), local.map, direction);
  PLUMB_CHECK(cell.kind() == SphereCell::Kind::Face && node[cell.index()] != kNone);
  return node[cell.index()];
}

/// Unites the outer shell of every piece with the shell that its ray towards -x hits, or with the
/// other shells of volume 0. Returns a node of volume 0: one piece holds the least vertex of all.
/// A piece in a bounded volume lies in the convex hull of another piece (Lemma 7). So no ray is
/// needed for a piece that has points outside of the hulls of all others.
std::uint32_t nest_pieces(const SpaceComplex& complex, std::span<const Piece> pieces,
                          ShellNodes& shells, Context& context) {
  LocalMap local;
  std::optional<SpaceLocator> locator;
  std::optional<OutermostPieces> by_boxes;
  if (pieces.size() > 1) by_boxes.emplace(pieces);
  std::vector<std::uint32_t> outermost;  // The nodes of volume 0.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    // No part of the piece is to the left of its least vertex, so this vertex is on the outer
    // shell.
    const VertexId v = pieces[i].least;
    const std::uint32_t outer = node_towards(complex, shells, v, kLeft, local);
    SpaceItem hit;
    if (by_boxes && !by_boxes->has(complex, i)) {
      if (!locator) locator.emplace(complex);
      hit = locator->shoot_left(complex.vertex_point[v]);
    }
    if (hit.is_valid()) {
      shells.unite(outer, node_towards(complex, shells, hit, kRight, local));
    } else {
      outermost.push_back(outer);
    }
    context.checkpoint("volumes", v.value(), complex.vertex_count());
  }
  for (const std::uint32_t node : outermost) shells.unite(outermost[0], node);
  return outermost[0];
}

// ---- numbering

/// Numbers the classes of nodes: first volume 0, that of the node `outermost`, then by facets,
/// edges and vertices.
VolumeLabels numbered(const SpaceComplex& complex, ShellNodes& shells, std::uint32_t outermost) {
  VolumeLabels labels;
  std::vector<VolumeId> number(shells.size());
  const auto volume_of = [&](std::uint32_t node) {
    VolumeId& volume = number[shells.root(node)];
    if (!volume.is_valid()) volume = VolumeId(labels.count++);
    return volume;
  };
  volume_of(outermost);
  labels.facet.reserve(complex.facet_count());
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    labels.facet.push_back({volume_of(2 * f), volume_of(2 * f + 1)});
  }
  labels.edge.resize(complex.edge_count());
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    const std::uint32_t node = shells.free_node(EdgeId(e));
    if (node != kNone) labels.edge[e] = volume_of(node);
  }
  labels.vertex.resize(complex.vertex_count());
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    const bool is_alone = complex.star_of(VertexId(v)).empty();
    if (is_alone && !complex.vertex_facet[v].is_valid()) {
      labels.vertex[v] = volume_of(shells.vertex_node(VertexId(v)));
    }
  }
  return labels;
}

}  // namespace

// If there are no vertices, the whole space is one volume.
VolumeLabels find_volumes(const SpaceComplex& complex, Context& context,
                          std::span<const std::uint8_t> connected) {
  if (complex.vertex_count() == 0) return {{}, {}, {}, 1};
  std::optional<ShellNodes> shells;
  std::vector<Piece> pieces;
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    own.check_limits("volumes");
    if (i == 0) {
      shells.emplace(complex, connected, &own);
    } else {
      pieces = find_pieces(complex, own);
    }
  });
  const std::uint32_t outermost = nest_pieces(complex, pieces, *shells, context);
  return numbered(complex, *shells, outermost);
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

namespace {

/// Checks that each jump is the difference of the winding numbers on both sides of its facet.
void check_jumps(const SpaceComplex& complex, std::span<const std::int32_t> jump,
                 const IdVector<VolumeId, std::int32_t>& winding) {
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    const auto& [above, below] = complex.facet_volume[f];
    PLUMB_CHECK(winding[above] - winding[below] == jump[f]);
  }
}

}  // namespace

IdVector<VolumeId, std::int32_t> winding_numbers(const SpaceComplex& complex,
                                                 std::span<const std::int32_t> jump) {
  if (complex.volume_count() == 2 && complex.facet_count() > 0 &&
      complex.facet_volume[0][0] != complex.facet_volume[0][1]) {
    // One facet determines the difference between the only other volume and volume 0.
    const bool is_outside_above = complex.facet_volume[0][0] == VolumeId(0);
    IdVector<VolumeId, std::int32_t> both(2, 0);
    both[VolumeId(1)] = is_outside_above ? -jump[0] : jump[0];
    check_jumps(complex, jump, both);
    return both;
  }
  // The graph of volumes, whose edges are the facets, in compressed rows.
  const std::size_t volumes = complex.volume_count();
  std::vector<std::uint32_t> begin(volumes + 1, 0);
  for (const auto& sides : complex.facet_volume) {
    for (const VolumeId v : sides) ++begin[v.value() + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> facet(begin.back());
  IdVector<VolumeId, std::uint32_t> at(begin.begin(), begin.end() - 1);
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    for (const VolumeId v : complex.facet_volume[f]) facet[at[v]++] = f;
  }
  IdVector<VolumeId, std::int32_t> winding(volumes, 0);
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
      // The number increases by the jump from the negative to the positive side.
      winding[other] = winding[v] + (is_positive_side ? -jump[facet[i]] : jump[facet[i]]);
      open.push_back(other);
    }
  }
  check_jumps(complex, jump, winding);
  return winding;
}

}  // namespace plumb
