// Makes the sphere map of a cell from the arrays of the complex.
//
// A facet gives a loop between two faces, an edge two points with a half-circle for each edge use
// (Weiler), a vertex a point for each half-edge and an arc for each corner. Around a half-edge the
// arcs have the radial order of its edge, which links them; faces are the orbits of `next`. If the
// map is connected (by Euler's formula, points - arcs + faces = 2), no arithmetic is needed.
// Otherwise, several orbits bound one face, and walks along great circles group them
// (docs/design/sphere.md, "Nesting").
//
// The numbering is fixed: points in the order of the star, arcs by the point at which their use
// begins. VertexCarrier (boolean/vertex_labels.h) relies on it.
//
// Tested by tests/space/nef3_property_test.cpp and tests/space/embedding_test.cpp.

#include "plumb/space/local_maps.h"

#include <algorithm>
#include <numeric>

#include "plumb/predicates/error.h"
#include "plumb/sphere/arcs/sphere_arcs.h"

namespace plumb {

namespace {

/// Empties a map, but keeps its memory.
void clear(LocalMap& local) {
  local.map.clear();
  local.halfedge.clear();
  local.use.clear();
  local.facet.clear();
  local.volume.clear();
}

/// Adds the point of a half-edge, without arcs.
void add_point(const SpaceComplex& complex, HalfedgeId h, LocalMap& out) {
  out.halfedge.push_back(h);
  out.map.direction.push_back(direction_of(complex, h));
  out.map.point_mark.push_back(complex.edge_mark[h.value() >> 1U]);
  out.map.first_out.push_back(kNone);
  out.map.point_face.push_back(kNone);
}

/// Adds an arc that has no points and faces yet. An arc without points is a loop, in which both
/// half-arcs follow themselves.
void add_arc(const SpaceComplex& complex, FacetId f, UseId use, LocalMap& out) {
  out.use.push_back(use);
  out.facet.push_back(f);
  out.map.circle.push_back(complex.facet_plane[f]);
  out.map.arc_mark.push_back(complex.facet_mark[f]);
  for (int side = 0; side < 2; ++side) {  // This takes much less time than insert().
    out.map.origin.push_back(kNone);
    out.map.next.push_back(static_cast<std::uint32_t>(out.map.next.size()));
    out.map.face.push_back(kNone);
  }
}

void add_loop(const SpaceComplex& complex, FacetId f, LocalMap& out) {
  add_arc(complex, f, UseId(), out);
}

/// Adds a face in a volume, with mark 0 if the volume is not known, and returns it.
std::uint32_t add_face(const SpaceComplex& complex, VolumeId volume, LocalMap& out) {
  const bool known = volume.is_valid() && volume.value() < complex.volume_count();
  out.volume.push_back(volume);
  out.map.face_mark.push_back(known ? complex.volume_mark[volume] : 0);
  return static_cast<std::uint32_t>(out.volume.size() - 1);
}

/// Returns the volume to the left of a half-arc.
VolumeId volume_left_of(const SpaceComplex& complex, const LocalMap& local, std::uint32_t half) {
  const FacetId f = local.facet[half / 2];
  if (complex.facet_volume.empty()) return VolumeId();
  return complex.facet_volume[f][half & 1U];
}

/// Links half-arcs that leave one point. Each is the clockwise neighbour of the next one.
void link_ring(std::span<const std::uint32_t> counterclockwise, SphereMap& map) {
  for (std::size_t i = 0; i < counterclockwise.size(); ++i) {
    const std::uint32_t after = counterclockwise[i + 1 < counterclockwise.size() ? i + 1 : 0];
    map.next[SphereMap::twin(after)] = counterclockwise[i];
  }
}

// ---- edges and facets

void map_facet(const SpaceComplex& complex, FacetId f, LocalMap& out) {
  add_loop(complex, f, out);
  for (std::uint32_t side = 0; side < 2; ++side) {
    out.map.face[side] = add_face(complex, volume_left_of(complex, out, side), out);
  }
  out.map.centre_mark = complex.facet_mark[f];
}

/// Returns the volume around a free edge, or an invalid id if volumes have no labels.
VolumeId volume_of_free_edge(const SpaceComplex& complex, HalfedgeId h) {
  return complex.edge_volume.empty() ? VolumeId() : complex.edge_volume[h.value() >> 1U];
}

// The uses are counter-clockwise around half-edge 2e, and so are their half-arcs at point 0. At
// point 1, the order is reversed.
void map_edge(const SpaceComplex& complex, EdgeId e, LocalMap& out) {
  SphereMap& map = out.map;
  const HalfedgeId forward(2 * e.value()), backward(2 * e.value() + 1);
  add_point(complex, forward, out);
  add_point(complex, backward, out);
  map.centre_mark = complex.edge_mark[e];
  const UseId first = complex.edge_use[e];
  if (!first.is_valid()) {
    const VolumeId around = volume_of_free_edge(complex, forward);
    map.point_face[0] = map.point_face[1] = add_face(complex, around, out);
    return;
  }
  // Arc i is the half-circle of the i-th use in radial order. Of its half-arcs, the even one leaves
  // point 0 if the use is on 2e, and the odd one if the use is on 2e + 1.
  std::vector<std::uint32_t> ring, reversed;
  UseId u = first;
  do {
    const bool is_reverse = SpaceComplex::is_reverse(complex.use_halfedge[u]);
    const auto half = static_cast<std::uint32_t>(2 * out.use.size());
    add_arc(complex, complex.use_facet[u], u, out);
    map.origin[half] = is_reverse ? 1 : 0;
    map.origin[half + 1] = is_reverse ? 0 : 1;
    ring.push_back(is_reverse ? half + 1 : half);
    u = complex.use_radial[u];
  } while (u != first);
  for (const std::uint32_t half : ring) reversed.push_back(SphereMap::twin(half));
  std::reverse(reversed.begin(), reversed.end());
  link_ring(ring, map);
  link_ring(reversed, map);
  map.first_out[0] = ring.front();
  map.first_out[1] = SphereMap::twin(ring.front());
  // Between two neighbouring half-circles, there is one face. It is to the left of the first
  // half-arc at point 0, and of the reverse of the next one.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::uint32_t after = ring[i + 1 < ring.size() ? i + 1 : 0];
    map.face[ring[i]] = map.face[SphereMap::twin(after)] =
        add_face(complex, volume_left_of(complex, out, ring[i]), out);
  }
}

// ---- vertices

/// Finds the arc of a use; at vertices of many facets by binary search.
class ArcsByUse {
 public:
  explicit ArcsByUse(const std::vector<UseId>& use) : use_(use) {
    if (use.size() <= kFew) return;
    order_.resize(use.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::sort(order_.begin(), order_.end(),
              [&use](std::uint32_t i, std::uint32_t j) { return use[i] < use[j]; });
  }

  std::uint32_t operator()(UseId u) const {
    if (use_.size() <= kFew) {
      return static_cast<std::uint32_t>(std::find(use_.begin(), use_.end(), u) - use_.begin());
    }
    return *std::lower_bound(order_.begin(), order_.end(), u,
                             [this](std::uint32_t i, UseId v) { return use_[i] < v; });
  }

 private:
  static constexpr std::size_t kFew = 12;
  const std::vector<UseId>& use_;
  std::vector<std::uint32_t> order_;
};

/// Calls visit(use) for the uses around the edge of a half-edge, in radial order.
template <class Visit>
void for_each_use(const SpaceComplex& complex, HalfedgeId h, Visit visit) {
  const UseId first = complex.edge_use[h.value() >> 1U];
  if (!first.is_valid()) return;
  UseId u = first;
  do {
    visit(u);
    u = complex.use_radial[u];
  } while (u != first);
}

/// Adds the points and arcs of a vertex with their links, without faces.
void link_vertex(const SpaceComplex& complex, VertexId v, LocalMap& out) {
  SphereMap& map = out.map;
  for (const HalfedgeId h : complex.star_of(v)) add_point(complex, h, out);
  for (const HalfedgeId h : complex.star_of(v)) {
    for_each_use(complex, h, [&](UseId u) {
      if (complex.use_halfedge[u] == h) {
        add_arc(complex, complex.use_facet[u], u, out);
      }
    });
  }
  const ArcsByUse arc_of(out.use);
  // If a use leaves along h, its corner begins at this point, and its even half-arc leaves. If a
  // use arrives, its corner belongs to the next use and ends here, so its odd half-arc leaves.
  for (std::uint32_t i = 0; i < out.halfedge.size(); ++i) {
    const HalfedgeId h = out.halfedge[i];
    const bool is_reverse = SpaceComplex::is_reverse(h);
    std::uint32_t first = kNone, last = kNone;
    // Around half-edge 2e, the uses are counter-clockwise. Around its reverse, they are clockwise.
    const auto link = [&](std::uint32_t half, std::uint32_t after) {
      if (is_reverse) std::swap(half, after);
      map.next[SphereMap::twin(after)] = half;
    };
    for_each_use(complex, h, [&](UseId u) {
      const bool leaves = complex.use_halfedge[u] == h;
      const std::uint32_t half = leaves ? 2 * arc_of(u) : 2 * arc_of(complex.use_next[u]) + 1;
      map.origin[half] = i;
      if (first == kNone) {
        first = half;
      } else {
        link(last, half);
      }
      last = half;
    });
    if (first == kNone) continue;
    link(last, first);
    map.first_out[i] = is_reverse ? last : first;
  }
  const FacetId inside = complex.vertex_facet[v];
  if (inside.is_valid()) add_loop(complex, inside, out);
}

/// Makes each orbit of `next` a face, with the volume of its first half-arc. Returns the number of
/// faces.
std::uint32_t add_orbits(const SpaceComplex& complex, LocalMap& out) {
  SphereMap& map = out.map;
  std::uint32_t count = 0;
  for (std::uint32_t start = 0; start < map.next.size(); ++start) {
    if (map.face[start] != kNone) continue;
    const std::uint32_t face = add_face(complex, volume_left_of(complex, out, start), out);
    for (std::uint32_t h = start; map.face[h] == kNone; h = map.next[h]) map.face[h] = face;
    ++count;
  }
  return count;
}

/// Groups the boundary cycles of a map that is not connected into faces. A cycle is an orbit of
/// half-arcs or an isolated point.
class CycleGroups {
 public:
  CycleGroups(const PlaneTable& planes, const SphereMap& map,
              const std::vector<std::uint32_t>& orbit, std::uint32_t orbit_count)
      : orbit_(orbit), orbit_count_(orbit_count) {
    make_singles(class_, orbit_count + map.point_count());
    SphereParts parts;
    parts.find(planes, map);
    for (const SphereParts::Link& l : parts.links()) {
      unite(class_, cycle_of(l.first), cycle_of(l.second));
    }
    if (map.arc_count() == 0) std::fill(class_.begin(), class_.end(), 0U);
  }

