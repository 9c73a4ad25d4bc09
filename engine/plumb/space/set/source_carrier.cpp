#include "plumb/space/set/source_carrier.h"

#include <algorithm>
#include <string>

#include "plumb/predicates/error.h"
#include "plumb/space/mesh/face_corners.h"

namespace plumb {
namespace {

bool is_same_source(const PlacedSource& a, const PlacedSource& b) {
  return a.source == b.source && a.map.matrix == b.map.matrix && a.map.offset == b.map.offset;
}

/// Returns the map that applies `first` and then `second`.
AffineMap3 composed(const AffineMap3& second, const AffineMap3& first) {
  AffineMap3 both;
  for (std::size_t i = 0; i < 3; ++i) {
    both.offset[i] = second.offset[i];
    for (std::size_t k = 0; k < 3; ++k) {
      both.offset[i] += second.matrix[i][k] * first.offset[k];
      for (std::size_t j = 0; j < 3; ++j) {
        both.matrix[i][j] += second.matrix[i][k] * first.matrix[k][j];
      }
    }
  }
  return both;
}

AffineMap3 identity_map() {
  const Rational zero = 0, one = 1;
  return {{{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}, {zero, zero, zero}};
}

void require_indices(std::span<const std::uint32_t> indices, std::size_t end, const char* what) {
  for (const std::uint32_t i : indices) {
    if (i != MeshAttributes::kNone && i >= end) {
      throw Error(ErrorCode::BadArgument, std::string("a face of a mesh refers to no ") + what);
    }
  }
}

void require_different_names(std::span<const MeshChannel> channels) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (channels[j].name == channels[i].name) {
        throw Error(ErrorCode::BadArgument, "two channels of a mesh have the same name");
      }
    }
  }
}

void require_plane(const MeshSource& source) {
  const Plane3& plane = *source.plane;
  if (plane.a == 0 && plane.b == 0 && plane.c == 0) {
    throw Error(ErrorCode::BadArgument, "a plane needs a normal that is not zero");
  }
  if (source.mesh.face_count() > 0 || !source.attributes.channels.empty()) {
    throw Error(ErrorCode::BadArgument, "a source that is a plane has neither faces nor channels");
  }
}

}  // namespace

PolygonMesh copied_mesh(const MeshView& mesh) {
  PolygonMesh copy;
  copy.points.reserve(mesh.point_count());
  for (std::size_t i = 0; i < mesh.point_count(); ++i) copy.points.push_back(mesh.point(i));
  copy.exact.assign(mesh.exact.begin(), mesh.exact.end());
  copy.face_begin.reserve(mesh.face_count() + 1);
  copy.corners.reserve(mesh.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) copy.add_face(mesh.face(f));
  return copy;
}

void require_consistent(const MeshSource& source) {
  const MeshAttributes& attributes = source.attributes;
  if (source.plane) require_plane(source);
  const std::size_t faces = source.plane ? 1 : source.mesh.face_count();
  require_sizes(attributes, faces, source.mesh.corners.size());
  require_indices(attributes.face_material, attributes.materials.size(), "material");
  require_indices(attributes.face_group, attributes.groups.size(), "group");
  for (const std::uint32_t v : source.mesh.corners) {
    if (v >= source.mesh.points.size()) {
      throw Error(ErrorCode::BadArgument, "a corner of a mesh refers to no point");
    }
  }
  for (const auto& [v, place] : source.mesh.exact) {
    if (v >= source.mesh.points.size()) {
      throw Error(ErrorCode::BadArgument, "exact coordinates of a mesh refer to no point");
    }
  }
  require_different_names(attributes.channels);
}

Nef3 from_source(std::shared_ptr<const MeshSource> source, const FromMeshOptions& options,
                 Context& context) {
  if (source == nullptr) throw Error(ErrorCode::BadArgument, "a source must not be null");
  require_consistent(*source);
  if (source->plane) {
    return Nef3::half_space(*source->plane, Boundary::Closed).with_source(std::move(source));
  }
  return Nef3::from_mesh(source->mesh, options, context).with_source(std::move(source));
}

Nef3 Nef3::with_source(std::shared_ptr<const MeshSource> source) const {
  const PlacedSource placed{std::move(source), identity_map()};
  return with_sources({&placed, 1});
}

namespace {

void require_invertible(const AffineMap3& map) {
  const auto& m = map.matrix;
  const Rational determinant(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
  if (determinant == 0) throw Error(ErrorCode::BadArgument, "the map of a source is singular");
}

}  // namespace

Nef3 Nef3::with_sources(std::span<const PlacedSource> sources) const {
  for (const PlacedSource& placed : sources) {
    if (placed.source == nullptr) {
      throw Error(ErrorCode::BadArgument, "a source must not be null");
    }
    require_consistent(*placed.source);
    require_invertible(placed.map);
  }
  Nef3 result = *this;
  result.sources_.reset();
  if (!sources.empty()) {
    result.sources_ =
        std::make_shared<const std::vector<PlacedSource>>(sources.begin(), sources.end());
  }
  return result;
}

std::span<const PlacedSource> Nef3::sources() const {
  if (sources_ == nullptr) return {};
  return *sources_;
}

SourceLists::List SourceLists::joined(const List& first, const List& second) {
  if (second == nullptr || first == second) return first;
  if (first == nullptr) return second;
  auto both = std::make_shared<std::vector<PlacedSource>>(*first);
  for (const PlacedSource& placed : *second) {
    const bool is_known = std::any_of(first->begin(), first->end(), [&](const PlacedSource& other) {
      return is_same_source(other, placed);
    });
    if (!is_known) both->push_back(placed);
  }
  return both;
}

SourceLists::List SourceLists::joined(std::span<const Nef3> sets) {
  List list;
  std::shared_ptr<std::vector<PlacedSource>> all;  // Set only if several sets have sources.
  std::unordered_multimap<const MeshSource*, std::size_t> known;
  const auto add = [&](const PlacedSource& placed) {
    const auto [first, last] = known.equal_range(placed.source.get());
    const bool is_known = std::any_of(
        first, last, [&](const auto& at) { return is_same_source((*all)[at.second], placed); });
    if (is_known) return;
    known.emplace(placed.source.get(), all->size());
    all->push_back(placed);
  };
  for (const Nef3& set : sets) {
    const List own = SourceCarrier::of(set);
    if (own == nullptr || own == list) continue;
    if (list == nullptr) {
      list = own;
      continue;
    }
    if (all == nullptr) {
      all = std::make_shared<std::vector<PlacedSource>>();
      for (const PlacedSource& placed : *list) add(placed);
    }
    for (const PlacedSource& placed : *own) add(placed);
  }
  return all == nullptr ? list : List(all);
}

SourceLists::List SourceLists::mapped(const List& list, const AffineMap3& map) {
  if (list == nullptr) return list;
  auto result = std::make_shared<std::vector<PlacedSource>>(*list);
  for (PlacedSource& placed : *result) placed.map = composed(map, placed.map);
  return result;
}

}  // namespace plumb
