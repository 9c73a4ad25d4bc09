// Point location and ray shooting over one box tree.
//
// Items of the tree are facets, free edges and isolated vertices; their boxes cover all edges and
// vertices. A point is first compared with the items whose boxes contain it. If it lies on no item,
// it lies in the volume that a ray towards -x sees first. All decisions are exact: boxes only
// choose candidates, and a candidate is left out only where a bound proves that it is farther away
// than the best hit.
//
// Short rays first: boxes that meet a piece of the ray a few mean box sizes long are few and found
// without divisions. A hit well within the piece is the nearest of all hits, because every nearer
// item meets the piece, too. For points in doubles a grid of known volumes (volume_grid.h) is asked
// first; it is made once, under a std::once_flag, and then read by any thread.
//
// Tested by tests/space/space_locator_test.cpp.

#include "plumb/space/space_locator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/query_point3.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/query/space_ray.h"
#include "plumb/space/query/volume_grid.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {
namespace {

constexpr SphereDirection kRight{kPlaneY, kPlaneZ};  ///< The direction of x.
constexpr std::size_t kAxisX = 0;
/// This part of a distance is less than the distance in spite of all roundings.
constexpr double kWellWithin = 0.99;

/// Returns the mark of a cell.
Mark mark_of(const SpaceComplex& complex, SpaceItem item) {
  switch (item.kind()) {
    case SpaceItem::Kind::Vertex:
      return complex.vertex_mark[item.index()];
    case SpaceItem::Kind::Edge:
      return complex.edge_mark[item.index()];
    case SpaceItem::Kind::Facet:
      return complex.facet_mark[item.index()];
    case SpaceItem::Kind::Volume:
      break;
  }
  return complex.volume_mark[item.index()];
}

}  // namespace

/// The index of a locator.
struct SpaceLocator::Tree {
  explicit Tree(const SpaceComplex& complex);

  /// Returns the first cell that the ray meets strictly after its origin.
  std::optional<SpaceRayHit> first_hit(const SpaceRay& ray) const;
  SpaceItem on_item(const QueryPoint3& p) const;
  VolumeId volume_of(const QueryPoint3& p) const;
  VolumeId volume_of(const Point3& p) const;
  SpaceItem locate(const QueryPoint3& p) const;
  SpaceItem locate(const Point3& p) const;

 private:
  void add(SpaceItem item) {
    items_.push_back(item);
    boxes_.push_back(axis_box(item));
  }
  Box3 axis_box(SpaceItem item) const;
  void choose_frame();
  BoxRay box_ray(const SpaceRay& ray) const;
  Box3 piece(const SpaceRay& ray, double length) const;
  bool find_near(const SpaceRay& ray, std::optional<SpaceRayHit>& hit) const;
  void add_hits(SpaceItem item, const SpaceRay& ray, std::vector<SpaceRayHit>& hits) const;
  SpaceItem on(FacetId f, const QueryPoint3& p) const;
  SpaceItem on(EdgeId e, const QueryPoint3& p) const;
  bool is_at(VertexId v, const QueryPoint3& p) const;
  SpaceItem on(SpaceItem item, const QueryPoint3& p) const;
  VolumeId volume_right_of(SpaceItem item) const;
  const VolumeGrid& grid() const;
  bool locate_between(const QueryPoint3& p, const VolumeGrid::Left& left, SpaceItem& found) const;

  const SpaceComplex& complex_;
  std::vector<SpaceItem> items_;
  std::vector<Box3> boxes_;
  BoxFrame frame_;
  bool is_turned_ = false;
  double mean_extent_ = 0;  // The mean over finite boxes.
  BoxTree boxes_tree_;
  mutable std::once_flag grid_made_;
  mutable VolumeGrid known_grid_;
};

// --- the tree

