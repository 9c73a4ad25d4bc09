#include "generate/counted_memory.h"

#include <cstdlib>
#include <new>

namespace plumb::testing {
namespace {

CountedMemory memory;

void* allocate(std::size_t bytes, std::size_t alignment) noexcept {
  ++memory.allocations;
  memory.bytes += bytes;
  if (memory.left == 0) return nullptr;
  if (memory.left > 0) --memory.left;
  void* const block = std::aligned_alloc(alignment, (bytes + alignment) / alignment * alignment);
  if (block != nullptr) ++memory.held;
  return block;
}

void* allocate_or_throw(std::size_t bytes, std::size_t alignment) {
  if (void* const block = allocate(bytes, alignment)) return block;
  throw std::bad_alloc();
}

void give_back(void* block) noexcept {
  if (block != nullptr) --memory.held;
  std::free(block);
}

constexpr std::size_t kAlignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

CountedMemory& counted_memory() { return memory; }

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
