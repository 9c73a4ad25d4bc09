// Copies numbers from corners of sources, and interpolates them at all other corners.
//
// A corner of the result has the numbers of its piece at the corner's point. If the point equals a
// corner of the source after rounding, the numbers are copied; nearly all corners are of this kind.
// Otherwise the barycentric weights of the exact point are rounded before the sum: on a common edge
// of two source triangles both give the same doubles, because the third weight is zero there. Most
// constructed points are on an edge of one source and in a triangle of another one; doubles with
// error bounds give their weights (line_weights.h). All other weights are computed in integers. A
// point that a repair has moved is taken at its new place.
//
// If pieces were joined, the point may lie outside the triangle that stands for all of them; the
// sum is then computed exactly, so that large weights cannot cancel.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/corner_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/nearest_quotient.h"
#include "plumb/predicates/arithmetic/scaled.h"
#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/space/point_as_line.h"
#include "plumb/predicates/space/rounded_point3.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/set/barycentric_form.h"
#include "plumb/space/set/line_weights.h"

namespace plumb {
namespace {

Point3 rounded_to(CoordinateType type, const Point3& p) {
  if (type == CoordinateType::Double) return p;
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// Returns the homogeneous coordinates of a point of doubles.
IntegerRow row_of(const Point3& p) {
  const int low = std::min(Grid{p.x, p.y, p.z}.low(), 0);
  return {to_integer(p.x, low), to_integer(p.y, low), to_integer(p.z, low),
          shifted(Integer(1), -low)};
}

// ---------------------------------------------------------------- normals

/// The inverse transpose of the linear part of a map, up to a positive factor, in doubles.
using NormalMap = std::array<std::array<double, 3>, 3>;

NormalMap normal_map(const AffineMap3& map) {
  const auto& m = map.matrix;
  std::array<std::array<Rational, 3>, 3> cofactor;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactor[i][j] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    }
  }
  const Rational determinant =
      m[0][0] * cofactor[0][0] + m[0][1] * cofactor[0][1] + m[0][2] * cofactor[0][2];
  NormalMap result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i][j] = static_cast<double>(Rational(cofactor[i][j] / determinant));
    }
  }
  return result;
}

/// Transforms a normal. Its length does not change.
void transform_normal(const NormalMap& map, std::span<double> normal) {
  const std::array<double, 3> n{normal[0], normal[1], normal[2]};
  std::array<double, 3> image{};
  for (std::size_t i = 0; i < 3; ++i) {
    image[i] = map[i][0] * n[0] + map[i][1] * n[1] + map[i][2] * n[2];
  }
  const double before = std::hypot(n[0], n[1], n[2]);
  const double after = std::hypot(image[0], image[1], image[2]);
  if (!(after > 0)) return;
  for (std::size_t i = 0; i < 3; ++i) normal[i] = image[i] * (before / after);
}

// ---------------------------------------------------------------- one triangle

/// The weights of the corners of a source triangle at a point.
struct CornerWeights {
  std::array<double, 3> rounded;
  std::optional<std::array<Rational, 3>> exact;  // Set if the sum must be exact.
};

/// The source triangle of a piece, prepared for the corners of its faces. Results for a triangle
/// are kept until the next one, because faces of one triangle are consecutive.
class TriangleReader {
 public:
  explicit TriangleReader(const CornerInput& input) : input_(input) {}

  /// Moves to a piece that has a source triangle.
  void set(const BoundaryPiece& piece) {
    if (known_ == piece.triangle && cover_ == piece.cover) return;
    weights_.clear();
    cover_ = piece.cover;
    if (known_ == piece.triangle) return;
    known_ = piece.triangle;
    form_.reset();
    triangle_ = &input_.sources[known_];
    for (std::size_t i = 0; i < 3; ++i) at_[i] = rounded_corner(i);
  }
  const SourceTriangle& triangle() const { return *triangle_; }

