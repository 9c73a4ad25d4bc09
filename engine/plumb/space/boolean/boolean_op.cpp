// Booleans of complexes: the order of the steps, the times at which memory is freed, and the parts
// that run in parallel.
//
// The two operands are symmetric until Combiner applies the function of marks, so each step runs
// for operand 0 and 1 by one function. With threads, contacts are overlaid in batches of 512, each
// by a Combiner of its own; the parts are appended in the order of the batches, so the result does
// not depend on the number of threads.
//
// A plane as second operand needs neither boxes nor rays: a sign for each vertex says where it
// lies, and an edge whose ends lie on both sides crosses the plane in one point
// (docs/design/boolean.md, "Where the result can have a vertex").
//
// Invariants: tables only grow, ids in use never change; every array of SpaceComplex appears once
// in appended(). Peak memory: the draft and the result at once, so operands are freed between them.
// Tested by tests/space/nef3_test.cpp, tests/space/nef3_property_test.cpp and
// tests/space/threads_test.cpp.

#include "plumb/space/boolean/boolean_op.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/boolean/combiner.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/complex/tidy_tables.h"

namespace plumb {

namespace {

constexpr const char* kMemoryName = "a Boolean of space";

/// Returns the complex of a draft. A set without vertices is the whole space or empty. The draft's
/// mark of the outside determines which of the two it is.
SpaceComplex assembled(CombinedDraft draft, Context& context) {
  SpaceComplex result = assemble(std::move(draft.vertices), context);
  if (result.vertex_count() == 0) result.volume_mark[0] = draft.outside;
  return result;
}

/// Returns the facet_origin of a facet that lies in facets of both operands.
std::uint32_t lesser_origin(std::uint32_t first, std::uint32_t second) {
  return std::min(first, second);
}

/// Replaces all ids of planes and points by those in the merged tables.
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
  const bool is_own = a.tables.use_count() == 1;
  // The fence orders the reads of other threads before the writes of this one.
  if (is_own) std::atomic_thread_fence(std::memory_order_acquire);
  // Sets share their tables and never write to them. Only a sole owner may write.
  auto tables = is_own ? std::const_pointer_cast<SpaceTables>(a.tables) : copy(*a.tables);
  if (!is_shared) translate(b, merge(*tables, *b.tables));
  a.tables = b.tables = tables;
  return tables;
}

namespace {

/// Returns a context with one thread if the operands are small, because starting threads would take
/// more time than it saves. Otherwise, returns a context with all threads.
Context with_useful_threads(const SpaceComplex& a, const SpaceComplex& b, const Context& context) {
  constexpr std::size_t kLeastUses = 4000;
  const bool is_small = a.use_count() + b.use_count() < kLeastUses;
  return Context::of_job(context, std::stop_token(), is_small ? 1U : context.threads(),
                         JobProgress::Reported);
}

/// Returns an estimate of the bytes of the draft and of the assembled complex. It has a number of
/// bytes for each corner of a facet, and a number for everything that a contact adds: two pairs of
/// cells, a point of the tables, and a vertex with its map.
std::uint64_t draft_bytes(std::size_t uses, std::size_t contacts) {
  constexpr std::uint64_t kBytesPerUse = 60, kBytesPerContact = 600;
  return kBytesPerUse * uses + kBytesPerContact * contacts;
}

/// Frees the memory of a complex, except what Combiner::finish() reads.
void free_kept(SpaceComplex& complex) {
  SpaceComplex rest;
  rest.edge_planes = std::move(complex.edge_planes);
  rest.facet_plane = std::move(complex.facet_plane);
  rest.volume_mark = std::move(complex.volume_mark);
  complex = std::move(rest);
}

/// Runs steps 2 to 6. The memory in use until the draft is assembled is charged to `memory`. If
/// `owned` is not null, it has the operands, which are consumed.
CombinedDraft draft_of(const std::shared_ptr<SpaceTables>& tables, const SpaceComplex& a,
                       const SpaceComplex& b, std::array<SpaceComplex, 2>* owned,
                       const MarkTable& f, const CommonOrigin& origin, MemoryCharge& memory,
                       Context& context) {
  WorkPhase phase("contacts");
  const std::vector<Contact> contacts = find_contacts(a, b, *tables, context);
  phase.next("labels of vertices");
  memory.add(draft_bytes(a.use_count() + b.use_count(), contacts.size()), kMemoryName);
  const std::array<const SpaceComplex*, 2> operands{&a, &b};
  // Both operands are labelled at the same time, and neither job changes the tables.
  std::array<std::optional<TouchedComplex>, 2> touched;
  std::array<IdVector<VertexId, VolumeId>, 2> labels;
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    touched[i].emplace(*operands[i], contacts, i);
    labels[i] = label_vertices(*touched[i], *operands[1 - i], contacts, i, *tables, own);
  });
  phase.next("vertices of the result");
  Combiner combiner(operands, tables, contacts, f, origin);
  if (context.threads() == 1) {  // One combiner makes the whole draft, so no parts are appended.
    combiner.overlay_contacts(context);
    for (const std::size_t i : {0U, 1U}) {
      combiner.keep_vertices(i, *touched[i], labels[i], context);
      touched[i].reset();
      if (owned != nullptr) free_kept((*owned)[i]);
    }
    phase.next("pairs of half-edges");
    return combiner.finish();
  }
  constexpr std::size_t kContactsAtOnce = 512;
  const std::size_t overlays = (contacts.size() + kContactsAtOnce - 1) / kContactsAtOnce;
  // One part for each batch of contacts, then one for the other vertices of each operand.
  std::vector<std::optional<Combiner>> parts(overlays + 2);
  run_jobs(context, parts.size(), [&](std::size_t job, Context& own) {
    Combiner& part = parts[job].emplace(operands, tables, contacts, f, origin);
    if (job < overlays) {
      const std::size_t begin = job * kContactsAtOnce;
      part.overlay_contacts(begin, std::min(begin + kContactsAtOnce, contacts.size()), own);
    } else {
      const std::size_t i = job - overlays;
      part.keep_vertices(i, *touched[i], labels[i], own);
    }
  });
  phase.next("joining the parts");
  combiner.append(parts, context);
  phase.next("pairs of half-edges");
  return combiner.finish();
}

}  // namespace

