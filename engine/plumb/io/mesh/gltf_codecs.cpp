// Calls of the libraries that decompress glTF.
//
// The decoder of meshoptimizer writes into memory of the caller, checks the stream as it goes, and
// only asserts that strides and counts suit the mode: that is checked here. Draco allocates by
// itself. Its decoder is derived here to look ahead at the counts of the stream and at the
// attributes before it allocates for them, and to charge estimates that are upper bounds. The
// results of Draco are not trusted: indices and coordinates are checked as in any file.
//
// Without PLUMB_WITH_DRACO and PLUMB_WITH_MESHOPT this file has only the messages of its errors.
// Tested by tests/io/gltf_codecs_test.cpp.
#include "plumb/io/mesh/gltf_codecs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "plumb/io/mesh/gltf_parts.h"
#include "plumb/predicates/error.h"

#ifdef PLUMB_WITH_DRACO
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#endif
#ifdef PLUMB_WITH_MESHOPT
#include <meshoptimizer.h>
#endif

namespace plumb {
namespace {

#if defined(PLUMB_WITH_DRACO) || defined(PLUMB_WITH_MESHOPT)
static_assert(std::endian::native == std::endian::little,
              "the decoders write numbers as the processor has them");
#endif

constexpr const char* kDecompress = "decompress it: gltf-transform cp IN.glb OUT.glb";

[[noreturn, maybe_unused]] void refuse_without(const char* codec, const char* package) {
  throw Error(ErrorCode::UnknownFormat, std::string("compressed by ") + codec + "; install " +
                                            package + " and build plumb again, or " + kDecompress);
}

}  // namespace

// ---------------------------------------------------------------- meshoptimizer

#ifdef PLUMB_WITH_MESHOPT

bool has_meshopt() { return true; }

namespace {

[[noreturn]] void fail_stream(ErrorCode code, const std::string& what) {
  throw Error(code, "compressed by meshopt: " + what);
}

using Filter = void (*)(void* elements, std::size_t count, std::size_t stride);

/// Returns the filter of that name. Returns null if the decoded elements need no filter.
Filter filter_of(const MeshoptStream& s) {
  if (s.filter.empty() || s.filter == "NONE") return nullptr;
  const bool is_short = s.stride == 8;
  if (s.filter == "OCTAHEDRAL" && (is_short || s.stride == 4)) return meshopt_decodeFilterOct;
  if (s.filter == "QUATERNION" && is_short) return meshopt_decodeFilterQuat;
  if (s.filter == "EXPONENTIAL") return meshopt_decodeFilterExp;
  fail_stream(ErrorCode::UnknownFormat, "its filter is not read; " + std::string(kDecompress));
}

using Decode = int (*)(void* elements, std::size_t count, std::size_t stride,
                       const unsigned char* bytes, std::size_t size);

Decode decoder_of(const MeshoptStream& s) {
  if (s.mode == "ATTRIBUTES") return meshopt_decodeVertexBuffer;
  if (s.mode == "TRIANGLES") return meshopt_decodeIndexBuffer;
  return meshopt_decodeIndexSequence;
}

/// Throws unless the mode is known, and stride and count are what its decoder requires.
void require_shape(const MeshoptStream& s) {
  const bool is_index = s.stride == 2 || s.stride == 4;
  bool fits = false;
  if (s.mode == "ATTRIBUTES") {
    fits = s.stride > 0 && s.stride <= 256 && s.stride % 4 == 0;
  } else if (s.mode == "TRIANGLES") {
    fits = is_index && s.count % 3 == 0;
  } else if (s.mode == "INDICES") {
    fits = is_index;
  } else {
    fail_stream(ErrorCode::UnknownFormat, "its mode is not read");
  }
  if (!fits) fail_stream(ErrorCode::Syntax, "its byteStride or count does not suit its mode");
  // In a block of 256 elements, each byte of an element takes at least two bits.
  constexpr std::size_t kMostPerByte = 1024;
  const std::size_t most = (s.bytes.size() + 1) * kMostPerByte;
  if (s.count > most / s.stride) {
    fail_stream(ErrorCode::CountMismatch, std::to_string(s.count) + " elements are not in " +
                                              std::to_string(s.bytes.size()) + " bytes");
  }
}

}  // namespace

std::string decode_meshopt(const MeshoptStream& s, MemoryCharge& charge) {
  require_shape(s);
  const Filter filter = s.mode == "ATTRIBUTES" ? filter_of(s) : nullptr;
  charge.add(s.count * s.stride, "compressed data");
  std::string out(s.count * s.stride, '\0');
  const auto* bytes = reinterpret_cast<const unsigned char*>(s.bytes.data());
  const int flaw = decoder_of(s)(out.data(), s.count, s.stride, bytes, s.bytes.size());
  if (flaw == -1) {
    fail_stream(ErrorCode::UnknownFormat,
                std::string("this version of it is not read; ") + kDecompress);
  }
  if (flaw != 0) fail_stream(ErrorCode::Syntax, "the bytes are damaged");
  if (filter != nullptr) filter(out.data(), s.count, s.stride);
  return out;
}

#else

bool has_meshopt() { return false; }

std::string decode_meshopt(const MeshoptStream& /*stream*/, MemoryCharge& /*charge*/) {
  refuse_without("meshopt", "libmeshoptimizer-dev");
}

#endif

// ---------------------------------------------------------------- Draco

#ifdef PLUMB_WITH_DRACO

bool has_draco() { return true; }

struct DracoMesh::Decoded {
  explicit Decoded(Context& context) : charge(context) {}
  MemoryCharge charge;
  draco::Mesh mesh;
  std::vector<int> read;  // The numbers, within the mesh, of the attributes that were decoded.
};

namespace {

[[noreturn]] void fail_draco(ErrorCode code, const std::string& what) {
  throw Error(code, "compressed by Draco: " + what);
}

/// Returns the number of the attribute with this id within a mesh, or -1 if there is none.
int number_of(const draco::PointCloud& points, std::size_t id) {
  return id > UINT32_MAX ? -1 : points.GetAttributeIdByUniqueId(static_cast<std::uint32_t>(id));
}

/// A decoder of Draco that charges memory before it is allocated.
template <class Decoder>
class ChargedDecoder final : public Decoder {
 public:
  /// Appends the numbers of the attributes that were decoded to `read`.
  ChargedDecoder(std::span<const std::size_t> attributes, MemoryCharge& charge,
                 std::vector<int>& read)
      : attributes_(attributes), charge_(charge), read_(read) {}

