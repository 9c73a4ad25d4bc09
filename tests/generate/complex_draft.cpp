#include "generate/complex_draft.h"

#include <algorithm>
#include <map>
#include <utility>

#include "plumb/predicates/plane_signs.h"

namespace plumb::testing {

namespace {

int sign(const BigRational& x) { return x.sign(); }

BigRational coordinate_of(const ExactPoint3& p, std::size_t i) {
  return i == 0 ? p.x : i == 1 ? p.y : p.z;
}

class DraftBuilder {
 public:
  DraftBuilder(const ComplexDraft& draft, std::shared_ptr<SpaceTables> tables, Dice& dice)
      : draft_(draft), tables_(std::move(tables)), dice_(dice), planes_at_(draft.points.size()) {
    result_.tables = tables_;
  }

  SpaceComplex run() {
    result_.cycle_begin = result_.inner_begin = {0};
    for (const ComplexDraft::Facet& f : draft_.facets) add_facet(f);
    for (const auto& ends : draft_.free_edges) halfedge(ends[0], ends[1]);
    for (std::size_t e = 0; e < ends_.size(); ++e) add_edge(e);
    link_radially();
    add_vertices();
    return std::move(result_);
  }

 private:
  PlaneId plane_through(const ExactPoint3& p, const ExactPoint3& normal) {
    return tables_->planes
        .intern(to_rational(normal.x), to_rational(normal.y), to_rational(normal.z),
                to_rational(-dot(normal, p)))
        .plane();
  }

  /// Counter-clockwise seen from the positive side of the canonical plane, holes clockwise.
  void add_facet(const ComplexDraft::Facet& facet) {
    const ComplexDraft::Cycle& outer = facet.cycles[0];
    ExactPoint3 normal =
        cross(point(outer[1]) - point(outer[0]), point(outer[2]) - point(outer[0]));
    if (sign(normal.x) < 0 || (sign(normal.x) == 0 && sign(normal.y) < 0) ||
        (sign(normal.x) == 0 && sign(normal.y) == 0 && sign(normal.z) < 0)) {
      normal = BigRational(-1) * normal;
    }
    const FacetId f(result_.facet_count());
    result_.facet_plane.push_back(plane_through(point(outer[0]), normal));
    result_.facet_mark.push_back(0);
    result_.facet_volume.emplace_back();
    result_.facet_origin.push_back(f.value());
    for (std::size_t c = 0; c < facet.cycles.size(); ++c) {
      ComplexDraft::Cycle cycle = facet.cycles[c];
      const bool runs_ccw = sign(dot(area(cycle), normal)) > 0;
      if (runs_ccw != (c == 0)) std::reverse(cycle.begin(), cycle.end());
      add_cycle(f, cycle);
    }
    result_.cycle_begin.push_back(static_cast<std::uint32_t>(result_.cycle.size()));
    for (const std::uint32_t v : facet.inner) {
      result_.inner.emplace_back(v);
      facet_of_inner_.emplace_back(v, f);
    }
    result_.inner_begin.push_back(static_cast<std::uint32_t>(result_.inner.size()));
  }

  ExactPoint3 area(const ComplexDraft::Cycle& cycle) const {
    ExactPoint3 sum{0, 0, 0};
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      sum = sum + cross(point(cycle[i]), point(cycle[(i + 1) % cycle.size()]));
    }
    return sum;
  }

  void add_cycle(FacetId f, const ComplexDraft::Cycle& cycle) {
    const std::size_t begin = result_.use_count(), n = cycle.size();
    result_.cycle.emplace_back(begin);
    for (std::size_t i = 0; i < n; ++i) {
      const HalfedgeId h = halfedge(cycle[i], cycle[(i + 1) % n]);
      uses_of_[h.value() / 2].emplace_back(begin + i);
      result_.use_halfedge.push_back(h);
      result_.use_next.emplace_back(begin + (i + 1) % n);
      result_.use_prev.emplace_back(begin + (i + n - 1) % n);
      result_.use_facet.push_back(f);
      planes_at_[cycle[i]].push_back(result_.facet_plane[f.value()]);
    }
  }

