// A set of space made ready for a file.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/space/nef3.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// How `.nef` names the planes of the frame, in the order of the tables.
inline constexpr std::array<std::string_view, 6> kFrameSides{"-x", "+x", "-y", "+y", "-z", "+z"};

/// .nef holds every set exactly, meshes the closure of the interior with rounded coordinates.
struct SolidFormat {
  std::string_view name;
  std::string_view extension;
  std::optional<MeshFormat> mesh;  ///< none: .nef
};
/// In the order of preference.
std::span<const SolidFormat> solid_formats();

/// All work and all judgement is done before the first byte is written.
class SolidText {
 public:
  /// Throws Error{CannotWrite} when a mesh is to hold a marked volume that reaches to infinity,
  /// Error{NumberOutOfRange} when a coordinate lies beyond the largest double.
  SolidText(const Nef3& set, const SolidFormat& format, Context& context);

  /// What the file does not say of the set, or says otherwise after rounding; one sentence each.
  const std::vector<std::string>& losses() const { return losses_; }
  /// `.nef` with checkpoints.
  void write(std::ostream& out, Context& context) const;

 private:
  void make_mesh(MeshFormat format, Context& context);

  Nef3 set_;
  SolidFormat format_;
  PolygonMesh mesh_;
  std::vector<std::string> losses_;
};

// Whether the links of a complex can be followed: what a reader must know before anybody else sees
// it.

/// Requires sizes that agree and ids in range (the reader's records have them). What is wrong, or
/// "":
///
///   edges     join two vertices; lie on two planes; free in a volume, or on a facet
///   vertices  alone: in a volume, or in a facet, not both; else no volume
///   uses      next goes on from where a use ends, in the same facet; radial stays at the edge;
///             both are permutations, and one radial cycle holds all uses of an edge
///   facets    each cycle of uses is listed once, with the facet that its uses name
///
/// O(n).
std::string flaw_of_links(const SpaceComplex& complex);

}  // namespace plumb
