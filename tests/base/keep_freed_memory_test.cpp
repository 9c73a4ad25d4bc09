// Freed memory is used again: no page of a second large block is touched for the first time. The
// heap asks for huge pages.
#include "plumb/base/keep_freed_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstddef>
#include <fstream>
#include <memory>
#include <string>

namespace plumb::keep_freed_memory_test {
namespace {

#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__)
constexpr bool kHasOtherMalloc = true;
#elif defined(__has_feature)
constexpr bool kHasOtherMalloc = __has_feature(address_sanitizer) ||
                                 __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer);
#else
constexpr bool kHasOtherMalloc = false;
#endif

long pages_touched_first() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

/// First touches of pages while a block is made, written all over and freed.
long touches_of_a_block(std::size_t bytes) {
  const long before = pages_touched_first();
  const std::unique_ptr<volatile char[]> block(new char[bytes]);
  for (std::size_t i = 0; i < bytes; i += 1024) block[i] = 1;
  return pages_touched_first() - before;
}

/// What the kernel says of the heap: "VmFlags: rd wr ... hg".
std::string flags_of_heap() {
  std::ifstream maps("/proc/self/smaps");
  std::string line;
  bool is_heap = false;
  std::string flags;
  while (std::getline(maps, line)) {
    if (line.find('-') < line.find(' ')) is_heap = line.ends_with("[heap]");
    if (is_heap && line.starts_with("VmFlags:")) flags += line + ' ';
  }
  return flags;
}

// Before the other: of a heap that has room nothing is asked.
TEST(UseHugePages, TheHeapAsksForThem) {
  if (kHasOtherMalloc) GTEST_SKIP() << "another malloc";
  if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled")) GTEST_SKIP() << "no such";
  keep_freed_memory();
  EXPECT_EQ(flags_of_heap().find(" hg "), std::string::npos);
  use_huge_pages();
  EXPECT_NE(flags_of_heap().find(" hg "), std::string::npos);
}

TEST(KeepFreedMemory, ASecondBlockTakesThePagesOfTheFirst) {
  if (kHasOtherMalloc) GTEST_SKIP() << "another malloc";
  keep_freed_memory();
  constexpr std::size_t kBytes = std::size_t{24} << 20;
  touches_of_a_block(kBytes);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(touches_of_a_block(kBytes - static_cast<std::size_t>(i) * 4096), 16);
  }
}

}  // namespace
}  // namespace plumb::keep_freed_memory_test
