// Voronoi cells from the Delaunay triangulation.
//
// Cells are convex polygons of exact points in counter-clockwise order, without equal neighbours.
// Four or more sites on a circle give triangles with equal centres, which become one corner.
// If all sites lie on a line, there are no triangles; then the neighbours of a site are the sites
// before and after it on the line.
// Tested by tests/convex/voronoi_test.cpp.
#include "plumb/convex/voronoi.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/convex/triangulation.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

using Polygon = std::vector<RationalPoint2>;

constexpr std::size_t kSitesPerCheckpoint = 64;

/// The half-plane of the points with a x + b y <= c.
struct HalfPlane {
  Rational a, b, c;
  Rational excess(const RationalPoint2& p) const { return a * p.x + b * p.y - c; }
};

/// Returns the points that are at least as near to p as to q.
HalfPlane nearer(const RationalPoint2& p, const RationalPoint2& q) {
  const Rational a = q.x - p.x;
  const Rational b = q.y - p.y;
  return {2 * a, 2 * b, a * (p.x + q.x) + b * (p.y + q.y)};
}

/// Appends a corner, unless it equals the one before it.
void add_corner(Polygon& polygon, RationalPoint2 p) {
  if (polygon.empty() || !(polygon.back() == p)) polygon.push_back(std::move(p));
}

