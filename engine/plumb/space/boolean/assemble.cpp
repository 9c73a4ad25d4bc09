// Assembles a complex from vertices with sphere maps.
//
// The maps at all vertices determine a complex (docs/design/boolean.md, "Correctness"): every cell
// has a vertex in its closure. Points that face each other are the two ends of an edge. Around an
// edge, both maps have the same facets in opposite orders. One matched facet determines the
// rotation, and thereby the next corner along every facet. Then the cycles are followed. In planes
// with several cycles, a sweep finds the outer cycle around each hole. Volumes follow from shells
// and rays (volumes.h).
//
// Invariants, checked by PLUMB_CHECK: facing points have equal marks, rings mirror each other, all
// corners of a facet and all views of a volume have one mark. They hold because both sides of each
// condition are computed from the same pair of cells.
//
// Memory: arrays of the draft are freed as soon as no later step reads them, because the peak is
// reached when volumes are made. Tested by tests/space/nef3_test.cpp and
// tests/space/simplify_test.cpp.

#include "plumb/space/boolean/assemble.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <stop_token>
#include <type_traits>
#include <utility>

#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/parallel_ranges.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_site.h"
#include "plumb/space/query/volumes.h"

namespace plumb {

namespace {

constexpr std::size_t kFew = 16;  ///< So few items are added faster one by one than all at once.
constexpr std::size_t kLeastPoints = 4000;  ///< So many points of a draft are worth a thread.

/// Checks the limits at some steps i of a loop. A step takes up to a microsecond.
void check_at(std::size_t i, const Context& context) {
  constexpr std::size_t kStepsPerCheck = 16'384;
  if (i % kStepsPerCheck == 0) context.check_limits("assemble");
}

/// Appends items.
template <class T>
void extend(std::vector<T>& all, const std::vector<T>& more) {
  if (more.size() > kFew) {
    all.insert(all.end(), more.begin(), more.end());
  } else {
    for (const T& item : more) all.push_back(item);
  }
}

/// Appends indices, each raised by `shift`. kNone stays kNone.
void extend_shifted(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more,
                    std::uint32_t shift) {
  for (const std::uint32_t i : more) all.push_back(i == kNone ? i : i + shift);
}

/// Appends a map. `offsets` states where its parts begin. Each arc has two half-arcs.
void append_map(SphereMap& maps, const SphereMap& map, const SpaceDraft::Offsets& offsets) {
  extend(maps.direction, map.direction);
  extend(maps.point_mark, map.point_mark);
  extend_shifted(maps.first_out, map.first_out, 2 * offsets.arc);
  extend_shifted(maps.point_face, map.point_face, offsets.face);
  extend(maps.circle, map.circle);
  extend(maps.arc_mark, map.arc_mark);
  extend_shifted(maps.origin, map.origin, offsets.point);
  extend_shifted(maps.next, map.next, 2 * offsets.arc);
  extend_shifted(maps.face, map.face, offsets.face);
  extend(maps.face_mark, map.face_mark);
}

}  // namespace

// The map is appended with all its indices increased. The maker sets facing points later.
SpaceDraft::Offsets SpaceDraft::add(SpacePoint at, const SphereMap& map, bool passed,
                                    std::span<const std::uint32_t> origin_ids) {
  const VertexId v(vertex_point.size());
  const Offsets offsets = end();
  vertex_point.push_back(at);
  vertex_mark.push_back(map.centre_mark);
  is_passed.push_back(passed ? 1 : 0);
  begin.push_back(offsets);

  append_map(maps, map, offsets);
  for (std::size_t i = 0; i < map.point_count(); ++i) {
    vertex_of_point.push_back(v);
    twin.push_back(kNone);
  }
  PLUMB_CHECK(origin_ids.size() == map.arc_count());
  for (const std::uint32_t origin : origin_ids) arc_origin.push_back(origin);
  return offsets;
}

void SpaceDraft::resize(std::size_t vertices, std::size_t points, std::size_t arcs,
                        std::size_t faces) {
  const auto resize = [](std::size_t size, auto&... arrays) { (arrays.resize(size), ...); };
  resize(vertices, vertex_point, vertex_mark, is_passed, begin);
  resize(points, maps.direction, maps.point_mark, maps.first_out, vertex_of_point);
  maps.point_face.resize(points, kNone);
  twin.resize(points, kNone);
  resize(arcs, maps.circle, maps.arc_mark, arc_origin);
  resize(2 * arcs, maps.origin, maps.next, maps.face);
  resize(faces, maps.face_mark);
}

SpaceDraft::Offsets SpaceDraft::end() const {
  return {static_cast<std::uint32_t>(maps.point_count()),
          static_cast<std::uint32_t>(maps.arc_count()),
          static_cast<std::uint32_t>(maps.face_count())};
}

namespace {

/// Appends the items of one array of each part to the same array of the whole. `get` returns the
/// array of a draft, and append(all, own, i) appends the array of part i.
template <class Get, class Append>
void move_array(SpaceDraft& whole, std::span<SpaceDraft* const> parts, const Get& get,
                const Append& append) {
  auto& all = get(whole);
  std::size_t size = all.size();
  for (SpaceDraft* const part : parts) size += get(*part).size();
  all.reserve(size);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto& own = get(*parts[i]);
    append(all, own, i);
    own = std::remove_reference_t<decltype(own)>();
  }
}

/// Where the vertices and maps of a part begin in the whole.
struct PartBegin {
  std::uint32_t vertex;
  SpaceDraft::Offsets offsets;
};

/// Returns where each part begins in the whole, if all parts are appended.
std::vector<PartBegin> begins_of(const SpaceDraft& whole, std::span<SpaceDraft* const> parts) {
  std::vector<PartBegin> begins;
  PartBegin at{static_cast<std::uint32_t>(whole.vertex_count()), whole.end()};
  for (const SpaceDraft* const part : parts) {
    begins.push_back(at);
    const SpaceDraft::Offsets size = part->end();
    at.vertex += static_cast<std::uint32_t>(part->vertex_count());
    at.offsets = {at.offsets.point + size.point, at.offsets.arc + size.arc,
                  at.offsets.face + size.face};
  }
  return begins;
}

}  // namespace

