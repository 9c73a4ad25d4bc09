// Scenes of divided surfaces: cells as patches, and layers for polygons, slices, labels and
// results.
//
// Triangles that follow each other in one face and cell share a patch, with the normal of the face;
// cells are groups, so that a viewer shows their label when pointed at. Each layer tints the groups
// anew, and lines belong to the layers in which they are seen: wires of the mesh, arcs in the
// colour of the first shape along them, and the border of a result.
// Tested by tests/picture/surface_scene_test.cpp.
#include "plumb/picture/surface_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/picture/scene/scene_frame.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/surface/cells/surface_arrangement.h"

namespace plumb {
namespace {

// The colour of labels that are zero, and of cells that are not selected.
constexpr Colour kNothing{0xe6, 0xe9, 0xee};
constexpr Colour kSelected{0x7f, 0xb4, 0xe6};
constexpr std::size_t kCurvePaints = 6;
constexpr std::uint32_t kNoPoint = ~std::uint32_t{0};
constexpr std::uint8_t kDrawn = bit(SurfaceLayer::Polygons) | bit(SurfaceLayer::Slices) |
                                bit(SurfaceLayer::Cells) | bit(SurfaceLayer::Labels);

Point3 normal_of(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 p{b.x - a.x, b.y - a.y, b.z - a.z}, q{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 n{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (!(length > 0)) return {0, 0, 1};
  return {n.x / length, n.y / length, n.z / length};
}

class SurfaceSceneMaker {
 public:
  SurfaceSceneMaker(const SurfaceDivision& division, const SurfaceTriangulation& triangles,
                    const SurfaceResult* result)
      : division_(division),
        arrangement_(division.arrangement()),
        in_(triangles),
        result_(result) {}

  Scene run() {
    place();
    add_patches();
    add_groups();
    add_layers();
    add_wires();
    add_arcs();
    add_dots();
    if (result_ != nullptr) add_result();
    return std::move(scene_);
  }

 private:
  void place() {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SurfaceTriangle& t : in_.triangles) {
      for (const std::uint32_t c : t) {
        frame_.include(in_.points[c]);
        low = std::min(low, in_.points[c].z);
        high = std::max(high, in_.points[c].z);
      }
    }
    frame_.close(0);
    frame_.describe(scene_);
    scene_.is_flat = low == high;
    for (const Point3& p : in_.points) scene_.points.push_back(frame_.at(p));
    point_of_node_.assign(arrangement_.node_count(), kNoPoint);
    for (std::uint32_t p = 0; p < in_.points.size(); ++p) {
      if (in_.node[p].is_valid()) point_of_node_[in_.node[p]] = p;
    }
  }

  /// Adds a patch for each sequence of triangles in the same face and cell.
  void add_patches() {
    const SurfaceMesh& mesh = division_.mesh();
    for (std::size_t t = 0; t < in_.triangles.size(); ++t) {
      const FaceId f = in_.face[t];
      if (t == 0 || in_.face[t - 1] != f || in_.cell[t - 1] != in_.cell[t]) {
        const SurfaceTriangle& c = mesh.corners(f);
        scene_.patches.push_back(
            {normal_of(scene_.points[c[0]], scene_.points[c[1]], scene_.points[c[2]]),
             Paint::Surface, in_.cell[t].value()});
      }
      scene_.triangles.push_back(
          {in_.triangles[t], static_cast<std::uint32_t>(scene_.patches.size() - 1)});
    }
  }

  void add_groups() {
    for (std::uint32_t c = 0; c < division_.cell_count(); ++c) {
      scene_.groups.push_back(
          {"cell " + std::to_string(c), label_text(division_.labels(CellId(c)))});
    }
  }

  /// Adds the layers that a viewer can choose from, each with a tint for every group.
  void add_layers() {
    Scene::Layer cells{layer_name(SurfaceLayer::Cells), {}, false};
    Scene::Layer labels{layer_name(SurfaceLayer::Labels), {}, true};
    std::map<std::string, Colour> known{{label_text({}), kNothing}};
    for (std::size_t c = 0; c < scene_.groups.size(); ++c) {
      cells.tints.push_back(distinct_colour(c));
      const auto [place, is_new] = known.emplace(scene_.groups[c].text, kNothing);
      if (is_new) place->second = distinct_colour(known.size() - 2);
      labels.tints.push_back(place->second);
    }
    scene_.layers = {{layer_name(SurfaceLayer::Polygons), {}, false},
                     {layer_name(SurfaceLayer::Slices), {}, false},
                     std::move(cells),
                     std::move(labels)};
    if (result_ == nullptr) return;
    Scene::Layer layer{layer_name(SurfaceLayer::Result), {}, false};
    for (const std::uint8_t is_selected : result_->region.is_selected) {
      layer.tints.push_back(is_selected != 0 ? kSelected : kNothing);
    }
    scene_.layers.push_back(std::move(layer));
  }

  /// Calls visit(side) for the sides of triangles, once for each pair of sides.
  template <class Visit>
  void for_sides(const Visit& visit) const {
    for (std::uint32_t s = 0; s < in_.across.size(); ++s) {
      if (in_.across[s] == kNone || s < in_.across[s]) visit(s);
    }
  }
  bool has_other(std::uint32_t side) const { return in_.across[side] != kNone; }
  void add_line(std::uint32_t side, Paint paint, std::uint8_t layers) {
    const Scene::Triangle& t = scene_.triangles[side / 3];
    const std::uint32_t other =
        has_other(side) ? scene_.triangles[in_.across[side] / 3].patch : Scene::kNoPatch;
    scene_.lines.push_back(
        {{t.corners[side % 3], t.corners[(side + 1) % 3]}, paint, {t.patch, other}, layers});
  }

  void add_wires() {
    for_sides([&](std::uint32_t s) { add_line(s, Paint::Wire, bit(SurfaceLayer::Slices)); });
  }

  /// Adds arcs in the colour of the first shape along them.
  void add_arcs() {
    const std::vector<std::uint32_t> shape_of = first_shapes();
    for_sides([&](std::uint32_t s) {
      if (!in_.arc[s].is_valid()) return;
      const std::uint32_t polygon = arrangement_.multiplicities(in_.arc[s]).front().id;
      const std::size_t paint =
          static_cast<std::size_t>(Paint::Curve) + shape_of[polygon] % kCurvePaints;
      add_line(s, static_cast<Paint>(paint), kDrawn);
    });
  }
  std::vector<std::uint32_t> first_shapes() const {
    const SurfaceScene& scene = division_.scene();
    std::vector<std::uint32_t> shape_of(scene.polygons.size());
    for (std::uint32_t p = 0; p < shape_of.size(); ++p) shape_of[p] = p;
    if (!scene.shapes) return shape_of;
    for (std::size_t s = scene.shapes->size(); s-- > 0;) {
      for (const std::uint32_t p : (*scene.shapes)[s]) shape_of[p] = static_cast<std::uint32_t>(s);
    }
    return shape_of;
  }

  void add_dots() {
    constexpr auto kLayer = bit(SurfaceLayer::Polygons);
    const SurfacePolygons& polygons = division_.scene().polygons;
    for (std::size_t i = 0; i < polygons.point.size(); ++i) {
      if (polygons.is_control[i] == 0) continue;
      const NodeId n = arrangement_.node_of_entry[i];
      scene_.dots.push_back({point_of(n), Paint::Control, kLayer});
    }
    const std::vector<std::uint8_t> ends = arc_ends(arrangement_);
    for (std::size_t n = 0; n < ends.size(); ++n) {
      if (ends[n] != kCrossingEnds) continue;
      scene_.dots.push_back({point_of(NodeId(n)), Paint::Crossing, kLayer});
    }
  }
  /// Returns the point of a node. If polygons cancel, no triangle has a corner there.
  std::uint32_t point_of(NodeId n) {
    std::uint32_t& point = point_of_node_[n];
    if (point == kNoPoint) point = add_point(node_position(division_, n));
    return point;
  }
  std::uint32_t add_point(const Point3& at) {
    scene_.points.push_back(frame_.at(at));
    return static_cast<std::uint32_t>(scene_.points.size() - 1);
  }

  bool is_selected(std::uint32_t side) const {
    return result_->region.is_selected[in_.cell[side / 3].value()] != 0;
  }

  void add_result() {
    constexpr auto kLayer = bit(SurfaceLayer::Result);
    for_sides([&](std::uint32_t s) {
      if (has_other(s) && is_selected(s) != is_selected(in_.across[s])) {
        add_line(s, Paint::Curve, kLayer);
      }
    });
    const SurfacePolygons& borders = result_->borders;
    for (std::size_t i = 0; i < borders.point.size(); ++i) {
      if (borders.is_control[i] == 0) continue;
      const std::uint32_t point = add_point(borders.points.position(borders.point[i]));
      scene_.dots.push_back({point, Paint::Control, kLayer});
    }
  }

  const SurfaceDivision& division_;
  const SurfaceArrangement& arrangement_;
  const SurfaceTriangulation& in_;
  const SurfaceResult* result_;
  SceneFrame frame_;
  Scene scene_;
  IdVector<NodeId, std::uint32_t> point_of_node_;
};

}  // namespace

Scene scene_of(const SurfaceDivision& division, const SurfaceTriangulation& triangles,
               const SurfaceResult* result) {
  return SurfaceSceneMaker(division, triangles, result).run();
}

Scene labelled_scene(const SurfaceDivision& division, const SurfaceResult* result,
                     Context& context) {
  Scene scene = scene_of(division, triangulate_surface(division, context), result);
  scene.shown = bit(SurfaceLayer::Labels);
  if (result == nullptr) return scene;
  std::erase_if(scene.triangles, [&](const Scene::Triangle& t) {
    return result->region.is_selected[scene.patches[t.patch].group] == 0;
  });
  std::erase_if(scene.lines,
                [](const Scene::Line& l) { return (l.layers & bit(SurfaceLayer::Result)) == 0; });
  for (Scene::Line& l : scene.lines) l.layers = Scene::kAllLayers;
  return scene;
}

std::string layer_name(SurfaceLayer layer) {
  return std::string(kSurfaceLayerNames[static_cast<std::size_t>(layer)]);
}

std::string facts_of(const SurfaceDivision& division) {
  const SurfaceCounts n = division.counts();
  return counted(n.triangles, "triangle") + ", " +
         counted(division.scene().polygons.size(), "polygon") + ", " +
         counted(n.segments, "segment") + ", " + counted(n.crossings, "crossing") + ", " +
         counted(n.cells, "cell");
}

std::string shape_name(std::uint32_t shape) {
  if (shape < 26) return {static_cast<char>('A' + shape)};
  return "s" + std::to_string(shape);
}

std::string label_text(std::span<const SignedEntry> label) {
  std::string text;
  for (const SignedEntry& e : label) {
    if (e.value < 0) {
      text += '-';
    } else if (!text.empty()) {
      text += '+';
    }
    if (std::abs(e.value) != 1) text += std::to_string(std::abs(e.value));
    text += shape_name(e.id);
  }
  return text.empty() ? "0" : text;
}

}  // namespace plumb
