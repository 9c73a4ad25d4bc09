// Closed chains of vertices in a plane: which way they run around, and what lies inside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/convex/part/cut_surface.h"
#include "plumb/sphere/arcs/sphere_arcs.h"

namespace plumb {

/// A side of a ring in the plane n: runs along `along` * (n x n_other), n the canonical normal.
struct RingSide {
  VertexId from;
  VertexId to;
  PlaneId other;
  Sign along;
};

/// A boundary cycle of a face.
std::vector<RingSide> ring_of(const CutSurface& surface, HalfedgeId first);

/// Does it run clockwise, seen from the side that `plane` looks to? Decided at its least vertex.
/// O(length).
bool is_hole(const CutSurface& surface, OrientedPlane plane, std::span<const RingSide> ring);

enum class RingPlace : std::uint8_t { Outside, On, Inside };

/// Where a vertex in the plane lies: by the sides that cross a line through it, parallel to a
/// coordinate plane. O(length).
RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   VertexId v);

/// Where another ring that crosses none of its sides lies: where its first vertex that is not on it
/// does. On: all vertices are.
RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   std::span<const RingSide> other);

// One cut: a piece of a surface divided along the part of a plane section that a reflex edge
// bounds.
//
// Notation
//   T, above     the plane, the side its canonical normal points to
//   section      where T runs strictly inside the solid; its parts are polygons, perhaps with holes
//   segment      a stretch of the section's boundary, with the section to its left seen from above:
//                a chord across a face, or an edge of the surface that lies in T
//   u            the direction n_f x n_T in a face f: what is to its left in f lies below T
//
// Main flow of PlaneCut::run():
//  1. find_sides       of all vertices of the piece
//  2. find_segments    (plane_section.cpp) chords of faces; edges in T with the section on one side
//                      or both
//  3. link_cycles      segments linked around the section's vertices
//  4. select           the cycles of the part with the seed: one around, perhaps holes
//  5. split            (surface_cut.cpp) edges at the ends of chords, then faces along chords
//  6. make_walls       two new faces, one for each side; what they part is no longer joined
//  7. flood            one piece, or two
//
// Only one part of the section is cut, so that lobes of the solid elsewhere stay whole, and the
// surface of either side stays connected: a closed surface that holds one side of a connected wall,
// and not the other, separates them. Source: Chazelle, SIAM J. Comput. 13 (1984), who cuts so.
// Cost: O(size of the piece), and a walk along the section for each vertex that touches T elsewhere
// (is_punctured()).

/// The part of a section that is cut. Scratch memory is kept from cut to cut.
class PlaneSection {
 public:
  /// Where a line enters or leaves a face: at a corner, or across a half-edge.
  struct Event {
    HalfedgeId at;  ///< leaves the vertex; or is crossed
    VertexId vertex;
    bool is_crossing, starts, ends;
    std::uint8_t out_class;        ///< of a corner: where `at` points (plane_section.cpp)
    HalfedgeId first_out;          ///< the chord inserted first,
    std::uint8_t first_class = 0;  ///< and where it points
  };
  struct Segment {
    VertexId from, to;
    CirclePlace place;                         ///< its direction on T
    std::uint32_t start = kNone, end = kNone;  ///< of a chord: events, along u
    FaceId face;                               ///< of a chord
    HalfedgeId half;                           ///< of an edge in T: with the section to its left
    std::uint32_t next = kNone, cycle = kNone;
    HalfedgeId low, high;  ///< of a chord: its halves in the lower and the upper face
  };

  explicit PlaneSection(CutSurface& surface) : s_(surface) {}

  /// The segments of the part that bounds `seed`. False: the section does not reach the seed, its
  /// parts could not be told apart, or a vertex of the surface touches the part from one side.
  bool find(std::span<const FaceId> faces, PlaneId plane, HalfedgeId seed);

  bool is_selected(const Segment& segment) const { return is_selected_[segment.cycle] != 0; }
  /// Where find() failed because of it: the vertex that touches the part.
  VertexId puncture() const { return puncture_; }
  std::vector<Segment>& segments() { return segments_; }
  std::vector<Event>& events() { return events_; }

  /// The sign of n . (n_T x d) for a half in T with direction d, n the normal of its face.
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

  Sign side_of(VertexId v) const { return side_[v.value()]; }

  CutSurface& s_;
  PlaneId plane_;
  std::span<const FaceId> faces_;
  std::vector<Event> events_;
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> first_of_cycle_;
  std::vector<std::uint8_t> is_selected_;  // per cycle
  std::vector<Sign> side_;                 // per vertex, where stamped
  std::vector<std::uint32_t> vertex_stamp_, half_stamp_;
  std::vector<VertexId> crossing_;       // per half, where stamped
  std::vector<VertexId> zeros_;          // vertices in T
  std::vector<std::uint32_t> outgoing_;  // segments by where they leave
  VertexId puncture_;
  std::uint32_t stamp_ = 0;
};

/// The faces of one or two pieces; the one below comes first.
using CutPieces = std::vector<std::vector<FaceId>>;

class PlaneCut {
 public:
  explicit PlaneCut(CutSurface& surface) : s_(surface), section_(surface) {}

  /// Requires a plane through the reflex edge `seed` of the piece. No pieces: nothing was done, see
  /// PlaneSection::find().
  CutPieces run(std::span<const FaceId> faces, PlaneId plane, HalfedgeId seed);
  /// See PlaneSection.
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
  std::vector<HalfedgeId> wall_low_, wall_high_;  // per segment
  std::vector<VertexId> given_;
  std::vector<std::uint32_t> face_stamp_;
  std::uint32_t stamp_ = 0;
};

}  // namespace plumb
