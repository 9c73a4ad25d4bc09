// SurfaceDivision: polygons on a mesh, divided into labelled cells; Booleans of shapes and their
// borders.
//
// The work is done in stages, each with its own file: slice() arranges polygons face by face
// (cells/surface_arrangement.h), make_cells() joins pieces to cells, label_cells() computes the
// integer label of each shape in each cell or a cycle that proves there is none
// (cells/surface_labels.h). This file validates scenes, evaluates set expressions cell by cell, and
// describes a result as a scene of its own.
//
// A label is determined up to a constant for each component of the mesh. By the usual rule, the
// least label at the border, or the least of all labels, is zero. result_scene() finds the
// components where this rule would give the border of the result another meaning, and states an
// outside face or a level there. Theory: docs/design/surface.md, sections Labels and Selection and
// borders. Tested by tests/surface/surface_test.cpp, tests/surface/surface_plane_test.cpp and
// tests/surface/surface_labels_test.cpp.
#include "plumb/surface/surface.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/cells/surface_labels.h"

namespace plumb {
namespace {

constexpr std::uint32_t kCellsPerCheckpoint = 256;

void require_sane_levels(const SurfaceScene& scene) {
  const std::size_t shapes = scene.shapes ? scene.shapes->size() : scene.polygons.size();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;  // The pairs of shape and component.
  for (const SurfaceLevel& l : scene.levels) {
    if (l.shape >= shapes) {
      throw Error(ErrorCode::BadIndex, "no shape " + std::to_string(l.shape));
    }
    if (l.face.value() >= scene.mesh->face_count()) {
      throw Error(ErrorCode::BadIndex, "no face " + std::to_string(l.face.value()));
    }
    places.emplace_back(l.shape, scene.mesh->component(l.face));
  }
  std::sort(places.begin(), places.end());
  const auto twice = std::adjacent_find(places.begin(), places.end());
  if (twice == places.end()) return;
  throw Error(ErrorCode::BadArgument,
              "two levels of shape " + std::to_string(twice->first) + " in one component");
}

/// Throws unless all indices of the scene exist and its polygons are over its own mesh.
void require_sane(const SurfaceScene& scene) {
  if (scene.mesh == nullptr) throw Error(ErrorCode::BadArgument, "a scene without a mesh");
  if (&scene.polygons.points.mesh() != scene.mesh.get()) {
    throw Error(ErrorCode::BadArgument, "polygons over another mesh");
  }
  require_valid(scene.polygons);
  for (std::size_t s = 0; scene.shapes && s < scene.shapes->size(); ++s) {
    for (const std::uint32_t p : (*scene.shapes)[s]) {
      if (p < scene.polygons.size()) continue;
      throw Error(ErrorCode::BadIndex,
                  "shape " + std::to_string(s) + ": no polygon " + std::to_string(p));
    }
  }
  if (scene.outside.is_valid() && scene.outside.value() >= scene.mesh->face_count()) {
    throw Error(ErrorCode::BadIndex, "no face " + std::to_string(scene.outside.value()));
  }
  require_sane_levels(scene);
}

/// Returns the number of a shape named "A" ... "Z", or "s0", "s1", ...; no value for other names.
std::optional<std::uint32_t> shape_named(const std::string& name) {
  if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z') {
    return static_cast<std::uint32_t>(name[0] - 'A');
  }
  std::uint32_t number = 0;
  const char* end = name.data() + name.size();
  if (name.size() < 2 || name[0] != 's') return std::nullopt;
  const auto [at, error] = std::from_chars(name.data() + 1, end, number);
  if (error != std::errc{} || at != end) return std::nullopt;
  return number;
}

/// Whether a label counts as inside by the winding rule.
bool is_inside(std::int32_t label, WindingRule rule) {
  switch (rule) {
    case WindingRule::EvenOdd:
      return label % 2 != 0;
    case WindingRule::Positive:
      return label > 0;
    case WindingRule::NonZero:
      break;
  }
  return label != 0;
}

bool apply(SetOperator op, bool a, bool b) {
  switch (op) {
    case SetOperator::Intersection:
      return a && b;
    case SetOperator::Union:
      return a || b;
    case SetOperator::Difference:
      return a && !b;
    default:
      return a != b;
  }
}

}  // namespace

/// The data of a division: the scene, and the result of each stage.
struct SurfaceDivision::State {
  SurfaceScene scene;
  SurfaceArrangement arrangement;
  SurfaceCells cells;
  // The labels of polygons. If the shapes are the polygons, they are also the labels of shapes.
  CellLabels polygon_labels;
  CellLabels shape_labels;
  std::size_t crossings = 0;

  State(SurfaceScene given, Context& context)
      : scene(std::move(given)),
        arrangement(slice(scene.polygons, context)),
        cells(make_cells(*scene.mesh, arrangement, context)) {
    count_crossings();
    CellId outside;
    if (scene.outside.is_valid()) outside = cell_at_corner(arrangement, cells, scene.outside);
    std::vector<CellLevel> levels;
    for (const SurfaceLevel& l : scene.levels) {
      levels.push_back({l.shape, cell_at_corner(arrangement, cells, l.face), l.label});
    }
    const CellJumps jumps = jumps_of_polygons(arrangement, cells, context);
    polygon_labels = label_cells(cells, jumps, scene.polygons.size(), outside,
                                 scene.shapes ? std::vector<CellLevel>() : levels, context);
    if (!scene.shapes) return;
    const CellJumps sums = jumps_of_shapes(jumps, *scene.shapes, context);
    shape_labels = label_cells(cells, sums, scene.shapes->size(), outside, levels, context);
  }

  const CellLabels& labels() const { return scene.shapes ? shape_labels : polygon_labels; }