 protected:
  /// Looks ahead at the counts. Both methods begin with the counts of triangles and vertices. In
  /// the method edgebreaker, they are followed by the number of attributes that have their own
  /// connectivity.
  bool DecodeConnectivity() override {
    draco::DecoderBuffer ahead = *this->buffer();
    std::uint32_t a = 0, b = 0;
    std::uint8_t connectivities = 0;
    if (!draco::DecodeVarint(&a, &ahead) || !draco::DecodeVarint(&b, &ahead) ||
        !ahead.Decode(&connectivities)) {
      return false;
    }
    const std::uint64_t count = std::max(a, b);
    // A flat grid has about thirty triangles for each byte.
    constexpr std::uint64_t kMostPerByte = 4096;
    if (count / kMostPerByte > static_cast<std::uint64_t>(ahead.remaining_size())) {
      fail_draco(ErrorCode::CountMismatch,
                 std::to_string(count) + " triangles are not in its bytes");
    }
    // The memory of tables of corners, vertices and triangles, and of the connectivity of an
    // attribute.
    constexpr std::uint64_t kBytes = 160, kConnectivityBytes = 64;
    charge_.add(count * (kBytes + connectivities * kConnectivityBytes), "compressed triangles");
    return Decoder::DecodeConnectivity();
  }

