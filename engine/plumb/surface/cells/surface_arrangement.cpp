// Slicing: the subdivision of a surface by polygons, and its nodes.
//
// NodeMaker sorts the entries of all polygons by place and parameters, so equal points become one
// node, and the nodes of an edge are consecutive and ascend by t. slice() then divides the segments
// into two kinds. Segments along a mesh edge are added up on the intervals between the nodes of
// this edge. Other segments are added up by face and end nodes, so equal segments become one
// segment with the sum of their multiplicities. Segments that cancel each other disappear before
// anything is intersected. Each touched face is arranged in its own parameter plane
// (face_arrangement.h) and written to the flat arrays; half-edges on both sides of a mesh edge are
// matched by position, because both faces have the same nodes along it.
//
// The result does not depend on coordinates of space: docs/design/surface.md, sections A face is a
// plane and Slicing.
// Tested by tests/surface/surface_arrangement_test.cpp and tests/surface/surface_plane_test.cpp.
#include "plumb/surface/cells/surface_arrangement.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "plumb/predicates/segment2.h"
#include "plumb/surface/cells/face_arrangement.h"

namespace plumb {

bool SurfaceBundles::add_sum(std::span<SignedEntry> terms) {
  std::sort(terms.begin(), terms.end());
  const std::size_t before = entries_.size();
  for (std::size_t i = 0; i < terms.size();) {
    const std::uint32_t id = terms[i].id;
    std::int64_t sum = 0;
    for (; i < terms.size() && terms[i].id == id; ++i) sum += terms[i].value;
    if (sum != 0) entries_.push_back({id, entry_value(sum)});
  }
  if (entries_.size() == before) return false;
  begin_.push_back(static_cast<std::uint32_t>(entries_.size()));
  return true;
}

RationalPoint2 exact_crossing(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, const SurfaceCrossing& c) {
  const auto at = [&](std::size_t i) {
    return points.exact_in(arrangement.node_point[c.ends[i]], c.face);
  };
  return crossing_point(RationalSegment2{at(0), at(1)}, RationalSegment2{at(2), at(3)});
}

RationalPoint2 exact_node(const SurfaceArrangement& arrangement, const SurfacePointTable& points,
                          NodeId node, FaceId f) {
  if (arrangement.is_crossing(node)) {
    return exact_crossing(arrangement, points, arrangement.crossing(node));
  }
  if (arrangement.is_input(node)) return points.exact_in(arrangement.input(node), f);
  const VertexId v = arrangement.corner(node);
  const SurfaceMesh& mesh = points.mesh();
  return {mesh.corner(f, 1) == v ? 1 : 0, mesh.corner(f, 2) == v ? 1 : 0};
}

SurfacePointId add_node_point(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, NodeId node, SurfacePointTable& to) {
  if (arrangement.is_crossing(node)) {
    const SurfaceCrossing& c = arrangement.crossing(node);
    const RationalPoint2 at = exact_crossing(arrangement, points, c);
    return to.add_in_face(c.face, at.x, at.y);
  }
  if (!arrangement.is_input(node)) return to.add_vertex(arrangement.corner(node));
  const SurfacePointId p = arrangement.input(node);
  switch (points.place(p)) {
    case SurfacePlace::Vertex:
      return to.add_vertex(points.vertex(p));
    case SurfacePlace::Edge:
      return to.add_on_edge(points.edge(p), points.exact(p).x);
    case SurfacePlace::Face:
      break;
  }
  const RationalPoint2 at = points.exact(p);
  return to.add_in_face(points.face(p), at.x, at.y);
}

namespace {

// The memory of an arc with its half-edges, nodes and pieces.
constexpr std::uint64_t kArcBytes = 160;
constexpr std::uint64_t kEntryBytes = 600;  // The memory of an entry of a polygon.
constexpr std::uint64_t kFaceBytes = 24;
// The memory of a use while the list grows, and of its sum.
constexpr std::uint64_t kUseBytes = 60;
constexpr std::size_t kStepsPerCheckpoint = 65536;

/// A polygon along something between two numbers: a piece of an edge (edge, interval), or a segment
/// of a face between two nodes. `value` is +1 upwards, from the lower node to the higher.
struct Use {
  std::uint32_t item;  ///< Edge or face.
  std::uint32_t low;
  std::uint32_t high;
  SignedEntry polygon;
  bool is_with(const Use& u) const { return item == u.item && low == u.low && high == u.high; }
  friend bool operator<(const Use& a, const Use& b) {
    return std::tie(a.item, a.low, a.high, a.polygon) < std::tie(b.item, b.low, b.high, b.polygon);
  }
};

/// The sum of some uses. The remainder extends along (item, low, high).
struct Strand {
  std::uint32_t item;
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t bundle;
};

/// Adds up equal uses, and returns the sums that are not zero.
std::vector<Strand> add_up(std::vector<Use>& uses, SurfaceBundles& bundles) {
  std::sort(uses.begin(), uses.end());
  std::vector<Strand> strands;
  std::vector<SignedEntry> terms;
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    terms.clear();
    for (; j < uses.size() && uses[j].is_with(uses[i]); ++j) terms.push_back(uses[j].polygon);
    if (!bundles.add_sum(terms)) continue;
    strands.push_back(
        {uses[i].item, uses[i].low, uses[i].high, static_cast<std::uint32_t>(bundles.size() - 1)});
  }
  return strands;
}

/// The parts of polygons along mesh edges and across faces.
struct Uses {
  std::vector<Use> runs;      ///< Uses of intervals between the nodes of mesh edges.
  std::vector<Use> segments;  ///< Uses of segments that cross faces.
  std::size_t count = 0;      ///< Number of segments of the polygons that have a length.
};

/// Makes the uses of all segments. A segment whose ends lie on a common side of its face extends
/// along that mesh edge. Any other segment crosses the face. This is a class because both lists
/// grow at the same time and share one charge, which is increased in steps.
class UseGatherer {
 public:
  UseGatherer(const SurfacePolygons& polygons, const SurfaceNodes& nodes, MemoryCharge& charge,
              Context& context)
      : polygons_(polygons),
        mesh_(polygons.points.mesh()),
        nodes_(nodes),
        charge_(charge),
        context_(context) {}

