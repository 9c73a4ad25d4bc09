#include "plumb/surface/surface_result.h"

#include <numeric>
#include <vector>

#include "plumb/base/refused_memory.h"
#include "plumb/surface/surface_cells.h"

namespace plumb {
namespace {

/// Of a component of the mesh.
struct Component {
  bool has_border = false;
  bool has_selected = false;
  bool has_other = false;  ///< a cell that is not selected
  bool has_other_at_border = false;
  FaceId first;    ///< the lowest face
  FaceId outside;  ///< one whose first corner is in no selected cell

  /// Is a label that is 1 in selected cells and 0 in others what borders mean by themselves?
  bool is_usual() const { return !has_selected || (has_border ? has_other_at_border : has_other); }
};

std::vector<Component> components_of(const SurfaceDivision& d, const SurfaceRegion& region) {
  const SurfaceCells& cells = d.cells();
  std::vector<Component> components(d.mesh().component_count());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Component& in = components[cells.component[c]];
    const bool is_selected = region.is_selected[c] != 0, is_at_border = cells.is_at_border[c] != 0;
    in.has_border |= is_at_border;
    (is_selected ? in.has_selected : in.has_other) = true;
    in.has_other_at_border |= is_at_border && !is_selected;
  }
  for (std::size_t i = 0; i < d.mesh().face_count(); ++i) {
    const FaceId f(i);
    Component& in = components[d.mesh().component(f)];
    if (!in.first.is_valid()) in.first = f;
    if (in.outside.is_valid() || in.is_usual()) continue;
    const CellId c = cell_at_corner(d.arrangement(), cells, f);
    if (region.is_selected[c.value()] == 0) in.outside = f;
  }
  return components;
}

}  // namespace

SurfaceScene result_scene(const SurfaceDivision& d, const SurfaceResult& result) try {
  std::vector<std::uint32_t> shape(result.borders.size());
  std::iota(shape.begin(), shape.end(), 0U);
  SurfaceScene scene{d.scene().mesh, result.borders, {{shape}}, FaceId{}};
  for (const Component& c : components_of(d, result.region)) {
    if (c.is_usual()) continue;
    if (c.outside.is_valid() && !scene.outside.is_valid()) {
      scene.outside = c.outside;
    } else if (c.outside.is_valid()) {
      scene.levels.push_back({0, c.outside, 0});
    } else {
      const CellId at = cell_at_corner(d.arrangement(), d.cells(), c.first);
      scene.levels.push_back({0, c.first, result.region.is_selected[at.value()] != 0 ? 1 : 0});
    }
  }
  return scene;
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
