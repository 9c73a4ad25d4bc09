// Walls put into a complex, and the volumes of a complex as sets.
//
// WallSurface makes the polygons of walls one surface: equal points, found by their fingerprints
// and confirmed exactly, become one vertex, and polygons that coincide are merged. ConflictSearch
// finds the pairs of walls that meet outside of common vertices and sides, and only these are cut
// against each other. It may report pairs that do not conflict, but misses none: walls are
// vertical, so two of them in different planes meet on one vertical line.
//
// VolumeSplitter gives every cell to the first marked volume around it, restricts the sphere map at
// each vertex to one volume and the cells that it owns, and lets the ordinary assembly of sphere
// maps make the set. So each volume comes out in minimal form, and each point of the boundary
// belongs to one of them. See docs/design/walls.md, section Vertical walls.
// Tested by tests/convex/walls_test.cpp.

#include "plumb/convex/wall/wall_complex.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/box_tree.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/wall/set_parts.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/boolean/boolean_op.h"
#include "plumb/space/boolean/vertex_labels.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/complex/tidy_tables.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/mesh/link_facets.h"
#include "plumb/space/mesh/mesh_arrangement.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Returns pairs of facets, each pair once. The pairs include all pairs that meet outside of common
/// vertices and sides, and possibly a few more. This is enough for layers. Requires facets in
/// vertical planes, linked by their vertices. Seen along the vertical they are segments, so two in
/// different planes can only meet on one vertical line; if both end there, they meet in common
/// vertices only. Cost: O(n log n), and a sign for each corner of facets with common boxes.
std::vector<std::pair<FacetId, FacetId>> find_wall_conflicts(const SpaceComplex& walls,
                                                             Context& context);

namespace {

class ConflictSearch {
 public:
  explicit ConflictSearch(const SpaceComplex& walls) : c_(walls) {}

  std::vector<std::pair<FacetId, FacetId>> run(Context& context) {
    std::vector<Box3> boxes;
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) boxes.push_back(box_of(c_, FacetId(f)));
    const BoxTree tree(boxes);
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (f % 256 == 0) context.checkpoint("walls that cross", f, c_.facet_count());
      tree.for_each_meeting(boxes[f], [&](std::uint32_t g) {
        if (g > f && may_conflict(FacetId(f), FacetId(g))) pairs_.emplace_back(f, g);
      });
    }
    std::sort(pairs_.begin(), pairs_.end());
    return std::move(pairs_);
  }

 private:
  /// The position of a facet relative to the plane of another facet.
  struct Place {
    // Whether a corner is strictly before the plane, or strictly behind it.
    bool is_before = false, is_behind = false;
    std::vector<VertexId> on;
    bool crosses() const { return is_before && is_behind; }
  };

  template <class Visit>
  void for_each_corner(FacetId f, const Visit& visit) const {
    const UseId first = c_.cycles_of(f)[0];
    UseId u = first;
    do {
      visit(c_.use_origin(u));
      u = c_.use_next[u];
    } while (u != first);
  }

  Place place(FacetId f, PlaneId plane) const {
    Place result;
    for_each_corner(f, [&](VertexId v) {
      const Sign s = side(c_.points(), c_.vertex_point[v], plane);
      if (s == Sign::Positive) result.is_before = true;
      if (s == Sign::Negative) result.is_behind = true;
      if (s == Sign::Zero) result.on.push_back(v);
    });
    std::sort(result.on.begin(), result.on.end());
    return result;
  }

  /// Facets in the same plane may overlap. Other facets meet on at most one vertical line. They
  /// conflict if one crosses the plane of the other, or if they touch in different vertices.
  bool may_conflict(FacetId f, FacetId g) const {
    const PlaneId p = c_.facet_plane[f], q = c_.facet_plane[g];
    if (p == q) return true;
    const Place x = place(f, q);
    if (!x.crosses() && x.on.empty()) return false;
    const Place y = place(g, p);
    if (!y.crosses() && y.on.empty()) return false;
    return x.crosses() || y.crosses() || x.on != y.on;
  }

  const SpaceComplex& c_;
  std::vector<std::pair<FacetId, FacetId>> pairs_;
};

}  // namespace

std::vector<std::pair<FacetId, FacetId>> find_wall_conflicts(const SpaceComplex& walls,
                                                             Context& context) {
  return ConflictSearch(walls).run(context);
}

namespace {

// ---------------------------------------------------------------- walls as a surface

/// Polygons whose points have separate ids. Equal points become one vertex.
class WallSurface {
 public:
  WallSurface(const std::vector<WallPolygon>& walls, const Point3Table& points) {
    for (const WallPolygon& wall : walls) {
      corner_.insert(corner_.end(), wall.corners.begin(), wall.corners.end());
    }
    unite(points);
    auto next = number_.begin();
    for (const WallPolygon& wall : walls) {
      const auto size = static_cast<std::ptrdiff_t>(wall.corners.size());
      add(wall.plane, {next, next + size});
      next += size;
    }
  }

