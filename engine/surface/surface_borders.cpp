#include "plumb/surface/surface_borders.h"

#include <algorithm>
#include <vector>

namespace plumb {
namespace {

constexpr std::uint32_t kNone = SurfaceArrangement::kNone;
constexpr std::uint32_t kStepsPerCheckpoint = 4096;
constexpr std::uint64_t kStepBytes = 64;  // of a point of a loop

/// A half-edge of the arrangement, or of the mesh in a face that is not touched.
struct Dart {
  bool is_of_mesh;
  HalfedgeId h;
};

class BorderTracer {
 public:
  BorderTracer(const SurfacePolygons& polygons, const SurfaceArrangement& arrangement,
               const SurfaceCells& cells, std::span<const std::uint8_t> is_selected,
               std::span<const std::uint32_t> generators, Context& context)
      : polygons_(polygons),
        mesh_(polygons.points.mesh()),
        a_(arrangement),
        cells_(cells),
        is_selected_(is_selected),
        context_(context),
        charge_(context),
        out_(mesh_),
        is_generator_(polygons.size()) {
    for (const std::uint32_t p : generators) is_generator_[p] = 1;
    find_control_nodes();
  }

  SurfacePolygons run() {
    is_used_.resize(a_.halfedge_count());
    for (std::uint32_t i = 0; i < a_.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (i % kStepsPerCheckpoint == 0) context_.checkpoint("borders", i, a_.halfedge_count());
      if (is_used_[i] == 0 && is_border_arc(h)) trace({false, h});
    }
    return std::move(out_);
  }

 private:
  // ---------------------------------------------------------------- what is where

  void find_control_nodes() {
    is_control_.resize(a_.node_count());
    for (std::uint32_t p = 0; p < polygons_.size(); ++p) {
      for (std::uint32_t i = polygons_.begin[p]; i < polygons_.begin[p + 1]; ++i) {
        if (is_generator_[p] != 0 && polygons_.is_control[i] != 0) {
          is_control_[a_.node_of_entry[i].value()] = 1;
        }
      }
    }
    const auto ends = arc_ends(a_, [&](ArcId a) { return carries_generator(a); });
    for (std::size_t n = 0; n < ends.size(); ++n) {
      if (ends[n] == kCrossingEnds) is_control_[n] = 1;
    }
  }
  bool carries_generator(ArcId a) const {
    return std::ranges::any_of(a_.multiplicities(a),
                               [&](const SignedEntry& e) { return is_generator_[e.id] != 0; });
  }

  bool is_inside(HalfedgeId h) const {
    return is_selected_[cells_.of_piece[a_.piece[h.value()].value()].value()] != 0;
  }
  bool is_border_arc(HalfedgeId h) const {
    const HalfedgeId t = a_.twin[h.value()];
    return a_.arc[h.value()].is_valid() && t.is_valid() && is_inside(h) && !is_inside(t);
  }

  // ---------------------------------------------------------------- walking

  Dart next(Dart d) const {
    return d.is_of_mesh ? Dart{true, SurfaceMesh::next(d.h)} : Dart{false, a_.next[d.h.value()]};
  }
  FaceId face(Dart d) const {
    return d.is_of_mesh ? SurfaceMesh::face(d.h) : a_.face_of(a_.piece[d.h.value()]);
  }

  /// Invalid at the mesh border.
  Dart twin(Dart d) const {
    HalfedgeId side = d.h;
    if (!d.is_of_mesh) {
      if (const HalfedgeId t = a_.twin[d.h.value()]; t.is_valid()) return {false, t};
      side = mesh_halfedge(d.h);
    }
    // No node lies inside an edge of a face that is not touched.
    const HalfedgeId across = mesh_.twin(side);
    if (!across.is_valid()) return {true, across};
    const std::uint32_t slot = a_.slot_of_face[SurfaceMesh::face(across).value()];
    if (slot == kNone) return {true, across};
    return {false, HalfedgeId(a_.side_begin[4 * slot + SurfaceMesh::side(across)])};
  }
  /// The side of its face that a half-edge lies on.
  HalfedgeId mesh_halfedge(HalfedgeId h) const {
    const std::uint32_t slot = a_.piece_slot[a_.piece[h.value()].value()];
    std::size_t side = 0;
    while (a_.side_begin[4 * slot + side + 1] <= h.value()) ++side;
    return SurfaceMesh::halfedge(a_.slot_face[slot], side);
  }

  /// The border after d, with the selected side to the left.
  Dart next_border(Dart d) const {
    for (d = next(d);; d = next(d)) {
      if (!d.is_of_mesh && is_border_arc(d.h)) return d;
      const Dart across = twin(d);
      if (!across.h.is_valid()) return d;
      d = across;
    }
  }

  void trace(Dart first) {
    Dart last = first;
    for (Dart d = next_border(first);; d = next_border(d)) {
      visit(last, d);
      last = d;
      if (!d.is_of_mesh && d.h == first.h) break;
    }
    out_.close();
  }

  /// Adds the segment that starts with d, which follows `last`.
  void visit(Dart last, Dart d) {
    if (++steps_ % kStepsPerCheckpoint == 0) {
      context_.checkpoint("borders", 0, 1);
      charge_.add(kStepBytes * kStepsPerCheckpoint, "borders");
    }
    if (!d.is_of_mesh) is_used_[d.h.value()] = 1;
    if (d.is_of_mesh) {
      out_.add_segment(out_.points.add_vertex(mesh_.origin(d.h)), face(d), false);
      return;
    }
    const NodeId n = a_.origin[d.h.value()];
    const bool is_control = is_control_[n.value()] != 0;
    const bool is_straight = a_.is_crossing(n) && !is_control && !last.is_of_mesh;
    if (is_straight) return;
    out_.add_segment(add_node_point(a_, polygons_.points, n, out_.points), face(d), is_control);
  }

  const SurfacePolygons& polygons_;
  const SurfaceMesh& mesh_;
  const SurfaceArrangement& a_;
  const SurfaceCells& cells_;
  std::span<const std::uint8_t> is_selected_;
  Context& context_;
  MemoryCharge charge_;
  std::size_t steps_ = 0;
  SurfacePolygons out_;
  std::vector<std::uint8_t> is_generator_;  // per polygon
  std::vector<std::uint8_t> is_control_;    // per node
  std::vector<std::uint8_t> is_used_;       // per half-edge
};

}  // namespace

SurfacePolygons trace_borders(const SurfacePolygons& polygons,
                              const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                              std::span<const std::uint8_t> is_selected,
                              std::span<const std::uint32_t> generators, Context& context) {
  return BorderTracer(polygons, arrangement, cells, is_selected, generators, context).run();
}

}  // namespace plumb
