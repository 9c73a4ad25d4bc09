// Reading of accessors.
//
// Offsets, strides and counts are compared with the bytes of the view in advance, so that elements
// are read without checks. A sparse accessor is copied, with some elements replaced. An accessor
// without any bytes has zeros for elements; so that a small file cannot ask for many elements,
// their number is at most the number of bytes that were read. If data are stored both compressed
// and uncompressed, the uncompressed data are used, because they do not depend on a library. Tested
// by tests/io/gltf_accessors_test.cpp.
#include "plumb/io/mesh/gltf_accessors.h"

#include <algorithm>
#include <cstring>

namespace plumb {
namespace {

bool is_index(std::size_t component) {
  return component == GltfComponent::kByte || component == GltfComponent::kShort ||
         component == GltfComponent::kInteger;
}

/// Returns the number of parts of VEC2, VEC3 or VEC4.
std::size_t parts_of(std::string_view type) { return type == "VEC4" ? 4 : type == "VEC3" ? 3 : 2; }

}  // namespace

GltfElements GltfAccessors::indices(std::size_t accessor) {
  const std::string where = GltfDocument::entry("accessors", accessor);
  const Accessor& a = accessor_of(accessor, where);
  if (a.type != "SCALAR") in_.fail(ErrorCode::Syntax, where, "type is not SCALAR");
  if (!is_index(a.component)) fail_component(a.component, where);
  return elements(accessor, a, 1, where);
}

GltfElements GltfAccessors::vectors(std::size_t accessor, std::string_view type) {
  const std::string where = GltfDocument::entry("accessors", accessor);
  return elements(accessor, vectors_of(accessor, type, where), parts_of(type), where);
}

std::string GltfAccessors::type_of(std::size_t accessor) {
  return accessor_of(accessor, GltfDocument::entry("accessors", accessor)).type;
}

bool GltfAccessors::can_open(std::size_t accessor) {
  const Accessor& a = accessor_of(accessor, GltfDocument::entry("accessors", accessor));
  if (!a.view) return false;
  const auto [at, is_new] = can_open_view_.try_emplace(*a.view);
  if (is_new) {
    const Id view = in_.item("bufferViews", *a.view);
    const std::string where = GltfDocument::entry("bufferViews", *a.view);
    at->second = in_.can_open_buffer(in_.count(view, "buffer", {}, where));
  }
  return at->second;
}

// ---------------------------------------------------------------- elements

GltfElements GltfAccessors::elements(std::size_t accessor, const Accessor& a, std::size_t parts,
                                     const std::string& where) {
  GltfElements e;
  e.component = a.component;
  e.count = a.count;
  e.is_normalized = a.is_normalized;
  const std::size_t bytes = parts * component_bytes(a.component);
  if (a.view && !a.is_sparse) return in_view(*a.view, a.offset, e, bytes, where);
  e.bytes = replaced(accessor, a, bytes, where);
  e.stride = bytes;
  return e;
}

void GltfAccessors::fail_component(std::size_t component, const std::string& where) const {
  in_.fail(ErrorCode::UnknownFormat, where,
           "componentType " + std::to_string(component) + " is not read here");
}

/// Returns an accessor of floats, bytes or shorts.
const GltfAccessors::Accessor& GltfAccessors::vectors_of(std::size_t accessor,
                                                         std::string_view type,
                                                         const std::string& where) {
  const Accessor& a = accessor_of(accessor, where);
  if (a.type != type) in_.fail(ErrorCode::Syntax, where, "type is not " + std::string(type));
  if (component_bytes(a.component) == 0 || a.component == GltfComponent::kInteger) {
    fail_component(a.component, where);
  }
  return a;
}

const GltfAccessors::Accessor& GltfAccessors::accessor_of(std::size_t accessor,
                                                          const std::string& where) {
  if (const auto known = accessors_.find(accessor); known != accessors_.end()) return known->second;
  Accessor a{};
  a.object = in_.item("accessors", accessor);
  a.type = in_.text(a.object, "type");
  a.component = in_.count(a.object, "componentType", {}, where);
  a.count = in_.count(a.object, "count", {}, where);
  a.offset = in_.count(a.object, "byteOffset", 0, where);
  if (in_.has(a.object, "bufferView")) a.view = in_.count(a.object, "bufferView", {}, where);
  a.is_normalized = in_.is_true(a.object, "normalized");
  a.is_sparse = in_.has(a.object, "sparse");
  charge_.add(sizeof(Accessor) + a.type.size(), "accessors");
  return accessors_.emplace(accessor, std::move(a)).first->second;
}

/// Returns the elements `e`, each with `bytes` bytes, and their place in a view.
GltfElements GltfAccessors::in_view(std::size_t view, std::size_t offset, GltfElements e,
                                    std::size_t bytes, const std::string& where) {
  const auto [data, stride] = view_bytes(view);
  e.stride = stride == 0 ? bytes : stride;
  if (e.stride < bytes) in_.fail(ErrorCode::Syntax, where, "byteStride is less than an element");
  const bool fits = e.count == 0 || (offset <= data.size() && bytes <= data.size() - offset &&
                                     e.count - 1 <= (data.size() - offset - bytes) / e.stride);
  if (!fits) {
    in_.fail(ErrorCode::CountMismatch, where,
             std::to_string(e.count) + " elements are not in its bufferView");
  }
  if (e.count > 0) e.bytes = data.substr(offset);
  return e;
}

/// Returns a copy of all elements without gaps, in which the elements of the sparse accessor are
/// replaced.
const std::string& GltfAccessors::replaced(std::size_t accessor, const Accessor& a,
                                           std::size_t bytes, const std::string& where) {
  if (const auto known = replaced_.find(accessor); known != replaced_.end()) return known->second;
  GltfElements old;
  old.count = a.count;
  if (a.view) {
    old = in_view(*a.view, a.offset, old, bytes, where);
  } else if (a.count > in_.bytes_read()) {
    in_.fail(ErrorCode::CountMismatch, where,
             std::to_string(a.count) + " elements without a bufferView");
  }
  charge_.add(a.count * bytes, "accessors");
  std::string all(a.count * bytes, '\0');
  for (std::size_t i = 0; a.view && i < a.count; ++i) {
    if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, a.count);
    std::memcpy(all.data() + i * bytes, old.bytes.data() + i * old.stride, bytes);
  }
  if (a.is_sparse) {
    const auto sparse = in_.object(a.object, "sparse");
    if (!sparse) in_.fail(ErrorCode::Syntax, where, "sparse is no object");
    replace_some(*sparse, a, bytes, where, all);
  } else if (a.count > 0) {
    ++accessors_of_zeros_;
  }
  return replaced_.emplace(accessor, std::move(all)).first->second;
}

