// Is a rounded mesh of space valid and near? By brute force: every pair of triangles, and exact
// distances.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "plumb/space/valid_mesh.h"

namespace plumb::testing {

/// Whether a triangle has an area.
bool has_area(const PolygonMesh& mesh, std::span<const std::uint32_t> triangle);

/// Whether two triangles, given by their vertices, have a common point outside the vertices and
/// edges that both have. Vertices are equal if their indices are equal. Requires that both have an
/// area.
bool meet_elsewhere(const PolygonMesh& mesh, std::span<const std::uint32_t> a,
                    std::span<const std::uint32_t> b);

/// Whether every vertex of a face of `mesh` is at most `bound` away from a face of `triangles`.
/// Exact coordinates count where a mesh lists them.
bool is_within(const PolygonMesh& mesh, const PolygonMesh& triangles, double bound);

/// Returns the first way in which a mesh is not a valid mesh of numbers of the type, or "": a
/// number is of no such type, an edge is not balanced, a face has no area or is not planar, two
/// faces meet outside common vertices and edges, or its reader has something to say of it.
std::string invalid_mesh(const PolygonMesh& mesh, CoordinateType type);

/// Rounds a set. Returns the first thing that is wrong, or "": the mesh is invalid, farther from
/// the exact boundary than is reported, or changes when it is read and rounded again.
std::string valid_mesh_disagreement(const Nef3& set, CoordinateType type, MeshFaces faces,
                                    ValidMesh* result = nullptr);

/// Makes a scene of bytes (generate/near_solids.h), operation by operation. After each one the set
/// is rounded and checked, and goes on as what was written if the bytes say so.
std::string valid_mesh_of_program_disagreement(std::span<const std::uint8_t> program);

}  // namespace plumb::testing