  /// Returns the class of an orbit; isolated point i is cycle orbit_count + i.
  std::uint32_t of_cycle(std::uint32_t cycle) { return find_root(class_, cycle); }

 private:
  std::uint32_t cycle_of(SphereSlot slot) const {
    return slot.half_arc != kNone ? orbit_[slot.half_arc] : orbit_count_ + slot.point;
  }

  const std::vector<std::uint32_t>& orbit_;
  std::uint32_t orbit_count_;
  std::vector<std::uint32_t> class_;
};

/// Gives each class of boundary cycles a face, with the volume that is known for one of its cycles.
class FaceNumbers {
 public:
  FaceNumbers(const SpaceComplex& complex, std::size_t classes, LocalMap& out)
      : complex_(complex), out_(out), face_(classes, kNone) {}

  std::uint32_t operator()(std::uint32_t cycle_class, VolumeId volume) {
    if (face_[cycle_class] == kNone) face_[cycle_class] = add_face(complex_, volume, out_);
    return face_[cycle_class];
  }

 private:
  const SpaceComplex& complex_;
  LocalMap& out_;
  std::vector<std::uint32_t> face_;
};

void map_vertex(const SpaceComplex& complex, VertexId v, LocalMap& out) {
  SphereMap& map = out.map;
  map.centre_mark = complex.vertex_mark[v];
  link_vertex(complex, v, out);
  if (map.point_count() == 0 && map.arc_count() == 0) {
    add_face(complex, complex.vertex_volume.empty() ? VolumeId() : complex.vertex_volume[v], out);
    return;
  }
  const std::uint32_t orbits = add_orbits(complex, out);
  const auto points = static_cast<std::uint32_t>(map.point_count());
  // By Euler's formula, V - E + F is 2 for a component with points and arcs, and no two components
  // share an orbit. Therefore the sum is 2 if and only if there is one component.
  const bool has_lone_parts =
      complex.vertex_facet[v].is_valid() ||
      std::find(map.first_out.begin(), map.first_out.end(), kNone) != map.first_out.end();
  if (!has_lone_parts && points + orbits == map.arc_count() + 2) return;  // The map is connected.
  // Orbits are grouped: a class of cycles that bound one face gets one number.
  const std::vector<std::uint32_t> orbit = map.face;
  out.volume.clear();
  map.face_mark.clear();
  FaceNumbers face(complex, orbits + points, out);
  CycleGroups groups(complex.planes(), map, orbit, orbits);
  for (std::uint32_t h = 0; h < map.next.size(); ++h) {
    map.face[h] = face(groups.of_cycle(orbit[h]), volume_left_of(complex, out, h));
  }
  for (std::uint32_t i = 0; i < points; ++i) {
    if (map.first_out[i] != kNone) continue;
    map.point_face[i] =
        face(groups.of_cycle(orbits + i), volume_of_free_edge(complex, out.halfedge[i]));
  }
}

}  // namespace

void local_map(const SpaceComplex& complex, SpaceItem item, LocalMap& out) {
  clear(out);
  switch (item.kind()) {
    case SpaceItem::Kind::Vertex:
      return map_vertex(complex, item.vertex(), out);
    case SpaceItem::Kind::Edge:
      return map_edge(complex, item.edge(), out);
    case SpaceItem::Kind::Facet:
      return map_facet(complex, item.facet(), out);
    case SpaceItem::Kind::Volume:
      break;
  }
  PLUMB_CHECK(false);
}

}  // namespace plumb
