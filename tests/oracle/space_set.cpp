#include "oracle/space_set.h"

#include <algorithm>
#include <array>

#include "oracle/line_cells.h"

namespace plumb::testing {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

using Sample = SpaceCells::Cell;

const std::array<ExactPoint3, 3>& axes() {
  static const std::array<ExactPoint3, 3> kAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return kAxes;
}

// ---------------------------------------------------------------- planes of leaves

void add_point_planes(const ExactPoint3& p, std::vector<CellPlane>& planes) {
  for (const ExactPoint3& axis : axes()) planes.push_back(plane_at(p, axis));
}

// Planes along an axis through the line, and one across it at each end.
void add_segment_planes(const ExactPoint3& p, const ExactPoint3& q,
                        std::vector<CellPlane>& planes) {
  const ExactPoint3 along = q - p;
  for (const ExactPoint3& axis : axes()) {
    const ExactPoint3 normal = cross(along, axis);
    if (!(normal == ExactPoint3{})) planes.push_back(plane_at(p, normal));
  }
  for (const ExactPoint3& axis : axes()) {
    if (dot(along, axis) == 0) continue;
    planes.push_back(plane_at(p, axis));
    planes.push_back(plane_at(q, axis));
    return;
  }
}

void add_chain_planes(const Chain3& chain, std::vector<CellPlane>& planes) {
  bool is_point = true;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    if (chain[i] == chain[i + 1]) continue;
    is_point = false;
    add_segment_planes(chain[i], chain[i + 1], planes);
  }
  if (is_point && !chain.empty()) add_point_planes(chain.front(), planes);
}

// Newell's normal: zero only for polygons without area.
ExactPoint3 normal_of(const Chain3& corners) {
  ExactPoint3 normal;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    normal = normal + cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  return normal;
}

CellPlane plane_of(const Chain3& corners) { return plane_at(corners.front(), normal_of(corners)); }

// An axis along which the polygon is not seen as a line.
std::size_t steep_axis(const Chain3& corners) {
  const ExactPoint3 n = normal_of(corners);
  return n.z != 0 ? 2 : n.y != 0 ? 1 : 0;
}

void add_polygon_planes(const Chain3& corners, std::vector<CellPlane>& planes) {
  planes.push_back(plane_of(corners));
  const ExactPoint3& axis = axes()[steep_axis(corners)];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactPoint3& p = corners[i];
    planes.push_back(plane_at(p, cross(corners[(i + 1) % corners.size()] - p, axis)));
  }
}

Chain3 face_of(const MeshLeaf& mesh, const std::vector<std::size_t>& face) {
  Chain3 corners;
  for (const std::size_t v : face) corners.push_back(mesh.points[v]);
  return corners;
}

// ---------------------------------------------------------------- membership of leaves

// What is seen along an axis.
ExactPoint seen(const ExactPoint3& p, std::size_t axis) {
  if (axis == 0) return {p.y, p.z};
  return axis == 1 ? ExactPoint{p.z, p.x} : ExactPoint{p.x, p.y};
}
CellPoint seen(const CellPoint3& p, std::size_t axis) {
  if (axis == 0) return {p.v.y, p.v.z, p.w};
  return axis == 1 ? CellPoint{p.v.z, p.v.x, p.w} : CellPoint{p.v.x, p.v.y, p.w};
}

// How often a ray towards +x leaves a mesh less how often it enters it. The ray is moved by
// (0, e, e^2) for an infinitely small e, so that it meets no edge.
class MeshWinding {
 public:
  explicit MeshWinding(const MeshLeaf& mesh) {
    for (const auto& face : mesh.faces) {
      const Chain3 corners = face_of(mesh, face);
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        add(corners[0], corners[i], corners[i + 1]);
      }
    }
  }

  int at(const CellPoint3& p) const {
    int winding = 0;
    for (const Triangle& t : triangles_) winding += crossing(t, p);
    return winding;
  }

 private:
  struct Side {
    CellLine line;  // of the (y, z)-plane
    int if_on_it;   // the side on which (e, e^2) from a point of the line lies
  };
  struct Triangle {
    CellPlane plane;
    std::array<Side, 3> sides;
  };

  // Those parallel to x are never met.
  void add(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
    if (cross(b - a, c - a).x == 0) return;
    triangles_.push_back({plane_through(a, b, c), {side_of(a, b), side_of(b, c), side_of(c, a)}});
  }
  static Side side_of(const ExactPoint3& a, const ExactPoint3& b) {
    const CellLine line = line_through(seen(a, 0), seen(b, 0));
    return {line, line.a != 0 ? line.a.sign() : line.b.sign()};
  }
  static int crossing(const Triangle& t, const CellPoint3& p) {
    const int facing = t.plane.n.x.sign();
    for (const Side& s : t.sides) {
      const int where = side(s.line, seen(p, 0));
      if ((where != 0 ? where : s.if_on_it) != facing) return 0;
    }
    return side(t.plane, p) == -facing ? facing : 0;
  }

  std::vector<Triangle> triangles_;
};

