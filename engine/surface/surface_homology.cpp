#include "plumb/surface/surface_homology.h"

#include <algorithm>

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr std::uint8_t kTree = 1;
constexpr std::uint8_t kCotree = 2;

}  // namespace

SurfaceHomology::SurfaceHomology(const SurfaceMesh& mesh) : mesh_(mesh) {
  is_in_tree_.assign(mesh.edge_count(), 0);
  grow_tree();
  find_disks();
  grow_cotree();
  for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
    if (is_in_tree_[e] == 0) generators_.push_back(EdgeId(e));
  }
}

VertexId SurfaceHomology::across(EdgeId e, VertexId v) const {
  return mesh_.lower(e) == v ? mesh_.upper(e) : mesh_.lower(e);
}

void SurfaceHomology::grow_tree() {
  parent_.assign(mesh_.vertex_count(), EdgeId{});
  std::vector<std::uint8_t> is_seen(mesh_.vertex_count());
  std::vector<VertexId> queue;
  for (std::uint32_t root = 0; root < mesh_.vertex_count(); ++root) {
    if (is_seen[root] != 0) continue;
    is_seen[root] = 1;
    std::size_t at = queue.size();
    queue.emplace_back(root);
    const auto reach = [&](HalfedgeId h, VertexId from) {
      const VertexId to = across(mesh_.edge(h), from);
      if (is_seen[to.value()] != 0) return;
      is_seen[to.value()] = 1;
      is_in_tree_[mesh_.edge(h).value()] = kTree;
      parent_[to.value()] = mesh_.edge(h);
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

/// One disk for each closed walk along the border.
void SurfaceHomology::find_disks() {
  const std::size_t n = 3 * mesh_.face_count();
  disk_of_.assign(n, kNone);
  disk_begin_ = {0};
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!mesh_.is_border(HalfedgeId(i)) || disk_of_[i] != kNone) continue;
    const auto disk = static_cast<std::uint32_t>(disk_begin_.size() - 1);
    for (HalfedgeId h(i); disk_of_[h.value()] == kNone;) {
      disk_of_[h.value()] = disk;
      disk_halfedges_.push_back(h);
      h = SurfaceMesh::next(h);
      while (!mesh_.is_border(h)) h = SurfaceMesh::next(mesh_.twin(h));
    }
    disk_begin_.push_back(static_cast<std::uint32_t>(disk_halfedges_.size()));
  }
}

void SurfaceHomology::grow_cotree() {
  const auto faces = static_cast<std::uint32_t>(mesh_.face_count());
  std::vector<std::uint8_t> is_seen(faces + disk_begin_.size() - 1);
  const auto reach = [&](std::uint32_t node, HalfedgeId over) {
    std::uint8_t& use = is_in_tree_[mesh_.edge(over).value()];
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
        reach(t.is_valid() ? SurfaceMesh::face(t).value() : faces + disk_of_[h.value()], h);
      }
    }
  }
}

// ---------------------------------------------------------------- generators

std::vector<VertexId> SurfaceHomology::to_root(VertexId v) const {
  std::vector<VertexId> path = {v};
  while (parent_[v.value()].is_valid()) {
    v = across(parent_[v.value()], v);
    path.push_back(v);
  }
  return path;
}

/// Up the edge, and home over the tree.
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
    // A face at the edge between them: turning around `from`.
    HalfedgeId h = mesh_.halfedge(from);
    while (mesh_.target(h) != to && mesh_.origin(SurfaceMesh::prev(h)) != to) {
      h = mesh_.twin(SurfaceMesh::prev(h));
    }
    polygons.add_segment(polygons.points.add_vertex(from), SurfaceMesh::face(h), true);
  }
  polygons.close();
}

std::vector<std::uint32_t> SurfaceHomology::add_repair(std::span<const std::uint32_t> shape,
                                                       SurfacePolygons& polygons) const {
  const std::vector<std::int64_t> times = class_of(polygons, shape);
  std::vector<std::uint32_t> added;
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::int64_t k = times[i]; k != 0; k -= k > 0 ? 1 : -1) {
      added.push_back(static_cast<std::uint32_t>(polygons.size()));
      add_generator(i, times[i] > 0, polygons);
    }
  }
  return added;
}

// ---------------------------------------------------------------- classes

/// A corner of every face that the point lies in.
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

/// A segment moves, within its face, to the side between the corners that its ends move to.
void SurfaceHomology::push(const SurfacePolygons& polygons, std::size_t polygon,
                           std::vector<std::int64_t>& chain) const {
  for (std::uint32_t i = polygons.begin[polygon]; i < polygons.begin[polygon + 1]; ++i) {
    const VertexId from = vertex_at(polygons.points, polygons.point[i]);
    const VertexId to = vertex_at(polygons.points, polygons.point[polygons.next(polygon, i)]);
    if (from == to) continue;
    for (std::size_t side = 0; side < 3; ++side) {
      const HalfedgeId h = SurfaceMesh::halfedge(polygons.face[i], side);
      const bool is_along = mesh_.origin(h) == from && mesh_.target(h) == to;
      const bool is_against = mesh_.origin(h) == to && mesh_.target(h) == from;
      if (is_along || is_against) chain[mesh_.edge(h).value()] += from < to ? 1 : -1;
    }
  }
}

/// From the roots on: as often as needed the boundary of a node is added, so that nothing is left on the edge to
/// its parent. What that changes on the edges to its children is cleared with them.
void SurfaceHomology::clear_cotree(std::vector<std::int64_t>& chain) const {
  const auto faces = static_cast<std::uint32_t>(mesh_.face_count());
  std::vector<HalfedgeId> sides;
  for (const Step& s : cotree_) {
    if (!s.edge.is_valid() || chain[s.edge.value()] == 0) continue;
    sides.clear();
    if (s.node >= faces) {
      const std::uint32_t disk = s.node - faces;
      sides.assign(disk_halfedges_.begin() + disk_begin_[disk],
                   disk_halfedges_.begin() + disk_begin_[disk + 1]);
    } else {
      for (std::size_t k = 0; k < 3; ++k) sides.push_back(SurfaceMesh::halfedge(FaceId(s.node), k));
    }
    const auto sign = [&](HalfedgeId h) { return mesh_.is_upward(h) ? 1 : -1; };
    const auto own = std::find_if(sides.begin(), sides.end(),
                                  [&](HalfedgeId h) { return mesh_.edge(h) == s.edge; });
    const std::int64_t times = chain[s.edge.value()] * sign(*own);
    for (const HalfedgeId h : sides) chain[mesh_.edge(h).value()] -= times * sign(h);
  }
}

std::vector<std::int64_t> SurfaceHomology::class_of(const SurfacePolygons& polygons,
                                                    std::span<const std::uint32_t> sum) const {
  std::vector<std::int64_t> chain(mesh_.edge_count());
  for (const std::uint32_t p : sum) push(polygons, p, chain);
  clear_cotree(chain);
  std::vector<std::int64_t> times;
  for (const EdgeId e : generators_) times.push_back(chain[e.value()]);
  return times;
}

std::vector<std::int64_t> SurfaceHomology::class_of(const SurfacePolygons& polygons,
                                                    std::size_t polygon) const {
  const auto p = static_cast<std::uint32_t>(polygon);
  return class_of(polygons, std::span(&p, 1));
}

}  // namespace plumb
