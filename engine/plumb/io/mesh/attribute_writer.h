// What the writers of attributes have in common: numbering of distinct values, splitting of
// vertices, and the numbers of colours.
//
// OFF and PLY list numbers per vertex. A vertex whose corners have different numbers is therefore
// written once for each of them, at the same point. OBJ lists the distinct numbers of a channel and
// numbers them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/io/text/text_output.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// Throws Error{BadArgument} unless each array of the attributes is empty or complete, and unless
/// each material and group of a face exists. O(n).
void require_complete(const MeshAttributes& attributes, const PolygonMesh& mesh);

/// Leaves out the materials that no face has. If several materials have the same name, colour and
/// texture, they become one material, the first of them. The order stays. Cost: O(n + m log m) for
/// n faces and m materials.
void keep_used_materials(MeshAttributes& attributes);

/// Returns the channel of this name if it has a width from `least` to `most`, otherwise nullptr.
const MeshChannel* channel_of(const MeshAttributes& attributes, std::string_view name,
                              std::uint32_t least, std::uint32_t most);

/// Numbers of corners from 0. Corners with the same number have equal values.
struct DistinctCorners {
  std::vector<std::uint32_t> of_corner;  ///< For each corner, its number.
  std::vector<std::uint32_t> corner;     ///< For each number, the first corner that has it.
};

/// Numbers the distinct values of a channel in the order of corners. Values are compared by their
/// bits. Expected cost: O(n) for n numbers.
DistinctCorners distinct_values(const MeshChannel& channel, std::size_t corners);

/// A mesh whose vertices have values.
struct SplitMesh {
  PolygonMesh mesh;
  /// For each vertex, a corner whose values it has, or MeshAttributes::kNone if no face uses it.
  std::vector<std::uint32_t> corner_of_vertex;
};

/// Returns the mesh with a copy of each vertex for each further combination of values that its
/// corners have in these channels. The vertices of the mesh keep their numbers; copies follow them.
/// Throws Error{ResourceLimit} if there would be 2^32 vertices. Expected cost: O(n) for n numbers.
SplitMesh split_vertices(const PolygonMesh& mesh, const std::vector<const MeshChannel*>& channels);

/// Whether all numbers are multiples of 1/255 from 0 to 1 up to rounding, so that bytes hold them.
bool are_bytes(std::span<const double> colors);
/// Returns the byte of such a number.
std::uint32_t byte_of(double part);

/// Returns the values of a channel at a corner.
inline std::span<const double> values_at(const MeshChannel& channel, std::uint32_t corner) {
  return std::span(channel.values)
      .subspan(std::size_t{corner} * channel.width, std::size_t{channel.width});
}

/// Returns a channel's values at the corner of a vertex. A vertex without a corner has zeros.
std::vector<double> values_of_vertex(const MeshChannel& channel, std::uint32_t corner);

/// Writes the numbers, each after a blank.
void write_numbers(TextOutput& out, std::span<const double> numbers);

}  // namespace plumb