bool is_inside(MeshRule rule, int winding) {
  if (rule == MeshRule::Positive) return winding > 0;
  return rule == MeshRule::Odd ? winding % 2 != 0 : winding != 0;
}

CellMarks marks_of_mesh(const MeshLeaf& mesh, const SpaceCells& cells) {
  const MeshWinding winding(mesh);
  CellMarks marks(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    marks[c] = cells[c].dimension == 3 && is_inside(mesh.rule, winding.at(cells[c].sample));
  }
  return closure_of(cells, marks);
}

template <class Contains>
CellMarks marks_where(const SpaceCells& cells, const Contains& contains) {
  CellMarks marks(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) marks[c] = contains(cells[c]);
  return marks;
}

CellMarks marks_of_half_space(const HalfSpaceLeaf& h, const SpaceCells& cells) {
  const int greatest = h.closed ? 0 : -1;
  return marks_where(cells, [&](const Sample& p) { return side(h.plane, p.sample) <= greatest; });
}

bool lies_on_segment(const ExactPoint3& x, const ExactPoint3& p, const ExactPoint3& q) {
  if (x == p || x == q) return true;
  return cross(x - p, q - p) == ExactPoint3{} && (p < x) != (q < x);
}

// Of a polygon seen along an axis: the boundary, or an odd number of edges to the right.
class PolygonTest {
 public:
  explicit PolygonTest(const Chain3& corners)
      : plane_(plane_of(corners)), axis_(steep_axis(corners)) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ExactPoint3& p = corners[i];
      const ExactPoint3& q = corners[(i + 1) % corners.size()];
      edges_.push_back(
          {seen(p, axis_), seen(q, axis_), line_through(seen(p, axis_), seen(q, axis_))});
    }
  }

  bool contains(const Sample& x) const {
    if (side(plane_, x.sample) != 0) return false;
    const CellPoint sample = seen(x.sample, axis_);
    const ExactPoint point = seen(x.point, axis_);
    bool inside = false;
    for (const Edge& e : edges_) {
      const int where = side(e.line, sample);
      if (where == 0 && (point == e.p || point == e.q || (e.p < point) != (e.q < point))) {
        return true;
      }
      const bool upward = e.p.y <= point.y && point.y < e.q.y;
      const bool downward = e.q.y <= point.y && point.y < e.p.y;
      if ((upward && where > 0) || (downward && where < 0)) inside = !inside;
    }
    return inside;
  }

 private:
  struct Edge {
    ExactPoint p, q;
    CellLine line;
  };
  CellPlane plane_;
  std::size_t axis_;
  std::vector<Edge> edges_;
};

bool contains(const ChainsLeaf& set, const ExactPoint3& x) {
  return std::any_of(set.chains.begin(), set.chains.end(), [&](const Chain3& chain) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (lies_on_segment(x, chain[i], chain[i + 1])) return true;
    }
    return !chain.empty() && chain.front() == x;
  });
}

}  // namespace

SpaceSetPointer apply(SetOperator op, SpaceSetPointer first, SpaceSetPointer second) {
  return space_set(SpaceOperation{op, std::move(first), std::move(second)});
}

SpaceSetPointer empty_space() { return space_set(PointsLeaf{}); }

