// Scenes of segments, rays, lines and points, and their way into the engine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/plane/sweep/sweep.h"
#include "plumb/testing/dice.h"
#include "plumb/testing/exact.h"

namespace plumb::testing {

/// A segment, ray or line a -> b cut to [from, to]; an end that is missing lies at infinity. Both
/// ends equal: a point.
struct TestCurve {
  ExactPoint a, b;
  std::optional<ExactPoint> from, to;

  bool is_point() const { return from && to && *from == *to; }
  bool contains(const ExactPoint& p) const;
};

struct CurveScene {
  std::vector<TestCurve> curves;
  std::vector<ExactPoint> isolated;
};

/// For messages.
std::string to_text(const CurveScene& scene);

enum class SceneKind {
  Grid,        ///< everything on a few integers: overlaps, equal ends, verticals
  Concurrent,  ///< all lines through one of two points
  Fractions,   ///< thirds and sevenths: no doubles
  Wild,        ///< coordinates of every size a double has
};
inline constexpr SceneKind kSceneKinds[] = {SceneKind::Grid, SceneKind::Concurrent,
                                            SceneKind::Fractions, SceneKind::Wild};

/// Kinds of curves are mixed; some ends are crossings with other lines of the scene.
CurveScene random_curves(SceneKind kind, std::uint32_t curves, std::uint64_t seed);

/// A scene as the engine takes it. Ends that lie on another line of the scene are, half of them,
/// crossings; equal points are, half of them, different indices.
struct EngineScene {
  PlanePoints points;
  std::vector<SweepCurve> curves;
  std::vector<std::uint32_t> isolated;
};
EngineScene to_engine(const CurveScene& scene, std::uint64_t seed);

/// Where two lines cross; none when they are parallel.
std::optional<ExactPoint> crossing_of(const TestCurve& s, const TestCurve& t);

void add_point(PointTable2& points, const ExactPoint& p);

}  // namespace plumb::testing
