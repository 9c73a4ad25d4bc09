// Rounds a mesh and repairs what rounding has damaged, round by round.
//
// Most damage is local: where vertices are nearly on a line or nearly in a plane, rounding folds
// thin triangles over their neighbours. snap_damaged() makes the parts that nearly touch meet in
// common vertices, at first those within one unit of the last digit. If the damage does not shrink,
// the distance doubles. Where nothing is near, mended() takes out each solid (marked volume) with a
// damaged face: the sum of the winding numbers of these solids is an integer at every point off
// their faces, and the points where it is positive form the new solids. Solids without damaged
// faces cross no other face, so they need not take part.
//
// Both steps can cause new damage. They end after a few rounds in practice. To end in any case, the
// damaged solids are snapped to a coarser grid after each kRoundsOfAGrid rounds. If the step of the
// grid exceeds the size of the solids, all their vertices coincide, and nothing is left of them.
// docs/design/mesh-rounding.md has the proofs.
//
// Tested by tests/space/valid_mesh_test.cpp.
#include "plumb/space/valid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/base/internal/union_find.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/mesh/snap_near.h"
#include "plumb/space/weld_points.h"

namespace plumb {
namespace {

constexpr int kWidestSnap = 6;                // 2^6 units of the last digit.
constexpr std::uint32_t kRoundsOfAGrid = 60;  // Rounds before the units become coarser.
constexpr int kCoarser = 4;                   // By 2^4.

/// A mesh during the repair. Parallel to its faces are their facets and their solids.
struct Draft {
  PolygonMesh mesh;
  std::vector<FacetId> facet;        ///< The facet of the set from which a face was made.
  std::vector<std::uint32_t> solid;  ///< The solid that a face bounds.
  std::uint32_t solid_count = 0;

