// Makes the mesh of the pieces of a boundary, rounds it, and computes the attributes of its faces.
//
// The corner of a face has the numbers of its piece at the corner's point. The point is the exact
// one, unless a repair has moved it. A corner of the source with the same coordinates has its own
// numbers, without arithmetic. Otherwise the barycentric weights are computed exactly, and rounded
// before the sum: on a common edge of two source triangles both give the same doubles, because the
// third weight is zero there. If pieces were joined, the point may lie outside the triangle that
// stands for all of them; the sum is then computed exactly, so that large weights cannot cancel.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/mesh_with_attributes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/rounded_point3.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/set/cut_boundary.h"
#include "plumb/space/set/round_mesh.h"
#include "plumb/space/set/source_triangles.h"

namespace plumb {
namespace {

// ---------------------------------------------------------------- the mesh

/// A point of the result that had to be rounded.
struct PointKey {
  std::array<std::uint64_t, 3> bits;
  explicit PointKey(const Point3& p)  // Both zeros have the same key.
      : bits{std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
             std::bit_cast<std::uint64_t>(p.z + 0.0)} {}
  friend bool operator==(const PointKey&, const PointKey&) = default;
};

struct PointKeyHash {
  std::size_t operator()(const PointKey& key) const noexcept {
    std::uint64_t h = 0x9e3779b97f4a7c15U;
    for (const std::uint64_t b : key.bits) h = (h ^ b ^ (b >> 32)) * 0xff51afd7ed558ccdU;
    return static_cast<std::size_t>(h ^ (h >> 29));
  }
};

/// For each point of the result that was rounded, its place before.
using PlacesBeforeRounding = std::unordered_map<PointKey, SpacePoint, PointKeyHash>;

/// Throws unless the closure of the interior is bounded.
void require_bounded(const SpaceComplex& complex) {
  const std::vector<std::uint8_t> is_far = unbounded_volumes(complex);
  for (std::size_t v = 0; v < complex.volume_count(); ++v) {
    if (is_far[v] != 0 && complex.volume_mark[v] == 1) {
      throw Error(ErrorCode::BadArgument, "an unbounded set has no mesh");
    }
  }
}

/// Whether attributes do not change between two pieces, which may lie in different planes.
bool have_same_constants(const CutBoundary& cut, const SourceTriangles& triangles, std::uint32_t p,
                         std::uint32_t q) {
  const std::uint32_t s = cut.pieces[p].triangle, t = cut.pieces[q].triangle;
  if (p == q) return true;
  return s == kNone || t == kNone ? s == t : triangles.has_same_constants(s, t);
}

/// Returns the mesh of the pieces of a boundary. Lists its rounded points.
MeshToRound mesh_of_pieces(const CutBoundary& cut, const SourceTriangles& triangles,
                           const SpaceComplex& complex) {
  MeshToRound result{{}, {}, &complex, {}};
  PolygonMesh& mesh = result.made.mesh;
  std::vector<std::uint32_t> index(complex.vertex_point.size(), kNone);
  std::vector<std::uint32_t> piece_at, is_mixed;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = cut.triangles[t][i];
      std::uint32_t& at = index[v.value()];
      if (at == kNone) {
        at = static_cast<std::uint32_t>(mesh.points.size());
        const RoundedPoint3 rounded_at = rounded(complex.points(), complex.vertex_point[v]);
        mesh.points.push_back(rounded_at.at);
        if (!rounded_at.is_exact) result.made.rounded.emplace_back(at, v);
        piece_at.push_back(cut.piece[t]);
        is_mixed.push_back(0);
      }
      if (!have_same_constants(cut, triangles, piece_at[at], cut.piece[t])) is_mixed[at] = 1;
      corners[i] = at;
    }
    mesh.add_face(corners);
    result.made.facet.push_back(FacetId(cut.piece[t]));
  }
  // A vertex between pieces marks where attributes change.
  for (std::uint32_t v = 0; v < is_mixed.size(); ++v) {
    if (is_mixed[v] != 0) result.kept.push_back(v);
  }
  std::vector<FacetId> facets;
  for (const std::uint32_t p : cut.piece) facets.push_back(cut.pieces[p].facet);
  result.solid = solids_at(complex, facets);
  return result;
}