// Each array is a job, because arrays differ in size and do not depend on each other. Twins within
// a part still face each other, and kNone remains.
void SpaceDraft::take_all(std::span<SpaceDraft* const> parts, Context& context) {
  const std::vector<PartBegin> begins = begins_of(*this, parts);
  std::vector<std::function<void()>> jobs;
  const auto add = [&](auto get, auto append) {
    jobs.emplace_back([this, parts, get, append] { move_array(*this, parts, get, append); });
  };
  const auto add_same = [&](auto get) {
    add(get, [](auto& all, const auto& own, std::size_t) { extend(all, own); });
  };
  const auto add_shifted = [&](auto get, auto shift) {
    add(get, [&begins, shift](auto& all, const auto& own, std::size_t i) {
      extend_shifted(all, own, shift(begins[i].offsets));
    });
  };
  const auto by_points = [](const Offsets& o) { return o.point; };
  const auto by_half_arcs = [](const Offsets& o) { return 2 * o.arc; };
  const auto by_faces = [](const Offsets& o) { return o.face; };
  add_shifted(
      [](SpaceDraft & d) -> auto& { return d.maps.origin; }, by_points);
  add_shifted(
      [](SpaceDraft & d) -> auto& { return d.maps.next; }, by_half_arcs);
  add_shifted(
      [](SpaceDraft & d) -> auto& { return d.maps.face; }, by_faces);
  add_shifted(
      [](SpaceDraft & d) -> auto& { return d.maps.first_out; }, by_half_arcs);
  add_shifted(
      [](SpaceDraft & d) -> auto& { return d.maps.point_face; }, by_faces);
  add_shifted(
      [](SpaceDraft & d) -> auto& { return d.twin; }, by_points);
  add(
      [](SpaceDraft & d) -> auto& { return d.vertex_of_point; },
      [&begins](auto& all, const auto& own, std::size_t i) {
        for (const VertexId v : own) all.push_back(VertexId(v.value() + begins[i].vertex));
      });
  add(
      [](SpaceDraft & d) -> auto& { return d.begin; },
      [&begins](auto& all, const auto& own, std::size_t i) {
        const Offsets& at = begins[i].offsets;
        for (const Offsets& o : own) {
          all.push_back({o.point + at.point, o.arc + at.arc, o.face + at.face});
        }
      });
  add_same([](SpaceDraft & d) -> auto& { return d.maps.direction; });
  add_same([](SpaceDraft & d) -> auto& { return d.maps.circle; });
  add_same([](SpaceDraft & d) -> auto& { return d.arc_origin; });
  add_same([](SpaceDraft & d) -> auto& { return d.vertex_point; });
  add_same([](SpaceDraft & d) -> auto& { return d.maps.point_mark; });
  add_same([](SpaceDraft & d) -> auto& { return d.maps.arc_mark; });
  add_same([](SpaceDraft & d) -> auto& { return d.maps.face_mark; });
  add_same([](SpaceDraft & d) -> auto& { return d.vertex_mark; });
  add_same([](SpaceDraft & d) -> auto& { return d.is_passed; });
  run_jobs(context, jobs.size(), [&](std::size_t i, Context&) { jobs[i](); });
}