  void count_crossings() {
    for (const std::uint8_t ends : arc_ends(arrangement)) crossings += ends == kCrossingEnds;
  }

  /// Returns the shape of each name. Throws Error{BadArgument} for names that are not shapes, and
  /// for shapes without labels.
  std::vector<std::uint32_t> shapes_of(const SetExpression& expression, WindingRule rule) const {
    std::vector<std::uint32_t> shapes;
    for (const std::string& name : expression.names) {
      const auto shape = shape_named(name);
      if (!shape || *shape >= labels().separation.size()) {
        throw Error(ErrorCode::BadArgument, "no shape is named " + name);
      }
      const Separation& s = labels().separation[*shape];
      if (!s.over_z && !(s.mod_2 && rule == WindingRule::EvenOdd)) {
        throw Error(ErrorCode::BadArgument,
                    "shape " + name + " does not separate the surface: it has no inside");
      }
      shapes.push_back(*shape);
    }
    return shapes;
  }

  /// Returns the polygons of some shapes in ascending order, each once.
  std::vector<std::uint32_t> polygons_of(const std::vector<std::uint32_t>& shapes) const {
    std::vector<std::uint32_t> polygons;
    for (const std::uint32_t s : shapes) {
      if (scene.shapes) {
        const std::vector<std::uint32_t>& shape = (*scene.shapes)[s];
        polygons.insert(polygons.end(), shape.begin(), shape.end());
      } else {
        polygons.push_back(s);
      }
    }
    std::sort(polygons.begin(), polygons.end());
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    return polygons;
  }
};

SurfaceDivision::SurfaceDivision(SurfaceScene scene, Context& context) {
  require_sane(scene);
  state_ = std::make_unique<State>(std::move(scene), context);
}
SurfaceDivision::~SurfaceDivision() = default;
SurfaceDivision::SurfaceDivision(SurfaceDivision&&) noexcept = default;
SurfaceDivision& SurfaceDivision::operator=(SurfaceDivision&&) noexcept = default;

const SurfaceScene& SurfaceDivision::scene() const { return state_->scene; }
const SurfaceArrangement& SurfaceDivision::arrangement() const { return state_->arrangement; }
const SurfaceCells& SurfaceDivision::cells() const { return state_->cells; }

SurfaceCounts SurfaceDivision::counts() const {
  return {mesh().face_count(), state_->arrangement.segments, state_->crossings,
          state_->cells.size(), state_->cells.edges.size()};
}

std::size_t SurfaceDivision::cell_count() const { return state_->cells.size(); }
std::size_t SurfaceDivision::shape_count() const { return state_->labels().separation.size(); }

const Separation& SurfaceDivision::polygon_separation(std::uint32_t polygon) const {
  return state_->polygon_labels.separation[polygon];
}
const Separation& SurfaceDivision::shape_separation(std::uint32_t shape) const {
  return state_->labels().separation[shape];
}
std::span<const SignedEntry> SurfaceDivision::labels(CellId c) const { return state_->labels()[c]; }
double SurfaceDivision::area(CellId c) const { return state_->cells.area[c]; }

/// Evaluates the expression in each cell. Labels are sparse: only the shapes listed in a cell are
/// set, and reset afterwards.
SurfaceRegion SurfaceDivision::select(const SetExpression& expression, WindingRule rule,
                                      Context& context) const {
  const std::vector<std::uint32_t> shapes = state_->shapes_of(expression, rule);
  SurfaceRegion region;
  region.generators = state_->polygons_of(shapes);
  std::vector<std::uint8_t> is_in(shape_count());
  for (std::uint32_t c = 0; c < cell_count(); ++c) {
    if (c % kCellsPerCheckpoint == 0) context.checkpoint("select", c, cell_count());
    const auto label = labels(CellId(c));
    for (const SignedEntry& e : label) is_in[e.id] = is_inside(e.value, rule) ? 1 : 0;
    const bool is_selected = plumb::evaluate<bool>(
        expression, [&](std::uint32_t name) { return is_in[shapes[name]] != 0; },
        [](bool a) { return !a; }, apply);
    for (const SignedEntry& e : label) is_in[e.id] = 0;
    region.is_selected.push_back(is_selected ? 1 : 0);
    if (!is_selected) continue;
    ++region.cells;
    region.area = clamped_to_finite(region.area + area(CellId(c)));
  }
  return region;
}

SurfacePolygons SurfaceDivision::borders(const SurfaceRegion& region, Context& context) const {
  return trace_borders(scene().polygons, state_->arrangement, state_->cells, region.is_selected,
                       region.generators, context);
}

SurfaceResult SurfaceDivision::evaluate(const SetExpression& expression, WindingRule rule,
                                        Context& context) const {
  SurfaceRegion region = select(expression, rule, context);
  SurfacePolygons loops = borders(region, context);
  return {std::move(region), std::move(loops)};
}

namespace {

/// How a component of the mesh is covered by the selection.
struct Component {
  bool has_border = false;
  bool has_selected = false;
  bool has_other = false;  ///< Whether a cell of it is not selected.
  bool has_other_at_border = false;
  FaceId first;    ///< The lowest face.
  FaceId outside;  ///< A face whose first corner is in no selected cell.

  /// Whether the borders alone determine a label that is 1 in selected cells and 0 in other cells.
  bool is_usual() const { return !has_selected || (has_border ? has_other_at_border : has_other); }
};

/// Finds how the selection covers each component of the mesh. If the border of a component alone
/// has the wrong meaning, finds a face outside of the selection.
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

SurfaceScene result_scene(const SurfaceDivision& d, const SurfaceResult& result) {
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
}

}  // namespace plumb
