// Points and rays in a set.
#include <array>
#include <cmath>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/space/nef3_state.h"

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

SpaceLocation Nef3::locate(const RationalPoint3& p) const try {
  const SpaceItem item = locator().locate(p);
  return {item, is_marked(complex(), item)};
} catch (...) {
  rethrow_refused_memory();
}

SpaceLocation Nef3::locate(const Point3& p) const try {
  require_finite(p);
  const SpaceItem item = locator().locate(p);
  return {item, is_marked(complex(), item)};
} catch (...) {
  rethrow_refused_memory();
}

void Nef3::contains(std::span<const Point3> points, std::span<Mark> marked) const {
  if (points.size() != marked.size()) {
    throw Error(ErrorCode::BadArgument, "one mark is needed for each point");
  }
  for (std::size_t i = 0; i < points.size(); ++i) marked[i] = contains(points[i]) ? 1 : 0;
}

bool Nef3::has_on_boundary(const RationalPoint3& p) const try {
  return locator().on_item(p).is_valid();
} catch (...) {
  rethrow_refused_memory();
}

bool Nef3::has_on_boundary(const Point3& p) const try {
  require_finite(p);
  return locator().on_item(p).is_valid();
} catch (...) {
  rethrow_refused_memory();
}

// Between two hits the ray stays in one item, and any point there tells which.
std::optional<SpaceHit> Nef3::shoot(const RationalPoint3& p, const RationalPoint3& direction,
                                    const std::function<bool(SpaceItem)>& accepts) const try {
  if (direction.x == 0 && direction.y == 0 && direction.z == 0) {
    throw Error(ErrorCode::BadArgument, "the direction of a ray must not be zero");
  }
  SpaceHit at{locator().locate(p), p};
  for (;;) {
    if (accepts(at.item)) return at;
    const std::optional<SpaceHit> next = locator().shoot(at.point, direction);
    const RationalPoint3 beyond = next ? middle(at.point, next->point) : along(at.point, direction);
    const SpaceItem entered = locator().locate(beyond);
    if (accepts(entered)) return SpaceHit{entered, at.point};
    if (!next) return std::nullopt;
    at = *next;
  }
} catch (...) {
  rethrow_refused_memory();
}

std::optional<SpaceHit> Nef3::shoot_to_marked(const RationalPoint3& p,
                                              const RationalPoint3& direction) const {
  return shoot(p, direction, [this](SpaceItem item) { return is_marked(complex(), item); });
}

std::optional<SpaceHit> Nef3::shoot_to_boundary(const RationalPoint3& p,
                                                const RationalPoint3& direction) const {
  return shoot(p, direction, [](SpaceItem item) { return item.kind() != SpaceItem::Kind::Volume; });
}

}  // namespace plumb
