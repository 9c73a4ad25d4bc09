#include "plumb/base/keep_freed_memory.h"

#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <climits>
#include <cstddef>
#include <cstdint>
#include <memory>
#endif

namespace plumb {
namespace {

#if defined(__GLIBC__)
/// Whether the address space of the process may be so small that a reserve would take a part of it
/// that the process needs.
bool is_address_space_scarce() {
  constexpr rlim_t kPlenty = rlim_t{1} << 30;
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur < kPlenty;
}
#endif

}  // namespace

void keep_freed_memory() {
#if defined(__GLIBC__)
  // The greatest value that glibc accepts. Larger blocks are always mapped by themselves.
  constexpr int kMostOfThreshold = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, kMostOfThreshold);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
}

void use_one_heap() {
#if defined(__GLIBC__)
  mallopt(M_ARENA_MAX, 1);
#endif
}

void use_huge_pages() {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
  if (is_address_space_scarce()) return;
  constexpr int kHeap = 64 << 20, kUsualPad = 128 << 10;
  constexpr std::uintptr_t kHugePage = std::uintptr_t{2} << 20;
  const auto end_of_heap = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
  const std::uintptr_t begin = (end_of_heap() + kHugePage - 1) / kHugePage * kHugePage;
  mallopt(M_TOP_PAD, kHeap);
  {
    // The block is larger than what is left, so the heap grows by the block and the pad.
    const std::unique_ptr<volatile char[]> block(new char[std::size_t{1} << 20]);
    block[0] = 0;
  }
  mallopt(M_TOP_PAD, kUsualPad);
  const std::uintptr_t end = end_of_heap() / kHugePage * kHugePage;
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace plumb
