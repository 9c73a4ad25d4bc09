// Models of OpenSCAD from bytes: any sequence of bytes is a model, and one with fewer records is a
// simpler one. A stack machine of records of eight bytes (set_program.h): each pushes a leaf, or
// operates on the models pushed. In the end all models left are combined.
//
// Leaves are boxes, halves of space (the part of a big box near the origin), and hulls of two
// boxes. Maps are affine with halves as entries, at most two above each other, so all corners are
// multiples of 1/8.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "generate/set_program.h"
#include "oracle/model_cells.h"
#include "plumb/space/nef3.h"

namespace plumb::testing {

/// The corners of models are integers divided by this.
inline constexpr std::int64_t kModelUnit = 8;

/// A node of a model, with all nodes below it.
struct Model {
  enum class Kind : std::uint8_t { Leaf, Union, Difference, Intersection, Map };
  Kind kind = Kind::Leaf;
  std::string text;                   ///< Of a leaf: its nodes. Of a map: the node above the child.
  AffineMap3 map;                     ///< Of a map.
  std::vector<IntegerPoint> corners;  ///< Of a leaf: its corners under all maps above it.
  std::vector<Model> children;
  int maps = 0;  ///< How many maps are above each other.
};

/// Returns the model of a program, and nothing (no children of a union) if no record pushes one.
/// Stops at a record that would take the model beyond `most_planes` planes.
Model model_of_program(std::span<const std::uint8_t> program, std::size_t most_planes);

/// Returns a model as a file of OpenSCAD.
std::string text_of_model(const Model& model);
/// Returns the same set in another order: children of unions and intersections, and what is
/// subtracted, are permuted.
Model shuffled(const Model& model, Dice& dice);

std::vector<std::uint8_t> random_model_program(Dice& dice, std::size_t records);

}  // namespace plumb::testing
