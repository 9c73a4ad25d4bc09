// 32-bit ids that cannot be mixed up.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#pragma GCC visibility push(default)
namespace plumb {

/// A 32-bit index into one kind of array. `Tag` is any (incomplete) type naming that kind.
/// A default-constructed id is invalid; ids order by value.
template <class Tag>
class StrongId {
 public:
  using Value = std::uint32_t;  ///< what an id is made of
  /// Of an id that names nothing.
  static constexpr Value kInvalid = std::numeric_limits<Value>::max();

  constexpr StrongId() = default;
  /// The id of that number.
  constexpr explicit StrongId(std::size_t value) : value_(static_cast<Value>(value)) {}

  constexpr Value value() const { return value_; }  ///< The number; kInvalid if it names nothing.
  constexpr bool is_valid() const { return value_ != kInvalid; }  ///< Does it name something?
  friend constexpr auto operator<=>(StrongId, StrongId) = default;

 private:
  Value value_ = kInvalid;
};

}  // namespace plumb
#pragma GCC visibility pop

template <class Tag>
struct std::hash<plumb::StrongId<Tag>> {
  std::size_t operator()(plumb::StrongId<Tag> id) const noexcept { return id.value(); }
};
