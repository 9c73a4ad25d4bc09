// Trees of constructive solid geometry (CSG). The nodes of a tree are primitives, affine maps,
// Booleans, hulls, Minkowski sums and extrusions. OpenSCAD writes such trees in its flattened files
// (.csg).
//
// The nodes of a tree are numbered in preorder: a node comes before its children, and the subtree
// of a node is a range of nodes. All data are in flat arrays. A node has parameters: some numbers
// (doubles) and some indices (integers). The numbers of all nodes are in one array, and the indices
// of all nodes are in another array. The comments of CsgKind state which parameters a node of each
// kind has.
//
// The value of a node is a set of the plane, a set of space, or nothing. The file evaluate.h
// defines the value of each kind of node.
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

/// The kinds of nodes. Each comment states the value of the node and its numbers. The word
/// "division" stands for three numbers $fn, $fa and $fs, which determine how circles are divided
/// into chords (CircleDivision in primitives.h).
enum class CsgKind : std::uint8_t {
  Root,   ///< The union of the children: the whole file.
  Group,  ///< The union of the children.
  Union,  ///< The union of the children.
  /// The union of the children, with a colour. The node has four numbers (red, green, blue and
  /// opacity) or no numbers. Negative numbers mean that there is no colour.
  Color,
  Render,        ///< The union of the children.
  Difference,    ///< The first child minus all other children.
  Intersection,  ///< The intersection of all children.
  Hull,          ///< The convex hull of all children together.
  Minkowski,     ///< The Minkowski sum of all children.
  /// The image of the union of the children. The node has twelve numbers, which are the three rows
  /// of the map.
  Multmatrix,
  /// The union of the children, scaled along the axes. The node has six numbers. The first three
  /// are the sizes of the result along the axes; 0 means that no size is given. The last three
  /// state the factor of each axis without a size: 1 stands for the greatest factor of the other
  /// axes, and 0 stands for the factor 1.
  Resize,
  /// The union of the children, grown by a distance. The node has five numbers: the distance; 0 for
  /// round joins, 1 for mitres, or 2 for square joins; the division.
  Offset,
  /// A set of the plane made from the union of the children. The node has one number: 0 for the
  /// projection of the union along the z-axis, any other value for the slice of the union at z = 0.
  Projection,
  /// The solid that the union of the children sweeps along the z-axis. The node has nine numbers:
  /// the height; 1 if the solid is centred at z = 0, else 0; the twist; the number of slices, or 0
  /// if it is not given; the scales of x and y at the top; the division. It may have two more
  /// numbers: the distances along x and y by which the top is shifted.
  LinearExtrude,
  /// The solid that the union of the children sweeps around the z-axis. The node has four numbers:
  /// the angle; the division. It may have a fifth number: the angle at which the turn begins,
  /// which otherwise is 180 degrees for a full turn and 0 for any other turn.
  RotateExtrude,
  /// A box. The node has four numbers: the three sizes; 1 if the box is centred at the origin,
  /// else 0.
  Cube,
  Sphere,  ///< A ball. The node has four numbers: the radius; the division.
  /// A cylinder or cone. The node has seven numbers: the height; the radii at the bottom and at the
  /// top; 1 if the cylinder is centred, else 0; the division.
  Cylinder,
  /// A solid bounded by listed faces. The numbers are the coordinates of the points. The indices
  /// are the number of faces, then the number of corners of each face, and then the corners of all
  /// faces. The corners of a face are in clockwise order, seen from outside.
  Polyhedron,
  /// A rectangle. The node has three numbers: the two sizes; 1 if the rectangle is centred at the
  /// origin, else 0.
  Square,
  Circle,  ///< A disk. The node has four numbers: the radius; the division.
  /// A set of the plane bounded by listed paths. The numbers are the coordinates of the points. The
  /// indices are the number of paths, then the number of corners of each path, and then the corners
  /// of all paths. A point belongs to the set if it lies inside an odd number of paths.
  Polygon,
  Solid,  ///< A set of space from a file. The node has one index into CsgTree::solids.
  Shape,  ///< A set of the plane from a file. The node has one index into CsgTree::shapes.
};

/// Returns the word by which a .csg file calls nodes of this kind, such as "linear_extrude". For
/// Solid and Shape, which are sets from files, the word is "import".
[[nodiscard]] std::string_view name_of(CsgKind kind);
/// Whether the value of a node of this kind is simply the union of the node's children.
[[nodiscard]] bool is_union(CsgKind kind);

/// A tree. Node 0 is the root, and its kind is Root.
struct CsgTree {
  /// A node.
  struct Node {
    CsgKind kind = CsgKind::Root;  ///< The kind of the node.
    /// The index of the node that follows the last node of this node's subtree.
    std::uint32_t end = 1;
    std::uint32_t first_number = 0;  ///< Index into `numbers`.
    std::uint32_t number_count = 0;  ///< The number of entries in `numbers`.
    std::uint32_t first_index = 0;   ///< Index into `indices`.
    std::uint32_t index_count = 0;   ///< The number of entries in `indices`.
    std::uint32_t line = 0;          ///< The line of the file, counted from 1; 0 if unknown.
    std::uint32_t column = 0;        ///< The column, counted from 1.
  };
  std::vector<Node> nodes = {Node()};  ///< All nodes, in preorder.
  std::vector<double> numbers;         ///< The numbers of all nodes.
  std::vector<std::uint32_t> indices;  ///< The indices of all nodes.
  std::vector<Nef3> solids;            ///< Sets of space that were read from files.
  std::vector<Nef2> shapes;            ///< Sets of the plane that were read from files.
  std::string file;                    ///< The name of the file in messages; may be empty.

  /// Returns the entries of `numbers` that belong to the node. CsgKind states their meaning.
  [[nodiscard]] std::span<const double> numbers_of(const Node& node) const {
    return std::span(numbers).subspan(node.first_number, node.number_count);
  }
  /// Returns the entries of `indices` that belong to the node. CsgKind states their meaning.
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
