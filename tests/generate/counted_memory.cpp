#include "generate/counted_memory.h"

#include <gmp.h>
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

namespace plumb::testing {
namespace {

CountedMemory memory;

void hold(void* block) noexcept {
  ++memory.held;
  memory.held_bytes += static_cast<std::int64_t>(malloc_usable_size(block));
  memory.peak_bytes = std::max(memory.peak_bytes, memory.held_bytes);
}

void* allocate(std::size_t bytes, std::size_t alignment) noexcept {
  ++memory.allocations;
  memory.bytes += bytes;
  if (memory.left == 0) return nullptr;
  if (memory.left > 0) --memory.left;
  void* const block = std::aligned_alloc(alignment, (bytes + alignment) / alignment * alignment);
  if (block != nullptr) hold(block);
  return block;
}

void* allocate_or_throw(std::size_t bytes, std::size_t alignment) {
  if (void* const block = allocate(bytes, alignment)) return block;
  throw std::bad_alloc();
}

void give_back(void* block) noexcept {
  if (block == nullptr) return;
  --memory.held;
  memory.held_bytes -= static_cast<std::int64_t>(malloc_usable_size(block));
  std::free(block);
}

void* allocate_number(std::size_t bytes) {
  void* const block = std::malloc(bytes);
  if (block == nullptr) std::abort();
  hold(block);
  return block;
}

void* grow_number(void* old, std::size_t old_bytes, std::size_t bytes) {
  void* const block = allocate_number(bytes);
  std::memcpy(block, old, std::min(old_bytes, bytes));
  give_back(old);
  return block;
}

void free_number(void* block, std::size_t) { give_back(block); }

constexpr std::size_t kAlignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

CountedMemory& counted_memory() { return memory; }

void count_numbers() { mp_set_memory_functions(allocate_number, grow_number, free_number); }

}  // namespace plumb::testing

// All forms: those of a sanitizer do not call each other.
void* operator new(std::size_t bytes) {
  return plumb::testing::allocate_or_throw(bytes, plumb::testing::kAlignment);
}
void* operator new[](std::size_t bytes) {
  return plumb::testing::allocate_or_throw(bytes, plumb::testing::kAlignment);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return plumb::testing::allocate(bytes, plumb::testing::kAlignment);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return plumb::testing::allocate(bytes, plumb::testing::kAlignment);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return plumb::testing::allocate_or_throw(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return plumb::testing::allocate_or_throw(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { plumb::testing::give_back(block); }
void operator delete[](void* block) noexcept { plumb::testing::give_back(block); }
void operator delete(void* block, std::size_t) noexcept { plumb::testing::give_back(block); }
void operator delete[](void* block, std::size_t) noexcept { plumb::testing::give_back(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept {
  plumb::testing::give_back(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
  plumb::testing::give_back(block);
}
void operator delete(void* block, std::align_val_t) noexcept { plumb::testing::give_back(block); }
void operator delete[](void* block, std::align_val_t) noexcept { plumb::testing::give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  plumb::testing::give_back(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
  plumb::testing::give_back(block);
}
