#include "plumb/space/mesh/mesh_fans.h"

#include <array>
#include <cstddef>

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {
namespace {

/// Axes as bits 0, 1, 2. Along axis i the other two, i + 1 and i + 2, are seen as right and up.
using Axes = std::uint8_t;
constexpr Axes kAllAxes = 7;

/// The axes along which a triangle is seen from the positive and from the negative side of its
/// plane.
struct Sides {
  Axes positive = 0;
  Axes negative = 0;
};

class FanSearch {
 public:
  explicit FanSearch(const SpaceComplex& complex)
      : complex_(complex),
        can_be_(complex.vertex_count(), kAllAxes),
        turns_(complex.vertex_count()) {}

  std::vector<std::uint8_t> run() {
    find_sides();
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) look_at_edge(EdgeId(e));
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) count_turns(FacetId(f));
    for (const VertexId v : complex_.inner) can_be_[v.value()] = 0;
    for (std::size_t v = 0; v < can_be_.size(); ++v) {
      can_be_[v] = (can_be_[v] & turns_[v].once & ~turns_[v].twice) != 0 ? 1 : 0;
    }
    return std::move(can_be_);
  }

 private:
  /// How often the corners around a vertex pass the direction 0, along each axis.
  struct Turns {
    Axes once = 0;
    Axes twice = 0;
  };

  // A component of the row's normal is off by less than its error.
  void find_sides() {
    sides_.reserve(complex_.facet_count());
    for (const PlaneId plane : complex_.facet_plane) {
      const PlaneRow& row = complex_.planes().row(plane);
      Sides sides;
      for (std::size_t i = 0; i < 3; ++i) {
        const double error = static_cast<double>(row.normal_error);
        sides.positive |= static_cast<Axes>((row.n[i] > error ? 1U : 0U) << i);
        sides.negative |= static_cast<Axes>((row.n[i] < -error ? 1U : 0U) << i);
      }
      sides_.push_back(sides);
    }
  }

  /// Uses run with the facet to their left, seen from the positive side.
  void look_at_edge(EdgeId e) {
    const UseId u = complex_.edge_use[e.value()];
    const UseId v = u.is_valid() ? complex_.use_radial[u.value()] : u;
    Axes good = 0;
    if (v != u && complex_.use_radial[v.value()] == u) {
      const Sides &s = sides_of(u), &t = sides_of(v);
      const bool is_opposite = complex_.use_halfedge[u.value()] != complex_.use_halfedge[v.value()];
      good = is_opposite ? (s.positive & t.positive) | (s.negative & t.negative)
                         : (s.positive & t.negative) | (s.negative & t.positive);
    }
    can_be_[complex_.origin[2 * e.value()].value()] &= good;
    can_be_[complex_.origin[2 * e.value() + 1].value()] &= good;
  }
  const Sides& sides_of(UseId u) const { return sides_[complex_.use_facet[u.value()].value()]; }

  void count_turns(FacetId f) {
    const UseId first = complex_.cycles_of(f)[0];
    std::array<UseId, 3> uses{first};
    for (std::size_t i = 1; i < 3; ++i) uses[i] = complex_.use_next[uses[i - 1].value()];
    const bool is_triangle =
        complex_.cycles_of(f).size() == 1 && complex_.use_next[uses[2].value()] == first;
    if (!is_triangle) return count_turns_of_any(f);
    std::array<std::uint32_t, 3> corner;
    std::array<const Point3*, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = complex_.use_origin(uses[i]);
      const SpacePoint p = complex_.vertex_point[v.value()];
      if (!p.is_input()) return count_turns_of_any(f);
      corner[i] = v.value();
      at[i] = &complex_.planes().point(p.input());
    }
    std::array<Axes, 3> rises;  // from corner i to the next
    for (std::size_t i = 0; i < 3; ++i) rises[i] = rises_along(*at[i], *at[i == 2 ? 0 : i + 1]);
    const Axes is_reversed = sides_[f.value()].negative;
    for (std::size_t i = 0; i < 3; ++i) {
      // Counter-clockwise, seen from the positive side: from the next corner to the one before.
      const Axes begins_up = rises[i], ends_up = ~rises[i == 0 ? 2 : i - 1];
      const Axes passes =
          (is_reversed & begins_up & ~ends_up) | (~is_reversed & ~begins_up & ends_up);
      count(corner[i], passes);
    }
  }
  void count(std::uint32_t v, unsigned passes) {
    Turns& turns = turns_[v];
    turns.twice |= static_cast<Axes>(turns.once & passes);
    turns.once |= static_cast<Axes>(passes);
  }

  /// Axes along which q is in the upper half-plane around p: above it, or level with it and to the
  /// right.
  static Axes rises_along(const Point3& p, const Point3& q) {
    const std::array<unsigned, 3> above{q.x > p.x, q.y > p.y, q.z > p.z};
    const std::array<unsigned, 3> level{q.x == p.x, q.y == p.y, q.z == p.z};
    unsigned axes = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t right = (i + 1) % 3, up = (i + 2) % 3;
      axes |= (above[up] | (level[up] & above[right])) << i;
    }
    return static_cast<Axes>(axes);
  }

  // ---- corners of polygons, and constructed ones

  void count_turns_of_any(FacetId f) {
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        count_turn(f, u);
        u = complex_.use_next[u.value()];
      } while (u != first);
    }
  }
  void count_turn(FacetId f, UseId u) {
    const VertexId v = complex_.use_origin(u);
    const HalfedgeId next = complex_.use_halfedge[u.value()];
    const HalfedgeId before =
        SpaceComplex::twin(complex_.use_halfedge[complex_.use_prev[u.value()].value()]);
    const Rises ahead = rises_along(v, complex_.target(next)),
                behind = rises_along(v, complex_.target(before));
    can_be_[v.value()] &= ahead.known & behind.known;
    if (can_be_[v.value()] == 0) return;
    const Axes is_reversed = sides_[f.value()].negative;
    const Axes begins_up = (is_reversed & behind.up) | (~is_reversed & ahead.up),
               ends_up = (is_reversed & ahead.up) | (~is_reversed & behind.up);
    const Axes is_level = ~(begins_up ^ ends_up) & can_be_[v.value()];
    const bool is_reflex =
        is_level != 0 &&
        side_in_plane(complex_, complex_.facet_plane[f.value()], next, complex_.points(),
                      complex_.vertex_point[complex_.target(before).value()]) != Sign::Positive;
    count(v.value(), (~begins_up & ends_up) | (is_reflex ? is_level : 0));
  }

  struct Rises {
    Axes up = 0;  // as above
    Axes known = 0;
  };
  Rises rises_along(VertexId v, VertexId w) const {
    const SpacePoint p = complex_.vertex_point[v.value()], q = complex_.vertex_point[w.value()];
    const PlaneTable& planes = complex_.planes();
    if (p.is_input() && q.is_input()) {
      return {rises_along(planes.point(p.input()), planes.point(q.input())), kAllAxes};
    }
    Rises rises;
    for (std::size_t i = 0; i < 3; ++i) {
      const FilteredSign above = rung::compare_axis_filter(complex_.points().box(q),
                                                           complex_.points().box(p), (i + 2) % 3);
      rises.up |= static_cast<Axes>((above == FilteredSign::Positive ? 1U : 0U) << i);
      rises.known |= static_cast<Axes>((is_decided(above) ? 1U : 0U) << i);
    }
    return rises;
  }

  const SpaceComplex& complex_;
  std::vector<Axes> can_be_;  // per vertex: axes along which it may have a fan
  std::vector<Turns> turns_;  // per vertex
  std::vector<Sides> sides_;  // per facet
};

}  // namespace

std::vector<std::uint8_t> find_fans(const SpaceComplex& complex) {
  return FanSearch(complex).run();
}

}  // namespace plumb
