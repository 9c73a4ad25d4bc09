// Homology of a surface whose border loops are closed by disks: generators, classes of polygons,
// and loops that repair a shape.
//
// Tree and cotree: a spanning tree of the vertices, and a spanning tree of faces and disks over the
// remaining edges. By Euler's formula 2 g edges are left for genus g; each closes a generator with
// the vertex tree, and a dual loop with the face tree. The class of a polygon has as its i-th
// coefficient the number of times the polygon, pushed onto mesh edges within its faces, crosses the
// i-th dual loop, with sign. Therefore, after the crossings of each edge have been stored in a
// table, a class needs one lookup for each segment.
//
// Proof: docs/design/surface.md, section Homology, Lemma 3. Source: D. Eppstein, Dynamic generators
// of topologically embedded graphs, SODA (2003); J. Erickson and K. Whittlesey, Greedy optimal
// homotopy and homology generators, SODA (2005).
// Tested by tests/surface/triangulation_test.cpp.
#include "plumb/surface/surface_homology.h"

#include <algorithm>

namespace plumb {
namespace {

constexpr std::uint8_t kTree = 1;
constexpr std::uint8_t kCotree = 2;
constexpr std::uint64_t kFaceBytes = 80;
constexpr std::uint64_t kPointBytes = 64;  // The memory of a point of a polygon.
constexpr std::size_t kCrossingsPerCharge = 65536;
constexpr std::size_t kStepsPerCheckpoint = 65536;
constexpr std::uint64_t kCrossingBytes = 3 * sizeof(SignedEntry) + sizeof(EdgeId);

}  // namespace

SurfaceHomology::SurfaceHomology(const SurfaceMesh& mesh, Context& context) : mesh_(mesh) {
  context.checkpoint("homology", 0, 1);
  context.charge_memory(kFaceBytes * mesh.face_count(), "the homology");
  is_in_tree_.assign(mesh.edge_count(), 0);
  grow_tree();
  find_disks();
  grow_cotree();
  for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
    if (is_in_tree_[e] == 0) generators_.push_back(EdgeId(e));
  }
  cross_dual_loops(context);
}

VertexId SurfaceHomology::across(EdgeId e, VertexId v) const {
  return mesh_.lower(e) == v ? mesh_.upper(e) : mesh_.lower(e);
}

/// Searches breadth-first over vertices, with one tree for each component. At a vertex at the
/// border, the rotation starts at its first half-edge and ends with the edge that arrives along the
/// border.
void SurfaceHomology::grow_tree() {
  parent_.assign(mesh_.vertex_count(), EdgeId{});
  IdVector<VertexId, std::uint8_t> is_seen(mesh_.vertex_count());
  std::vector<VertexId> queue;
  for (std::uint32_t root = 0; root < mesh_.vertex_count(); ++root) {
    if (is_seen[root] != 0) continue;
    is_seen[root] = 1;
    std::size_t at = queue.size();
    queue.emplace_back(root);
    const auto reach = [&](HalfedgeId h, VertexId from) {
      const VertexId to = across(mesh_.edge(h), from);
      if (is_seen[to] != 0) return;
      is_seen[to] = 1;
      is_in_tree_[mesh_.edge(h)] = kTree;
      parent_[to] = mesh_.edge(h);
      queue.push_back(to);
    };
    for (; at < queue.size(); ++at) {
      const VertexId v = queue[at];
      const HalfedgeId first = mesh_.halfedge(v);
      for (HalfedgeId h = first; h.is_valid();) {
        reach(h, v);
        const HalfedgeId in = SurfaceMesh::prev(h);
        if (mesh_.is_border(in)) reach(in, v);
        h = mesh_.twin(in);
        if (h == first) break;
      }
    }
  }
}

/// Finds a disk for each closed walk along the border.
void SurfaceHomology::find_disks() {
  const std::size_t n = 3 * mesh_.face_count();
  disk_of_.assign(n, kNone);
  disk_begin_ = {0};
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!mesh_.is_border(HalfedgeId(i)) || disk_of_[i] != kNone) continue;
    const auto disk = static_cast<std::uint32_t>(disk_begin_.size() - 1);
    for (HalfedgeId h(i); disk_of_[h] == kNone;) {
      disk_of_[h] = disk;
      disk_halfedges_.push_back(h);
      h = SurfaceMesh::next(h);
      while (!mesh_.is_border(h)) h = SurfaceMesh::next(mesh_.twin(h));
    }
    disk_begin_.push_back(static_cast<std::uint32_t>(disk_halfedges_.size()));
  }
}

