// The set that a tree of constructive solid geometry describes: evaluate(CsgTree), exactly.
//
// Main flow:
//  1. dimensions   finds which nodes are sets of the plane, sets of space, or nothing
//  2. equal nodes  numbers the nodes so that equal subtrees have equal numbers; each is evaluated
//                  once
//  3. regions      the nodes of a maximal part of the tree that consists of Booleans are rewritten
//                  together (base/set_tree.h), and evaluated with unions and differences of many
//                  sets
//  4. nodes        all other nodes are computed from their children: primitives (primitives.h),
//                  maps, hulls, extrusions, slices, sums
//
// Meaning. Sets are closed and regular: each is the closure of its interior. So a difference is
// closed, and an intersection of solids that only touch is empty. Coordinates of primitives are
// doubles; the maps above them are applied exactly, and the results of Booleans, hulls, sums,
// projections and slices are exact. Twisted, scaled and rotated extrusions have corners that are
// rounded to doubles.
//
// OpenSCAD's rules: the children of a node that is no Boolean are united. The first child that is
// not nothing decides whether a node is a set of the plane or of space; children of the other
// dimension are left out, with a note. A difference whose first child is nothing is nothing, and so
// is an intersection with nothing. Hulls and sums pass over nothing. A map with a singular matrix
// gives nothing, with a note.
//
// Colours. The colours of a set of space are stored in its sources (source_mesh.h), as materials of
// the faces that primitives, extrusions, hulls and sums make. The outermost colour wins, also over
// the colours of imported files. A hull, a sum or an extrusion does not keep the colours of its
// children, with a note. Sets of the plane have no colours. Colours never change the set.
//
// Cost: the sum of the operations. Errors: Error{BadArgument}, OpenMesh and other errors of the
// operations get the place of the node, if the tree has places; so do ResourceLimit and NotFinite.
// Nothing recurses over the tree.
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

/// What a node is.
enum class CsgDimension : std::uint8_t {
  Nothing,  ///< The node has no geometry below it.
  Plane,    ///< A set of the plane.
  Space,    ///< A set of space.
};

/// How the value of a node was found.
enum class CsgWork : std::uint8_t {
  LeftOut,    ///< The value has no influence on the result.
  Computed,   ///< The node was evaluated.
  Rewritten,  ///< The node is computed with its user: a Boolean of many sets, or a chain of maps.
  Shared,     ///< The value is that of an equal node before it.
};

/// What is known of a node after an evaluation.
struct CsgNodeReport {
  CsgDimension dimension = CsgDimension::Nothing;  ///< What the node is.
  CsgWork work = CsgWork::LeftOut;                 ///< How its value was found.
  /// If `work` is Shared, the node whose value was taken. Otherwise the node itself.
  std::uint32_t same_as = 0;
  std::size_t cells =
      0;               ///< If `work` is Computed: the number of facets, or of edges in the plane.
  double seconds = 0;  ///< If `work` is Computed: the time, without that of the nodes below it.
};

/// The value of a tree.
struct CsgResult {
  CsgDimension dimension = CsgDimension::Nothing;  ///< Which of the sets below is the value.
  Nef2 shape;                        ///< The value, if it is a set of the plane; otherwise empty.
  Nef3 solid;                        ///< The value, if it is a set of space; otherwise empty.
  std::vector<CsgNodeReport> nodes;  ///< A report for each node.
  /// Notes for a human: what was left out. Each is one sentence, with the line and the column of
  /// the node if the tree has places.
  std::vector<std::string> notes;
};

/// Options of an evaluation.
struct CsgEvaluateOptions {
  /// Whether the value has the colours of the tree. A tree without colours costs the same either
  /// way.
  bool colors = true;
};

/// Returns the value of a tree. The progress that is reported names the nodes: "hull at line 12".
[[nodiscard]] CsgResult evaluate(const CsgTree& tree, Context& context = unlimited_context());
/// Returns the value of a tree as the function above does, with options.
[[nodiscard]] CsgResult evaluate(const CsgTree& tree, const CsgEvaluateOptions& options,
                                 Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
