// How overlays of the sphere grow (growth.h says how it is measured): SphereOverlay::boolean_op
// alone. And location in a large set, locators made before.
#include "generate/sphere_families.h"

#include <memory>
#include <vector>

#include "growth.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/overlay/sphere_overlay.h"
#include "plumb/sphere/sphere_locator.h"

namespace plumb::bench {
namespace {

using testing::crown;

/// The maps of two sets over one table.
struct Operands {
  PlaneTable planes;
  SphereMap a;
  SphereMap b;

  Operands(const NefSphere& first, const NefSphere& second)
      : planes(first.planes()), a(first.map()), b(second.map()) {
    const std::vector<PlaneId> to = planes.merge(second.planes());
    for (PlaneId& c : b.circle) c = to[c.value()];
    for (SphereDirection& u : b.direction) u = {to[u.p.value()], to[u.q.value()]};
  }
};

Work overlay_of(const NefSphere& first, const NefSphere& second) {
  const auto o = std::make_shared<const Operands>(first, second);
  const auto overlay = std::make_shared<SphereOverlay>(o->planes);
  SphereMap out;
  SphereOrigins origins;
  overlay->boolean_op(o->a, o->b, MarkTable(kUnion), out, origins);
  const std::size_t size = o->a.arc_count() + o->b.arc_count() + out.point_count();
  return measured(static_cast<double>(size), [o, overlay] {
    SphereMap result;
    SphereOrigins from;
    overlay->boolean_op(o->a, o->b, MarkTable(kUnion), result, from);
    return result;
  });
}

Work crossing_crowns(std::size_t n) {
  return overlay_of(crown(n, 0, 0.5, 1.5), crown(n, 0.37, 0.6, 1.4));
}
Work nested_crowns(std::size_t n) {
  return overlay_of(crown(n, 0, 0.5, 0.6), crown(n, 0.37, 1.5, 1.6));
}
Work equal_crowns(std::size_t n) {
  const NefSphere set = crown(n, 0, 0.5, 1.5);
  return overlay_of(set, set);
}

/// 1000 locations; `ask` gets the next direction, too.
template <class Ask>
Work asked_in_triangles(std::size_t n, Ask ask) {
  const auto locator = std::make_shared<SphereLocator>(testing::scattered_triangles(n));
  const std::vector<SphereVector> directions = testing::any_directions(1001, n);
  const auto size = static_cast<double>(locator->set().map().arc_count());
  return measured(size, [=] {
    std::size_t found = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
      if (ask(*locator, directions[i], directions[i + 1])) ++found;
    }
    return found;
  });
}
Work locate_in_triangles(std::size_t n) {
  return asked_in_triangles(n, [](SphereLocator& in, const SphereVector& u, const SphereVector&) {
    return in.locate(u).marked;
  });
}
Work shoot_in_triangles(std::size_t n) {
  return asked_in_triangles(n, [](SphereLocator& in, const SphereVector& u, const SphereVector& v) {
    return in.shoot(u, v).has_value();
  });
}

const std::vector<std::size_t> kSizes{100,  316,   1000,
                                      3162, 10000, 31622};  // even: corners alternate
const std::vector<Family> kFamilies{
    {"crossing-crowns",
     "overlay of two maps of the sphere, O((n + k) log n)",
     "n + k",
     {1, 1},
     kSizes,
     crossing_crowns,
     1.25},
    {"nested-crowns", "the same, nothing crosses", "n + k", {1, 1}, kSizes, nested_crowns, 1.25},
    {"equal-crowns", "the same, one map twice", "n + k", {1, 1}, kSizes, equal_crowns, 1.25},
    {"locate-scattered",
     "SphereLocator::locate, O(log n), 1000 times",
     "arcs",
     {0, 1},
     kSizes,
     locate_in_triangles,
     0.3},
    {"shoot-scattered",
     "SphereLocator::shoot, the same",
     "arcs",
     {0, 1},
     kSizes,
     shoot_in_triangles,
     0.3},
};

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::growth_main("Growth of overlays of the sphere", plumb::bench::kFamilies,
                                   argc, argv);
}