  Uses run() {
    for (std::uint32_t p = 0; p < polygons_.size(); ++p) {
      for (std::uint32_t i = polygons_.begin[p]; i < polygons_.begin[p + 1]; ++i) {
        const NodeId from = nodes_.of_entry[i], to = nodes_.of_entry[polygons_.next(p, i)];
        if (from == to) continue;
        if (++uses_.count % kStepsPerCheckpoint == 0) charge_uses();
        const FaceId f = polygons_.face[i];
        const unsigned common = sides(from, f) & sides(to, f);
        if (common == 0) {
          const auto [low, high] = std::minmax(from, to);
          uses_.segments.push_back({f.value(), low.value(), high.value(), {p, from < to ? 1 : -1}});
        } else {
          const std::size_t side = (common & 1U) != 0 ? 0 : ((common & 2U) != 0 ? 1 : 2);
          add_run(mesh_.edge(SurfaceMesh::halfedge(f, side)), p, from, to);
        }
      }
    }
    charge_uses();
    return std::move(uses_);
  }

 private:
  bool is_on_edge(NodeId n) const { return n.value() < nodes_.vertices_begin; }
  bool is_vertex(NodeId n) const {
    return n.value() >= nodes_.vertices_begin && n.value() < nodes_.faces_begin;
  }
  SurfacePointId point(NodeId n) const { return nodes_.point[n]; }

