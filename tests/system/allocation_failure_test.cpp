// Memory that runs out, at the n-th allocation of every public operation, for n = 1, 2, 3 ...
// (beyond 60 in growing steps): std::bad_alloc leaves the operation, what it took is given back,
// its inputs are what they were, and the same call then gives what it always gave.
//
// GMP and MPFR allocate by malloc and end the program when it fails; what they are asked for is
// bounded before (Limits). Everything else comes through operator new (generate/counted_memory.h).
#include <gtest/gtest.h>

#include <cstdint>
#include <exception>
#include <new>
#include <string>

#include "generate/counted_memory.h"
#include "system/public_operations.h"

namespace plumb::testing::allocation_failure_test {
namespace {

std::uint64_t run(const PublicOperation& operation) {
  Context context;
  return operation.run(context);
}

/// What leaves the operation when all but n allocations are refused; empty: nothing, and the sum is
/// right.
std::string outcome(const PublicOperation& operation, std::int64_t n, std::uint64_t expected) {
  CountedMemory& memory = counted_memory();
  try {
    memory.left = n;
    const std::uint64_t got = run(operation);
    memory.left = -1;
    return got == expected ? "" : "another result";
  } catch (const std::bad_alloc&) {
    memory.left = -1;
    return "";
  } catch (const std::exception& error) {
    memory.left = -1;
    return error.what();
  }
}

void expect_survival(const PublicOperation& operation) {
  SCOPED_TRACE(operation.name);
  CountedMemory& memory = counted_memory();
  const std::uint64_t expected = run(operation);  // whatever is made once is made now
  const std::uint64_t before = memory.allocations;
  ASSERT_EQ(run(operation), expected);
  const auto all = static_cast<std::int64_t>(memory.allocations - before);
  ASSERT_GT(all, 0);
  const std::int64_t held = memory.held;
  for (std::int64_t n = 0; n < all; n += 1 + n / 60) {
    ASSERT_EQ(outcome(operation, n, expected), "") << "allocation " << n << " of " << all;
    ASSERT_EQ(memory.held, held) << "allocation " << n << " of " << all;
  }
  EXPECT_EQ(run(operation), expected);
}

void expect_survival(const OperationRoom& room) {
  SCOPED_TRACE(room.name);
  const std::uint64_t inputs = room.inputs();
  for (const PublicOperation& operation : room.operations) {
    if (!operation.is_json) expect_survival(operation);
    EXPECT_EQ(room.inputs(), inputs) << operation.name;
  }
}

TEST(AllocationFailure, Maps) { expect_survival(map_operations()); }
TEST(AllocationFailure, Plane) { expect_survival(plane_operations()); }
TEST(AllocationFailure, Sphere) { expect_survival(sphere_operations()); }
TEST(AllocationFailure, Space) { expect_survival(space_operations()); }
TEST(AllocationFailure, Extraction) { expect_survival(extraction_operations()); }
TEST(AllocationFailure, Convex) { expect_survival(convex_operations()); }
TEST(AllocationFailure, Surface) { expect_survival(surface_operations()); }
TEST(AllocationFailure, Readers) { expect_survival(reader_operations()); }
TEST(AllocationFailure, Pictures) { expect_survival(picture_operations()); }

}  // namespace
}  // namespace plumb::testing::allocation_failure_test