  /// Half-edges are directed when the planes of edges are known: see add_edge.
  HalfedgeId halfedge(std::uint32_t from, std::uint32_t to) {
    const auto key = std::minmax(from, to);
    const auto found = edge_.emplace(key, ends_.size());
    if (found.second) {
      ends_.push_back({from, to});
      uses_of_.emplace_back();
    }
    const std::size_t e = found.first->second;
    return HalfedgeId(2 * e + (ends_[e][0] == from ? 0 : 1));
  }

  void add_edge(std::size_t e) {
    const auto [from, to] = ends_[e];
    const ExactPoint3 d = point(to) - point(from);
    std::array<PlaneId, 2> planes = planes_of_edge(e, point(from), d);
    if (runs_against(planes, d)) std::swap(planes[0], planes[1]);
    result_.edge_planes.push_back(planes);
    result_.edge_mark.push_back(0);
    result_.edge_use.push_back(uses_of_[e].empty() ? UseId() : uses_of_[e].front());
    result_.edge_volume.emplace_back();
    result_.origin.emplace_back(from);
    result_.origin.emplace_back(to);
    for (const PlaneId p : planes) {
      planes_at_[from].push_back(p);
      planes_at_[to].push_back(p);
    }
  }

  bool runs_against(const std::array<PlaneId, 2>& planes, const ExactPoint3& d) const {
    std::size_t axis = 0;
    while (sign(coordinate_of(d, axis)) == 0) ++axis;
    return static_cast<int>(minor_sign(tables_->planes, planes[0], planes[1], axis)) !=
           sign(coordinate_of(d, axis));
  }

  /// Of two facets; what is missing is parallel to an axis.
  std::array<PlaneId, 2> planes_of_edge(std::size_t e, const ExactPoint3& p, const ExactPoint3& d) {
    std::vector<PlaneId> found;
    const auto offer = [&](PlaneId plane) {
      if (plane.is_valid() && std::find(found.begin(), found.end(), plane) == found.end()) {
        found.push_back(plane);
      }
    };
    for (const UseId u : uses_of_[e]) {
      offer(result_.facet_plane[result_.use_facet[u.value()].value()]);
    }
    const ExactPoint3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t i = dice_.below(3), k = 0; k < 3; ++k, i = (i + 1) % 3) {
      const ExactPoint3 normal = cross(d, axes[i]);
      if (normal != ExactPoint3{0, 0, 0}) offer(plane_through(p, normal));
    }
    return {found[0], found[1]};
  }

  void link_radially() {
    result_.use_radial.resize(result_.use_count());
    for (const std::vector<UseId>& uses : uses_of_) {
      for (std::size_t i = 0; i < uses.size(); ++i) {
        result_.use_radial[uses[i].value()] = uses[(i + 1) % uses.size()];
      }
    }
  }

  void add_vertices() {
    std::vector<std::vector<HalfedgeId>> stars(draft_.points.size());
    for (std::size_t h = 0; h < result_.origin.size(); ++h) {
      stars[result_.origin[h].value()].emplace_back(h);
    }
    result_.star_begin = {0};
    for (std::uint32_t v = 0; v < draft_.points.size(); ++v) {
      result_.vertex_point.push_back(make_point(v));
      result_.vertex_mark.push_back(0);
      result_.vertex_volume.emplace_back();
      result_.vertex_facet.emplace_back();
      result_.star.insert(result_.star.end(), stars[v].begin(), stars[v].end());
      result_.star_begin.push_back(static_cast<std::uint32_t>(result_.star.size()));
    }
    for (const auto& [v, f] : facet_of_inner_) result_.vertex_facet[v] = f;
  }

