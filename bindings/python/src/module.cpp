// The module plumb._core. plumb/__init__.py has its names.
#include "plumb/base/keep_freed_memory.h"
#include "plumb/base/version.h"
#include "set_grammar.h"

namespace plumb::python {
namespace {

void bind_results(nb::module_& m) {
  nb::class_<Cell> cell(m, "Cell", "The cell of a set that contains a point.");
  cell.def_ro("kind", &Cell::kind,
              "'vertex', 'edge', 'facet' or 'volume' of a Solid; 'vertex', 'edge' or 'face' of a "
              "PlaneSet; 'point', 'arc' or 'face' of a SphereSet.");
  cell.def_ro("index", &Cell::index, "The index among the cells of this kind.");
  cell.def_ro("is_marked", &Cell::is_marked, "Whether the cell belongs to the set.");
  cell.def("__repr__", [](const Cell& c) {
    return "<plumb.Cell: " + c.kind + " " + std::to_string(c.index) +
           (c.is_marked ? ", marked>" : ", not marked>");
  });
  nb::class_<RayHit> hit(m, "RayHit", "The first cell that a ray meets.");
  hit.def_ro("cell", &RayHit::cell, "The cell.");
  hit.def_prop_ro(
      "point",
      [](const RayHit& h) {
        return nb::typed<nb::tuple, Rational, nb::ellipsis>(nb::tuple(nb::cast(h.point)));
      },
      "The first point of the cell on the ray, as fractions.");
  nb::class_<SetDistance> apart(m, "Distance", "The distance between the closures of two sets.");
  apart.def_ro("squared", &SetDistance::squared, "The square of the distance, a fraction.");
  apart.def_ro("length", &SetDistance::length, "The distance, rounded to a float.");
  apart.def_prop_ro(
      "points",
      [](const SetDistance& d) {
        using Point = nb::typed<nb::tuple, Rational, nb::ellipsis>;
        return std::pair(Point(nb::tuple(nb::cast(d.point))),
                         Point(nb::tuple(nb::cast(d.other_point))));
      },
      "A nearest point of this set and a nearest point of the other set, as fractions.");
  apart.def_prop_ro(
      "cells", [](const SetDistance& d) { return std::pair(d.cell, d.other_cell); },
      "The cells of this set and of the other set that contain the nearest points.");
  apart.def("__repr__", [](const SetDistance& d) {
    return "<plumb.Distance: " + std::to_string(d.length) + ">";
  });
  nb::class_<Flaw> flaw(m, "Flaw", "A broken invariant, which an audit found.");
  flaw.def_ro("invariant", &Flaw::invariant, "The condition that does not hold.");
  flaw.def_ro("place", &Flaw::place, "The cells that violate it.");
}

}  // namespace

NB_MODULE(_core, m) {
  // Objects that other modules still hold when Python ends are no leak of this one.
  nb::set_leak_warnings(false);
  m.doc() = "The compiled part of plumb.";
  m.attr("VERSION") = PLUMB_VERSION_STRING;
  m.def(
      "keep_freed_memory", &keep_freed_memory,
      "Make malloc keep freed memory for reuse, in the whole process. Then repeated operations on "
      "large sets take about 0.9 times as long.");
  bind_errors(m);
  bind_results(m);
  bind_plane(m);
  bind_solid(m);
  bind_sphere(m);
  bind_map(m);
  bind_surface(m);
  bind_models(m);
  bind_layer(m);
  bind_meshes(m);
}

}  // namespace plumb::python