SpaceLocator::Tree::Tree(const SpaceComplex& complex) : complex_(complex) {
  items_.reserve(complex_.facet_count());
  boxes_.reserve(complex_.facet_count());
  for (std::size_t f = 0; f < complex_.facet_count(); ++f) add(FacetId(f));
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    if (!complex_.edge_use[e].is_valid()) add(EdgeId(e));
  }
  for (std::size_t v = 0; v < complex_.vertex_count(); ++v) {
    const bool is_alone =
        complex_.star_of(VertexId(v)).empty() && !complex_.vertex_facet[v].is_valid();
    if (is_alone) add(VertexId(v));
  }
  choose_frame();
  double sum = 0;
  for (const Box3& box : boxes_) sum += std::isfinite(box.extent()) ? box.extent() : 0;
  if (!boxes_.empty()) mean_extent_ = sum / static_cast<double>(boxes_.size());
  boxes_tree_ = BoxTree(boxes_);
  boxes_ = std::vector<Box3>();  // This releases the memory, which an assignment of {} would not.
}

/// Returns the box of an item along the coordinate axes.
Box3 SpaceLocator::Tree::axis_box(SpaceItem item) const {
  if (item.kind() == SpaceItem::Kind::Facet) return box_of(complex_, item.facet());
  if (item.kind() == SpaceItem::Kind::Edge) return box_of(complex_, item.edge());
  return box_of(complex_, item.vertex());
}

/// If many of the boxes meet, and another frame has far fewer pairs, replaces the boxes by those of
/// the other frame.
void SpaceLocator::Tree::choose_frame() {
  const double pairs = expected_pairs(boxes_, boxes_);
  if (!has_many_pairs(pairs, boxes_.size())) return;
  const BoxFrame other = BoxFrame::of_edges(std::array{&complex_});
  std::vector<Box3> turned;
  for (const SpaceItem item : items_) {
    if (item.kind() == SpaceItem::Kind::Facet) {
      turned.push_back(other.box_of(complex_, item.facet()));
    } else if (item.kind() == SpaceItem::Kind::Edge) {
      turned.push_back(other.box_of(complex_, item.edge()));
    } else {
      turned.push_back(other.box_of(complex_, item.vertex()));
    }
  }
  if (!is_better_frame(expected_pairs(turned, turned), pairs)) return;
  boxes_ = std::move(turned);
  frame_ = other;
  is_turned_ = true;
}

// --- points on items

/// Whether a vertex is at p.
bool SpaceLocator::Tree::is_at(VertexId v, const QueryPoint3& p) const {
  const SpacePoint x = complex_.vertex_point[v];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (compare_axis(complex_.points(), x, p, axis) != Sign::Zero) return false;
  }
  return true;
}

/// Returns the edge or the end of it on which p lies, or an invalid item. If p lies on both planes
/// it lies on the edge's line; there it is an end, or strictly between the ends along some axis.
SpaceItem SpaceLocator::Tree::on(EdgeId e, const QueryPoint3& p) const {
  for (const PlaneId plane : complex_.edge_planes[e]) {
    if (side(complex_.points(), p, plane) != Sign::Zero) return {};
  }
  const HalfedgeId h(2 * std::size_t{e.value()});
  const VertexId a = complex_.origin[h.value()], b = complex_.target(h);
  if (is_at(a, p)) return a;
  if (is_at(b, p)) return b;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto order = [&](VertexId v) {
      return compare_axis(complex_.points(), complex_.vertex_point[v], p, axis);
    };
    if (order(a) * order(b) == Sign::Negative) return e;
  }
  return {};
}

/// Returns the facet on which p lies, or the cell of its boundary, or an invalid item. The plane is
/// certainly not parallel to the axis of the largest component of its normal, so the shadows along
/// this axis distinguish the points of the plane.
SpaceItem SpaceLocator::Tree::on(FacetId f, const QueryPoint3& p) const {
  const PlaneId plane = complex_.facet_plane[f];
  if (side(complex_.points(), p, plane) != Sign::Zero) return {};
  const auto& n = complex_.planes().row(plane).n;
  const auto is_less = [](double x, double y) { return std::fabs(x) < std::fabs(y); };
  const auto axis =
      static_cast<std::size_t>(std::max_element(n.begin(), n.end(), is_less) - n.begin());
  std::vector<SpaceRayHit> hits;
  SpaceRay(complex_, p, axis, false).add_hits(f, hits);
  return hits.empty() ? SpaceItem() : hits[0].item;
}

