// Dot and cross products of vectors of space, as arrays of coordinates or as points. Of doubles
// they are evaluated in the order that is written here, without fused operations, as the error
// bounds of their users assume.
#pragma once

#include <array>
#include <concepts>

#include "plumb/predicates/point.h"
#include "plumb/predicates/rational.h"

namespace plumb {

/// A type of coordinates for which the products below are meant. Fixed-width integers and residues
/// have products of their own, which widen or reduce.
template <class T>
concept VectorCoordinate =
    std::same_as<T, double> || std::same_as<T, Rational> || std::same_as<T, Integer>;

/// A point or vector with members x, y and z of one such type.
template <class V>
concept SpaceVector = requires(const V& v) {
  requires VectorCoordinate<std::remove_cvref_t<decltype(v.x)>>;
  v.y;
  v.z;
};

/// Returns a.b.
template <VectorCoordinate T>
T dot(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <SpaceVector V>
auto dot(const V& a, const V& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Returns a x b.
template <VectorCoordinate T>
std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <SpaceVector V>
V cross(const V& a, const V& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace plumb
