#include "plumb/convex/sum/volume_sum.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/query_point3.h"
#include "plumb/space/space_measure.h"

namespace plumb {
namespace {

/// A side of a facet that occurs `times` times. It leads from the point with the lesser number to
/// the other point.
struct Side {
  const SpaceTables* tables;
  PlaneId plane;
  SpacePoint from, to;
  int times;
};
auto key(const Side& s) { return std::tuple(s.tables, s.plane, s.from, s.to); }

class VolumeSum {
 public:
  explicit VolumeSum(Context& context) : context_(context) {}

  /// Adds the sides of a complex; `sign` is -1 to subtract them.
  void add(const SpaceComplex& c, int sign) {
    context_.checkpoint("volumes", 0, 1);
    const auto is_marked = [&c](VolumeId v) { return c.volume_mark[v] == 1 ? 1 : 0; };
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
      const auto& [above, below] = c.facet_volume[f];
      const int outward = is_marked(below) - is_marked(above);
      if (outward == 0) continue;
      for (const UseId first : c.cycles_of(FacetId(f))) {
        UseId u = first;
        do {
          const UseId next = c.use_next[u];
          add_side(c, c.facet_plane[f], c.use_origin(u), c.use_origin(next), sign * outward);
          u = next;
        } while (u != first);
      }
    }
  }

  bool is_zero() {
    cancel();
    RationalSum sum;
    for (std::size_t i = 0; i < sides_.size();) {
      context_.checkpoint("volumes", i, sides_.size());
      const std::size_t first = i;
      const auto is_same = [&](const Side& s) {
        return s.tables == sides_[first].tables && s.plane == sides_[first].plane;
      };
      while (i < sides_.size() && is_same(sides_[i])) ++i;
      sum.add(volume_under(std::span(sides_).subspan(first, i - first)));
    }
    return sum.total() == 0;
  }

 private:
  void add_side(const SpaceComplex& c, PlaneId plane, VertexId a, VertexId b, int times) {
    const SpacePoint p = c.vertex_point[a], q = c.vertex_point[b];
    if (p < q) {
      sides_.push_back({c.tables.get(), plane, p, q, times});
    } else {
      sides_.push_back({c.tables.get(), plane, q, p, -times});
    }
  }

  void cancel() {
    std::sort(sides_.begin(), sides_.end(),
              [](const Side& s, const Side& t) { return key(s) < key(t); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sides_.size();) {
      Side all = sides_[i];
      for (++i; i < sides_.size() && key(sides_[i]) == key(all); ++i) all.times += sides_[i].times;
      if (all.times != 0) sides_[kept++] = all;
    }
    sides_.resize(kept);
  }

  /// Returns minus six times the volume of the cones from the origin over the regions that the
  /// sides bound in one plane. It is d / n_k times twice an area (volume_sum.h).
  static Rational volume_under(std::span<const Side> sides) {
    const SpaceTables& tables = *sides[0].tables;
    const IntegerRow row = tables.planes.coefficients(sides[0].plane);
    if (row[3] == 0) return 0;
    const std::size_t k = row[2] != 0 ? 2 : row[1] != 0 ? 1 : 0;
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    RationalSum twice;
    for (const Side& side : sides) {
      const RationalPoint3 a = exact(tables.points, side.from), b = exact(tables.points, side.to);
      const Rational area =
          coordinate(a, i) * coordinate(b, j) - coordinate(a, j) * coordinate(b, i);
      twice.add(side.times * area);
    }
    return twice.total() * Rational(row[3], row[k]);
  }

  Context& context_;
  std::vector<Side> sides_;
};

}  // namespace

std::optional<bool> do_volumes_add_up(const Nef3& set, std::span<const Nef3> pieces,
                                      Context& context) {
  if (!set.is_bounded() && !marked_volume(set.complex())) return std::nullopt;
  VolumeSum sum(context);
  sum.add(set.complex(), -1);
  for (const Nef3& piece : pieces) sum.add(piece.complex(), 1);
  return sum.is_zero();
}

}  // namespace plumb
