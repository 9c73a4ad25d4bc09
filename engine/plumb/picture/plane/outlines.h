// Closed polygons on their way into a picture: boxes, paths, and what becomes of those too small to
// be seen.
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

/// Requires a point.
Rectangle box_of(const std::vector<Point2>& ring);

/// The points of its vertices, from those of all vertices.
std::vector<Point2> points_of(std::span<const VertexId> ring, std::span<const Point2> of_vertex);

/// The ring in picture units.
std::vector<Point2> placed(const View& view, const std::vector<Point2>& ring);

/// Adds a closed subpath. Requires a point.
void append_ring(const std::vector<Point2>& ring, PathData& path);

/// The picture in small cells; which of them hold faces too small to be drawn.
class TinyFaces {
 public:
  explicit TinyFaces(const Rectangle& frame);

  void mark(Point2 p);
  bool is_empty() const { return is_empty_; }
  /// One path of class "tiny" of all runs of marked cells; nothing if there are none.
  void write(std::ostream& out) const;

 private:
  void write_run(std::size_t begin, std::size_t length, std::ostream& out) const;

  Rectangle frame_;
  std::size_t columns_;
  std::vector<bool> marked_;
  bool is_empty_ = true;
};

// Edges of a complex joined into long paths, so that dashes run on over vertices.

/// Every edge e with kind[e] = `kind`, once. Chains end where other than two such edges meet. `at`
/// are the places of the vertices; requires no such edge to lead to infinity. Stops after
/// `max_points`; returns the number of edges left out. O(edges + vertices).
std::size_t append_chains(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                          std::uint8_t wanted, std::span<const Point2> at, std::size_t max_points,
                          PathData& path);

/// The total length of these edges.
double total_length(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                    std::uint8_t wanted, std::span<const Point2> at);

// Room for a label inside a polygon.

/// A box of this size that lies inside the polygon of the rings (even-odd), as near to the middle
/// of it as a few tries find. Nothing if none of the tries fits. O(points).
std::optional<Rectangle> room_inside(const std::vector<std::vector<Point2>>& rings, double width,
                                     double height);

}  // namespace plumb
