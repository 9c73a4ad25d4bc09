#include "plumb/plane/plane_scene.h"

#include <utility>

namespace plumb {
namespace {

void append_crossings(const PlanePoints& from, const std::vector<std::uint32_t>& to,
                      PlanePoints& points) {
  for (Crossing2 c : from.crossings) {
    c.a = to[c.a];
    c.b = to[c.b];
    c.c = to[c.c];
    c.d = to[c.d];
    points.crossings.push_back(c);
  }
}

void append_complex(const PlaneComplex& complex, const std::vector<std::uint32_t>& to,
                    std::uint32_t operand, JoinedScene& joined) {
  const std::uint32_t flag = operand == 0 ? 0 : BooleanRule::kSecondOperand;
  const auto point = [&](VertexId v) {
    return complex.is_at_infinity(v) ? SweepCurve::kUnbounded : to[complex.vertex_point[v.value()]];
  };
  for (std::uint32_t i = 0; i < complex.vertex_count(); ++i) {
    const VertexId v(i);
    joined.vertex_at[point(v)] = i | flag;
    if (complex.dcel.is_isolated(v)) joined.scene.stops.push_back(point(v));
  }
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const HalfedgeId h = first_half(EdgeId(i));
    const PlaneLine& line = complex.line[i];
    joined.scene.curves.push_back(
        {point(complex.dcel.origin(h)), point(complex.dcel.target(h)), to[line.a], to[line.b]});
    joined.sides.push_back(
        {complex.dcel.face(h).value(), complex.dcel.face(twin(h)).value(), EdgeId(i), operand});
  }
}

}  // namespace

JoinedPoints join_points(std::span<const PlaneComplex* const> complexes) {
  JoinedPoints joined;
  joined.to.resize(complexes.size());
  for (std::size_t k = 0; k < complexes.size(); ++k) {
    const PointTable2& inputs = complexes[k]->points.inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      joined.to[k].push_back(static_cast<std::uint32_t>(joined.points.inputs.size() + i));
    }
    joined.points.inputs.append(inputs);
  }
  for (std::size_t k = 0; k < complexes.size(); ++k) {
    const PlanePoints& points = complexes[k]->points;
    const std::size_t first = joined.points.size();
    for (std::size_t i = 0; i < points.crossings.size(); ++i) {
      joined.to[k].push_back(static_cast<std::uint32_t>(first + i));
    }
    append_crossings(points, joined.to[k], joined.points);
  }
  return joined;
}

JoinedScene join_scene(std::span<const PlaneComplex* const> complexes) {
  JoinedPoints points = join_points(complexes);
  JoinedScene joined;
  joined.vertex_at.assign(points.points.size(), BooleanRule::kNoVertex);
  std::size_t edges = 0;
  for (const PlaneComplex* c : complexes) edges += c->edge_count();
  joined.scene.curves.reserve(edges);
  joined.sides.reserve(edges);
  for (std::size_t k = 0; k < complexes.size(); ++k) {
    append_complex(*complexes[k], points.to[k], static_cast<std::uint32_t>(k), joined);
  }
  joined.scene.points = std::move(points.points);
  return joined;
}

}  // namespace plumb
