// Joins vertices with sphere maps to a complex.
//
// The maps at all vertices determine a complex (docs/design/boolean.md, "Correctness"): every cell
// has a vertex in its closure. Points that face each other are the two ends of an edge. Around an
// edge both maps show the same facets, in opposite senses; matching one facet fixes the rotation,
// and then corner follows corner along every facet. Cycles are walked; in planes with several of
// them a sweep finds the outer cycle around each hole. Volumes follow from shells and rays
// (volumes.h).
//
// Invariants, checked by PLUMB_CHECK: facing points have equal marks, rings mirror each other, all
// corners of a facet and all views of a volume have one mark. They hold because both are computed
// from the same pair of cells.
//
// Memory: arrays of the draft are freed as soon as no later step reads them, since the peak comes
// with the volumes.
// Tested by tests/space/nef3_test.cpp and tests/space/simplify_test.cpp.

#include "plumb/space/boolean/assemble.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "plumb/base/internal/parallel.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_site.h"
#include "plumb/space/query/volumes.h"

namespace plumb {

namespace {

constexpr std::size_t kFew = 16;  ///< So few items are added faster one by one than all at once.

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

/// Appends a map; `offsets` is where its parts begin. Half-arcs are two for each arc.
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

// The map is appended with all its indices raised; facing points are set by the maker later.
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

// Twins within the other draft keep facing each other; kNone stays open.
void SpaceDraft::append(const SpaceDraft& other) {
  const auto vertices = static_cast<std::uint32_t>(vertex_count());
  const Offsets offsets = end();
  extend(vertex_point, other.vertex_point);
  extend(vertex_mark, other.vertex_mark);
  extend(is_passed, other.is_passed);
  for (const Offsets& o : other.begin) {
    begin.push_back({o.point + offsets.point, o.arc + offsets.arc, o.face + offsets.face});
  }
  append_map(maps, other.maps, offsets);
  for (const VertexId v : other.vertex_of_point) {
    vertex_of_point.push_back(VertexId(v.value() + vertices));
  }
  extend_shifted(twin, other.twin, offsets.point);
  extend(arc_origin, other.arc_origin);
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

/// Items sorted by their planes, in their old order within each. O(items + planes).
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
    return std::span(item_).subspan(begin_[p.value()], begin_[p.value() + 1] - begin_[p.value()]);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> item_;
};

/// The join in progress: steps in the order of assemble.h.
class Joiner {
 public:
  Joiner(SpaceDraft& draft, Context& context)
      : draft_(draft), maps_(draft.maps), context_(context) {}

  SpaceComplex run() {
    context_.checkpoint("join", 0, 5);
    splice();
    make_vertices();
    make_edges();
    find_connected();
    release(draft_.vertex_point, draft_.vertex_mark, draft_.maps.direction);
    context_.checkpoint("join", 1, 5);
    run_jobs(context_, 2, [this](std::size_t i, Context&) { i == 0 ? make_stars() : link_uses(); });
    release(draft_.maps.next, draft_.twin, use_of_arc_);
    trace_cycles();
    context_.checkpoint("join", 2, 5);
    gather_facets();
    release(draft_.maps.origin, draft_.maps.circle, draft_.arc_origin, parent_, first_use_);
    context_.checkpoint("join", 3, 5);
    label_volumes(out_, context_, connected_);
    copy_volume_marks();
    return std::move(out_);
  }

 private:
  /// Frees arrays that no later step reads: the peak of memory comes with the volumes.
  template <class... Arrays>
  static void release(Arrays&... arrays) {
    ((arrays = Arrays()), ...);
  }

  // ---- vertices and edges

  /// Removes places inside edges. The neighbours of both points of such a place face each other;
  /// chains of places shrink one by one.
  void splice() {
    for (std::size_t v = 0; v < draft_.vertex_count(); ++v) {
      if (draft_.is_passed[v] == 0) continue;
      has_passed_ = true;
      // The map of a place inside an edge has exactly two opposite points.
      const std::uint32_t x = draft_.begin[v].point, y = x + 1;
      const std::uint32_t a = draft_.twin[x], b = draft_.twin[y];
      PLUMB_CHECK(a != kNone && b != kNone);
      draft_.twin[a] = b;
      draft_.twin[b] = a;
    }
  }

  /// Whether a point belongs to a place inside an edge.
  bool is_passed(std::uint32_t point) const {
    return has_passed_ && draft_.is_passed[draft_.vertex_of_point[point].value()] != 0;
  }

