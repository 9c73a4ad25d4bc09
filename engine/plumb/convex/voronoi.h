// Voronoi diagrams of points of the plane, exactly: the cell of a site consists of the points that
// are at least as near to this site as to every other site.
//
// Main flow of voronoi_cells():
//  1. delaunay   (triangulation.h) finds which sites are neighbours
//  2. centres    computes the exact centre of the circle of each triangle. The centres of the
//                triangles around a site inside the convex hull are the corners of its cell
//  3. clip       cuts the cells to a box. The cell of a site on the convex hull is the box, cut by
//                the bisectors between the site and its neighbours
//
// Corners are rational points, so equal corners of several cells are equal exactly, and cells share
// their borders.
//
// Cost: that of delaunay(), and O(d) exact steps for a site with d neighbours; O(d^2) if the site
// lies on the convex hull.
#pragma once

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational_point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the Voronoi cells of sites inside the box between two corners, as a layer. Feature i is
/// the cell of site i: a convex polygon, or no polygon if the cell does not meet the inside of the
/// box, or if the site equals an earlier one. Features have no ids and no properties.
/// repair_layer() rounds such a layer to doubles. Throws Error{BadArgument} unless the box has an
/// area, and what the context throws.
[[nodiscard]] Layer voronoi_cells(const PointTable2& sites, const RationalPoint2& low,
                                  const RationalPoint2& high,
                                  Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
