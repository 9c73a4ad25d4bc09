// Steps 4 to 6 of a Boolean: decides about every vertex, and finds the half-edges that face each
// other.
//
// At a contact the sphere maps of both operands are overlaid, marks combined, and the result
// simplified; it is a vertex, a place inside an edge (kept until edges are joined), or nothing. A
// vertex in a volume with mark n changes its marks by m -> f(m, n): the identity, the negation, or
// a constant, under which it is dropped.
//
// Invariant of pairing: every half-edge of the draft runs in one cell of each operand. Half-edges
// with the same two cells lie on one line and alternate along it: a half-edge that leaves in the
// reference direction is followed by a half-edge that looks back (docs/design/boolean.md, Lemma 5).
// If one of the cells is an edge e, the reference direction is the direction of half-edge 2e.
// Otherwise it is n_p x n_q for the planes p of the facet of a and q of the facet of b.
//
// Tested by tests/space/nef3_property_test.cpp and tests/space/degenerate_families_test.cpp.

#include "plumb/space/boolean/combiner.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {

namespace {

// The part of the draft of so many contacts remains in the cache.
constexpr std::size_t kRingsAtOnce = 128;

/// Returns the name of the line that contains half-edges in the cells a and b.
std::uint64_t line_key(SpaceItem a, SpaceItem b) {
  return (std::uint64_t{a.code()} << 32U) | b.code();
}

}  // namespace

// If the overlay is the map of a facet or of a volume, the contact is dropped, because it does not
// differ from its neighbourhood. The map of an edge is added as a place inside of an edge, because
// its two half-edges may come from different cells and must be paired separately.
void Combiner::overlay_contacts(std::size_t begin, std::size_t end, Context& context) {
  std::vector<std::uint32_t> origin_ids;
  for (std::size_t i = begin; i < end; ++i) {
    if (i % 1024 == 0) context.checkpoint("overlay", i, contacts_.size());
    const Contact& c = contacts_[i];
    local_map(*operands_[0], c.a, local_[0]);
    local_map(*operands_[1], c.b, local_[1]);
    overlay_.boolean_op(local_[0].map, local_[1].map, table_, map_, origins_, &context);
    const PyramidKind kind = classify(planes_, map_);
    if (kind != PyramidKind::Vertex && kind != PyramidKind::Edge) continue;
    origin_ids.clear();
    for (const auto& pair : origins_.arc) origin_ids.push_back(facet_origin(pair));
    const auto offsets = draft_.add(c.point, map_, kind == PyramidKind::Edge, origin_ids);
    for (std::uint32_t p = 0; p < map_.point_count(); ++p) add_contact_end(offsets.point + p, p);
  }
}

// Vertices are added in their order, so that the draft keeps the order of the operand. Vertices
// whose corners make one ring (nearly all of them) are collected and added many at once; a vertex
// of another kind flushes the list first.
void Combiner::keep_vertices(std::size_t operand, const TouchedComplex& own,
                             std::span<const VolumeId> labels, Context& context) {
  const SpaceComplex& complex = *operands_[operand];
  MemoryCharge memory(context);  // The arrays of the carrier for all half-edges and edge uses.
  memory.add(sizeof(std::uint32_t) * (complex.origin.size() + complex.use_count()),
             "vertices that stay");
  reserve(operand, own, labels);
  VertexCarrier carrier(complex, draft_, overlay_);
  std::vector<VertexCarrier::Remarked> rings;  // Vertices to be added before the next other one.
  rings.reserve(kRingsAtOnce);
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    if (v % 4096 == 0) context.checkpoint("vertices that stay", v, complex.vertex_count());
    if (own.is_touched(VertexId(v))) continue;
    const std::array<Mark, 3> becomes = marks_in(operand, labels[v]);
    // If the function is constant, all marks around the vertex are equal, so the minimal form drops
    // it. Only a vertex of the frame is kept, because kBeyond does not change.
    const bool is_constant = becomes[0] == becomes[1];
    if (is_constant && complex.vertex_mark[v] != kBeyond) continue;
    if (!is_constant && carrier.may_have_ring(VertexId(v))) {
      rings.push_back({VertexId(v), becomes});
      if (rings.size() == kRingsAtOnce) keep_rings(complex, rings, carrier);
    } else {
      keep_rings(complex, rings, carrier);
      keep_vertex(complex, VertexId(v), becomes, is_constant, carrier);
    }
  }
  keep_rings(complex, rings, carrier);
  face_kept_ends(operand, own, labels, carrier.point_of());
}