  /// The numbers of points and the types of attributes are known, but their values have not been
  /// read. Values that follow the requested values are not read.
  bool DecodeAllAttributes() override {
    const draco::PointCloud& points = *this->point_cloud();
    std::uint64_t bytes = 0;
    for (int i = 0; i < points.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *points.attribute(i);
      // The memory of the values, twice as integers, and of their numbers.
      constexpr std::uint64_t kIntegers = 2 * sizeof(std::int32_t);
      constexpr std::uint64_t kNumbers = 3 * sizeof(std::uint32_t);
      bytes += static_cast<std::uint64_t>(attribute.byte_stride()) +
               attribute.num_components() * kIntegers + kNumbers;
    }
    charge_.add(bytes * points.num_points(), "compressed vertices");
    std::vector<int> wanted;
    for (const std::size_t id : attributes_) wanted.push_back(number_of(points, id));
    std::erase(wanted, -1);
    for (int i = 0; i < this->num_attributes_decoders() && !wanted.empty(); ++i) {
      // The base class owns the parts, and gives access to them only as constants.
      auto* const part =
          const_cast<draco::AttributesDecoderInterface*>(this->attributes_decoder(i));
      if (!can_decode(*part)) return is_read(number_of(points, attributes_[0]));
      for (int k = 0; k < part->GetNumAttributes(); ++k) {
        read_.push_back(part->GetAttributeId(k));
        std::erase(wanted, part->GetAttributeId(k));
      }
    }
    return true;
  }

 private:
  bool is_read(int number) const {
    return std::find(read_.begin(), read_.end(), number) != read_.end();
  }
  bool can_decode(draco::AttributesDecoderInterface& part) {
    try {
      return part.DecodeAttributes(this->buffer());
    } catch (const std::length_error&) {
      return false;
    }
  }

  std::span<const std::size_t> attributes_;
  MemoryCharge& charge_;
  std::vector<int>& read_;
};

draco::DracoHeader header_of(draco::DecoderBuffer in) {
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&in, &header).ok() ||
      header.encoder_type != draco::TRIANGULAR_MESH) {
    fail_draco(ErrorCode::Syntax, "its bytes are no mesh of Draco");
  }
  if (header.version_major != draco::kDracoMeshBitstreamVersionMajor ||
      header.version_minor != draco::kDracoMeshBitstreamVersionMinor ||
      header.encoder_method > draco::MESH_EDGEBREAKER_ENCODING) {
    fail_draco(ErrorCode::UnknownFormat,
               "this version of it is not read; " + std::string(kDecompress));
  }
  return header;
}

template <class Decoder>
void decode(draco::DecoderBuffer& in, std::span<const std::size_t> attributes, MemoryCharge& charge,
            draco::Mesh& mesh, std::vector<int>& read) {
  ChargedDecoder<Decoder> decoder(attributes, charge, read);
  const draco::DecoderOptions options;
  if (!decoder.Decode(options, &in, &mesh).ok()) {
    fail_draco(ErrorCode::Syntax, "the bytes are damaged");
  }
}

template <class Number>
std::string values_of(const draco::PointAttribute& attribute, std::size_t parts,
                      std::size_t points) {
  const std::size_t size = parts * sizeof(Number);
  std::string bytes(points * size, '\0');
  for (std::size_t i = 0; i < points; ++i) {
    std::array<Number, 4> value{};
    const auto entry = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    if (!attribute.ConvertValue(entry, static_cast<std::int8_t>(parts), value.data())) {
      fail_draco(ErrorCode::Syntax, "a vertex lacks numbers");
    }
    std::memcpy(bytes.data() + i * size, value.data(), size);
  }
  return bytes;
}

}  // namespace