void SpaceDraft::reserve_more(std::size_t vertices, std::size_t point_count, std::size_t arcs,
                              std::size_t faces) {
  const auto reserve = [](std::size_t more, auto&... arrays) {
    (arrays.reserve(arrays.size() + more), ...);
  };
  reserve(vertices, vertex_point, vertex_mark, is_passed, begin);
  reserve(point_count, maps.direction, maps.point_mark, maps.first_out, maps.point_face,
          vertex_of_point, twin);
  reserve(arcs, maps.circle, maps.arc_mark, arc_origin);
  reserve(2 * arcs, maps.origin, maps.next, maps.face);
  reserve(faces, maps.face_mark);
}

namespace {

/// Calls visit(half-arc) for the half-arcs that leave a point, clockwise seen from outside.
template <class Visit>
void for_each_clockwise(const SphereMap& map, std::uint32_t point, Visit visit) {
  const std::uint32_t first = map.first_out[point];
  if (first == kNone) return;
  std::uint32_t h = first;
  do {
    visit(h);
    h = map.clockwise(h);
  } while (h != first);
}

/// Items sorted by their planes. Within each plane, they keep their order. O(items + planes).
class ByPlane {
 public:
  ByPlane(const std::vector<std::uint32_t>& items, const std::vector<PlaneId>& plane,
          std::size_t planes) {
    if (items.empty()) return;
    begin_.assign(planes + 2, 0);
    for (const std::uint32_t i : items) ++begin_[plane[i].value() + 2];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    item_.resize(items.size());
    for (const std::uint32_t i : items) item_[begin_[plane[i].value() + 1]++] = i;
  }

  /// Returns the items of a plane.
  std::span<const std::uint32_t> of(PlaneId p) const {
    if (item_.empty()) return {};
    return std::span(item_).subspan(begin_[p], begin_[p.value() + 1] - begin_[p]);
  }

 private:
  IdVector<PlaneId, std::uint32_t> begin_;
  std::vector<std::uint32_t> item_;
};

/// Frees arrays that no later step reads, because the peak of memory is reached when volumes are
/// made.
template <class... Arrays>
void release(Arrays&... arrays) {
  ((arrays = Arrays()), ...);
}

// ---- vertices and edges

/// The points of a draft that belong to places inside edges.
class PassedPoints {
 public:
  PassedPoints(const SpaceDraft& draft, bool has_any) : draft_(draft), has_any_(has_any) {}

  /// Whether a point belongs to a place inside an edge.
  bool contains(std::uint32_t point) const {
    return has_any_ && draft_.is_passed[draft_.vertex_of_point[point]] != 0;
  }

