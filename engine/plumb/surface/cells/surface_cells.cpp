// Cells of a divided surface and the borders of selections.
//
// Cells are the classes of pieces and whole faces under joins across half-edges that carry no arc;
// a union-find over both finds them (docs/design/surface.md, section Slicing, Lemma 2). Edges of
// their graph are kept once for each pair of cells and signed bundle, so the cost of labels depends
// on the number of different edges, not on the lengths of borders. Areas are sums of triangle areas
// times rounded shares of pieces. No decision depends on them.
//
// BorderTracer walks around the selected cells over darts: half-edges of the arrangement, or of the
// mesh in faces that nothing touches. At a node it turns within the selected cells, so pinch points
// separate correctly and each loop has the selection to its left.
// Tested by tests/surface/surface_labels_test.cpp and tests/surface/surface_test.cpp.
#include "plumb/surface/cells/surface_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plumb/base/internal/union_find.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

/// Returns the area of a face. If products would overflow or underflow, the sides are scaled by a
/// power of two. An area that exceeds all doubles becomes the greatest double.
double triangle_area(const SurfaceMesh& mesh, FaceId f) {
  const Point3 &a = mesh.point(mesh.corner(f, 0)), &b = mesh.point(mesh.corner(f, 1)),
               &c = mesh.point(mesh.corner(f, 2));
  // Halves are used because differences of large numbers may overflow.
  Point3 u{b.x / 2 - a.x / 2, b.y / 2 - a.y / 2, b.z / 2 - a.z / 2};
  Point3 v{c.x / 2 - a.x / 2, c.y / 2 - a.y / 2, c.z / 2 - a.z / 2};
  const double largest = std::max({std::fabs(u.x), std::fabs(u.y), std::fabs(u.z), std::fabs(v.x),
                                   std::fabs(v.y), std::fabs(v.z)});
  int scale = 0;
  if (largest < 0x1p-200 || largest > 0x1p200) {
    std::frexp(largest, &scale);
    for (Point3* p : {&u, &v}) {
      *p = {std::ldexp(p->x, -scale), std::ldexp(p->y, -scale), std::ldexp(p->z, -scale)};
    }
  }
  const double x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
  const double area = 2 * std::sqrt(x * x + y * y + z * z);
  if (scale == 0) return area;
  return clamped_to_finite(std::ldexp(area, 2 * scale));
}

/// Adds to a sum, which is at most the greatest double and therefore remains finite.
void add_area(double area, double& sum) { sum = clamped_to_finite(sum + area); }

class CellMaker {
 public:
  CellMaker(const SurfaceMesh& mesh, const SurfaceArrangement& arrangement)
      : mesh_(mesh), a_(arrangement), joined_(a_.piece_count() + mesh.face_count()) {}

  SurfaceCells run() {
    join_pieces();
    join_faces();
    number();
    measure();
    link();
    return std::move(cells_);
  }

 private:
  bool is_touched(FaceId f) const { return a_.slot_of_face[f] != kNone; }
  std::uint32_t node_of(FaceId f) const {
    return static_cast<std::uint32_t>(a_.piece_count()) + f.value();
  }
  PieceId piece_of(HalfedgeId h) const { return a_.piece[h]; }

  void join_pieces() {
    for (std::uint32_t i = 0; i < a_.halfedge_count(); ++i) {
      const HalfedgeId t = a_.twin[i];
      if (t.is_valid() && t.value() > i && !a_.arc[i].is_valid()) {
        joined_.unite(a_.piece[i].value(), piece_of(t).value());
      }
    }
  }

  /// Joins whole faces with each other, and with the one piece at the side of a touched face.
  void join_faces() {
    for (std::uint32_t i = 0; i < 3 * mesh_.face_count(); ++i) {
      const HalfedgeId h(i), t = mesh_.twin(h);
      const FaceId f = SurfaceMesh::face(h);
      if (!t.is_valid() || is_touched(f)) continue;
      const FaceId g = SurfaceMesh::face(t);
      if (!is_touched(g)) {
        if (f < g) joined_.unite(node_of(f), node_of(g));
        continue;
      }
      const std::uint32_t slot = a_.slot_of_face[g];
      const HalfedgeId side(a_.side_begin[4 * slot + SurfaceMesh::side(t)]);
      joined_.unite(node_of(f), piece_of(side).value());
    }
  }

