#include "plumb/space/same_complex.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/local_maps.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {
namespace {

/// Vertices in the order of the fingerprints of their points.
std::vector<std::pair<Fingerprint, VertexId>> by_fingerprint(
    const Point3Table& points, const std::vector<SpacePoint>& vertex_point) {
  std::vector<std::pair<Fingerprint, VertexId>> order;
  order.reserve(vertex_point.size());
  for (std::size_t v = 0; v < vertex_point.size(); ++v) {
    order.emplace_back(fingerprint(points, vertex_point[v]), VertexId(v));
  }
  std::sort(order.begin(), order.end());
  return order;
}

/// The planes of a map of another table.
void translate(const TableMap& to, SphereMap& map) {
  for (PlaneId& p : map.circle) p = to(p);
  for (SphereDirection& d : map.direction) d = {to(d.p), to(d.q)};
}

class Comparison {
 public:
  Comparison(const SpaceComplex& a, const SpaceComplex& b)
      : a_(a),
        b_(b),
        tables_(copy(*a.tables)),
        to_(merge(*tables_, *b.tables)),
        overlay_(tables_->planes) {}

  bool operator()() {
    std::vector<SpacePoint> points_of_b;
    for (const SpacePoint p : b_.vertex_point) points_of_b.push_back(to_(p));
    const auto first = by_fingerprint(tables_->points, a_.vertex_point);
    const auto second = by_fingerprint(tables_->points, points_of_b);
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (!(first[i].first == second[i].first)) return false;
    }
    for (std::size_t i = 0; i < first.size();) {
      std::size_t end = i + 1;
      while (end < first.size() && first[end].first == first[i].first) ++end;
      for (std::size_t k = i; k < end; ++k) {
        const VertexId v = first[k].second;
        const bool has_match =
            std::any_of(second.begin() + static_cast<std::ptrdiff_t>(i),
                        second.begin() + static_cast<std::ptrdiff_t>(end), [&](const auto& entry) {
                          return equal(tables_->points, a_.vertex_point[v.value()],
                                       points_of_b[entry.second.value()]) &&
                                 have_same_map(v, entry.second);
                        });
        if (!has_match) return false;
      }
      i = end;
    }
    return true;
  }

 private:
  bool have_same_map(VertexId v, VertexId w) {
    local_map(a_, v, local_[0]);
    local_map(b_, w, local_[1]);
    const SphereMap &m = local_[0].map, &n = local_[1].map;
    if (m.centre_mark != n.centre_mark || m.point_count() != n.point_count() ||
        m.arc_count() != n.arc_count() || m.face_count() != n.face_count()) {
      return false;
    }
    translate(to_, local_[1].map);
    overlay_.combine(m, n, MarkTable::unequal(), difference_, origins_);
    return difference_.point_count() == 0 && difference_.arc_count() == 0 &&
           difference_.face_mark[0] == 0;
  }

  const SpaceComplex& a_;
  const SpaceComplex& b_;
  std::shared_ptr<SpaceTables> tables_;
  TableMap to_;
  SphereOverlay overlay_;
  std::array<LocalMap, 2> local_;
  SphereMap difference_;
  SphereOrigins origins_;
};

}  // namespace

bool is_same(const SpaceComplex& a, const SpaceComplex& b) {
  if (a.vertex_count() != b.vertex_count() || a.edge_count() != b.edge_count() ||
      a.facet_count() != b.facet_count() || a.volume_count() != b.volume_count() ||
      a.volume_mark[0] != b.volume_mark[0]) {
    return false;
  }
  return a.vertex_count() == 0 || Comparison(a, b)();
}

}  // namespace plumb