 private:
  const SpaceDraft& draft_;
  bool has_any_;
};

/// Removes places inside of edges, and returns their points. Then the neighbours of both points of
/// such a place face each other. Chains of places become shorter one by one.
PassedPoints splice(SpaceDraft& draft) {
  bool has_passed = false;
  for (std::size_t v = 0; v < draft.vertex_count(); ++v) {
    if (draft.is_passed[v] == 0) continue;
    has_passed = true;
    // The map of a place inside an edge has exactly two opposite points.
    const std::uint32_t x = draft.begin[v].point, y = x + 1;
    const std::uint32_t a = draft.twin[x], b = draft.twin[y];
    PLUMB_CHECK(a != kNone && b != kNone);
    draft.twin[a] = b;
    draft.twin[b] = a;
  }
  return {draft, has_passed};
}

/// The vertex of the complex that each vertex of the draft becomes. It is invalid for places inside
/// edges.
using VertexNumbers = IdVector<VertexId, VertexId>;

/// Makes the vertices of the complex, in the order of the draft.
VertexNumbers make_vertices(const SpaceDraft& draft, SpaceComplex& out) {
  out.tables = draft.tables;
  VertexNumbers vertex_number(draft.vertex_count());
  for (std::size_t v = 0; v < draft.vertex_count(); ++v) {
    if (draft.is_passed[v] != 0) continue;
    vertex_number[v] = VertexId(out.vertex_count());
    out.vertex_point.push_back(draft.vertex_point[v]);
    out.vertex_mark.push_back(draft.vertex_mark[v]);
  }
  out.vertex_facet.resize(out.vertex_count());
  return vertex_number;
}

/// Makes edge e of the pair (i, j) of facing points, i < j: half-edge 2e leaves point i, whose
/// direction gives the edge its two planes in order. Returns the half-edge of each point.
std::vector<HalfedgeId> make_edges(const SpaceDraft& draft, const PassedPoints& passed,
                                   const VertexNumbers& vertex_number, SpaceComplex& out,
                                   const Context& context) {
  const SphereMap& maps = draft.maps;
  std::vector<HalfedgeId> halfedge_of_point(maps.point_count());
  out.edge_planes.reserve(maps.point_count() / 2);
  out.edge_mark.reserve(maps.point_count() / 2);
  out.origin.reserve(maps.point_count());
  for (std::uint32_t i = 0; i < maps.point_count(); ++i) {
    check_at(i, context);
    const std::uint32_t j = draft.twin[i];
    if (passed.contains(i) || j < i) continue;
    PLUMB_CHECK(j != kNone && j != i && maps.point_mark[i] == maps.point_mark[j]);
    const auto e = static_cast<std::uint32_t>(out.edge_count());
    halfedge_of_point[i] = HalfedgeId(2 * e);
    halfedge_of_point[j] = HalfedgeId(2 * e + 1);
    out.edge_planes.push_back({maps.direction[i].p, maps.direction[i].q});
    out.edge_mark.push_back(maps.point_mark[i]);
    out.origin.push_back(vertex_number[draft.vertex_of_point[i]]);
    out.origin.push_back(vertex_number[draft.vertex_of_point[j]]);
  }
  out.edge_use.resize(out.edge_count());
  return halfedge_of_point;
}

/// Returns for each of the `count` vertices of the complex whether its sphere map is connected, for
/// label_volumes(). A map without free points and loops is connected if and only if points - arcs +
/// faces = 2 (Euler): with k components the sum is k + 1.
IdVector<VertexId, std::uint8_t> find_connected(const SpaceDraft& draft, std::size_t count,
                                                const Context& context) {
  IdVector<VertexId, std::uint8_t> connected;
  connected.reserve(count);
  for (std::size_t v = 0; v < draft.vertex_count(); ++v) {
    check_at(v, context);
    if (draft.is_passed[v] != 0) continue;
    const SpaceDraft::Offsets& at = draft.begin[v];
    const SpaceDraft::Offsets end = v + 1 < draft.vertex_count() ? draft.begin[v + 1] : draft.end();
    bool is_whole = end.point - at.point + (end.face - at.face) == end.arc - at.arc + 2;
    for (std::uint32_t i = at.point; i < end.point; ++i) is_whole &= !draft.is_free(i);
    for (std::uint32_t a = at.arc; a < end.arc; ++a) is_whole &= !draft.is_loop(a);
    connected.push_back(is_whole ? 1 : 0);
  }
  return connected;
}

// ---- edge uses: one for each arc of a vertex that stays

/// Links the corners of facets at both ends of an edge, one edge after the other. This is a class
/// because all edges use the same memory for their rings.
class CornerLinker {
 public:
  /// Links the uses of `out`, which come from the arcs of the draft by `use_of_arc`.
  CornerLinker(const SpaceDraft& draft, const std::vector<UseId>& use_of_arc, SpaceComplex& out)
      : draft_(draft), maps_(draft.maps), use_of_arc_(use_of_arc), out_(out) {}

  /// Links the uses of edge e along facets and around the edge. Half-edge 2e leaves `point`.
  void link_edge(std::uint32_t point, EdgeId e) {
    if (!link_plain_edge(point, e)) link_rings(point, e);
  }

 private:
  /// Computes the same result as link_rings() for an edge with two uses, as nearly all edges have.
  /// Returns false if the edge has another number of uses.
  bool link_plain_edge(std::uint32_t point, EdgeId e) {
    const std::uint32_t x = maps_.first_out[point], after_x = maps_.clockwise(x);
    std::uint32_t y = maps_.first_out[draft_.twin[point]];
    if (y == kNone) return false;
    std::uint32_t after_y = maps_.clockwise(y);
    if (after_x == x || maps_.clockwise(after_x) != x) return false;
    if (after_y == y || maps_.clockwise(after_y) != y) return false;
    if (!is_mirror(x, after_y)) std::swap(y, after_y);
    PLUMB_CHECK(is_mirror(x, after_y) && is_mirror(after_x, y));
    const UseId first = link_corners(x, after_y), second = link_corners(after_x, y);
    out_.use_radial[first] = second;
    out_.use_radial[second] = first;
    out_.edge_use[e] = first;
    return true;
  }

  /// Matches the rings of arcs at both ends of an edge. Half-arcs of the same plane match if one is
  /// outgoing and one is incoming. Two rotations never give different results. Two facets around
  /// one edge in the same plane are on opposite sides of it, so the plane and the direction
  /// determine a half-arc.
  void link_rings(std::uint32_t point, EdgeId e) {
    // The ring at the far end, reversed, is the ring at the near end, rotated.
    near_.clear();
    far_.clear();
    for_each_clockwise(maps_, point, [this](std::uint32_t h) { near_.push_back(h); });
    for_each_clockwise(maps_, draft_.twin[point], [this](std::uint32_t h) { far_.push_back(h); });
    PLUMB_CHECK(near_.size() == far_.size());
    const std::size_t k = near_.size();
    // Seen from the other end, the same ring has the opposite direction.
    std::reverse(far_.begin(), far_.end());
    std::size_t shift = 0;
    while (shift < k && !is_mirror(near_[0], far_[shift])) ++shift;
    PLUMB_CHECK(shift < k);
    radial_.clear();
    for (std::size_t i = 0; i < k; ++i) {
      const std::uint32_t x = near_[i], y = far_[(i + shift) % k];
      PLUMB_CHECK(is_mirror(x, y));
      radial_.push_back(link_corners(x, y));
    }
    // `near_` is clockwise around the half-edge that leaves `point`, which is half-edge 2e.
    for (std::size_t i = 0; i < k; ++i) out_.use_radial[radial_[(i + 1) % k]] = radial_[i];
    out_.edge_use[e] = radial_[0];
  }

