// The shells of a complex: the connected components of the boundaries of its volumes.
//
// Consider a point that moves along the boundary of a volume without leaving the closure of the
// volume. A shell consists of all parts of the boundary that such a point can reach. The point
// moves on the sides of facets that face the volume, across edges to the next such side, and across
// vertices. Free edges and isolated vertices are parts of shells, too. If a facet has the same
// volume on both sides, both of its sides are parts of shells of that volume. The boundary of a
// volume is the union of its shells. A bounded volume has one outer shell. In addition, it has one
// inner shell for each connected part of the boundary that lies inside, such as the boundary of a
// void.
//
// In an unbounded set, all parts of the boundary of one volume that reach to infinity belong to the
// same shell, because the frame connects them. Cells of the frame and the volume outside the frame
// are not listed.
//
// Cost: O(n alpha(n)) for n cells, where alpha is the inverse Ackermann function. The cells of a
// shell are returned as spans, or are passed to a visitor by visit().
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"
#include "plumb/space/to_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

using ShellId = StrongId<struct ShellTag>;  ///< The id of a shell.

/// The shells of all volumes of a complex.
class SpaceShells {
 public:
  /// Finds the shells. Requires that the complex has volumes. The complex must outlive this object.
  /// Cost: O(n alpha(n)) for n cells.
  explicit SpaceShells(const SpaceComplex& complex);

  /// Returns the number of shells. Shells are ordered by volume. The shells of one volume are
  /// ordered by their lexicographically least vertex. So the outer shell of a bounded volume is the
  /// first shell of this volume. If all vertices of a shell belong to the frame, the shell has no
  /// listed vertices, and is the last shell of its volume.
  std::size_t size() const { return volume_.size(); }
  /// Returns the shells of a volume, in ascending order.
  std::span<const ShellId> shells_of(VolumeId v) const;
  /// Returns the volume that a shell bounds.
  VolumeId volume(ShellId s) const { return volume_[s.value()]; }

  /// Returns the sides of facets that make up the shell. Each side is seen from outside the volume.
  /// So FacetSide::is_reversed is true if the volume lies on the positive side of the facet.
  std::span<const FacetSide> sides(ShellId s) const { return part(sides_, side_begin_, s); }
  /// Returns the edges of the shell: the edges of its facets, and its free edges. Each edge occurs
  /// once.
  std::span<const EdgeId> edges(ShellId s) const { return part(edges_, edge_begin_, s); }
  /// Returns the vertices of the shell: the vertices of its facets and edges, and its isolated
  /// vertices. Each vertex occurs once.
  std::span<const VertexId> vertices(ShellId s) const { return part(vertices_, vertex_begin_, s); }

  /// Calls the visitor first with every FacetSide of a shell, then with every EdgeId, and finally
  /// with every VertexId. If the visitor does not accept one of these types, the cells of this type
  /// are skipped.
  template <class Visitor>
  void visit(ShellId s, Visitor&& visitor) const {
    visit_all(sides(s), visitor);
    visit_all(edges(s), visitor);
    visit_all(vertices(s), visitor);
  }

  const SpaceComplex& complex() const { return complex_; }  ///< Returns the complex.

 private:
  template <class T, class Visitor>
  static void visit_all(std::span<const T> items, Visitor& visitor) {
    if constexpr (std::is_invocable_v<Visitor&, const T&>) {
      for (const T& item : items) visitor(item);
    }
  }

  template <class T>
  static std::span<const T> part(const std::vector<T>& all, const std::vector<std::uint32_t>& begin,
                                 ShellId s) {
    return std::span(all).subspan(begin[s.value()], begin[s.value() + 1] - begin[s.value()]);
  }

  const SpaceComplex& complex_;
  std::vector<VolumeId> volume_;
  std::vector<ShellId> ids_;
  std::vector<std::uint32_t> volume_begin_, side_begin_, edge_begin_, vertex_begin_;
  std::vector<FacetSide> sides_;
  std::vector<EdgeId> edges_;
  std::vector<VertexId> vertices_;
};

/// Selects the solid that a mesh made from a shell bounds.
enum class ShellSolid : std::uint8_t {
  /// The solid is the volume of the shell. The faces of the mesh are oriented away from this
  /// volume.
  Volume,
  /// The solid lies on the other side of the shell. For example, let the volume have a void. Then
  /// the shell around the void gives a solid in the shape of the void.
  Other,
};

/// Returns the facets of a shell as a mesh. Throws Error{BadArgument} if one of the facets reaches
/// to infinity.
MeshOfComplex mesh_of_shell(const SpaceShells& shells, ShellId s, ShellSolid solid,
                            const ToMeshOptions& options = {},
                            Context& context = unlimited_context());

/// Selects the cells of a shell that belong to the set returned by set_of_shell().
enum class ShellMarks : std::uint8_t {
  Own,  ///< The cells that belong to the original set.
  All,  ///< All cells; the set is then closed.
};

/// Returns the facets, edges and vertices of a shell as a set without volumes.
/// Nef3::with_bounded_volumes() adds the volumes that such a set encloses. Requires that `shells`
/// was made from set.complex().
Nef3 set_of_shell(const Nef3& set, const SpaceShells& shells, ShellId s, ShellMarks marks,
                  Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