  /// Returns the sides of a face that contain a node, as bits.
  unsigned sides(NodeId n, FaceId f) const {
    if (is_on_edge(n)) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (mesh_.edge(SurfaceMesh::halfedge(f, i)) == polygons_.points.edge(point(n))) {
          return 1U << i;
        }
      }
    }
    if (is_vertex(n)) {
      constexpr unsigned kAtCorner[] = {0b101, 0b011, 0b110};
      for (std::size_t i = 0; i < 3; ++i) {
        if (mesh_.corner(f, i) == polygons_.points.vertex(point(n))) return kAtCorner[i];
      }
    }
    return 0;
  }

  void charge_uses() {
    context_.checkpoint("slice", 0, 1);
    const std::size_t uses = uses_.runs.size() + uses_.segments.size();
    charge_.add(kUseBytes * (uses - charged_uses_), "runs along edges");
    charged_uses_ = uses;
  }

  /// Returns the place of a node on an edge: 0 for the lower vertex, then the nodes inside, then
  /// the higher vertex.
  std::uint32_t place_on(EdgeId e, NodeId n) const {
    if (is_on_edge(n)) return n.value() - nodes_.first_on(e) + 1;
    return polygons_.points.vertex(point(n)) == mesh_.lower(e) ? 0 : nodes_.count_on(e) + 1;
  }
  void add_run(EdgeId e, std::uint32_t polygon, NodeId from, NodeId to) {
    const std::uint32_t i = place_on(e, from), j = place_on(e, to);
    for (std::uint32_t k = std::min(i, j); k < std::max(i, j); ++k) {
      uses_.runs.push_back({e.value(), k, 0, {polygon, i < j ? 1 : -1}});
      if (uses_.runs.size() % kStepsPerCheckpoint == 0) charge_uses();
    }
  }

  const SurfacePolygons& polygons_;
  const SurfaceMesh& mesh_;
  const SurfaceNodes& nodes_;
  MemoryCharge& charge_;
  Context& context_;
  std::size_t charged_uses_ = 0;
  Uses uses_;
};

/// Returns the faces at edges and vertices with nodes, and the faces with segments, in ascending
/// order.
std::vector<FaceId> touched_faces(const SurfacePolygons& polygons, const SurfaceNodes& nodes,
                                  const std::vector<Strand>& segments) {
  const SurfaceMesh& mesh = polygons.points.mesh();
  IdVector<FaceId, std::uint8_t> is_touched(mesh.face_count());
  for (const EdgeId e : nodes.edges) {
    const HalfedgeId h = mesh.halfedge(e);
    is_touched[SurfaceMesh::face(h)] = 1;
    if (!mesh.is_border(h)) is_touched[SurfaceMesh::face(mesh.twin(h))] = 1;
  }
  for (std::uint32_t n = nodes.vertices_begin; n < nodes.faces_begin; ++n) {
    const HalfedgeId first = mesh.halfedge(polygons.points.vertex(nodes.point[n]));
    for (HalfedgeId h = first; h.is_valid();) {
      is_touched[SurfaceMesh::face(h)] = 1;
      h = mesh.twin(SurfaceMesh::prev(h));
      if (h == first) break;
    }
  }
  for (const Strand& s : segments) is_touched[s.item] = 1;
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < is_touched.size(); ++f) {
    if (is_touched[f] != 0) faces.push_back(FaceId(f));
  }
  return faces;
}

/// Returns the slot of each face of the mesh, or kNone.
IdVector<FaceId, std::uint32_t> slots_of_faces(const SurfaceMesh& mesh,
                                               const std::vector<FaceId>& slot_face) {
  IdVector<FaceId, std::uint32_t> slot_of_face(mesh.face_count(), kNone);
  for (std::uint32_t slot = 0; slot < slot_face.size(); ++slot) {
    slot_of_face[slot_face[slot]] = slot;
  }
  return slot_of_face;
}

/// Makes nodes of the corners of touched faces that are not input points, and returns their
/// vertices. Enters these nodes in `nodes.of_vertex`.
std::vector<VertexId> number_corners(const SurfaceMesh& mesh, const std::vector<FaceId>& faces,
                                     SurfaceNodes& nodes) {
  std::vector<VertexId> corners;
  for (const FaceId f : faces) {
    for (const std::uint32_t v : mesh.corners(f)) {
      if (nodes.of_vertex[v].is_valid()) continue;
      nodes.of_vertex[v] = NodeId(nodes.point.size() + corners.size());
      corners.push_back(VertexId(v));
    }
  }
  return corners;
}

/// Appends an arc along a half-edge, and stores its id at the half-edge and its twin.
void add_arc(HalfedgeId h, std::uint32_t bundle, SurfaceArrangement& out) {
  const ArcId a(out.arc_halfedge.size());
  out.arc_halfedge.push_back(h);
  out.arc_bundle.push_back(bundle);
  out.arc[h] = a;
  if (const HalfedgeId t = out.twin[h]; t.is_valid()) out.arc[t] = a;
}

