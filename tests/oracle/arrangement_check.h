// Is an arrangement what brute force says it is?
#pragma once

#include <cstdint>
#include <string>

#include "generate/curve_scenes.h"

namespace plumb::testing {

/// Arranges the scene, loaded by to_engine(scene, seed), and compares every vertex, edge, face and
/// origin. Empty: all the same; else the first difference in words.
std::string disagreement(const CurveScene& scene, std::uint64_t seed);

}  // namespace plumb::testing
