#include "generate/rounding_scenes.h"

#include <cmath>
#include <limits>

#include "plumb/plane/arrangement.h"

namespace plumb::testing {
namespace {

double sign_by(std::uint8_t byte) { return (byte & 1U) != 0 ? -1 : 1; }

/// Returns the coordinate that a byte stands for.
double scene_coordinate(std::uint8_t kind, std::uint8_t byte) {
  const double high = byte >> 4U, low = byte & 15U;
  switch (kind) {
    case 0:  // Decimals.
      return (byte - 100) * 0.1;
    case 1:  // A cluster near 1.
      return 1 + low * 0x1p-52 + (high > 12 ? high : 0);
    case 2:  // Small integers and their neighbours: long edges that are nearly parallel.
      return high + (low - 8) * 0x1p-52 * std::max(high, 1.0);
    case 3:  // Subnormals.
      return (byte - 128) * std::numeric_limits<double>::denorm_min();
    case 4:  // Spikes: far apart in one coordinate, close in the other.
      return byte < 128 ? byte * 0x1p-54 : byte - 128;
    case 5:  // A huge range.
      return sign_by(byte) * std::ldexp(1 + (byte % 7) / 8.0, (byte - 128) * 8);
    case 6:  // The largest doubles.
      return sign_by(byte) * std::numeric_limits<double>::max() * ((255 - byte) / 256.0);
    default:  // Near zero beside large.
      return byte < 64 ? byte * 1e-17 : byte < 128 ? byte * 0.37 : byte * 1e5 / 3;
  }
}

Point2 scene_point(std::uint8_t how, std::uint8_t x, std::uint8_t y) {
  const std::uint8_t kind = how & 7U;
  // Bit 3: the ordinate is of the next kind.
  const auto other = static_cast<std::uint8_t>((kind + ((how >> 3U) & 1U)) & 7U);
  return {scene_coordinate(kind, x), scene_coordinate(other, y)};
}

}  // namespace

PlaneComplex rounding_scene(std::span<const std::uint8_t> program) {
  PlanePoints points;
  std::vector<SweepCurve> curves;
  std::vector<std::uint32_t> stops;
  std::vector<std::uint8_t> how;
  for (std::size_t i = 0; i + kRoundingRecord <= program.size(); i += kRoundingRecord) {
    const auto r = program.subspan(i, kRoundingRecord);
    const auto from = static_cast<std::uint32_t>(points.inputs.size());
    points.inputs.push_back(scene_point(r[0], r[1], r[2]));
    points.inputs.push_back(scene_point(r[0], r[3], r[4]));
    curves.push_back({from, from + 1, from, from + 1});
    how.push_back(r[0]);
    if ((r[0] & 128U) != 0) stops.push_back(from);
  }
  Arrangement arrangement = arrange(points, curves, stops);
  PlaneComplex complex = std::move(arrangement.complex);
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    const std::uint8_t byte = program[(f * 7 + 5) % program.size()];
    complex.marks.face[f] = (byte >> (f % 5)) & 1U;
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const SegmentId s : arrangement.origins_of(EdgeId(e))) {
      if ((how[s.value()] & 64U) != 0) complex.marks.edge[e] = 1;
    }
  }
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    complex.marks.vertex[v] = complex.dcel.is_isolated(VertexId(v)) ? 1 : 0;
  }
  return complex;
}

std::vector<std::uint8_t> random_rounding_program(Dice& dice, std::size_t segments) {
  std::vector<std::uint8_t> program;
  const auto kind = static_cast<std::uint8_t>(dice.below(16));
  const bool mixes = dice.below(4) == 0;
  const auto any_byte = [&dice] { return static_cast<std::uint8_t>(dice.below(256)); };
  for (std::size_t i = 0; i < segments; ++i) {
    const auto flags = static_cast<std::uint8_t>(dice.below(8) == 0 ? dice.below(16) << 4U : 0);
    const std::size_t before = program.size();
    program.push_back(static_cast<std::uint8_t>((mixes ? dice.below(16) : kind) | flags));
    for (std::size_t c = 1; c < kRoundingRecord; ++c) {
      // Ends are often those of the segment before, so that there are rings and fans.
      const bool repeats = before >= kRoundingRecord && c < 3 && dice.below(2) == 0;
      program.push_back(repeats ? program[before - kRoundingRecord + c + 2] : any_byte());
    }
  }
  return program;
}

}  // namespace plumb::testing
