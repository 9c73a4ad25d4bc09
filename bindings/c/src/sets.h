// The functions that sets of the plane, of the sphere and of space have in common (nef_set.h), once
// for all three.
#pragma once

#include <vector>

#include "handles.h"
#include "plumb/base/nef_set.h"

namespace plumb::c {

inline MarkFunction function_of(int operation) {
  if (operation < 0 || operation > 31) fail_argument("operation is not from 0 to 31");
  return {(operation & 1) != 0, (operation & 2) != 0, (operation & 4) != 0, (operation & 8) != 0};
}

template <class Handle>
plumb_status combine(const Handle* a, const Handle* b, int operation, Handle** out,
                     const plumb_context* context, plumb_error** error) noexcept {
  return make(out, error, [&] {
    Call call(context);
    auto result = boolean_op(need(a, "a").set, need(b, "b").set, function_of(operation), call);
    return (operation & PLUMB_REGULARIZED) != 0 ? result.regularization(call) : result;
  });
}

template <class Handle>
auto sets_of(const Handle* const* handles, std::size_t count) {
  std::vector<decltype(Handle::set)> sets;
  sets.reserve(count);
  for (const Handle* const handle : array(handles, count, "sets")) {
    sets.push_back(need(handle, "an element of sets").set);
  }
  return sets;
}

/// Makes the result of a member function with a Context, such as &Nef3::closure.
template <class Handle, class Member>
plumb_status apply(const Handle* set, Member member, Handle** out, const plumb_context* context,
                   plumb_error** error) noexcept {
  return make(out, error, [&] {
    Call call(context);
    return (need(set, "set").set.*member)(call);
  });
}

/// Makes the text of a flaw, or a null pointer if there is none.
template <class Audit>
plumb_status report_flaw(plumb_bytes** flaw, plumb_error** error, const Audit& audit) noexcept {
  if (flaw != nullptr) *flaw = nullptr;
  return guarded(error, [&] {
    need(flaw, "flaw");
    if (const std::optional<std::string> found = audit()) *flaw = new plumb_bytes{*found};
  });
}

template <class Handle>
plumb_status audit_set(const Handle* set, plumb_bytes** flaw, const plumb_context* context,
                       plumb_error** error) noexcept {
  return report_flaw(flaw, error, [&]() -> std::optional<std::string> {
    Call call(context);
    const auto found = need(set, "set").set.audit(call);
    if (!found) return std::nullopt;
    return found->invariant + (found->place.empty() ? "" : ": ") + found->place;
  });
}

template <class Handle>
plumb_status answer_equals(const Handle* a, const Handle* b, bool* out,
                           plumb_error** error) noexcept {
  return guarded(error, [&] {
    need(out, "out");
    *out = need(a, "a").set == need(b, "b").set;
  });
}

template <class Handle>
plumb_status answer_subset(const Handle* a, const Handle* b, bool* out,
                           const plumb_context* context, plumb_error** error) noexcept {
  return guarded(error, [&] {
    need(out, "out");
    Call call(context);
    *out = need(a, "a").set.is_subset_of(need(b, "b").set, call);
  });
}

/// Finds the first cell on a ray. `Point` makes a point of the numbers from an index on.
template <class Handle, class PointAt, class LocationOf, class NumbersOf>
plumb_status shoot(const Handle* set, const plumb_numbers* ray, std::size_t width, bool to_boundary,
                   bool* is_hit, plumb_location* location, plumb_numbers** point,
                   const plumb_context* context, plumb_error** error, const PointAt& point_at,
                   const LocationOf& location_of, const NumbersOf& numbers) noexcept {
  if (point != nullptr) *point = nullptr;
  return guarded(error, [&] {
    need(is_hit, "is_hit");
    const std::span<const Rational> values = exactly(ray, "ray", 2 * width);
    const auto origin = point_at(values.first(width)), along = point_at(values.subspan(width));
    Call call(context);
    const auto& shot_at = need(set, "set").set;
    const auto hit = to_boundary ? shot_at.shoot_to_boundary(origin, along, call)
                                 : shot_at.shoot(origin, along, call);
    if (hit) {
      if (point != nullptr) *point = new plumb_numbers(numbers(hit->point));
      if (location != nullptr) *location = location_of(hit->location);
    }
    *is_hit = hit.has_value();
  });
}

/// Returns the numbers of the distance of two sets, and sets the cells of the nearest points.
template <class Handle, class LocationOf>
plumb_status find_distance(const Handle* a, const Handle* b, plumb_numbers** out,
                           plumb_location* cells, const plumb_context* context, plumb_error** error,
                           const LocationOf& location_of) noexcept {
  return make(out, error, [&] {
    Call call(context);
    const auto found = distance(need(a, "a").set, need(b, "b").set, call);
    if (cells != nullptr) {
      cells[0] = location_of(found.cell_a);
      cells[1] = location_of(found.cell_b);
    }
    std::vector<Rational> values{found.squared};
    for (const auto* at : {&found.at_a, &found.at_b}) {
      values.push_back(at->x);
      values.push_back(at->y);
      if constexpr (requires { at->z; }) values.push_back(at->z);
    }
    return numbers_of(std::move(values));
  });
}

}  // namespace plumb::c

