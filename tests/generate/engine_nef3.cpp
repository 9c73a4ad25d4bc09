// Expressions of the tests into the engine.
#include "oracle/nef3_check.h"

namespace plumb::testing {
namespace {

bool as_doubles(const std::vector<ExactPoint3>& points, std::vector<Point3>& result) {
  result.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!as_double(points[i], result[i])) return false;
  }
  return true;
}

WindingRule rule_of(MeshRule rule) {
  if (rule == MeshRule::Positive) return WindingRule::Positive;
  return rule == MeshRule::Odd ? WindingRule::EvenOdd : WindingRule::NonZero;
}

void add_face(const std::vector<std::size_t>& face, PolygonMesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (const std::size_t v : face) corners.push_back(static_cast<std::uint32_t>(v));
  mesh.add_face(corners);
}

struct ToNef {
  Nef3 operator()(const HalfSpaceLeaf& h) const {
    return Nef3::half_space(to_plane(h.plane), h.closed ? Boundary::Closed : Boundary::Open);
  }
  Nef3 operator()(const PlaneLeaf& p) const { return Nef3::plane(to_plane(p.plane)); }

  // Coordinates that are no doubles: what is below all its faces. Such meshes are convex here.
  Nef3 operator()(const MeshLeaf& m) const {
    Context context;
    PolygonMesh mesh;
    if (as_doubles(m.points, mesh.points)) {
      for (const auto& face : m.faces) add_face(face, mesh);
      return Nef3::mesh(mesh, rule_of(m.rule), context);
    }
    std::vector<HalfSpace3> below;
    for (const auto& face : m.faces) {
      below.push_back(
          {to_plane(plane_through(m.points[face[0]], m.points[face[1]], m.points[face[2]]))});
    }
    return Nef3::intersection(below, context);
  }

  // The same: convex ones, as their plane between planes through their edges.
  Nef3 operator()(const PolygonLeaf& p) const {
    std::vector<Point3> corners;
    if (as_doubles(p.corners, corners)) return Nef3::facet(corners);
    const ExactPoint3 &a = p.corners[0], &b = p.corners[1], &c = p.corners[2];
    const CellPlane plane = plane_through(a, b, c);
    const ExactPoint3 normal = cross(b - a, c - a);
    Nef3 result = Nef3::plane(to_plane(plane));
    for (std::size_t i = 0; i < p.corners.size(); ++i) {
      const ExactPoint3& from = p.corners[i];
      const ExactPoint3& to = p.corners[(i + 1) % p.corners.size()];
      const CellPlane side = plane_at(from, cross(to - from, normal));
      result *= Nef3::half_space(to_plane(side), Boundary::Closed);
    }
    return result;
  }

  Nef3 operator()(const ChainsLeaf& c) const {
    Context context;
    Nef3 result;
    for (const Chain3& chain : c.chains) {
      std::vector<RationalPoint3> points;
      for (const ExactPoint3& p : chain) points.push_back(to_rational(p));
      result += Nef3::polyline(points, context);
    }
    return result;
  }
  Nef3 operator()(const PointsLeaf& p) const {
    std::vector<RationalPoint3> points;
    for (const ExactPoint3& point : p.points) points.push_back(to_rational(point));
    Context context;
    return Nef3::points(points, context);
  }
  Nef3 operator()(const SpaceOperation& o) const {
    return apply(o.op, to_nef(*o.first), o.second ? to_nef(*o.second) : Nef3());
  }
};

}  // namespace

Plane3 to_plane(const CellPlane& plane) {
  const auto number = [](const BigInt& v) { return to_rational(BigRational(v)); };
  return {number(plane.n.x), number(plane.n.y), number(plane.n.z), number(plane.d)};
}

RationalPoint3 to_rational(const ExactPoint3& p) {
  return {to_rational(p.x), to_rational(p.y), to_rational(p.z)};
}

Nef3 apply(SetOperator op, const Nef3& first, const Nef3& second) {
  switch (op) {
    case SetOperator::Union:
      return first + second;
    case SetOperator::Intersection:
      return first * second;
    case SetOperator::Difference:
      return first - second;
    case SetOperator::SymmetricDifference:
      return first ^ second;
    case SetOperator::Complement:
      return !first;
    case SetOperator::Interior:
      return first.interior();
    case SetOperator::Closure:
      return first.closure();
    case SetOperator::Boundary:
      return first.boundary();
    case SetOperator::Exterior:
      return first.exterior();
    default:
      return first.regularization();
  }
}

Nef3 to_nef(const SpaceSet& set) { return std::visit(ToNef(), set.node); }

}  // namespace plumb::testing
