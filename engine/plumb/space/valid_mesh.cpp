// Rounds a mesh, leaves out flat vertices, and repairs the damage of rounding, round by round.
//
// If doubles prove that a face is sound, its exact coordinates are not computed. If this is so for
// all faces, the cost is the cost of making the mesh and of the proofs.
//
// Most damage is local: where vertices are nearly on a line or nearly in a plane, rounding folds
// thin triangles over their neighbours. snap_damaged() makes the parts that nearly touch meet in
// common vertices, at first only parts within one unit of the last digit. If the damage does not
// shrink, the distance doubles. If nothing is near, mended() takes out each solid (marked volume)
// with a damaged face: the sum of the winding numbers of these solids is an integer at every point
// off their faces, and the points where it is positive form the new solids. Solids without damaged
// faces cross no other face, so they need not take part.
//
// Both steps can cause new damage. They end after a few rounds in practice. To end in any case, the
// repair starts again after kRoundsOfAGrid rounds, or if the damage grows: all solids that have
// been damaged are snapped to a coarser grid each time. If the step of the grid exceeds the size of
// the solids, all their vertices coincide, and nothing is left of them.
// docs/design/mesh-rounding.md has the proofs.
//
// Tested by tests/space/valid_mesh_test.cpp.
#include "plumb/space/valid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/base/internal/union_find.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/check_faces.h"
#include "plumb/space/mesh/doubtful_faces.h"
#include "plumb/space/mesh/drop_flat_vertices.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/mesh/snap_near.h"
#include "plumb/space/set/cut_boundary.h"
#include "plumb/space/set/piece_mesh.h"
#include "plumb/space/set/round_mesh.h"
#include "plumb/space/set/source_triangles.h"
#include "plumb/space/source_mesh.h"
#include "plumb/space/weld_points.h"

namespace plumb {
namespace {

constexpr int kWidestSnap = 6;  // The width is 2^6 units of the last digit.
// The number of rounds before the units become coarser.
constexpr std::uint32_t kRoundsOfAGrid = 60;
// If the damage grows by this factor, the units become coarser, too.
constexpr std::uint64_t kGrowth = 4;
constexpr int kCoarser = 4;  // The units become coarser by a factor of 2^4.
// The distance in units by which a flat vertex may be off a plane.
constexpr double kFlat = 4;

/// The places that points had before they were rounded. Exact coordinates are computed on demand.
struct PlacesBefore {
  const SpaceComplex* complex;
  /// The vertices of the complex of constructed points.
  std::vector<std::pair<std::uint32_t, VertexId>> constructed;
  std::vector<Point3> points;  ///< The nearest doubles of all points; empty if none was a double.

