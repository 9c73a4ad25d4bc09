#include "oracle/ray_twin.h"

#include <algorithm>
#include <vector>

namespace plumb::testing {
namespace {

Rational cross(const RationalPoint2& u, const RationalPoint2& v) { return u.x * v.y - u.y * v.x; }
Rational dot(const RationalPoint2& u, const RationalPoint2& v) { return u.x * v.x + u.y * v.y; }

// The ray origin + t direction, t >= 0.
class Ray {
 public:
  Ray(const RationalPoint2& origin, const RationalPoint2& direction)
      : origin_(origin), direction_(direction) {}

  RationalPoint2 at(const Rational& t) const {
    return {origin_.x + t * direction_.x, origin_.y + t * direction_.y};
  }

  /// All t >= 0 at which the ray comes to, or leaves, an element of the boundary; ascending.
  std::vector<Rational> contacts(const PlaneComplex& complex) const {
    std::vector<Rational> found;
    for (std::size_t i = 0; i < complex.vertex_count(); ++i) {
      add_point(exact(complex.points, complex.vertex_point[i]), found);
    }
    for (std::size_t i = 0; i < complex.edge_count(); ++i) add_edge(complex, EdgeId(i), found);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  void add_point(const RationalPoint2& p, std::vector<Rational>& found) const {
    const RationalPoint2 v = p - origin_;
    if (cross(direction_, v) != 0) return;
    const Rational t = dot(direction_, v) / dot(direction_, direction_);
    if (t >= 0) found.push_back(t);
  }

  /// Crossings of the inside of an edge; ends are vertices. An edge along the ray begins and ends
  /// at vertices or goes on for ever.
  void add_edge(const PlaneComplex& complex, EdgeId e, std::vector<Rational>& found) const {
    const PlaneLine& line = complex.line[e.value()];
    const RationalPoint2 a = complex.points.inputs.exact(line.a);
    const RationalPoint2 along = complex.points.inputs.exact(line.b) - a;
    const Rational turn = cross(direction_, along);
    if (turn == 0) return;
    const Rational t = cross(a - origin_, along) / turn;
    if (t < 0) return;
    const RationalPoint2 p = at(t);
    const VertexId left = complex.dcel.origin(first_half(e));
    const VertexId right = complex.dcel.target(first_half(e));
    const auto is_before = [&](const RationalPoint2& from, const RationalPoint2& to) {
      return dot(along, to - from) > 0;
    };
    const auto point = [&](VertexId v) {
      return exact(complex.points, complex.vertex_point[v.value()]);
    };
    const bool after_left = complex.is_at_infinity(left) || is_before(point(left), p);
    const bool before_right = complex.is_at_infinity(right) || is_before(p, point(right));
    if (after_left && before_right) found.push_back(t);
  }

  RationalPoint2 origin_;
  RationalPoint2 direction_;
};

}  // namespace

std::optional<PlaneHit> shoot_slowly(const Nef2& set, const RationalPoint2& origin,
                                     const RationalPoint2& direction) {
  const Ray ray(origin, direction);
  const PlaneLocation start = set.locate(origin);
  if (start.marked) return PlaneHit{start, origin};
  std::vector<Rational> contacts = ray.contacts(set.complex());
  if (contacts.empty() || contacts.front() != 0) contacts.insert(contacts.begin(), Rational(0));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const RationalPoint2 here = ray.at(contacts[i]);
    const PlaneLocation on = set.locate(here);
    if (on.marked) return PlaneHit{on, here};
    const Rational later =
        i + 1 < contacts.size() ? Rational((contacts[i] + contacts[i + 1]) / 2) : contacts[i] + 1;
    const PlaneLocation after = set.locate(ray.at(later));
    if (after.marked) return PlaneHit{after, here};
  }
  return std::nullopt;
}

std::optional<PlaneHit> shoot_to_boundary_slowly(const Nef2& set, const RationalPoint2& origin,
                                                 const RationalPoint2& direction) {
  const Ray ray(origin, direction);
  const PlaneLocation start = set.locate(origin);
  if (!start.face.is_valid()) return PlaneHit{start, origin};
  const std::vector<Rational> contacts = ray.contacts(set.complex());
  if (contacts.empty()) return std::nullopt;
  const RationalPoint2 here = ray.at(contacts.front());
  return PlaneHit{set.locate(here), here};
}

}  // namespace plumb::testing
