// What a Nef2 shares between its copies. Internal.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_locator.h"
#include "plumb/plane/plane_trapezoids.h"

namespace plumb {

struct Nef2::State {
  explicit State(PlaneComplex c) : complex(std::move(c)) {}

  PlaneComplex complex;
  mutable std::once_flag locator_made;
  mutable std::unique_ptr<PlaneLocator> locator;
  mutable std::once_flag trapezoids_made;
  mutable std::unique_ptr<PlaneTrapezoids> trapezoids;
};

}  // namespace plumb