/// Ends a polygon. A polygon with fewer than three corners has no area and is dropped.
Polygon closed(Polygon polygon) {
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

/// Returns the part of a convex polygon that lies in a half-plane.
Polygon cut(const Polygon& polygon, const HalfPlane& side) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint2& p = polygon[i];
    const RationalPoint2& q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = side.excess(p);
    const Rational at_q = side.excess(q);
    if (at_p.sign() <= 0) add_corner(result, p);
    if (at_p.sign() * at_q.sign() < 0) {
      const Rational t = at_p / (at_p - at_q);
      add_corner(result, {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return closed(std::move(result));
}

/// Returns the centre of the circle through three points that do not lie on a line.
RationalPoint2 centre_of(const RationalPoint2& p, const RationalPoint2& q,
                         const RationalPoint2& r) {
  const RationalPoint2 u = q - p;
  const RationalPoint2 v = r - p;
  const Rational twice_area = 2 * (u.x * v.y - u.y * v.x);
  const Rational uu = u.x * u.x + u.y * u.y;
  const Rational vv = v.x * v.x + v.y * v.y;
  return {p.x + (v.y * uu - u.y * vv) / twice_area, p.y + (u.x * vv - v.x * uu) / twice_area};
}

/// The sites, their triangles, and the box.
class Voronoi {
 public:
  Voronoi(const PointTable2& sites, const RationalPoint2& low, const RationalPoint2& high,
          Context& context)
      : sites_(sites),
        low_(low),
        high_(high),
        context_(context),
        memory_(context),
        triangulation_(delaunay(sites, context)) {}

  Layer cells() {
    find_centres();
    find_corners();
    find_straight_neighbours();
    Layer layer;
    for (std::uint32_t site = 0; site < sites_.size(); ++site) {
      if (site % kSitesPerCheckpoint == 0) {
        context_.checkpoint("voronoi", site, sites_.size());
        charge(layer.points.bytes());
      }
      add_feature(layer, cell(site));
    }
    return layer;
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Charges memory for the points of the layer. Their array grows by doubling.
  void charge(std::size_t bytes) {
    memory_.add(2 * (bytes - charged_), "voronoi");
    charged_ = bytes;
  }

  void find_centres() {
    constexpr std::uint64_t kCentreBytes = 400;
    memory_.add(kCentreBytes * triangulation_.triangles.size(), "voronoi");
    for (const auto& [a, b, c] : triangulation_.triangles) {
      if (centres_.size() % kSitesPerCheckpoint == 0) {
        context_.checkpoint("voronoi", centres_.size(), triangulation_.triangles.size());
      }
      centres_.push_back(centre_of(sites_.exact(a), sites_.exact(b), sites_.exact(c)));
    }
  }

  /// Sorts the corners of all triangles by their sites. Corner 3 t + i is corner i of triangle t.
  void find_corners() {
    const std::size_t count = 3 * triangulation_.triangles.size();
    begin_.assign(sites_.size() + 1, 0);
    for (std::size_t corner = 0; corner < count; ++corner) ++begin_[site_of(corner) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    corners_.resize(count);
    for (std::size_t corner = 0; corner < count; ++corner) {
      corners_[next[site_of(corner)]++] = static_cast<std::uint32_t>(corner);
    }
  }

  /// Finds the neighbours of sites that all lie on a line.
  void find_straight_neighbours() {
    if (!triangulation_.triangles.empty()) return;
    std::vector<std::uint32_t> order(sites_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return compare_xy(sites_, i, j) == Sign::Negative;
    });
    straight_.resize(sites_.size());
    is_repeated_.assign(sites_.size(), 0);
    std::uint32_t previous = kNone;
    for (const std::uint32_t site : order) {
      if (previous != kNone && compare_xy(sites_, previous, site) == Sign::Zero) {
        is_repeated_[site] = 1;
        continue;
      }
      if (previous != kNone) {
        straight_[previous].push_back(site);
        straight_[site].push_back(previous);
      }
      previous = site;
    }
  }

  std::uint32_t site_of(std::size_t corner) const {
    return triangulation_.triangles[corner / 3][corner % 3];
  }
  /// Returns the site that follows a corner around its triangle.
  std::uint32_t after(std::size_t corner) const {
    return triangulation_.triangles[corner / 3][(corner % 3 + 1) % 3];
  }
  std::uint32_t before(std::size_t corner) const {
    return triangulation_.triangles[corner / 3][(corner % 3 + 2) % 3];
  }

  Polygon cell(std::uint32_t site) const {
    if (triangulation_.triangles.empty()) {
      return is_repeated_[site] != 0 ? Polygon() : cut_box(site, straight_[site]);
    }
    const std::vector<std::uint32_t> around = corners_around(site);
    if (around.empty()) return {};
    if (after(around.front()) != before(around.back())) return cut_box(site, neighbours(around));
    Polygon polygon;
    for (const std::uint32_t corner : around) add_corner(polygon, centres_[corner / 3]);
    return clipped(closed(std::move(polygon)));
  }

  /// Returns the corners at a site, counter-clockwise around it. If the site is on the convex hull,
  /// the first corner follows the gap.
  std::vector<std::uint32_t> corners_around(std::uint32_t site) const {
    std::vector<std::uint32_t> around(corners_.begin() + begin_[site],
                                      corners_.begin() + begin_[site + 1]);
    if (around.empty()) return around;
    // Finds the corner whose first neighbour is not the last neighbour of any other corner. The
    // pairs are the first neighbour of a corner, and the corner.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_first;
    std::vector<std::uint32_t> lasts;
    for (const std::uint32_t corner : around) {
      by_first.emplace_back(after(corner), corner);
      lasts.push_back(before(corner));
    }
    std::sort(by_first.begin(), by_first.end());
    std::sort(lasts.begin(), lasts.end());
    std::uint32_t at = by_first.front().second;
    for (const auto& [first, corner] : by_first) {
      if (!std::binary_search(lasts.begin(), lasts.end(), first)) at = corner;
    }
    for (std::uint32_t& place : around) {
      place = at;
      const auto next =
          std::lower_bound(by_first.begin(), by_first.end(), std::pair(before(at), 0U));
      if (next != by_first.end() && next->first == before(at)) at = next->second;
    }
    return around;
  }

  std::vector<std::uint32_t> neighbours(const std::vector<std::uint32_t>& around) const {
    std::vector<std::uint32_t> sites{after(around.front())};
    for (const std::uint32_t corner : around) sites.push_back(before(corner));
    return sites;
  }

  Polygon box() const { return {low_, {high_.x, low_.y}, high_, {low_.x, high_.y}}; }

  Polygon cut_box(std::uint32_t site, const std::vector<std::uint32_t>& neighbours) const {
    Polygon polygon = box();
    for (const std::uint32_t other : neighbours) {
      if (polygon.empty()) break;
      polygon = cut(polygon, nearer(sites_.exact(site), sites_.exact(other)));
    }
    return polygon;
  }

  Polygon clipped(Polygon polygon) const {
    const auto is_inside = [this](const RationalPoint2& p) {
      return low_.x <= p.x && p.x <= high_.x && low_.y <= p.y && p.y <= high_.y;
    };
    if (std::all_of(polygon.begin(), polygon.end(), is_inside)) return polygon;
    for (const HalfPlane& side : {HalfPlane{1, 0, high_.x}, HalfPlane{0, 1, high_.y},
                                  HalfPlane{-1, 0, -low_.x}, HalfPlane{0, -1, -low_.y}}) {
      polygon = cut(polygon, side);
    }
    return polygon;
  }

  static void add_feature(Layer& layer, const Polygon& polygon) {
    if (!polygon.empty()) {
      for (const RationalPoint2& p : polygon) {
        layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
        layer.points.push_back(p.x, p.y);
      }
      layer.end_ring();
      layer.end_polygon();
    }
    layer.end_feature({}, {});
  }

  const PointTable2& sites_;
  const RationalPoint2 low_, high_;
  Context& context_;
  MemoryCharge memory_;
  std::size_t charged_ = 0;
  PlaneTriangulation triangulation_;
  std::vector<RationalPoint2> centres_;               // The centre of each triangle.
  std::vector<std::uint32_t> begin_, corners_;        // The corners of triangles at each site.
  std::vector<std::vector<std::uint32_t>> straight_;  // The neighbours, if all sites are collinear.
  std::vector<std::uint8_t> is_repeated_;
};

}  // namespace

Layer voronoi_cells(const PointTable2& sites, const RationalPoint2& low, const RationalPoint2& high,
                    Context& context) {
  if (!(low.x < high.x && low.y < high.y)) {
    throw Error(ErrorCode::BadArgument, "the box of a Voronoi diagram must have an area");
  }
  return Voronoi(sites, low, high, context).cells();
}

}  // namespace plumb
