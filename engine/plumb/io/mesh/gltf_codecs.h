// Decoders of compressed glTF: Draco and meshoptimizer, if plumb is built with these libraries.
//
// Without a library, its function throws Error{UnknownFormat} that says how to get at the data. The
// streams are hostile input. Before a decoder runs, the announced sizes are compared with the
// length of the stream, and charged. All errors are thrown without a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "plumb/base/context.h"

namespace plumb {

/// Whether plumb is built with the library.
bool has_draco();
bool has_meshopt();

/// The compressed bytes of a view of a buffer, and the kind of their contents
/// (EXT_meshopt_compression).
struct MeshoptStream {
  std::string_view bytes;
  std::size_t count = 0;   ///< The number of compressed elements.
  std::size_t stride = 0;  ///< Bytes of an element.
  std::string mode;        ///< ATTRIBUTES, TRIANGLES or INDICES.
  std::string filter;      ///< NONE or empty, OCTAHEDRAL, QUATERNION or EXPONENTIAL.
};

/// Returns count * stride bytes, which are charged to `charge`. Throws Error{UnknownFormat} also
/// for modes and filters that are not known, Error{CountMismatch} and Error{Syntax}; the errors of
/// the Context. Cost: O(count * stride).
std::string decode_meshopt(const MeshoptStream& stream, MemoryCharge& charge);

/// A mesh that Draco compressed: its triangles, and some attributes of its points.
class DracoMesh {
 public:
  /// Decodes `bytes`, at a cost that is linear in the mesh, up to the last of the attributes with
  /// these ids. The first id is the id of the positions. Other attributes behind them are not
  /// decoded. The memory of the mesh is charged while the object exists. Throws
  /// Error{UnknownFormat}, Error{CountMismatch} and Error{Syntax}; Error{BadIndex} if the positions
  /// are not there with 3 components; the errors of the Context. If another attribute is missing or
  /// damaged, has() says so.
  DracoMesh(std::string_view bytes, std::span<const std::size_t> attributes, Context& context);
  ~DracoMesh();
  DracoMesh(const DracoMesh&) = delete;
  DracoMesh& operator=(const DracoMesh&) = delete;

  std::size_t point_count() const;
  std::size_t triangle_count() const;

  /// Whether the attribute with this id was decoded and has this number of components.
  bool has(std::size_t attribute, std::size_t parts) const;

  // The caller charges the memory of the results of these two functions.
  /// Returns the corners of all triangles as std::uint32_t.
  std::string corners() const;
  /// Returns the 2, 3 or 4 components of an attribute for each point, as numbers of a component
  /// type of glTF (GltfComponent). Requires has().
  std::string vectors(std::size_t attribute, std::size_t parts, std::size_t component) const;

 private:
  struct Decoded;
  std::unique_ptr<Decoded> decoded_;
};

}  // namespace plumb