/// Pairs the half-edges of one operand. If an edge has no contacts and both ends are kept, its
/// twins are kept. Any other half-edge lies, up to the first contact, in its edge and in the volume
/// of the other operand around its vertex. These two cells are the name of its line.
void Combiner::face_kept_ends(std::size_t operand, const TouchedComplex& own,
                              std::span<const VolumeId> labels,
                              std::span<const std::uint32_t> point_of) {
  const SpaceComplex& complex = *operands_[operand];
  for (std::uint32_t h = 0; h < point_of.size(); ++h) {
    if (point_of[h] == kNone) continue;
    const EdgeId e(h / 2);
    const std::uint32_t opposite = point_of[h ^ 1U];
    if (!own.is_touched(e) && opposite != kNone) {
      draft_.twin[point_of[h]] = opposite;
      continue;
    }
    const VolumeId around = labels[complex.origin[h].value()];
    const std::uint64_t line = operand == 0 ? line_key(e, around) : line_key(around, e);
    ends_.push_back({line, point_of[h], h % 2 == 0 ? Sign::Positive : Sign::Negative});
  }
}

// When a draft is appended, the indices of points change, but the names of lines do not, because
// they are ids of the operands.
void Combiner::append(std::span<std::optional<Combiner>> parts, Context& context) {
  std::uint32_t offset = draft_.end().point;
  std::vector<SpaceDraft*> drafts;
  for (std::optional<Combiner>& part : parts) {
    drafts.push_back(&part->draft_);
    for (const LineEnd& end : part->ends_) {
      ends_.push_back({end.line, end.point + offset, end.sign});
    }
    offset += part->draft_.end().point;
  }
  draft_.take_all(drafts, context);
}

CombinedDraft Combiner::finish() {
  pair_ends();
  return {std::move(draft_), table_(operands_[0]->volume_mark[0], operands_[1]->volume_mark[0])};
}

/// Returns the images of the marks 0, 1 and kBeyond of one operand in a volume of the other
/// operand.
std::array<Mark, 3> Combiner::marks_in(std::size_t operand, VolumeId volume) const {
  const Mark around = operands_[1 - operand]->volume_mark[volume];
  return {combined(operand, 0, around), combined(operand, 1, around), kBeyond};
}

/// Reserves memory for the vertices that are kept. In most sets, each vertex has as many corners as
/// edges, and two volumes around it.
void Combiner::reserve(std::size_t operand, const TouchedComplex& own,
                       std::span<const VolumeId> labels) {
  const SpaceComplex& complex = *operands_[operand];
  std::size_t vertices = 0, points = 0;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    if (own.is_touched(VertexId(v))) continue;
    const std::array<Mark, 3> becomes = marks_in(operand, labels[v]);
    if (becomes[0] == becomes[1]) continue;
    ++vertices;
    points += complex.star_of(VertexId(v)).size();
  }
  draft_.reserve_more(vertices, points, points, 2 * vertices);
}

/// Adds all vertices of the list, and empties the list. The carrier stops at a vertex with several
/// rings, which is added by its local map.
void Combiner::keep_rings(const SpaceComplex& complex, std::vector<VertexCarrier::Remarked>& rings,
                          VertexCarrier& carrier) {
  std::span<const VertexCarrier::Remarked> left = rings;
  while (!left.empty()) {
    left = left.subspan(carrier.add_rings(left));
    if (left.empty()) break;
    keep_vertex(complex, left.front().vertex, left.front().becomes, false, carrier);
    left = left.subspan(1);
  }
  rings.clear();
}

/// Adds one vertex by its local map with new marks. With may_dissolve the map may not be minimal
/// under them.
void Combiner::keep_vertex(const SpaceComplex& complex, VertexId v,
                           const std::array<Mark, 3>& becomes, bool may_dissolve,
                           VertexCarrier& carrier) {
  LocalMap& local = local_[0];
  local_map(complex, v, local);
  local.map.centre_mark = becomes[local.map.centre_mark];
  for (auto* marks : {&local.map.point_mark, &local.map.arc_mark, &local.map.face_mark}) {
    for (Mark& m : *marks) m = becomes[m];
  }
  if (may_dissolve) {
    carrier.add_simplified(v, local);
  } else {
    carrier.add(v, local);
  }
}

/// Returns the facet_origin of an arc of the overlay. It is the facet_origin of the facet that
/// contains the arc. If facets of both operands overlap, common_origin_ combines both.
std::uint32_t Combiner::facet_origin(const SphereOrigins::Pair& cells) const {
  const auto is_facet = [&](std::size_t i) {
    return cells[i].is_valid() && cells[i].kind() == SphereCell::Kind::Arc;
  };
  const auto origin_in = [&](std::size_t i) {
    return operands_[i]->facet_origin[local_[i].facet[cells[i].index()]];
  };
  if (is_facet(0)) return is_facet(1) ? common_origin_(origin_in(0), origin_in(1)) : origin_in(0);
  PLUMB_CHECK(is_facet(1));
  return origin_in(1);
}

