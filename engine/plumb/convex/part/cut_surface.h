// The surface of a solid that is being cut, in half-edges, and of all its pieces: one pool of
// arrays that only grows. A piece is a list of faces.
//
// Notation
//   face        outward plane; boundary cycles counter-clockwise seen from outside, holes clockwise
//   half-edge   runs along `along` * (n_f x n_other), n_f the canonical normal of its face's plane.
//               Each half names its line for itself, so both copies of an edge on a cut keep what
//               they had.
//   marks       of the copy: 1 where the piece owns the item and the set has it. Every point of the
//               surface is owned by one copy, so pieces need no comparison with each other.
//
// Combinatorial, not geometric: a cut that does not separate a piece leaves both its sides on one
// surface, and where the solid touches itself along an edge, each of its wedges has an edge of its
// own. Vertices are points; several rings of half-edges may leave one.
//
// Invariant: of a piece, the surface is connected. A cut along one part of a section keeps it so
// (surface_cut.h).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct CutSurface {
  struct Half {
    VertexId origin;
    HalfedgeId next, prev, twin;
    FaceId face;
    HalfedgeId next_cycle;  ///< of the first half-edge of a cycle: that of the next
    PlaneId other;          ///< the line: the face's plane and this one
    EdgeId edge;            ///< of the solid, that it is part of; not valid: of cuts alone
    std::array<InputPointId, 2> line;  ///< two input points on it, where known
    Sign along = Sign::Positive;
    Mark mark = 0;         ///< of the edge
    Mark origin_mark = 0;  ///< of the origin
    bool is_reflex = false;
  };
  struct Face {
    OrientedPlane plane;
    HalfedgeId cycle;
    std::uint32_t origin;  ///< facet_origin
    Mark mark;
  };

  std::shared_ptr<SpaceTables> tables;
  std::vector<SpacePoint> point;  ///< per vertex
  std::vector<Half> halves;
  std::vector<Face> faces;
  /// Scratch of set_of_piece(): numbers in the piece at hand.
  std::vector<std::uint32_t> half_number, vertex_number;

  Half& half(HalfedgeId h) { return halves[h.value()]; }
  const Half& half(HalfedgeId h) const { return halves[h.value()]; }
  Face& face(FaceId f) { return faces[f.value()]; }
  const Face& face(FaceId f) const { return faces[f.value()]; }
  OrientedPlane plane_of(HalfedgeId h) const { return face(half(h).face).plane; }
  VertexId target(HalfedgeId h) const { return half(half(h).next).origin; }
  const PlaneTable& planes() const { return tables->planes; }
  const Point3Table& points() const { return tables->points; }

  /// visit(h) for all half-edges of the face.
  template <class Visit>
  void for_each_half(FaceId f, Visit&& visit) const {
    for (HalfedgeId c = face(f).cycle; c.is_valid(); c = half(c).next_cycle) {
      HalfedgeId h = c;
      do {
        visit(h);
        h = half(h).next;
      } while (h != c);
    }
  }

  /// Is the solid more than half a turn around the edge? Exact.
  bool is_reflex_at(HalfedgeId h) const;
  /// The sign of the turn from the half-edge before to h, seen from outside.
  Sign turn_at(HalfedgeId h) const;
};

/// The surface of the one marked volume of a set. None when a piece could not be held as one: not
/// bounded, not connected, or with facets, edges or vertices inside the volume.
std::optional<CutSurface> cut_surface_of(const SpaceComplex& part);

/// Does the piece touch itself along an edge, or have both sides of a cut? Then no set is bounded
/// by it. Edges are told by their vertices, of which a cut makes one for each wedge: of a piece of
/// a surface that touched itself when it was cut, this need not say so.
bool touches_itself(const CutSurface& surface, std::span<const FaceId> faces);

/// A piece that does not touch itself along an edge, as a set. With `closed`: its closure. The set
/// shares the tables.
Nef3 set_of_piece(CutSurface& surface, std::span<const FaceId> faces, bool closed,
                  Context& context);

}  // namespace plumb
