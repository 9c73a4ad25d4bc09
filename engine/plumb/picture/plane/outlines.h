// Closed polygons on their way into a picture: boxes, paths, chains of edges, space for labels, and
// the treatment of polygons that are too small to be seen.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <vector>

#include "plumb/picture/plane/plane_view.h"
#include "plumb/picture/svg/svg_text.h"
#include "plumb/plane/plane_complex.h"

namespace plumb {

/// Returns the box of a ring. Requires a point.
Rectangle box_of(const std::vector<Point2>& ring);

/// Selects the points of the vertices of a ring from the points of all vertices.
std::vector<Point2> points_of(std::span<const VertexId> ring, std::span<const Point2> of_vertex);

/// Returns the ring in picture units.
std::vector<Point2> placed(const View& view, const std::vector<Point2>& ring);

/// Appends a closed subpath. Requires a point.
void append_ring(const std::vector<Point2>& ring, PathData& path);

/// The picture in small cells, and which of them hold faces too small to be drawn.
class TinyFaces {
 public:
  explicit TinyFaces(const Rectangle& frame);

  /// Marks the cell of a point.
  void mark(Point2 p);
  bool is_empty() const { return is_empty_; }
  /// Writes one path of class "tiny" with all runs of marked cells; nothing if there are none.
  void write(std::ostream& out) const;

 private:
  void write_run(std::size_t begin, std::size_t length, std::ostream& out) const;

  Rectangle frame_;
  std::size_t columns_;
  std::vector<bool> marked_;
  bool is_empty_ = true;
};

// Edges of a complex joined into long paths, so that dashes continue across vertices.

/// Appends every edge e with kind[e] = `wanted`, once. Chains end at vertices with one such edge or
/// more than two. `at` holds the places of the vertices. Requires that no such edge leads to
/// infinity. Stops after `max_points` and returns the number of edges left out. Cost: O(edges +
/// vertices).
std::size_t append_chains(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                          std::uint8_t wanted, std::span<const Point2> at, std::size_t max_points,
                          PathData& path);

/// Returns the total length of these edges.
double total_length(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                    std::uint8_t wanted, std::span<const Point2> at);

// Space for a label inside a polygon.

/// Returns a box of this size that lies inside the polygon of the rings (even-odd), as near to its
/// middle as a few tries find; no value if none of the tries fits. Cost: O(points).
std::optional<Rectangle> room_inside(const std::vector<std::vector<Point2>>& rings, double width,
                                     double height);

}  // namespace plumb
