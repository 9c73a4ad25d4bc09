// 32-bit ids, and vectors that are indexed by ids. Each kind of id has its own type, so that ids of
// different kinds cannot be confused.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// The value that means "no index" in arrays of 32-bit indices.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A 32-bit index of an object of one kind, such as a vertex. The type `Tag` names the kind. `Tag`
/// may be any type, even an incomplete type. A default-constructed id is invalid. Ids are ordered
/// by value, and the invalid id is the greatest id.
template <class Tag>
class StrongId {
 public:
  using Value = std::uint32_t;  ///< The integer type of the index.
  /// The value of an invalid id.
  static constexpr Value kInvalid = std::numeric_limits<Value>::max();

  constexpr StrongId() = default;
  /// Constructs the id with the index `value`. Requires value <= kInvalid. A larger value is
  /// truncated to 32 bits.
  constexpr explicit StrongId(std::size_t value) : value_(static_cast<Value>(value)) {}

  constexpr Value value() const { return value_; }  ///< Returns the index, or kInvalid.
  constexpr bool is_valid() const { return value_ != kInvalid; }  ///< Whether the id is valid.
  friend constexpr auto operator<=>(StrongId, StrongId) = default;

 private:
  Value value_ = kInvalid;
};

/// A std::vector that is indexed by ids: element `id` belongs to the object with the index
/// id.value(). Besides ids, integers can be used as indices. Code that indexes the vector with an
/// id of another kind does not compile. The class adds no data members, so it can be constructed by
/// moving a std::vector, and can be moved to a std::vector.
template <class Id, class T>
class IdVector : public std::vector<T> {
 public:
  using std::vector<T>::vector;
  using std::vector<T>::operator[];
  using std::vector<T>::operator=;
  IdVector() = default;
  /// Takes the elements of a vector.
  IdVector(std::vector<T> elements) : std::vector<T>(std::move(elements)) {}

  /// Returns the element of `id`. Requires id.value() < size().
  typename std::vector<T>::reference operator[](Id id) { return (*this)[id.value()]; }
  typename std::vector<T>::const_reference operator[](Id id) const { return (*this)[id.value()]; }
};

}  // namespace plumb
#pragma GCC visibility pop

/// Hash function of ids: the hash of an id is its value.
template <class Tag>
struct std::hash<plumb::StrongId<Tag>> {
  std::size_t operator()(plumb::StrongId<Tag> id) const noexcept { return id.value(); }
};
