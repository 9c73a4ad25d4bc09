// What a Nef3 shares between its copies. Internal.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "plumb/space/nef3.h"
#include "plumb/space/space_locator.h"

namespace plumb {

struct Nef3::State {
  explicit State(SpaceComplex c) : complex(std::move(c)) {}

  SpaceComplex complex;
  mutable std::once_flag locator_made;
  mutable std::unique_ptr<SpaceLocator> locator;
};

}  // namespace plumb
