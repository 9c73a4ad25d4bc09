// 32-bit ids of distinct types, so that ids of different kinds cannot be confused.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#pragma GCC visibility push(default)
namespace plumb {

/// The index of nothing, in arrays of 32-bit indices.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A 32-bit index into arrays of one kind. `Tag` is any type, possibly incomplete, that names the
/// kind. A default-constructed id is invalid. Ids are ordered by value; the invalid id is the
/// greatest.
template <class Tag>
class StrongId {
 public:
  using Value = std::uint32_t;  ///< The integer type of the index.
  /// The value of an invalid id.
  static constexpr Value kInvalid = std::numeric_limits<Value>::max();

  constexpr StrongId() = default;
  /// Makes the id with this index. Requires value <= kInvalid; larger values are truncated.
  constexpr explicit StrongId(std::size_t value) : value_(static_cast<Value>(value)) {}

  constexpr Value value() const { return value_; }  ///< Returns the index, or kInvalid.
  constexpr bool is_valid() const { return value_ != kInvalid; }  ///< Whether the id is valid.
  friend constexpr auto operator<=>(StrongId, StrongId) = default;

 private:
  Value value_ = kInvalid;
};

}  // namespace plumb
#pragma GCC visibility pop

/// Hashes an id to its value.
template <class Tag>
struct std::hash<plumb::StrongId<Tag>> {
  std::size_t operator()(plumb::StrongId<Tag> id) const noexcept { return id.value(); }
};