  /// Returns the place of a point if it was rounded.
  [[nodiscard]] std::optional<RationalPoint3> place(std::uint32_t v, const Point3& now) const {
    const auto found =
        std::ranges::lower_bound(constructed, v, {}, [](const auto& c) { return c.first; });
    if (found != constructed.end() && found->first == v) {
      return exact(complex->points(), complex->vertex_point[found->second]);
    }
    if (v >= points.size() || points[v] == now) return {};
    return RationalPoint3{points[v].x, points[v].y, points[v].z};
  }
};

/// A mesh during the repair. The facets and solids of its faces are stored in parallel arrays.
struct Draft {
  PolygonMesh mesh;  ///< mesh.exact lists points of doubtful faces, with their places before.
  std::vector<std::uint8_t> is_checked;  ///< 1 for each face that must be checked.
  std::vector<FacetId> facet;            ///< The facet of the set from which a face was made.
  /// The solid that a face bounds. The array is empty until damage is found, if facets of a complex
  /// determine the solids.
  std::vector<std::uint32_t> solid;
  std::uint32_t solid_count = 0;
  std::vector<std::uint32_t> kept;  ///< Points that stay even if the boundary is flat there.

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

/// The effect of rounding on the faces of a draft.
struct Damage {
  std::vector<std::uint8_t> of_face;            ///< 1 for each damaged face.
  std::vector<std::uint8_t> of_solid;           ///< 1 for each solid with a damaged face.
  std::vector<RoundingReport::FacePair> pairs;  ///< The pairs of faces that cross or coincide.
  std::uint64_t faces = 0;                      ///< The number of damaged faces.
  bool has_only_flipped = false;    ///< Whether the damaged faces are flipped and nothing else.
  bool has_equal_vertices = false;  ///< Whether vertices coincide that did not before.
};

/// Lists the points of the faces that were rounded in mesh.exact.
void list_places_before(std::span<const std::uint32_t> faces, const PlacesBefore& before,
                        Draft& draft) {
  auto& exact = draft.mesh.exact;
  std::vector<std::uint8_t> is_listed(draft.mesh.points.size(), 0);
  for (const auto& [v, p] : exact) is_listed[v] = 1;
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : draft.mesh.face(f)) {
      if (is_listed[v] != 0) continue;
      is_listed[v] = 1;
      if (auto place = before.place(v, draft.mesh.points[v])) {
        exact.emplace_back(v, std::move(*place));
      }
    }
  }
  std::ranges::sort(exact, {}, [](const auto& e) { return e.first; });
}

/// Finds damage at faces that are to be checked. A polygon that is not flat counts as
/// damage, unless `faces` allows it.
Damage find_damage(Draft& draft, const PlacesBefore& before, MeshFaces faces, Context& context) {
  const DoubtfulFaces doubtful = doubtful_faces(draft.mesh, draft.is_checked, context);
  if (doubtful.faces.empty()) return {};
  list_places_before(doubtful.faces, before, draft);
  const RoundingReport found =
      check_faces(draft.mesh, doubtful, std::numeric_limits<std::uint64_t>::max(), context);
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
  if (draft.solid.empty()) draft.solid = solids_at(*before.complex, draft.facet);
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

double largest_coordinate(const Point3& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}
double largest_coordinate(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max(largest, largest_coordinate(p));
  return largest;
}
/// Returns the largest coordinate of the points that have faces.
double largest_coordinate(const PolygonMesh& mesh) {
  double largest = 0;
  for (const std::uint32_t v : mesh.corners) {
    largest = std::max(largest, largest_coordinate(mesh.points[v]));
  }
  return largest;
}

/// Replaces the mesh of a draft by a changed mesh. Changed faces must be checked, too.
void take(ChangedMesh changed, Draft& draft) {
  Draft next;
  next.solid_count = draft.solid_count;
  for (std::uint32_t f = 0; f < changed.origin.size(); ++f) {
    const std::uint32_t from = changed.origin[f];
    next.facet.push_back(draft.facet[from]);
    if (!draft.solid.empty()) next.solid.push_back(draft.solid[from]);
    const bool must_be_checked = draft.is_checked[from] != 0 || changed.changed[from] != 0;
    next.is_checked.push_back(must_be_checked ? 1 : 0);
  }
  next.mesh = std::move(changed.mesh);
  next.mesh.exact = std::move(draft.mesh.exact);
  draft = std::move(next);
}

/// Snaps damaged parts of the draft that are at most `width` apart. Returns a bound of the
/// distances by which faces moved, or nullopt if nothing is near.
std::optional<double> snap_damaged(Draft& draft, const Damage& damage, double width) {
  ChangedMesh snapped = snap_near(draft.mesh, damage.of_face, damage.pairs, width);
  if (snapped.changed.empty()) return std::nullopt;
  const double largest_move = snapped.largest_move;
  draft.is_checked = damage.of_face;
  take(std::move(snapped), draft);
  return largest_move;
}

/// Removes vertices at which the surface is flat or folded along a straight line. Returns a bound
/// of the distances by which faces moved. Requires that all faces with constructed vertices are to
/// be checked. `largest` is the largest coordinate.
double drop_flat(const std::vector<std::uint8_t>& is_constructed, double largest,
                 CoordinateType type, RoundingRepair& repair, Draft& draft, Context& context) {
  const double width = kFlat * std::ldexp(1, last_digit_exponent(largest, type));
  FlattenedMesh flat =
      drop_flat_vertices(draft.mesh, is_constructed, draft.is_checked, width, context);
  if (flat.removed == 0) return 0;
  const double largest_move = flat.changes.largest_move;
  repair.dropped_vertices += flat.removed;
  take(std::move(flat.changes), draft);
  return largest_move;
}

/// Marks all faces with a chosen point to be checked, and no other faces.
void check_faces_at(const std::vector<std::uint8_t>& is_chosen, Draft& draft) {
  draft.is_checked = faces_at(draft.mesh, is_chosen);
}

/// Moves the points of chosen solids to multiples of 2^exponent, towards zero, so that no
/// coordinate increases. Returns a bound of the distances.
double snap_to_grid(Draft& draft, const std::vector<std::uint8_t>& is_chosen, int exponent) {
  const auto snapped = [exponent](double value) {
    return std::ldexp(std::trunc(std::ldexp(value, -exponent)), exponent);
  };
  std::vector<std::uint8_t> is_moved(draft.mesh.points.size(), 0);
  for (std::uint32_t f = 0; f < draft.solid.size(); ++f) {
    if (is_chosen[draft.solid[f]] == 0) continue;
    for (const std::uint32_t v : draft.mesh.face(f)) is_moved[v] = 1;
  }
  for (std::uint32_t v = 0; v < is_moved.size(); ++v) {
    Point3& p = draft.mesh.points[v];
    if (is_moved[v] != 0) p = {snapped(p.x), snapped(p.y), snapped(p.z)};
  }
  check_faces_at(is_moved, draft);
  return std::ldexp(1.7321, exponent);  // The value exceeds the diagonal of a cube of the grid.
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

/// Appends the boundary of the set of a mesh with faces of the draft. As they are the source of the
/// set, its facets are cut where they meet. Therefore each appended face belongs to one facet of
/// the draft, and the points between faces of different facets are kept.
void append_pieces(PolygonMesh mesh, std::span<const FacetId> facet, const ToMeshOptions& options,
                   Draft& draft, Context& context) {
  MeshSource source{{}, std::move(mesh), {}};
  for (const FacetId f : facet) source.attributes.face_id.push_back(f.value());
  const Nef3 set = from_source(std::make_shared<const MeshSource>(std::move(source)),
                               {.rule = WindingRule::Positive}, context);
  GrowingComplex growing(set.complex());
  SourceTriangles triangles(set.sources(), growing, context);
  const CutBoundary cut = cut_boundary(growing, triangles, {.faces = options.faces}, context);
  const SpaceComplex& complex = growing.get();
  const MeshToRound made = mesh_of_pieces(cut, triangles, complex);

  const auto first = static_cast<std::uint32_t>(draft.mesh.points.size());
  const auto& points = made.made.mesh.points;
  draft.mesh.points.insert(draft.mesh.points.end(), points.begin(), points.end());
  for (const auto& [at, v] : made.made.rounded) {
    draft.mesh.exact.emplace_back(first + at, exact(complex.points(), complex.vertex_point[v]));
  }
  for (const std::uint32_t v : made.kept) draft.kept.push_back(first + v);
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < cut.piece.size(); ++f) {
    corners.clear();
    for (const std::uint32_t v : made.made.mesh.face(f)) corners.push_back(first + v);
    const FacetId from = facet[triangles[cut.pieces[cut.piece[f]].triangle].face];
    draft.add_face(corners, from, draft.solid_count + made.solid[f]);
  }
  draft.solid_count += static_cast<std::uint32_t>(complex.volume_count());
}

/// Replaces damaged solids, with all that touch them, by the points of positive winding number.
/// Solids may touch in points that are equal only after rounding, so equal points are welded before
/// contacts are searched.
Draft mended(Draft draft, const Damage& damage, const ToMeshOptions& options, bool has_pieces,
             Context& context) {
  draft.mesh.exact.clear();
  weld_points(draft.mesh, 0, context);
  const std::vector<std::uint8_t> is_broken = connected_with_damage(draft, damage);
  Draft result;
  result.solid_count = draft.solid_count;
  PolygonMesh broken;
  std::vector<FacetId> facet;  // The facets of the faces of `broken`.
  for (std::uint32_t f = 0; f < draft.solid.size(); ++f) {
    const auto corners = draft.mesh.face(f);
    if (is_broken[draft.solid[f]] != 0) {
      broken.add_face(corners);
      facet.push_back(draft.facet[f]);
    } else {
      result.add_face(corners, draft.facet[f], draft.solid[f]);
    }
  }
  broken.points = draft.mesh.points;
  result.mesh.points = std::move(draft.mesh.points);
  if (has_pieces) {
    append_pieces(std::move(broken), facet, options, result, context);
  } else {
    const Nef3 set = Nef3::from_mesh(broken, {.rule = WindingRule::Positive}, context);
    append(mesh_of_complex(set.complex(), options, context), set.complex(), facet, result);
  }
  return result;
}

// ---------------------------------------------------------------- rounds

/// Repairs a draft, round by round. It is a class because a round needs data of earlier rounds.
class RoundingRepairer {
 public:
  RoundingRepairer(const ToMeshOptions& options, CoordinateType type, PlacesBefore before,
                   bool has_pieces, RoundingRepair& repair, Context& context)
      : options_(options),
        type_(type),
        has_pieces_(has_pieces),
        before_(std::move(before)),
        repair_(repair),
        context_(context) {}

  /// Returns the draft without damage. `damage` is the damage of the draft.
  Draft run(Draft draft, Damage damage) {
    first_ = draft;
    first_repair_ = repair_;
    was_damaged_.assign(draft.solid_count, 0);
    most_damaged_ = kGrowth * (damage.faces + 16);
    // The least number of damaged faces since the last round that made new faces.
    std::uint64_t fewest = damage.faces;
    while (damage.faces > 0 && !(damage.has_only_flipped && flipped_rounds_ >= kFlippedRounds)) {
      context_.checkpoint("repair rounding", repair_.rounds, 0);
      ++repair_.rounds;
      repair_.damaged_faces += damage.faces;
      flipped_rounds_ += damage.has_only_flipped ? 1 : 0;
      repair_.largest_move += next(draft, damage);
      damage = find_damage(draft, has_first_places_ ? before_ : PlacesBefore{}, options_.faces,
                           context_);
      if (is_new_) fewest = damage.faces + 1;
      width_ = damage.faces < fewest ? 0 : width_ + 1;
      fewest = std::min(fewest, damage.faces);
    }
    return draft;
  }

 private:
  /// A surface that does not cross itself can be inside out only if it is as small as the errors.
  /// Therefore a set is made of it, and the remaining part of this set is snapped, which is
  /// sufficient.
  static constexpr int kFlippedRounds = 3;

  /// Makes one round. Returns a bound of the distances by which faces moved.
  double next(Draft& draft, const Damage& damage) {
    is_new_ = true;
    const std::vector<std::uint8_t> is_broken = connected_with_damage(draft, damage);
    for (std::size_t s = 0; s < was_damaged_.size(); ++s) was_damaged_[s] |= is_broken[s];
    const int digit = last_digit_exponent(largest_coordinate(draft.mesh), type_);
    if (++rounds_of_grid_ == kRoundsOfAGrid || damage.faces > most_damaged_) {
      return start_again(draft, digit);
    }
    const bool may_snap = !damage.has_only_flipped || flipped_rounds_ == 2;
    for (; may_snap && width_ <= kWidestSnap; ++width_) {
      const double width = std::ldexp(1, digit + coarseness_ + width_);
      const auto move = snap_damaged(draft, damage, width);
      if (!move) continue;
      is_new_ = false;
      return *move;
    }
    draft = mended(std::move(draft), damage, options_, has_pieces_, context_);
    has_first_places_ = false;
    return round_mended(draft);
  }

  /// Starts again with the first draft and a coarser unit. The solids that have been damaged so far
  /// are rounded to this unit.
  double start_again(Draft& draft, int digit) {
    draft = first_;
    has_first_places_ = true;
    repair_.largest_move = first_repair_.largest_move;
    repair_.dropped_vertices = first_repair_.dropped_vertices;
    ++repair_.coarse_rounds;
    coarseness_ += kCoarser;
    rounds_of_grid_ = 0;
    width_ = 0;
    return snap_to_grid(draft, was_damaged_, digit + coarseness_);
  }

  /// Rounds the points that mended() has made.
  double round_mended(Draft& draft) {
    std::vector<std::uint8_t> is_constructed(draft.mesh.points.size(), 0);
    for (const auto& [v, p] : draft.mesh.exact) is_constructed[v] = 1;
    for (const std::uint32_t v : draft.kept) is_constructed[v] = 0;
    const double moved = round_points(draft.mesh, type_);
    std::vector<std::uint8_t> is_rounded(draft.mesh.points.size(), 0);
    for (const auto& [v, p] : draft.mesh.exact) is_rounded[v] = 1;
    check_faces_at(is_rounded, draft);
    const double largest = largest_coordinate(draft.mesh);
    return moved + drop_flat(is_constructed, largest, type_, repair_, draft, context_);
  }

  const ToMeshOptions& options_;
  CoordinateType type_;
  bool has_pieces_;            // The value of MeshToRound::has_pieces.
  const PlacesBefore before_;  // The places before the first draft was rounded.
  RoundingRepair& repair_;
  Context& context_;
  // The exponent of the snapping distance. It increases if there is no progress.
  int width_ = 0;
  int coarseness_ = 0;           // The exponent of the unit.
  Draft first_;                  // The draft before the first round.
  RoundingRepair first_repair_;  // The report before the first round.
  // For each of its solids, 1 if the solid has been damaged.
  std::vector<std::uint8_t> was_damaged_;
  std::uint64_t most_damaged_ = 0;  // If more faces are damaged, the unit is too fine.
  std::uint32_t rounds_of_grid_ = 0;
  bool has_first_places_ = true;  // Whether before_ has the original places of points of the draft.
  int flipped_rounds_ = 0;
  bool is_new_ = false;  // Whether the last round made new faces, and did not only snap some.
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

/// Moves the mesh and its facets to a draft.
Draft draft_of(MeshToRound& made) {
  Draft draft;
  draft.mesh = std::move(made.made.mesh);
  draft.facet = std::move(made.made.facet);
  draft.solid = std::move(made.solid);
  draft.solid_count = static_cast<std::uint32_t>(made.complex->volume_count());
  draft.kept = std::move(made.kept);
  return draft;
}

/// Rounds the points of the first draft, and removes flat vertices. Vertices whose coordinates are
/// doubles do not change.
void round_draft(CoordinateType type, PlacesBefore& before, RoundingRepair& repair, Draft& draft,
                 Context& context) {
  auto& points = draft.mesh.points;
  if (type == CoordinateType::Float) before.points = points;
  std::vector<std::uint8_t> is_constructed(points.size(), 0), is_rounded(points.size(), 0);
  const auto round = [&](std::uint32_t v) {
    const double move = round_point(points[v], is_constructed[v] != 0, type);
    if (move == 0) return;
    repair.largest_move = std::max(repair.largest_move, move);
    ++repair.rounded_vertices;
    is_rounded[v] = 1;
  };
  for (const auto& [v, vertex] : before.constructed) {
    is_constructed[v] = 1;
    if (type == CoordinateType::Double) round(v);
  }
  if (type == CoordinateType::Float) {
    for (std::uint32_t v = 0; v < points.size(); ++v) round(v);
  }
  check_faces_at(is_rounded, draft);
  if (before.constructed.empty()) return;
  for (const std::uint32_t v : draft.kept) is_constructed[v] = 0;
  repair.largest_move +=
      drop_flat(is_constructed, largest_coordinate(points), type, repair, draft, context);
}

}  // namespace

std::vector<std::uint32_t> solids_at(const SpaceComplex& complex, std::span<const FacetId> facets) {
  std::vector<std::uint32_t> solids;
  solids.reserve(facets.size());
  for (const FacetId f : facets) solids.push_back(solid_at(complex, f).value());
  return solids;
}

ValidMesh round_mesh(MeshToRound input, const ToMeshOptions& options, CoordinateType type,
                     Context& context) {
  const RoundToNearest nearest;
  const WorkPhase phase("test of rounding");
  ToMeshOptions used = options;
  used.keeps_exact = false;
  // Corners that are doubles may lie in one plane, while the same corners as floats do not.
  if (type == CoordinateType::Float) used.faces = MeshFaces::Triangles;
  ValidMesh result;
  result.made.report = input.made.report;
  RoundingRepair& repair = result.repair;

  // The memory of the mesh of a round and of the previous one.
  constexpr std::uint64_t kBytesPerCorner = 32;
  MemoryCharge memory(context);
  memory.add(kBytesPerCorner * input.made.mesh.corners.size(), "a rounded mesh");
  PlacesBefore before{input.complex, std::move(input.made.rounded), {}};
  Draft draft = draft_of(input);
  round_draft(type, before, repair, draft, context);
  Damage damage = find_damage(draft, before, used.faces, context);
  const bool has_equal_vertices = damage.has_equal_vertices;
  Topology topology;
  if (damage.faces > 0) {
    topology = topology_of(draft);
    used.keeps_exact = true;
    draft = RoundingRepairer(used, type, std::move(before), input.has_pieces, repair, context)
                .run(std::move(draft), std::move(damage));
  }
  draft.mesh.exact.clear();
  const bool has_changed = repair.rounds > 0 || has_equal_vertices;
  if (has_changed && !options.split_vertices) weld_points(draft.mesh, 0, context);
  if (has_changed || repair.dropped_vertices > 0) drop_unused_points(draft.mesh);
  if (repair.rounds > 0) repair.changes_topology = !(topology_of(draft) == topology);
  result.made.mesh = std::move(draft.mesh);
  result.made.facet = std::move(draft.facet);
  return result;
}

ValidMesh valid_mesh(const Nef3& set, const ToMeshOptions& options, CoordinateType type,
                     Context& context) {
  const SpaceComplex& complex = set.complex();
  ToMeshOptions used = options;
  used.keeps_exact = false;
  if (type == CoordinateType::Float) used.faces = MeshFaces::Triangles;
  MeshToRound input{mesh_of_complex(complex, used, context), {}, &complex, {}, false};
  return round_mesh(std::move(input), options, type, context);
}

}  // namespace plumb