// Defines the functions plumb_NAME_... of the handle of a class of sets.
#define PLUMB_C_SET(HANDLE, SET)                                                                   \
  plumb_status HANDLE##_empty(HANDLE** out, plumb_error** error) {                                 \
    return make(out, error, [] { return SET::empty(); });                                          \
  }                                                                                                \
  plumb_status HANDLE##_whole(HANDLE** out, plumb_error** error) {                                 \
    return make(out, error, [] { return SET::whole(); });                                          \
  }                                                                                                \
  plumb_status HANDLE##_copy(const HANDLE* set, HANDLE** out, plumb_error** error) {               \
    return make(out, error, [&] { return need(set, "set").set; });                                 \
  }                                                                                                \
  void HANDLE##_free(HANDLE* set) { delete set; }                                                  \
  plumb_status HANDLE##_combine(const HANDLE* a, const HANDLE* b, int operation, HANDLE** out,     \
                                const plumb_context* context, plumb_error** error) {               \
    return combine(a, b, operation, out, context, error);                                          \
  }                                                                                                \
  plumb_status HANDLE##_union(const HANDLE* a, const HANDLE* b, HANDLE** out,                      \
                              const plumb_context* context, plumb_error** error) {                 \
    return combine(a, b, PLUMB_UNION, out, context, error);                                        \
  }                                                                                                \
  plumb_status HANDLE##_intersection(const HANDLE* a, const HANDLE* b, HANDLE** out,               \
                                     const plumb_context* context, plumb_error** error) {          \
    return combine(a, b, PLUMB_INTERSECTION, out, context, error);                                 \
  }                                                                                                \
  plumb_status HANDLE##_difference(const HANDLE* a, const HANDLE* b, HANDLE** out,                 \
                                   const plumb_context* context, plumb_error** error) {            \
    return combine(a, b, PLUMB_DIFFERENCE, out, context, error);                                   \
  }                                                                                                \
  plumb_status HANDLE##_symmetric_difference(const HANDLE* a, const HANDLE* b, HANDLE** out,       \
                                             const plumb_context* context, plumb_error** error) {  \
    return combine(a, b, PLUMB_SYMMETRIC_DIFFERENCE, out, context, error);                         \
  }                                                                                                \
  plumb_status HANDLE##_union_of(const HANDLE* const* sets, size_t count, HANDLE** out,            \
                                 const plumb_context* context, plumb_error** error) {              \
    return make(out, error, [&] {                                                                  \
      Call call(context);                                                                          \
      return union_of(sets_of(sets, count), call);                                                 \
    });                                                                                            \
  }                                                                                                \
  plumb_status HANDLE##_intersection_of(const HANDLE* const* sets, size_t count, HANDLE** out,     \
                                        const plumb_context* context, plumb_error** error) {       \
    return make(out, error, [&] {                                                                  \
      Call call(context);                                                                          \
      return intersection_of(sets_of(sets, count), call);                                          \
    });                                                                                            \
  }                                                                                                \
  plumb_status HANDLE##_complement(const HANDLE* set, HANDLE** out, const plumb_context* context,  \
                                   plumb_error** error) {                                          \
    return apply(set, &SET::complement, out, context, error);                                      \
  }                                                                                                \
  plumb_status HANDLE##_interior(const HANDLE* set, HANDLE** out, const plumb_context* context,    \
                                 plumb_error** error) {                                            \
    return apply(set, &SET::interior, out, context, error);                                        \
  }                                                                                                \
  plumb_status HANDLE##_closure(const HANDLE* set, HANDLE** out, const plumb_context* context,     \
                                plumb_error** error) {                                             \
    return apply(set, &SET::closure, out, context, error);                                         \
  }                                                                                                \
  plumb_status HANDLE##_boundary(const HANDLE* set, HANDLE** out, const plumb_context* context,    \
                                 plumb_error** error) {                                            \
    return apply(set, &SET::boundary, out, context, error);                                        \
  }                                                                                                \
  plumb_status HANDLE##_exterior(const HANDLE* set, HANDLE** out, const plumb_context* context,    \
                                 plumb_error** error) {                                            \
    return apply(set, &SET::exterior, out, context, error);                                        \
  }                                                                                                \
  plumb_status HANDLE##_regularization(const HANDLE* set, HANDLE** out,                            \
                                       const plumb_context* context, plumb_error** error) {        \
    return apply(set, &SET::regularization, out, context, error);                                  \
  }                                                                                                \
  bool HANDLE##_is_empty(const HANDLE* set) { return set != nullptr && set->set.is_empty(); }      \
  bool HANDLE##_is_whole(const HANDLE* set) { return set != nullptr && set->set.is_whole(); }      \
  plumb_status HANDLE##_equals(const HANDLE* a, const HANDLE* b, bool* out, plumb_error** error) { \
    return answer_equals(a, b, out, error);                                                        \
  }                                                                                                \
  plumb_status HANDLE##_is_subset(const HANDLE* a, const HANDLE* b, bool* out,                     \
                                  const plumb_context* context, plumb_error** error) {             \
    return answer_subset(a, b, out, context, error);                                               \
  }                                                                                                \
  plumb_status HANDLE##_audit(const HANDLE* set, plumb_bytes** flaw, const plumb_context* context, \
                              plumb_error** error) {                                               \
    return audit_set(set, flaw, context, error);                                                   \
  }