/// Returns the places of points that are rounded. Where several round to the same point, the place
/// of one of them stands for all.
PlacesBeforeRounding places_before(const MeshToRound& input, CoordinateType type) {
  PlacesBeforeRounding places;
  const auto to_key = [&](Point3 p) {
    if (type == CoordinateType::Float) {
      p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }
    return PointKey(p);
  };
  for (const auto& [v, vertex] : input.made.rounded) {
    places.emplace(to_key(input.made.mesh.points[v]), input.complex->vertex_point[vertex]);
  }
  return places;
}

/// Sorts faces by their sources, and fills the runs.
void sort_by_source(std::size_t sources, std::vector<std::uint32_t>& piece,
                    MeshWithAttributes& result, const std::vector<FaceSource>& source_of_piece) {
  const PolygonMesh& mesh = result.mesh;
  const auto run_of = [&](std::uint32_t f) {
    return std::min<std::size_t>(source_of_piece[piece[f]].source, sources);
  };
  std::vector<std::uint32_t> order(mesh.face_count());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t f, std::uint32_t g) { return run_of(f) < run_of(g); });
  PolygonMesh sorted;
  sorted.points = mesh.points;
  std::vector<std::uint32_t> sorted_piece;
  result.run_begin.assign(sources + 2, 0);
  for (const std::uint32_t f : order) {
    sorted.add_face(mesh.face(f));
    sorted_piece.push_back(piece[f]);
    result.source.push_back(source_of_piece[piece[f]]);
    ++result.run_begin[run_of(f) + 1];
  }
  std::partial_sum(result.run_begin.begin(), result.run_begin.end(), result.run_begin.begin());
  result.mesh = std::move(sorted);
  piece = std::move(sorted_piece);
}

// ---------------------------------------------------------------- attributes of faces

/// Appends the materials and groups of all sources, and those of each face.
void fill_faces(std::span<const PlacedSource> sources, MeshWithAttributes& result) {
  MeshAttributes& to = result.attributes;
  bool has_material = false, has_group = false, has_id = false;
  std::vector<std::uint32_t> first_material, first_group;
  for (const PlacedSource& placed : sources) {
    const MeshAttributes& from = placed.source->attributes;
    first_material.push_back(static_cast<std::uint32_t>(to.materials.size()));
    first_group.push_back(static_cast<std::uint32_t>(to.groups.size()));
    to.materials.insert(to.materials.end(), from.materials.begin(), from.materials.end());
    to.groups.insert(to.groups.end(), from.groups.begin(), from.groups.end());
    has_material = has_material || !from.face_material.empty();
    has_group = has_group || !from.face_group.empty();
    has_id = has_id || !from.face_id.empty();
  }
  const auto value_at = [](const std::vector<std::uint32_t>& of_face, std::uint32_t face,
                           std::uint32_t first) {
    if (of_face.empty() || of_face[face] == MeshAttributes::kNone) return MeshAttributes::kNone;
    return of_face[face] + first;
  };
  for (const FaceSource& face : result.source) {
    static const MeshAttributes kNothing;
    const bool has_source = face.source != FaceSource::kNone;
    const MeshAttributes& from = has_source ? sources[face.source].source->attributes : kNothing;
    const std::uint32_t material = has_source ? first_material[face.source] : 0;
    const std::uint32_t group = has_source ? first_group[face.source] : 0;
    if (has_material) to.face_material.push_back(value_at(from.face_material, face.face, material));
    if (has_group) to.face_group.push_back(value_at(from.face_group, face.face, group));
    if (has_id) to.face_id.push_back(value_at(from.face_id, face.face, 0));
  }
}