// Searches breadth-first over faces and disks, without crossing edges of the vertex tree. The nodes
// are the faces, followed by the disks.
void SurfaceHomology::grow_cotree() {
  const auto faces = static_cast<std::uint32_t>(mesh_.face_count());
  std::vector<std::uint8_t> is_seen(faces + disk_begin_.size() - 1);
  const auto reach = [&](std::uint32_t node, HalfedgeId over) {
    std::uint8_t& use = is_in_tree_[mesh_.edge(over)];
    if (is_seen[node] != 0 || use == kTree) return;
    is_seen[node] = 1;
    use = kCotree;
    cotree_.push_back({node, mesh_.edge(over)});
  };
  for (std::uint32_t root = 0; root < faces; ++root) {
    if (is_seen[root] != 0) continue;
    is_seen[root] = 1;
    std::size_t at = cotree_.size();
    cotree_.push_back({root, EdgeId{}});
    for (; at < cotree_.size(); ++at) {
      const std::uint32_t node = cotree_[at].node;
      if (node >= faces) {
        const std::uint32_t disk = node - faces;
        for (std::uint32_t i = disk_begin_[disk]; i < disk_begin_[disk + 1]; ++i) {
          reach(SurfaceMesh::face(disk_halfedges_[i]).value(), disk_halfedges_[i]);
        }
        continue;
      }
      for (std::size_t side = 0; side < 3; ++side) {
        const HalfedgeId h = SurfaceMesh::halfedge(FaceId(node), side);
        const HalfedgeId t = mesh_.twin(h);
        reach(t.is_valid() ? SurfaceMesh::face(t).value() : faces + disk_of_[h], h);
      }
    }
  }
}

// ---------------------------------------------------------------- dual loops

/// Returns the face or disk across a half-edge.
std::uint32_t SurfaceHomology::node_behind(HalfedgeId h) const {
  const HalfedgeId t = mesh_.twin(h);
  if (t.is_valid()) return SurfaceMesh::face(t).value();
  return static_cast<std::uint32_t>(mesh_.face_count()) + disk_of_[h];
}

/// Computes the dual loops that cross each edge. A loop crosses an edge in the positive sense if it
/// leads from the left to the right of the edge, where the edge points upwards.
void SurfaceHomology::cross_dual_loops(Context& context) {
  std::vector<std::uint32_t> step_of(mesh_.face_count() + disk_begin_.size() - 1);
  for (std::uint32_t i = 0; i < cotree_.size(); ++i) step_of[cotree_[i].node] = i;
  struct Crossing {
    EdgeId edge;
    SignedEntry entry;
  };
  std::vector<Crossing> crossings;
  std::size_t charged = 0;
  // The sign of a crossing of the edge e out of that node.
  const auto sign_out_of = [&](std::uint32_t node, EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e);
    const bool is_from_here = SurfaceMesh::face(h).value() == node;
    return is_from_here == mesh_.is_upward(h) ? 1 : -1;
  };
  const auto behind = [&](std::uint32_t node, EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e);
    const std::uint32_t face = SurfaceMesh::face(h).value();
    return face == node ? node_behind(h) : face;
  };
  for (std::uint32_t g = 0; g < generators_.size(); ++g) {
    const EdgeId e = generators_[g];
    const HalfedgeId h = mesh_.halfedge(e);
    const std::int32_t way = mesh_.is_upward(h) ? 1 : -1;
    crossings.push_back({e, {g, 1}});
    // The loop leads from the face that it enters up towards the root, and back from the place
    // where both ways meet. Of the two ends, the one that was found later in the breadth-first
    // search moves, so they meet at the common ancestor.
    std::uint32_t to = node_behind(h), from = SurfaceMesh::face(h).value();
    while (to != from) {
      const bool moves_to = step_of[to] > step_of[from];
      std::uint32_t& node = moves_to ? to : from;
      const EdgeId up = cotree_[step_of[node]].edge;
      const std::int32_t sign = sign_out_of(node, up) * (moves_to ? way : -way);
      crossings.push_back({up, {g, sign}});
      node = behind(node, up);
    }
    if (crossings.size() - charged < kCrossingsPerCharge) continue;
    context.checkpoint("homology", g, generators_.size());
    context.charge_memory(kCrossingBytes * (crossings.size() - charged), "the homology");
    charged = crossings.size();
  }
  crossed_begin_.assign(mesh_.edge_count() + 1, 0);
  for (const Crossing& c : crossings) ++crossed_begin_[c.edge.value() + 1];
  for (std::size_t e = 0; e < mesh_.edge_count(); ++e) crossed_begin_[e + 1] += crossed_begin_[e];
  IdVector<EdgeId, std::uint32_t> at(crossed_begin_.begin(), crossed_begin_.end() - 1);
  crossed_.resize(crossings.size());
  for (const Crossing& c : crossings) crossed_[at[c.edge]++] = c.entry;
}

// ---------------------------------------------------------------- generators

std::vector<VertexId> SurfaceHomology::to_root(VertexId v) const {
  std::vector<VertexId> path = {v};
  while (parent_[v].is_valid()) {
    v = across(parent_[v], v);
    path.push_back(v);
  }
  return path;
}

/// Returns the loop of a generator, which leads up its edge and back through the tree.
std::vector<VertexId> SurfaceHomology::generator(std::size_t i) const {
  const EdgeId e = generators_[i];
  std::vector<VertexId> from = to_root(mesh_.upper(e)), to = to_root(mesh_.lower(e));
  while (from.size() > 1 && to.size() > 1 && from[from.size() - 2] == to[to.size() - 2]) {
    from.pop_back();
    to.pop_back();
  }
  from.insert(from.end(), to.rbegin() + 1, to.rend());
  return from;
}

