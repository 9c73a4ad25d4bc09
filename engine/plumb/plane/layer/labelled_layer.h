// Layers from labels of faces: the polygons of feature k are the faces with label k.
//
// Main flow:
//  1. rounded_labels   leaves out the edges between equal labels, and rounds the vertices of the
//                      other edges together to doubles (plane_rounding.h)
//  2. layer_of_labels  traces the polygons of each label
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/plane/sweep/sweep.h"

namespace plumb {

/// The label of a face that belongs to no feature.
inline constexpr std::uint32_t kNoLabel = std::numeric_limits<std::uint32_t>::max();

/// A subdivision with a label for each face.
struct LabelledComplex {
  PlaneComplex complex;              ///< The subdivision.
  std::vector<std::uint32_t> label;  ///< For each face, its label, or kNoLabel.
};

/// The labels at both sides of a curve, seen from its lesser end.
struct SideLabels {
  std::uint32_t left;
  std::uint32_t right;
};

/// Returns the arrangement of curves that run from their lesser ends and do not cross, with the
/// labels that the curves state. The points `isolated` become vertices, too.
LabelledComplex labelled_arrangement(const PlanePoints& points, std::span<const SweepCurve> curves,
                                     std::span<const SideLabels> sides,
                                     std::span<const std::uint32_t> isolated, Context& context);

/// Returns the subdivision without the edges between equal labels. Vertices that only such edges
/// met vanish if they are no corners, so pieces of one curve become one edge again. `is_corner` has
/// an entry for each vertex. If it is empty, crossings are no corners, and other vertices are.
LabelledComplex without_inner_edges(const PlaneComplex& complex,
                                    const std::vector<std::uint32_t>& label,
                                    std::span<const std::uint8_t> is_corner, Context& context);

/// A subdivision whose vertices are doubles, and whose neighbouring faces have different labels.
struct RoundedLabels {
  LabelledComplex labelled;      ///< The subdivision.
  PlaneRoundingReport rounding;  ///< The changes that rounding has caused.
};

/// Returns the subdivision of the labels of faces, rounded to doubles. `is_corner` has the same
/// meaning as in without_inner_edges().
RoundedLabels rounded_labels(const PlaneComplex& complex, const std::vector<std::uint32_t>& label,
                             Context& context, std::span<const std::uint8_t> is_corner = {});

/// Returns the layer whose feature k consists of the faces with label k. Requires that all vertices
/// are doubles. The ids, the properties and the coordinate reference system are copied from
/// `named`. If `named` is null, there are none.
Layer layer_of_labels(const LabelledComplex& labelled, std::size_t label_count, const Layer* named,
                      Context& context);

}  // namespace plumb
