// What a Nef3 shares between its copies, and unions of sets that are used up. Internal.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_locator.h"

namespace plumb {

/// A complex, with known facts about it. The locator is made at most once, by any thread; nothing
/// else changes while copies share the state.
struct Nef3::State {
  /// Takes the complex, and boxes around its parts if they are known.
  explicit State(SpaceComplex c, std::vector<Box3> known_parts = {})
      : complex(std::move(c)), parts(std::move(known_parts)) {}
  /// Returns boxes around the boundary: its parts, or one box if they are not known.
  std::vector<Box3> boxes() const {
    return parts.empty() ? std::vector<Box3>{box_of(complex)} : parts;
  }

  SpaceComplex complex;     ///< Minimal.
  std::vector<Box3> parts;  ///< The boxes of a BoxedComplex; empty if not known.
  mutable std::once_flag locator_made;
  mutable std::unique_ptr<SpaceLocator> locator;
};

/// Returns the union of sets, which are used up: their memory is freed as they are united, not all
/// of it at the end. Otherwise as union_of().
Nef3 united(std::vector<Nef3> sets, Context& context);

}  // namespace plumb