  void add_face(std::span<const std::uint32_t> corners, FacetId f, std::uint32_t s) {
    mesh.add_face(corners);
    facet.push_back(f);
    solid.push_back(s);
  }
};

/// Returns the marked volume at a facet of the boundary of the closure of the interior.
VolumeId solid_at(const SpaceComplex& complex, FacetId f) {
  const auto [front, back] = complex.facet_volume[f];
  return complex.volume_mark[front] == 1 ? front : back;
}

// ---------------------------------------------------------------- damage

/// What rounding has done to the faces of a draft.
struct Damage {
  std::vector<std::uint8_t> of_face;            ///< 1 for each damaged face.
  std::vector<std::uint8_t> of_solid;           ///< 1 for each solid with a damaged face.
  std::vector<RoundingReport::FacePair> pairs;  ///< The pairs of faces that cross or coincide.
  std::uint64_t faces = 0;                      ///< The number of damaged faces.
  bool has_only_flipped = false;    ///< Whether the damaged faces are flipped and nothing else.
  bool has_equal_vertices = false;  ///< Whether vertices coincide that did not before.
};

/// Finds damage. A polygon that is not flat counts as damage, unless `faces` allows it.
Damage find_damage(const Draft& draft, MeshFaces faces, Context& context) {
  const RoundingReport found =
      check_rounding(draft.mesh, std::numeric_limits<std::uint64_t>::max(), context);
  Damage damage{std::vector<std::uint8_t>(draft.mesh.face_count(), 0),
                std::vector<std::uint8_t>(draft.solid_count, 0),
                found.crossings,
                0,
                false,
                found.vertices_merged > 0};
  damage.pairs.insert(damage.pairs.end(), found.doubled.begin(), found.doubled.end());
  const auto note = [&](std::uint32_t f) {
    damage.faces += damage.of_face[f] == 0 ? 1 : 0;
    damage.of_face[f] = 1;
    damage.of_solid[draft.solid[f]] = 1;
  };
  std::ranges::for_each(found.degenerate, note);
  std::ranges::for_each(found.not_simple, note);
  if (faces != MeshFaces::Polygons) std::ranges::for_each(found.not_planar, note);
  for (const auto* const pairs : {&found.doubled, &found.crossings}) {
    for (const auto& [f, g] : *pairs) {
      note(f);
      note(g);
    }
  }
  if (damage.faces == 0) {
    damage.has_only_flipped = !found.flipped.empty();
    std::ranges::for_each(found.flipped, note);
  }
  return damage;
}

// ---------------------------------------------------------------- snapping

double largest_coordinate(const PolygonMesh& mesh) {
  double largest = 0;
  for (const std::uint32_t v : mesh.corners) {
    const Point3& p = mesh.points[v];
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return largest;
}

/// Lists the chosen points in mesh.exact, too, as if they had moved: faces at them are then
/// checked.
void list_points(PolygonMesh& mesh, const std::vector<std::uint8_t>& is_chosen) {
  std::vector<std::pair<std::uint32_t, RationalPoint3>> list;
  auto exact = mesh.exact.begin();
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (exact != mesh.exact.end() && exact->first == v) {
      list.push_back(std::move(*exact++));
    } else if (is_chosen[v] != 0) {
      const Point3& p = mesh.points[v];
      list.emplace_back(v, RationalPoint3{p.x, p.y, p.z});
    }
  }
  mesh.exact = std::move(list);
}

/// Snaps damaged parts of the draft that are at most `width` apart. Returns a bound of the
/// distances by which faces moved, or nullopt if nothing is near.
std::optional<double> snap_damaged(Draft& draft, const Damage& damage, double width) {
  SnappedMesh snapped = snap_near(draft.mesh, damage.of_face, damage.pairs, width);
  if (snapped.changed.empty()) return std::nullopt;
  Draft next;
  next.solid_count = draft.solid_count;
  std::vector<std::uint8_t> is_checked(draft.mesh.points.size(), 0);
  for (std::uint32_t f = 0; f < snapped.origin.size(); ++f) {
    const std::uint32_t from = snapped.origin[f];
    next.facet.push_back(draft.facet[from]);
    next.solid.push_back(draft.solid[from]);
    if (damage.of_face[from] == 0 && snapped.changed[from] == 0) continue;
    for (const std::uint32_t v : snapped.mesh.face(f)) is_checked[v] = 1;
  }
  next.mesh = std::move(snapped.mesh);
  next.mesh.exact = std::move(draft.mesh.exact);
  list_points(next.mesh, is_checked);
  draft = std::move(next);
  return snapped.largest_move;
}

/// Moves the points of damaged solids to multiples of 2^exponent, towards zero, so that no
/// coordinate grows. Returns a bound of the distances.
double snap_to_grid(Draft& draft, const Damage& damage, int exponent) {
  const auto snapped = [exponent](double value) {
    return std::ldexp(std::trunc(std::ldexp(value, -exponent)), exponent);
  };
  std::vector<std::uint8_t> is_moved(draft.mesh.points.size(), 0);
  for (std::uint32_t f = 0; f < draft.solid.size(); ++f) {
    if (damage.of_solid[draft.solid[f]] == 0) continue;
    for (const std::uint32_t v : draft.mesh.face(f)) is_moved[v] = 1;
  }
  for (std::uint32_t v = 0; v < is_moved.size(); ++v) {
    Point3& p = draft.mesh.points[v];
    if (is_moved[v] != 0) p = {snapped(p.x), snapped(p.y), snapped(p.z)};
  }
  list_points(draft.mesh, is_moved);
  return std::ldexp(1.7321, exponent);  // More than the diagonal of a cube of the grid.
}

// ---------------------------------------------------------------- solids

/// Returns 1 for each damaged solid and for each solid that is connected with a damaged one by
/// common vertices. A set of one of them alone would not have the vertices at which others touch
/// it.
std::vector<std::uint8_t> connected_with_damage(const Draft& draft, const Damage& damage) {
  UnionFind classes(draft.solid_count);
  std::vector<std::uint32_t> solid_of_point(draft.mesh.points.size(), kNone);
  for (std::uint32_t f = 0; f < draft.solid.size(); ++f) {
    for (const std::uint32_t v : draft.mesh.face(f)) {
      if (solid_of_point[v] == kNone) solid_of_point[v] = draft.solid[f];
      classes.unite(solid_of_point[v], draft.solid[f]);
    }
  }
  std::vector<std::uint8_t> has_damage(draft.solid_count, 0), result(draft.solid_count, 0);
  for (std::uint32_t s = 0; s < draft.solid_count; ++s) {
    if (damage.of_solid[s] != 0) has_damage[classes.root(s)] = 1;
  }
  for (std::uint32_t s = 0; s < draft.solid_count; ++s) result[s] = has_damage[classes.root(s)];
  return result;
}

/// Appends a mesh of a set that bounds new solids.
void append(const MeshOfComplex& made, const SpaceComplex& complex, std::span<const FacetId> facet,
            Draft& draft) {
  const auto first = static_cast<std::uint32_t>(draft.mesh.points.size());
  draft.mesh.points.insert(draft.mesh.points.end(), made.mesh.points.begin(),
                           made.mesh.points.end());
  for (const auto& [v, p] : made.mesh.exact) draft.mesh.exact.emplace_back(first + v, p);
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    corners.clear();
    for (const std::uint32_t v : made.mesh.face(f)) corners.push_back(first + v);
    const FacetId from = made.facet[f];
    const std::uint32_t solid = draft.solid_count + solid_at(complex, from).value();
    draft.add_face(corners, facet[complex.facet_origin[from]], solid);
  }
  draft.solid_count += static_cast<std::uint32_t>(complex.volume_count());
}

/// Replaces the damaged solids, and those that touch them, by the points of positive winding
/// number.
Draft mended(Draft draft, const Damage& damage, const ToMeshOptions& options, Context& context) {
  draft.mesh.exact.clear();
  weld_points(draft.mesh, 0, context);
  const std::vector<std::uint8_t> is_broken = connected_with_damage(draft, damage);
  Draft kept;
  kept.solid_count = draft.solid_count;
  PolygonMesh broken;
  std::vector<FacetId> facet;  // Of the faces of `broken`.
  for (std::uint32_t f = 0; f < draft.solid.size(); ++f) {
    const auto corners = draft.mesh.face(f);
    if (is_broken[draft.solid[f]] != 0) {
      broken.add_face(corners);
      facet.push_back(draft.facet[f]);
    } else {
      kept.add_face(corners, draft.facet[f], draft.solid[f]);
    }
  }
  broken.points = draft.mesh.points;
  kept.mesh.points = std::move(draft.mesh.points);
  const Nef3 set = Nef3::from_mesh(broken, {.rule = WindingRule::Positive}, context);
  append(mesh_of_complex(set.complex(), options, context), set.complex(), facet, kept);
  return kept;
}

// ---------------------------------------------------------------- rounds

/// Repairs a draft, round by round. It is a class for what a round has to know of earlier ones.
class RoundingRepairer {
 public:
  RoundingRepairer(const ToMeshOptions& options, CoordinateType type, RoundingRepair& repair,
                   Context& context)
      : options_(options), type_(type), repair_(repair), context_(context) {}

