#include "oracle/sphere_leaf.h"

#include <algorithm>
#include <sstream>

namespace plumb::testing {
namespace {

const CellVector kZero{0, 0, 0};

int side(const CellVector& n, const CellVector& u) { return dot(n, u).sign(); }

CellVector minus(const CellVector& v) { return {-v[0], -v[1], -v[2]}; }

bool is_same(const CellVector& u, const CellVector& v) {
  return cross(u, v) == kZero && dot(u, v) > 0;
}

/// On the shorter arc, without its ends.
bool is_between(const CellVector& from, const CellVector& to, const CellVector& u) {
  const CellVector n = cross(from, to);
  return side(n, u) == 0 && side(cross(n, from), u) > 0 && side(cross(to, n), u) > 0;
}

/// Is everything on the right side of all; strictly, unless closed?
bool is_in_all(const std::vector<CellVector>& normals, const CellVector& u, bool closed) {
  return std::all_of(normals.begin(), normals.end(), [&](const CellVector& n) {
    return side(n, u) > 0 || (closed && side(n, u) == 0);
  });
}

}  // namespace

std::vector<CellVector> SphereLeaf::cells() const {
  std::vector<CellVector> result;
  for (const SphereVector& vector : v) result.push_back(cell_vector(vector));
  return result;
}

bool SphereLeaf::is_valid() const {
  const std::vector<CellVector> c = cells();
  switch (kind) {
    case Arc:
    case LongArc:
    case RoundArc:
    case Lune:
      return cross(c[0], c[1]) != kZero;
    case Triangle:
      return dot(c[0], cross(c[1], c[2])) != 0;
    default:
      return true;
  }
}

std::vector<CellVector> SphereLeaf::normals() const {
  const std::vector<CellVector> c = cells();
  std::vector<CellVector> result;
  const auto add = [&](const CellVector& n) {
    if (n != kZero) result.push_back(n);
  };
  // Two circles that cross at u, as the components say: u x e1, u x e2 with u . e3 != 0.
  const auto add_through = [&](const CellVector& u) {
    std::size_t axis = 0;
    while (u[axis] == 0) ++axis;
    for (const std::size_t other : {(axis + 1) % 3, (axis + 2) % 3}) {
      CellVector e{};
      e[other] = 1;
      add(cross(u, e));
    }
  };
  switch (kind) {
    case HalfSphere:
    case Circle:
      add(c[0]);
      break;
    case Arc:
    case LongArc:
    case RoundArc:
      add(cross(c[0], c[1]));
      add_through(c[0]);
      add_through(c[1]);
      break;
    case Points:
      for (const CellVector& u : c) add_through(u);
      break;
    case Triangle:
      for (std::size_t i = 0; i < 3; ++i) add(cross(c[i], c[(i + 1) % 3]));
      break;
    default:
      for (const CellVector& n : c) add(n);
  }
  return result;
}

bool SphereLeaf::contains(const CellVector& u) const {
  const std::vector<CellVector> c = cells();
  const bool closed = boundary == Boundary::Closed;
  switch (kind) {
    case HalfSphere:
      return side(c[0], u) > 0 || (closed && side(c[0], u) == 0);
    case Circle:
      return side(c[0], u) == 0;
    case Arc:
      return is_between(c[0], c[1], u) || (closed && (is_same(c[0], u) || is_same(c[1], u)));
    case LongArc:
      if (is_same(c[0], u) || is_same(c[1], u)) return closed;
      return side(cross(c[0], c[1]), u) == 0 && !is_between(c[0], c[1], u);
    case RoundArc:
      return side(cross(c[0], c[1]), u) == 0 && (closed || !is_same(c[0], u));
    case Points:
      return std::any_of(c.begin(), c.end(), [&](const CellVector& p) { return is_same(p, u); });
    case Triangle: {
      std::vector<CellVector> n{cross(c[0], c[1]), cross(c[1], c[2]), cross(c[2], c[0])};
      if (side(n[0], c[2]) > 0) return is_in_all(n, u, closed);
      for (CellVector& m : n) m = minus(m);
      return !is_in_all(n, u, !closed);
    }
    case Lune:  // left turns at its ends or right ones, as the sides are listed
      return is_in_all({c[0], c[1]}, u, closed);
    default:
      return is_in_all(c, u, closed);
  }
}

/// The lune's first end: there one turns left, from the second half-circle to the first.
NefSphere SphereLeaf::to_nef() const {
  switch (kind) {
    case HalfSphere:
      return NefSphere::half_sphere(v[0], boundary);
    case Circle:
      return NefSphere::circle(v[0]);
    case Arc:
      return NefSphere::arc(v[0], v[1], boundary);
    case LongArc:
      return NefSphere::arc(v[1], v[0], cross(v[0], v[1]), boundary);
    case RoundArc:
      return NefSphere::arc(v[0], v[0], cross(v[0], v[1]), boundary);
    case Points:
      return NefSphere::points(v);
    case Triangle:
      return NefSphere::polygon(v, boundary);
    case Lune: {
      const SphereVector end = cross(v[1], v[0]);
      const std::vector<SphereSide> sides{{end, v[0]}, {end.opposite(), v[1]}};
      return NefSphere::region(sides, boundary);
    }
    default:
      return NefSphere::convex(v, boundary);
  }
}

std::string SphereLeaf::to_text() const {
  static constexpr const char* kNames[] = {"half",   "circle",   "arc",  "long_arc", "round_arc",
                                           "points", "triangle", "lune", "convex"};
  std::ostringstream text;
  text << (boundary == Boundary::Closed ? "closed " : "open ") << kNames[kind];
  for (const SphereVector& u : v) text << " (" << u.x << ' ' << u.y << ' ' << u.z << ')';
  return text.str();
}

}  // namespace plumb::testing
