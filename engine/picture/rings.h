// Closed polygons on their way into a picture: boxes, paths, and what becomes of those too small to
// be seen.
#pragma once

#include <ostream>
#include <span>
#include <vector>

#include "plumb/picture/svg_text.h"
#include "plumb/picture/view.h"

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

}  // namespace plumb
