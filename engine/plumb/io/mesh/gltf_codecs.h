// Decoders of compressed glTF: Draco and meshoptimizer, if plumb is built with these libraries.
//
// Without a library, its function throws Error{UnknownFormat} that says how to get at the data. The
// streams are hostile input: what is announced is compared with the length of the stream and
// charged before a decoder runs. All errors are thrown without a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "plumb/base/context.h"

namespace plumb {

/// Whether plumb is built with the library.
bool has_draco();
bool has_meshopt();

/// The compressed bytes of a view of a buffer, and what they are (EXT_meshopt_compression).
struct MeshoptStream {
  std::string_view bytes;
  std::size_t count = 0;   ///< How many elements are compressed.
  std::size_t stride = 0;  ///< Bytes of an element.
  std::string mode;        ///< ATTRIBUTES, TRIANGLES or INDICES.
  std::string filter;      ///< NONE or empty, OCTAHEDRAL, QUATERNION or EXPONENTIAL.
};

/// Returns count * stride bytes, which are charged to `charge`. Throws Error{UnknownFormat} also
/// for modes and filters that are not known, Error{CountMismatch} and Error{Syntax}; what the
/// context throws. Cost: O(count * stride).
std::string decode_meshopt(const MeshoptStream& stream, MemoryCharge& charge);

/// A mesh that Draco compressed: its triangles, and one attribute of its points.
class DracoMesh {
 public:
  /// Decodes `bytes`, at a cost that is linear in the mesh, up to the attribute with this id. Other
  /// attributes, which come behind, are not decoded. The memory of the mesh is charged while the
  /// object exists. Throws Error{UnknownFormat}, Error{CountMismatch} and Error{Syntax};
  /// Error{BadIndex} if there is no such attribute of 3 components; what the context throws.
  DracoMesh(std::string_view bytes, std::size_t attribute, Context& context);
  ~DracoMesh();
  DracoMesh(const DracoMesh&) = delete;
  DracoMesh& operator=(const DracoMesh&) = delete;

  std::size_t point_count() const;
  std::size_t triangle_count() const;

  // The caller charges what these two return.
  /// Returns the corners of all triangles as std::uint32_t.
  std::string corners() const;
  /// Returns the 3 components of the attribute for each point, as numbers of a component type of
  /// glTF (GltfComponent).
  std::string vectors(std::size_t component) const;

 private:
  struct Decoded;
  std::unique_ptr<Decoded> decoded_;
};

}  // namespace plumb
