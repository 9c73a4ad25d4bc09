#include "plumb/space/combine.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stop_token>

#include "plumb/base/error.h"
#include "plumb/base/parallel.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/meet.h"
#include "plumb/space/plane_cycles.h"
#include "plumb/space/simplify.h"
#include "plumb/space/space_draft.h"
#include "plumb/space/vertex_labels.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {

namespace {

constexpr std::uint32_t kNone = SphereMap::kNone;

/// A point of the draft and the line it points along.
struct LineEnd {
  std::uint64_t line;   ///< items of a and of b that the half-edge runs in
  std::uint32_t point;  ///< of the draft
  Sign sign;            ///< along the line's reference direction or against it
};

std::uint64_t line_key(SpaceItem a, SpaceItem b) {
  return (std::uint64_t{a.code()} << 32U) | b.code();
}

/// What is joined; `outside` is the mark of everything if nothing is left.
struct Draft {
  SpaceDraft vertices;
  Mark outside;
};

SpaceComplex joined(Draft draft, Context& context) {
  SpaceComplex result = join(std::move(draft.vertices), context);
  if (result.vertex_count() == 0) result.volume_mark[0] = draft.outside;
  return result;
}

/// Phases 4 to 6, given contacts and labels.
class Combiner {
 public:
  Combiner(std::array<const SpaceComplex*, 2> operands, std::shared_ptr<SpaceTables> tables,
           std::span<const Contact> contacts, const MarkTable& f, const CommonOrigin& origin)
      : operands_(operands),
        planes_(tables->planes),
        points_(tables->points),
        contacts_(contacts),
        table_(f),
        common_origin_(origin),
        draft_(tables),
        overlay_(tables->planes) {}

  /// Contacts make the first vertices of the draft.
  void overlay_contacts(Context& context) { overlay_contacts(0, contacts_.size(), context); }
  void overlay_contacts(std::size_t begin, std::size_t end, Context& context) {
    std::vector<std::uint32_t> origin_ids;
    for (std::size_t i = begin; i < end; ++i) {
      if (i % 1024 == 0) context.checkpoint("overlay", i, contacts_.size());
      const Contact& c = contacts_[i];
      local_map(*operands_[0], c.a, local_[0]);
      local_map(*operands_[1], c.b, local_[1]);
      overlay_.combine(local_[0].map, local_[1].map, table_, map_, origins_);
      const PyramidKind kind = classify(planes_, map_);
      if (kind != PyramidKind::Vertex && kind != PyramidKind::Edge) continue;
      origin_ids.clear();
      for (const auto& pair : origins_.arc) origin_ids.push_back(facet_origin(pair));
      const auto offsets = draft_.add(c.point, map_, kind == PyramidKind::Edge, origin_ids);
      for (std::uint32_t p = 0; p < map_.point_count(); ++p) add_contact_end(offsets.point + p, p);
    }
  }

  /// Vertices of one operand that lie in volumes of the other.
  void keep_vertices(std::size_t operand, const TouchedComplex& own,
                     std::span<const VolumeId> labels) {
    const SpaceComplex& complex = *operands_[operand];
    reserve(operand, own, labels);
    VertexCarrier carrier(complex, draft_, overlay_);
    for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
      if (own.is_touched(VertexId(v))) continue;
      const std::array<Mark, 3> becomes = marks_in(operand, labels[v]);
      // What is constant here dissolves, but for the frame.
      const bool is_constant = becomes[0] == becomes[1];
      if (is_constant && complex.vertex_mark[v] != kBeyond) continue;
      keep_vertex(complex, VertexId(v), becomes, is_constant, carrier);
    }
    const std::vector<std::uint32_t>& point_of = carrier.point_of();
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

