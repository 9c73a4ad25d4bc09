// One cut of a piece of a surface along a plane, and the rings of vertices in a plane that the cut
// needs: the direction of a ring, and the vertices inside it.
//
// Notation
//   T, above     T is the plane; above is the side its canonical normal points to
//   section      where T runs strictly inside the solid; its components are polygons, perhaps with
//                holes
//   segment      a stretch of the section's boundary, with the section to its left seen from above:
//                a chord across a face, or an edge of the surface that lies in T
//   u            the direction n_f x n_T in a face f: what is to its left in f lies below T
//
// Main flow of PlaneCut::run():
//  1. find_sides       finds the sides of all vertices of the piece
//  2. find_segments    finds chords of faces, and edges in T with the section on one side or both
//                      (plane_section.cpp)
//  3. link_cycles      links segments around the section's vertices
//  4. select           takes the cycles of the component with the seed: one around, perhaps holes
//  5. split            splits edges at the ends of chords, then faces along chords
//                      (surface_cut.cpp)
//  6. make_walls       adds two new faces, one for each side; what they separate is no longer
//                      joined
//  7. flood            collects one piece, or two
//
// Only one component of the section is cut, so that lobes of the solid elsewhere stay whole, and
// the surface of either side stays connected: a closed surface that holds one side of a connected
// wall and not the other separates them. Source: B. Chazelle, SIAM J. Comput. 13 (1984), who cuts
// the same way. Cost: O(size of the piece), and a walk along the section for each vertex that
// touches T elsewhere (is_punctured()).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/convex/part/cut_surface.h"
#include "plumb/sphere/arcs/sphere_arcs.h"

namespace plumb {

/// A side of a ring in the plane n. It runs along `along` * (n x n_other), n the canonical normal.
struct RingSide {
  VertexId from;
  VertexId to;
  PlaneId other;
  Sign along;
};

/// Returns the boundary cycle of a face that begins with `first`.
std::vector<RingSide> ring_of(const CutSurface& surface, HalfedgeId first);

/// Whether the ring runs clockwise, seen from the side that `plane` looks to. Decided by the turns
/// at its least vertex. Cost: O(length).
bool is_hole(const CutSurface& surface, OrientedPlane plane, std::span<const RingSide> ring);

/// Where a vertex or ring lies with respect to a ring.
enum class RingPlace : std::uint8_t { Outside, On, Inside };

/// Returns where a vertex in the plane lies: the winding number by the sides that cross a line
/// through it, parallel to a coordinate plane. Cost: O(length).
RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   VertexId v);

/// Returns where another ring lies that crosses none of its sides: where the first vertex lies that
/// is not on the ring. Returns On if all vertices are on it.
RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   std::span<const RingSide> other);

/// The component of a section that is cut. Scratch memory is kept from cut to cut.
class PlaneSection {
 public:
  /// Where a line enters or leaves a face: at a corner, or across a half-edge.
  struct Event {
    HalfedgeId at;  ///< The half-edge that leaves the vertex, or that is crossed.
    VertexId vertex;
    bool is_crossing, starts, ends;
    /// At a corner: the class of directions in which `at` points (plane_section.cpp).
    std::uint8_t out_class;
    HalfedgeId first_out;          ///< The chord that was inserted first,
    std::uint8_t first_class = 0;  ///< Class in which that chord points.
  };
  /// A stretch of the section's boundary.
  struct Segment {
    VertexId from, to;
    CirclePlace place;                         ///< Its direction on T.
    std::uint32_t start = kNone, end = kNone;  ///< Events of a chord, in the order along u.
    FaceId face;                               ///< The face of a chord.
    HalfedgeId half;  ///< An edge in T: the half-edge with the section to its left.
    std::uint32_t next = kNone, cycle = kNone;
    HalfedgeId low, high;  ///< Half-edges of a chord in the lower and the upper face.
  };

  explicit PlaneSection(CutSurface& surface) : s_(surface) {}

  /// Finds the segments of the component that bounds `seed`. Returns false if the section does not
  /// reach the seed, its components could not be separated, or a vertex of the surface touches the
  /// component from one side (puncture()).
  bool find(std::span<const FaceId> faces, PlaneId plane, HalfedgeId seed);

