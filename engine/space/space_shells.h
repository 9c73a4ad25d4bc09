// The shells of a complex: connected parts of the boundary of its volumes.
//
// A shell is what a fly in a volume can walk: sides of facets, along edges to the next side, and through
// vertices where the volume goes on around them; free edges and lone vertices, too. A facet with the same volume on both
// sides shows both. The boundary of a volume is its shells: of a bounded volume the outer one first, then the
// voids in it.
//
// Where a set is unbounded, what reaches infinity is connected there (the frame joins it); items of the
// frame and volumes beyond it are not listed.
//
// Cost: O(n alpha(n)). A shell is a few spans to loop over, or goes to a visitor with visit().
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

using ShellId = StrongId<struct ShellTag>;  ///< a connected part of the boundary of a volume

/// The shells of all volumes of a complex.
class SpaceShells {
 public:
  /// Requires volumes. The complex must outlive the shells.
  explicit SpaceShells(const SpaceComplex& complex);

  /// Shells follow each other by volume, within it by their lexicographically least vertex; a shell
  /// without vertices (all of it at infinity) comes last.
  std::size_t size() const { return volume_.size(); }
  std::span<const ShellId> shells_of(VolumeId v) const;  ///< Those of a volume, in their order.
  VolumeId volume(ShellId s) const { return volume_[s.value()]; }  ///< The volume that it bounds.

  /// Facets by the side that bounds the volume, as faces of a solid that fills it: is_reversed where
  /// the volume is on the positive side.
  std::span<const FacetSide> sides(ShellId s) const { return part(sides_, side_begin_, s); }
  /// Each once: of its facets, and free ones.
  std::span<const EdgeId> edges(ShellId s) const { return part(edges_, edge_begin_, s); }
  /// Each once: of its edges, and isolated ones.
  std::span<const VertexId> vertices(ShellId s) const { return part(vertices_, vertex_begin_, s); }

  /// Calls the visitor with every item of a shell, each once: FacetSide, then EdgeId, then VertexId. What the visitor
  /// cannot be called with is passed over.
  template <class Visitor>
  void visit(ShellId s, Visitor&& visitor) const {
    visit_all(sides(s), visitor);
    visit_all(edges(s), visitor);
    visit_all(vertices(s), visitor);
  }

  const SpaceComplex& complex() const { return complex_; }  ///< The complex that was given.

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

/// What the faces of the mesh of a shell bound.
enum class ShellSolid : std::uint8_t {
  Volume,  ///< the shell's volume is the solid: faces look out of it
  Other,   ///< what lies on the other side is: a void becomes a solid
};

/// The facets of a shell as a mesh. Throws Error{BadArgument} when one of them reaches to infinity.
MeshOfComplex mesh_of_shell(const SpaceShells& shells, ShellId s, ShellSolid solid,
                            const ToMeshOptions& options, Context& context);

/// Which items of a shell belong to the set made of it.
enum class ShellMarks : std::uint8_t {
  Own,  ///< those that belong to the set it is a shell of
  All,  ///< all: the closed surface
};

/// The facets, edges and vertices of a shell as a set without volumes; Nef3::with_bounded_volumes() fills it. Requires the
/// shells of set.complex().
Nef3 set_of_shell(const Nef3& set, const SpaceShells& shells, ShellId s, ShellMarks marks,
                  Context& context);

}  // namespace plumb
#pragma GCC visibility pop