  MeshComplex complex(const std::shared_ptr<SpaceTables>& tables, Context& context) {
    MeshLinks links = link_corners(facets_, vertex_.size());
    merge_doubled(facets_, links, vertex_.size());
    drop_unused();
    links = link_corners(facets_, vertex_.size());
    MeshComplex mesh;
    mesh.complex = link_facets(facets_, links, vertex_, tables);
    mesh.jump = facets_.jump;
    mesh.component.resize(facets_.size());
    std::iota(mesh.component.begin(), mesh.component.end(), 0U);
    mesh.crossings = find_wall_conflicts(mesh.complex, context);
    return mesh;
  }

 private:
  /// Sorts points by fingerprint. In a group of equal fingerprints, each point is compared exactly
  /// with the earlier points.
  void unite(const Point3Table& points) {
    std::vector<std::pair<Fingerprint, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < corner_.size(); ++i) {
      order.emplace_back(fingerprint(points, corner_[i]), i);
    }
    std::sort(order.begin(), order.end());
    number_.resize(corner_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::uint32_t at = order[i].second;
      number_[at] = kNone;
      // Different points with one fingerprint are extremely rare.
      for (std::size_t j = i; j-- > 0 && order[j].first == order[i].first;) {
        if (!equal(points, corner_[at], corner_[order[j].second])) continue;
        number_[at] = number_[order[j].second];
        break;
      }
      if (number_[at] != kNone) continue;
      number_[at] = static_cast<std::uint32_t>(vertex_.size());
      vertex_.push_back(corner_[at]);
    }
  }

  /// Adds a polygon without repeated corners. If the vertical sides of a wall have no length, the
  /// wall may have fewer than three corners, and is dropped.
  void add(PlaneId plane, std::vector<std::uint32_t> cycle) {
    cycle.erase(std::unique(cycle.begin(), cycle.end()), cycle.end());
    while (cycle.size() > 1 && cycle.front() == cycle.back()) cycle.pop_back();
    if (cycle.size() < 3) return;
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    facets_.corner.insert(facets_.corner.end(), cycle.begin(), cycle.end());
    facets_.begin.push_back(static_cast<std::uint32_t>(facets_.corner.size()));
    facets_.plane.push_back(plane);
    facets_.jump.push_back(1);
    facets_.origin.push_back(kWallOrigin);
  }

  /// Removes vertices that belong to no polygon after some were dropped.
  void drop_unused() {
    std::vector<std::uint32_t> number(vertex_.size(), 0);
    for (const std::uint32_t v : facets_.corner) number[v] = 1;
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      if (number[v] == 0) continue;
      vertex_[count] = vertex_[v];
      number[v] = count++;
    }
    vertex_.resize(count);
    for (std::uint32_t& v : facets_.corner) v = number[v];
  }

  std::vector<SpacePoint> corner_;
  std::vector<std::uint32_t> number_;  // The vertex of each corner.
  std::vector<SpacePoint> vertex_;
  MeshFacets facets_;
};

// ---------------------------------------------------------------- volumes as sets

/// Makes each marked volume of a complex a set of its own.
class VolumeSplitter {
 public:
  explicit VolumeSplitter(const SpaceComplex& complex) : c_(complex), overlay_(complex.planes()) {
    find_owners();
    find_vertices();
  }

  std::vector<Nef3> run(Context& context) {
    std::vector<Nef3> sets;
    MemoryCharge memory(context);
    SpaceDraft none(c_.tables);
    VertexCarrier carrier(c_, none, overlay_);
    for (std::size_t i = 0; i < vertices_.size();) {
      context.checkpoint("pieces", i, vertices_.size());
      const VolumeId volume = vertices_[i].first;
      SpaceDraft draft(none.tables);
      carrier.start(draft);
      for (; i < vertices_.size() && vertices_[i].first == volume; ++i) {
        local_map(c_, vertices_[i].second, local_);
        mark(volume, vertices_[i].second);
        carrier.add_simplified(vertices_[i].second, local_);
      }
      carrier.face_ends();
      sets.push_back(Nef3::from_minimal_unchecked(assemble(std::move(draft), context)));
      memory.add(bytes_beside_tables(sets.back()), "convex pieces");
    }
    return sets;
  }

  /// Returns the marks of the cells that belong to no marked volume.
  SpaceMarks rest() const {
    SpaceMarks marks{c_.vertex_mark, c_.edge_mark, c_.facet_mark, {}};
    marks.volume.assign(c_.volume_count(), 0);
    take(vertex_owner_, marks.vertex);
    take(edge_owner_, marks.edge);
    take(facet_owner_, marks.facet);
    return marks;
  }

