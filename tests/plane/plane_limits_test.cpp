// Sets of the plane under limits: memory, cancellation, progress.
#include <gtest/gtest.h>

#include <stop_token>

#include "generate/plane_families.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/error.h"

namespace plumb::plane_limits_test {
namespace {

struct Scene {
  PointTable2 points;
  std::vector<SweepSegment> segments;
};

Scene crossing_segments(std::size_t n) {
  Scene scene;
  for (const auto& [p, q] : testing::long_segments(n)) {
    const auto i = static_cast<std::uint32_t>(scene.points.size());
    scene.points.push_back(p);
    scene.points.push_back(q);
    scene.segments.push_back({i, i + 1});
  }
  return scene;
}

ErrorCode code_of(const Scene& scene, Context context) {
  try {
    arrange(scene.points, scene.segments, context);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::Usage;  // none of those asked for
}

TEST(PlaneLimits, ManyCrossingsOfFewSegmentsHitTheMemoryLimit) {
  Limits limits;
  limits.max_memory_bytes = std::uint64_t{8} << 20U;
  EXPECT_EQ(code_of(crossing_segments(1000), Context(limits)), ErrorCode::ResourceLimit);
  EXPECT_NO_THROW({
    Context context(limits);
    const Scene few = crossing_segments(100);
    arrange(few.points, few.segments, context);
  });
}

TEST(PlaneLimits, MemoryIsGivenBack) {
  Limits limits;
  limits.max_memory_bytes = std::uint64_t{8} << 20U;
  Context context(limits);
  const Scene scene = crossing_segments(300);
  for (int i = 0; i < 20; ++i) arrange(scene.points, scene.segments, context);
}

TEST(PlaneLimits, AStopRequestCancels) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(code_of(crossing_segments(10), Context({}, stop.get_token())), ErrorCode::Cancelled);
}

TEST(PlaneLimits, OperandsStayAsTheyWereWhenAnOperationFails) {
  const Nef2 a = Nef2::polygon(testing::star_polygon(1000, 1));
  const Nef2 b = Nef2::polygon(testing::star_polygon(1000, 2));
  const Nef2 copy = a;
  std::stop_source stop;
  stop.request_stop();
  Context context({}, stop.get_token());
  EXPECT_THROW(boolean_op(a, b, kUnion, context), Error);
  EXPECT_TRUE(a == copy);
  EXPECT_FALSE(a.audit().has_value());
}

TEST(PlaneLimits, AuditsAndAreasKeepToThem) {
  const Nef2 star = Nef2::polygon(testing::star_polygon(1000, 1));
  Context context;
  EXPECT_FALSE(audit(star.complex(), AuditForm::Minimal, context).has_value());
  EXPECT_EQ(marked_area(star.complex(), context), star.area());
  std::stop_source stop;
  stop.request_stop();
  Context stopped({}, stop.get_token());
  EXPECT_THROW(audit(star.complex(), AuditForm::Minimal, stopped), Error);
  EXPECT_THROW(marked_area(star.complex(), stopped), Error);
}

}  // namespace
}  // namespace plumb::plane_limits_test