// ---------------------------------------------------------------- numbers at corners

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

/// Transforms a normal; its length stays.
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

/// The weights of the corners of a source triangle at a point.
struct CornerWeights {
  std::array<double, 3> rounded;
  std::optional<std::array<Rational, 3>> exact;  // Given if the sum must be exact.
};

/// Computes numbers at the corners of the result.
class Interpolation {
 public:
  Interpolation(const CutBoundary& cut, const SpaceTables& tables, const SourceTriangles& sources,
                const PlacesBeforeRounding& places, MeshWithAttributes& result)
      : cut_(cut), tables_(tables), sources_(sources), places_(places), result_(result) {}

  void run(std::span<const std::uint32_t> piece, Context& context) {
    add_channels();
    if (result_.attributes.channels.empty()) return;
    for (std::size_t f = 0; f < piece.size(); ++f) {
      if (f % 1024 == 0) context.checkpoint("interpolate", f, piece.size());
      const BoundaryPiece& from = cut_.pieces[piece[f]];
      if (from.triangle == kNone) continue;
      for (std::size_t i = 0; i < 3; ++i) fill_corner(3 * f + i, from);
    }
  }

 private:
  /// Makes the channels of the result, and tells where each channel of a source goes.
  void add_channels() {
    auto& channels = result_.attributes.channels;
    for (const PlacedSource& placed : sources_.sources()) {
      std::vector<std::uint32_t> to;
      for (const MeshChannel& channel : placed.source->attributes.channels) {
        const auto known = std::find_if(channels.begin(), channels.end(),
                                        [&](const auto& c) { return c.name == channel.name; });
        to.push_back(static_cast<std::uint32_t>(known - channels.begin()));
        if (known == channels.end()) channels.push_back({channel.name, channel.width, {}});
        MeshChannel& target = channels[to.back()];
        target.width = std::max(target.width, channel.width);
      }
      target_.push_back(std::move(to));
      normal_map_.push_back(normal_map(placed.map));
      is_moved_.push_back(is_identity(placed.map) ? 0 : 1);
    }
    for (MeshChannel& channel : channels) {
      channel.values.assign(result_.mesh.corners.size() * channel.width,
                            channel.name == "color" ? 1 : 0);
    }
  }