  CellId cell_of(std::uint32_t node, std::uint32_t component) {
    CellId& c = cell_of_root_[joined_.root(node)];
    if (!c.is_valid()) {
      c = CellId(cells_.component.size());
      cells_.component.push_back(component);
    }
    return c;
  }
  /// Numbers cells in the order of faces and pieces, which does not depend on how the union-find
  /// joined them.
  void number() {
    cell_of_root_.assign(joined_.size(), CellId{});
    cells_.of_piece.resize(a_.piece_count());
    cells_.of_face.resize(mesh_.face_count());
    for (std::uint32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      const std::uint32_t slot = a_.slot_of_face[i];
      if (slot == kNone) {
        cells_.of_face[i] = cell_of(node_of(f), mesh_.component(f));
        continue;
      }
      for (PieceId p = a_.piece_begin[slot]; p < a_.piece_begin[slot + 1];
           p = PieceId(p.value() + std::size_t{1})) {
        cells_.of_piece[p] = cell_of(p.value(), mesh_.component(f));
      }
    }
  }

  void measure() {
    cells_.area.resize(cells_.component.size());
    cells_.is_at_border.resize(cells_.component.size());
    for (std::uint32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      const double area = triangle_area(mesh_, f);
      const std::uint32_t slot = a_.slot_of_face[i];
      if (slot == kNone) {
        add_area(area, cells_.area[cells_.of_face[i]]);
      } else {
        for (std::uint32_t p = a_.piece_begin[slot].value(); p < a_.piece_begin[slot + 1].value();
             ++p) {
          add_area(area * a_.piece_share[p], cells_.area[cells_.of_piece[p]]);
        }
      }
      for (std::size_t side = 0; side < 3; ++side) {
        if (mesh_.is_border(SurfaceMesh::halfedge(f, side))) mark_border(f, side);
      }
    }
  }
  void mark_border(FaceId f, std::size_t side) {
    const std::uint32_t slot = a_.slot_of_face[f];
    if (slot == kNone) {
      cells_.is_at_border[cells_.of_face[f]] = 1;
      return;
    }
    for (std::uint32_t h = a_.side_begin[4 * slot + side]; h < a_.side_begin[4 * slot + side + 1];
         ++h) {
      cells_.is_at_border[cells_.of_piece[a_.piece[h]].value()] = 1;
    }
  }

  // ---------------------------------------------------------------- graph

  /// Adds an edge for each arc with cells on both sides, directed from the lower cell, and drops
  /// equal edges. An arc from a cell to itself is kept, with the sign that makes its first entry
  /// positive, because it may prove that a shape has no label.
  void link() {
    for (std::uint32_t i = 0; i < a_.arc_count(); ++i) {
      const HalfedgeId h = a_.arc_halfedge[i], t = a_.twin[h];
      if (!t.is_valid()) continue;  // The arc lies on the border of the mesh.
      const CellId left = cells_.of_piece[piece_of(h)];
      const CellId right = cells_.of_piece[piece_of(t)];
      const std::uint32_t bundle = a_.arc_bundle[i];
      std::int32_t sign = right <= left ? 1 : -1;
      if (left == right && a_.bundles[bundle].front().value < 0) sign = -1;
      cells_.edges.push_back({std::min(left, right), std::max(left, right), bundle, sign});
    }
    std::sort(cells_.edges.begin(), cells_.edges.end(),
              [&](const CellEdge& a, const CellEdge& b) { return compare(a, b) < 0; });
    const auto end =
        std::unique(cells_.edges.begin(), cells_.edges.end(),
                    [&](const CellEdge& a, const CellEdge& b) { return compare(a, b) == 0; });
    cells_.edges.erase(end, cells_.edges.end());
    cells_.edges.shrink_to_fit();  // Until here, there was one edge for each arc.
  }