SpaceComplex boolean_op(SpaceComplex a, SpaceComplex b, MarkFunction f, Context& context) {
  Context own = with_useful_threads(a, b, context);
  MemoryCharge memory(context);
  memory.add(memory_bytes(a) + memory_bytes(b), kMemoryName);
  WorkPhase phase("uniting tables");
  const std::shared_ptr<SpaceTables> tables = unite_tables(a, b);
  std::array<SpaceComplex, 2> operands{std::move(a), std::move(b)};
  phase.next("draft");
  CombinedDraft draft = draft_of(tables, operands[0], operands[1], &operands, MarkTable(f),
                                 lesser_origin, memory, own);
  phase.next("assembling");
  // The peak of memory is still to come, when the draft and the result exist at the same time.
  operands = {};
  return assembled(std::move(draft), own);
}

SpaceComplex boolean_op_on(const std::shared_ptr<SpaceTables>& tables, const SpaceComplex& a,
                           const SpaceComplex& b, const MarkTable& f, const CommonOrigin& origin,
                           Context& context) {
  Context own = with_useful_threads(a, b, context);
  MemoryCharge memory(context);
  return assembled(draft_of(tables, a, b, nullptr, f, origin, memory, own), own);
}

namespace {

/// Returns the marks on the plane, above it and below it.
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

/// Returns a plane as a complex: one facet without boundary, with volume 0 above it and volume 1
/// below it. Its arrays of cycles stay empty: local_map() of a facet reads its plane, mark and
/// volumes only.
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

/// Finds all contacts with the plane, and the volume (0 above, 1 below) of every vertex off it. An
/// edge within the plane has its ends on it, and these are contacts. A facet of `a` shares a
/// direction with the plane, so it is no contact.
void find_contacts_with_plane(const SpaceComplex& a, PlaneId plane, SpaceTables& tables,
                              std::vector<Contact>& contacts,
                              IdVector<VertexId, VolumeId>& labels) {
  IdVector<VertexId, Sign> sides(a.vertex_count());
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
    const Sign from = sides[a.origin[2 * e]], to = sides[a.origin[2 * e + 1]];
    // The ends are strictly on both sides, so the edge crosses the plane in one point.
    if (from * to != Sign::Negative) continue;
    const auto& [p, q] = a.edge_planes[e];
    contacts.push_back({EdgeId(e), FacetId(0), tables.points.add(p, q, plane)});
  }
}

}  // namespace

