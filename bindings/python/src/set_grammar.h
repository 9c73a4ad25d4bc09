// The grammar that sets of the plane, of the sphere and of space have in common (nef_set.h), bound
// once for all of them.
//
// Python has `|` and `&` for sets; `+` and `*` are the operators of C++. A method has the keywords
// of an operation, an operator runs without limits and can be interrupted. Cells are named by a
// kind and an index, as the classes of C++ name them.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "binding.h"
#include "plumb/base/marks.h"
#include "plumb/base/nef_set.h"
#include "plumb/model/distance.h"

namespace plumb::python {

/// The cell that contains a point.
struct Cell {
  std::string kind;
  std::uint32_t index = 0;
  bool is_marked = false;
};

/// The first cell that a ray meets.
struct RayHit {
  Cell cell;
  std::vector<Rational> point;
};

/// The distance of two sets: nearest points, and the cells that contain them.
struct SetDistance {
  Rational squared;
  double length = 0;
  std::vector<Rational> point;
  std::vector<Rational> other_point;
  Cell cell;
  Cell other_cell;
};

/// What an audit found.
struct Flaw {
  std::string invariant;
  std::string place;
};

/// What a class of sets has to say of itself; the specialisations are in the file of the class.
///   kNoun          what the class is called in texts, such as "solid"
///   point_of       the point of the class with these exact coordinates
///   kDimension     the number of coordinates
///   cell_of        the name of the cell of a location
///   coordinates    the coordinates of a point
///   repr           the counts as text
template <class Set>
struct SetTraits;

template <class Set>
using PointOf = Exact<SetTraits<Set>::kDimension>;

inline Boundary boundary_of(bool is_closed) {
  return is_closed ? Boundary::Closed : Boundary::Open;
}

/// Returns the rule with this name; throws Error{BadArgument} for other names.
inline WindingRule winding_rule(const std::string& name) {
  if (name == "positive") return WindingRule::Positive;
  if (name == "nonzero") return WindingRule::NonZero;
  if (name == "evenodd") return WindingRule::EvenOdd;
  throw Error(ErrorCode::BadArgument,
              "rule must be 'positive', 'nonzero' or 'evenodd', not '" + name + "'");
}

inline std::optional<WindingRule> winding_rule(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  return winding_rule(*name);
}

/// Writes to a string.
template <class F>
std::string written(F&& write) {
  std::ostringstream out;
  write(out);
  return std::move(out).str();
}

inline nb::bytes bytes_of(const std::string& text) { return nb::bytes(text.data(), text.size()); }

/// Returns the distance of two sets.
template <class Set>
SetDistance distance_of(Context& context, const Set& a, const Set& b) {
  using Traits = SetTraits<Set>;
  const auto found = distance(a, b, context);
  return {found.squared,
          root_of(found.squared),
          Traits::coordinates(found.at_a),
          Traits::coordinates(found.at_b),
          Traits::cell_of(found.cell_a),
          Traits::cell_of(found.cell_b)};
}

template <class Set>
std::optional<RayHit> ray_hit(const std::optional<typename Set::Hit>& hit) {
  if (!hit) return std::nullopt;
  return RayHit{SetTraits<Set>::cell_of(hit->location), SetTraits<Set>::coordinates(hit->point)};
}

template <class Set, MarkFunction kFunction>
Set combined(const Set& a, const Set& b) {
  return run(CallLimits{1, std::nullopt, std::nullopt, nb::none()},
             [&](Context& context) { return boolean_op(a, b, kFunction, context); });
}

template <class Set>
void def_booleans(nb::class_<Set>& c) {
  def_run(
      c, "union",
      +[](Context& k, const Set& a, const Set& b) { return boolean_op(a, b, kUnion, k); },
      "Return the points that belong to this set or to the other set. `a | b` and `a + b` do the "
      "same.",
      "other"_a);
  def_run(
      c, "intersection",
      +[](Context& k, const Set& a, const Set& b) { return boolean_op(a, b, kIntersection, k); },
      "Return the points that belong to both sets. `a & b` and `a * b` do the same.", "other"_a);
  def_run(
      c, "difference",
      +[](Context& k, const Set& a, const Set& b) { return boolean_op(a, b, kDifference, k); },
      "Return the points of this set that do not belong to the other set. `a - b` does the same.",
      "other"_a);
  def_run(
      c, "symmetric_difference",
      +[](Context& k, const Set& a, const Set& b) {
        return boolean_op(a, b, kSymmetricDifference, k);
      },
      "Return the points that belong to exactly one of the sets. `a ^ b` does the same.",
      "other"_a);
  def_run_static(
      c, "union_of",
      +[](Context& k, const std::vector<Set>& sets) {
        return union_of(std::span<const Set>(sets), k);
      },
      "Return the union of any number of sets, computed in a balanced tree.", "sets"_a);
  def_run_static(
      c, "intersection_of",
      +[](Context& k, const std::vector<Set>& sets) {
        return intersection_of(std::span<const Set>(sets), k);
      },
      "Return the intersection of any number of sets. The intersection of no sets is the whole "
      "space.",
      "sets"_a);
  for (const char* name : {"__or__", "__add__"}) {
    c.def(name, &combined<Set, kUnion>, "other"_a, nb::is_operator(), "Return the union.");
  }
  for (const char* name : {"__and__", "__mul__"}) {
    c.def(name, &combined<Set, kIntersection>, "other"_a, nb::is_operator(),
          "Return the intersection.");
  }
  c.def("__sub__", &combined<Set, kDifference>, "other"_a, nb::is_operator(),
        "Return the difference.");
  c.def("__xor__", &combined<Set, kSymmetricDifference>, "other"_a, nb::is_operator(),
        "Return the symmetric difference.");
  c.def(
      "__invert__",
      [](const Set& a) {
        return run(CallLimits{1, std::nullopt, std::nullopt, nb::none()},
                   [&](Context& k) { return a.complement(k); });
      },
      "Return the complement.");
  c.def(
      "__eq__",
      [](const Set& a, const Set& b) {
        return run(CallLimits{1, std::nullopt, std::nullopt, nb::none()},
                   [&](Context&) { return a == b; });
      },
      "other"_a, nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"),
      "Whether both sets have the same points.");
  c.def(
      "__bool__", [](const Set& a) { return !a.is_empty(); }, "Whether the set has points.");
}

template <class Set>
void def_topology(nb::class_<Set>& c) {
  def_run(
      c, "complement", +[](Context& k, const Set& a) { return a.complement(k); },
      "Return the points that do not belong to the set. `~a` does the same.");
  def_run(
      c, "interior", +[](Context& k, const Set& a) { return a.interior(k); },
      "Return the set without the points of its boundary.");
  def_run(
      c, "closure", +[](Context& k, const Set& a) { return a.closure(k); },
      "Return the union of the set and its boundary.");
  def_run(
      c, "boundary", +[](Context& k, const Set& a) { return a.boundary(k); },
      "Return the boundary: the closure without the interior.");
  def_run(
      c, "exterior", +[](Context& k, const Set& a) { return a.exterior(k); },
      "Return the interior of the complement.");
  def_run(
      c, "regularization", +[](Context& k, const Set& a) { return a.regularization(k); },
      "Return the closure of the interior.");
}

template <class Set>
void def_queries(nb::class_<Set>& c) {
  using Traits = SetTraits<Set>;
  using P = PointOf<Set>;
  c.def("is_empty", &Set::is_empty, "Whether the set has no points.");
  c.def("is_whole", &Set::is_whole, "Whether every point belongs to the set.");
  c.def("is_closed", &Set::is_closed, "Whether the set equals its closure.");
  c.def("is_open", &Set::is_open, "Whether the set equals its interior.");
  c.def("memory_bytes", &Set::bytes, "Return the memory of the set in bytes.");
  c.def("__repr__", &Traits::repr);
  def_run(
      c, "is_subset_of",
      +[](Context& k, const Set& a, const Set& b) { return a.is_subset_of(b, k); },
      "Whether every point of this set belongs to the other set.", "other"_a);
  def_run(
      c, "contains",
      +[](Context& k, const Set& a, const P& p) { return a.contains(Traits::point_of(p), k); },
      "Whether a point with exact coordinates belongs to the set.", "point"_a);
  def_run(
      c, "has_on_boundary",
      +[](Context& k, const Set& a, const P& p) {
        return a.has_on_boundary(Traits::point_of(p), k);
      },
      "Whether a point with exact coordinates lies on the boundary of the set.", "point"_a);
  def_run(
      c, "locate",
      +[](Context& k, const Set& a, const P& p) {
        return Traits::cell_of(a.locate(Traits::point_of(p), k));
      },
      "Return the cell that contains a point with exact coordinates.", "point"_a);
  def_run(
      c, "shoot",
      +[](Context& k, const Set& a, const P& origin, const P& direction) {
        return ray_hit<Set>(a.shoot(Traits::point_of(origin), Traits::point_of(direction), k));
      },
      Traits::kShootDoc, "origin"_a, "direction"_a);
  def_run(
      c, "shoot_to_boundary",
      +[](Context& k, const Set& a, const P& origin, const P& direction) {
        return ray_hit<Set>(
            a.shoot_to_boundary(Traits::point_of(origin), Traits::point_of(direction), k));
      },
      "Return the first cell of the boundary that the ray meets, whether or not it is marked. "
      "The result has the same form as the result of shoot().",
      "origin"_a, "direction"_a);
  def_run(
      c, "audit",
      +[](Context& k, const Set& a) -> std::optional<Flaw> {
        const auto flaw = a.audit(k);
        if (!flaw) return std::nullopt;
        return Flaw{flaw->invariant, flaw->place};
      },
      "Check every invariant from scratch. Return the first broken invariant, or None if all "
      "invariants hold.");
}

/// Binds what all sets have.
template <class Set>
void def_set(nb::class_<Set>& c) {
  c.def(nb::init<>(), "Make the empty set.");
  c.def_static(
      "empty", [] { return Set::empty(); }, "Return the set without points.");
  c.def_static(
      "whole", [] { return Set::whole(); }, "Return the set of all points.");
  c.def_static(
      "point",
      [](const PointOf<Set>& p) {
        require(p);
        return Set::point(SetTraits<Set>::point_of(p));
      },
      "point"_a, "Return the set of one point.");
  def_booleans(c);
  def_topology(c);
  def_queries(c);
  // A set is immutable, so that a copy is the set itself.
  c.def(
      "__copy__", [](const Set& a) { return a; }, "Return a copy, which shares its memory.");
  c.def(
      "__deepcopy__", [](const Set& a, nb::handle) { return a; }, "memo"_a,
      "Return a copy, which shares its memory.");
}

/// Binds hashing and pickling of a class whose sets have canonical bytes.
template <class Set>
void def_bytes(nb::class_<Set>& c, std::string (*canonical_bytes)(Context&, const Set&),
               Set (*from_bytes)(Context&, const std::string&)) {
  static std::string (*write)(Context&, const Set&) = canonical_bytes;
  static Set (*read)(Context&, const std::string&) = from_bytes;
  const auto bytes = [](const Set& set) {
    return bytes_of(run(CallLimits{1, std::nullopt, std::nullopt, nb::none()},
                        [&](Context& k) { return write(k, set); }));
  };
  const auto parsed = [](const nb::bytes& data) {
    const std::string text(data.c_str(), data.size());
    return run(CallLimits{1, std::nullopt, std::nullopt, nb::none()},
               [&](Context& k) { return read(k, text); });
  };
  c.def("to_bytes", bytes,
        "Return the exact set as the bytes of a canonical file. Equal sets give equal bytes.");
  c.def_static("from_bytes", parsed, "data"_a,
               "Return the set that to_bytes() or a file of the same format describes.");
  c.def("__hash__", [bytes](const Set& set) { return nb::hash(bytes(set)); });
  c.def("__getstate__", bytes, "Return what pickle stores: the canonical bytes.");
  c.def(
      "__setstate__", [parsed](Set& set, const nb::bytes& data) { new (&set) Set(parsed(data)); },
      "data"_a, "Make the set again from its canonical bytes.");
}

}  // namespace plumb::python