  /// What other combiners of the same operands have made, one after the other. They are used up.
  void append(std::span<std::optional<Combiner>> parts) {
    std::size_t vertices = 0, ends = 0;
    SpaceDraft::Offsets sum{};
    for (const std::optional<Combiner>& part : parts) {
      const SpaceDraft::Offsets size = part->draft_.end();
      sum = {sum.point + size.point, sum.arc + size.arc, sum.face + size.face};
      vertices += part->draft_.vertex_count();
      ends += part->ends_.size();
    }
    draft_.reserve_more(vertices, sum.point, sum.arc, sum.face);
    ends_.reserve(ends);
    for (std::optional<Combiner>& part : parts) {
      const std::uint32_t offset = draft_.end().point;
      draft_.append(part->draft_);
      for (const LineEnd& end : part->ends_) {
        ends_.push_back({end.line, end.point + offset, end.sign});
      }
      part.reset();
    }
  }

  Draft finish() {
    pair_ends();
    return {std::move(draft_), table_(operands_[0]->volume_mark[0], operands_[1]->volume_mark[0])};
  }

 private:
  Mark combined(std::size_t operand, Mark own, Mark other) const {
    return operand == 0 ? table_(own, other) : table_(other, own);
  }

  /// What each mark of one operand becomes in a volume of the other.
  std::array<Mark, 3> marks_in(std::size_t operand, VolumeId volume) const {
    const Mark around = operands_[1 - operand]->volume_mark[volume.value()];
    return {combined(operand, 0, around), combined(operand, 1, around), kBeyond};
  }