/// Arranges touched faces and appends them to the flat arrays. This is a class because all faces
/// share one FaceArrangement and the tables between its local ids and nodes. Their memory is
/// reused.
class FaceWriter {
 public:
  /// Requires that the slots and corners of `out` are complete.
  FaceWriter(const SurfacePolygons& polygons, const SurfaceNodes& nodes, MemoryCharge& charge,
             Context& context, SurfaceArrangement& out)
      : polygons_(polygons),
        mesh_(polygons.points.mesh()),
        nodes_(nodes),
        charge_(charge),
        context_(context),
        crossings_begin_(nodes.point.size() + out.corner_vertex.size()),
        out_(out) {}

  /// Faces are arranged one after the other with one FaceArrangement, in the order of their slots,
  /// which is also that of the segments.
  void run(const std::vector<Strand>& segments) {
    local_of_node_.resize(crossings_begin_);
    std::size_t at = 0;
    out_.loop_begin.push_back(0);
    for (std::uint32_t slot = 0; slot < out_.slot_face.size(); ++slot) {
      if (slot % 1024 == 0) context_.checkpoint("slice", slot, out_.slot_face.size());
      const FaceId f = out_.slot_face[slot];
      face_.clear();
      node_of_local_.clear();
      add_ring(f);
      for (; at < segments.size() && segments[at].item == f.value(); ++at) {
        const Strand& s = segments[at];
        face_.segments.push_back(
            {add_point(NodeId(s.low), f), add_point(NodeId(s.high), f), s.bundle, 1});
      }
      face_.run(out_.bundles, context_);
      charge_.add(kArcBytes * face_.arcs.size(), "an arrangement on a surface");
      emit(slot);
    }
    out_.piece_begin.push_back(PieceId(out_.piece_slot.size()));
  }