  /// Compares edges by their cells, then by the signed bundles.
  std::strong_ordering compare(const CellEdge& a, const CellEdge& b) const {
    if (const auto order = a.from <=> b.from; order != 0) return order;
    if (const auto order = a.to <=> b.to; order != 0) return order;
    if (a.bundle == b.bundle) return a.sign <=> b.sign;
    const auto p = a_.bundles[a.bundle], q = a_.bundles[b.bundle];
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
      if (const auto order = p[i].id <=> q[i].id; order != 0) return order;
      if (const auto order = p[i].value * a.sign <=> q[i].value * b.sign; order != 0) return order;
    }
    return p.size() <=> q.size();
  }

  const SurfaceMesh& mesh_;
  const SurfaceArrangement& a_;
  UnionFind joined_;  // The pieces, followed by the faces.
  std::vector<CellId> cell_of_root_;
  SurfaceCells cells_;
};

}  // namespace

SurfaceCells make_cells(const SurfaceMesh& mesh, const SurfaceArrangement& arrangement,
                        Context& context) {
  context.checkpoint("cells", 0, 1);
  return CellMaker(mesh, arrangement).run();
}

CellId cell_at_corner(const SurfaceArrangement& arrangement, const SurfaceCells& cells, FaceId f) {
  const std::uint32_t slot = arrangement.slot_of_face[f];
  if (slot == kNone) return cells.of_face[f];
  const HalfedgeId h(arrangement.sides_begin(slot));
  return cells.of_piece[arrangement.piece[h]];
}

namespace {

constexpr std::uint32_t kBorderStepsPerCheckpoint = 4096;
constexpr std::uint64_t kStepBytes = 64;  // The memory of a point of a loop.

/// A half-edge of the arrangement, or of the mesh in a face that is not touched.
struct Dart {
  bool is_of_mesh;
  HalfedgeId h;
};

class BorderTracer {
 public:
  BorderTracer(const SurfacePolygons& polygons, const SurfaceArrangement& arrangement,
               const SurfaceCells& cells, std::span<const std::uint8_t> is_selected,
               std::span<const std::uint32_t> generators, Context& context)
      : polygons_(polygons),
        mesh_(polygons.points.mesh()),
        a_(arrangement),
        cells_(cells),
        is_selected_(is_selected),
        context_(context),
        charge_(context),
        out_(mesh_),
        is_generator_(polygons.size()) {
    for (const std::uint32_t p : generators) is_generator_[p] = 1;
    find_control_nodes();
  }

  SurfacePolygons run() {
    is_used_.resize(a_.halfedge_count());
    for (std::uint32_t i = 0; i < a_.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (i % kBorderStepsPerCheckpoint == 0)
        context_.checkpoint("borders", i, a_.halfedge_count());
      if (is_used_[i] == 0 && is_border_arc(h)) trace({false, h});
    }
    return std::move(out_);
  }

 private:
  // ---------------------------------------------------------------- what is where

  void find_control_nodes() {
    is_control_.resize(a_.node_count());
    for (std::uint32_t p = 0; p < polygons_.size(); ++p) {
      for (std::uint32_t i = polygons_.begin[p]; i < polygons_.begin[p + 1]; ++i) {
        if (is_generator_[p] != 0 && polygons_.is_control[i] != 0) {
          is_control_[a_.node_of_entry[i].value()] = 1;
        }
      }
    }
    const auto ends = arc_ends(a_, [&](ArcId a) { return carries_generator(a); });
    for (std::size_t n = 0; n < ends.size(); ++n) {
      if (ends[n] == kCrossingEnds) is_control_[n] = 1;
    }
  }
  bool carries_generator(ArcId a) const {
    return std::ranges::any_of(a_.multiplicities(a),
                               [&](const SignedEntry& e) { return is_generator_[e.id] != 0; });
  }

  bool is_inside(HalfedgeId h) const {
    return is_selected_[cells_.of_piece[a_.piece[h]].value()] != 0;
  }
  bool is_border_arc(HalfedgeId h) const {
    const HalfedgeId t = a_.twin[h];
    return a_.arc[h].is_valid() && t.is_valid() && is_inside(h) && !is_inside(t);
  }

