// Volumes, centroids and areas by sums over the facets.
//
// By the divergence theorem the volume is a sixth of the sum of det(p, a, b) over triangles of the
// boundary, oriented outwards, and the moments follow from the centroid of the tetrahedron with the
// origin. A facet is a signed sum of triangles between one of its corners and its edges, so holes
// and reflex corners need no triangulation. Sums are exact: RationalSum adds terms pairwise, which
// keeps numbers short. Areas involve square roots and are rounded once for each facet, with a
// relative error below 2^-51.
//
// Tested by tests/space/space_measure_test.cpp.

#include "plumb/space/space_measure.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/query_point3.h"

namespace plumb {
namespace {

/// The bytes of a sum for each vertex: it is about as long as the coordinates of all vertices.
constexpr std::uint64_t kBytesPerVertex = 10;

/// Whether a volume belongs to the set.
bool is_marked(const SpaceComplex& c, VolumeId v) { return c.volume_mark[v] == 1; }

/// Returns 1 if the marked volume is on the negative side of a facet, so that the normal points out
/// of it. Returns -1 if it is on the positive side, and 0 if both sides are marked or no side is.
int outward(const SpaceComplex& c, std::size_t f) {
  const auto& [positive, negative] = c.facet_volume[f];
  return static_cast<int>(is_marked(c, negative)) - static_cast<int>(is_marked(c, positive));
}

/// Whether a facet reaches to infinity.
bool is_at_frame(const SpaceComplex& c, FacetId f) {
  for (const UseId first : c.cycles_of(f)) {
    UseId u = first;
    do {
      const VertexId v = c.use_origin(u);
      if (c.points().depends_on_frame(c.vertex_point[v])) return true;
      u = c.use_next[u];
    } while (u != first);
  }
  return false;
}

/// Whether the marked volumes are infinite. Volume 0 is infinite. If there is a frame, volume 0 is
/// beyond the frame, and the volumes at the frame are infinite.
bool is_volume_infinite(const SpaceComplex& c) {
  if (is_marked(c, VolumeId(0))) return true;
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    if (c.facet_mark[f] == kBeyond && outward(c, f) != 0) return true;
  }
  return false;
}

/// Counts steps, and calls a checkpoint from time to time.
class Steps {
 public:
  Steps(const SpaceComplex& complex, Context& context)
      : context_(context), edges_(complex.use_count()) {}
  void operator()() {
    if (++done_ % 64 == 0) context_.checkpoint("measures", done_, edges_ + 1);
  }

 private:
  Context& context_;
  std::uint64_t edges_;
  std::uint64_t done_ = 0;
};

/// Calls visit(p, a, b) for the triangle of each edge a b of the facet and one of its corners p.
/// Together, with signs, they are the facet, counter-clockwise.
template <class Visit>
void for_each_triangle(const SpaceComplex& c, FacetId f, Steps& step, Visit visit) {
  const auto at = [&](UseId u) { return exact(c.points(), c.vertex_point[c.use_origin(u)]); };
  const RationalPoint3 p = at(c.cycles_of(f)[0]);
  for (const UseId first : c.cycles_of(f)) {
    const RationalPoint3 start = at(first);
    RationalPoint3 a = start;
    UseId u = first;
    do {
      step();
      const UseId next = c.use_next[u];
      RationalPoint3 b = next == first ? start : at(next);
      if (a != p && b != p) visit(p, a, b);
      a = std::move(b);
      u = next;
    } while (u != first);
  }
}

/// Integrals over the marked volumes.
struct Integrals {
  Rational volume;        ///< The integral of 1.
  RationalPoint3 moment;  ///< The integrals of x, y and z.
};

/// Returns the integrals, or nothing if the volume is infinite. A tetrahedron with the origin has
/// its centroid at a quarter of the sum of the other corners.
std::optional<Integrals> integrals(const SpaceComplex& c, bool with_moments, Context& context) {
  if (is_volume_infinite(c)) return std::nullopt;
  Steps step(c, context);
  MemoryCharge memory(context);
  memory.add((with_moments ? 4 : 1) * kBytesPerVertex * c.vertex_count(), "numbers of a measure");
  RationalSum volume;
  std::array<RationalSum, 3> moments;
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    const int sign = outward(c, f);
    if (sign == 0) continue;
    const auto add = [&](const RationalPoint3& p, const RationalPoint3& a,
                         const RationalPoint3& b) {
      const Rational six = sign * dot(p, cross(a, b));
      for (std::size_t i = 0; i < 3 && with_moments; ++i) {
        moments[i].add(six * (coordinate(p, i) + coordinate(a, i) + coordinate(b, i)));
      }
      volume.add(six);
    };
    for_each_triangle(c, FacetId(f), step, add);
  }
  return Integrals{volume.total() / 6,
                   {moments[0].total() / 24, moments[1].total() / 24, moments[2].total() / 24}};
}

/// Returns half the length of v with a relative error below 2^-51: two roundings of exact numbers
/// (the one below the root counts half), a root and a product, 2^-53 each.
double half_length(const RationalPoint3& v) {
  Rational largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (abs(coordinate(v, i)) > largest) largest = abs(coordinate(v, i));
  }
  if (largest == 0) return 0;
  const Rational square = dot(v, v) / (largest * largest);  // The value is in [1, 3].
  return nearest_double(largest / 2) * std::sqrt(nearest_double(square));
}

}  // namespace

std::optional<Rational> marked_volume(const SpaceComplex& complex, Context& context) {
  const std::optional<Integrals> all = integrals(complex, false, context);
  if (!all) return std::nullopt;
  return all->volume;
}

std::optional<RationalPoint3> marked_centroid(const SpaceComplex& complex, Context& context) {
  const std::optional<Integrals> all = integrals(complex, true, context);
  if (!all || all->volume == 0) return std::nullopt;
  const auto& [volume, moment] = *all;
  return RationalPoint3{moment.x / volume, moment.y / volume, moment.z / volume};
}

// The areas are not negative. Therefore their exact sum has the relative error of each area. The
// sum is rounded once.
std::optional<double> surface_area(const SpaceComplex& complex, Context& context) {
  Steps step(complex, context);
  RationalSum sum;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    if (complex.facet_mark[f] == kBeyond || outward(complex, f) == 0) continue;
    if (is_at_frame(complex, FacetId(f))) return std::nullopt;
    RationalPoint3 twice{0, 0, 0};
    for_each_triangle(complex, FacetId(f), step, [&](const auto& p, const auto& a, const auto& b) {
      const RationalPoint3 area = cross(a - p, b - p);
      twice = {twice.x + area.x, twice.y + area.y, twice.z + area.z};
    });
    const double area = half_length(twice);
    if (!std::isfinite(area)) return area;
    sum.add(exact_rational(area));
  }
  return nearest_double(sum.total());
}

}  // namespace plumb
