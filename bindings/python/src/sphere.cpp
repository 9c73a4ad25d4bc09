// plumb.SphereSet: sets of directions (NefSphere). There is no file format for them, hence no
// pickling; a hash is that of the counts, which equal sets share.
// Tests: tests/test_sphere.py.
#include "plumb/sphere/nef_sphere.h"
#include "set_grammar.h"

namespace plumb::python {

template <>
struct SetTraits<NefSphere> {
  static constexpr std::size_t kDimension = 3;
  static constexpr const char* kShootDoc =
      "Return the first marked cell on a walk along a great circle, or None if the walk meets no "
      "marked cell. The walk starts at `origin`, takes the shorter way to `direction`, and "
      "continues until it returns to `origin`.";

  static SphereVector point_of(const Exact<3>& p) { return {p.value[0], p.value[1], p.value[2]}; }
  static std::vector<Rational> coordinates(const SphereVector& p) { return {p.x, p.y, p.z}; }
  static Cell cell_of(const SphereLocation& location) {
    static constexpr std::array kNames{"point", "arc", "face"};
    const auto kind = static_cast<std::size_t>(location.cell.kind());
    return {kNames[kind], location.cell.index(), location.marked};
  }
  static std::string repr(const NefSphere& set) {
    const SphereCounts n = set.counts();
    return "<plumb.SphereSet: " + std::to_string(n.points) + " points, " + std::to_string(n.arcs) +
           " arcs, " + std::to_string(n.faces) + " faces (" + std::to_string(n.marked_faces) +
           " marked)>";
  }
};

namespace {

std::vector<SphereVector> directions_of(const std::vector<Exact<3>>& points) {
  std::vector<SphereVector> result;
  result.reserve(points.size());
  for (const Exact<3>& p : points) result.push_back(SetTraits<NefSphere>::point_of(p));
  return result;
}

CountsOut sphere_counts(const NefSphere& set) {
  const SphereCounts n = set.counts();
  CountsOut result;
  result["points"] = n.points;
  result["arcs"] = n.arcs;
  result["faces"] = n.faces;
  result["marked_faces"] = n.marked_faces;
  return result;
}

std::size_t hash_of_counts(const NefSphere& set) {
  const SphereCounts n = set.counts();
  return ((n.points * 1000003 + n.arcs) * 1000003 + n.faces) * 1000003 + n.marked_faces;
}

}  // namespace

void bind_sphere(nb::module_& m) {
  nb::class_<NefSphere> c(m, "SphereSet",
                          "A set of directions that can be made from half-spheres by unions, "
                          "intersections and complements. A direction is given by a vector of any "
                          "length. The set is immutable and exact.");
  def_set(c);
  c.def("__hash__", &hash_of_counts);
  c.def("counts", &sphere_counts, "Return the numbers of points, arcs and faces.");
  def_run_static(
      c, "half_sphere",
      +[](Context&, const Exact<3>& normal, bool closed) {
        return NefSphere::half_sphere(SetTraits<NefSphere>::point_of(normal), boundary_of(closed));
      },
      "Return the directions u with dot(normal, u) >= 0, or > 0 if not `closed`.", "normal"_a,
      "closed"_a = true);
  def_run_static(
      c, "circle",
      +[](Context&, const Exact<3>& normal) {
        return NefSphere::circle(SetTraits<NefSphere>::point_of(normal));
      },
      "Return the great circle of the directions u with dot(normal, u) = 0.", "normal"_a);
  def_run_static(
      c, "convex",
      +[](Context& k, const std::vector<Exact<3>>& normals, bool closed) {
        return NefSphere::convex(directions_of(normals), boundary_of(closed), k);
      },
      "Return the intersection of the half-spheres with these normals.", "normals"_a,
      "closed"_a = true);
  def_run_static(
      c, "polygon",
      +[](Context&, const std::vector<Exact<3>>& corners, bool closed) {
        return NefSphere::polygon(directions_of(corners), boundary_of(closed));
      },
      "Return the region to the left of the shortest arcs between consecutive corners.",
      "corners"_a, "closed"_a = true);
  def_run_static(
      c, "arc",
      +[](Context&, const Exact<3>& from, const Exact<3>& to, bool closed) {
        return NefSphere::arc(SetTraits<NefSphere>::point_of(from),
                              SetTraits<NefSphere>::point_of(to), boundary_of(closed));
      },
      "Return the shortest arc between two directions. The ends of the arc belong to the set if "
      "`closed` is true.",
      "start"_a, "end"_a, "closed"_a = true);
  def_run_static(
      c, "points",
      +[](Context& k, const std::vector<Exact<3>>& directions) {
        return NefSphere::points(directions_of(directions), k);
      },
      "Return the set of these directions.", "directions"_a);
}

}  // namespace plumb::python
