// A set of space made ready for a file.
#pragma once

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

namespace plumb {

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

}  // namespace plumb