  /// Returns the draft without damage. `damage` is that of the draft.
  Draft run(Draft draft, Damage damage) {
    std::uint64_t fewest = damage.faces;  // Damaged faces since the last round that made new ones.
    while (damage.faces > 0 && !(damage.has_only_flipped && flipped_rounds_ >= kFlippedRounds)) {
      context_.checkpoint("repair rounding", repair_.rounds, 0);
      ++repair_.rounds;
      repair_.damaged_faces += damage.faces;
      flipped_rounds_ += damage.has_only_flipped ? 1 : 0;
      repair_.largest_move += next(draft, damage);
      damage = find_damage(draft, options_.faces, context_);
      if (is_new_) fewest = damage.faces + 1;
      width_ = damage.faces < fewest ? 0 : width_ + 1;
      fewest = std::min(fewest, damage.faces);
    }
    return draft;
  }

 private:
  /// A surface that does not cross itself can be inside out only if it is as small as the errors.
  /// So a set is made of it, what is left of it is snapped, and that suffices.
  static constexpr int kFlippedRounds = 3;

  /// Makes one round. Returns a bound of the distances by which faces moved.
  double next(Draft& draft, const Damage& damage) {
    const int digit = last_digit_exponent(largest_coordinate(draft.mesh), type_);
    is_new_ = true;
    if (repair_.rounds % kRoundsOfAGrid == 0) {
      ++repair_.coarse_rounds;
      coarseness_ += kCoarser;
      return snap_to_grid(draft, damage, digit + coarseness_);
    }
    const bool may_snap = !damage.has_only_flipped || flipped_rounds_ == 2;
    for (; may_snap && width_ <= kWidestSnap; ++width_) {
      const double width = std::ldexp(1, digit + coarseness_ + width_);
      const auto move = snap_damaged(draft, damage, width);
      if (!move) continue;
      is_new_ = false;
      return *move;
    }
    draft = mended(std::move(draft), damage, options_, context_);
    return round_points(draft.mesh, type_);
  }

