// Scenes of sets of the plane and of maps: planar drawings for viewers of scenes.
//
// Faces are triangulated between exact points, so a thin face keeps its shape, and only then placed
// in scene coordinates in doubles. A set is first cut at a window, exactly, as for its picture
// (plane/plane_view.h). Lines and dots follow the marks of edges and vertices; defects of a map
// become lines in the colour of their kind.
// Tested by tests/cli/view_command_test.cpp.
#include "plumb/picture/plane_scene.h"

#include <algorithm>

#include "plumb/picture/plane/plane_view.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

constexpr double kThickness = 1e-3;
constexpr std::size_t kRegionPaints = 6;
constexpr const char* kPhase = "drawing";
constexpr std::size_t kCheckedPoints = 256;  // Testing a point takes some microseconds.

using IndexRing = std::vector<std::uint32_t>;

/// A flat scene, filled face by face. Triangles are made between exact points.
class FlatScene {
 public:
  FlatScene() : flat_(tables_.points) { scene_.is_flat = true; }

  Scene& scene() { return scene_; }

  std::uint32_t add_point(const RationalPoint2& exact, Point2 shown) {
    points_.push_back(plumb::add_point(tables_, {exact.x, exact.y, 0}));
    scene_.points.push_back({shown.x, shown.y, 0});
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  /// Fills the region to the left of the rings. A ring of one point has no area.
  void fill(const std::vector<IndexRing>& rings, Paint paint) {
    std::vector<std::uint32_t> used;
    for (const IndexRing& ring : rings) used.insert(used.end(), ring.begin(), ring.end());
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    flat_.reset({});
    for (const std::uint32_t i : used) flat_.push_back(points_[i]);
    const auto number = [&used](std::uint32_t i) {
      return static_cast<std::uint32_t>(std::ranges::lower_bound(used, i) - used.begin());
    };
    std::vector<IndexEdge> edges;
    for (const IndexRing& ring : rings) {
      for (std::size_t k = 0; ring.size() > 1 && k < ring.size(); ++k) {
        edges.push_back({number(ring[k]), number(ring[(k + 1) % ring.size()])});
      }
    }
    std::vector<IndexTriangle> triangles;
    if (!triangulate(flat_, edges, triangles)) return;
    const auto patch = static_cast<std::uint32_t>(scene_.patches.size());
    scene_.patches.push_back({{0, 0, 1}, paint});
    for (const IndexTriangle& t : triangles) {
      scene_.triangles.push_back({{used[t[0]], used[t[1]], used[t[2]]}, patch});
    }
  }

  void add_line(std::uint32_t a, std::uint32_t b, Paint paint) {
    scene_.lines.push_back({{a, b}, paint, {Scene::kNoPatch, Scene::kNoPatch}});
  }

 private:
  SpaceTables tables_;
  FlatPoints flat_;
  std::vector<SpacePoint> points_;
  Scene scene_;
};

std::vector<IndexRing> numbers_of(const std::vector<std::vector<VertexId>>& rings) {
  std::vector<IndexRing> numbers;
  for (const std::vector<VertexId>& ring : rings) {
    numbers.emplace_back();
    for (const VertexId v : ring) numbers.back().push_back(v.value());
  }
  return numbers;
}

// ---------------------------------------------------------------- sets

void add_edges(const PlaneComplex& complex, std::span<const unsigned> borders, FlatScene& flat) {
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const std::uint32_t a = complex.dcel.origin(h).value(), b = complex.dcel.target(h).value();
    if ((borders[a] & borders[b]) != 0) continue;
    flat.add_line(a, b, complex.mark(EdgeId(e)) ? Paint::Edge : Paint::OpenEdge);
  }
}

