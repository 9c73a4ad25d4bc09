// Finds the first cell that a walk once around a great circle meets. The caller passes the cells on
// the circle in order. Internal.
#pragma once

#include <optional>

#include "plumb/sphere/arcs/sphere_arcs.h"
#include "plumb/sphere/nef_sphere.h"

namespace plumb {

/// Whether a cell of the map is marked.
bool is_marked(const SphereMap& map, SphereCell cell);

/// Returns the circle through both directions, in the direction of the shot. Throws
/// Error{BadArgument} if they are the same or opposite.
OrientedPlane intern_circle_through(PlaneTable& planes, const SphereVector& origin,
                                    const SphereVector& towards);

/// A shot, and the cell in which it starts.
class SphereRound {
 public:
  SphereRound(const PlaneTable& planes, const SphereMap& map, OrientedPlane circle,
              CirclePlace from, SphereCell start, const SphereVector& origin)
      : planes_(planes), map_(map), circle_(circle), from_(from), start_(start), origin_(origin) {}

  /// Returns the first marked cell and the place where the walk meets it, or nullopt if there is
  /// none. next() returns the next PathHit, with entry and exit in the direction of the shot, or
  /// nothing; what is met at the start comes first.
  template <class Next>
  std::optional<SphereHit> first_marked(Next next) const {
    if (is_marked(map_, start_)) return SphereHit{{start_, true}, origin_};
    SphereCell between = start_;
    std::optional<PathHit> hit = next();
    if (hit && is_at_start(*hit)) {
      between = after(*hit);
      hit = next();
    }
    if (is_marked(map_, between)) return SphereHit{{between, true}, origin_};
    for (; hit; hit = next()) {
      if (is_marked(map_, hit->cell)) return SphereHit{{hit->cell, true}, at(*hit)};
      between = after(*hit);
      if (is_marked(map_, between)) return SphereHit{{between, true}, at(*hit)};
    }
    return std::nullopt;
  }

  /// Returns the first point or arc, and where it is met; nothing if there is none. next() is as
  /// above.
  template <class Next>
  std::optional<SphereHit> first_of_boundary(Next next) const {
    if (start_.kind() != SphereCell::Kind::Face) {
      return SphereHit{{start_, is_marked(map_, start_)}, origin_};
    }
    const std::optional<PathHit> hit = next();
    if (!hit) return std::nullopt;
    return SphereHit{{hit->cell, is_marked(map_, hit->cell)}, at(*hit)};
  }

 private:
  bool is_at_start(const PathHit& hit) const;
  SphereCell after(const PathHit& hit) const;
  SphereVector at(const PathHit& hit) const;

  const PlaneTable& planes_;
  const SphereMap& map_;
  OrientedPlane circle_;
  CirclePlace from_;
  SphereCell start_;
  const SphereVector& origin_;
};

}  // namespace plumb
