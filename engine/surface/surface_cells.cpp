#include "plumb/surface/surface_cells.h"

#include <algorithm>
#include <cmath>

#include "plumb/base/union_find.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = SurfaceArrangement::kNone;

/// Of sides scaled by a power of two where products would over- or underflow. What is beyond doubles is
/// the largest.
double triangle_area(const SurfaceMesh& mesh, FaceId f) {
  const Point3 &a = mesh.point(mesh.corner(f, 0)), &b = mesh.point(mesh.corner(f, 1)),
               &c = mesh.point(mesh.corner(f, 2));
  // Halves, as differences of large numbers are none.
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

/// No more than the largest double.
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
  bool is_touched(FaceId f) const { return a_.slot_of_face[f.value()] != kNone; }
  std::uint32_t node_of(FaceId f) const {
    return static_cast<std::uint32_t>(a_.piece_count()) + f.value();
  }
  PieceId piece_of(HalfedgeId h) const { return a_.piece[h.value()]; }

  void join_pieces() {
    for (std::uint32_t i = 0; i < a_.halfedge_count(); ++i) {
      const HalfedgeId t = a_.twin[i];
      if (t.is_valid() && t.value() > i && !a_.arc[i].is_valid()) {
        joined_.unite(a_.piece[i].value(), piece_of(t).value());
      }
    }
  }

  /// Whole faces with each other, and with the one piece at the side of a touched face.
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
      const std::uint32_t slot = a_.slot_of_face[g.value()];
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
        cells_.of_piece[p.value()] = cell_of(p.value(), mesh_.component(f));
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
        add_area(area, cells_.area[cells_.of_face[i].value()]);
      } else {
        for (std::uint32_t p = a_.piece_begin[slot].value(); p < a_.piece_begin[slot + 1].value();
             ++p) {
          add_area(area * a_.piece_share[p], cells_.area[cells_.of_piece[p].value()]);
        }
      }
      for (std::size_t side = 0; side < 3; ++side) {
        if (mesh_.is_border(SurfaceMesh::halfedge(f, side))) mark_border(f, side);
      }
    }
  }
  void mark_border(FaceId f, std::size_t side) {
    const std::uint32_t slot = a_.slot_of_face[f.value()];
    if (slot == kNone) {
      cells_.is_at_border[cells_.of_face[f.value()].value()] = 1;
      return;
    }
    for (std::uint32_t h = a_.side_begin[4 * slot + side]; h < a_.side_begin[4 * slot + side + 1];
         ++h) {
      cells_.is_at_border[cells_.of_piece[a_.piece[h].value()].value()] = 1;
    }
  }

  // ---------------------------------------------------------------- graph

  void link() {
    for (std::uint32_t i = 0; i < a_.arc_count(); ++i) {
      const HalfedgeId h = a_.arc_halfedge[i], t = a_.twin[h.value()];
      if (!t.is_valid()) continue;  // along the mesh border
      const CellId left = cells_.of_piece[piece_of(h).value()];
      const CellId right = cells_.of_piece[piece_of(t).value()];
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
    cells_.edges.shrink_to_fit();  // there was one for each arc
  }

  /// By cells, then by the signed bundles.
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
  UnionFind joined_;  // pieces, then faces
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
  const std::uint32_t slot = arrangement.slot_of_face[f.value()];
  if (slot == kNone) return cells.of_face[f.value()];
  const HalfedgeId h(arrangement.sides_begin(slot));
  return cells.of_piece[arrangement.piece[h.value()].value()];
}

}  // namespace plumb