void SurfaceHomology::add_generator(std::size_t i, bool is_reversed,
                                    SurfacePolygons& polygons) const {
  std::vector<VertexId> loop = generator(i);
  if (is_reversed) std::reverse(loop.begin(), loop.end());
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const VertexId from = loop[k], to = loop[(k + 1) % loop.size()];
    // Finds a face at the edge between them by turning around `from`.
    HalfedgeId h = mesh_.halfedge(from);
    while (mesh_.target(h) != to && mesh_.origin(SurfaceMesh::prev(h)) != to) {
      h = mesh_.twin(SurfaceMesh::prev(h));
    }
    polygons.add_segment(polygons.points.add_vertex(from), SurfaceMesh::face(h),
                         SegmentStart::ControlPoint);
  }
  polygons.close();
}

/// Each coefficient of the class is cancelled by as many copies of the generator in the opposite
/// direction.
std::vector<std::uint32_t> SurfaceHomology::add_repair(std::span<const std::uint32_t> shape,
                                                       SurfacePolygons& polygons,
                                                       Context& context) const {
  const std::vector<std::int64_t> times = class_of(polygons, shape, context);
  std::vector<std::uint32_t> added;
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::int64_t k = times[i]; k != 0; k -= k > 0 ? 1 : -1) {
      added.push_back(static_cast<std::uint32_t>(polygons.size()));
      add_generator(i, times[i] > 0, polygons);
      const std::size_t length = polygons.begin.back() - polygons.begin[polygons.size() - 1];
      context.checkpoint("homology", 0, 1);
      context.charge_memory(kPointBytes * length, "loops that repair");
    }
  }
  return added;
}

// ---------------------------------------------------------------- classes

/// Returns a corner of every face that contains the point.
VertexId SurfaceHomology::vertex_at(const SurfacePointTable& points, SurfacePointId p) const {
  switch (points.place(p)) {
    case SurfacePlace::Vertex:
      return points.vertex(p);
    case SurfacePlace::Edge:
      return mesh_.lower(points.edge(p));
    case SurfacePlace::Face:
      break;
  }
  return mesh_.corner(points.face(p), 0);
}

/// Adds the crossings of a polygon with the dual loops. A segment is moved, within its face, to the
/// side between the corners to which its ends are moved.
void SurfaceHomology::count(const SurfacePolygons& polygons, std::size_t polygon,
                            std::int64_t multiplicity, std::vector<std::int64_t>& times,
                            Context& context) const {
  std::size_t steps = 0;
  for (std::uint32_t i = polygons.begin[polygon]; i < polygons.begin[polygon + 1]; ++i) {
    if (++steps > kStepsPerCheckpoint) {
      context.checkpoint("homology", i - polygons.begin[polygon],
                         polygons.begin[polygon + 1] - polygons.begin[polygon]);
      steps = 0;
    }
    const VertexId from = vertex_at(polygons.points, polygons.point[i]);
    const VertexId to = vertex_at(polygons.points, polygons.point[polygons.next(polygon, i)]);
    if (from == to) continue;
    std::size_t side = 0;
    const auto joins = [&](HalfedgeId h) {
      return (mesh_.origin(h) == from && mesh_.target(h) == to) ||
             (mesh_.origin(h) == to && mesh_.target(h) == from);
    };
    while (!joins(SurfaceMesh::halfedge(polygons.face[i], side))) ++side;
    const EdgeId e = mesh_.edge(SurfaceMesh::halfedge(polygons.face[i], side));
    const std::int64_t by = from < to ? multiplicity : -multiplicity;
    for (std::uint32_t k = crossed_begin_[e]; k < crossed_begin_[e.value() + 1]; ++k) {
      times[crossed_[k].id] += by * crossed_[k].value;
    }
    steps += crossed_begin_[e.value() + 1] - crossed_begin_[e];
  }
}

std::vector<std::int64_t> SurfaceHomology::class_of(const SurfacePolygons& polygons,
                                                    std::span<const std::uint32_t> sum,
                                                    Context& context) const {
  std::vector<std::int64_t> times(generators_.size());
  if (times.empty()) return times;
  MemoryCharge charge(context);
  charge.add(sum.size_bytes(), "homology");
  std::vector<std::uint32_t> sorted(sum.begin(), sum.end());
  std::sort(sorted.begin(), sorted.end());
  for (auto i = sorted.begin(); i != sorted.end();) {
    const auto end = std::upper_bound(i, sorted.end(), *i);
    context.checkpoint("homology", static_cast<std::uint64_t>(i - sorted.begin()), sorted.size());
    count(polygons, *i, end - i, times, context);
    i = end;
  }
  return times;
}

std::vector<std::int64_t> SurfaceHomology::class_of(const SurfacePolygons& polygons,
                                                    std::size_t polygon, Context& context) const {
  const auto p = static_cast<std::uint32_t>(polygon);
  return class_of(polygons, std::span(&p, 1), context);
}

}  // namespace plumb
