// The numbers that accessors of glTF name: in views of buffers, in sparse lists that replace some
// of them, and in compressed streams.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh/gltf_codecs.h"
#include "plumb/io/mesh/gltf_document.h"
#include "plumb/io/mesh/gltf_parts.h"

namespace plumb {

/// Elements are found on first use and kept: an accessor and a view are read once, and a compressed
/// stream a bounded number of times, however many primitives name them. Elements point into memory
/// of the document or of this object.
class GltfAccessors {
 public:
  /// The document and the context must outlive it.
  GltfAccessors(GltfDocument& document, Context& context)
      : in_(document), context_(context), charge_(context) {}

  /// Returns numbers that are indices, all of whose bytes exist. Throws "FILE: accessors[3]: what"
  /// if the accessor has another type, or if its data are not there.
  GltfElements indices(std::size_t accessor);
  /// Returns vectors of 2, 3 or 4 floats, bytes or shorts. `type` is VEC2, VEC3 or VEC4.
  GltfElements vectors(std::size_t accessor, std::string_view type);
  /// Throws the errors of vectors() that do not depend on where the bytes are.
  void require_vectors(std::size_t accessor, std::string_view type) {
    vectors_of(accessor, type, GltfDocument::entry("accessors", accessor));
  }
  /// Returns the type that an accessor states, such as VEC3.
  std::string type_of(std::size_t accessor);

  /// Whether an accessor names a view of a buffer that can be opened.
  bool can_open(std::size_t accessor);

  /// Vectors of a compressed mesh.
  struct CompressedVectors {
    std::size_t attribute;  ///< The id of the attribute in the stream.
    std::size_t accessor;   ///< The accessor whose place the attribute takes.
    std::string type;       ///< VEC2, VEC3 or VEC4.
  };
  /// A mesh that is compressed as a whole (KHR_draco_mesh_compression).
  struct Compressed {
    GltfElements positions, corners;
    std::vector<std::optional<GltfElements>> others;  ///< Without a value if they cannot be read.
  };
  /// Returns the triangles of a compressed mesh, and other vectors of its points. A stream is read
  /// again, up to 16 times, if a primitive asks for vectors that no other one asked for. Requires
  /// require_vectors() for the accessors of `others`.
  Compressed compressed(std::size_t view, const CompressedVectors& positions,
                        std::span<const CompressedVectors> others);

  /// Returns how many accessors have no bytes at all: their elements are zeros.
  std::size_t accessors_of_zeros() const { return accessors_of_zeros_; }

 private:
  using Id = GltfDocument::Id;

  /// The members of an accessor.
  struct Accessor {
    Id object;
    std::string type;
    std::size_t component, count, offset;
    std::optional<std::size_t> view;
    bool is_normalized, is_sparse;
  };
  using ViewBytes = std::pair<std::string_view, std::size_t>;
  /// A stream of Draco, and the data that were requested from it.
  struct Stream {
    struct Vectors {
      std::size_t component, parts;
      std::string bytes;
    };
    std::size_t points = 0;
    std::string corners;
    std::map<std::size_t, Vectors> vectors;  // Per attribute.
    // Attributes, including attributes that the stream lacks.
    std::set<std::size_t> asked;
    std::size_t times = 0;  // How often the stream was read.
  };

  const Accessor& accessor_of(std::size_t accessor, const std::string& where);
  const Accessor& vectors_of(std::size_t accessor, std::string_view type, const std::string& where);
  [[noreturn]] void fail_component(std::size_t component, const std::string& where) const;
  GltfElements elements(std::size_t accessor, const Accessor& a, std::size_t parts,
                        const std::string& where);
  GltfElements in_view(std::size_t view, std::size_t offset, GltfElements e, std::size_t bytes,
                       const std::string& where);
  const std::string& replaced(std::size_t accessor, const Accessor& a, std::size_t bytes,
                              const std::string& where);
  void replace_some(Id sparse, const Accessor& a, std::size_t bytes, const std::string& where,
                    std::string& all);

  void decode(std::size_t view, const CompressedVectors& positions,
              std::span<const CompressedVectors> others, Stream& stream);
  std::optional<GltfElements> vectors_in(const Stream& stream, const CompressedVectors& wanted);

  const ViewBytes& view_bytes(std::size_t view);
  ViewBytes found_view(std::size_t view);
  std::string_view part_of_buffer(Id object, const std::string& where);
  std::optional<Id> compression_of(Id view) const;
  std::string_view decompressed(std::size_t view, Id compression, std::size_t length,
                                const std::string& where);

  GltfDocument& in_;
  Context& context_;
  MemoryCharge charge_;
  std::size_t accessors_of_zeros_ = 0;
  std::map<std::size_t, Accessor> accessors_;
  std::map<std::size_t, ViewBytes> views_;
  std::map<std::size_t, bool> can_open_view_;
  std::map<std::size_t, std::string> replaced_;      // Per accessor that is sparse or of zeros.
  std::map<std::size_t, std::string> decompressed_;  // Per view that meshopt compressed.
  std::map<std::size_t, Stream> streams_;            // Per view that Draco compressed.
};

}  // namespace plumb