  /// Links the corners of one facet at both ends of an edge, and returns the use along the edge.
  UseId link_corners(std::uint32_t x, std::uint32_t y) {
    // An even half-arc is a corner that starts here, and its use leaves along this edge.
    if (x % 2 != 0) std::swap(x, y);
    // The corner at the other end of the edge follows this one along the facet.
    const UseId leaving = use_of_arc_[x / 2], arriving_at = use_of_arc_[y / 2];
    out_.use_next[leaving] = arriving_at;
    out_.use_prev[arriving_at] = leaving;
    return leaving;
  }

  /// Whether half-arcs at both ends of an edge can belong to one facet. Their planes must be equal,
  /// and one of them begins a corner while the other one ends a corner.
  bool is_mirror(std::uint32_t x, std::uint32_t y) const {
    return maps_.circle[x / 2] == maps_.circle[y / 2] && (x ^ y) % 2 == 1;
  }

  const SpaceDraft& draft_;
  const SphereMap& maps_;
  const std::vector<UseId>& use_of_arc_;
  SpaceComplex& out_;
  std::vector<std::uint32_t> near_, far_;  // The half-arcs around both ends of an edge.
  std::vector<UseId> radial_;              // The uses of an edge.
};

/// The edge uses and the arcs of which they are made.
struct UsesOfArcs {
  std::vector<UseId> use_of_arc;  // Invalid for arcs that make no use.
  IdVector<UseId, std::uint32_t> arc_of_use;
};

/// Numbers the edge uses, which are not linked yet.
UsesOfArcs number_uses(const SpaceDraft& draft, const PassedPoints& passed,
                       const std::vector<HalfedgeId>& halfedge_of_point, SpaceComplex& out,
                       const Context& context) {
  const SphereMap& maps = draft.maps;
  UsesOfArcs uses;
  auto& [use_of_arc, arc_of_use] = uses;
  use_of_arc.resize(maps.arc_count());
  out.use_halfedge.reserve(maps.arc_count());
  arc_of_use.reserve(maps.arc_count());
  for (std::uint32_t a = 0; a < maps.arc_count(); ++a) {
    check_at(a, context);
    if (maps.is_loop(a) || passed.contains(maps.origin[2 * a])) continue;
    use_of_arc[a] = UseId(out.use_count());
    out.use_halfedge.push_back(halfedge_of_point[maps.origin[2 * a]]);
    arc_of_use.push_back(a);
  }
  out.use_next.resize(out.use_count());
  out.use_prev.resize(out.use_count());
  out.use_radial.resize(out.use_count());
  return uses;
}

/// Links the uses along facets and around edges, one edge at a time. Each link is written at one
/// edge only, so the edges are independent of each other.
void link_uses(const SpaceDraft& draft, const PassedPoints& passed,
               const std::vector<HalfedgeId>& halfedge_of_point,
               const std::vector<UseId>& use_of_arc, SpaceComplex& out, Context& context) {
  run_ranges(context, halfedge_of_point.size(), kLeastPoints,
             [&](std::size_t, std::size_t begin, std::size_t end, Context& own) {
               CornerLinker linker(draft, use_of_arc, out);
               for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                 check_at(i - begin, own);
                 if (i > draft.twin[i] || passed.contains(i)) continue;
                 if (draft.maps.first_out[i] == kNone) continue;
                 linker.link_edge(i, SpaceComplex::edge_of(halfedge_of_point[i]));
               }
             });
}

// ---- facets

/// Follows the cycles, and makes a temporary facet for each of them. Returns a use of each cycle.
std::vector<UseId> trace_cycles(const SphereMap& maps,
                                const IdVector<UseId, std::uint32_t>& arc_of_use, SpaceComplex& out,
                                const Context& context) {
  std::vector<UseId> first_use;
  out.use_facet.assign(out.use_count(), FacetId());
  std::size_t steps = 0;
  for (std::uint32_t u = 0; u < out.use_count(); ++u) {
    if (out.use_facet[u].is_valid()) continue;
    const FacetId f(first_use.size());
    first_use.push_back(UseId(u));
    out.facet_plane.push_back(maps.circle[arc_of_use[u]]);
    for (UseId w(u); !out.use_facet[w].is_valid(); w = out.use_next[w]) {
      check_at(steps++, context);
      out.use_facet[w] = f;
    }
  }
  return first_use;
}