  SpacePoint make_point(std::uint32_t v) {
    const ExactPoint3& p = draft_.points[v];
    Point3 as_input;
    const bool is_double =
        as_double(p.x, as_input.x) && as_double(p.y, as_input.y) && as_double(p.z, as_input.z);
    if (is_double && dice_.below(3) > 0) return SpacePoint(tables_->planes.add_point(as_input));
    std::vector<PlaneId>& planes = planes_at_[v];
    for (const ExactPoint3& normal :
         {ExactPoint3{1, 0, 0}, ExactPoint3{0, 1, 0}, ExactPoint3{0, 0, 1}}) {
      planes.push_back(plane_through(p, normal));
    }
    return point_of(planes);
  }

  /// The first three that cut each other in one point.
  SpacePoint point_of(const std::vector<PlaneId>& planes) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          const SpacePoint p = tables_->points.add(planes[k], planes[j], planes[i]);
          if (p.is_valid()) return p;
        }
      }
    }
    return {};
  }

  const ExactPoint3& point(std::uint32_t v) const { return draft_.points[v]; }

  const ComplexDraft& draft_;
  std::shared_ptr<SpaceTables> tables_;
  Dice& dice_;
  SpaceComplex result_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> edge_;
  std::vector<std::array<std::uint32_t, 2>> ends_;  // of edges
  std::vector<std::vector<UseId>> uses_of_;
  std::vector<std::vector<PlaneId>> planes_at_;
  std::vector<std::pair<std::uint32_t, FacetId>> facet_of_inner_;
};

}  // namespace

void ComplexDraft::add(const ComplexDraft& other) {
  const auto shift = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), other.points.begin(), other.points.end());
  for (Facet f : other.facets) {
    for (Cycle& c : f.cycles) {
      for (std::uint32_t& v : c) v += shift;
    }
    for (std::uint32_t& v : f.inner) v += shift;
    facets.push_back(std::move(f));
  }
  for (const auto& e : other.free_edges) free_edges.push_back({e[0] + shift, e[1] + shift});
}

SpaceComplex build_complex(const ComplexDraft& draft, std::shared_ptr<SpaceTables> tables,
                           Dice& dice) {
  return DraftBuilder(draft, std::move(tables), dice).run();
}

ComplexDraft tetrahedron_draft(const std::array<ExactPoint3, 4>& corners) {
  ComplexDraft draft;
  draft.points.assign(corners.begin(), corners.end());
  for (std::uint32_t skipped = 0; skipped < 4; ++skipped) {
    ComplexDraft::Cycle cycle;
    for (std::uint32_t v = 0; v < 4; ++v) {
      if (v != skipped) cycle.push_back(v);
    }
    draft.facets.push_back({{cycle}, {}});
  }
  return draft;
}

ComplexDraft box_draft(const ExactPoint3& low, const ExactPoint3& high) {
  ComplexDraft draft;
  for (std::uint32_t v = 0; v < 8; ++v) {
    draft.add({(v & 1) != 0 ? high.x : low.x, (v & 2) != 0 ? high.y : low.y,
               (v & 4) != 0 ? high.z : low.z});
  }
  for (const ComplexDraft::Cycle& cycle : {ComplexDraft::Cycle{0, 2, 6, 4},
                                           {1, 3, 7, 5},
                                           {0, 1, 5, 4},
                                           {2, 3, 7, 6},
                                           {0, 1, 3, 2},
                                           {4, 5, 7, 6}}) {
    draft.facets.push_back({{cycle}, {}});
  }
  return draft;
}

ComplexDraft prism_draft(const std::vector<std::array<int, 2>>& polygon, int low, int high) {
  ComplexDraft draft;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  ComplexDraft::Facet bottom{{{}}, {}}, top{{{}}, {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    bottom.cycles[0].push_back(draft.add({polygon[i][0], polygon[i][1], low}));
    top.cycles[0].push_back(draft.add({polygon[i][0], polygon[i][1], high}));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    draft.facets.push_back({{{2 * i, 2 * j, 2 * j + 1, 2 * i + 1}}, {}});
  }
  draft.facets.push_back(std::move(bottom));
  draft.facets.push_back(std::move(top));
  return draft;
}

}  // namespace plumb::testing