  void make_vertices() {
    out_.tables = draft_.tables;
    vertex_number_.resize(draft_.vertex_count());
    for (std::size_t v = 0; v < draft_.vertex_count(); ++v) {
      if (draft_.is_passed[v] != 0) continue;
      vertex_number_[v] = VertexId(out_.vertex_count());
      out_.vertex_point.push_back(draft_.vertex_point[v]);
      out_.vertex_mark.push_back(draft_.vertex_mark[v]);
    }
    out_.vertex_facet.resize(out_.vertex_count());
  }

  /// Makes edge e of the pair (i, j) of facing points, i < j: half-edge 2e leaves point i, whose
  /// direction gives the edge its two planes in order.
  void make_edges() {
    halfedge_of_point_.resize(maps_.point_count());
    out_.edge_planes.reserve(maps_.point_count() / 2);
    out_.edge_mark.reserve(maps_.point_count() / 2);
    out_.origin.reserve(maps_.point_count());
    for (std::uint32_t i = 0; i < maps_.point_count(); ++i) {
      const std::uint32_t j = draft_.twin[i];
      if (is_passed(i) || j < i) continue;
      PLUMB_CHECK(j != kNone && j != i && maps_.point_mark[i] == maps_.point_mark[j]);
      const auto e = static_cast<std::uint32_t>(out_.edge_count());
      halfedge_of_point_[i] = HalfedgeId(2 * e);
      halfedge_of_point_[j] = HalfedgeId(2 * e + 1);
      out_.edge_planes.push_back({maps_.direction[i].p, maps_.direction[i].q});
      out_.edge_mark.push_back(maps_.point_mark[i]);
      out_.origin.push_back(vertex_number_[draft_.vertex_of_point[i].value()]);
      out_.origin.push_back(vertex_number_[draft_.vertex_of_point[j].value()]);
    }
    out_.edge_use.resize(out_.edge_count());
  }

  /// Notes which sphere maps are connected, for label_volumes(). A map without free points and
  /// loops is connected if and only if points - arcs + faces = 2 (Euler): with k components the sum
  /// is k + 1.
  void find_connected() {
    connected_.reserve(out_.vertex_count());
    for (std::size_t v = 0; v < draft_.vertex_count(); ++v) {
      if (draft_.is_passed[v] != 0) continue;
      const SpaceDraft::Offsets& at = draft_.begin[v];
      const SpaceDraft::Offsets end =
          v + 1 < draft_.vertex_count() ? draft_.begin[v + 1] : draft_.end();
      bool is_whole = end.point - at.point + (end.face - at.face) == end.arc - at.arc + 2;
      for (std::uint32_t i = at.point; i < end.point; ++i) is_whole &= !draft_.is_free(i);
      for (std::uint32_t a = at.arc; a < end.arc; ++a) is_whole &= !draft_.is_loop(a);
      connected_.push_back(is_whole ? 1 : 0);
    }
  }

  /// Sorts the half-edges by their origins.
  void make_stars() {
    out_.star_begin.assign(out_.vertex_count() + 1, 0);
    for (const VertexId v : out_.origin) ++out_.star_begin[v.value() + 1];
    std::partial_sum(out_.star_begin.begin(), out_.star_begin.end(), out_.star_begin.begin());
    out_.star.resize(out_.origin.size());
    std::vector<std::uint32_t> at(out_.star_begin.begin(), out_.star_begin.end() - 1);
    for (std::uint32_t h = 0; h < out_.origin.size(); ++h) {
      out_.star[at[out_.origin[h].value()]++] = HalfedgeId(h);
    }
  }

  // ---- edge uses: one for each arc of a vertex that stays

  /// Numbers the edge uses and links them along facets and around edges, one edge at a time.
  void link_uses() {
    use_of_arc_.assign(maps_.arc_count(), UseId());
    out_.use_halfedge.reserve(maps_.arc_count());
    arc_of_use_.reserve(maps_.arc_count());
    for (std::uint32_t a = 0; a < maps_.arc_count(); ++a) {
      if (maps_.is_loop(a) || is_passed(maps_.origin[2 * a])) continue;
      use_of_arc_[a] = UseId(out_.use_count());
      out_.use_halfedge.push_back(halfedge_of_point_[maps_.origin[2 * a]]);
      arc_of_use_.push_back(a);
    }
    out_.use_next.resize(out_.use_count());
    out_.use_prev.resize(out_.use_count());
    out_.use_radial.resize(out_.use_count());
    for (std::uint32_t i = 0; i < halfedge_of_point_.size(); ++i) {
      if (i > draft_.twin[i] || is_passed(i) || maps_.first_out[i] == kNone) continue;
      if (!link_plain_edge(i)) link_edge(i);
    }
  }