/// Replaces the elements that a sparse accessor lists.
void GltfAccessors::replace_some(Id sparse, const Accessor& a, std::size_t bytes,
                                 const std::string& where, std::string& all) {
  const auto indices = in_.object(sparse, "indices"), values = in_.object(sparse, "values");
  if (!indices || !values) in_.fail(ErrorCode::Syntax, where, "sparse needs indices and values");
  GltfElements at, to;
  at.count = to.count = in_.count(sparse, "count", {}, where);
  at.component = in_.count(*indices, "componentType", {}, where);
  if (!is_index(at.component)) fail_component(at.component, where);
  at = in_view(in_.count(*indices, "bufferView", {}, where),
               in_.count(*indices, "byteOffset", 0, where), at, component_bytes(at.component),
               where);
  to = in_view(in_.count(*values, "bufferView", {}, where),
               in_.count(*values, "byteOffset", 0, where), to, bytes, where);
  for (std::size_t i = 0; i < at.count; ++i) {
    if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, at.count);
    const std::size_t index = at.index(i);
    if (index >= a.count) {
      in_.fail(ErrorCode::BadIndex, where, "sparse: no element " + std::to_string(index));
    }
    std::memcpy(all.data() + index * bytes, to.bytes.data() + i * to.stride, bytes);
  }
}

// ---------------------------------------------------------------- views

/// Returns the bytes of a view and its stride. The stride is 0 if the view states none.
const GltfAccessors::ViewBytes& GltfAccessors::view_bytes(std::size_t view) {
  if (const auto known = views_.find(view); known != views_.end()) return known->second;
  charge_.add(sizeof(ViewBytes), "views of buffers");
  return views_.emplace(view, found_view(view)).first->second;
}

GltfAccessors::ViewBytes GltfAccessors::found_view(std::size_t view) {
  const std::string where = GltfDocument::entry("bufferViews", view);
  const Id object = in_.item("bufferViews", view);
  const std::size_t stride = in_.count(object, "byteStride", 0, where);
  const auto compression = compression_of(object);
  if (compression && !in_.can_open_buffer(in_.count(object, "buffer", {}, where))) {
    const std::size_t length = in_.count(object, "byteLength", {}, where);
    return {decompressed(view, *compression, length, where), stride};
  }
  return {part_of_buffer(object, where), stride};
}

/// Returns the bytes of a buffer that an object names by buffer, byteOffset and byteLength.
std::string_view GltfAccessors::part_of_buffer(Id object, const std::string& where) {
  const std::string_view buffer = in_.buffer(in_.count(object, "buffer", {}, where));
  const std::size_t offset = in_.count(object, "byteOffset", 0, where);
  const std::size_t length = in_.count(object, "byteLength", {}, where);
  if (offset > buffer.size() || length > buffer.size() - offset) {
    in_.fail(ErrorCode::CountMismatch, where, "is longer than its buffer");
  }
  return buffer.substr(offset, length);
}

