// The half-edge structure shared by plane, sphere and surface maps (a doubly connected edge list).
//
// Topology only: no coordinates here; geometry and marks are parallel arrays of the owner, indexed by
// VertexId, EdgeId, FaceId. Half-edges come in pairs: edge e has half-edges 2e and 2e+1, twin = xor 1.
//
//   half-edge h : origin(h), next(h), prev(h), loop(h); its face lies to its left
//   loop l      : one boundary cycle of a face: first half-edge, or an isolated vertex; next loop of
//                 the same face
//   face f      : first loop (which loop is the outer one is geometry, known to the owner)
//   vertex v    : one half-edge leaving it, or its isolated loop
//
// A half-edge knows its loop, a loop its face: merging two faces touches loops, not half-edges.
//
// Building (1) and editing (2):
//  1. Dcel::from_cycles      listed cycles of vertex ids, every directed edge used once, twins present
//  2. Euler operators, each undone by its partner:
//     add_vertex/remove_vertex          an isolated vertex in a face
//     add_edge/remove_edge              between two corners: within a loop splits the loop, between
//                                       two loops of one face joins them
//     split_edge/join_edge              a vertex of degree 2 inside an edge
//     split_face/join_faces             moves chosen loops into a new face and back
//  3. audit                             every invariant from scratch
//
// Deleted elements leave holes until compact(). All operations O(1) unless said otherwise.
// Source: Muller and Preparata 1978; Mäntylä's Euler operators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumb/base/ids.h"

namespace plumb {

constexpr HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value() ^ 1U); }
constexpr EdgeId edge_of(HalfedgeId h) { return EdgeId(h.value() >> 1U); }

class Dcel;  // full class: to be written by its owner (see the flow above)

}  // namespace plumb
