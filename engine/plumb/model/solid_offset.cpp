#include "plumb/model/solid_offset.h"

#include <array>
#include <cmath>
#include <utility>

#include "plumb/convex/minkowski.h"
#include "plumb/model/transform.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::array kInnerRadius{0.577350, 0.816496, 0.942809, 0.984731,
                                  0.996116, 0.999024, 0.999755, 0.999938};

/// Returns the complement of a closed set; if the set is bounded, only the part of the complement
/// that lies within `margin` of its box. The result is open.
Nef3 complement_near(const Nef3& closed, const Rational& margin, Context& context) {
  if (!closed.is_bounded()) return closed.complement(context);
  const auto [low, high] = *bounding_box(closed);
  const std::array<HalfSpace3, 6> sides{HalfSpace3{{-1, 0, 0, low.x - margin}, Boundary::Open},
                                        HalfSpace3{{1, 0, 0, -high.x - margin}, Boundary::Open},
                                        HalfSpace3{{0, -1, 0, low.y - margin}, Boundary::Open},
                                        HalfSpace3{{0, 1, 0, -high.y - margin}, Boundary::Open},
                                        HalfSpace3{{0, 0, -1, low.z - margin}, Boundary::Open},
                                        HalfSpace3{{0, 0, 1, -high.z - margin}, Boundary::Open}};
  return boolean_op(Nef3::intersection(sides, context), closed, kDifference, context);
}

// A point p of the set is removed if p + b lies outside of the set for some b of the ball. Then p
// lies in the sum of the complement and the mirrored ball. The points p + b are within the radius
// of the set, so the complement near the set is enough. It is open, and the sum of an open set and
// a body is as fast as the sum of closed sets (minkowski.h).
Nef3 eroded(const Nef3& closed, double radius, unsigned rounds, Context& context) {
  const Nef3 ball = polyhedral_ball(radius, rounds, context);
  const Nef3 mirrored = ball.transformed(scaling({-1, -1, -1}), context);
  const Nef3 outside = complement_near(closed, 2 * exact_rational(radius), context);
  const Nef3 lost = minkowski_sum(outside, mirrored, context);
  return boolean_op(closed, lost, kDifference, context);
}

}  // namespace

double inner_radius(unsigned rounds) {
  if (rounds >= kInnerRadius.size()) {
    throw Error(ErrorCode::BadArgument, "the ball of an offset has at most 7 rounds");
  }
  return kInnerRadius[rounds];
}

Nef3 offset(const Nef3& set, double distance, const SolidOffsetOptions& options, Context& context) {
  if (!std::isfinite(distance)) {
    throw Error(ErrorCode::NotFinite, "the distance of an offset is not finite");
  }
  // This call throws if there are too many rounds.
  static_cast<void>(inner_radius(options.rounds));
  const Nef3 closed = set.closure(context);
  if (distance == 0 || closed.is_empty() || closed.is_whole()) return closed;
  if (distance < 0) return eroded(closed, -distance, options.rounds, context);
  return minkowski_sum(closed, polyhedral_ball(distance, options.rounds, context), context);
}

}  // namespace plumb
