// Plumb's side of Booleans of the plane, beside whichever library.
#pragma once

#include <optional>

#include "peer_report.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rounding.h"

namespace plumb::bench {

struct FlatBoolean {
  const char* name;
  MarkFunction marks;
};
inline constexpr FlatBoolean kFlatBooleans[] = {{"intersection", kIntersection},
                                                {"union", kUnion},
                                                {"symmetric difference", kSymmetricDifference}};

/// The result of work() lives until answer() has seen it; only work() is timed.
template <class Work, class Answer>
PeerRun timed(Work work, Answer answer) {
  std::optional<decltype(work())> result;
  return timed_run([&] { result.emplace(work()); }, [&] { return answer(*result); });
}

inline double area_of(const Nef2& set) { return nearest_double(*set.area()); }

/// The answer is the area.
inline PeerRun timed_boolean(const Nef2& a, const Nef2& b, MarkFunction marks) {
  Context context;
  return timed([&] { return boolean_op(a, b, marks, context); },
               [](const Nef2& set) { return area_of(set); });
}

}  // namespace plumb::bench
