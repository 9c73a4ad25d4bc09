// What glTF files are made of: a JSON document with buffers of bytes, affine maps of nodes, and
// triangles.
//
// A file that begins with "glTF" is binary, with chunks of JSON and of bytes; else the text is the
// JSON. A buffer is the chunk of bytes, base64 in its name (data:), or a file in the same folder.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/text/byte_order.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// The number of accessor items that are read between two checkpoints.
inline constexpr std::size_t kItemsPerCheckpoint = 4096;

/// The document of a file, and the chunk of bytes if it has one.
struct GltfContainer {
  std::string_view file;  ///< All bytes of the file.
  std::string name;
  bool is_binary = false;
  std::string_view json;
  std::optional<std::string_view> chunk;  ///< The chunk of bytes.

  /// Throws an error at a byte of the JSON: FILE:LINE:COLUMN in a text, "FILE: at byte N" in a
  /// binary file.
  [[noreturn]] void fail(std::size_t byte, ErrorCode code, const std::string& what) const;
};

/// Returns the container of a file. `bytes` must outlive it. Throws Error{UnknownFormat},
/// Error{CountMismatch} and Error{Syntax}, with the byte.
GltfContainer open_gltf(std::string_view bytes, const std::string& name);

/// Returns the bytes of a file in the folder of the file that is read, charged; `name` has no
/// slashes.
using GltfLoader = std::function<std::string(const std::string& name)>;

/// Returns a uri with codes such as %20 replaced. What is no code stays.
std::string decoded_uri(std::string_view uri);

/// Returns the bytes that a uri names, charged to the context. Throws errors without a place:
/// UnknownFormat, Syntax, CannotOpen for files outside the folder, or for all files if `loader` is
/// empty; and the exceptions of `loader`.
std::string bytes_of_uri(std::string_view uri, const GltfLoader& loader, Context& context);

// Where a node of glTF puts its mesh: affine maps of space, in doubles.

/// Rows of x' = m[0][0] x + m[0][1] y + m[0][2] z + m[0][3], and so on.
using GltfTransform = std::array<std::array<double, 4>, 3>;
inline constexpr GltfTransform kGltfIdentity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// Returns the map that applies b, then a.
inline GltfTransform product(const GltfTransform& a, const GltfTransform& b) {
  GltfTransform c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
    c[i][3] += a[i][3];
  }
  return c;
}

/// Whether the map mirrors: the exact sign of its determinant, which underflows in doubles.
/// Requires finite entries.
inline bool mirrors(const GltfTransform& m) {
  const auto row = [&m](std::size_t i) { return Point3{m[i][0], m[i][1], m[i][2]}; };
  return orient3d(row(0), row(1), row(2), Point3{0, 0, 0}) == Sign::Negative;
}

/// Returns the image of a point.
inline std::array<double, 3> applied(const GltfTransform& m, const std::array<double, 3>& p) {
  std::array<double, 3> q{};
  for (std::size_t k = 0; k < 3; ++k) {
    q[k] = m[k][0] * p[0] + m[k][1] * p[1] + m[k][2] * p[2] + m[k][3];
  }
  return q;
}

/// Returns the map of a matrix, listed by columns as in glTF.
inline GltfTransform from_matrix(const std::array<double, 16>& m) {
  GltfTransform t{};
  for (std::size_t i = 0; i < 3; ++i) t[i] = {m[i], m[4 + i], m[8 + i], m[12 + i]};
  return t;
}

/// Returns the map that scales, turns by a quaternion (x, y, z, w) of any length but zero, and
/// moves. Quarter turns are exact.
inline GltfTransform from_parts(const std::array<double, 4>& turn,
                                const std::array<double, 3>& scale,
                                const std::array<double, 3>& move) {
  const auto [x, y, z, w] = turn;
  const double n = x * x + y * y + z * z + w * w;
  GltfTransform t{{{w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w), 0},
                   {2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w), 0},
                   {2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z, 0}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) t[i][j] = t[i][j] / n * scale[j];
    t[i][3] = move[i];
  }
  return t;
}

// The triangles of glTF's primitives, as they are placed: numbers from buffers.

/// Component types, as accessors number them.
struct GltfComponent {
  static constexpr std::size_t kSignedByte = 5120, kByte = 5121, kSignedShort = 5122, kShort = 5123,
                               kInteger = 5125, kFloat = 5126;
};

/// Returns the bytes of a component; 0 if there is no such type.
constexpr std::size_t component_bytes(std::size_t component) {
  switch (component) {
    case GltfComponent::kSignedByte:
    case GltfComponent::kByte:
      return 1;
    case GltfComponent::kSignedShort:
    case GltfComponent::kShort:
      return 2;
    case GltfComponent::kInteger:
    case GltfComponent::kFloat:
      return 4;
    default:
      return 0;
  }
}
/// Modes, as primitives number them.
struct GltfMode {
  static constexpr std::size_t kTriangles = 4, kStrip = 5, kFan = 6;
};

/// The components of an accessor's elements: numbers that are not checked.
struct GltfElements {
  std::string_view bytes;
  std::size_t stride = 0;
  std::size_t count = 0;
  std::size_t component = 0;
  bool is_normalized = false;  ///< Integers stand for fractions of the largest one.