  /// Returns the corner of the source whose rounded point is p, as an index of mesh.corners.
  /// Returns kNone if there is none.
  std::uint32_t corner_at(const Point3& p) {
    // Most faces follow the order of their triangle, so the corner after the last one is compared
    // first.
    constexpr std::array<std::uint8_t, 6> kCyclic{0, 1, 2, 0, 1, 2};
    for (std::size_t k = last_ + 1; k < last_ + 4; ++k) {
      const std::size_t i = kCyclic[k];
      if (at_[i] != p) continue;
      last_ = i;
      return triangle().corner[i];
    }
    if (cover_ != PieceCover::Face) return kNone;
    const PolygonMesh& mesh = input_.sources.mesh_of(triangle());
    for (std::uint32_t c = mesh.face_begin[triangle().face];
         c < mesh.face_begin[triangle().face + std::size_t{1}]; ++c) {
      const Point3* const at = input_.sources.doubles(triangle().source, mesh.corners[c]);
      if (at != nullptr && rounded_to(input_.type, *at) == p) return c;
    }
    return kNone;
  }

  /// Returns the weights at a point. Negative weights become 0, unless pieces were joined. The
  /// weights of the last points are kept, because several faces of a piece share their corners. The
  /// result is valid until the next call.
  const CornerWeights& weights_at(const Point3& p) {
    constexpr std::size_t kMost = 16;
    for (const auto& [at, weights] : weights_) {
      if (at == p) return weights;
    }
    if (weights_.size() == kMost) weights_.clear();
    return weights_.emplace_back(p, computed_weights(p)).second;
  }

 private:
  CornerWeights computed_weights(const Point3& p) {
    if (const auto certain = certain_weights(p)) return {*certain, {}};
    BarycentricWeights w = exact_weights(p);
    CornerWeights weights{};
    if (w.has_negative()) {
      if (cover_ == PieceCover::Triangle) {
        w.move_inside();
      } else {
        weights.exact = w.exact();
      }
    }
    weights.rounded = w.rounded();
    return weights;
  }
  /// Returns the rounded weights at a constructed point if doubles are certain of them: if the
  /// point is on an edge of the triangle, or where an edge of another triangle meets this one.
  std::optional<std::array<double, 3>> certain_weights(const Point3& p) const {
    const SpacePoint at = has_filter_ ? input_.places.constructed(p) : SpacePoint();
    if (!at.is_valid() || at.is_input()) return {};
    const CornerPoints corners = input_.sources.corner_points(triangle());
    const PlaneTable& planes = input_.points().planes();
    const PointSource line = exact3::as_line(planes, input_.points().source(at));
    if (!line.is_line()) return {};
    const LineEnds ends{planes.point(line.end(0)), planes.point(line.end(1))};
    const std::size_t i = corner_index(corners, ends[0]), j = corner_index(corners, ends[1]);
    if (i < 3 && j < 3 && i != j) {
      const PlaneSource& plane = planes.source(line.plane(0));
      if (plane.is_explicit()) return {};
      const auto weights = weights_on_line(ends, {planes.point(InputPointId(plane.code[0])),
                                                  planes.point(InputPointId(plane.code[1])),
                                                  planes.point(InputPointId(plane.code[2]))});
      if (!weights) return {};
      std::array<double, 3> result{};
      result[i] = (*weights)[0];
      result[j] = (*weights)[1];
      return result;
    }
    const bool has_corners =
        corners[0] != nullptr && corners[1] != nullptr && corners[2] != nullptr;
    if (!has_corners || line.plane(0) != triangle().plane) return {};
    return weights_of_corners({*corners[0], *corners[1], *corners[2]}, ends);
  }
  /// Most points at which triangles are cut lie on an edge, where the weights need few products.
  BarycentricWeights exact_weights(const Point3& p) {
    const IntegerRow& row = input_.places.row(input_.points(), p);
    const SpacePoint at = input_.places.constructed(p);
    if (at.is_valid()) {
      const CornerPoints corners = input_.sources.corner_points(triangle());
      const std::size_t edge = input_.sources.edge_of(triangle(), corners, at);
      if (edge < 3 && corners[edge] != nullptr && corners[(edge + 1) % 3] != nullptr) {
        return weights_on_edge(corners, edge, row);
      }
    }
    return form().at(row);
  }
  Point3 rounded_corner(std::size_t i) {
    const Point3* const doubles = input_.sources.doubles(triangle(), i);
    if (doubles != nullptr) return rounded_to(input_.type, *doubles);
    const SpacePoint place = input_.sources.place(triangle(), i);
    return rounded_to(input_.type, rounded(input_.points(), place).at);
  }

