#include "oracle/model_check.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>
#include <vector>

#include "generate/model_program.h"
#include "oracle/model_cells.h"
#include "oracle/nef3_check.h"
#include "plumb/base/nef_set.h"
#include "plumb/csg/evaluate.h"
#include "plumb/io/csg_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/space/canonical.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMostPlanes = 36;

/// A Boolean function of polytopes.
struct PolytopeTree {
  Model::Kind kind;
  IntegerPolytope leaf;
  std::vector<PolytopeTree> children;
};

PolytopeTree polytopes_of(const Model& model, ModelPlanes& planes) {
  PolytopeTree tree{model.kind, {}, {}};
  if (model.kind == Model::Kind::Leaf) tree.leaf = planes.hull_of(model.corners);
  for (const Model& child : model.children) tree.children.push_back(polytopes_of(child, planes));
  return tree;
}

bool contains_cell(const PolytopeTree& tree, const CellSigns& cell) {
  const auto child_has = [&](const PolytopeTree& child) { return contains_cell(child, cell); };
  const auto begin = tree.children.begin(), end = tree.children.end();
  switch (tree.kind) {
    case Model::Kind::Leaf:
      return (cell & tree.leaf.planes) == tree.leaf.above;
    case Model::Kind::Union:
    case Model::Kind::Map:
      return std::any_of(begin, end, child_has);
    case Model::Kind::Intersection:
      return std::all_of(begin, end, child_has);
    default:
      return child_has(*begin) && std::none_of(begin + 1, end, child_has);
  }
}

Nef3 solid_of_text(const std::string& text) {
  return evaluate(read_csg("model.csg", text).tree).solid;
}

/// Evaluates a model node by node, in the order of its text.
Nef3 solid_by_nodes(const Model& model) {
  if (model.kind == Model::Kind::Leaf) return solid_of_text(model.text);
  Nef3 value;
  for (std::size_t i = 0; i < model.children.size(); ++i) {
    Nef3 child = solid_by_nodes(model.children[i]);
    if (model.kind == Model::Kind::Map) child = child.transformed(model.map);
    if (i == 0) {
      value = std::move(child);
    } else if (model.kind == Model::Kind::Difference) {
      value = regularized_difference(value, child);
    } else if (model.kind == Model::Kind::Intersection) {
      value = regularized_intersection(value, child);
    } else {
      value = regularized_union(value, child);
    }
  }
  return value;
}

std::string canonical_text(const Nef3& set) {
  std::ostringstream text;
  write_nef3(text, canonical(set).complex());
  return text.str();
}

/// Returns a plane as a file has it, where coordinates are not multiplied by the unit.
std::array<std::int64_t, 4> plane_in_file(const IntegerPlane& plane) {
  std::array<std::int64_t, 4> numbers{kModelUnit * plane.normal[0], kModelUnit * plane.normal[1],
                                      kModelUnit * plane.normal[2], plane.offset};
  std::int64_t common = 0;
  for (const std::int64_t x : numbers) common = std::gcd(common, x);
  for (std::int64_t& x : numbers) x /= common;
  return numbers;
}

/// Whether all planes of a canonical file, except those of the axes, are planes of the model.
bool has_planes_of_model(const std::string& file, std::span<const IntegerPlane> planes) {
  std::vector<std::array<std::int64_t, 4>> known;
  for (const IntegerPlane& plane : planes) known.push_back(plane_in_file(plane));
  std::istringstream text(file);
  std::string line;
  std::getline(text, line);
  std::size_t count = 0;
  text >> count;
  std::getline(text, line);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::int64_t, 4> plane{};
    for (std::int64_t& x : plane) text >> x;
    if (i >= 3 && std::find(known.begin(), known.end(), plane) == known.end()) return false;
  }
  return static_cast<bool>(text);
}

/// Whether the set has a point, which is given in units.
bool has_point(const Nef3& set, const ExactPoint3& in_units) {
  const ExactPoint3 p = BigRational(1, kModelUnit) * in_units;
  Point3 doubles;
  return as_double(p, doubles) ? set.contains(doubles) : set.contains(to_rational(p));
}

std::string flaw_of_cells(const Nef3& solid, const PolytopeTree& tree,
                          std::span<const IntegerPlane> planes) {
  const ModelCells all = cells_of(planes);
  std::vector<char> is_in;
  for (const ModelCells::Cell& cell : all.cells) {
    is_in.push_back(contains_cell(tree, cell.signs) ? 1 : 0);
    if (has_point(solid, cell.inside) != (is_in.back() != 0)) return "a cell has the wrong mark";
  }
  for (const ModelCells::Corner& corner : all.corners) {
    const bool is_expected = std::any_of(corner.cells.begin(), corner.cells.end(),
                                         [&](std::uint32_t cell) { return is_in[cell] != 0; });
    if (has_point(solid, corner.at) != is_expected) return "a corner has the wrong mark";
  }
  return "";
}

}  // namespace

std::string flaw_of_model(std::span<const std::uint8_t> program) {
  const Model model = model_of_program(program, kMostPlanes);
  if (model.kind == Model::Kind::Union && model.children.empty()) return "";
  const Nef3 solid = solid_of_text(text_of_model(model));
  if (solid.audit()) return "the audit finds a flaw";
  if (!solid.is_closed() || !(solid.regularization() == solid)) return "the set is not regular";
  ModelPlanes planes;
  const PolytopeTree tree = polytopes_of(model, planes);
  const std::string file = canonical_text(solid);
  if (!has_planes_of_model(file, planes.planes())) return "a facet lies in no plane of the model";
  if (const std::string flaw = flaw_of_cells(solid, tree, planes.planes()); !flaw.empty()) {
    return flaw;
  }
  Dice dice(program.size() < 3 ? 0 : program[2]);
  if (canonical_text(solid_of_text(text_of_model(shuffled(model, dice)))) != file) {
    return "another order gives another file";
  }
  return canonical_text(solid_by_nodes(model)) == file ? "" : "single nodes give another file";
}

}  // namespace plumb::testing