SpaceItem SpaceLocator::Tree::on(SpaceItem item, const QueryPoint3& p) const {
  if (item.kind() == SpaceItem::Kind::Facet) return on(item.facet(), p);
  if (item.kind() == SpaceItem::Kind::Edge) return on(item.edge(), p);
  return is_at(item.vertex(), p) ? item : SpaceItem();
}

SpaceItem SpaceLocator::Tree::on_item(const QueryPoint3& p) const {
  SpaceItem found;
  boxes_tree_.for_each_meeting(frame_.turned(box_of(p.box())), [&](std::uint32_t i) {
    if (mark_of(complex_, items_[i]) != kBeyond) found = on(items_[i], p);
    return !found.is_valid();
  });
  return found;
}

// --- rays

/// Returns the ray for the box tree, which is certainly wide enough. The time of the box ray is the
/// distance along the ray.
BoxRay SpaceLocator::Tree::box_ray(const SpaceRay& ray) const {
  Box3 direction;
  for (std::size_t i = 0; i < 3; ++i) {
    Ball d = Ball{ray.is_reverse() ? -1.0 : 1.0, 0};
    if (i != ray.axis()) d = ray.is_axis_parallel() ? Ball{} : ray.slope(i) * d;
    direction.low[i] = d.mid - d.error;
    direction.high[i] = d.mid + d.error;
  }
  return {frame_.turned(box_of(ray.origin().box())), frame_.turned(direction)};
}

void SpaceLocator::Tree::add_hits(SpaceItem item, const SpaceRay& ray,
                                  std::vector<SpaceRayHit>& hits) const {
  if (item.kind() == SpaceItem::Kind::Facet) {
    ray.add_hits(item.facet(), hits);
  } else if (item.kind() == SpaceItem::Kind::Edge) {
    ray.add_hits(item.edge(), hits);
  } else {
    ray.add_hits(item.vertex(), hits);
  }
}

namespace {

/// The nearest of the hits so far that are in front of the origin.
class NearestHit {
 public:
  explicit NearestHit(const SpaceRay& ray) : ray_(ray) {}

  void look_at(std::span<const SpaceRayHit> hits) {
    for (const SpaceRayHit& hit : hits) {
      // The exact comparison of distances is made only for hits in front of the origin.
      if (ray_.side(hit) != Sign::Positive) continue;
      if (best_ && ray_.compare(hit, *best_) != Sign::Negative) continue;
      best_ = hit;
      limit_ = std::min(limit_, hit.distance.upper());
    }
  }
  const std::optional<SpaceRayHit>& best() const { return best_; }
  double limit() const { return limit_; }  ///< An upper bound of its distance.

 private:
  const SpaceRay& ray_;
  std::optional<SpaceRayHit> best_;
  double limit_ = Box3::kInfinity;
};

}  // namespace

/// Returns the beginning of a ray along an axis, or somewhat less than that for rounding.
Box3 SpaceLocator::Tree::piece(const SpaceRay& ray, double length) const {
  Box3 box = box_of(ray.origin().box());
  if (ray.is_reverse()) {
    box.low[ray.axis()] -= length;
  } else {
    box.high[ray.axis()] += length;
  }
  return box;
}