  const ToMeshOptions& options_;
  CoordinateType type_;
  RoundingRepair& repair_;
  Context& context_;
  int width_ = 0;       // The exponent of the distance that is snapped; it grows without progress.
  int coarseness_ = 0;  // The exponent of the unit.
  int flipped_rounds_ = 0;
  bool is_new_ = false;  // Whether the last round made new faces, not only snapped some.
};

// ---------------------------------------------------------------- the result

/// Returns V - E + F of a mesh, the Euler characteristic of its surface.
std::int64_t euler_characteristic(const PolygonMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(mesh.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    std::uint32_t from = face.back();
    for (const std::uint32_t to : face) {
      edges.push_back(std::minmax(from, to));
      from = to;
    }
  }
  const auto count_different = [](auto list) {
    std::ranges::sort(list);
    return static_cast<std::int64_t>(std::unique(list.begin(), list.end()) - list.begin());
  };
  return count_different(mesh.corners) - count_different(std::move(edges)) +
         static_cast<std::int64_t>(mesh.face_count());
}

/// The properties of a mesh that a repair should not change.
struct Topology {
  std::int64_t euler = 0;
  std::int64_t solids = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

Topology topology_of(const Draft& draft) {
  std::vector<std::uint8_t> is_seen(draft.solid_count, 0);
  for (const std::uint32_t s : draft.solid) is_seen[s] = 1;
  return {euler_characteristic(draft.mesh), std::ranges::count(is_seen, 1)};
}

}  // namespace

ValidMesh valid_mesh(const Nef3& set, const ToMeshOptions& options, CoordinateType type,
                     Context& context) {
  const RoundToNearest nearest;
  const SpaceComplex& complex = set.complex();
  ToMeshOptions exactly = options;
  exactly.keeps_exact = true;
  // Corners that are doubles lie in one plane, but not when they are floats.
  if (type == CoordinateType::Float) exactly.faces = MeshFaces::Triangles;
  ValidMesh result{mesh_of_complex(complex, exactly, context), {}};
  RoundingRepair& repair = result.repair;

  constexpr std::uint64_t kBytesPerCorner = 32;  // The mesh of a round and of the one before.
  MemoryCharge memory(context);
  memory.add(kBytesPerCorner * result.made.mesh.corners.size(), "a rounded mesh");
  Draft draft{std::move(result.made.mesh), std::move(result.made.facet), {}, 0};
  for (const FacetId f : draft.facet) draft.solid.push_back(solid_at(complex, f).value());
  draft.solid_count = static_cast<std::uint32_t>(complex.volume_count());
  repair.largest_move = round_points(draft.mesh, type);
  repair.rounded_vertices = draft.mesh.exact.size();
  Damage damage = find_damage(draft, exactly.faces, context);
  const bool has_equal_vertices = damage.has_equal_vertices;
  Topology before;
  if (damage.faces > 0) {
    before = topology_of(draft);
    draft =
        RoundingRepairer(exactly, type, repair, context).run(std::move(draft), std::move(damage));
  }
  draft.mesh.exact.clear();
  if (repair.rounds > 0 || has_equal_vertices) {
    if (!options.split_vertices) weld_points(draft.mesh, 0, context);
    drop_unused_points(draft.mesh);
  }
  if (repair.rounds > 0) repair.changes_topology = !(topology_of(draft) == before);
  result.made.mesh = std::move(draft.mesh);
  result.made.facet = std::move(draft.facet);
  return result;
}

}  // namespace plumb
