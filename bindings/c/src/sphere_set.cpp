// Sets of the sphere. Directions are given by exact numbers.
// Tested by tests/c/interface_test.c.
#include "handles.h"
#include "sets.h"

namespace plumb::c {
namespace {

SphereVector vector_at(std::span<const Rational> values) {
  return {values[0], values[1], values[2]};
}

std::vector<SphereVector> vectors(const plumb_numbers* numbers, const char* name) {
  const std::span<const Rational> values = records(numbers, name, 3);
  std::vector<SphereVector> result;
  for (std::size_t i = 0; i < values.size(); i += 3) {
    result.push_back(vector_at(values.subspan(i, 3)));
  }
  return result;
}

plumb_location location_of(const SphereLocation& at) {
  return {static_cast<std::int32_t>(at.cell.kind()), at.cell.index(), at.marked};
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

PLUMB_C_SET(plumb_sphere_set, NefSphere)

plumb_status plumb_sphere_set_half_spheres(const plumb_numbers* normals, bool is_closed,
                                           plumb_sphere_set** out, const plumb_context* context,
                                           plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return NefSphere::convex(vectors(normals, "normals"), boundary(is_closed), call);
  });
}

plumb_status plumb_sphere_set_circle(const plumb_numbers* normal, plumb_sphere_set** out,
                                     plumb_error** error) {
  return make(out, error,
              [&] { return NefSphere::circle(vector_at(exactly(normal, "normal", 3))); });
}

plumb_status plumb_sphere_set_polygon(const plumb_numbers* corners, bool is_closed,
                                      plumb_sphere_set** out, plumb_error** error) {
  return make(out, error,
              [&] { return NefSphere::polygon(vectors(corners, "corners"), boundary(is_closed)); });
}

plumb_status plumb_sphere_set_arc(const plumb_numbers* ends, bool is_closed, plumb_sphere_set** out,
                                  plumb_error** error) {
  return make(out, error, [&] {
    const std::span<const Rational> v = exactly(ends, "ends", 6);
    return NefSphere::arc(vector_at(v.first(3)), vector_at(v.subspan(3)), boundary(is_closed));
  });
}

plumb_status plumb_sphere_set_points(const plumb_numbers* directions, plumb_sphere_set** out,
                                     const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return NefSphere::points(vectors(directions, "directions"), call);
  });
}

plumb_status plumb_sphere_set_describe(const plumb_sphere_set* set, plumb_sphere_set_info* info,
                                       plumb_error** error) {
  return guarded(error, [&] {
    const NefSphere& of = need(set, "set").set;
    const SphereCounts counts = of.counts();
    fill(info,
         {0, counts.points, counts.arcs, counts.faces, counts.marked_faces, of.bytes(),
          of.is_empty(), of.is_whole(), of.is_closed(), of.is_open()},
         "info");
  });
}

plumb_status plumb_sphere_set_locate(const plumb_sphere_set* set, const plumb_numbers* directions,
                                     plumb_location* locations, std::size_t count,
                                     const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    Call call(context);
    exactly(directions, "directions", 3, count);
    if (count > 0) need(locations, "locations");
    const std::vector<SphereVector> at = vectors(directions, "directions");
    const std::vector<SphereLocation> found =
        need(set, "set").set.locate(std::span<const SphereVector>(at), call);
    for (std::size_t i = 0; i < count; ++i) locations[i] = location_of(found[i]);
  });
}

plumb_status plumb_sphere_set_shoot(const plumb_sphere_set* set, const plumb_numbers* walk,
                                    bool to_boundary, bool* is_hit, plumb_location* location,
                                    plumb_numbers** point, const plumb_context* context,
                                    plumb_error** error) {
  return shoot(set, walk, 3, to_boundary, is_hit, location, point, context, error, vector_at,
               location_of, [](const SphereVector& v) {
                 return numbers_of(RationalPoint3{v.x, v.y, v.z});
               });
}
