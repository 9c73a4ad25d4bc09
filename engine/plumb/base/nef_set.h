// Concepts that state the common interface of the sets of the plane, of the sphere and of space.
//
// Functions of Nef2, NefSphere and Nef3 that serve the same purpose have the same name, the same
// order of arguments, and the same form of results. Code written for the concept NefSet works for
// all three classes; tests/base/nef_set_test.cpp instantiates such code for each of them.
//
// The classes differ in the elements of their sets: points of the plane, directions, and points of
// space. The types that depend on the kind of element are members of the class: Point, Complex,
// Marks, Counts, Location, Hit, Selector and Flaw.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A class of sets. Boolean operations and topological operators on sets of the class give sets of
/// the same class. Each set is represented by a minimal complex.
template <class Set>
concept NefSet = std::regular<Set> &&
    requires(const Set& a, const Set& b, const typename Set::Point& p,
             const typename Set::Selector& selector, typename Set::Complex complex,
             typename Set::Marks marks, std::span<const Set> sets, MarkFunction f,
             Context& context) {
  // Constructing sets.
  { Set::empty() } -> std::same_as<Set>;
  { Set::whole() } -> std::same_as<Set>;
  { Set::point(p) } -> std::same_as<Set>;
  { Set::from_complex(complex, context) } -> std::same_as<Set>;
  { Set::from_minimal_unchecked(complex) } -> std::same_as<Set>;
  { a.with_marks(marks, context) } -> std::same_as<Set>;

  // Queries.
  { a.complex() } -> std::same_as<const typename Set::Complex&>;
  { a.marks() } -> std::same_as<typename Set::Marks>;
  { a.counts() } -> std::same_as<typename Set::Counts>;
  { a.bytes() } -> std::same_as<std::size_t>;
  { a.is_empty() } -> std::same_as<bool>;
  { a.is_whole() } -> std::same_as<bool>;
  { a.is_closed() } -> std::same_as<bool>;
  { a.is_open() } -> std::same_as<bool>;
  { a.is_subset_of(b, context) } -> std::same_as<bool>;
  { a.contains(p, context) } -> std::same_as<bool>;
  { a.locate(p, context) } -> std::same_as<typename Set::Location>;
  { a.locate(p, context).marked } -> std::convertible_to<bool>;
  { a.has_on_boundary(p, context) } -> std::same_as<bool>;
  { a.shoot(p, p, context) } -> std::same_as<std::optional<typename Set::Hit>>;
  { a.shoot_to_boundary(p, p, context) } -> std::same_as<std::optional<typename Set::Hit>>;
  { a.shoot(p, p, context)->location } -> std::convertible_to<typename Set::Location>;
  { a.shoot(p, p, context)->point } -> std::convertible_to<typename Set::Point>;
  { a.audit(context) } -> std::same_as<std::optional<typename Set::Flaw>>;

  // Operations of one set.
  { a.complement(context) } -> std::same_as<Set>;
  { a.interior(context) } -> std::same_as<Set>;
  { a.closure(context) } -> std::same_as<Set>;
  { a.boundary(context) } -> std::same_as<Set>;
  { a.exterior(context) } -> std::same_as<Set>;
  { a.regularization(context) } -> std::same_as<Set>;
  { !a } -> std::same_as<Set>;

  // Operations of two or more sets.
  { a + b } -> std::same_as<Set>;
  { a* b } -> std::same_as<Set>;
  { a - b } -> std::same_as<Set>;
  { a ^ b } -> std::same_as<Set>;
  { boolean_op(a, b, f, context) } -> std::same_as<Set>;
  { boolean_op(a, selector, b, selector, f, context) } -> std::same_as<Set>;
  { union_of(sets, context) } -> std::same_as<Set>;
  { intersection_of(sets, context) } -> std::same_as<Set>;
};

/// A NefSet with an exact measure, which is an area or a volume. (NefSphere has no exact measure,
/// because a solid angle is in general not a rational number.)
template <class Set>
concept MeasurableNefSet = NefSet<Set> && requires(const Set& a, Context& context) {
  { a.measure(context)->sign() } -> std::convertible_to<int>;
  { a.is_bounded() } -> std::same_as<bool>;
};

/// Returns the closure of the interior of the union. This is the union that users of meshes and
/// polygons expect: the result is closed and has no isolated points, slits or dangling parts.
template <NefSet Set>
[[nodiscard]] Set regularized_union(const Set& a, const Set& b,
                                    Context& context = unlimited_context()) {
  return boolean_op(a, b, kUnion, context).regularization(context);
}
/// Returns the closure of the interior of the intersection. The result is empty if the two sets
/// only touch each other.
template <NefSet Set>
[[nodiscard]] Set regularized_intersection(const Set& a, const Set& b,
                                           Context& context = unlimited_context()) {
  return boolean_op(a, b, kIntersection, context).regularization(context);
}
/// Returns the closure of the interior of a - b. The result is closed. The result contains its
/// whole boundary, including the part that lies on the boundary of b.
template <NefSet Set>
[[nodiscard]] Set regularized_difference(const Set& a, const Set& b,
                                         Context& context = unlimited_context()) {
  return boolean_op(a, b, kDifference, context).regularization(context);
}
/// Returns the closure of the interior of the symmetric difference. The symmetric difference
/// consists of the points that belong to exactly one of the sets.
template <NefSet Set>
[[nodiscard]] Set regularized_symmetric_difference(const Set& a, const Set& b,
                                                   Context& context = unlimited_context()) {
  return boolean_op(a, b, kSymmetricDifference, context).regularization(context);
}

}  // namespace plumb
#pragma GCC visibility pop