SpaceComplex boolean_op_with_plane(SpaceComplex first, OrientedPlane plane, PlaneSet h,
                                   MarkFunction f, const std::shared_ptr<SpaceTables>& tables,
                                   Context& context) {
  MemoryCharge memory(context);
  memory.add(memory_bytes(first), kMemoryName);
  first.tables = tables;
  if (plane.is_opposite()) h = opposite(h);
  const SpaceComplex second = plane_operand(tables, plane.plane(), h);
  std::vector<Contact> contacts;
  IdVector<VertexId, VolumeId> labels;
  find_contacts_with_plane(first, plane.plane(), *tables, contacts, labels);
  memory.add(draft_bytes(first.use_count(), contacts.size()), kMemoryName);
  const TouchedComplex touched(first, contacts, 0);
  const CommonOrigin origin = lesser_origin;
  Combiner combiner({&first, &second}, tables, contacts, MarkTable(f), origin);
  combiner.overlay_contacts(context);
  combiner.keep_vertices(0, touched, labels, context);
  return assembled(combiner.finish(), context);
}

namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Appends ids, each increased by `shift`. Invalid ids remain invalid.
template <class Id>
void append_shifted(std::vector<Id>& all, const std::vector<Id>& more, std::size_t shift) {
  for (const Id id : more) all.push_back(id.is_valid() ? Id(id.value() + shift) : id);
}

/// Appends starts of lists, each raised by `shift`, without the first: `all` ends with it already.
void append_begins(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more,
                   std::size_t shift) {
  for (std::size_t i = 1; i < more.size(); ++i) {
    all.push_back(more[i] + static_cast<std::uint32_t>(shift));
  }
}

/// Renumbers the volumes of an appended complex. Volume 0 is common to both.
class VolumeShift {
 public:
  explicit VolumeShift(std::size_t volumes_before)
      : shift_(static_cast<std::uint32_t>(volumes_before - 1)) {}
  VolumeId operator()(VolumeId v) const {
    return v.is_valid() && v.value() != 0 ? VolumeId(v.value() + shift_) : v;
  }

 private:
  std::uint32_t shift_;
};

/// The six ways from a box to infinity along the axes, and which of them are still free. A way is
/// the box extended without bound in one direction.
class Ways {
 public:
  explicit Ways(const Box3& from) : from_(from) {
    ways_.fill(from);
    for (std::size_t i = 0; i < 3; ++i) {
      ways_[2 * i].low[i] = -Box3::kInfinity;
      ways_[2 * i + 1].high[i] = Box3::kInfinity;
    }
  }
  /// Blocks the ways that meet `by`. Returns false if `by` meets the box itself, or if no way is
  /// left.
  bool obstruct(const Box3& by) {
    if (by.meets(from_)) return false;
    for (std::size_t w = 0; w < ways_.size(); ++w) {
      if (by.meets(ways_[w])) is_free_[w] = false;
    }
    return std::ranges::find(is_free_, true) != is_free_.end();
  }

 private:
  Box3 from_;
  std::array<Box3, 6> ways_;
  std::array<bool, 6> is_free_ = {true, true, true, true, true, true};
};

