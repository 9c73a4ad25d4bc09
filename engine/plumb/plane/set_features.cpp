// The set is an additional feature of the layer, after all sources. A face belongs to the set if
// its list of features ends with this feature, and its list begins with the first source that
// covers it.
//
// Tested by tests/plane/set_features_test.cpp.
#include "plumb/plane/set_features.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/plane/plane_faces.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

/// Appends the rings and polygons of features first, ..., last - 1, whose points are in the layer
/// from `offset` on. Does not end a feature.
void append_polygons(Layer& to, const Layer& from, std::size_t first, std::size_t last,
                     std::uint32_t offset) {
  for (std::size_t p = from.feature_begin[first]; p < from.feature_begin[last]; ++p) {
    for (std::size_t r = from.polygon_begin[p]; r < from.polygon_begin[p + 1]; ++r) {
      for (const std::uint32_t c : from.ring(r)) to.ring_corners.push_back(offset + c);
      to.end_ring();
    }
    to.end_polygon();
  }
}

/// Returns the number of points of the layer, after which those of `more` are appended.
std::uint32_t append_points(Layer& to, const Layer& more) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() / 2;
  const std::size_t offset = to.points.size();
  if (offset + more.points.size() > kMost ||
      to.ring_corners.size() + more.ring_corners.size() > kMost) {
    throw Error(ErrorCode::ResourceLimit, "more corners than a layer can have");
  }
  to.points.append(more.points);
  return static_cast<std::uint32_t>(offset);
}

/// Returns the label of each face: the source of the face, `rest` if only the set contains the
/// face, or kNoLabel.
std::vector<std::uint32_t> labels_of(const CoveredCells& cells, std::uint32_t rest) {
  std::vector<std::uint32_t> label(cells.complex().face_count(), kNoLabel);
  for (std::size_t f = 0; f < label.size(); ++f) {
    const FeatureList features = cells.features(FaceId(f));
    if (!features.empty() && features.back() == rest) label[f] = features.front();
  }
  return label;
}

/// Leaves out features without polygons.
void keep_occupied(Layer parts, const Layer& sources, SetFeatures& result) {
  Layer& layer = result.layer;
  layer.points = std::move(parts.points);
  for (std::uint32_t f = 0; f < parts.feature_count(); ++f) {
    if (parts.feature_begin[f] == parts.feature_begin[f + 1]) continue;
    append_polygons(layer, parts, f, f + 1, 0);
    const bool is_source = f < sources.feature_count();
    layer.end_feature(is_source ? sources.id(f) : "", is_source ? sources.properties(f) : "");
    result.source.push_back(is_source ? f : LayerRegion::kNobody);
  }
}

/// Whether the set has edges or isolated vertices that are not on the border of a marked face. The
/// complex of a set is minimal, so a marked isolated vertex lies in an unmarked face.
bool has_thin_parts(const Nef2& set) {
  const PlaneComplex& complex = set.complex();
  const auto is_beside_face = [&](HalfedgeId h) { return complex.mark(complex.dcel.face(h)); };
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    if (complex.mark(EdgeId(e)) && !is_beside_face(h) && !is_beside_face(twin(h))) return true;
  }
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    if (complex.mark(VertexId(v)) && complex.dcel.is_isolated(VertexId(v))) return true;
  }
  return false;
}

}  // namespace

void append_layer(Layer& layer, const Layer& more) {
  const std::uint32_t offset = append_points(layer, more);
  if (layer.crs.empty()) layer.crs = more.crs;
  for (std::size_t f = 0; f < more.feature_count(); ++f) {
    append_polygons(layer, more, f, f + 1, offset);
    layer.end_feature(more.id(f), more.properties(f));
  }
}

SetFeatures set_features(const Nef2& set, const Layer& sources, Context& context) {
  const auto rest = static_cast<std::uint32_t>(sources.feature_count());
  Layer all;
  append_layer(all, sources);
  const Layer faces = layer_of_faces(set, context);
  append_polygons(all, faces, 0, faces.feature_count(), append_points(all, faces));
  all.end_feature("", "");
  const CoveredCells cells(all, context);
  const std::vector<std::uint32_t> label = labels_of(cells, rest);
  const RoundedLabels rounded = rounded_labels(cells.complex(), label, context);
  SetFeatures result;
  result.layer.crs = sources.crs;
  result.rounding = rounded.rounding;
  result.is_unbounded = !set.is_bounded();
  result.has_thin_parts = has_thin_parts(set);
  keep_occupied(layer_of_labels(rounded.labelled, std::size_t{rest} + 1, nullptr, context), sources,
                result);
  std::vector<std::uint8_t> had_part(std::size_t{rest} + 1, 0);
  for (const std::uint32_t l : label) {
    if (l != kNoLabel) had_part[l] = 1;
  }
  for (const std::uint32_t f : result.source) had_part[std::min(f, rest)] = 0;
  for (std::uint32_t f = 0; f < rest; ++f) {
    if (had_part[f] != 0) result.vanished.push_back(f);
  }
  return result;
}

}  // namespace plumb