std::optional<GltfAccessors::Id> GltfAccessors::compression_of(Id view) const {
  const auto found = in_.extension(view, "KHR_meshopt_compression");
  return found ? found : in_.extension(view, "EXT_meshopt_compression");
}

std::string_view GltfAccessors::decompressed(std::size_t view, Id compression, std::size_t length,
                                             const std::string& where) {
  MeshoptStream stream;
  stream.count = in_.count(compression, "count", {}, where);
  stream.stride = in_.count(compression, "byteStride", {}, where);
  stream.mode = in_.text(compression, "mode");
  stream.filter = in_.text(compression, "filter");
  if (stream.stride == 0 || length % stream.stride != 0 || length / stream.stride != stream.count) {
    in_.fail(ErrorCode::CountMismatch, where, "byteLength is not that of its compressed elements");
  }
  stream.bytes = part_of_buffer(compression, where);
  std::string bytes = in_.with_where(where, [&] { return decode_meshopt(stream, charge_); });
  return decompressed_.emplace(view, std::move(bytes)).first->second;
}

// ---------------------------------------------------------------- Draco

GltfAccessors::Compressed GltfAccessors::compressed(std::size_t view,
                                                    const CompressedVectors& positions,
                                                    std::span<const CompressedVectors> others) {
  require_vectors(positions.accessor, positions.type);
  // A primitive may ask for vectors that the primitives before it did not ask for. The number of
  // times is bounded, because ids are not.
  constexpr std::size_t kMostTimes = 16;
  Stream& stream = streams_[view];
  const bool asks_more = std::any_of(others.begin(), others.end(), [&](const auto& other) {
    return !stream.asked.contains(other.attribute);
  });
  if (stream.times == 0 || (asks_more && stream.times < kMostTimes)) {
    decode(view, positions, others, stream);
  }
  const std::optional<GltfElements> found = vectors_in(stream, positions);
  if (!found) {
    in_.fail(ErrorCode::CountMismatch, GltfDocument::entry("bufferViews", view),
             "has its positions in two ways");
  }
  Compressed c;
  c.positions = *found;
  c.corners = {stream.corners, sizeof(std::uint32_t), stream.corners.size() / sizeof(std::uint32_t),
               GltfComponent::kInteger};
  for (const CompressedVectors& other : others) c.others.push_back(vectors_in(stream, other));
  return c;
}

/// Decodes the positions of a stream and the other vectors in it. Requires accessors that
/// require_vectors() has checked.
void GltfAccessors::decode(std::size_t view, const CompressedVectors& positions,
                           std::span<const CompressedVectors> others, Stream& stream) {
  const std::string_view bytes = view_bytes(view).first;
  std::vector<std::size_t> ids{positions.attribute};
  for (const CompressedVectors& other : others) ids.push_back(other.attribute);
  in_.with_where(GltfDocument::entry("bufferViews", view), [&] {
    const DracoMesh mesh(bytes, ids, context_);
    if (stream.times++ == 0) {
      stream.points = mesh.point_count();
      charge_.add(mesh.triangle_count() * 3 * sizeof(std::uint32_t), "compressed data");
      stream.corners = mesh.corners();
    }
    stream.asked.insert(ids.begin(), ids.end());
    const auto keep = [&](const CompressedVectors& wanted) {
      const std::size_t parts = parts_of(wanted.type);
      if (stream.vectors.contains(wanted.attribute) || !mesh.has(wanted.attribute, parts)) return;
      const std::size_t component = accessors_.at(wanted.accessor).component;
      charge_.add(stream.points * parts * component_bytes(component), "compressed data");
      stream.vectors.emplace(
          wanted.attribute,
          Stream::Vectors{component, parts, mesh.vectors(wanted.attribute, parts, component)});
    };
    keep(positions);
    for (const CompressedVectors& other : others) keep(other);
  });
}

/// Returns the vectors of a stream, if they were decoded in the form that their accessor states.
std::optional<GltfElements> GltfAccessors::vectors_in(const Stream& stream,
                                                      const CompressedVectors& wanted) {
  const Accessor& a =
      vectors_of(wanted.accessor, wanted.type, GltfDocument::entry("accessors", wanted.accessor));
  const auto found = stream.vectors.find(wanted.attribute);
  if (found == stream.vectors.end()) return {};
  const Stream::Vectors& vectors = found->second;
  if (vectors.component != a.component || vectors.parts != parts_of(wanted.type)) return {};
  return GltfElements{vectors.bytes, vectors.parts * component_bytes(vectors.component),
                      stream.points, vectors.component, a.is_normalized};
}

}  // namespace plumb
