#include "plumb/picture/piece_layer.h"

#include <algorithm>
#include <vector>

#include "plumb/picture/distinct_colour.h"
#include "plumb/picture/rings.h"
#include "plumb/picture/scene.h"
#include "plumb/picture/svg_text.h"
#include "plumb/plane/plane_measure.h"

namespace plumb {
namespace {

constexpr double kVisible = 1.2;
constexpr std::size_t kMaxPoints = 400000;

/// The marked faces in picture units.
PathData path_of(const Nef2& piece, const PlaneWindow& window, const View& view) {
  const PlaneComplex& c = piece.complex();
  std::vector<Point2> at;
  for (const std::uint32_t i : c.vertex_point) at.push_back(view.place(window.at(c.points, i)));
  PathData path;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    if (!c.mark(FaceId(f))) continue;
    for (const std::vector<VertexId>& ring : face_rings(c, FaceId(f))) {
      const std::vector<Point2> places = points_of(ring, at);
      const Rectangle box = box_of(places);
      if (std::max(box.width(), box.height()) >= kVisible) append_ring(places, path);
    }
  }
  return path;
}

}  // namespace

PieceCounts write_pieces(std::span<const Nef2> pieces, const PlaneWindow& window, const View& view,
                         bool is_cut, Context* context, std::ostream& out) {
  std::size_t points = 0;
  PieceCounts counts;
  out << "<g transform=\"scale(.1)\">\n";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (context != nullptr) context->checkpoint("drawing pieces", i, pieces.size());
    const PathData path = path_of(is_cut ? cut_at(pieces[i], window) : pieces[i], window, view);
    if (path.empty()) continue;
    points += path.points();
    if (points > kMaxPoints) {
      ++counts.left_out;
      continue;
    }
    ++counts.drawn;
    out << "<path class=\"piece\" fill=\"" << hex(distinct_colour(i)) << "\" d=\"" << path.data()
        << "\"/>\n";
  }
  out << "</g>\n";
  return counts;
}

}  // namespace plumb