void add_dots(const PlaneComplex& complex, std::span<const unsigned> borders, FlatScene& flat) {
  for (std::uint32_t i = 0; i < complex.vertex_count(); ++i) {
    const VertexId v(i);
    if (borders[i] != 0) continue;
    const bool is_point = complex.mark(v);
    std::size_t alike = 0, unlike = 0;
    for (const HalfedgeId h : complex.dcel.around(v)) {
      ++(complex.mark(edge_of(h)) == is_point ? alike : unlike);
    }
    const bool says_more = is_point ? alike == 0 : unlike > 0 || alike == 0;
    if (says_more) flat.scene().dots.push_back({i, is_point ? Paint::Point : Paint::OpenPoint});
  }
}

// ---------------------------------------------------------------- maps

void add_borders(const MapReport& report, FlatScene& flat) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t c = 0; c < report.map.cycle_count(); ++c) {
    const auto cycle = report.map.cycle(c);
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      edges.emplace_back(std::minmax(cycle[k], cycle[(k + 1) % cycle.size()]));
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) flat.add_line(a, b, Paint::Edge);
}

void add_regions(const MapReport& report, FlatScene& flat, Context& context) {
  const std::vector<std::uint8_t> tints = colour_cycles(report.map);
  const auto ring_of = [&report](std::uint32_t c) {
    const auto cycle = report.map.cycle(c);
    return IndexRing(cycle.begin(), cycle.end());
  };
  for (const MapRegion& region : report.regions) {
    if (!region.outer) continue;
    context.checkpoint(kPhase, *region.outer, 0);
    std::vector<IndexRing> rings{ring_of(*region.outer)};
    for (const std::uint32_t hole : region.holes) rings.push_back(ring_of(hole));
    const auto first = static_cast<std::size_t>(Paint::Region);
    flat.fill(rings, static_cast<Paint>(first + tints[*region.outer] % kRegionPaints));
  }
}

void add_defects(const MapReport& report, const Plane& plane, FlatScene& flat) {
  for (const MapDefect& defect : report.defects) {
    for (const MapEdge& e : defect.edges) flat.add_line(e.from, e.to, Paint::Defect);
    if (!defect.point) continue;
    const std::uint32_t at = flat.add_point(*defect.point, plane.at(defect.near));
    flat.scene().dots.push_back({at, Paint::Defect});
  }
}

}  // namespace

Scene scene_of(const Nef2& set, Context& context) {
  constexpr double kMargin = 0.1, kFadingMargin = 0.34;
  const bool fades = !set.is_bounded();
  const PlaneWindow window(set.complex(), fades ? kFadingMargin : kMargin);
  const Nef2 shown = cut_at(set, window, context);
  const PlaneComplex& complex = shown.complex();
  FlatScene flat;
  flat.scene().fades = fades;
  flat.scene().half = {1, window.aspect(), kThickness};
  std::vector<unsigned> borders;
  for (const std::uint32_t i : complex.vertex_point) {
    if (borders.size() % kCheckedPoints == 0) context.checkpoint(kPhase, borders.size(), 0);
    flat.add_point(exact(complex.points, i), window.at(complex.points, i));
    borders.push_back(window.borders(complex.points, i));
  }
  for (std::uint32_t f = 0; f < complex.face_count(); ++f) {
    context.checkpoint(kPhase, f, complex.face_count());
    const std::vector<IndexRing> rings = numbers_of(face_rings(complex, FaceId(f)));
    if (complex.mark(FaceId(f))) flat.fill(rings, Paint::ClosedFacet);
  }
  add_edges(complex, borders, flat);
  add_dots(complex, borders, flat);
  return std::move(flat.scene());
}

Scene scene_of(const MapReport& report, Context& context) {
  const Plane plane(report.map);
  FlatScene flat;
  for (std::uint32_t v = 0; v < report.map.points.size(); ++v) {
    if (v % kCheckedPoints == 0) context.checkpoint(kPhase, v, report.map.points.size());
    flat.add_point(report.map.points.exact(v), plane.at(v));
  }
  const Rectangle& extent = plane.extent();
  flat.scene().half = {std::max(extent.width() / 2, kThickness),
                       std::max(extent.height() / 2, kThickness), kThickness};
  add_regions(report, flat, context);
  add_borders(report, flat);
  add_defects(report, plane, flat);
  return std::move(flat.scene());
}

}  // namespace plumb