/// The outer cycles around holes and inner vertices.
struct FacetNesting {
  std::vector<std::uint32_t> parent;  // For each hole, the outer cycle around it; otherwise kNone.
  // Pairs of an outer cycle and a vertex inside it.
  std::vector<std::pair<std::uint32_t, VertexId>> inner_of_cycle;
};

/// The cycles of one plane, and the loops of vertices inside its facets.
struct PlaneGroup {
  std::span<const std::uint32_t> cycles;
  std::span<const std::uint32_t> loops;
};

/// Nests the cycles and inner vertices of one plane after the other. This is a class because all
/// planes use the same memory for their lists.
class PlaneNester {
 public:
  PlaneNester(const SpaceDraft& draft, const VertexNumbers& vertex_number,
              const std::vector<UseId>& first_use, const SpaceComplex& out, Context& context)
      : draft_(draft),
        vertex_number_(vertex_number),
        first_use_(first_use),
        out_(out),
        context_(context) {}

  /// Adds the cycles and inner vertices of one plane to `all`. A single cycle without inner
  /// vertices needs no arithmetic.
  void nest(PlaneId plane, const PlaneGroup& group, FacetNesting& all) {
    if (group.cycles.size() <= 1 && group.loops.empty()) return;
    cycles_.clear();
    inner_.clear();
    for (const std::uint32_t c : group.cycles) cycles_.push_back(first_use_[c]);
    for (const std::uint32_t a : group.loops) inner_.push_back(vertex_of_loop(a));
    // nest_cycles() names the outer cycle of each cycle and point by its index in these lists.
    const CycleNesting nesting = nest_cycles(out_, plane, cycles_, inner_, context_);
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
      if (nesting.of_cycle[i] != i) {
        all.parent[group.cycles[i]] = group.cycles[nesting.of_cycle[i]];
      }
    }
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      all.inner_of_cycle.emplace_back(group.cycles[nesting.of_point[i]], inner_[i]);
    }
  }

 private:
  /// Returns the vertex whose map has a loop: the last one whose arcs begin at or before it.
  VertexId vertex_of_loop(std::uint32_t arc) const {
    const auto next =
        std::upper_bound(draft_.begin.begin(), draft_.begin.end(), arc,
                         [](std::uint32_t a, const SpaceDraft::Offsets& o) { return a < o.arc; });
    return vertex_number_[static_cast<std::size_t>(next - draft_.begin.begin()) - 1];
  }

  const SpaceDraft& draft_;
  const VertexNumbers& vertex_number_;
  const std::vector<UseId>& first_use_;
  const SpaceComplex& out_;
  Context& context_;
  std::vector<UseId> cycles_;    // The cycles of a plane, named by their first uses.
  std::vector<VertexId> inner_;  // The inner vertices of a plane.
};

/// Finds the outer cycle around every hole and inner vertex, plane by plane. Cycles and loops are
/// sorted by their planes in linear time. Then the cycles of each plane are nested.
FacetNesting nest_planes(const SpaceDraft& draft, const VertexNumbers& vertex_number,
                         const std::vector<UseId>& first_use, const SpaceComplex& out,
                         Context& context) {
  const auto cycles = static_cast<std::uint32_t>(first_use.size());
  FacetNesting nesting;
  nesting.parent.assign(cycles, kNone);
  std::vector<std::uint32_t> all_cycles(cycles), all_loops;
  std::iota(all_cycles.begin(), all_cycles.end(), 0U);
  for (std::uint32_t a = 0; a < draft.maps.arc_count(); ++a) {
    if (draft.is_loop(a)) all_loops.push_back(a);
  }
  const ByPlane by_cycle(all_cycles, out.facet_plane, draft.tables->planes.size());
  const ByPlane by_loop(all_loops, draft.maps.circle, draft.tables->planes.size());
  PlaneNester nester(draft, vertex_number, first_use, out, context);
  for (std::uint32_t p = 0; p < draft.tables->planes.size(); ++p) {
    if (p % 64 == 0) context.checkpoint("assemble", 2, 5);
    nester.nest(PlaneId(p), {by_cycle.of(PlaneId(p)), by_loop.of(PlaneId(p))}, nesting);
  }
  return nesting;
}

void reserve_facets(std::size_t facets, std::size_t cycles, SpaceComplex& out) {
  out.facet_mark.reserve(facets);
  out.facet_origin.reserve(facets);
  out.cycle.reserve(cycles);
  out.cycle_begin.reserve(facets + 1);
  out.inner_begin.reserve(facets + 1);
  out.cycle_begin = {0};
  out.inner_begin = {0};
}

