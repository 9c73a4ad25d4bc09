// Expressions of the tests into the engine.
#include "oracle/apply_to_sets.h"
#include "oracle/nef3_check.h"

namespace plumb::testing {
namespace {

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

  Nef3 operator()(const MeshLeaf& m) const {
    Context context;
    PolygonMesh mesh;
    mesh.points.resize(m.points.size());
    for (std::uint32_t i = 0; i < m.points.size(); ++i) {
      if (!as_double(m.points[i], mesh.points[i])) {
        mesh.exact.emplace_back(i, to_rational(m.points[i]));
      }
    }
    for (const auto& face : m.faces) add_face(face, mesh);
    return Nef3::from_mesh(mesh, {.rule = rule_of(m.rule)}, context);
  }
  Nef3 operator()(const PolygonLeaf& p) const {
    std::vector<RationalPoint3> corners;
    for (const ExactPoint3& c : p.corners) corners.push_back(to_rational(c));
    return Nef3::facet(std::span<const RationalPoint3>(corners));
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
  return apply_to_sets(op, first, second);
}

Nef3 to_nef(const SpaceSet& set) { return std::visit(ToNef(), set.node); }

}  // namespace plumb::testing
