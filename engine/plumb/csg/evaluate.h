// Evaluates trees of constructive solid geometry (csg_tree.h): evaluate() returns the exact set
// that a tree describes.
//
// Main flow:
//  1. dimensions   finds for each node the kind of its value: a set of the plane, a set of space,
//                  or "nothing". A node without geometry has the value "nothing" (see below)
//  2. equal nodes  numbers the nodes so that equal subtrees have equal numbers. Of several equal
//                  subtrees, only the first one is evaluated
//  3. regions      rewrites Booleans. Each maximal connected part of the tree that consists of
//                  Booleans only is rewritten as a whole (base/set_tree.h). The rewritten part is
//                  then evaluated with unions and differences of many sets
//  4. nodes        computes all other nodes from their children. These nodes are primitives
//                  (primitives.h), maps, hulls, extrusions, slices and Minkowski sums
//
// Meaning. The value of each node is a closed and regular set: it is the closure of its interior.
// So a difference is closed, and an intersection of solids that only touch is empty. The
// coordinates of primitives are doubles. Maps, Booleans, hulls, sums, projections and slices are
// computed exactly. Twisted, scaled and rotational extrusions have corners that are rounded to
// doubles.
//
// OpenSCAD has the following rules, too. A node that is neither a Boolean nor a hull nor a
// Minkowski sum operates on the union of its children. A node without geometry below it has the
// value "nothing". The first child whose value is not "nothing" decides whether a node is a set of
// the plane or of space. Children of the other dimension are left out, and a note reports this. The
// value of a difference is "nothing" if the value of its first child is "nothing". The value of an
// intersection is "nothing" if the value of any child is "nothing". Hulls and sums ignore children
// with the value "nothing". The value of a map with a singular matrix is "nothing", and a note
// reports this.
//
// Colours. The colours of a set of space are stored in its sources (source_mesh.h), as materials of
// faces. The faces come from primitives, extrusions, hulls and Minkowski sums. If colours are
// nested, the outermost colour is used. This colour also replaces the colours of imported files. A
// hull, a sum or an extrusion does not keep the colours of its children, and a note reports this.
// Sets of the plane have no colours. Colours never change the set.
//
// Cost: the sum of the costs of all operations. Errors: Error{BadArgument}, Error{NotFinite},
// Error{ResourceLimit}, OpenMesh and the other errors of the operations. If the tree states lines
// and columns, an error names the position of the node. No function recurses over the tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/csg/csg_tree.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The kind of value that a node has.
enum class CsgDimension : std::uint8_t {
  Nothing,  ///< The node has no geometry below it.
  Plane,    ///< A set of the plane.
  Space,    ///< A set of space.
};

/// The way in which evaluate() found the value of a node.
enum class CsgWork : std::uint8_t {
  LeftOut,   ///< The value has no influence on the result.
  Computed,  ///< The node was evaluated.
  /// The node was computed together with the node above it, as a part of a Boolean of many sets or
  /// of a chain of maps.
  Rewritten,
  Shared,  ///< The value was taken from an equal node with a lower index.
};

/// A report about one node of an evaluated tree.
struct CsgNodeReport {
  /// Whether the node's value is a set of the plane, a set of space, or nothing.
  CsgDimension dimension = CsgDimension::Nothing;
  CsgWork work = CsgWork::LeftOut;  ///< The way in which the node's value was found.
  /// If `work` is Shared, the index of the node whose value was taken. Otherwise the index of this
  /// node.
  std::uint32_t same_as = 0;
  /// If `work` is Computed: the number of facets of a set of space, or of edges of a set of the
  /// plane.
  std::size_t cells = 0;
  /// If `work` is Computed: the time in seconds, without the time for the nodes below this node.
  double seconds = 0;
};

/// The value of a tree.
struct CsgResult {
  /// Whether the value is a set of the plane, a set of space, or nothing.
  CsgDimension dimension = CsgDimension::Nothing;
  Nef2 shape;                        ///< The value, if it is a set of the plane; otherwise empty.
  Nef3 solid;                        ///< The value, if it is a set of space; otherwise empty.
  std::vector<CsgNodeReport> nodes;  ///< A report for each node.
  /// Notes for a human reader about contents of the tree that were left out. Each note is one
  /// sentence. It begins with the line and the column of the node, if the tree states them.
  std::vector<std::string> notes;
};

/// Options of an evaluation.
struct CsgEvaluateOptions {
  /// Whether the value has the colours of the tree. This costs time only if the tree has colours.
  bool colors = true;
};

/// Returns the value of a tree. The phases that are reported to `context` name the nodes, as in
/// "hull at line 12".
[[nodiscard]] CsgResult evaluate(const CsgTree& tree, Context& context = unlimited_context());
/// Does the same as the function above, with options.
[[nodiscard]] CsgResult evaluate(const CsgTree& tree, const CsgEvaluateOptions& options,
                                 Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