  template <class Number>
  Number at(std::size_t i, std::size_t part = 0) const {
    const char* const first = bytes.data() + i * stride + part * sizeof(Number);
    return from_bytes<Number>(first, std::endian::little);
  }
  std::uint32_t index(std::size_t i) const {
    if (component == GltfComponent::kByte) return at<std::uint8_t>(i);
    return component == GltfComponent::kShort ? at<std::uint16_t>(i) : at<std::uint32_t>(i);
  }
  /// Returns an element of N floats, bytes or shorts, as doubles. They are exact, except that
  /// fractions are rounded once.
  template <std::size_t N>
  std::array<double, N> numbers(std::size_t i) const {
    switch (component) {
      case GltfComponent::kFloat:
        return read<float, N>(i);
      case GltfComponent::kSignedByte:
        return integers<std::int8_t, N>(i);
      case GltfComponent::kByte:
        return integers<std::uint8_t, N>(i);
      case GltfComponent::kSignedShort:
        return integers<std::int16_t, N>(i);
      default:
        return integers<std::uint16_t, N>(i);
    }
  }

 private:
  template <class Number, std::size_t N>
  std::array<double, N> read(std::size_t i) const {
    std::array<double, N> all{};
    for (std::size_t part = 0; part < N; ++part) all[part] = at<Number>(i, part);
    return all;
  }
  /// A fraction is at least -1, although the range of integers is not symmetric.
  template <class Number, std::size_t N>
  std::array<double, N> integers(std::size_t i) const {
    std::array<double, N> all = read<Number, N>(i);
    constexpr double kLargest = std::numeric_limits<Number>::max();
    if (is_normalized) {
      for (double& value : all) value = std::max(value / kLargest, -1.0);
    }
    return all;
  }
};

/// The copies of a mesh at a node (EXT_mesh_gpu_instancing). What is missing is as for nodes.
struct GltfInstances {
  std::size_t count = 1;
  std::optional<GltfElements> turns, scales, moves;

  /// Whether the rotation of a copy is no quaternion.
  bool lacks_turn(std::size_t i) const {
    return turns && turns->numbers<4>(i) == std::array<double, 4>{};
  }
  GltfTransform transform(std::size_t i) const {
    return from_parts(turns ? turns->numbers<4>(i) : std::array<double, 4>{0, 0, 0, 1},
                      scales ? scales->numbers<3>(i) : std::array<double, 3>{1, 1, 1},
                      moves ? moves->numbers<3>(i) : std::array<double, 3>{});
  }
};

/// Numbers of the vertices of a primitive: colours, normals or texture coordinates.
struct GltfChannel {
  std::string name;         ///< The name, as in MeshChannel.
  std::uint32_t width = 0;  ///< 2, 3 or 4 numbers.
  GltfElements values;      ///< One element for each vertex.

  /// Returns the numbers of a vertex; those behind the width are 1.
  std::array<double, 4> at(std::size_t vertex) const;
};

/// A part of a mesh.
struct GltfPrimitive {
  std::size_t number;  ///< Number within its mesh.
  std::size_t mode;    ///< One of GltfMode.
  GltfElements positions;
  std::optional<GltfElements> indices;
  std::uint32_t material = MeshAttributes::kNone;  ///< Index into the materials of the document.
  std::vector<GltfChannel> channels = {};          ///< If attributes are kept.
  bool is_compressed = false;                      ///< Whether Draco compressed the vertices.
  /// The vectors that Draco compressed, by the names of attributes of glTF.
  std::map<std::string, GltfElements> decompressed = {};

  std::size_t corner_count() const { return indices ? indices->count : positions.count; }
};

/// Collects the triangles of primitives into a mesh.
class GltfTriangles {
 public:
  /// `name` is the file in messages.
  GltfTriangles(std::string name, Context& context)
      : name_(std::move(name)), context_(context), mesh_(context), charge_(context) {}

  /// Keeps the material of each triangle, and the channels of its corners.
  void keep_materials() { keeps_materials_ = true; }
  void pass_over(std::string_view what) { mesh_.pass_over(what); }
  void leave_out(std::string_view geometry) { mesh_.leave_out(geometry); }
  /// Returns how many triangles were added.
  std::size_t triangle_count() const { return mesh_.face_count(); }
  /// Adds a primitive. Requires at least 3 corners, and a number of corners that suits the mode.
  /// Throws "FILE: where: what": BadIndex, NumberOutOfRange, ResourceLimit; Cancelled.
  void add(const GltfPrimitive& p, const GltfTransform& placed, const std::string& where);
  /// Returns the mesh with equal points made one. Triangles with two equal corners are left out,
  /// with a note. If materials are kept, attributes.face_material has the materials of the
  /// document, and attributes.channels has the channels of all primitives.
  MeshFile take();

 private:
  [[noreturn]] void fail(ErrorCode code, const std::string& where, const std::string& what) const {
    throw Error(code, where + ": " + what, {name_});
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turns);
  std::uint64_t add_points(const GltfElements& positions, const GltfTransform& m,
                           const std::string& where);

  /// The numbers of a channel, at all corners up to the last corner that has numbers. Colours have
  /// four numbers until all are known.
  struct Collected {
    MeshChannel channel;
    bool has_opacity = false;
  };

  std::vector<Collected*> channels_of(const GltfPrimitive& p);
  void add_values(const GltfPrimitive& p, const std::vector<Collected*>& channels,
                  const GltfTransform& placed, bool is_mirrored,
                  const std::array<std::size_t, 3>& vertices);
  MeshChannel finished(Collected& from, const std::vector<std::uint32_t>& kept);

  /// The points that were added last.
  struct AddedPoints {
    GltfElements positions;
    GltfTransform m;
    std::uint64_t first;  ///< The number of the first point.
  };

  std::string name_;
  std::optional<AddedPoints> last_points_;
  Context& context_;
  MeshCollector mesh_;
  MemoryCharge charge_;  // Of channels.
  bool keeps_materials_ = false;
  std::vector<std::uint32_t> material_;  // Of each triangle, if they are kept.
  std::deque<Collected> collected_;
  std::size_t not_finite_ = 0;
};

}  // namespace plumb
