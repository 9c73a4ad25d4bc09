#include "surface_input.h"

#include <algorithm>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/set_expression.h"
#include "plumb/io/scene_reader.h"
#include "plumb/surface/surface_homology.h"

namespace plumb::cli {
namespace {

/// Adds generators of the homology to shapes until every one separates.
std::vector<SurfaceRepair> repair(SurfaceScene& scene, Context& context) {
  const SurfaceHomology homology(*scene.mesh, context);
  if (!scene.shapes) {
    scene.shapes.emplace();
    for (std::uint32_t p = 0; p < scene.polygons.size(); ++p) scene.shapes->push_back({p});
  }
  std::vector<SurfaceRepair> repairs;
  for (std::uint32_t s = 0; s < scene.shapes->size(); ++s) {
    std::vector<std::uint32_t>& shape = (*scene.shapes)[s];
    if (s % 64 == 0) context.checkpoint("homology", s, scene.shapes->size());
    std::vector<std::int64_t> before = homology.class_of(scene.polygons, shape, context);
    if (std::ranges::all_of(before, [](std::int64_t k) { return k == 0; })) continue;
    std::vector<std::uint32_t> added = homology.add_repair(shape, scene.polygons, context);
    context.charge_memory(before.size() * sizeof(std::int64_t), "loops that repair");
    shape.insert(shape.end(), added.begin(), added.end());
    repairs.push_back({s, std::move(before), std::move(added)});
  }
  return repairs;
}

}  // namespace

void SurfaceInput::declare(CLI::App& app) {
  app.add_option("SCENE", file_, "A scene: .json; - is standard input")->required()->type_name("");
  app.add_flag("--repair", repairs_,
               "Add loops around handles to shapes that do not separate, so that they do");
}

void SurfaceInput::declare_expression(CLI::App& app, bool is_required) {
  CLI::Option* const op =
      app.add_option("--op", expression_,
                     "+ union, * intersection, - difference, ^ symmetric, ! complement of shapes "
                     "A, B .. or s0, s1 ..")
          ->type_name("EXPR");
  if (is_required) op->required();
  app.add_option("--rule", rule_, "Labels inside: evenodd (default), nonzero, positive")
      ->type_name("RULE")
      ->check(CLI::IsMember({"evenodd", "nonzero", "positive"}).description(""));
}

DividedScene SurfaceInput::read(Session& session) const {
  session.begin("read");
  SceneFile file = read_scene_file(file_, {.exact_decimals = session.options().exact_decimals},
                                   session.context());
  for (const std::string& note : file.notes) session.note(note);
  std::vector<SurfaceRepair> repairs;
  if (repairs_) repairs = repair(file.scene, session.context());
  session.begin("divide");
  return {SurfaceDivision(std::move(file.scene), session.context()), file.model,
          std::move(repairs)};
}

SurfaceResult SurfaceInput::evaluate(const SurfaceDivision& division, Context& context) const {
  const WindingRule rule = rule_ == "nonzero"    ? WindingRule::NonZero
                           : rule_ == "positive" ? WindingRule::Positive
                                                 : WindingRule::EvenOdd;
  try {
    return division.evaluate(parse_set_expression(expression_), rule, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadArgument && error.code() != ErrorCode::Syntax) throw;
    throw Error(ErrorCode::Usage, "--op '" + expression_ + "': " + error.message());
  }
}

}  // namespace plumb::cli
