// NefSphere: operations of several sets.
#include <utility>

#include "plumb/base/refused_memory.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/sphere_overlay.h"
#include "plumb/sphere/sphere_vectors.h"

namespace plumb {
namespace {

/// The maps of two sets over one table.
struct OneTable {
  std::shared_ptr<const PlaneTable> planes;
  SphereMap a;
  SphereMap b;
};

OneTable over_one_table(const NefSphere& a, const NefSphere& b) {
  if (a.shared_planes() == b.shared_planes()) return {a.shared_planes(), a.map(), b.map()};
  auto planes = std::make_shared<PlaneTable>(a.planes());
  const std::vector<PlaneId> to = planes->merge(b.planes());
  OneTable one{planes, a.map(), b.map()};
  for (PlaneId& c : one.b.circle) c = to[c.value()];
  for (SphereDirection& u : one.b.direction) u = {to[u.p.value()], to[u.q.value()]};
  return one;
}

void select(const std::function<bool(std::uint32_t)>& accepts, std::vector<Mark>& marks) {
  if (!accepts) return;
  for (std::uint32_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0 && !accepts(i)) marks[i] = 0;
  }
}

void select(const SphereSelector& selector, SphereMap& map) {
  select(selector.point, map.point_mark);
  select(selector.arc, map.arc_mark);
  select(selector.face, map.face_mark);
}

/// Without what comes of places where they meet.
std::uint64_t memory_of_overlay(const SphereMap& a, const SphereMap& b) {
  const auto items = [](const SphereMap& m) { return m.point_count() + m.arc_count(); };
  return 400 * (items(a) + items(b));
}

/// Planes that no item names any more go when they are many.
NefSphere with_few_planes(std::shared_ptr<const PlaneTable> planes, SphereMap map) {
  const std::size_t named = map.arc_count() + 2 * map.point_count();
  if (planes->size() > 2 * named + 64) planes = centred(*planes, map);
  return NefSphere::from_minimal(std::move(planes), std::move(map));
}

/// Halves the list until it is one set.
NefSphere fold(std::span<const NefSphere> sets, MarkFunction f, Context& context) {
  if (sets.size() == 1) return sets.front();
  const std::size_t half = sets.size() / 2;
  return combine(fold(sets.first(half), f, context), fold(sets.subspan(half), f, context), f,
                 context);
}

/// Without limits.
NefSphere combine_plainly(const NefSphere& a, const NefSphere& b, MarkFunction f) {
  Context context;
  return combine(a, b, f, context);
}

}  // namespace

NefSphere combine(const NefSphere& a, const SphereSelector& select_a, const NefSphere& b,
                  const SphereSelector& select_b, MarkFunction f, Context& context) try {
  context.checkpoint("overlay", 0, 1);
  MemoryCharge memory(context);
  memory.add(memory_of_overlay(a.map(), b.map()), "an overlay of the sphere");
  OneTable one = over_one_table(a, b);
  context.checkpoint("overlay", 0, 1);
  select(select_a, one.a);
  select(select_b, one.b);
  SphereMap map;
  SphereOrigins origins;
  SphereOverlay(*one.planes).combine(one.a, one.b, MarkTable(f), map, origins, &context);
  map.centre_mark = 0;
  context.checkpoint("overlay", 0, 1);
  return with_few_planes(std::move(one.planes), std::move(map));
} catch (...) {
  rethrow_refused_memory();
}

NefSphere combine(const NefSphere& a, const NefSphere& b, MarkFunction f, Context& context) try {
  return combine(a, {}, b, {}, f, context);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere union_of(std::span<const NefSphere> sets, Context& context) try {
  return sets.empty() ? NefSphere::empty() : fold(sets, kUnion, context);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere intersection_of(std::span<const NefSphere> sets, Context& context) try {
  return sets.empty() ? NefSphere::sphere() : fold(sets, kIntersection, context);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere operator+(const NefSphere& a, const NefSphere& b) {
  return combine_plainly(a, b, kUnion);
}
NefSphere operator*(const NefSphere& a, const NefSphere& b) {
  return combine_plainly(a, b, kIntersection);
}
NefSphere operator-(const NefSphere& a, const NefSphere& b) {
  return combine_plainly(a, b, kDifference);
}
NefSphere operator^(const NefSphere& a, const NefSphere& b) {
  return combine_plainly(a, b, kSymmetricDifference);
}

}  // namespace plumb