  /// Makes room for the vertices that stay: in most sets each has as many corners as edges, and two volumes.
  void reserve(std::size_t operand, const TouchedComplex& own, std::span<const VolumeId> labels) {
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

  void keep_vertex(const SpaceComplex& complex, VertexId v, const std::array<Mark, 3>& becomes,
                   bool may_dissolve, VertexCarrier& carrier) {
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

  /// Where facets of both lie on each other, what common_origin_ makes of their ids.
  std::uint32_t facet_origin(const SphereOrigins::Pair& cells) const {
    const auto is_facet = [&](std::size_t i) {
      return cells[i].is_valid() && cells[i].kind() == SphereCell::Kind::Arc;
    };
    const auto origin_in = [&](std::size_t i) {
      return operands_[i]->facet_origin[local_[i].facet[cells[i].index()].value()];
    };
    if (is_facet(0)) return is_facet(1) ? common_origin_(origin_in(0), origin_in(1)) : origin_in(0);
    PLUMB_CHECK(is_facet(1));
    return origin_in(1);
  }

  /// `p` is a point of map_, the current overlay.
  void add_contact_end(std::uint32_t draft_point, std::uint32_t p) {
    const SphereOrigins::Pair& cells = origins_.point[p];
    const SpaceItem a = local_[0].item(cells[0]), b = local_[1].item(cells[1]);
    ends_.push_back({line_key(a, b), draft_point, sign_on_line(cells, map_.direction[p])});
  }

  Sign sign_on_line(const SphereOrigins::Pair& cells, SphereDirection direction) const {
    for (std::size_t i = 0; i < 2; ++i) {
      if (cells[i].kind() != SphereCell::Kind::Point) continue;
      const HalfedgeId h = local_[i].halfedge[cells[i].index()];
      return SpaceComplex::is_reverse(h) ? Sign::Negative : Sign::Positive;
    }
    const PlaneId p = local_[0].map.circle[cells[0].index()];
    const PlaneId q = local_[1].map.circle[cells[1].index()];
    return same_direction(planes_, p, q, direction.p, direction.q);
  }

  // ---- pairing

  void pair_ends() {
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

  void pair_line(std::span<LineEnd> line) {
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

  void face_each_other(std::uint32_t p, std::uint32_t q) {
    draft_.twin[p] = q;
    draft_.twin[q] = p;
  }

  /// Along the reference direction of the line; of two ends at one vertex the one that looks back first.
  void sort_along(std::span<LineEnd> line) {
    const std::array<PlaneId, 2> planes = planes_of(line[0].line);
    std::sort(line.begin(), line.end(), [&](const LineEnd& x, const LineEnd& y) {
      const VertexId v = draft_.vertex_of_point[x.point], w = draft_.vertex_of_point[y.point];
      if (v == w) return x.sign < y.sign;
      return order_along_line(points_, planes[0], planes[1], draft_.vertex_point[v.value()],
                              draft_.vertex_point[w.value()]) == Sign::Positive;
    });
  }

  std::array<PlaneId, 2> planes_of(std::uint64_t line) const {
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

  std::array<const SpaceComplex*, 2> operands_;
  const PlaneTable& planes_;
  const Point3Table& points_;
  std::span<const Contact> contacts_;
  MarkTable table_;
  const CommonOrigin& common_origin_;
  SpaceDraft draft_;
  SphereOverlay overlay_;
  std::vector<LineEnd> ends_;
  // of the contact at hand
  std::array<LocalMap, 2> local_;
  SphereMap map_;
  SphereOrigins origins_;
};

std::uint32_t lesser_origin(std::uint32_t first, std::uint32_t second) {
  return std::min(first, second);
}

/// The complex with the ids of merged tables.
void translate(SpaceComplex& complex, const TableMap& map) {
  for (SpacePoint& p : complex.vertex_point) p = map(p);
  for (auto& planes : complex.edge_planes) {
    for (PlaneId& p : planes) p = map(p);
  }
  for (PlaneId& p : complex.facet_plane) p = map(p);
}

}  // namespace

std::shared_ptr<SpaceTables> unite_tables(SpaceComplex& a, SpaceComplex& b) {
  const bool is_shared = a.tables == b.tables;
  if (is_shared) b.tables.reset();
  const auto tables =
      a.tables.use_count() == 1 ? std::const_pointer_cast<SpaceTables>(a.tables) : copy(*a.tables);
  if (!is_shared) translate(b, merge(*tables, *b.tables));
  a.tables = b.tables = tables;
  return tables;
}

namespace {

/// With one thread where there is so little to do that more cost more than they bring.
Context with_useful_threads(const SpaceComplex& a, const SpaceComplex& b, const Context& context) {
  constexpr std::size_t kLeastUses = 4000;
  const bool is_small = a.use_count() + b.use_count() < kLeastUses;
  return Context(context, std::stop_token(), is_small ? 1U : context.threads(), true);
}

/// Phases 2 to 6.
Draft draft_of(const std::shared_ptr<SpaceTables>& tables, const SpaceComplex& a,
               const SpaceComplex& b, const MarkTable& f, const CommonOrigin& origin,
               Context& context) {
  const std::vector<Contact> contacts = meet(a, b, *tables, context);
  const std::array<const SpaceComplex*, 2> operands{&a, &b};
  std::array<std::optional<TouchedComplex>, 2> touched;
  std::array<std::vector<VolumeId>, 2> labels;
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    touched[i].emplace(*operands[i], contacts, i);
    labels[i] = label_vertices(*touched[i], *operands[1 - i], contacts, i, *tables, own);
  });
  Combiner combiner(operands, tables, contacts, f, origin);
  if (context.threads() == 1) {  // nothing to be put together
    combiner.overlay_contacts(context);
    for (const std::size_t i : {0U, 1U}) combiner.keep_vertices(i, *touched[i], labels[i]);
    return combiner.finish();
  }
  constexpr std::size_t kContactsAtOnce = 512;
  const std::size_t overlays = (contacts.size() + kContactsAtOnce - 1) / kContactsAtOnce;
  std::vector<std::optional<Combiner>> parts(overlays + 2);
  run_jobs(context, parts.size(), [&](std::size_t job, Context& own) {
    Combiner& part = parts[job].emplace(operands, tables, contacts, f, origin);
    if (job < overlays) {
      const std::size_t begin = job * kContactsAtOnce;
      part.overlay_contacts(begin, std::min(begin + kContactsAtOnce, contacts.size()), own);
    } else {
      const std::size_t i = job - overlays;
      part.keep_vertices(i, *touched[i], labels[i]);
    }
  });
  combiner.append(parts);
  return combiner.finish();
}

}  // namespace

SpaceComplex combine(SpaceComplex a, SpaceComplex b, MarkFunction f, Context& context) {
  Context own = with_useful_threads(a, b, context);
  const std::shared_ptr<SpaceTables> tables = unite_tables(a, b);
  Draft draft = draft_of(tables, a, b, MarkTable(f), lesser_origin, own);
  a = b = {};  // the peak of memory is yet to come
  return joined(std::move(draft), own);
}

SpaceComplex combine_on(const std::shared_ptr<SpaceTables>& tables, const SpaceComplex& a,
                        const SpaceComplex& b, const MarkTable& f, const CommonOrigin& origin,
                        Context& context) {
  Context own = with_useful_threads(a, b, context);
  return joined(draft_of(tables, a, b, f, origin, own), own);
}

namespace {

/// On the plane, above it, below it.
std::array<Mark, 3> marks_of(PlaneSet h) {
  switch (h) {
    case PlaneSet::OpenBelow:
      return {0, 0, 1};
    case PlaneSet::ClosedBelow:
      return {1, 0, 1};
    case PlaneSet::OpenAbove:
      return {0, 1, 0};
    case PlaneSet::ClosedAbove:
      return {1, 1, 0};
    case PlaneSet::BeyondBelow:
      return {kBeyond, 0, kBeyond};
    case PlaneSet::BeyondAbove:
      return {kBeyond, kBeyond, 0};
    case PlaneSet::Plane:
      break;
  }
  return {1, 0, 0};
}

/// A plane as an operand: one facet without boundary, above it volume 0, below it volume 1.
SpaceComplex plane_operand(std::shared_ptr<const SpaceTables> tables, PlaneId plane, PlaneSet h) {
  SpaceComplex out;
  out.tables = std::move(tables);
  out.star_begin = {0};
  out.facet_plane = {plane};
  out.facet_volume = {{VolumeId(0), VolumeId(1)}};
  out.facet_origin = {kNone};
  const auto [on, above, below] = marks_of(h);
  out.facet_mark = {on};
  out.volume_mark = {above, below};
  return out;
}

/// Where vertices and edges touch the plane; the other vertices lie above or below.
void meet_plane(const SpaceComplex& a, PlaneId plane, SpaceTables& tables,
                std::vector<Contact>& contacts, std::vector<VolumeId>& labels) {
  std::vector<Sign> sides(a.vertex_count());
  labels.resize(a.vertex_count());
  for (std::uint32_t v = 0; v < a.vertex_count(); ++v) {
    sides[v] = side(tables.points, a.vertex_point[v], plane);
    if (sides[v] == Sign::Zero) {
      contacts.push_back({VertexId(v), FacetId(0), a.vertex_point[v]});
    } else {
      labels[v] = VolumeId(sides[v] == Sign::Positive ? 0 : 1);
    }
  }
  for (std::uint32_t e = 0; e < a.edge_count(); ++e) {
    const Sign from = sides[a.origin[2 * e].value()], to = sides[a.origin[2 * e + 1].value()];
    if (from * to != Sign::Negative) continue;
    const auto& [p, q] = a.edge_planes[e];
    contacts.push_back({EdgeId(e), FacetId(0), tables.points.add(p, q, plane)});
  }
}

}  // namespace

SpaceComplex combine_with_plane(const SpaceComplex& a, OrientedPlane plane, PlaneSet h,
                                MarkFunction f, std::shared_ptr<SpaceTables> tables,
                                Context& context) {
  SpaceComplex first = a;
  first.tables = tables;
  if (plane.is_opposite()) h = opposite(h);
  const SpaceComplex second = plane_operand(tables, plane.plane(), h);
  std::vector<Contact> contacts;
  std::vector<VolumeId> labels;
  meet_plane(first, plane.plane(), *tables, contacts, labels);
  const TouchedComplex touched(first, contacts, 0);
  const CommonOrigin origin = lesser_origin;
  Combiner combiner({&first, &second}, tables, contacts, MarkTable(f), origin);
  combiner.overlay_contacts(context);
  combiner.keep_vertices(0, touched, labels);
  return joined(combiner.finish(), context);
}

}  // namespace plumb
