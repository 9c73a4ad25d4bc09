// Points and rays in a set.

#include <array>
#include <cmath>

#include "plumb/predicates/error.h"
#include "plumb/space/set/nef3_state.h"

namespace plumb {
namespace {

void require_finite(const Point3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    throw Error(ErrorCode::NotFinite, "the coordinates of a point must be finite");
  }
}

bool is_marked(const SpaceComplex& c, SpaceItem item) {
  switch (item.kind()) {
    case SpaceItem::Kind::Vertex:
      return c.vertex_mark[item.index()] == 1;
    case SpaceItem::Kind::Edge:
      return c.edge_mark[item.index()] == 1;
    case SpaceItem::Kind::Facet:
      return c.facet_mark[item.index()] == 1;
    case SpaceItem::Kind::Volume:
      break;
  }
  return c.volume_mark[item.index()] == 1;
}

RationalPoint3 along(const RationalPoint3& p, const RationalPoint3& d) {
  return {p.x + d.x, p.y + d.y, p.z + d.z};
}

RationalPoint3 middle(const RationalPoint3& p, const RationalPoint3& q) {
  return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
}

}  // namespace

const SpaceLocator& Nef3::locator() const {
  std::call_once(state_->locator_made,
                 [this] { state_->locator = std::make_unique<SpaceLocator>(state_->complex); });
  return *state_->locator;
}

SpaceLocation Nef3::locate(const RationalPoint3& p, Context& context) const {
  context.checkpoint("locate", 0, 0);
  const SpaceItem item = locator().locate(p);
  return {item, is_marked(complex(), item)};
}

SpaceLocation Nef3::locate(const Point3& p, Context& context) const {
  require_finite(p);
  context.checkpoint("locate", 0, 0);
  const SpaceItem item = locator().locate(p);
  return {item, is_marked(complex(), item)};
}

void Nef3::contains(std::span<const Point3> points, std::span<Mark> marked,
                    Context& context) const {
  if (points.size() != marked.size()) {
    throw Error(ErrorCode::BadArgument, "one mark is needed for each point");
  }
  constexpr std::size_t kPointsPerCheckpoint = 256;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kPointsPerCheckpoint == 0) context.checkpoint("locate", i, points.size());
    require_finite(points[i]);
    marked[i] = is_marked(complex(), locator().locate(points[i])) ? 1 : 0;
  }
}

bool Nef3::has_on_boundary(const RationalPoint3& p, Context& context) const {
  context.checkpoint("locate", 0, 0);
  return locator().on_item(p).is_valid();
}

bool Nef3::has_on_boundary(const Point3& p, Context& context) const {
  require_finite(p);
  context.checkpoint("locate", 0, 0);
  return locator().on_item(p).is_valid();
}

// Between two hits the ray stays in one cell, so any point in between tells which.
std::optional<SpaceHit> Nef3::shoot_if(const RationalPoint3& origin,
                                       const RationalPoint3& direction,
                                       const std::function<bool(SpaceItem)>& accepts,
                                       Context& context) const {
  if (direction.x == 0 && direction.y == 0 && direction.z == 0) {
    throw Error(ErrorCode::BadArgument, "the direction of a ray must not be zero");
  }
  const auto hit = [this](SpaceItem item, const RationalPoint3& point) {
    return SpaceHit{{item, is_marked(complex(), item)}, point};
  };
  SpaceItemHit at{locator().locate(origin), origin};
  for (;;) {
    context.checkpoint("shoot", 0, 0);
    if (accepts(at.item)) return hit(at.item, at.point);
    const std::optional<SpaceItemHit> next = locator().shoot(at.point, direction);
    const RationalPoint3 beyond = next ? middle(at.point, next->point) : along(at.point, direction);
    const SpaceItem entered = locator().locate(beyond);
    if (accepts(entered)) return hit(entered, at.point);
    if (!next) return std::nullopt;
    at = *next;
  }
}

std::optional<SpaceHit> Nef3::shoot(const RationalPoint3& origin, const RationalPoint3& direction,
                                    Context& context) const {
  return shoot_if(
      origin, direction, [this](SpaceItem item) { return is_marked(complex(), item); }, context);
}

std::optional<SpaceHit> Nef3::shoot_to_boundary(const RationalPoint3& origin,
                                                const RationalPoint3& direction,
                                                Context& context) const {
  return shoot_if(
      origin, direction, [](SpaceItem item) { return item.kind() != SpaceItem::Kind::Volume; },
      context);
}

}  // namespace plumb
