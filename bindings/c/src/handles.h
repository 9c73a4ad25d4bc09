// What all sources of the C interface share: handles, the one conversion of exceptions to statuses,
// and the checks of arguments.
//
// A handle is a struct of one C++ value. guarded() runs the body of a function; every function that
// can fail consists of one call of it, of make(), or of make_with_notes(). Bodies throw
// plumb::Error for bad arguments, as the engine does, and report() in context.cpp turns whatever is
// thrown into a status and an error object.
#pragma once

#include <plumb.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/base/arithmetic_watch.h"
#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/convex/convexity.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"
#include "plumb/space/nef3.h"
#include "plumb/space/repair_mesh.h"
#include "plumb/sphere/nef_sphere.h"

// --- handles ------------------------------------------------------------------------------------

struct plumb_error {
  plumb_status status;
  std::string message, text, file;
  std::size_t line, column;
};

struct plumb_context {
  plumb::Limits limits;
  unsigned threads = 1;
  plumb_progress progress = nullptr;
  void* user_data = nullptr;
  std::stop_source stop;
};

struct plumb_bytes {
  std::string bytes;
};

struct plumb_notes {
  std::vector<std::string> texts;
  std::size_t warnings = 0;  // The last texts are warnings.
};

struct plumb_indices {
  std::vector<std::uint32_t> values;
};

struct plumb_numbers {
  std::vector<plumb::Rational> values;
  std::vector<std::string> texts;
};

struct plumb_mesh {
  plumb::PolygonMesh mesh;
  std::vector<std::uint32_t> facets = {};  // Empty unless the mesh was made from a solid.
  plumb::MeshAttributes attributes = {};   // Always complete, and with indices in range.
  // The source of each face, its face, and whether it is flipped. Empty unless the mesh was made
  // with the attributes of a solid.
  std::array<std::vector<std::uint32_t>, 3> sources = {};
};

struct plumb_solid {
  plumb::Nef3 set;
};
struct plumb_solid_list {
  std::vector<plumb_solid> sets;
};

struct plumb_plane_set {
  plumb::Nef2 set;
};
struct plumb_plane_set_list {
  std::vector<plumb_plane_set> sets;
};

struct plumb_sphere_set {
  plumb::NefSphere set;
};

namespace plumb::c {

// --- failures -----------------------------------------------------------------------------------

/// Turns the exception that is being handled into a status and, if `error` is not null, an error
/// object.
plumb_status report(plumb_error** error) noexcept;

/// Runs the body of a function.
template <class Body>
plumb_status guarded(plumb_error** error, const Body& body) noexcept {
  if (error != nullptr) *error = nullptr;
  try {
    body();
    return PLUMB_OK;
  } catch (...) {
    return report(error);
  }
}

[[noreturn]] void fail_null(const char* name);
[[noreturn]] void fail_argument(const std::string& message);

/// Returns what an argument points to. Throws Error{BadArgument} for a null pointer.
template <class T>
T& need(T* argument, const char* name) {
  if (argument == nullptr) fail_null(name);
  return *argument;
}

/// Makes a handle of its value, or of another handle.
template <class Handle, class Value>
Handle* new_handle(Value&& value) {
  if constexpr (std::is_same_v<std::remove_cvref_t<Value>, Handle>) {
    return new Handle(std::forward<Value>(value));
  } else {
    return new Handle{std::forward<Value>(value)};
  }
}

/// Makes a handle of what the body returns.
template <class Handle, class Body>
plumb_status make(Handle** out, plumb_error** error, const Body& body) noexcept {
  if (out != nullptr) *out = nullptr;
  return guarded(error, [&] {
    need(out, "out");
    *out = new_handle<Handle>(body());
  });
}

/// Makes a handle of what the body returns; the body also fills a list of notes.
template <class Handle, class Body>
plumb_status make_with_notes(Handle** out, plumb_notes** notes, plumb_error** error,
                             const Body& body) noexcept {
  if (out != nullptr) *out = nullptr;
  if (notes != nullptr) *notes = nullptr;
  return guarded(error, [&] {
    need(out, "out");
    auto told = std::make_unique<plumb_notes>();
    *out = new_handle<Handle>(body(*told));
    if (notes != nullptr) *notes = told.release();
  });
}

// --- contexts -----------------------------------------------------------------------------------

/// The Context of one call. Its time limit counts from here.
class Call {
 public:
  explicit Call(const plumb_context* settings);
  operator Context&() { return own_ ? *own_ : unlimited_context(); }