 private:
  void add_local(NodeId n) {
    local_of_node_[n] = static_cast<std::uint32_t>(node_of_local_.size());
    node_of_local_.push_back(n);
  }
  /// Lists the nodes along the boundary of a face, counter-clockwise from corner 0. Nodes of an
  /// edge come in ascending order of t, or descending if the face runs down the edge.
  void add_ring(FaceId f) {
    constexpr Point2 kCorners[] = {{0, 0}, {1, 0}, {0, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
      const HalfedgeId h = SurfaceMesh::halfedge(f, i);
      out_.side_begin.push_back(
          static_cast<std::uint32_t>(out_.origin.size() + node_of_local_.size()));
      if (i == 1) face_.corner_1 = static_cast<std::uint32_t>(node_of_local_.size());
      add_local(nodes_.of_vertex[mesh_.origin(h)]);
      face_.points.inputs.push_back(kCorners[i]);
      const EdgeId e = mesh_.edge(h);
      const std::uint32_t count = nodes_.count_on(e);
      for (std::uint32_t j = 0; j < count; ++j) {
        const NodeId n(nodes_.first_on(e) + (mesh_.is_upward(h) ? j : count - 1 - j));
        add_local(n);
        polygons_.points.append_local(nodes_.point[n], f, face_.points.inputs);
      }
    }
    face_.ring_size = static_cast<std::uint32_t>(node_of_local_.size());
    out_.side_begin.push_back(static_cast<std::uint32_t>(out_.origin.size() + face_.ring_size));
  }
  /// Returns the local id of a node. A point inside of the face is added when it is first needed.
  std::uint32_t add_point(NodeId n, FaceId f) {
    const std::uint32_t known = local_of_node_[n];
    if (known < node_of_local_.size() && node_of_local_[known] == n) return known;
    add_local(n);
    polygons_.points.append_local(nodes_.point[n], f, face_.points.inputs);
    return local_of_node_[n];
  }

  /// Appends half-edges, arcs and pieces of the face to the flat arrays. Half-edges keep their
  /// order, so the half-edges along the sides are found by position.
  void emit(std::uint32_t slot) {
    name_crossings(slot);
    const auto base = static_cast<std::uint32_t>(out_.origin.size());
    const auto pieces = static_cast<std::uint32_t>(out_.piece_slot.size());
    out_.piece_begin.push_back(PieceId(pieces));
    for (std::uint32_t h = 0; h < face_.halfedge_count(); ++h) {
      out_.origin.push_back(node_of_local_[face_.origin(h)]);
      out_.next.push_back(HalfedgeId(std::size_t{base} + face_.next[h]));
      out_.piece.push_back(PieceId(std::size_t{pieces} + face_.piece[h]));
      out_.twin.push_back({});
      out_.arc.push_back({});
    }
    for (std::uint32_t a = 0; a < face_.arcs.size(); ++a) {
      const HalfedgeId h(std::size_t{base} + face_.ring_size + std::size_t{2} * a);
      const HalfedgeId g(h.value() + std::size_t{1});
      out_.twin[h] = g;
      out_.twin[g] = h;
      add_arc(face_.arcs[a].sign > 0 ? h : g, face_.arcs[a].bundle, out_);
    }
    emit_pieces(slot, base);
  }

  /// Makes crossings in which arcs end nodes, in the order of arcs.
  void name_crossings(std::uint32_t slot) {
    const PlanePoints& points = face_.points;
    node_of_local_.resize(points.size());
    for (const FaceArc& a : face_.arcs) {
      for (const std::uint32_t p : {a.from, a.to}) {
        if (p < points.inputs.size() || node_of_local_[p].is_valid()) continue;
        node_of_local_[p] = NodeId(crossings_begin_ + out_.crossings.size());
        const Crossing2& c = points.crossings[p - points.inputs.size()];
        out_.crossings.push_back(
            {out_.slot_face[slot],
             {node_of_local_[c.a], node_of_local_[c.b], node_of_local_[c.c], node_of_local_[c.d]},
             {c.x, c.y},
             c.radius});
      }
    }
  }

  void emit_pieces(std::uint32_t slot, std::uint32_t base) {
    double twice_area = 0;
    for (std::size_t i = 0; i < face_.loops.size(); ++i) {
      const FaceArrangement::Loop& l = face_.loops[i];
      if (!l.is_hole) {
        if (i > 0) end_piece(slot, twice_area);
        twice_area = 0;
      }
      twice_area += twice_loop_area(l.halfedge);
      out_.loop.push_back(HalfedgeId(std::size_t{base} + l.halfedge));
    }
    end_piece(slot, twice_area);
  }
  void end_piece(std::uint32_t slot, double twice_area) {
    out_.piece_slot.push_back(slot);
    out_.piece_share.push_back(std::clamp(twice_area, 0.0, 1.0));
    out_.loop_begin.push_back(static_cast<std::uint32_t>(out_.loop.size()));
  }
  /// Returns twice the signed area of a loop in (u, v); the whole face has 1.
  double twice_loop_area(std::uint32_t first) const {
    const Point2 o = approx(PlanePointsView(face_.points), face_.origin(first));
    double sum = 0;
    Point2 last{0, 0};
    for (std::uint32_t h = face_.next[first]; h != first; h = face_.next[h]) {
      const Point2 p = approx(PlanePointsView(face_.points), face_.origin(h));
      const Point2 v{p.x - o.x, p.y - o.y};
      sum += last.x * v.y - last.y * v.x;
      last = v;
    }
    return sum;
  }

  const SurfacePolygons& polygons_;
  const SurfaceMesh& mesh_;
  const SurfaceNodes& nodes_;
  MemoryCharge& charge_;
  Context& context_;
  std::size_t crossings_begin_;
  SurfaceArrangement& out_;
  FaceArrangement face_;
  std::vector<NodeId> node_of_local_;
  IdVector<NodeId, std::uint32_t> local_of_node_;
};

/// Returns the j-th half-edge along a side of a touched face, or an invalid id if the face is not
/// touched.
HalfedgeId on_side(const SurfaceArrangement& out, HalfedgeId h, std::uint32_t j) {
  const std::uint32_t slot = out.slot_of_face[SurfaceMesh::face(h)];
  if (slot == kNone) return {};
  return HalfedgeId(out.side_begin[4 * slot + SurfaceMesh::side(h)] + j);
}

/// Both faces at a mesh edge have the same nodes along it, in opposite order, so the j-th
/// half-edge from one end is the twin of the j-th from the other.
void sew(const SurfaceMesh& mesh, const SurfaceNodes& nodes, SurfaceArrangement& out) {
  for (const FaceId f : out.slot_face) {
    for (std::size_t i = 0; i < 3; ++i) {
      const HalfedgeId h = SurfaceMesh::halfedge(f, i);
      if (mesh.is_border(h)) continue;
      const std::uint32_t count = nodes.count_on(mesh.edge(h));
      for (std::uint32_t j = 0; j <= count; ++j) {
        out.twin[on_side(out, h, j)] = on_side(out, mesh.twin(h), count - j);
      }
    }
  }
}

/// Appends the negative of a bundle and returns its index.
std::uint32_t add_negated(std::uint32_t bundle, SurfaceBundles& bundles) {
  const auto entries = bundles[bundle];
  std::vector<SignedEntry> terms(entries.begin(), entries.end());
  for (SignedEntry& e : terms) e.value = -e.value;
  bundles.add_sum(terms);
  return static_cast<std::uint32_t>(bundles.size() - 1);
}

/// Assigns the sums along mesh edges to the half-edges there. At the border, only one half-edge
/// exists. If it leads downward, the sum is negated.
void lay_runs(const SurfaceMesh& mesh, const SurfaceNodes& nodes, const std::vector<Strand>& runs,
              SurfaceArrangement& out) {
  for (const Strand& run : runs) {
    const EdgeId e(run.item);
    HalfedgeId h = mesh.halfedge(e);
    std::uint32_t bundle = run.bundle;
    if (!mesh.is_upward(h)) {
      if (mesh.is_border(h)) {
        bundle = add_negated(bundle, out.bundles);
      } else {
        h = mesh.twin(h);
      }
    }
    const std::uint32_t j = mesh.is_upward(h) ? run.low : nodes.count_on(e) - run.low;
    add_arc(on_side(out, h, j), bundle, out);
  }
}

}  // namespace