  // ---------------------------------------------------------------- walking

  Dart next(Dart d) const {
    return d.is_of_mesh ? Dart{true, SurfaceMesh::next(d.h)} : Dart{false, a_.next[d.h]};
  }
  FaceId face(Dart d) const {
    return d.is_of_mesh ? SurfaceMesh::face(d.h) : a_.face_of(a_.piece[d.h]);
  }

  /// Returns the twin, or an invalid id at the border of the mesh.
  Dart twin(Dart d) const {
    HalfedgeId side = d.h;
    if (!d.is_of_mesh) {
      if (const HalfedgeId t = a_.twin[d.h]; t.is_valid()) return {false, t};
      side = mesh_halfedge(d.h);
    }
    // No node lies inside an edge of a face that is not touched.
    const HalfedgeId across = mesh_.twin(side);
    if (!across.is_valid()) return {true, across};
    const std::uint32_t slot = a_.slot_of_face[SurfaceMesh::face(across)];
    if (slot == kNone) return {true, across};
    return {false, HalfedgeId(a_.side_begin[4 * slot + SurfaceMesh::side(across)])};
  }
  /// Returns the side of its face that a half-edge lies on.
  HalfedgeId mesh_halfedge(HalfedgeId h) const {
    const std::uint32_t slot = a_.piece_slot[a_.piece[h]];
    std::size_t side = 0;
    while (a_.side_begin[4 * slot + side + 1] <= h.value()) ++side;
    return SurfaceMesh::halfedge(a_.slot_face[slot], side);
  }

  /// Returns the dart of the border after d. The selected side is on the left.
  Dart next_border(Dart d) const {
    for (d = next(d);; d = next(d)) {
      if (!d.is_of_mesh && is_border_arc(d.h)) return d;
      const Dart across = twin(d);
      if (!across.h.is_valid()) return d;
      d = across;
    }
  }

  void trace(Dart first) {
    Dart last = first;
    for (Dart d = next_border(first);; d = next_border(d)) {
      visit(last, d);
      last = d;
      if (!d.is_of_mesh && d.h == first.h) break;
    }
    out_.close();
  }

  /// Adds the segment that starts with d, which follows `last`.
  void visit(Dart last, Dart d) {
    if (++steps_ % kBorderStepsPerCheckpoint == 0) {
      context_.checkpoint("borders", 0, 1);
      charge_.add(kStepBytes * kBorderStepsPerCheckpoint, "borders");
    }
    if (!d.is_of_mesh) is_used_[d.h] = 1;
    if (d.is_of_mesh) {
      out_.add_segment(out_.points.add_vertex(mesh_.origin(d.h)), face(d), SegmentStart::PathPoint);
      return;
    }
    const NodeId n = a_.origin[d.h];
    const bool is_control = is_control_[n] != 0;
    const bool is_straight = a_.is_crossing(n) && !is_control && !last.is_of_mesh;
    if (is_straight) return;
    out_.add_segment(add_node_point(a_, polygons_.points, n, out_.points), face(d),
                     is_control ? SegmentStart::ControlPoint : SegmentStart::PathPoint);
  }

  const SurfacePolygons& polygons_;
  const SurfaceMesh& mesh_;
  const SurfaceArrangement& a_;
  const SurfaceCells& cells_;
  std::span<const std::uint8_t> is_selected_;
  Context& context_;
  MemoryCharge charge_;
  std::size_t steps_ = 0;
  SurfacePolygons out_;
  std::vector<std::uint8_t> is_generator_;      // For each polygon.
  IdVector<NodeId, std::uint8_t> is_control_;   // For each node.
  IdVector<HalfedgeId, std::uint8_t> is_used_;  // For each half-edge.
};

}  // namespace

SurfacePolygons trace_borders(const SurfacePolygons& polygons,
                              const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                              std::span<const std::uint8_t> is_selected,
                              std::span<const std::uint32_t> generators, Context& context) {
  return BorderTracer(polygons, arrangement, cells, is_selected, generators, context).run();
}

}  // namespace plumb