  void fill_corner(std::size_t corner, const BoundaryPiece& from) {
    const SourceTriangle& triangle = sources_[from.triangle];
    if (sources_.is_plane(triangle)) return;
    const CornerWeights weights =
        weights_at(result_.mesh.points[result_.mesh.corners[corner]], triangle, from.is_joined);
    const auto& channels = sources_.sources()[triangle.source].source->attributes.channels;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (channels[c].values.empty()) continue;
      MeshChannel& to = result_.attributes.channels[target_[triangle.source][c]];
      const std::span<double> values =
          std::span(to.values).subspan(corner * to.width, channels[c].width);
      for (std::uint32_t k = 0; k < channels[c].width; ++k) {
        values[k] = value_of(channels[c], k, triangle, weights);
      }
      if (to.name != "normal" || channels[c].width != 3) continue;
      if (is_moved_[triangle.source] != 0) transform_normal(normal_map_[triangle.source], values);
      if (from.is_flipped) {
        for (double& value : values) value = 0 - value;
      }
    }
  }

  /// Returns number k of a channel. Equal numbers at all corners give this number.
  static double value_of(const MeshChannel& channel, std::uint32_t k,
                         const SourceTriangle& triangle, const CornerWeights& weights) {
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

  CornerWeights weights_at(const Point3& p, const SourceTriangle& triangle, bool is_joined) {
    std::array<RationalPoint3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const SpacePoint place = sources_.place(triangle, i);
      if (!place.is_input()) continue;
      const Point3& corner = tables_.planes.point(place.input());
      if (corner.x != p.x || corner.y != p.y || corner.z != p.z) continue;
      CornerWeights weights{{0, 0, 0}, {}};
      weights.rounded[i] = 1;
      return weights;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = exact(tables_.points, sources_.place(triangle, i));
    }
    const auto known = places_.find(PointKey(p));
    const RationalPoint3 at = known != places_.end() ? exact(tables_.points, known->second)
                                                     : RationalPoint3{p.x, p.y, p.z};
    std::array<Rational, 3> w = barycentric_weights(tables_.planes, triangle.plane, corners, at);
    const bool is_outside = w[0] < 0 || w[1] < 0 || w[2] < 0;
    CornerWeights weights{};
    if (is_outside && !is_joined) move_inside(w);
    for (std::size_t i = 0; i < 3; ++i) weights.rounded[i] = static_cast<double>(w[i]);
    if (is_outside && is_joined) weights.exact = std::move(w);
    return weights;
  }

  /// Replaces negative weights by 0; the others keep their ratio.
  static void move_inside(std::array<Rational, 3>& weights) {
    Rational sum = 0;
    for (Rational& w : weights) {
      if (w < 0) w = 0;
      sum += w;
    }
    for (Rational& w : weights) w /= sum;
  }

  const CutBoundary& cut_;
  const SpaceTables& tables_;
  const SourceTriangles& sources_;
  const PlacesBeforeRounding& places_;
  MeshWithAttributes& result_;
  std::vector<std::vector<std::uint32_t>> target_;  // For each channel of a source, its channel.
  std::vector<NormalMap> normal_map_;
  std::vector<std::uint8_t> is_moved_;
};

std::vector<FaceSource> sources_of(const CutBoundary& cut, const SourceTriangles& triangles) {
  std::vector<FaceSource> sources;
  sources.reserve(cut.pieces.size());
  for (const BoundaryPiece& piece : cut.pieces) {
    FaceSource source;
    if (piece.triangle != kNone) {
      const SourceTriangle& triangle = triangles[piece.triangle];
      source = {triangle.source, triangle.face, piece.is_flipped};
    }
    sources.push_back(source);
  }
  return sources;
}

}  // namespace

MeshWithAttributes mesh_with_attributes(const Nef3& set, const AttributeOptions& options,
                                        Context& context) {
  require_bounded(set.complex());
  SpaceComplex complex = set.complex();
  MemoryCharge memory(context);
  memory.add(2 * set.bytes(), "a set with attributes");
  constexpr std::uint64_t kPlaceBytes = 64, kCornerBytes = 64;
  for (const PlacedSource& placed : set.sources()) {
    const PolygonMesh& mesh = placed.source->mesh;
    memory.add(kPlaceBytes * mesh.points.size() + kCornerBytes * mesh.corners.size(),
               "the sources of a set");
  }
  const std::shared_ptr<SpaceTables> tables = copy(*complex.tables);
  complex.tables = tables;
  const SourceTriangles triangles(set.sources(), *tables, context);
  const CutBoundary cut = cut_boundary(complex, *tables, triangles, options.join, context);

  MeshToRound input = mesh_of_pieces(cut, triangles, complex);
  const PlacesBeforeRounding places = places_before(input, options.type);
  ValidMesh valid =
      round_mesh(std::move(input), {.faces = MeshFaces::Triangles}, options.type, context);

  MeshWithAttributes result;
  result.mesh = std::move(valid.made.mesh);
  result.repair = valid.repair;
  std::vector<std::uint32_t> piece;
  for (const FacetId id : valid.made.facet) piece.push_back(id.value());
  sort_by_source(set.sources().size(), piece, result, sources_of(cut, triangles));
  fill_faces(set.sources(), result);
  Interpolation(cut, *tables, triangles, places, result).run(piece, context);
  return result;
}

}  // namespace plumb
