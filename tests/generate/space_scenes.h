// Complexes built item by item: facets with holes, free edges, lone vertices, as a test wants them.
//
// The items of a scene must be those of a complex: they meet only where one bounds the other or is
// listed as inner to it. Nothing is merged and nothing is checked.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "plumb/space/space_complex.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

struct SceneFacet {
  /// The outer cycle first, in either direction; holes run against it.
  std::vector<std::vector<std::uint32_t>> cycles;
  std::vector<std::uint32_t> inner;
};

struct SpaceScene {
  std::vector<RationalPoint3> points;  ///< all different; those without facet and edge are alone
  std::vector<SceneFacet> facets;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> free_edges;

  /// Corners counter-clockwise or clockwise. Points are shared with what is there already.
  void add_facet(const std::vector<RationalPoint3>& corners,
                 const std::vector<std::vector<RationalPoint3>>& holes = {});
  void add_free_edge(const RationalPoint3& a, const RationalPoint3& b);
  std::uint32_t add_point(const RationalPoint3& p);
};

RationalPoint3 rational_point(int x, int y, int z);
RationalPoint3 operator+(const RationalPoint3& a, const RationalPoint3& b);
RationalPoint3 operator*(const Rational& s, const RationalPoint3& a);
RationalPoint3 cross(const RationalPoint3& a, const RationalPoint3& b);
Rational dot(const RationalPoint3& a, const RationalPoint3& b);

/// Everything of the complex: vertices are the points of the scene in order, facets and free edges
/// too; volumes by label_volumes(); all marks 0.
SpaceComplex complex_of(const SpaceScene& scene);
/// Without volumes.
SpaceComplex complex_without_volumes(const SpaceScene& scene);

/// A cuboid's six facets, outside of it or (a void) inside: the same scene.
void add_box(SpaceScene& scene, const RationalPoint3& low, const RationalPoint3& high);
void add_tetrahedron(SpaceScene& scene, const std::array<RationalPoint3, 4>& corners);
/// A box with a square shaft from bottom to top; two facets have a hole.
void add_frame_box(SpaceScene& scene, const RationalPoint3& low, const RationalPoint3& high);

/// What stands for the frame's R in finite scenes.
inline constexpr int kFar = 1000000;
/// The cube |x|, |y|, |z| <= kFar cut by planes x = at + slope y, which part it into slabs.
void add_slabs(SpaceScene& scene, const std::vector<int>& at, const Rational& slope);
/// The same complex with R for kFar; what lies on the cube gets the mark kBeyond. Every vertex
/// there must be the common point of planes of its edges.
SpaceComplex framed(SpaceComplex complex);

/// A scene of disjoint pieces with small rational coordinates: boxes, tetrahedra, boxes in boxes,
/// boxes with a shaft, polygons, chains and points; everything shifted and sheared the same way.
SpaceScene random_scene(Dice& dice);

}  // namespace plumb::testing