  const BarycentricForm& form() {
    if (form_) return *form_;
    std::array<IntegerRow, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3* const doubles = input_.sources.doubles(triangle(), i);
      if (doubles != nullptr) {
        rows[i] = row_of(*doubles);
        continue;
      }
      // The call may change the tables.
      const SpacePoint place = input_.sources.place(triangle(), i);
      rows[i] = homogeneous(input_.points(), place);
    }
    form_.emplace(FlatView::of_plane(input_.points().planes(), triangle().plane), rows);
    return *form_;
  }

  const CornerInput& input_;
  const bool has_filter_ = rounds_to_nearest();
  std::uint32_t known_ = kNone;
  const SourceTriangle* triangle_ = nullptr;  // The triangle with the index known_.
  PieceCover cover_ = PieceCover::Triangle;
  std::array<Point3, 3> at_{};  // The rounded corners.
  std::size_t last_ = 2;        // The corner that was found last.
  std::optional<BarycentricForm> form_;
  // The weights at some points of the triangle.
  std::vector<std::pair<Point3, CornerWeights>> weights_;
};

/// Returns number k of a channel. Equal numbers at all corners give this number.
double value_of(const MeshChannel& channel, std::uint32_t k, const SourceTriangle& triangle,
                const CornerWeights& weights) {
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = channel.values[std::size_t{triangle.corner[i]} * channel.width + k];
  }
  if (v[0] == v[1] && v[1] == v[2]) return v[0];
  const bool is_finite = std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  if (weights.exact && is_finite) {
    Rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += (*weights.exact)[i] * v[i];
    return static_cast<double>(sum);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights.rounded[i] == 1) return v[i];
  }
  // A corner of weight 0 takes no part, so that numbers beside an edge do not change its values.
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights.rounded[i] != 0) sum += weights.rounded[i] * v[i];
  }
  return sum;
}

// ---------------------------------------------------------------- all corners

/// Computes numbers at the corners of the result.
class ChannelWriter {
 public:
  ChannelWriter(const CornerInput& input, MeshWithAttributes& result)
      : input_(input), result_(result), reader_(input) {}

