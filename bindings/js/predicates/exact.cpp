// The exact stages of the predicates, as functions of a WebAssembly module.
//
// predicates.js evaluates the filters, which decide nearly all calls, and calls a function of this
// file for the others. So the module needs no filter, and a call that the filter decides never
// leaves JavaScript.
//
// A call allocates for integers of any size only, and keeps nothing: memory is handed out in
// ascending order, and is all free again when the next call begins. Nothing throws: the one
// failure, memory that cannot grow, is a trap.
//
// Tested by bindings/js/tests/predicates.test.mjs.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "plumb/predicates/input_predicates.h"

extern "C" std::uint8_t __heap_base;  // The linker defines it: the end of static data and stack.

namespace {

constexpr std::size_t kPage = std::size_t{1} << 16;
constexpr std::size_t kAlignment = 16;

std::uintptr_t arena_begin() { return reinterpret_cast<std::uintptr_t>(&__heap_base); }

std::uintptr_t arena_end = 0;

std::uintptr_t aligned(std::uintptr_t size) {
  return (size + kAlignment - 1) / kAlignment * kAlignment;
}

/// Returns `size` bytes, and traps if there are no more.
std::uintptr_t take(std::size_t size) {
  const std::uintptr_t begin = arena_end;
  arena_end = begin + aligned(size);
  const std::size_t have = __builtin_wasm_memory_size(0) * kPage;
  if (arena_end > have) {
    const std::size_t pages = (arena_end - have + kPage - 1) / kPage;
    if (__builtin_wasm_memory_grow(0, pages) == SIZE_MAX) __builtin_trap();
  }
  return begin;
}

/// Frees what earlier calls have allocated.
void begin_call() { arena_end = aligned(arena_begin()); }

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return reinterpret_cast<void*>(take(size)); }
void free(void*) {}
/// Copies `size` bytes from `old`, which may be more than it had: what lies behind is in the arena,
/// too, because the copy lies behind all of it.
void* realloc(void* old, std::size_t size) {
  void* moved = malloc(size);
  if (old != nullptr) std::memmove(moved, old, size);
  return moved;
}

#define PLUMB_EXPORT(name) __attribute__((export_name(#name)))

PLUMB_EXPORT(orient2d)
int exact_orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
  begin_call();
  return static_cast<int>(plumb::rung::orient2d_beyond_filter({ax, ay}, {bx, by}, {cx, cy}));
}

PLUMB_EXPORT(incircle)
int exact_incircle(double ax, double ay, double bx, double by, double cx, double cy, double dx,
                   double dy) {
  begin_call();
  return static_cast<int>(
      plumb::rung::incircle_beyond_filter({ax, ay}, {bx, by}, {cx, cy}, {dx, dy}));
}

PLUMB_EXPORT(orient3d)
int exact_orient3d(double ax, double ay, double az, double bx, double by, double bz, double cx,
                   double cy, double cz, double dx, double dy, double dz) {
  begin_call();
  return static_cast<int>(
      plumb::rung::orient3d_beyond_filter({ax, ay, az}, {bx, by, bz}, {cx, cy, cz}, {dx, dy, dz}));
}

PLUMB_EXPORT(insphere)
int exact_insphere(double ax, double ay, double az, double bx, double by, double bz, double cx,
                   double cy, double cz, double dx, double dy, double dz, double ex, double ey,
                   double ez) {
  begin_call();
  return static_cast<int>(plumb::rung::insphere_beyond_filter(
      {ax, ay, az}, {bx, by, bz}, {cx, cy, cz}, {dx, dy, dz}, {ex, ey, ez}));
}

}  // extern "C"

// The predicates reach none of these: shifts are never negative, and grids are small.
namespace plumb::detail {
void throw_negative_shift() { __builtin_trap(); }
void throw_out_of_range() { __builtin_trap(); }
}  // namespace plumb::detail
