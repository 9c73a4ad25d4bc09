// The triangles of glTF's primitives, as they are placed: numbers out of buffers, whatever names them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/base/context.h"
#include "plumb/base/error.h"
#include "plumb/io/gltf_transform.h"
#include "plumb/io/mesh_collector.h"
#include "plumb/io/mesh_file.h"

namespace plumb {

/// As accessors number them.
struct GltfComponent {
  static constexpr std::size_t kByte = 5121, kShort = 5123, kInteger = 5125, kFloat = 5126;
};
/// As primitives number them.
struct GltfMode {
  static constexpr std::size_t kTriangles = 4, kStrip = 5, kFan = 6;
};

/// The parts of an accessor's elements, unchecked numbers.
struct GltfElements {
  std::string_view bytes;
  std::size_t stride = 0;
  std::size_t count = 0;
  std::size_t component = 0;

  template <class Number>
  Number at(std::size_t i, std::size_t part = 0) const {
    Number value;
    std::memcpy(&value, bytes.data() + i * stride + part * sizeof(Number), sizeof(Number));
    return value;
  }
  std::uint32_t index(std::size_t i) const {
    if (component == GltfComponent::kByte) return at<std::uint8_t>(i);
    return component == GltfComponent::kShort ? at<std::uint16_t>(i) : at<std::uint32_t>(i);
  }
};

/// A part of a mesh.
struct GltfPrimitive {
  std::size_t number;  ///< in its mesh
  std::size_t mode;    ///< of GltfMode
  GltfElements positions;
  std::optional<GltfElements> indices;

  std::size_t corner_count() const { return indices ? indices->count : positions.count; }
};

/// Collects them into a mesh.
class GltfTriangles {
 public:
  /// `name`: the file in messages.
  GltfTriangles(std::string name, Context& context)
      : name_(std::move(name)), context_(context), mesh_(context) {}

  void pass_over(std::string_view what) { mesh_.pass_over(what); }
  /// Requires at least 3 corners, and as the mode wants them. Throws Error "FILE: where: what": BadIndex,
  /// NumberOutOfRange, ResourceLimit; Cancelled.
  void add(const GltfPrimitive& p, const GltfTransform& placed, const std::string& where);
  /// With equal points made one. Triangles that have two equal corners are left out, and told.
  MeshFile take();

 private:
  [[noreturn]] void fail(ErrorCode code, const std::string& where, const std::string& what) const {
    throw Error(code, where + ": " + what, {name_});
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turns);
  std::uint64_t add_points(const GltfElements& positions, const GltfTransform& m,
                           const std::string& where);

  std::string name_;
  Context& context_;
  MeshCollector mesh_;
  std::size_t dropped_ = 0;
};

}  // namespace plumb
