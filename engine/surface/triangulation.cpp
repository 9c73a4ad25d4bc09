#include "plumb/surface/triangulation.h"

#include <algorithm>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/space/triangulate.h"
#include "plumb/surface/piece_points.h"
#include "plumb/surface/surface_arrangement.h"
#include "plumb/surface/surface_cells.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = SurfaceTriangulation::kNone;
constexpr std::uint64_t kBytesPerTriangle = 56;  // 44 in the result, 12 for sides of the mesh
constexpr std::uint64_t kBytesPerPoint = 32;

class SurfaceTriangulator {
 public:
  explicit SurfaceTriangulator(const SurfaceDivision& division)
      : d_(division),
        mesh_(division.mesh()),
        a_(division.arrangement()),
        cells_(division.cells()),
        points_(division) {}

  SurfaceTriangulation run(Context& context) {
    MemoryCharge memory(context);
    const std::size_t triangles = mesh_.face_count() + a_.halfedge_count();
    memory.add(
        kBytesPerTriangle * triangles + kBytesPerPoint * (mesh_.vertex_count() + a_.node_count()),
        "triangles of a surface");
    reserve(triangles);
    add_points();
    side_of_halfedge_.assign(a_.halfedge_count(), kNone);
    side_of_mesh_.assign(3 * mesh_.face_count(), kNone);
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (f % 4096 == 0) context.checkpoint("triangulate", f, mesh_.face_count());
      const std::uint32_t slot = a_.slot_of_face[f];
      if (slot == SurfaceArrangement::kNone) {
        add_whole(FaceId(f));
        continue;
      }
      for (std::uint32_t p = a_.piece_begin[slot].value(); p < a_.piece_begin[slot + 1].value();
           ++p) {
        add_piece(PieceId(p), FaceId(f));
      }
    }
    sew();
    return std::move(out_);
  }

 private:
  /// Whole faces are triangles, and most pieces have fewer than sides.
  void reserve(std::size_t triangles) {
    const std::size_t points = mesh_.vertex_count() + a_.node_count();
    out_.points.reserve(points);
    out_.node.reserve(points);
    out_.triangles.reserve(triangles);
    out_.face.reserve(triangles);
    out_.cell.reserve(triangles);
    out_.across.reserve(3 * triangles);
    out_.arc.reserve(3 * triangles);
  }

  /// Vertices of the mesh, then other nodes that half-edges start in.
  void add_points() {
    out_.node.assign(mesh_.vertex_count(), NodeId{});
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      out_.points.push_back(mesh_.point(VertexId(v)));
    }
    point_of_node_.assign(a_.node_count(), kNone);
    for (const NodeId n : a_.origin) {
      std::uint32_t& point = point_of_node_[n.value()];
      if (point != kNone) continue;
      const VertexId v = vertex_of(n);
      point = v.is_valid() ? v.value() : static_cast<std::uint32_t>(out_.points.size());
      if (v.is_valid()) {
        out_.node[point] = n;
        continue;
      }
      out_.points.push_back(node_position(d_, n));
      out_.node.push_back(n);
    }
  }
  VertexId vertex_of(NodeId n) const {
    const SurfacePointTable& points = d_.scene().polygons.points;
    if (a_.is_crossing(n)) return {};
    if (!a_.is_input(n)) return a_.corner(n);
    const SurfacePointId p = a_.input(n);
    return points.place(p) == SurfacePlace::Vertex ? points.vertex(p) : VertexId{};
  }

  std::uint32_t add_triangle(const SurfaceTriangle& t, FaceId f, CellId c) {
    const auto first = static_cast<std::uint32_t>(3 * out_.triangles.size());
    out_.triangles.push_back(t);
    out_.face.push_back(f);
    out_.cell.push_back(c);
    out_.across.insert(out_.across.end(), 3, kNone);
    out_.arc.insert(out_.arc.end(), 3, ArcId{});
    return first;
  }
  void add_whole(FaceId f) {
    const std::uint32_t first = add_triangle(mesh_.corners(f), f, cells_.of_face[f.value()]);
    for (std::uint32_t i = 0; i < 3; ++i) side_of_mesh_[3 * f.value() + i] = first + i;
  }

  // ---------------------------------------------------------------- pieces

  void add_piece(PieceId p, FaceId f) {
    gather(p);
    local_.clear();
    if (edges_.size() == 3 && nodes_.size() == 3) {
      local_.push_back({edges_[0][0], edges_[1][0], edges_[2][0]});
    } else {
      points_.reset(f);
      for (const NodeId n : nodes_) points_.push_back(n);
      PLUMB_CHECK(triangulate(points_, edges_, local_));
      make_delaunay(points_, edges_, local_);
    }
    sides_.clear();
    for (const IndexTriangle& t : local_) {
      SurfaceTriangle named;
      for (std::size_t i = 0; i < 3; ++i) named[i] = point_of_node_[nodes_[t[i]].value()];
      const std::uint32_t first = add_triangle(named, f, cells_.of_piece[p.value()]);
      for (std::uint32_t i = 0; i < 3; ++i) {
        sides_.push_back({{t[i], t[(i + 1) % 3]}, first + i});
      }
    }
    std::sort(sides_.begin(), sides_.end());
    join_sides();
  }

  /// The half-edges around a piece, in the order of its loops, between its nodes in ascending order.
  void gather(PieceId p) {
    halfedges_.clear();
    nodes_.clear();
    for (std::uint32_t l = a_.loop_begin[p.value()]; l < a_.loop_begin[p.value() + 1]; ++l) {
      HalfedgeId h = a_.loop[l];
      do {
        halfedges_.push_back(h);
        nodes_.push_back(a_.origin[h.value()]);
        h = a_.next[h.value()];
      } while (h != a_.loop[l]);
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    const auto local = [&](NodeId n) {
      return static_cast<std::uint32_t>(std::lower_bound(nodes_.begin(), nodes_.end(), n) -
                                        nodes_.begin());
    };
    edges_.clear();
    for (const HalfedgeId h : halfedges_) {
      edges_.push_back({local(a_.origin[h.value()]), local(a_.target(h))});
    }
  }

  struct Side {
    IndexEdge ends;
    std::uint32_t side;
    friend auto operator<=>(const Side&, const Side&) = default;
  };
  std::uint32_t side_between(std::uint32_t from, std::uint32_t to) const {
    const IndexEdge ends = {from, to};
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), Side{ends, 0});
    return at != sides_.end() && at->ends == ends ? at->side : kNone;
  }
  void join_sides() {
    for (const Side& s : sides_) {
      out_.across[s.side] = side_between(s.ends[1], s.ends[0]);
    }
    for (std::size_t i = 0; i < halfedges_.size(); ++i) {
      const std::uint32_t side = side_between(edges_[i][0], edges_[i][1]);
      side_of_halfedge_[halfedges_[i].value()] = side;
      out_.across[side] = kNone;
      out_.arc[side] = a_.arc[halfedges_[i].value()];
    }
  }

  // ---------------------------------------------------------------- between pieces and faces

  void sew() {
    for (std::uint32_t h = 0; h < a_.halfedge_count(); ++h) {
      const HalfedgeId t = a_.twin[h];
      if (t.is_valid()) out_.across[side_of_halfedge_[h]] = side_of_halfedge_[t.value()];
    }
    for (std::uint32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
      const HalfedgeId t = mesh_.twin(HalfedgeId(h));
      if (side_of_mesh_[h] == kNone || !t.is_valid()) continue;
      std::uint32_t other = side_of_mesh_[t.value()];
      if (other == kNone) {
        const std::uint32_t slot = a_.slot_of_face[SurfaceMesh::face(t).value()];
        other = side_of_halfedge_[a_.side_begin[4 * slot + SurfaceMesh::side(t)]];
        out_.across[other] = side_of_mesh_[h];
      }
      out_.across[side_of_mesh_[h]] = other;
    }
  }

  const SurfaceDivision& d_;
  const SurfaceMesh& mesh_;
  const SurfaceArrangement& a_;
  const SurfaceCells& cells_;
  PiecePoints points_;
  std::vector<std::uint32_t> point_of_node_;
  std::vector<std::uint32_t> side_of_halfedge_;
  std::vector<std::uint32_t> side_of_mesh_;  // of whole faces
  // Of one piece:
  std::vector<HalfedgeId> halfedges_;
  std::vector<NodeId> nodes_;
  std::vector<IndexEdge> edges_;
  std::vector<IndexTriangle> local_;
  std::vector<Side> sides_;
  SurfaceTriangulation out_;
};

}  // namespace

SurfaceTriangulation triangulate_surface(const SurfaceDivision& division, Context& context) try {
  return SurfaceTriangulator(division).run(context);
} catch (...) {
  rethrow_refused_memory();
}

Point3 node_position(const SurfaceDivision& division, NodeId node) {
  const SurfaceArrangement& a = division.arrangement();
  const SurfaceMesh& mesh = division.mesh();
  if (a.is_input(node)) return division.scene().polygons.points.position(a.input(node));
  if (!a.is_crossing(node)) return mesh.point(a.corner(node));
  const SurfaceCrossing& c = a.crossing(node);
  const Point3 &p = mesh.point(mesh.corner(c.face, 0)), &q = mesh.point(mesh.corner(c.face, 1)),
               &r = mesh.point(mesh.corner(c.face, 2));
  const double u = c.approx.x, v = c.approx.y, w = 1 - u - v;
  return {w * p.x + u * q.x + v * r.x, w * p.y + u * q.y + v * r.y, w * p.z + u * q.z + v * r.z};
}

}  // namespace plumb