SurfaceArrangement slice(const SurfacePolygons& polygons, Context& context) {
  const SurfaceMesh& mesh = polygons.points.mesh();
  MemoryCharge charge(context);
  charge.add(kEntryBytes * polygons.point.size() + kFaceBytes * mesh.face_count(),
             "an arrangement on a surface");
  SurfaceNodes nodes = make_nodes(polygons, context);
  Uses uses = UseGatherer(polygons, nodes, charge, context).run();
  SurfaceArrangement out;
  out.segments = uses.count;
  const std::vector<Strand> runs = add_up(uses.runs, out.bundles);
  const std::vector<Strand> segments = add_up(uses.segments, out.bundles);
  out.slot_face = touched_faces(polygons, nodes, segments);
  out.slot_of_face = slots_of_faces(mesh, out.slot_face);
  out.corner_vertex = number_corners(mesh, out.slot_face, nodes);
  FaceWriter(polygons, nodes, charge, context, out).run(segments);
  sew(mesh, nodes, out);
  lay_runs(mesh, nodes, runs, out);
  out.node_point = std::move(nodes.point);
  out.node_of_entry = std::move(nodes.of_entry);
  return out;
}

namespace {

constexpr const char* kPhase = "slice";
// This is the number of comparisons between checkpoints.
constexpr std::uint64_t kComparisons = 65536;

/// An entry of the polygons. Entries are sorted by place, then by edge, vertex or face, and then by
/// parameters.
struct Entry {
  std::uint32_t rank;  ///< Order of the place.
  std::uint32_t item;
  double x;
  std::uint32_t entry;
};

class NodeMaker {
 public:
  NodeMaker(const SurfacePolygons& polygons, Context& context)
      : polygons_(polygons), points_(polygons.points), context_(context) {}

  SurfaceNodes run() {
    gather();
    std::sort(entries_.begin(), entries_.end(),
              [&](const Entry& a, const Entry& b) { return is_before(a, b); });
    context_.checkpoint(kPhase, 1, 2);
    number();
    index_edges();
    index_vertices();
    return std::move(nodes_);
  }

