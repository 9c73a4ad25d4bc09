// Trees of constructive solid geometry: primitives, maps, Booleans, hulls, sums and extrusions, as
// OpenSCAD writes them in its flattened files (.csg).
//
// The nodes of a tree are numbered in preorder: a node comes before its children, and the subtree
// of a node is a range of nodes. All data are in flat arrays. The numbers and the indices of a node
// are ranges of two common arrays; CsgKind says what they mean.
//
// A node is a set of the plane, a set of space, or nothing. Groups, unions, colours and so on are
// the unions of their children. evaluate.h says what a tree means.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The kinds of nodes, and their numbers. A division of circles is three numbers: $fn, $fa and $fs.
enum class CsgKind : std::uint8_t {
  Root,   ///< The union of the children: the whole file.
  Group,  ///< The union of the children.
  Union,  ///< The union of the children.
  /// The union of the children. Four numbers: red, green, blue, opacity; or none. A negative number
  /// means that there is no colour.
  Color,
  Render,        ///< The union of the children.
  Difference,    ///< The first child without all others.
  Intersection,  ///< What lies in all children.
  Hull,          ///< The convex hull of all children together.
  Minkowski,     ///< The Minkowski sum of all children.
  Multmatrix,    ///< The image of the union of the children. Twelve numbers: three rows of a map.
  /// The union of the children, scaled along the axes. Six numbers: the size along each axis, or 0;
  /// then for each axis whether its factor is automatic.
  Resize,
  /// The union of the children grown by a distance. Five numbers: distance; 0 for round joins, 1
  /// for mitres, 2 for square joins; division of circles.
  Offset,
  /// The shadow of the children, or, if its one number is not 0, their slice at z = 0.
  Projection,
  /// Nine numbers: height; whether it is centred; twist; slices, or 0; scale of x and y; division.
  LinearExtrude,
  RotateExtrude,  ///< Four numbers: angle; division.
  Cube,           ///< Four numbers: sizes; whether it is centred.
  Sphere,         ///< Four numbers: radius; division.
  Cylinder,       ///< Seven numbers: height; radius at the bottom and the top; centred; division.
  /// The numbers are the coordinates of the points. The indices are the number of faces, the number
  /// of corners of each face, and the corners of all faces, clockwise seen from outside.
  Polyhedron,
  Square,  ///< Three numbers: sizes; whether it is centred.
  Circle,  ///< Four numbers: radius; division.
  /// The numbers are the coordinates of the points. The indices are as in a polyhedron, with paths
  /// instead of faces. Points inside an odd number of paths belong to the set.
  Polygon,
  Solid,  ///< A set of space from a file. One index: into CsgTree::solids.
  Shape,  ///< A set of the plane from a file. One index: into CsgTree::shapes.
};

/// Returns the word for a kind, as in a file. Sets from files are called "import".
[[nodiscard]] std::string_view name_of(CsgKind kind);
/// Whether nodes of a kind are the union of their children and nothing else.
[[nodiscard]] bool is_union(CsgKind kind);

/// A tree. Node 0 is the root, and its kind is Root.
struct CsgTree {
  /// A node.
  struct Node {
    CsgKind kind = CsgKind::Root;    ///< What the node is.
    std::uint32_t end = 1;           ///< The node after the last node of the subtree.
    std::uint32_t first_number = 0;  ///< Index into `numbers`.
    std::uint32_t number_count = 0;  ///< How many numbers the node has.
    std::uint32_t first_index = 0;   ///< Index into `indices`.
    std::uint32_t index_count = 0;   ///< How many indices the node has.
    std::uint32_t line = 0;          ///< The line of the file, counted from 1; 0 if unknown.
    std::uint32_t column = 0;        ///< The column, counted from 1.
  };
  std::vector<Node> nodes = {Node()};  ///< All nodes, in preorder.
  std::vector<double> numbers;         ///< The numbers of all nodes.
  std::vector<std::uint32_t> indices;  ///< The indices of all nodes.
  std::vector<Nef3> solids;            ///< Sets of space that were read from files.
  std::vector<Nef2> shapes;            ///< Sets of the plane that were read from files.
  std::string file;                    ///< The name of the file in messages; may be empty.

  /// Returns the numbers of a node.
  [[nodiscard]] std::span<const double> numbers_of(const Node& node) const {
    return std::span(numbers).subspan(node.first_number, node.number_count);
  }
  /// Returns the indices of a node.
  [[nodiscard]] std::span<const std::uint32_t> indices_of(const Node& node) const {
    return std::span(indices).subspan(node.first_index, node.index_count);
  }
  /// Calls visit(child) for each child of a node, in order.
  template <class Visit>
  void for_each_child(std::uint32_t node, Visit visit) const {
    for (std::uint32_t c = node + 1; c < nodes[node].end; c = nodes[c].end) visit(c);
  }
};

}  // namespace plumb
#pragma GCC visibility pop
