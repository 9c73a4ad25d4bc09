// Minkowski sums and offsets of any two bounded sets of the plane, against the Boolean of A with
// p - B at single points.
//
// Input: a program of records of eight bytes (tests/generate/plane_program.h). The first half is
// one expression over sets of the plane, the rest the other one; what is unbounded is cut to the
// box of its vertices. The judge is tests/oracle/plane_sum_check.h.
#include <algorithm>

#include "generate/plane_program.h"
#include "oracle/plane_sum_check.h"
#include "plumb/plane/plane_offset.h"
#include "plumb/predicates/rounding.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxLines = 8;
constexpr std::size_t kMostEdges = 12;  // Of an operand.

/// The box of all vertices of a set.
Nef2 box_of(const PlaneComplex& c) {
  std::vector<Rational> x, y;
  for (const std::uint32_t p : c.vertex_point) {
    const RationalPoint2 at = exact(c.points, p);
    x.push_back(at.x);
    y.push_back(at.y);
  }
  if (x.empty()) return Nef2::empty();
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  PointTable2 corners;
  corners.push_back(*left, *low);
  corners.push_back(*right, *low);
  corners.push_back(*right, *high);
  corners.push_back(*left, *high);
  const std::vector<std::uint32_t> ring{0, 1, 2, 3}, begin{0, 4};
  return Nef2::polygons(corners, ring, begin, WindingRule::NonZero, Boundary::Closed);
}

/// The expression of so many records that there is not too much of it; in a box if it is unbounded.
Nef2 bounded(std::span<const std::uint8_t> program) {
  for (; program.size() >= 2 * kProgramRecord;
       program = program.first(program.size() - kProgramRecord)) {
    Nef2 set = to_nef(*set_of_program(program, kMaxLines));
    if (!set.is_bounded()) set *= box_of(set.complex());
    if (set.counts().edges <= kMostEdges) return set;
  }
  return Nef2::empty();
}

std::string flaw_of_offset(const Nef2& set, std::uint8_t how) {
  OffsetOptions options;
  options.join = static_cast<OffsetJoin>(how % 4);
  options.circle_segments = 3 + how % 13U;
  const Nef2 closed = set.closure();
  const double distance = 0.25 * (1 + how % 7);
  const Nef2 grown = offset(set, distance, options);
  const Nef2 shrunk = offset(set, -distance, options);
  if (grown.audit() || shrunk.audit()) return "an offset that its audit rejects";
  if (!closed.is_subset_of(grown)) return "a grown set without a point of the set";
  if (!shrunk.is_subset_of(closed)) return "a shrunk set with other points";
  return "";
}

std::string difference_of(std::span<const std::uint8_t> program) {
  const std::size_t half = program.size() / kProgramRecord / 2 * kProgramRecord;
  const Nef2 a = bounded(program.first(half)), b = bounded(program.subspan(half));
  if (const std::string flaw = flaw_of_offset(a, program[1]); !flaw.empty()) return flaw;
  return flaw_of_sum(a, b);
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 16,
                                                     plumb::testing::difference_of};
