// The shells of a complex: the connected components of the boundaries of its volumes.
//
// A shell contains the parts of the boundary that a point moving in one volume can reach along that
// boundary. The point moves on sides of facets, across edges to the next side, and through vertices
// around which the volume continues. Free edges and isolated vertices are parts of shells, too. A
// facet with the same volume on both sides contributes both sides. The boundary of a volume is the
// union of its shells. A bounded volume has one outer shell, and other shells around the voids in
// it.
//
// In an unbounded set, all parts that reach to infinity are connected there, by the frame. Cells of
// the frame and volumes beyond it are not listed.
//
// Cost: O(n alpha(n)). A shell is read as a few spans, or by a visitor with visit().
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

using ShellId = StrongId<struct ShellTag>;  ///< The id of a component of the boundary of a volume.

/// The shells of all volumes of a complex.
class SpaceShells {
 public:
  /// Finds the shells. Requires volumes. The complex must outlive the shells. O(n alpha(n)).
  explicit SpaceShells(const SpaceComplex& complex);

  /// Returns the number of shells. Shells are ordered by volume, then by their lexicographically
  /// least vertex. So the outer shell of a bounded volume comes first. A shell without vertices
  /// (all of it lies at infinity) comes last.
  std::size_t size() const { return volume_.size(); }
  /// Returns the shells of a volume, in their order.
  std::span<const ShellId> shells_of(VolumeId v) const;
  /// Returns the volume that a shell bounds.
  VolumeId volume(ShellId s) const { return volume_[s.value()]; }

  /// Returns the sides of facets that make up the shell, seen as faces of a solid that fills the
  /// volume. So is_reversed is set if the volume is on the positive side of the facet.
  std::span<const FacetSide> sides(ShellId s) const { return part(sides_, side_begin_, s); }
  /// Returns the edges of the facets of the shell and its free edges, each once.
  std::span<const EdgeId> edges(ShellId s) const { return part(edges_, edge_begin_, s); }
  /// Returns the vertices of the facets and edges of the shell and its isolated vertices, each
  /// once.
  std::span<const VertexId> vertices(ShellId s) const { return part(vertices_, vertex_begin_, s); }

  /// Calls the visitor once with every FacetSide of a shell, then with every EdgeId, then with
  /// every VertexId. Types with which the visitor cannot be called are skipped.
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

/// The solid that a mesh made from a shell bounds.
enum class ShellSolid : std::uint8_t {
  Volume,  ///< The volume of the shell: faces look out of it.
  Other,   ///< The solid on the other side of the shell: a void becomes a solid.
};

/// Returns the facets of a shell as a mesh. Throws Error{BadArgument} if one of the facets reaches
/// to infinity.
MeshOfComplex mesh_of_shell(const SpaceShells& shells, ShellId s, ShellSolid solid,
                            const ToMeshOptions& options = {},
                            Context& context = unlimited_context());

/// Which cells of a shell belong to the set that set_of_shell() makes.
enum class ShellMarks : std::uint8_t {
  Own,  ///< The cells that belong to the original set.
  All,  ///< All cells: the shell as a closed set.
};

/// Returns the facets, edges and vertices of a shell as a set without volumes.
/// Nef3::with_bounded_volumes() adds the volumes that such a set encloses. Requires that `shells`
/// are those of set.complex().
Nef3 set_of_shell(const Nef3& set, const SpaceShells& shells, ShellId s, ShellMarks marks,
                  Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