/// Looks for the first hit in short pieces of the ray. Only few boxes meet a short piece, and they
/// are found without divisions. A hit well within the piece is the nearest of all. Pieces grow
/// eightfold, so that they are no longer than necessary. Returns false if no piece decides, or one
/// meets many boxes, of which not all should be tested.
bool SpaceLocator::Tree::find_near(const SpaceRay& ray, std::optional<SpaceRayHit>& hit) const {
  constexpr int kPieces = 3;
  constexpr int kMostBoxes = 32;
  const Box3 all = boxes_tree_.bounds();
  const std::size_t k = ray.axis();
  std::vector<SpaceRayHit> hits;
  double length = 2 * mean_extent_;
  for (int i = 0; i < kPieces; ++i, length *= 8) {
    NearestHit nearest(ray);
    const Box3 box = piece(ray, length);
    if (!std::isfinite(box.extent()) || box.extent() < kWellWithin * length) return false;
    int left = kMostBoxes;
    boxes_tree_.for_each_meeting(box, [&](std::uint32_t item) {
      hits.clear();
      add_hits(items_[item], ray, hits);
      nearest.look_at(hits);
      return --left > 0;
    });
    if (left == 0) return false;
    hit = nearest.best();
    // A piece that reaches beyond all boxes is the whole ray.
    const bool is_last = ray.is_reverse() ? box.low[k] < all.low[k] : box.high[k] > all.high[k];
    if (is_last || nearest.limit() < kWellWithin * length) return true;
  }
  return false;
}

std::optional<SpaceRayHit> SpaceLocator::Tree::first_hit(const SpaceRay& ray) const {
  std::optional<SpaceRayHit> near;
  const bool has_pieces = ray.is_axis_parallel() && !is_turned_ && mean_extent_ > 0;
  if (has_pieces && find_near(ray, near)) return near;
  NearestHit nearest(ray);
  std::vector<SpaceRayHit> hits;
  boxes_tree_.for_each_along(box_ray(ray), Box3::kInfinity, [&](std::uint32_t i, double) {
    hits.clear();
    add_hits(items_[i], ray, hits);
    nearest.look_at(hits);
    return nearest.limit();
  });
  return nearest.best();
}

// --- volumes

/// Returns the volume through which a ray towards -x arrives at the item. A canonical plane that
/// the ray crosses has a positive x component, so the ray arrives from its positive side.
VolumeId SpaceLocator::Tree::volume_right_of(SpaceItem item) const {
  if (item.kind() == SpaceItem::Kind::Facet) return complex_.facet_volume[item.index()][0];
  LocalMap local;
  local_map(complex_, item, local);
  const SphereCell cell = plumb::locate(complex_.planes(), local.map, kRight);
  PLUMB_CHECK(cell.kind() == SphereCell::Kind::Face);
  return local.volume[cell.index()];
}

VolumeId SpaceLocator::Tree::volume_of(const QueryPoint3& p) const {
  const std::optional<SpaceRayHit> hit = first_hit(SpaceRay(complex_, p, kAxisX, true));
  return hit ? volume_right_of(hit->item) : VolumeId(0);
}

SpaceItem SpaceLocator::Tree::locate(const QueryPoint3& p) const {
  const SpaceItem item = on_item(p);
  return item.is_valid() ? item : SpaceItem(volume_of(p));
}

// --- points in doubles: most are in a cell of the grid that is known

/// Returns the grid, which is made at the first call. If a locator only shoots the few rays of a
/// complex without volumes, it never makes the grid.
const VolumeGrid& SpaceLocator::Tree::grid() const {
  std::call_once(grid_made_, [this] {
    if (is_turned_) return;  // Boxes along the axes would mark nearly all cells.
    std::vector<Box3> around;
    around.reserve(items_.size());
    for (const SpaceItem item : items_) around.push_back(axis_box(item));
    known_grid_ = VolumeGrid(around, [this](const Point3& p) { return volume_of(QueryPoint3(p)); });
  });
  return known_grid_;
}

