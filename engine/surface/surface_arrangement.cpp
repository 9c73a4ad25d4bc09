#include "plumb/surface/surface_arrangement.h"

#include <algorithm>

#include "plumb/predicates/segment2.h"

namespace plumb {

bool SurfaceBundles::add_sum(std::span<SignedEntry> terms) {
  std::sort(terms.begin(), terms.end());
  const std::size_t before = entries_.size();
  for (std::size_t i = 0; i < terms.size();) {
    const std::uint32_t id = terms[i].id;
    std::int64_t sum = 0;
    for (; i < terms.size() && terms[i].id == id; ++i) sum += terms[i].value;
    if (sum != 0) entries_.push_back({id, entry_value(sum)});
  }
  if (entries_.size() == before) return false;
  begin_.push_back(static_cast<std::uint32_t>(entries_.size()));
  return true;
}

RationalPoint2 exact_crossing(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, const SurfaceCrossing& c) {
  const auto at = [&](std::size_t i) {
    return points.exact_in(arrangement.node_point[c.ends[i].value()], c.face);
  };
  return crossing_point(RationalSegment2{at(0), at(1)}, RationalSegment2{at(2), at(3)});
}

RationalPoint2 exact_node(const SurfaceArrangement& arrangement, const SurfacePointTable& points,
                          NodeId node, FaceId f) {
  if (arrangement.is_crossing(node)) {
    return exact_crossing(arrangement, points, arrangement.crossing(node));
  }
  if (arrangement.is_input(node)) return points.exact_in(arrangement.input(node), f);
  const VertexId v = arrangement.corner(node);
  const SurfaceMesh& mesh = points.mesh();
  return {mesh.corner(f, 1) == v ? 1 : 0, mesh.corner(f, 2) == v ? 1 : 0};
}

SurfacePointId add_node_point(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, NodeId node, SurfacePointTable& to) {
  if (arrangement.is_crossing(node)) {
    const SurfaceCrossing& c = arrangement.crossing(node);
    const RationalPoint2 at = exact_crossing(arrangement, points, c);
    return to.add_in_face(c.face, at.x, at.y);
  }
  if (!arrangement.is_input(node)) return to.add_vertex(arrangement.corner(node));
  const SurfacePointId p = arrangement.input(node);
  switch (points.place(p)) {
    case SurfacePlace::Vertex:
      return to.add_vertex(points.vertex(p));
    case SurfacePlace::Edge:
      return to.add_on_edge(points.edge(p), points.exact(p).x);
    case SurfacePlace::Face:
      break;
  }
  const RationalPoint2 at = points.exact(p);
  return to.add_in_face(points.face(p), at.x, at.y);
}

}  // namespace plumb