  /// Does the same as link_edge() for an edge of two uses: nearly all edges. Returns false if the
  /// edge has another number of uses.
  bool link_plain_edge(std::uint32_t point) {
    const std::uint32_t x = maps_.first_out[point], after_x = maps_.clockwise(x);
    std::uint32_t y = maps_.first_out[draft_.twin[point]];
    if (y == kNone) return false;
    std::uint32_t after_y = maps_.clockwise(y);
    if (after_x == x || maps_.clockwise(after_x) != x) return false;
    if (after_y == y || maps_.clockwise(after_y) != y) return false;
    if (!is_mirror(x, after_y)) std::swap(y, after_y);
    PLUMB_CHECK(is_mirror(x, after_y) && is_mirror(after_x, y));
    const UseId first = join_corners(x, after_y), second = join_corners(after_x, y);
    out_.use_radial[first.value()] = second;
    out_.use_radial[second.value()] = first;
    out_.edge_use[halfedge_of_point_[point].value() / 2] = first;
    return true;
  }

  /// Matches the rings of arcs at both ends of an edge: half-arcs of one plane, one going out and
  /// one coming in. A ring cannot match in two rotations with different results: two facets around
  /// one edge in the same plane leave it on opposite sides, so plane and sense name one half-arc.
  void link_edge(std::uint32_t point) {
    // The ring at the far end, reversed, is the ring at the near end, rotated.
    near_.clear();
    far_.clear();
    for_each_clockwise(maps_, point, [this](std::uint32_t h) { near_.push_back(h); });
    for_each_clockwise(maps_, draft_.twin[point], [this](std::uint32_t h) { far_.push_back(h); });
    PLUMB_CHECK(near_.size() == far_.size());
    const std::size_t k = near_.size();
    // Seen from the other end the same ring runs the other way.
    std::reverse(far_.begin(), far_.end());
    std::size_t shift = 0;
    while (shift < k && !is_mirror(near_[0], far_[shift])) ++shift;
    PLUMB_CHECK(shift < k);
    radial_.clear();
    for (std::size_t i = 0; i < k; ++i) {
      const std::uint32_t x = near_[i], y = far_[(i + shift) % k];
      PLUMB_CHECK(is_mirror(x, y));
      radial_.push_back(join_corners(x, y));
    }
    // `near_` runs clockwise around the half-edge that leaves `point`, which is half-edge 2e.
    for (std::size_t i = 0; i < k; ++i) {
      out_.use_radial[radial_[(i + 1) % k].value()] = radial_[i];
    }
    out_.edge_use[halfedge_of_point_[point].value() / 2] = radial_[0];
  }

  /// Lets the corners of one facet at both ends of an edge follow each other, and returns the use
  /// along the edge.
  UseId join_corners(std::uint32_t x, std::uint32_t y) {
    // An even half-arc is a corner that starts here: its use leaves along this edge.
    if (x % 2 != 0) std::swap(x, y);
    // The corner at the other end of the edge follows this one along the facet.
    const UseId leaving = use_of_arc_[x / 2], arriving_at = use_of_arc_[y / 2];
    out_.use_next[leaving.value()] = arriving_at;
    out_.use_prev[arriving_at.value()] = leaving;
    return leaving;
  }

  /// Whether half-arcs at both ends of an edge can belong to one facet: their plane is the same and
  /// one of them begins a corner while the other ends one.
  bool is_mirror(std::uint32_t x, std::uint32_t y) const {
    return maps_.circle[x / 2] == maps_.circle[y / 2] && (x ^ y) % 2 == 1;
  }

  // ---- facets

  /// Walks the cycles and makes each, for now, a facet of its own.
  void trace_cycles() {
    out_.use_facet.assign(out_.use_count(), FacetId());
    for (std::uint32_t u = 0; u < out_.use_count(); ++u) {
      if (out_.use_facet[u].is_valid()) continue;
      const FacetId f(first_use_.size());
      first_use_.push_back(UseId(u));
      out_.facet_plane.push_back(maps_.circle[arc_of_use_[u]]);
      for (UseId w(u); !out_.use_facet[w.value()].is_valid(); w = out_.use_next[w.value()]) {
        out_.use_facet[w.value()] = f;
      }
    }
  }

