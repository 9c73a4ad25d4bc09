// Colours go down the tree and stay on faces. A pass over rising numbers sees parents before their
// children, so each node hands its colour to its children, and only a node without a colour takes
// the colour of a node of the kind Color. A node that makes faces (a primitive, an extrusion, a
// hull, a sum) is then painted as a whole. Booleans and maps carry the sources of their operands.
//
// Tested by tests/csg/colors_test.cpp.
#include "plumb/csg/node/node_colors.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "plumb/space/source_mesh.h"
#include "plumb/space/to_mesh.h"

namespace plumb {
namespace {

bool has_colors(const CsgTree& tree) {
  return std::any_of(tree.nodes.begin(), tree.nodes.end(),
                     [&](const CsgTree::Node& node) { return color_of(tree, node).has_value(); });
}

/// Gives all faces the material that is this colour.
void set_color(MeshAttributes& attributes, const CsgColor& color, std::size_t faces) {
  attributes.materials = {{{}, color, {}}};
  attributes.face_material.assign(faces, 0);
  std::erase_if(attributes.channels,
                [](const MeshChannel& channel) { return channel.name == "color"; });
}

Nef3 with_boundary(const Nef3& set, const CsgColor& color, const std::string& name,
                   Context& context) {
  ToMeshOptions options;
  options.keeps_exact = true;
  MeshSource source;
  source.name = name;
  source.mesh = set.to_polygons(options, context).mesh;
  set_color(source.attributes, color, source.mesh.face_count());
  return set.with_source(std::make_shared<const MeshSource>(std::move(source)));
}

}  // namespace

std::optional<CsgColor> color_of(const CsgTree& tree, const CsgTree::Node& node) {
  if (node.kind != CsgKind::Color || node.number_count != 4) return {};
  CsgColor color{};
  const auto numbers = tree.numbers_of(node);
  for (std::size_t i = 0; i < color.size(); ++i) {
    if (!(numbers[i] >= 0)) return {};
    color[i] = std::min(numbers[i], 1.0);
  }
  return color;
}

bool makes_new_faces(CsgKind kind) {
  return kind == CsgKind::Hull || kind == CsgKind::Minkowski || kind == CsgKind::LinearExtrude ||
         kind == CsgKind::RotateExtrude || kind == CsgKind::Projection || kind == CsgKind::Offset;
}

CsgPaint paint_of(const CsgTree& tree) {
  CsgPaint paint;
  if (!has_colors(tree)) return paint;
  const auto count = static_cast<std::uint32_t>(tree.nodes.size());
  paint.of_node.assign(count, CsgPaint::kNone);
  std::vector<std::uint32_t> maker(count, CsgPaint::kNone);  // The node that makes new faces.
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t color = paint.of_node[i], above = maker[i];
    const bool is_free = color == CsgPaint::kNone;
    if (is_free && color_of(tree, tree.nodes[i])) {
      if (above == CsgPaint::kNone) color = i;
      if (above != CsgPaint::kNone && paint.of_node[above] == CsgPaint::kNone) {
        paint.losing.push_back(above);
      }
    }
    if (makes_new_faces(tree.nodes[i].kind) && above == CsgPaint::kNone) above = i;
    const bool is_below_maker = above != CsgPaint::kNone;
    tree.for_each_child(i, [&](std::uint32_t child) {
      paint.of_node[child] = is_below_maker ? CsgPaint::kNone : color;
      maker[child] = above;
    });
  }
  std::sort(paint.losing.begin(), paint.losing.end());
  paint.losing.erase(std::unique(paint.losing.begin(), paint.losing.end()), paint.losing.end());
  return paint;
}

Nef3 painted(const Nef3& set, const CsgColor& color, const std::string& name, Context& context) {
  if (set.is_empty()) return set;
  if (set.sources().empty()) return with_boundary(set, color, name, context);
  std::vector<PlacedSource> sources(set.sources().begin(), set.sources().end());
  for (PlacedSource& placed : sources) {
    MeshSource changed = *placed.source;
    set_color(changed.attributes, color, changed.plane ? 1 : changed.mesh.face_count());
    placed.source = std::make_shared<const MeshSource>(std::move(changed));
  }
  return set.with_sources(sources);
}

}  // namespace plumb