  // Whether the segment belongs to the component that is cut.
  bool is_selected(const Segment& segment) const { return is_selected_[segment.cycle] != 0; }
  /// Returns the vertex that touches the component if find() failed because of it; else an invalid
  /// id.
  VertexId puncture() const { return puncture_; }
  std::vector<Segment>& segments() { return segments_; }
  std::vector<Event>& events() { return events_; }

  /// Returns the sign of n . (n_T x d) for a half-edge in T with direction d, n the outward normal
  /// of its face.
  Sign lean(HalfedgeId h) const;

 private:
  void find_sides();
  void find_segments();
  void find_chords(FaceId f);
  void add_corner(FaceId f, HalfedgeId h);
  std::uint8_t class_of(FaceId f, HalfedgeId h, VertexId end, bool is_reversed) const;
  void pair_events(FaceId f, std::size_t first);
  VertexId crossing(HalfedgeId h);
  void add_edge(HalfedgeId h);
  void add_edge_segment(HalfedgeId h);

  void link_cycles();
  std::uint32_t clockwise_next(const Segment& in, std::span<const std::uint32_t> out) const;
  bool select(HalfedgeId seed);
  bool select_part(std::uint32_t seed_cycle);
  bool is_punctured();
  std::vector<RingSide> ring_of(std::uint32_t first) const;

  Sign side_of(VertexId v) const { return side_[v]; }

  CutSurface& s_;
  PlaneId plane_;
  std::span<const FaceId> faces_;
  std::vector<Event> events_;
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> first_of_cycle_;
  std::vector<std::uint8_t> is_selected_;  // Per cycle.
  IdVector<VertexId, Sign> side_;          // Valid if stamped.
  IdVector<VertexId, std::uint32_t> vertex_stamp_;
  IdVector<HalfedgeId, std::uint32_t> half_stamp_;
  IdVector<HalfedgeId, VertexId> crossing_;  // Valid if stamped.
  std::vector<VertexId> zeros_;              // Vertices in T.
  std::vector<std::uint32_t> outgoing_;      // Segments, sorted by the vertex that they leave.
  VertexId puncture_;
  std::uint32_t stamp_ = 0;
};

/// The faces of one or two pieces. The piece below the plane comes first.
using CutPieces = std::vector<std::vector<FaceId>>;

/// Cuts pieces of one surface along planes. Scratch memory is kept from cut to cut.
class PlaneCut {
 public:
  explicit PlaneCut(CutSurface& surface) : s_(surface), section_(surface) {}

  /// Cuts a piece and returns the faces of one or two pieces. Requires a plane through the reflex
  /// edge `seed` of the piece. Returns no pieces if nothing was done (PlaneSection::find()).
  CutPieces run(std::span<const FaceId> faces, PlaneId plane, HalfedgeId seed);
  /// Returns PlaneSection::puncture() of the last cut.
  VertexId puncture() const { return section_.puncture(); }

 private:
  using Event = PlaneSection::Event;
  using Segment = PlaneSection::Segment;

  void split_edges();
  void split_edge(HalfedgeId h, VertexId at);
  void split_faces();
  HalfedgeId corner_of(const Event& event, std::uint8_t direction) const;
  void insert_chord(Segment& segment);
  void share_cycles(FaceId f, std::span<const HalfedgeId> chords);
  void share_holes(FaceId f, std::span<const HalfedgeId> cycles);
  FaceId new_face(const CutSurface::Face& like);
  void set_cycle(FaceId f, HalfedgeId first);

  void make_walls();
  void add_walls(std::uint32_t first, FaceId low, FaceId high);
  HalfedgeId add_wall_half(const Segment& segment, FaceId face, bool is_low);
  void join_walls();
  void join(HalfedgeId a, HalfedgeId b, Mark mark);
  void join_edge(HalfedgeId h, const Segment* left, const Segment* right);
  void give_vertices();
  void give_vertex(HalfedgeId wall_half, bool is_low);
  void set_origin_marks(HalfedgeId first, Mark mark);
  CutPieces flood(std::span<const FaceId> faces);

  CutSurface& s_;
  PlaneSection section_;
  PlaneId plane_;
  std::vector<FaceId> new_faces_;
  std::vector<HalfedgeId> wall_low_, wall_high_;  // Half-edges of the walls, per segment.
  std::vector<VertexId> given_;
  IdVector<FaceId, std::uint32_t> face_stamp_;
  std::uint32_t stamp_ = 0;
};

}  // namespace plumb
