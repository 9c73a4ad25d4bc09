// What a Nef3 shares between its copies. Internal.
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

struct Nef3::State {
  explicit State(SpaceComplex c, std::vector<Box3> known_parts = {})
      : complex(std::move(c)), parts(std::move(known_parts)) {}
  /// Around the boundary; its box where they are not known.
  std::vector<Box3> boxes() const {
    return parts.empty() ? std::vector<Box3>{box_of(complex)} : parts;
  }

  SpaceComplex complex;
  std::vector<Box3> parts;  ///< BoxedComplex; empty: not known
  mutable std::once_flag locator_made;
  mutable std::unique_ptr<SpaceLocator> locator;
};

// Unions of sets that nobody else needs. Internal.

/// union_of() that uses up its operands: their memory goes as they are united, not all of it at the
/// end.
Nef3 united(std::vector<Nef3> sets, Context& context);

}  // namespace plumb