/// Returns pairs of an outer cycle and a hole in it, sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted_holes(
    const std::vector<std::uint32_t>& parent) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> holes;
  for (std::uint32_t c = 0; c < parent.size(); ++c) {
    if (parent[c] != kNone) holes.emplace_back(parent[c], c);
  }
  std::sort(holes.begin(), holes.end());
  return holes;
}

/// Makes a facet of each outer cycle, in their order, with its holes and inner vertices. The facet
/// has the mark and facet_origin of the first corner of its outer cycle. Returns the facet of each
/// cycle.
std::vector<FacetId> number_facets(const SpaceDraft& draft,
                                   const IdVector<UseId, std::uint32_t>& arc_of_use,
                                   const std::vector<UseId>& first_use, FacetNesting& nesting,
                                   SpaceComplex& out) {
  const auto holes = sorted_holes(nesting.parent);
  // Holes and inner vertices are sorted by their outer cycle, so one pass over the cycles visits
  // them in order.
  std::stable_sort(nesting.inner_of_cycle.begin(), nesting.inner_of_cycle.end(),
                   [](const auto& x, const auto& y) { return x.first < y.first; });
  reserve_facets(first_use.size() - holes.size(), first_use.size(), out);
  std::vector<FacetId> facet_of_cycle(first_use.size());
  std::size_t facet_count = 0;
  auto hole = holes.begin();
  auto inner = nesting.inner_of_cycle.begin();
  for (std::uint32_t c = 0; c < first_use.size(); ++c) {
    if (nesting.parent[c] != kNone) continue;
    const FacetId f(facet_count);
    const std::uint32_t arc = arc_of_use[first_use[c]];
    // This overwrites no data that are still needed, because facet_count <= c.
    out.facet_plane[facet_count++] = out.facet_plane[c];
    out.facet_mark.push_back(draft.maps.arc_mark[arc]);
    out.facet_origin.push_back(draft.arc_origin[arc]);
    facet_of_cycle[c] = f;
    out.cycle.push_back(first_use[c]);
    for (; hole != holes.end() && hole->first == c; ++hole) {
      facet_of_cycle[hole->second] = f;
      out.cycle.push_back(first_use[hole->second]);
    }
    for (; inner != nesting.inner_of_cycle.end() && inner->first == c; ++inner) {
      out.inner.push_back(inner->second);
      out.vertex_facet[inner->second] = f;
    }
    out.cycle_begin.push_back(static_cast<std::uint32_t>(out.cycle.size()));
    out.inner_begin.push_back(static_cast<std::uint32_t>(out.inner.size()));
  }
  out.facet_plane.resize(facet_count);
  return facet_of_cycle;
}

/// Replaces the cycle of each use by its facet. The facet_origin of a facet becomes the least of
/// those of its corners.
void set_facets_of_uses(const SpaceDraft& draft, const IdVector<UseId, std::uint32_t>& arc_of_use,
                        const std::vector<FacetId>& facet_of_cycle, SpaceComplex& out,
                        Context& context) {
  run_ranges(context, out.use_count(), kLeastPoints,
             [&](std::size_t, std::size_t begin, std::size_t end, Context&) {
               for (std::size_t u = begin; u < end; ++u) {
                 out.use_facet[u] = facet_of_cycle[out.use_facet[u].value()];
               }
             });
  for (std::uint32_t u = 0; u < out.use_count(); ++u) {
    const FacetId f = out.use_facet[u];
    PLUMB_CHECK(draft.maps.arc_mark[arc_of_use[u]] == out.facet_mark[f]);
    std::uint32_t& origin = out.facet_origin[f];
    origin = std::min(origin, draft.arc_origin[arc_of_use[u]]);
  }
}

/// Makes the facets from the cycles of uses and from the inner vertices.
void gather_facets(const SpaceDraft& draft, const VertexNumbers& vertex_number,
                   const IdVector<UseId, std::uint32_t>& arc_of_use, SpaceComplex& out,
                   Context& context) {
  const std::vector<UseId> first_use = trace_cycles(draft.maps, arc_of_use, out, context);
  context.checkpoint("assemble", 2, 5);
  FacetNesting nesting = nest_planes(draft, vertex_number, first_use, out, context);
  const std::vector<FacetId> facet_of_cycle =
      number_facets(draft, arc_of_use, first_use, nesting, out);
  set_facets_of_uses(draft, arc_of_use, facet_of_cycle, out, context);
}

// ---- volumes

