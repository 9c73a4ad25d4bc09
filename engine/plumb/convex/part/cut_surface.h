// The surface of a solid that is being cut, and of all its pieces, in half-edges: one pool of
// arrays that only grows. A piece is a list of faces.
//
// Notation
//   face        A face has an outward plane. Boundary cycles run counter-clockwise seen from
//               outside, holes clockwise.
//   half-edge   A half-edge runs along `along` * (n_f x n_other), n_f the canonical normal of its
//               face's plane. Each half stores its own line, so both copies of an edge on a cut
//               keep their data.
//   marks       A mark belongs to the copy of a cell: it is 1 if the piece owns the cell and the
//               cell belongs to the set. Every point of the surface is owned by one copy, so pieces
//               need no comparison with each other.
//
// The structure is combinatorial, not geometric: a cut that does not separate a piece leaves both
// its sides on one surface, and if the solid touches itself along an edge, each of its wedges has
// an edge of its own. Vertices are points; several rings of half-edges may leave one.
//
// Invariant: the surface of every piece is connected. A cut along one component of a section keeps
// it so (surface_cut.h).
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

/// The pool of half-edges, faces and vertices.
struct CutSurface {
  /// A half-edge: one side of an edge, in the boundary cycle of a face.
  struct Half {
    VertexId origin;
    HalfedgeId next, prev, twin;
    FaceId face;
    /// If this half-edge is the first of a cycle: the first half-edge of the face's next cycle.
    HalfedgeId next_cycle;
    PlaneId other;  ///< The line is where the face's plane and this one meet.
    /// The edge of the solid that this is part of; not valid for edges that only cuts made.
    EdgeId edge;
    std::array<InputPointId, 2> line;  ///< Two input points on the line, if known.
    Sign along = Sign::Positive;
    Mark mark = 0;         ///< Mark of the edge.
    Mark origin_mark = 0;  ///< Mark of the origin.
    bool is_reflex = false;
  };
  /// A face of the surface, or a wall.
  struct Face {
    OrientedPlane plane;
    /// First half-edge of the first cycle.
    HalfedgeId cycle;
    /// Id of the facet it is part of (SpaceComplex::facet_origin), or kWallOrigin.
    std::uint32_t origin;
    Mark mark;
  };

  std::shared_ptr<SpaceTables> tables;
  IdVector<VertexId, SpacePoint> point;  ///< Position of each vertex.
  IdVector<HalfedgeId, Half> halves;
  IdVector<FaceId, Face> faces;
  /// Scratch of set_of_piece(): numbers within the piece at hand.
  IdVector<HalfedgeId, std::uint32_t> half_number;
  IdVector<VertexId, std::uint32_t> vertex_number;

  Half& half(HalfedgeId h) { return halves[h]; }
  const Half& half(HalfedgeId h) const { return halves[h]; }
  Face& face(FaceId f) { return faces[f]; }
  const Face& face(FaceId f) const { return faces[f]; }
  OrientedPlane plane_of(HalfedgeId h) const { return face(half(h).face).plane; }
  VertexId target(HalfedgeId h) const { return half(half(h).next).origin; }
  const PlaneTable& planes() const { return tables->planes; }
  const Point3Table& points() const { return tables->points; }

  /// Calls visit(h) for all half-edges of the face.
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

  /// Whether the solid spans more than half a turn around the edge. Exact.
  bool is_reflex_at(HalfedgeId h) const;
  /// Returns the sign of the turn from the half-edge before h to h, seen from outside.
  Sign turn_at(HalfedgeId h) const;
};

/// Returns the surface of the only marked volume of a set. Returns no value if the volume is
/// unbounded, if its surface is not connected, or if facets, edges or vertices lie inside the
/// volume.
std::optional<CutSurface> cut_surface_of(const SpaceComplex& part);

/// Whether the piece touches itself along an edge, or has both sides of a cut, so that it bounds no
/// set. Edges are distinguished by their vertices, of which a cut makes one for each wedge: for a
/// piece of a surface that touched itself before it was cut, false proves nothing.
bool touches_itself(const CutSurface& surface, std::span<const FaceId> faces);

/// Returns the set of a piece that does not touch itself along an edge, or the closure of that set
/// if `closed`. The set shares the tables.
Nef3 set_of_piece(CutSurface& surface, std::span<const FaceId> faces, bool closed,
                  Context& context);

}  // namespace plumb