  void run(std::span<const std::uint32_t> piece, Context& context) {
    add_channels();
    if (result_.attributes.channels.empty()) return;
    const PolygonMesh& mesh = result_.mesh;
    for (std::size_t f = 0; f < piece.size(); ++f) {
      if (f % 1024 == 0) context.checkpoint("interpolate", f, piece.size());
      if (f + kAhead < piece.size()) prefetch(input_.cut.pieces[piece[f + kAhead]].triangle);
      const BoundaryPiece& from = input_.cut.pieces[piece[f]];
      if (from.triangle == kNone) continue;
      reader_.set(from);
      if (input_.sources.is_plane(reader_.triangle())) continue;
      for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
        fill_corner(c, from.is_flipped);
      }
    }
  }

 private:
  static constexpr std::size_t kAhead = 12;  // The number of faces.

  /// The path of the numbers of a channel.
  struct Way {
    const MeshChannel* from;  ///< The channel of a source.
    std::uint32_t to;         ///< The index of the channel of the result.
    std::uint32_t to_width;   ///< The width of the channel of the result.
    double* values;           ///< The numbers of the channel of the result.
    bool is_normal;           ///< Whether the numbers are normals.
  };

  /// Makes the channels of the result, and finds the target of each channel of a source.
  void add_channels() {
    auto& channels = result_.attributes.channels;
    for (const PlacedSource& placed : input_.sources.sources()) {
      std::vector<Way> ways;
      for (const MeshChannel& channel : placed.source->attributes.channels) {
        const auto known = std::find_if(channels.begin(), channels.end(),
                                        [&](const auto& c) { return c.name == channel.name; });
        const auto to = static_cast<std::uint32_t>(known - channels.begin());
        if (known == channels.end()) channels.push_back({channel.name, channel.width, {}});
        MeshChannel& target = channels[to];
        target.width = std::max(target.width, channel.width);
        const bool is_normal = channel.name == "normal" && channel.width == 3;
        if (!channel.values.empty()) ways.push_back({&channel, to, 0, nullptr, is_normal});
      }
      ways_.push_back(std::move(ways));
      const bool is_moved = !is_identity(placed.map);
      is_moved_.push_back(is_moved ? 1 : 0);
      normal_map_.push_back(is_moved ? normal_map(placed.map) : NormalMap{});
    }
    for (MeshChannel& channel : channels) {
      channel.values.assign(result_.mesh.corners.size() * channel.width,
                            channel.name == "color" ? 1 : 0);
    }
    for (std::vector<Way>& ways : ways_) {
      for (Way& way : ways) {
        way.to_width = channels[way.to].width;
        way.values = channels[way.to].values.data();
      }
    }
  }

  /// Prefetches the numbers at the corners of a triangle, which are far in memory from those of the
  /// last triangle.
  void prefetch(std::uint32_t t) const {
    if (t == kNone) return;
    const SourceTriangle& triangle = input_.sources[t];
    for (const Way& way : ways_[triangle.source]) {
      __builtin_prefetch(&way.from->values[std::size_t{triangle.corner[0]} * way.from->width]);
      __builtin_prefetch(&way.from->values[std::size_t{triangle.corner[2]} * way.from->width]);
    }
  }

  void fill_corner(std::uint32_t corner, bool is_flipped) {
    const Point3& p = result_.mesh.points[result_.mesh.corners[corner]];
    const std::uint32_t source_corner = reader_.corner_at(p);
    const CornerWeights* const weights = source_corner == kNone ? &reader_.weights_at(p) : nullptr;
    const std::uint32_t source = reader_.triangle().source;
    for (const Way& way : ways_[source]) {
      const MeshChannel& from = *way.from;
      double* const values = way.values + std::size_t{corner} * way.to_width;
      if (weights == nullptr) {
        const double* const own = from.values.data() + std::size_t{source_corner} * from.width;
        for (std::uint32_t k = 0; k < from.width; ++k) values[k] = own[k];
      } else {
        for (std::uint32_t k = 0; k < from.width; ++k) {
          values[k] = value_of(from, k, reader_.triangle(), *weights);
        }
      }
      if (way.is_normal) turn_normal(source, is_flipped, std::span(values, 3));
    }
  }

  void turn_normal(std::uint32_t source, bool is_flipped, std::span<double> normal) const {
    if (is_moved_[source] != 0) transform_normal(normal_map_[source], normal);
    if (!is_flipped) return;
    for (double& value : normal) value = 0 - value;
  }

  const CornerInput& input_;
  MeshWithAttributes& result_;
  TriangleReader reader_;
  std::vector<std::vector<Way>> ways_;  // For each source, the data of its channels.
  std::vector<NormalMap> normal_map_;
  std::vector<std::uint8_t> is_moved_;
};

}  // namespace

std::size_t PlacesBeforeRounding::KeyHash::operator()(const Key& key) const noexcept {
  return SeededHash{}(key);
}

PlacesBeforeRounding::Key PlacesBeforeRounding::key_of(const Point3& p) {
  // Both zeros have the same key.
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
          std::bit_cast<std::uint64_t>(p.z + 0.0)};
}

PlacesBeforeRounding::PlacesBeforeRounding(const MeshToRound& input, CoordinateType type) {
  const SpaceComplex& complex = *input.complex;
  const std::vector<Point3>& points = input.made.mesh.points;
  for (const auto& [v, vertex] : input.made.rounded) {
    places_.emplace(key_of(rounded_to(type, points[v])),
                    Place{complex.vertex_point[vertex], points[v], {}});
  }
  if (type == CoordinateType::Double) return;
  for (const Point3& p : points) places_.emplace(key_of(rounded_to(type, p)), Place{{}, p, {}});
}

const IntegerRow& PlacesBeforeRounding::row(const Point3Table& points, const Point3& p) {
  const auto known = places_.find(key_of(p));
  if (known == places_.end()) return itself_ = row_of(p);
  Place& place = known->second;
  if (place.row[3].is_zero()) {
    place.row = place.at.is_valid() ? homogeneous(points, place.at) : row_of(place.nearest);
  }
  return place.row;
}

SpacePoint PlacesBeforeRounding::constructed(const Point3& p) const {
  const auto known = places_.find(key_of(p));
  return known == places_.end() ? SpacePoint() : known->second.at;
}

void fill_channels(const CornerInput& input, std::span<const std::uint32_t> piece,
                   MeshWithAttributes& result, Context& context) {
  ChannelWriter(input, result).run(piece, context);
}

}  // namespace plumb