void add_planes(const SpaceSet& set, std::vector<CellPlane>& planes) {
  std::visit(Overloaded{
                 [&](const HalfSpaceLeaf& h) { planes.push_back(h.plane); },
                 [&](const PlaneLeaf& p) { planes.push_back(p.plane); },
                 [&](const MeshLeaf& m) {
                   for (const auto& face : m.faces) planes.push_back(plane_of(face_of(m, face)));
                 },
                 [&](const PolygonLeaf& p) { add_polygon_planes(p.corners, planes); },
                 [&](const ChainsLeaf& c) {
                   for (const Chain3& chain : c.chains) add_chain_planes(chain, planes);
                 },
                 [&](const PointsLeaf& p) {
                   for (const ExactPoint3& point : p.points) add_point_planes(point, planes);
                 },
                 [&](const SpaceOperation& o) {
                   add_planes(*o.first, planes);
                   if (o.second) add_planes(*o.second, planes);
                 },
             },
             set.node);
}

SpaceCells cells_of(const SpaceSet& set) {
  std::vector<CellPlane> planes;
  add_planes(set, planes);
  return SpaceCells(std::move(planes));
}

CellMarks marks_of(const SpaceSet& set, const SpaceCells& cells) {
  return std::visit(
      Overloaded{
          [&](const HalfSpaceLeaf& h) { return marks_of_half_space(h, cells); },
          [&](const PlaneLeaf& l) {
            return marks_where(cells,
                               [&](const Sample& p) { return side(l.plane, p.sample) == 0; });
          },
          [&](const MeshLeaf& m) { return marks_of_mesh(m, cells); },
          [&](const PolygonLeaf& l) {
            const PolygonTest polygon(l.corners);
            return marks_where(cells, [&](const Sample& p) { return polygon.contains(p); });
          },
          [&](const ChainsLeaf& l) {
            return marks_where(cells, [&](const Sample& p) { return contains(l, p.point); });
          },
          [&](const PointsLeaf& l) {
            return marks_where(cells, [&](const Sample& p) {
              return std::find(l.points.begin(), l.points.end(), p.point) != l.points.end();
            });
          },
          [&](const SpaceOperation& o) {
            return apply(o.op, cells, marks_of(*o.first, cells),
                         o.second ? marks_of(*o.second, cells) : CellMarks());
          },
      },
      set.node);
}

std::optional<BigRational> volume_of(const SpaceCells& cells, const CellMarks& marks) {
  BigRational sum = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension != 3 || !marks[c]) continue;
    if (cells[c].unbounded) return std::nullopt;
    sum += cells.volume_of(c);
  }
  return sum;
}

// ---------------------------------------------------------------- text

namespace {

std::string chain_text(const Chain3& chain) {
  std::string text;
  for (const ExactPoint3& p : chain) text += (text.empty() ? "" : " ") + to_text(p);
  return "[" + text + "]";
}

std::string mesh_text(const MeshLeaf& mesh) {
  static constexpr const char* kRules[] = {"nonzero", "odd", "positive"};
  std::string text = kRules[static_cast<int>(mesh.rule)] + std::string(" mesh ");
  for (const auto& face : mesh.faces) text += chain_text(face_of(mesh, face));
  return text;
}

}  // namespace

std::string to_text(const ExactPoint3& p) {
  return "(" + p.x.str() + "," + p.y.str() + "," + p.z.str() + ")";
}

std::string to_text(const CellPlane& plane) {
  return "<" + plane.n.x.str() + " " + plane.n.y.str() + " " + plane.n.z.str() + " " +
         plane.d.str() + ">";
}

std::string to_text(const SpaceSet& set) {
  return std::visit(
      Overloaded{
          [](const HalfSpaceLeaf& h) {
            return (h.closed ? "closed" : "open") + std::string(" half-space ") + to_text(h.plane);
          },
          [](const PlaneLeaf& p) { return "plane " + to_text(p.plane); },
          [](const MeshLeaf& m) { return mesh_text(m); },
          [](const PolygonLeaf& p) { return "polygon " + chain_text(p.corners); },
          [](const ChainsLeaf& c) {
            std::string text = "chains ";
            for (const Chain3& chain : c.chains) text += chain_text(chain);
            return text;
          },
          [](const PointsLeaf& p) { return "points " + chain_text(p.points); },
          [](const SpaceOperation& o) {
            const std::string first = "(" + testing::to_text(*o.first) + ")";
            if (!o.second) return name_of(o.op) + first;
            return first + " " + name_of(o.op) + " (" + testing::to_text(*o.second) + ")";
          },
      },
      set.node);
}

}  // namespace plumb::testing