/// Copies the marks of volumes from the cells on their boundaries: sides of facets, free edges and
/// isolated vertices.
void copy_volume_marks(const SpaceDraft& draft, const PassedPoints& passed,
                       const VertexNumbers& vertex_number,
                       const std::vector<HalfedgeId>& halfedge_of_point,
                       const IdVector<UseId, std::uint32_t>& arc_of_use, SpaceComplex& out,
                       Context& context) {
  const SphereMap& maps = draft.maps;
  IdVector<VolumeId, std::uint8_t> is_marked(out.volume_count(), 0);
  // Sets the mark of a volume, or checks it if it is already known.
  const auto set_mark = [&](VolumeId volume, Mark mark) {
    PLUMB_CHECK(is_marked[volume] == 0 || out.volume_mark[volume] == mark);
    out.volume_mark[volume] = mark;
    is_marked[volume] = 1;
  };
  const auto mark_at = [&](UseId u, std::uint32_t side) {
    return maps.face_mark[maps.face[2 * arc_of_use[u] + side]];
  };
  // One corner of each facet determines the marks, and all other corners must have the same marks.
  for (std::uint32_t f = 0; f < out.facet_count(); ++f) {
    const UseId u = out.cycles_of(FacetId(f))[0];
    for (std::uint32_t side = 0; side < 2; ++side) {
      set_mark(out.facet_volume[f][side], mark_at(u, side));
    }
  }
  run_ranges(context, out.use_count(), kLeastPoints,
             [&](std::size_t, std::size_t begin, std::size_t end, Context&) {
               for (std::size_t u = begin; u < end; ++u) {
                 const auto& volumes = out.facet_volume[out.use_facet[u]];
                 for (std::uint32_t side = 0; side < 2; ++side) {
                   PLUMB_CHECK(out.volume_mark[volumes[side]] == mark_at(UseId(u), side));
                 }
               }
             });
  for (std::uint32_t i = 0; i < halfedge_of_point.size(); ++i) {
    if (passed.contains(i) || maps.first_out[i] != kNone) continue;
    set_mark(out.edge_volume[SpaceComplex::edge_of(halfedge_of_point[i])],
             maps.face_mark[maps.point_face[i]]);
  }
  for (std::size_t v = 0; v < vertex_number.size(); ++v) {
    if (draft.is_passed[v] != 0) continue;
    const VolumeId volume = out.vertex_volume[vertex_number[v]];
    if (volume.is_valid()) set_mark(volume, maps.face_mark[draft.begin[v].face]);
  }
}

/// Returns the complex of a draft without vertices: one volume with mark 0.
SpaceComplex whole_space(const SpaceDraft& draft) {
  SpaceComplex whole;
  whole.tables = draft.tables;
  whole.star_begin = whole.cycle_begin = whole.inner_begin = {0};
  whole.volume_mark = {0};
  return whole;
}

/// Assembles a draft that has vertices.
SpaceComplex assemble_vertices(SpaceDraft draft, Context& context) {
  SpaceComplex out;
  context.checkpoint("assemble", 0, 5);
  WorkPhase phase("vertices and edges");
  const PassedPoints passed = splice(draft);
  context.checkpoint("assemble", 0, 5);
  const VertexNumbers vertex_number = make_vertices(draft, out);
  context.checkpoint("assemble", 0, 5);
  std::vector<HalfedgeId> halfedge_of_point;
  IdVector<VertexId, std::uint8_t> connected;
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    if (i == 0) {
      halfedge_of_point = make_edges(draft, passed, vertex_number, out, own);
    } else {
      connected = find_connected(draft, out.vertex_count(), own);
    }
  });
  release(draft.vertex_point, draft.vertex_mark, draft.maps.direction);
  context.checkpoint("assemble", 1, 5);
  phase.next("edge uses");
  UsesOfArcs uses;
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    if (i == 0) {
      out.list_stars(out.vertex_count());
    } else {
      uses = number_uses(draft, passed, halfedge_of_point, out, own);
    }
  });
  link_uses(draft, passed, halfedge_of_point, uses.use_of_arc, out, context);
  const IdVector<UseId, std::uint32_t> arc_of_use = std::move(uses.arc_of_use);
  release(uses.use_of_arc);
  release(draft.maps.next, draft.twin);
  phase.next("facets");
  gather_facets(draft, vertex_number, arc_of_use, out, context);
  release(draft.maps.origin, draft.maps.circle, draft.arc_origin);
  context.checkpoint("assemble", 3, 5);
  phase.next("volumes");
  label_volumes(out, context, connected);
  phase.next("marks of volumes");
  copy_volume_marks(draft, passed, vertex_number, halfedge_of_point, arc_of_use, out, context);
  return out;
}

}  // namespace

// For small drafts, starting a thread would take more time than it saves.
SpaceComplex assemble(SpaceDraft draft, Context& context) {
  if (draft.vertex_count() == 0) return whole_space(draft);
  const bool is_small = draft.maps.point_count() < kLeastPoints;
  Context own = Context::of_job(context, std::stop_token(), is_small ? 1U : context.threads(),
                                JobProgress::Reported);
  return assemble_vertices(std::move(draft), own);
}

}  // namespace plumb
