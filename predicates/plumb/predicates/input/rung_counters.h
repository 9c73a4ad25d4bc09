// Counters that record, for each predicate, how many calls each stage decided. (In code, a stage is
// called a rung.) Each thread has its own counters. The counters exist only if PLUMB_COUNT_RUNGS is
// defined. Otherwise count_rung() does nothing and the counts stay zero.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The predicates whose calls are counted.
enum class Predicate : std::uint8_t {
  Orient2d,
  CrossSign,
  Orient3d,
  Incircle,
  Insphere,
  PlaneMinor,
  PlaneDet3,
  PlaneDet4,
  SideOfPlane,
  CompareAxis,
  HoldsLine,          ///< Whether a plane contains the common line of two planes.
  ComparePoints2,     ///< The order of points of a table of the plane.
  CompareCrossings2,  ///< The order of two points of which at least one is a crossing.
  SideOfCrossing2,    ///< orient2d of a line and a crossing.
  PointQuery2,        ///< Predicates on a query point (query2.h) and points of a table.
  RayQuery2           ///< Predicates on a query ray (query2.h) and points and lines of a table.
};
inline constexpr std::size_t kPredicates = 16;
inline constexpr std::array<const char*, kPredicates> kPredicateNames{
    "orient2d",          "cross_sign",       "orient3d",    "incircle",
    "insphere",          "plane minor",      "plane det3",  "plane det4",
    "side of plane",     "compare axis",     "holds line",  "compare points",
    "compare crossings", "side of crossing", "point query", "ray query"};

/// The stages: the filter, small integers, integers of fixed width, GMP integers, and identity. The
/// stage Identity decides by comparing ids of planes, points of space or crossings, without
/// arithmetic.
enum class Rung : std::uint8_t { Filter, Small, Exact, Big, Identity };
inline constexpr std::size_t kRungs = 5;
inline constexpr std::array<const char*, kRungs> kRungNames{"filter", "small", "exact", "big",
                                                            "identity"};

/// The number of calls that each stage of each predicate decided: counts[predicate][rung].
using RungCounts = std::array<std::array<std::uint64_t, kRungs>, kPredicates>;

#ifdef PLUMB_COUNT_RUNGS

namespace detail {
inline thread_local constinit RungCounts rung_counts{};
}

inline void count_rung(Predicate predicate, Rung rung) {
  ++detail::rung_counts[static_cast<std::size_t>(predicate)][static_cast<std::size_t>(rung)];
}

/// Returns the counts of the calling thread since its last reset.
inline RungCounts rung_counts() { return detail::rung_counts; }
inline void reset_rung_counts() { detail::rung_counts = {}; }

#else

inline void count_rung(Predicate, Rung) {}
inline RungCounts rung_counts() { return {}; }
inline void reset_rung_counts() {}

#endif

/// Counts a decision of the stage `rung` and returns `sign`. Requires is_decided(sign).
inline Sign decide(Predicate predicate, Rung rung, FilteredSign sign) {
  count_rung(predicate, rung);
  return decided(sign);
}

}  // namespace plumb
#pragma GCC visibility pop