/// Locates p by the cells between p and a place to its left whose volume is known. Returns false if
/// the nearest hit is so close to that place that it is not certain whether it lies between them.
bool SpaceLocator::Tree::locate_between(const QueryPoint3& p, const VolumeGrid::Left& left,
                                        SpaceItem& found) const {
  const SpaceRay ray(complex_, p, kAxisX, true);
  NearestHit nearest(ray);
  std::vector<SpaceRayHit> hits;
  Box3 way = box_of(p.box());
  way.low[kAxisX] = left.x;
  boxes_tree_.for_each_meeting(way, [&](std::uint32_t i) {
    if (items_[i].kind() == SpaceItem::Kind::Facet && ray.passes_by(items_[i].facet())) return true;
    found = on(items_[i], p);
    if (found.is_valid()) return false;
    hits.clear();
    add_hits(items_[i], ray, hits);
    nearest.look_at(hits);
    return true;
  });
  if (found.is_valid()) return true;
  const double length = p.point().x - left.x;
  // Items that lie to the left of the known place have not been tested, so a hit near it is not
  // certain to be the nearest.
  if (nearest.best() && nearest.limit() > kWellWithin * length) return false;
  found = nearest.best() ? volume_right_of(nearest.best()->item) : left.volume;
  return true;
}

VolumeId SpaceLocator::Tree::volume_of(const Point3& p) const {
  const VolumeId known = grid().volume_at(p);
  return known.is_valid() ? known : volume_of(QueryPoint3(p));
}

SpaceItem SpaceLocator::Tree::locate(const Point3& p) const {
  const VolumeId known = grid().volume_at(p);
  if (known.is_valid()) return known;
  const VolumeGrid::Left left = grid().left_of(p);
  const QueryPoint3 q(p);
  SpaceItem found;
  if (left.volume.is_valid() && locate_between(q, left, found)) return found;
  return locate(q);
}

// --- the public class

SpaceLocator::SpaceLocator(const SpaceComplex& complex)
    : complex_(complex), tree_(std::make_unique<Tree>(complex)) {}
SpaceLocator::~SpaceLocator() = default;

SpaceItem SpaceLocator::on_item(const RationalPoint3& p) const {
  return tree_->on_item(QueryPoint3(p));
}
SpaceItem SpaceLocator::on_item(const Point3& p) const { return tree_->on_item(QueryPoint3(p)); }

VolumeId SpaceLocator::volume_of(const RationalPoint3& p) const {
  return tree_->volume_of(QueryPoint3(p));
}
VolumeId SpaceLocator::volume_of(const Point3& p) const { return tree_->volume_of(p); }

SpaceItem SpaceLocator::locate(const RationalPoint3& p) const {
  return tree_->locate(QueryPoint3(p));
}
SpaceItem SpaceLocator::locate(const Point3& p) const { return tree_->locate(p); }

void SpaceLocator::locate(std::span<const Point3> points, std::span<SpaceItem> items) const {
  PLUMB_CHECK(points.size() == items.size());
  for (std::size_t i = 0; i < points.size(); ++i) items[i] = locate(points[i]);
}

std::optional<SpaceItemHit> SpaceLocator::shoot(const RationalPoint3& origin,
                                                const RationalPoint3& direction) const {
  const QueryPoint3 o(origin);
  const SpaceRay ray(complex_, o, direction);
  const std::optional<SpaceRayHit> hit = tree_->first_hit(ray);
  if (!hit || mark_of(complex_, hit->item) == kBeyond) return std::nullopt;
  return SpaceItemHit{hit->item, ray.point(*hit)};
}

std::optional<SpaceItemHit> SpaceLocator::shoot(const Point3& origin,
                                                const Point3& direction) const {
  const auto exact = [](const Point3& p) {
    return RationalPoint3{exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
  };
  return shoot(exact(origin), exact(direction));
}

SpaceItem SpaceLocator::shoot_left(SpacePoint origin) const {
  const QueryPoint3 o(complex_.points(), origin);
  const std::optional<SpaceRayHit> hit = tree_->first_hit(SpaceRay(complex_, o, kAxisX, true));
  return hit ? hit->item : SpaceItem();
}

}  // namespace plumb