/// Notes a half-edge that leaves a contact. `p` is a point of map_, the current overlay.
void Combiner::add_contact_end(std::uint32_t draft_point, std::uint32_t p) {
  const SphereOrigins::Pair& cells = origins_.point[p];
  const SpaceItem a = local_[0].item(cells[0]), b = local_[1].item(cells[1]);
  ends_.push_back({line_key(a, b), draft_point, sign_on_line(cells, map_.direction[p])});
}

/// Returns whether a direction agrees with the reference direction of its line, or is opposite to
/// it. If a cell is an edge, the parity of the half-edge decides. Otherwise, the cells are two
/// facets with planes p and q, the reference direction is n_p x n_q, and same_direction() compares.
Sign Combiner::sign_on_line(const SphereOrigins::Pair& cells, SphereDirection direction) const {
  for (std::size_t i = 0; i < 2; ++i) {
    if (cells[i].kind() != SphereCell::Kind::Point) continue;
    const HalfedgeId h = local_[i].halfedge[cells[i].index()];
    return SpaceComplex::is_reverse(h) ? Sign::Negative : Sign::Positive;
  }
  const PlaneId p = local_[0].map.circle[cells[0].index()];
  const PlaneId q = local_[1].map.circle[cells[1].index()];
  return same_direction(planes_, p, q, direction.p, direction.q);
}

// ---------------------------------------------------------------- pairing

// The half-edges are sorted by the name of the line and then by point, so the order does not depend
// on the division of the draft among threads.
void Combiner::pair_ends() {
  std::sort(ends_.begin(), ends_.end(), [](const LineEnd& x, const LineEnd& y) {
    return x.line != y.line ? x.line < y.line : x.point < y.point;
  });
  for (std::size_t i = 0; i < ends_.size();) {
    std::size_t end = i + 1;
    while (end < ends_.size() && ends_[end].line == ends_[i].line) ++end;
    pair_line(std::span(ends_).subspan(i, end - i));
    i = end;
  }
}

// If a line has only two ends, which look in opposite directions, they face each other without any
// arithmetic. Nearly all lines are of this kind.
void Combiner::pair_line(std::span<LineEnd> line) {
  if (line.size() == 2 && line[0].sign != line[1].sign) {
    face_each_other(line[0].point, line[1].point);
    return;
  }
  sort_along(line);
  PLUMB_CHECK(line.size() % 2 == 0);
  for (std::size_t i = 0; i < line.size(); i += 2) {
    PLUMB_CHECK(line[i].sign == Sign::Positive && line[i + 1].sign == Sign::Negative);
    face_each_other(line[i].point, line[i + 1].point);
  }
}

/// Sorts along the reference direction of the line. Of two ends at one vertex, the one that looks
/// back comes first, as its edge ends there and the other one's begins. Different vertices of one
/// line never tie: they are different points.
void Combiner::sort_along(std::span<LineEnd> line) {
  const std::array<PlaneId, 2> planes = planes_of(line[0].line);
  std::sort(line.begin(), line.end(), [&](const LineEnd& x, const LineEnd& y) {
    const VertexId v = draft_.vertex_of_point[x.point], w = draft_.vertex_of_point[y.point];
    if (v == w) return x.sign < y.sign;
    return order_along_line(points_, planes[0], planes[1], draft_.vertex_point[v],
                            draft_.vertex_point[w]) == Sign::Positive;
  });
}

/// Returns two planes that meet in the line, in the order that gives its reference direction: those
/// of the edge if one of the cells is an edge, else those of the two facets.
std::array<PlaneId, 2> Combiner::planes_of(std::uint64_t line) const {
  const std::array<std::uint32_t, 2> codes{static_cast<std::uint32_t>(line >> 32U),
                                           static_cast<std::uint32_t>(line)};
  std::array<PlaneId, 2> facets;
  for (std::size_t i = 0; i < 2; ++i) {
    const SpaceItem item = SpaceItem::from_code(codes[i]);
    if (item.kind() == SpaceItem::Kind::Edge) return operands_[i]->edge_planes[item.index()];
    if (item.kind() == SpaceItem::Kind::Facet) {
      facets[i] = operands_[i]->facet_plane[item.index()];
    }
  }
  return facets;
}

}  // namespace plumb