/// Whether the box can be moved to infinity without meeting the boundary of the complex. If it can,
/// the whole box lies in volume 0. Boxes of facets cover their edges and vertices, so only free
/// edges and isolated vertices must be tested in addition.
bool is_beyond(const SpaceComplex& complex, const Box3& box) {
  Ways ways(box);
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    if (!ways.obstruct(box_of(complex, FacetId(f)))) return false;
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.edge_use[e].is_valid()) continue;
    if (!ways.obstruct(box_of(complex, EdgeId(e)))) return false;
  }
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    if (!complex.star_of(VertexId(v)).empty()) continue;
    if (!ways.obstruct(box_of(complex, VertexId(v)))) return false;
  }
  return true;
}

/// Whether the box can be moved to infinity without meeting a part.
bool is_beyond(std::span<const Box3> parts, const Box3& box) {
  Ways ways(box);
  return std::ranges::all_of(parts, [&](const Box3& part) { return ways.obstruct(part); });
}

Box3 around(std::span<const Box3> parts) {
  Box3 all;
  for (const Box3& part : parts) all.add(part);
  return all;
}

}  // namespace

// The whole boundary of b lies in its box. If this box can move to infinity along an axis without
// meeting a, then b lies in volume 0 of a. Then a also lies in volume 0 of b, because a has no
// point in the box, and the points outside of a box are connected. Single cells are tested only
// once, against the operand with more facets.
bool are_apart(const BoxedComplex& a, const BoxedComplex& b) {
  if (a.complex.vertex_count() == 0 || b.complex.vertex_count() == 0) return false;
  const Box3 of_a = around(a.parts), of_b = around(b.parts);
  if (!of_a.meets(of_b) || is_beyond(a.parts, of_b) || is_beyond(b.parts, of_a)) return true;
  const bool is_a_larger = a.complex.facet_count() > b.complex.facet_count();
  return is_a_larger ? is_beyond(a.complex, of_b) : is_beyond(b.complex, of_a);
}

// Every array of b is appended, with its ids increased by the sizes that a had before.
SpaceComplex appended(SpaceComplex a, SpaceComplex b) {
  unite_tables(a, b);
  const std::size_t vertices = a.vertex_count(), edges = a.edge_count(), uses = a.use_count(),
                    facets = a.facet_count();
  const VolumeShift volume(a.volume_count());
  append(a.vertex_point, b.vertex_point);
  append(a.vertex_mark, b.vertex_mark);
  for (const VolumeId v : b.vertex_volume) a.vertex_volume.push_back(volume(v));
  append_shifted(a.vertex_facet, b.vertex_facet, facets);
  append_begins(a.star_begin, b.star_begin, a.star.size());
  append_shifted(a.star, b.star, 2 * edges);

  append(a.edge_planes, b.edge_planes);
  append(a.edge_mark, b.edge_mark);
  append_shifted(a.edge_use, b.edge_use, uses);
  for (const VolumeId v : b.edge_volume) a.edge_volume.push_back(volume(v));
  append_shifted(a.origin, b.origin, vertices);

  append_shifted(a.use_halfedge, b.use_halfedge, 2 * edges);
  append_shifted(a.use_next, b.use_next, uses);
  append_shifted(a.use_prev, b.use_prev, uses);
  append_shifted(a.use_radial, b.use_radial, uses);
  append_shifted(a.use_facet, b.use_facet, facets);

  append(a.facet_plane, b.facet_plane);
  append(a.facet_mark, b.facet_mark);
  for (const auto& [above, below] : b.facet_volume) {
    a.facet_volume.push_back({volume(above), volume(below)});
  }
  append(a.facet_origin, b.facet_origin);
  append_begins(a.cycle_begin, b.cycle_begin, a.cycle.size());
  append_shifted(a.cycle, b.cycle, uses);
  append_begins(a.inner_begin, b.inner_begin, a.inner.size());
  append_shifted(a.inner, b.inner, vertices);
  a.volume_mark.insert(a.volume_mark.end(), b.volume_mark.begin() + 1, b.volume_mark.end());
  return a;
}

}  // namespace plumb