 private:
  std::optional<Context> own_;
  std::optional<ArithmeticWatch> watch_;
};

// --- arrays -------------------------------------------------------------------------------------

/// Returns the array of `count` records of `width` elements. Throws Error{BadArgument} for a null
/// pointer to elements, for more records than ids can number, and for more bytes than an array can
/// have, which is less where addresses have 32 bits.
template <class T>
std::span<const T> array(const T* data, std::size_t count, const char* name,
                         std::size_t width = 1) {
  if (count > 0 && data == nullptr) fail_null(name);
  if (count > 0xffffffffU) fail_argument(std::string(name) + " has 2^32 entries or more");
  constexpr auto kMostBytes = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max());
  if (count > kMostBytes / sizeof(T) / width) {
    fail_argument(std::string(name) + " has more entries than an array can have");
  }
  return {data, count * width};
}

/// Returns the numbers of `count` records. Throws Error{NotFinite} with the index of a number that
/// is not finite, even if nothing would read it.
std::span<const double> finite(const double* data, std::size_t count, const char* name,
                               std::size_t width);

/// Returns the offsets of `count` lists in a flat array. No lists have the offset 0.
std::span<const std::uint32_t> offsets(const std::uint32_t* begin, std::size_t count,
                                       const char* name);

/// Returns the coordinates of what has `width` numbers each.
std::span<const Rational> records(const plumb_numbers* numbers, const char* name,
                                  std::size_t width);
/// Does the same for exactly `count` records.
std::span<const Rational> exactly(const plumb_numbers* numbers, const char* name, std::size_t width,
                                  std::size_t count = 1);
std::vector<RationalPoint3> points3(const plumb_numbers* numbers, const char* name);
std::vector<RationalPoint2> points2(const plumb_numbers* numbers, const char* name);

plumb_numbers numbers_of(std::vector<Rational> values);
plumb_numbers numbers_of(const RationalPoint3& point);
plumb_numbers numbers_of(const RationalPoint2& point);

// --- texts --------------------------------------------------------------------------------------

std::string text(const char* argument, const char* name);
inline std::string text_or_empty(const char* argument) { return argument ? argument : ""; }
inline std::string_view bytes_of(const char* data, std::size_t size) {
  if (size > 0 && data == nullptr) fail_null("bytes");
  return {data, size};
}
[[noreturn]] void fail_format(const std::string& format, const char* known);

void add_notes(plumb_notes& notes, const std::vector<std::string>& texts);
/// Adds warnings, which come after all notes.
void add_warnings(plumb_notes& notes, const std::vector<std::string>& texts);

/// Returns what a function writes to a stream.
template <class Write>
plumb_bytes written(const Write& write);
/// Writes a file, which is complete or absent.
template <class Write>
void write_file(const std::string& path, const Write& write);

// --- structs ------------------------------------------------------------------------------------

std::size_t checked_size(std::size_t stated, std::size_t known);

/// Returns the options that a caller gave; members that it does not know have their defaults.
template <class Options>
Options options_of(const Options* given, Options defaults) {
  static_assert(std::is_trivially_copyable_v<Options>);
  if (given != nullptr) {
    std::memcpy(&defaults, given, checked_size(given->struct_size, sizeof(Options)));
  }
  return defaults;
}

/// Fills the members that a caller knows. Throws before it writes.
template <class Facts>
void fill(Facts* out, Facts value, const char* name) {
  static_assert(std::is_trivially_copyable_v<Facts>);
  const std::size_t size = checked_size(need(out, name).struct_size, sizeof(Facts));
  value.struct_size = out->struct_size;
  std::memcpy(out, &value, size);
}

ReadOptions read_options(const plumb_read_options* options, const std::string& name);
/// Returns the name of a text in memory, which is a path without a folder for the readers.
std::string name_of(const plumb_read_options* options);
bool reads_exact_decimals(const plumb_read_options* options);
PlaneWriteOptions write_options(const plumb_write_options* options);
RepairOptions repair_options(const plumb_repair_options* options);

std::optional<WindingRule> rule_of(int rule);
inline Boundary boundary(bool is_closed) { return is_closed ? Boundary::Closed : Boundary::Open; }

// --- results ------------------------------------------------------------------------------------

/// Hands out the evidence of a test of convexity.
void deliver(const ConvexityEvidence& found, bool* is_convex, std::uint64_t* reflex_edges,
             plumb_indices** failing);

}  // namespace plumb::c
