// Exact Voronoi diagrams of points of the plane. The points are called sites. The cell of a site
// consists of all points of the plane that are at least as near to this site as to every other
// site.
//
// Main flow of voronoi_cells():
//  1. delaunay   (triangulation.h) finds the neighbours of each site
//  2. centres    computes the exact centre of the circle of each triangle. The centres of the
//                triangles around a site inside the convex hull are the corners of its cell
//  3. clip       intersects the cells with a box. The cell of a site on the convex hull is made by
//                another method. The box is cut by the bisectors between the site and its
//                neighbours. The cell is the part of the box that remains on the side of the site
//
// The corners of cells are exact rational points. So neighbouring cells have exactly the same
// corners and the same common border.
//
// Cost: the cost of delaunay(), plus the following costs for each site, where d is the number of
// its neighbours. A site inside the convex hull takes O(d) exact steps, and a site on the convex
// hull takes O(d^2) exact steps.
#pragma once

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational_point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the parts of the Voronoi cells that lie in a box, as a layer. `low` and `high` are two
/// opposite corners of the box. Feature i is the cell of site i, which is a convex polygon. The
/// feature has no polygon if the cell does not meet the interior of the box, or if the site equals
/// an earlier site. Features have no ids and no properties. repair_layer() rounds such a layer to
/// doubles. Throws Error{BadArgument} if the area of the box is not positive. Also throws the
/// errors of the Context.
[[nodiscard]] Layer voronoi_cells(const PointTable2& sites, const RationalPoint2& low,
                                  const RationalPoint2& high,
                                  Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
