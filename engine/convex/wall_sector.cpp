#include "plumb/convex/wall_sector.h"

#include "plumb/predicates/plane_signs.h"

namespace plumb {

void sectors_of(const SpaceComplex& complex, EdgeId e, std::vector<Sector>& sectors) {
  sectors.clear();
  const UseId any = complex.edge_use[e.value()];
  if (!any.is_valid()) {
    const VolumeId around = complex.edge_volume[e.value()];
    if (complex.volume_mark[around.value()] == 1) sectors.push_back({e, around, {}, {}});
    return;
  }
  UseId u = any;
  do {
    const UseId next = complex.use_radial[u.value()];
    const VolumeId between = complex.volume_after(u);
    if (complex.volume_mark[between.value()] == 1) sectors.push_back({e, between, u, next});
    u = next;
  } while (u != any);
}

Sign SectorTest::sine(EdgeId e, HalfPlane from, HalfPlane to) const {
  if (from.plane == to.plane) return Sign::Zero;
  const auto& [p, q] = c_.edge_planes[e.value()];
  return turn_about_line(c_.planes(), p, q, from.plane, to.plane) * from.sense * to.sense;
}

int SectorTest::turn(EdgeId e, HalfPlane from, HalfPlane to) const {
  const Sign s = sine(e, from, to);
  if (s == Sign::Zero) return from.sense == to.sense ? 0 : 2;
  return s == Sign::Positive ? 1 : 3;
}

bool SectorTest::is_reflex(const Sector& s) const {
  if (!s.first.is_valid() || s.first == s.second) return true;
  return turn(s.edge, of_use(s.first), of_use(s.second)) == 3;
}

bool SectorTest::holds(const Sector& s, HalfPlane h) const {
  if (!s.first.is_valid()) return true;
  const int at = turn(s.edge, of_use(s.first), h);
  if (at == 0) return false;
  if (s.first == s.second) return true;
  const int end = turn(s.edge, of_use(s.first), of_use(s.second));
  if (at != end) return at < end;
  return at != 2 && sine(s.edge, h, of_use(s.second)) == Sign::Positive;
}

bool SectorTest::is_resolved_by(const Sector& s, HalfPlane h) const {
  if (!s.first.is_valid() || !holds(s, h)) return false;
  return turn(s.edge, of_use(s.first), h) <= 2 && turn(s.edge, h, of_use(s.second)) <= 2;
}

}  // namespace plumb
