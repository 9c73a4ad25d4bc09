#include "plumb/csg/csg_tree.h"

#include <array>

namespace plumb {

std::string_view name_of(CsgKind kind) {
  static constexpr std::array<std::string_view, 24> kNames{
      "file",         "group",          "union",          "color",      "render", "difference",
      "intersection", "hull",           "minkowski",      "multmatrix", "resize", "offset",
      "projection",   "linear_extrude", "rotate_extrude", "cube",       "sphere", "cylinder",
      "polyhedron",   "square",         "circle",         "polygon",    "import", "import"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool is_union(CsgKind kind) {
  return kind == CsgKind::Root || kind == CsgKind::Group || kind == CsgKind::Union ||
         kind == CsgKind::Color || kind == CsgKind::Render;
}

}  // namespace plumb