 private:
  static void take(const std::vector<VolumeId>& owner, std::vector<Mark>& marks) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (owner[i].is_valid()) marks[i] = 0;
    }
  }

  /// Finds the first marked volume around every cell.
  void find_owners() {
    vertex_owner_.resize(c_.vertex_count());
    edge_owner_.resize(c_.edge_count());
    facet_owner_.resize(c_.facet_count());
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      for (const VolumeId volume : c_.facet_volume[f]) {
        claim(facet_owner_[f], volume);
        for (const VertexId v : c_.inner_of(FacetId(f))) claim(vertex_owner_[v], volume);
      }
    }
    for (std::uint32_t u = 0; u < c_.use_count(); ++u) {
      const VolumeId volume = facet_owner_[c_.use_facet[u]];
      claim(edge_owner_[c_.use_halfedge[u].value() / 2], volume);
      claim(vertex_owner_[c_.use_origin(UseId(u))], volume);
    }
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_use[e].is_valid()) continue;
      for (std::uint32_t h = 2 * e; h < 2 * e + 2; ++h) {
        claim(vertex_owner_[c_.origin[h]], c_.edge_volume[e]);
      }
      claim(edge_owner_[e], c_.edge_volume[e]);
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.vertex_volume[v].is_valid()) claim(vertex_owner_[v], c_.vertex_volume[v]);
    }
  }
  void claim(VolumeId& owner, VolumeId volume) const {
    if (!volume.is_valid() || c_.volume_mark[volume] != 1) return;
    if (!owner.is_valid() || volume < owner) owner = volume;
  }

  /// Collects the vertices around each marked volume.
  void find_vertices() {
    const auto add = [this](VolumeId volume, VertexId v) {
      if (c_.volume_mark[volume] == 1) vertices_.emplace_back(volume, v);
    };
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      for (const VolumeId volume : c_.facet_volume[f]) {
        for (const VertexId v : c_.inner_of(FacetId(f))) add(volume, v);
      }
    }
    for (std::uint32_t u = 0; u < c_.use_count(); ++u) {
      for (const VolumeId volume : c_.facet_volume[c_.use_facet[u]]) {
        add(volume, c_.use_origin(UseId(u)));
      }
    }
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_use[e].is_valid()) continue;
      add(c_.edge_volume[e], c_.origin[2 * e]);
      add(c_.edge_volume[e], c_.origin[2 * e + 1]);
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.vertex_volume[v].is_valid()) add(c_.vertex_volume[v], VertexId(v));
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  /// Restricts the sphere map at a vertex to the volume and the cells that it owns.
  void mark(VolumeId volume, VertexId v) {
    SphereMap& map = local_.map;
    const auto keep = [volume](VolumeId owner, Mark& m) {
      if (owner != volume) m = 0;
    };
    keep(vertex_owner_[v], map.centre_mark);
    for (std::size_t i = 0; i < map.point_count(); ++i) {
      keep(edge_owner_[local_.halfedge[i].value() / 2], map.point_mark[i]);
    }
    for (std::size_t i = 0; i < map.arc_count(); ++i) {
      keep(facet_owner_[local_.facet[i]], map.arc_mark[i]);
    }
    for (std::size_t i = 0; i < map.face_count(); ++i) {
      map.face_mark[i] = local_.volume[i] == volume ? 1 : 0;
    }
  }

  const SpaceComplex& c_;
  SphereOverlay overlay_;
  LocalMap local_;
  IdVector<VertexId, VolumeId> vertex_owner_;
  IdVector<EdgeId, VolumeId> edge_owner_;
  IdVector<FacetId, VolumeId> facet_owner_;
  std::vector<std::pair<VolumeId, VertexId>> vertices_;
};

}  // namespace

/// Walls are arranged among themselves first, so that the overlay with the complex sees a surface
/// that meets itself in common edges and vertices only.
SpaceComplex with_walls(SpaceComplex complex, const std::shared_ptr<SpaceTables>& tables,
                        const std::vector<WallPolygon>& walls, Context& context) {
  MeshComplex surface = WallSurface(walls, tables->points).complex(tables, context);
  if (surface.complex.facet_count() == 0) return complex;
  MemoryCharge memory(context);
  memory.add(array_bytes(surface.complex), "walls");
  arrange(surface, context);
  SpaceComplex& cutters = surface.complex;
  cutters.vertex_mark.assign(cutters.vertex_count(), 1);
  cutters.edge_mark.assign(cutters.edge_count(), 1);
  cutters.facet_mark.assign(cutters.facet_count(), 1);
  cutters.volume_mark.assign(cutters.volume_count(), 0);
  complex.tables = cutters.tables;
  // If walls crossed, arrange() may have given them new tables.
  const std::shared_ptr<SpaceTables> common =
      cutters.tables == tables ? tables : unite_tables(complex, cutters);
  memory.add(memory_bytes(complex) + array_bytes(cutters), "a set and its walls");
  const auto common_origin = [](std::uint32_t of_set, std::uint32_t) { return of_set; };
  return boolean_op_on(common, complex, cutters, MarkTable::walled(), common_origin, context);
}

std::vector<Nef3> volumes_as_sets(const SpaceComplex& complex, Context& context) {
  return VolumeSplitter(complex).run(context);
}

Nef3 without_volumes(const Nef3& set, Context& context) {
  return set.with_marks(VolumeSplitter(set.complex()).rest(), context);
}

}  // namespace plumb