  /// The cycles of one plane, and the loops of vertices inside its facets.
  struct PlaneGroup {
    std::span<const std::uint32_t> cycles;
    std::span<const std::uint32_t> loops;
  };

  /// Finds the outer cycle around every hole and inner vertex, plane by plane.
  void gather_facets() {
    const auto cycles = static_cast<std::uint32_t>(first_use_.size());
    // Cycles and loops are sorted by their planes in linear time, then each plane is nested by
    // itself.
    parent_.assign(cycles, kNone);
    std::vector<std::uint32_t> all_cycles(cycles), all_loops;
    std::iota(all_cycles.begin(), all_cycles.end(), 0U);
    for (std::uint32_t a = 0; a < maps_.arc_count(); ++a) {
      if (maps_.is_loop(a)) all_loops.push_back(a);
    }
    const ByPlane by_cycle(all_cycles, out_.facet_plane, draft_.tables->planes.size());
    const ByPlane by_loop(all_loops, maps_.circle, draft_.tables->planes.size());
    for (std::uint32_t p = 0; p < draft_.tables->planes.size(); ++p) {
      if (p % 1024 == 0) context_.checkpoint("join", 2, 5);
      nest(PlaneId(p), {by_cycle.of(PlaneId(p)), by_loop.of(PlaneId(p))});
    }
    number_facets();
  }

  /// Nests the cycles and inner vertices of one plane. A single cycle without inner vertices needs
  /// no arithmetic.
  void nest(PlaneId plane, const PlaneGroup& group) {
    if (group.cycles.size() <= 1 && group.loops.empty()) return;
    cycles_.clear();
    inner_.clear();
    for (const std::uint32_t c : group.cycles) cycles_.push_back(first_use_[c]);
    for (const std::uint32_t a : group.loops) inner_.push_back(vertex_of_loop(a));
    // nest_cycles() names the outer cycle of each cycle and point by its index in these lists.
    const CycleNesting nesting = nest_cycles(out_, plane, cycles_, inner_, context_);
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
      if (nesting.of_cycle[i] != i) parent_[group.cycles[i]] = group.cycles[nesting.of_cycle[i]];
    }
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      inner_of_cycle_.emplace_back(group.cycles[nesting.of_point[i]], inner_[i]);
    }
  }

  /// Returns the vertex whose map has a loop: the last one whose arcs begin at or before it.
  VertexId vertex_of_loop(std::uint32_t arc) const {
    const auto next =
        std::upper_bound(draft_.begin.begin(), draft_.begin.end(), arc,
                         [](std::uint32_t a, const SpaceDraft::Offsets& o) { return a < o.arc; });
    return vertex_number_[static_cast<std::size_t>(next - draft_.begin.begin()) - 1];
  }

  /// Makes a facet of each outer cycle, in their order, with its holes and inner vertices. Its
  /// facet_origin is the least of those of its corners.
  void number_facets() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> holes;
    for (std::uint32_t c = 0; c < parent_.size(); ++c) {
      if (parent_[c] != kNone) holes.emplace_back(parent_[c], c);
    }
    std::sort(holes.begin(), holes.end());
    // Holes and inner vertices are sorted by their outer cycle, so one pass over cycles meets them
    // in order.
    std::stable_sort(inner_of_cycle_.begin(), inner_of_cycle_.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    reserve_facets(first_use_.size() - holes.size());
    std::vector<FacetId> facet_of_cycle(first_use_.size());
    auto hole = holes.begin();
    auto inner = inner_of_cycle_.begin();
    for (std::uint32_t c = 0; c < first_use_.size(); ++c) {
      if (parent_[c] != kNone) continue;
      const FacetId f(facet_count_);
      const std::uint32_t arc = arc_of_use_[first_use_[c].value()];
      // This overwrites nothing that is still needed, as facet_count_ <= c.
      out_.facet_plane[facet_count_++] = out_.facet_plane[c];
      out_.facet_mark.push_back(maps_.arc_mark[arc]);
      out_.facet_origin.push_back(draft_.arc_origin[arc]);
      facet_of_cycle[c] = f;
      out_.cycle.push_back(first_use_[c]);
      for (; hole != holes.end() && hole->first == c; ++hole) {
        facet_of_cycle[hole->second] = f;
        out_.cycle.push_back(first_use_[hole->second]);
      }
      for (; inner != inner_of_cycle_.end() && inner->first == c; ++inner) {
        out_.inner.push_back(inner->second);
        out_.vertex_facet[inner->second.value()] = f;
      }
      out_.cycle_begin.push_back(static_cast<std::uint32_t>(out_.cycle.size()));
      out_.inner_begin.push_back(static_cast<std::uint32_t>(out_.inner.size()));
    }
    out_.facet_plane.resize(facet_count_);
    for (FacetId& f : out_.use_facet) f = facet_of_cycle[f.value()];
    for (std::uint32_t u = 0; u < out_.use_count(); ++u) {
      const FacetId f = out_.use_facet[u];
      PLUMB_CHECK(maps_.arc_mark[arc_of_use_[u]] == out_.facet_mark[f.value()]);
      std::uint32_t& origin = out_.facet_origin[f.value()];
      origin = std::min(origin, draft_.arc_origin[arc_of_use_[u]]);
    }
  }

