// Both layers are arranged as one layer, in which the features of the first layer come first. A
// list of features is ascending. So the pair of a face consists of the first entry of its list, and
// of the first entry from the second layer. Pairs get their numbers in sorted order; a pair that
// vanishes by rounding loses its number afterwards.
//
// Tested by tests/plane/layer_operations_test.cpp.
#include "plumb/plane/layer_overlay.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/arithmetic/rational_sum.h"

namespace plumb {
namespace {

using Pair = LayerOverlay::Pair;

/// Returns the features of both layers as one layer without ids and properties.
Layer both_layers(const Layer& first, const Layer& second) {
  Layer both;
  for (const Layer* const layer : {&first, &second}) {
    const auto offset = static_cast<std::uint32_t>(both.points.size());
    both.points.append(layer->points);
    std::size_t polygon = 0;
    for (std::size_t f = 0; f < layer->feature_count(); ++f) {
      for (; polygon < layer->feature_begin[f + 1]; ++polygon) {
        for (std::size_t r = layer->polygon_begin[polygon]; r < layer->polygon_begin[polygon + 1];
             ++r) {
          for (const std::uint32_t c : layer->ring(r)) both.ring_corners.push_back(offset + c);
          both.end_ring();
        }
        both.end_polygon();
      }
      both.end_feature("", "");
    }
  }
  return both;
}

/// Returns the pair of a face, or nothing if the pair is not kept. `firsts` is the number of
/// features of the first layer.
std::optional<Pair> pair_of(FeatureList features, std::uint32_t firsts, OverlayPairs kept) {
  Pair pair{kNoLabel, kNoLabel};
  if (!features.empty() && features.front() < firsts) pair.first = features.front();
  const auto second = std::lower_bound(features.begin(), features.end(), firsts);
  if (second != features.end()) pair.second = *second - firsts;
  const bool has_first = pair.first != kNoLabel, has_second = pair.second != kNoLabel;
  const bool is_kept = kept == OverlayPairs::All     ? has_first || has_second
                       : kept == OverlayPairs::Both  ? has_first && has_second
                       : kept == OverlayPairs::First ? has_first
                                                     : has_first && !has_second;
  return is_kept ? std::optional(pair) : std::nullopt;
}

/// The pairs that occur, and the number of the pair of each face.
struct FacePairs {
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> label;
};

FacePairs face_pairs(const CoveredCells& cells, std::uint32_t firsts, OverlayPairs kept) {
  const auto is_less = [](const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  };
  const std::size_t faces = cells.complex().face_count();
  FacePairs result;
  for (std::size_t f = 0; f < faces; ++f) {
    const auto pair = pair_of(cells.features(FaceId(f)), firsts, kept);
    if (pair) result.pairs.push_back(*pair);
  }
  std::sort(result.pairs.begin(), result.pairs.end(), is_less);
  result.pairs.erase(std::unique(result.pairs.begin(), result.pairs.end()), result.pairs.end());
  for (std::size_t f = 0; f < faces; ++f) {
    const auto pair = pair_of(cells.features(FaceId(f)), firsts, kept);
    if (!pair) {
      result.label.push_back(kNoLabel);
      continue;
    }
    const auto at = std::lower_bound(result.pairs.begin(), result.pairs.end(), *pair, is_less);
    result.label.push_back(static_cast<std::uint32_t>(at - result.pairs.begin()));
  }
  return result;
}

std::vector<Rational> areas_of(const PlaneComplex& complex, const FacePairs& faces,
                               Context& context) {
  std::vector<RationalSum> sums(faces.pairs.size());
  for (std::size_t f = 0; f < faces.label.size(); ++f) {
    if (f % kFacesPerCheckpoint == 0) context.checkpoint("areas", f, faces.label.size());
    if (faces.label[f] == kNoLabel) continue;
    sums[faces.label[f]].add(face_area(complex, FaceId(f)).value_or(0));
  }
  std::vector<Rational> areas;
  for (const RationalSum& sum : sums) areas.push_back(sum.total());
  return areas;
}

/// Removes the pairs that have no face in the rounded subdivision, and renumbers the others.
void remove_vanished(LayerOverlay& overlay, std::vector<std::uint32_t>& label) {
  std::vector<std::uint32_t> number(overlay.pairs.size(), kNoLabel);
  for (const std::uint32_t l : label) {
    if (l != kNoLabel) number[l] = 0;
  }
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == kNoLabel) {
      overlay.vanished.push_back(overlay.pairs[i]);
      continue;
    }
    overlay.pairs[count] = overlay.pairs[i];
    if (!overlay.area.empty()) std::swap(overlay.area[count], overlay.area[i]);
    number[i] = count++;
  }
  overlay.pairs.resize(count);
  if (!overlay.area.empty()) overlay.area.resize(count);
  for (std::uint32_t& l : label) {
    if (l != kNoLabel) l = number[l];
  }
}

}  // namespace

LayerOverlay overlay_layers(const Layer& first, const Layer& second,
                            const LayerOverlayOptions& options, Context& context) {
  const auto firsts = static_cast<std::uint32_t>(first.feature_count());
  const auto count = static_cast<std::uint32_t>(firsts + second.feature_count());
  const CoveredCells cells(both_layers(first, second), context);
  FacePairs faces = face_pairs(cells, firsts, options.pairs);
  LayerOverlay overlay;
  if (options.with_areas) overlay.area = areas_of(cells.complex(), faces, context);
  overlay.first_overlaps = count_overlaps(cells, {0, firsts}, {});
  overlay.second_overlaps = count_overlaps(cells, {firsts, count}, {});
  RoundedLabels rounded = rounded_labels(cells.complex(), faces.label, context);
  overlay.rounding = rounded.rounding;
  overlay.pairs = std::move(faces.pairs);
  remove_vanished(overlay, rounded.labelled.label);
  overlay.layer = layer_of_labels(rounded.labelled, overlay.pairs.size(), nullptr, context);
  overlay.layer.crs = first.crs.empty() ? second.crs : first.crs;
  return overlay;
}

}  // namespace plumb
