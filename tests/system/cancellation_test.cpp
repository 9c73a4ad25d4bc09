// A stop that is asked for, at the n-th checkpoint of every public operation, for n = 1, 2, 3 ...
// (beyond 60 in growing steps): Error{Cancelled} leaves the operation, what it took is given back,
// and its inputs are what they were.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "generate/counted_checkpoints.h"
#include "generate/counted_memory.h"
#include "plumb/predicates/error.h"
#include "system/public_operations.h"

namespace plumb::testing::cancellation_test {
namespace {

std::uint64_t run(const PublicOperation& operation) {
  Context context;
  return operation.run(context);
}

/// What leaves the operation when all checkpoints but n cancel.
std::optional<ErrorCode> outcome(const PublicOperation& operation, std::int64_t n) {
  counted_checkpoints().left = n;
  std::optional<ErrorCode> code;
  try {
    run(operation);
  } catch (const Error& error) {
    code = error.code();
  }
  counted_checkpoints().left = -1;
  return code;
}

/// Returns how many checkpoints it has.
std::int64_t expect_cancelled(const PublicOperation& operation) {
  const std::uint64_t expected = run(operation);  // whatever is made once is made now
  const std::uint64_t before = counted_checkpoints().passed;
  run(operation);
  const auto all = static_cast<std::int64_t>(counted_checkpoints().passed - before);
  const std::int64_t held = counted_memory().held;
  for (std::int64_t n = 0; n < all; n += 1 + n / 60) {
    EXPECT_EQ(outcome(operation, n), ErrorCode::Cancelled)
        << operation.name << ": checkpoint " << n << " of " << all;
    EXPECT_EQ(counted_memory().held, held)
        << operation.name << ": checkpoint " << n << " of " << all;
  }
  EXPECT_EQ(run(operation), expected) << operation.name;
  return all;
}

void expect_cancelled(const OperationRoom& room) {
  const std::uint64_t inputs = room.inputs();
  std::int64_t checkpoints = 0;
  for (const PublicOperation& operation : room.operations) {
    checkpoints += expect_cancelled(operation);
    EXPECT_EQ(room.inputs(), inputs) << operation.name;
  }
  EXPECT_GT(checkpoints, 0) << room.name;
}

TEST(Cancellation, Maps) { expect_cancelled(map_operations()); }
TEST(Cancellation, Plane) { expect_cancelled(plane_operations()); }
TEST(Cancellation, Sphere) { expect_cancelled(sphere_operations()); }
TEST(Cancellation, Space) { expect_cancelled(space_operations()); }
TEST(Cancellation, Extraction) { expect_cancelled(extraction_operations()); }
TEST(Cancellation, Convex) { expect_cancelled(convex_operations()); }
TEST(Cancellation, Surface) { expect_cancelled(surface_operations()); }
TEST(Cancellation, Readers) { expect_cancelled(reader_operations()); }

}  // namespace
}  // namespace plumb::testing::cancellation_test
