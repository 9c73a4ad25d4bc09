// Expressions of the tests into the engine.
#include "generate/curve_scenes.h"
#include "oracle/apply_to_sets.h"
#include "oracle/plane_set.h"

namespace plumb::testing {
namespace {

// Chains in the form the engine takes them.
struct ChainTable {
  PointTable2 points;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> chain_begin = {0};

  explicit ChainTable(const std::vector<Chain>& chains) {
    for (const Chain& chain : chains) {
      for (const ExactPoint& p : chain) {
        corners.push_back(static_cast<std::uint32_t>(points.size()));
        add_point(points, p);
      }
      chain_begin.push_back(static_cast<std::uint32_t>(corners.size()));
    }
  }
};

Line2 line_of(const ExactPoint& a, const ExactPoint& b) { return {to_rational(a), to_rational(b)}; }

struct ToNef {
  Nef2 operator()(const SetHalfPlane& h) const {
    return Nef2::half_plane(line_of(h.a, h.b), h.boundary);
  }
  Nef2 operator()(const SetLine& l) const { return Nef2::line(line_of(l.a, l.b)); }
  Nef2 operator()(const SetRay& r) const { return Nef2::ray(line_of(r.a, r.b), r.boundary); }
  Nef2 operator()(const SetPolygons& p) const {
    const ChainTable table(p.chains);
    Context context;
    return Nef2::polygons(table.points, table.corners, table.chain_begin, p.rule, p.boundary,
                          context);
  }
  Nef2 operator()(const SetPolylines& p) const {
    const ChainTable table(p.chains);
    Context context;
    return Nef2::polylines(table.points, table.corners, table.chain_begin, context);
  }
  Nef2 operator()(const SetPoints& p) const {
    PointTable2 points;
    for (const ExactPoint& point : p.points) add_point(points, point);
    Context context;
    return Nef2::points(points, context);
  }
  Nef2 operator()(const SetOperation& o) const {
    return apply(o.op, to_nef(*o.first), o.second ? to_nef(*o.second) : Nef2());
  }
};

}  // namespace

RationalPoint2 to_rational(const ExactPoint& p) { return {to_rational(p.x), to_rational(p.y)}; }

Nef2 apply(SetOperator op, const Nef2& first, const Nef2& second) {
  return apply_to_sets(op, first, second);
}

Nef2 to_nef(const PlaneSet& set) { return std::visit(ToNef(), set.node); }

}  // namespace plumb::testing