  void reserve_facets(std::size_t n) {
    out_.facet_mark.reserve(n);
    out_.facet_origin.reserve(n);
    out_.cycle.reserve(first_use_.size());
    out_.cycle_begin.reserve(n + 1);
    out_.inner_begin.reserve(n + 1);
    out_.cycle_begin = {0};
    out_.inner_begin = {0};
  }

  // ---- volumes

  /// Sets the mark of a volume, or checks it if it is known already.
  void set_volume_mark(VolumeId volume, Mark mark) {
    Mark& known = out_.volume_mark[volume.value()];
    std::uint8_t& is_known = is_marked_[volume.value()];
    PLUMB_CHECK(is_known == 0 || known == mark);
    known = mark;
    is_known = 1;
  }

  /// Copies the marks of volumes from everything that borders on them: sides of facets, free edges,
  /// isolated vertices.
  void copy_volume_marks() {
    is_marked_.assign(out_.volume_count(), 0);
    for (std::uint32_t u = 0; u < out_.use_count(); ++u) {
      const auto& volumes = out_.facet_volume[out_.use_facet[u].value()];
      for (std::uint32_t side = 0; side < 2; ++side) {
        set_volume_mark(volumes[side], maps_.face_mark[maps_.face[2 * arc_of_use_[u] + side]]);
      }
    }
    for (std::uint32_t i = 0; i < halfedge_of_point_.size(); ++i) {
      if (is_passed(i) || maps_.first_out[i] != kNone) continue;
      set_volume_mark(out_.edge_volume[halfedge_of_point_[i].value() / 2],
                      maps_.face_mark[maps_.point_face[i]]);
    }
    for (std::size_t v = 0; v < vertex_number_.size(); ++v) {
      if (draft_.is_passed[v] != 0) continue;
      const VolumeId volume = out_.vertex_volume[vertex_number_[v].value()];
      if (volume.is_valid()) set_volume_mark(volume, maps_.face_mark[draft_.begin[v].face]);
    }
  }

  SpaceDraft& draft_;
  const SphereMap& maps_;
  Context& context_;
  SpaceComplex out_;

  bool has_passed_ = false;              // Whether a vertex of the draft is a place inside an edge.
  std::vector<VertexId> vertex_number_;  // The new number of each vertex of the draft.
  std::vector<std::uint8_t> connected_;  // Whether the map of each vertex is connected.
  std::vector<HalfedgeId> halfedge_of_point_;  // The half-edge of each point.
  std::vector<UseId> use_of_arc_;              // The use of each arc.
  std::vector<std::uint32_t> arc_of_use_;      // The arc of each use.
  std::vector<UseId> first_use_;               // A use of each cycle.
  std::vector<std::uint32_t> parent_;          // The outer cycle around each hole, else kNone.
  std::vector<std::pair<std::uint32_t, VertexId>> inner_of_cycle_;
  std::size_t facet_count_ = 0;
  std::vector<std::uint8_t> is_marked_;  // Whether the mark of each volume is set.
  std::vector<std::uint32_t> near_, far_;
  std::vector<UseId> radial_, cycles_;
  std::vector<VertexId> inner_;
};

}  // namespace

SpaceComplex join(SpaceDraft draft, Context& context) {
  SpaceComplex whole;
  if (draft.vertex_count() == 0) {
    whole.tables = draft.tables;
    whole.star_begin = whole.cycle_begin = whole.inner_begin = {0};
    whole.volume_mark = {0};
    return whole;
  }
  return Joiner(draft, context).run();
}

}  // namespace plumb
