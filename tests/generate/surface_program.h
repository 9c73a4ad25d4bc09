// Scenes on surfaces from bytes: any bytes are a scene, and neighbouring bytes are similar ones.
//
// Records of three bytes. The first is {kind, size, shuffle}. Flat scenes (kind % 8 < 7): {what, x,
// y} is a corner, or starts a polygon, or repeats something. Raw ones: triangles and points without
// any care, most of them refused.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace plumb::testing {

inline constexpr std::size_t kSurfaceRecord = 3;
inline constexpr std::size_t kMostSurfaceRecords = 40;

/// Divides the scene and compares: a flat one with engine/plane (oracle/surface_oracle.h), a raw
/// one that is accepted with audit(). Empty, or what is wrong.
std::string disagreement_on_surface(std::span<const std::uint8_t> program);

}  // namespace plumb::testing
