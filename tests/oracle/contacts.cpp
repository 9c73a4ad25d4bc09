#include "oracle/contacts.h"

#include <optional>

namespace plumb::testing {

namespace {

using Found = std::optional<ExactPoint3>;

struct Segment {
  ExactPoint3 from, to;
  ExactPoint3 along() const { return to - from; }
  ExactPoint3 at(const BigRational& t) const { return from + t * along(); }
};

const ExactPoint3 kZero{0, 0, 0};

bool is_between(const BigRational& t) { return t > 0 && t < 1; }

struct Polygon {
  std::vector<Segment> sides;
  std::vector<ExactPoint3> inner;
  ExactPoint3 normal;

  const ExactPoint3& origin() const { return sides[0].from; }
};

bool is_inside(const ExactPoint3& p, const Segment& s) {
  if (cross(s.along(), p - s.from) != kZero) return false;
  return is_between(dot(p - s.from, s.along()) / dot(s.along(), s.along()));
}

/// The two coordinates left when one is dropped in which the normal is not zero.
ExactPoint flat(const ExactPoint3& p, const ExactPoint3& normal) {
  if (normal.x != 0) return {p.y, p.z};
  if (normal.y != 0) return {p.x, p.z};
  return {p.x, p.y};
}

/// Requires a point of the plane.
bool is_inside(const ExactPoint3& p, const Polygon& polygon) {
  for (const ExactPoint3& q : polygon.inner) {
    if (p == q) return false;
  }
  bool inside = false;
  const ExactPoint x = flat(p, polygon.normal);
  for (const Segment& s : polygon.sides) {
    if (p == s.from || p == s.to || is_inside(p, s)) return false;
    const ExactPoint a = flat(s.from, polygon.normal), b = flat(s.to, polygon.normal);
    if ((a.y > x.y) == (b.y > x.y)) continue;
    if (a.x + (x.y - a.y) * (b.x - a.x) / (b.y - a.y) > x.x) inside = !inside;
  }
  return inside;
}

Found meeting(const ExactPoint3& p, const ExactPoint3& q) { return p == q ? Found(p) : Found(); }
Found meeting(const ExactPoint3& p, const Segment& s) {
  return is_inside(p, s) ? Found(p) : Found();
}
Found meeting(const Segment& s, const ExactPoint3& p) { return meeting(p, s); }

Found meeting(const ExactPoint3& p, const Polygon& f) {
  if (dot(f.normal, p - f.origin()) != 0) return {};
  return is_inside(p, f) ? Found(p) : Found();
}
Found meeting(const Polygon& f, const ExactPoint3& p) { return meeting(p, f); }

Found meeting(const Segment& s, const Segment& t) {
  const ExactPoint3 n = cross(s.along(), t.along()), between = t.from - s.from;
  if (n == kZero || dot(n, between) != 0) return {};
  const BigRational at_s = dot(cross(between, t.along()), n) / dot(n, n);
  const BigRational at_t = dot(cross(between, s.along()), n) / dot(n, n);
  return is_between(at_s) && is_between(at_t) ? Found(s.at(at_s)) : Found();
}

Found meeting(const Segment& s, const Polygon& f) {
  const BigRational speed = dot(f.normal, s.along());
  if (speed == 0) return {};
  const BigRational t = dot(f.normal, f.origin() - s.from) / speed;
  if (!is_between(t)) return {};
  return is_inside(s.at(t), f) ? Found(s.at(t)) : Found();
}
Found meeting(const Polygon& f, const Segment& s) { return meeting(s, f); }
Found meeting(const Polygon&, const Polygon&) { return {}; }

/// The items of a complex with their coordinates.
struct Shape {
  const std::vector<ExactPoint3>& points;
  std::vector<Segment> edges;
  std::vector<Polygon> facets;

  Shape(const ComplexDraft& draft, const SpaceComplex& built) : points(draft.points) {
    for (std::size_t e = 0; e < built.edge_count(); ++e) {
      edges.push_back(
          {points[built.origin[2 * e].value()], points[built.origin[2 * e + 1].value()]});
    }
    for (const ComplexDraft::Facet& f : draft.facets) add(f);
  }

 private:
  void add(const ComplexDraft::Facet& facet) {
    Polygon polygon;
    for (const ComplexDraft::Cycle& c : facet.cycles) {
      for (std::size_t i = 0; i < c.size(); ++i) {
        polygon.sides.push_back({points[c[i]], points[c[(i + 1) % c.size()]]});
      }
    }
    for (const std::uint32_t v : facet.inner) polygon.inner.push_back(points[v]);
    polygon.normal = cross(polygon.sides[0].along(), polygon.sides[1].along());
    facets.push_back(std::move(polygon));
  }
};

class Search {
 public:
  Search(const Shape& a, const Shape& b) : a_(a), b_(b) {}

  std::vector<ExpectedContact> run() {
    from<VertexId>(a_.points);
    from<EdgeId>(a_.edges);
    from<FacetId>(a_.facets);
    return std::move(found_);
  }

 private:
  template <class Id, class Item>
  void from(const std::vector<Item>& items) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      against<VertexId>(Id(i), items[i], b_.points);
      against<EdgeId>(Id(i), items[i], b_.edges);
      against<FacetId>(Id(i), items[i], b_.facets);
    }
  }

  template <class Id, class Item, class Other>
  void against(SpaceItem a, const Item& item, const std::vector<Other>& others) {
    for (std::size_t j = 0; j < others.size(); ++j) {
      if (const Found p = meeting(item, others[j])) found_.push_back({a, Id(j), *p});
    }
  }

  const Shape& a_;
  const Shape& b_;
  std::vector<ExpectedContact> found_;
};

}  // namespace

std::vector<ExpectedContact> contacts_by_force(const ComplexDraft& a, const SpaceComplex& built_a,
                                               const ComplexDraft& b, const SpaceComplex& built_b) {
  const Shape shape_a(a, built_a), shape_b(b, built_b);
  return Search(shape_a, shape_b).run();
}

}  // namespace plumb::testing