 private:
  void gather() {
    entries_.reserve(polygons_.point.size());
    for (std::uint32_t i = 0; i < polygons_.point.size(); ++i) {
      const SurfacePointId p = polygons_.point[i];
      switch (points_.place(p)) {
        case SurfacePlace::Edge:
          entries_.push_back({0, points_.edge(p).value(), points_.approx(p).x, i});
          break;
        case SurfacePlace::Vertex:
          entries_.push_back({1, points_.vertex(p).value(), 0, i});
          break;
        case SurfacePlace::Face:
          entries_.push_back({2, points_.face(p).value(), points_.approx(p).x, i});
          break;
      }
    }
  }

  /// Compares two entries. If the rounded parameters differ, they have the right order. Only if
  /// they are equal, the exact parameters are compared.
  Sign compare(const Entry& a, const Entry& b) const {
    if (std::tie(a.rank, a.item, a.x) < std::tie(b.rank, b.item, b.x)) return Sign::Negative;
    if (std::tie(b.rank, b.item, b.x) < std::tie(a.rank, a.item, a.x)) return Sign::Positive;
    const std::uint32_t p = polygons_.point[a.entry].value(), q = polygons_.point[b.entry].value();
    return p == q ? Sign::Zero : compare_xy(points_.parameters(), p, q);
  }
  bool is_before(const Entry& a, const Entry& b) {
    if (++comparisons_ % kComparisons == 0) context_.checkpoint(kPhase, 0, 2);
    const Sign order = compare(a, b);
    return order == Sign::Zero ? a.entry < b.entry : order == Sign::Negative;
  }

  void number() {
    nodes_.of_entry.resize(entries_.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (i % kComparisons == 0) context_.checkpoint(kPhase, 1, 2);
      if (i == 0 || compare(entries_[i - 1], entries_[i]) != Sign::Zero) {
        nodes_.point.push_back(polygons_.point[entries_[i].entry]);
      }
      nodes_.of_entry[entries_[i].entry] = NodeId(nodes_.point.size() - 1);
    }
    const auto first_of = [&](SurfacePlace place) {
      const auto is_earlier = [&](SurfacePointId p) {
        return points_.place(p) == SurfacePlace::Edge ||
               (place == SurfacePlace::Face && points_.place(p) == SurfacePlace::Vertex);
      };
      return static_cast<std::uint32_t>(
          std::partition_point(nodes_.point.begin(), nodes_.point.end(), is_earlier) -
          nodes_.point.begin());
    };
    nodes_.vertices_begin = first_of(SurfacePlace::Vertex);
    nodes_.faces_begin = first_of(SurfacePlace::Face);
  }

  void index_edges() {
    nodes_.slot_of_edge.assign(points_.mesh().edge_count(), kNone);
    for (std::uint32_t n = 0; n < nodes_.vertices_begin; ++n) {
      const EdgeId e = points_.edge(nodes_.point[n]);
      if (!nodes_.edges.empty() && nodes_.edges.back() == e) continue;
      nodes_.slot_of_edge[e] = static_cast<std::uint32_t>(nodes_.edges.size());
      nodes_.edges.push_back(e);
      nodes_.edge_begin.push_back(n);
    }
    nodes_.edge_begin.push_back(nodes_.vertices_begin);
  }

  void index_vertices() {
    nodes_.of_vertex.assign(points_.mesh().vertex_count(), NodeId{});
    for (std::uint32_t n = nodes_.vertices_begin; n < nodes_.faces_begin; ++n) {
      nodes_.of_vertex[points_.vertex(nodes_.point[n])] = NodeId(n);
    }
  }

  const SurfacePolygons& polygons_;
  const SurfacePointTable& points_;
  Context& context_;
  std::uint64_t comparisons_ = 0;
  std::vector<Entry> entries_;
  SurfaceNodes nodes_;
};

}  // namespace

SurfaceNodes make_nodes(const SurfacePolygons& polygons, Context& context) {
  return NodeMaker(polygons, context).run();
}

}  // namespace plumb
