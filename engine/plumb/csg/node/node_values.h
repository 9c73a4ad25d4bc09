// Values of single nodes of a tree, from the values of their children. Parameters that give
// nothing, such as a negative radius, give an empty set and a remark, as they do in OpenSCAD.
#pragma once

#include <string>

#include "plumb/base/context.h"
#include "plumb/csg/csg_tree.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// Returns a cube, sphere, cylinder, polyhedron or solid of a file.
Nef3 primitive_solid(const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
                     Context& context);
/// Returns the convex hull of the corners of a polyhedron node, whose faces need not be closed. It
/// may be flat.
Nef3 hull_of_polyhedron(const CsgTree& tree, const CsgTree::Node& node, Context& context);
/// Returns a square, circle, polygon or shape of a file.
Nef2 primitive_shape(const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
                     Context& context);

/// Returns the map of a multmatrix node.
AffineMap3 map_of(const CsgTree& tree, const CsgTree::Node& node);
/// Returns the image of a set under a map; nothing if the matrix is singular. In the plane, the map
/// acts on x and y.
Nef3 mapped(const Nef3& set, const AffineMap3& map, std::string& remark, Context& context);
Nef2 mapped(const Nef2& set, const AffineMap3& map, std::string& remark, Context& context);

/// Returns the value of a resize node.
Nef3 resized(const Nef3& set, const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
             Context& context);
Nef2 resized(const Nef2& set, const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
             Context& context);

/// Returns the value of an offset node.
Nef2 offset_of(const Nef2& set, const CsgTree& tree, const CsgTree::Node& node, Context& context);
/// Returns the value of a projection node.
Nef2 projection_of(const Nef3& set, const CsgTree& tree, const CsgTree::Node& node,
                   Context& context);
/// Returns the value of a node that extrudes a set of the plane along or around the z-axis.
Nef3 extrusion_of(const Nef2& set, const CsgTree& tree, const CsgTree::Node& node,
                  std::string& remark, Context& context);

}  // namespace plumb
