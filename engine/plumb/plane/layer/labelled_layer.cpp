// Edges between equal labels are left out, and the pieces of one curve that remain on both sides of
// a left-out crossing become one curve again, so that rounding does not bend borders at crossings
// that are no longer there. What is left is arranged again, rounded as one subdivision, and read
// off face by face. Rounding may remove a narrow face between two faces with equal labels, so edges
// between equal labels are left out once more. Then neighbouring faces have different labels, and
// each face is one polygon.
//
// Tested by tests/plane/layer_test.cpp.
#include "plumb/plane/layer/labelled_layer.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "plumb/plane/arrangement.h"
#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/plane_measure.h"

namespace plumb {
namespace {

/// The edges between faces with different labels, as curves.
class LabelBorders {
 public:
  LabelBorders(const PlaneComplex& complex, const std::vector<std::uint32_t>& label,
               std::span<const std::uint8_t> is_corner)
      : complex_(complex),
        label_(label),
        is_corner_(is_corner),
        degree_(complex.vertex_count(), 0) {
    for (std::size_t e = 0; e < complex.edge_count(); ++e) count(EdgeId(e));
    // Edges are numbered by their left ends, so the first edge of a chain comes first.
    is_taken_.assign(complex.edge_count(), 0);
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      if (is_kept(EdgeId(e)) && is_taken_[e] == 0) add_chain(EdgeId(e));
    }
  }

  const std::vector<SweepCurve>& curves() const { return curves_; }
  const std::vector<SideLabels>& sides() const { return sides_; }

 private:
  std::uint32_t left(EdgeId e) const { return label_[complex_.dcel.face(first_half(e)).value()]; }
  std::uint32_t right(EdgeId e) const {
    return label_[complex_.dcel.face(twin(first_half(e))).value()];
  }
  bool is_kept(EdgeId e) const { return left(e) != right(e); }
  void count(EdgeId e);
  void add_chain(EdgeId first);
  std::optional<EdgeId> continuation(EdgeId e) const;

  const PlaneComplex& complex_;
  const std::vector<std::uint32_t>& label_;
  std::span<const std::uint8_t> is_corner_;
  // For each vertex, the number of kept edges, and the last one that goes to the right.
  std::vector<std::uint32_t> degree_;
  IdVector<VertexId, EdgeId> rightward_ = IdVector<VertexId, EdgeId>(degree_.size());
  std::vector<std::uint8_t> is_taken_;
  std::vector<SweepCurve> curves_;
  std::vector<SideLabels> sides_;
};

void LabelBorders::count(EdgeId e) {
  if (!is_kept(e)) return;
  const HalfedgeId h = first_half(e);
  ++degree_[complex_.dcel.origin(h).value()];
  ++degree_[complex_.dcel.target(h).value()];
  rightward_[complex_.dcel.origin(h)] = e;
}

/// Returns the edge that continues e to the right on the same line, if they meet in a vertex that
/// is no corner and that no other kept edge meets.
std::optional<EdgeId> LabelBorders::continuation(EdgeId e) const {
  const VertexId v = complex_.dcel.target(first_half(e));
  const bool is_corner = is_corner_.empty()
                             ? complex_.vertex_point[v] < complex_.points.inputs.size()
                             : is_corner_[v.value()] != 0;
  if (is_corner || degree_[v.value()] != 2 || !rightward_[v].is_valid()) return {};
  const EdgeId next = rightward_[v];
  const PlaneLine line = complex_.line[e], other = complex_.line[next];
  const PlanePointsView points(complex_.points);
  const bool is_straight =
      line == other || (orient2d(points, line.a, line.b, other.a) == Sign::Zero &&
                        orient2d(points, line.a, line.b, other.b) == Sign::Zero);
  return is_straight ? std::optional(next) : std::nullopt;
}

void LabelBorders::add_chain(EdgeId first) {
  EdgeId last = first;
  for (;;) {
    is_taken_[last.value()] = 1;
    const std::optional<EdgeId> next = continuation(last);
    if (!next) break;
    last = *next;
  }
  const Dcel& dcel = complex_.dcel;
  const PlaneLine line = complex_.line[first];
  curves_.push_back({complex_.vertex_point[dcel.origin(first_half(first))],
                     complex_.vertex_point[dcel.target(first_half(last))], line.a, line.b});
  sides_.push_back({left(first), right(first)});
}

bool has_inner_edges(const LabelledComplex& labelled) {
  const Dcel& dcel = labelled.complex.dcel;
  for (std::size_t e = 0; e < labelled.complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    if (labelled.label[dcel.face(h).value()] == labelled.label[dcel.face(twin(h)).value()]) {
      return true;
    }
  }
  return false;
}

/// Appends the rings of a face as a polygon.
void append_polygon(Layer& layer, const PlaneComplex& complex, FaceId f) {
  for (const std::vector<VertexId>& ring : face_rings(complex, f)) {
    for (const VertexId v : ring) layer.ring_corners.push_back(v.value());
    layer.end_ring();
  }
  layer.end_polygon();
}

}  // namespace