DracoMesh::DracoMesh(std::string_view bytes, std::span<const std::size_t> attributes,
                     Context& context)
    : decoded_(std::make_unique<Decoded>(context)) {
  draco::DecoderBuffer in;
  in.Init(bytes.data(), bytes.size());
  context.checkpoint("read", 0, 1);
  draco::Mesh& mesh = decoded_->mesh;
  std::vector<int>& read = decoded_->read;
  try {
    if (header_of(in).encoder_method == draco::MESH_SEQUENTIAL_ENCODING) {
      decode<draco::MeshSequentialDecoder>(in, attributes, decoded_->charge, mesh, read);
    } else {
      decode<draco::MeshEdgebreakerDecoder>(in, attributes, decoded_->charge, mesh, read);
    }
  } catch (const std::length_error&) {
    fail_draco(ErrorCode::Syntax, "the bytes are damaged");
  }
  if (!has(attributes[0], 3)) {
    fail_draco(ErrorCode::BadIndex,
               "no attribute " + std::to_string(attributes[0]) + " of 3 numbers");
  }
}

DracoMesh::~DracoMesh() = default;

bool DracoMesh::has(std::size_t attribute, std::size_t parts) const {
  const int number = number_of(decoded_->mesh, attribute);
  const std::vector<int>& read = decoded_->read;
  if (number < 0 || std::find(read.begin(), read.end(), number) == read.end()) return false;
  const draco::PointAttribute& found = *decoded_->mesh.attribute(number);
  return static_cast<std::size_t>(found.num_components()) == parts &&
         (found.is_mapping_identity() || found.indices_map_size() >= point_count());
}

std::size_t DracoMesh::point_count() const { return decoded_->mesh.num_points(); }
std::size_t DracoMesh::triangle_count() const { return decoded_->mesh.num_faces(); }

std::string DracoMesh::corners() const {
  constexpr std::size_t kBytes = 3 * sizeof(std::uint32_t);
  const std::size_t count = triangle_count();
  std::string bytes(count * kBytes, '\0');
  for (std::size_t i = 0; i < count; ++i) {
    const auto& face = decoded_->mesh.face(draco::FaceIndex(static_cast<std::uint32_t>(i)));
    const std::array<std::uint32_t, 3> corners{face[0].value(), face[1].value(), face[2].value()};
    std::memcpy(bytes.data() + i * kBytes, corners.data(), kBytes);
  }
  return bytes;
}

std::string DracoMesh::vectors(std::size_t attribute, std::size_t parts,
                               std::size_t component) const {
  const std::size_t points = point_count();
  const draco::PointAttribute& vectors =
      *decoded_->mesh.attribute(number_of(decoded_->mesh, attribute));
  switch (component) {
    case GltfComponent::kSignedByte:
      return values_of<std::int8_t>(vectors, parts, points);
    case GltfComponent::kByte:
      return values_of<std::uint8_t>(vectors, parts, points);
    case GltfComponent::kSignedShort:
      return values_of<std::int16_t>(vectors, parts, points);
    case GltfComponent::kShort:
      return values_of<std::uint16_t>(vectors, parts, points);
    default:
      return values_of<float>(vectors, parts, points);
  }
}

#else

bool has_draco() { return false; }

struct DracoMesh::Decoded {};

DracoMesh::DracoMesh(std::string_view /*bytes*/, std::span<const std::size_t> /*attributes*/,
                     Context& /*context*/) {
  refuse_without("Draco", "libdraco-dev");
}
DracoMesh::~DracoMesh() = default;
std::size_t DracoMesh::point_count() const { return 0; }
std::size_t DracoMesh::triangle_count() const { return 0; }
bool DracoMesh::has(std::size_t /*attribute*/, std::size_t /*parts*/) const { return false; }
std::string DracoMesh::corners() const { return {}; }
std::string DracoMesh::vectors(std::size_t /*attribute*/, std::size_t /*parts*/,
                               std::size_t /*component*/) const {
  return {};
}

#endif

}  // namespace plumb
