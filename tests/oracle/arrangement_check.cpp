#include "oracle/arrangement_check.h"

#include "oracle/plane_graph.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/plane_audit.h"

namespace plumb::testing {
namespace {

bool comes_from(const CurveScene& scene, const ExactPoint& p, std::span<const SegmentId> origins) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    if (!scene.curves[i].contains(p)) continue;
    if (next == origins.size() || origins[next].value() != i) return false;
    ++next;
  }
  return next == origins.size();
}

}  // namespace

std::string disagreement(const CurveScene& scene, std::uint64_t seed) {
  const EngineScene engine = to_engine(scene, seed);
  Context context;
  const Arrangement arrangement = arrange(engine.points, engine.curves, engine.isolated, context);
  if (const auto flaw = audit(arrangement.complex, AuditForm::Any)) {
    return "audit: " + flaw->invariant + " at " + flaw->place;
  }
  const LineCells cells(lines_of(scene));
  const PlaneGraph graph = arrangement_graph(cells, scene);
  const GraphMatch found = match(arrangement.complex, graph, cells);
  if (!found.difference.empty()) return found.difference;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const ExactPoint p = cells[graph.edges[e].cell].point;
    if (!comes_from(scene, p, arrangement.origins_of(found.edge[e]))) {
      return "origins of edge " + std::to_string(found.edge[e].value());
    }
  }
  return "";
}

}  // namespace plumb::testing