LabelledComplex labelled_arrangement(const PlanePoints& points, std::span<const SweepCurve> curves,
                                     std::span<const SideLabels> sides,
                                     std::span<const std::uint32_t> isolated, Context& context) {
  Arrangement kept = arrange(points, curves, isolated, context);
  LabelledComplex result{std::move(kept.complex), {}};
  result.label.assign(result.complex.face_count(), kNoLabel);
  std::vector<SegmentId> origins;
  for (std::size_t e = 0; e < result.complex.edge_count(); ++e) {
    origins.clear();
    kept.origin_sets.append(kept.origins[e], origins);
    const HalfedgeId h = first_half(EdgeId(e));
    const SideLabels side = sides[origins.front().value()];
    result.label[result.complex.dcel.face(h).value()] = side.left;
    result.label[result.complex.dcel.face(twin(h)).value()] = side.right;
  }
  return result;
}

LabelledComplex without_inner_edges(const PlaneComplex& complex,
                                    const std::vector<std::uint32_t>& label,
                                    std::span<const std::uint8_t> is_corner, Context& context) {
  const LabelBorders borders(complex, label, is_corner);
  return labelled_arrangement(complex.points, borders.curves(), borders.sides(), {}, context);
}

RoundedLabels rounded_labels(const PlaneComplex& complex, const std::vector<std::uint32_t>& label,
                             Context& context, std::span<const std::uint8_t> is_corner) {
  const LabelledComplex kept = without_inner_edges(complex, label, is_corner, context);
  RoundedSubdivision rounded = round_to_doubles(kept.complex, context);
  LabelledComplex result{std::move(rounded.complex), {}};
  for (const FaceId f : rounded.exact_face) result.label.push_back(kept.label[f.value()]);
  // If a narrow face vanishes, the faces beside it may have the same label.
  if (has_inner_edges(result))
    result = without_inner_edges(result.complex, result.label, {}, context);
  return {std::move(result), rounded.report};
}

Layer layer_of_labels(const LabelledComplex& labelled, std::size_t label_count, const Layer* named,
                      Context& context) {
  const PlaneComplex& complex = labelled.complex;
  std::vector<std::pair<std::uint32_t, FaceId>> faces;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (labelled.label[f] != kNoLabel) faces.push_back({labelled.label[f], FaceId(f)});
  }
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.value() < b.second.value();
  });
  Layer layer;
  layer.points.reserve(complex.vertex_count());
  for (const std::uint32_t p : complex.vertex_point) {
    layer.points.push_back(complex.points.inputs.approx(p));
  }
  auto next = faces.begin();
  for (std::uint32_t l = 0; l < label_count; ++l) {
    if (l % kFacesPerCheckpoint == 0) context.checkpoint("polygons", l, label_count);
    for (; next != faces.end() && next->first == l; ++next) {
      append_polygon(layer, complex, next->second);
    }
    layer.end_feature(named == nullptr ? "" : named->id(l),
                      named == nullptr ? "" : named->properties(l));
  }
  return layer;
}

}  // namespace plumb
