// Colours of a tree: which node each part of the result has its colour from, and how a set gets a
// colour.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/csg/csg_tree.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// Red, green, blue and opacity, from 0 to 1.
using CsgColor = std::array<double, 4>;

/// The colours of all nodes of a tree.
struct CsgPaint {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};  ///< There is no colour.
  /// For each node, the node of the kind Color that colours it, or kNone. If no node of the tree
  /// has a colour, the array is empty.
  std::vector<std::uint32_t> of_node;
  /// The nodes that make faces of their own from children with colours, and have no colour
  /// themselves. Their numbers ascend.
  std::vector<std::uint32_t> losing;
};

/// Returns the colour of a node of the kind Color, or nothing if it states none. Numbers above 1
/// count as 1. As in OpenSCAD, a negative number means that there is no colour.
std::optional<CsgColor> color_of(const CsgTree& tree, const CsgTree::Node& node);

/// Whether the faces of the children of a node of this kind are no faces of its value.
bool makes_new_faces(CsgKind kind);

/// Finds the colour of each node. The outermost colour wins. The children of a node that makes new
/// faces have no colour, because their faces do not reach the result. O(n) for n nodes.
CsgPaint paint_of(const CsgTree& tree);

/// Returns the set with a colour on its whole boundary. If the set has sources, which are meshes of
/// files, the colour replaces their materials and colours, and their other attributes stay.
/// Otherwise the exact boundary of the set becomes its source; `name` is the name of this source.
Nef3 painted(const Nef3& set, const CsgColor& color, const std::string& name, Context& context);

}  // namespace plumb
