// Point location: a segment tree over the slabs between the abscissae of vertices.
//
// An edge that spans all slabs of a node has a place in the vertical order of the node's list,
// which is found by signs without the edges being cut. A query asks one binary search of sides for
// each node on the way from the root to its slab. Reference: M. de Berg, O. Cheong, M. van Kreveld,
// M. Overmars, Computational Geometry, 3rd edition (2008), section 10.3, for segment trees.
//
// Tested by tests/plane/nef2_test.cpp and tests/plane/ray_walk_test.cpp.

#include "plumb/plane/query/plane_locator.h"

#include <algorithm>

#include "plumb/plane/sweep/sweep.h"

namespace plumb {

PlaneLocator::PlaneLocator(const PlaneComplex& complex)
    : complex_(complex), points_(complex.points) {
  make_columns();
  fill_lists();
}

bool PlaneLocator::is_vertical(EdgeId e) const {
  const PlaneLine& l = complex_.line[e];
  return compare_x(points_, l.a, l.b) == Sign::Zero;
}

// Makes the columns. Vertices are in the order of x. Vertical edges without vertices are merged
// into this order.
void PlaneLocator::make_columns() {
  const auto vertices = static_cast<std::uint32_t>(complex_.vertex_count());
  std::vector<EdgeId> lines;
  column_of_line_.assign(complex_.edge_count(), 0);
  for (std::size_t i = 0; i < complex_.edge_count(); ++i) {
    const EdgeId e(i);
    const HalfedgeId h = first_half(e);
    if (complex_.is_at_infinity(complex_.dcel.origin(h)) &&
        complex_.is_at_infinity(complex_.dcel.target(h)) && is_vertical(e)) {
      lines.push_back(e);  // Edges have the numbers of the sweep, so they are in the order of x.
    }
  }
  std::uint32_t v = 0;
  std::size_t l = 0;
  while (v < vertices || l < lines.size()) {
    const std::uint32_t line_point =
        l < lines.size() ? complex_.line[lines[l]].a : SweepCurve::kUnbounded;
    const bool takes_line =
        l < lines.size() &&
        (v == vertices ||
         compare_x(points_, line_point, complex_.vertex_point[v]) != Sign::Positive);
    // A vertical edge without vertices contains no vertex, so it is alone in its column.
    if (takes_line) {
      column_of_line_[lines[l].value()] = static_cast<std::uint32_t>(columns_.size());
      columns_.push_back({line_point, v, lines[l++]});
      continue;
    }
    const std::uint32_t point = complex_.vertex_point[v];
    columns_.push_back({point, v, EdgeId()});
    while (v < vertices && compare_x(points_, complex_.vertex_point[v], point) == Sign::Zero) {
      column_of_vertex_.push_back(static_cast<std::uint32_t>(columns_.size() - 1));
      ++v;
    }
  }
}

// Adds each edge to the lists of O(log n) nodes, and sorts the lists.
void PlaneLocator::fill_lists() {
  const std::size_t slabs = columns_.size() + 1;
  lists_.resize(4 * slabs);
  for (std::size_t i = 0; i < complex_.edge_count(); ++i) {
    const EdgeId e(i);
    const VertexId left = complex_.dcel.origin(first_half(e));
    const VertexId right = complex_.dcel.target(first_half(e));
    if (is_vertical(e)) {
      if (!complex_.is_at_infinity(left)) continue;
      const std::size_t column =
          complex_.is_at_infinity(right) ? column_of_line_[i] : column_of(right);
      downs_.push_back({column, complex_.dcel.face(twin(first_half(e)))});
      continue;
    }
    const std::size_t from = complex_.is_at_infinity(left) ? 0 : column_of(left) + 1;
    const std::size_t to = complex_.is_at_infinity(right) ? slabs : column_of(right) + 1;
    spread(e, 1, 0, slabs, from, to);
  }
  std::sort(downs_.begin(), downs_.end(),
            [](const Down& d, const Down& e) { return d.column < e.column; });
  for (std::vector<EdgeId>& list : lists_) {
    std::sort(list.begin(), list.end(), [this](EdgeId e, EdgeId f) { return is_below(e, f); });
  }
}

/// Adds an edge that spans the slabs [from, to) to the lists below a node of the slabs [begin,
/// end).
void PlaneLocator::spread(EdgeId e, std::size_t node, std::size_t begin, std::size_t end,
                          std::size_t from, std::size_t to) {
  if (to <= begin || end <= from) return;
  if (from <= begin && end <= to) {
    lists_[node].push_back(e);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  spread(e, 2 * node, begin, middle, from, to);
  spread(e, 2 * node + 1, middle, end, from, to);
}

// Whether e lies below f. Requires that both span a common slab. Of the two left ends, the later
// one lies above, below or on the other edge. If it lies on the edge, the directions decide.
bool PlaneLocator::is_below(EdgeId e, EdgeId f) const {
  if (e == f) return false;
  const PlaneLine& k = complex_.line[e];
  const PlaneLine& l = complex_.line[f];
  const VertexId left_e = complex_.dcel.origin(first_half(e));
  const VertexId left_f = complex_.dcel.origin(first_half(f));
  const bool e_from_infinity = complex_.is_at_infinity(left_e);
  const bool f_from_infinity = complex_.is_at_infinity(left_f);
  Sign f_above = Sign::Zero;
  if (e_from_infinity && f_from_infinity) {
    f_above = -cross_sign(points_.inputs(), k.a, k.b, l.a, l.b);
    if (f_above == Sign::Zero) f_above = orient2d(points_, k.a, k.b, l.a);
    return f_above == Sign::Positive;
  }
  const bool e_starts_later = f_from_infinity || (!e_from_infinity && left_f < left_e);
  if (e_starts_later) {
    f_above = -orient2d(points_, l.a, l.b, complex_.vertex_point[left_e]);
  } else {
    f_above = orient2d(points_, k.a, k.b, complex_.vertex_point[left_f]);
  }
  if (f_above == Sign::Zero) f_above = cross_sign(points_.inputs(), k.a, k.b, l.a, l.b);
  return f_above == Sign::Positive;
}

// ---------------------------------------------------------------- queries

Sign PlaneLocator::side(EdgeId e, const QueryPoint2& q) const {
  const PlaneLine& l = complex_.line[e];
  return orient2d(points_, l.a, l.b, q);
}

PlaneLocation PlaneLocator::at(VertexId v) const {
  return {v, EdgeId(), FaceId(), complex_.mark(v)};
}
PlaneLocation PlaneLocator::at(EdgeId e) const {
  return {VertexId(), e, FaceId(), complex_.mark(e)};
}
PlaneLocation PlaneLocator::at(FaceId f) const {
  return {VertexId(), EdgeId(), f, complex_.mark(f)};
}

PlaneLocator::ColumnPlace PlaneLocator::find_column(const QueryPoint2& q) const {
  const auto c = std::partition_point(columns_.begin(), columns_.end(), [&](const Column& column) {
    return compare_x(points_, column.point, q) == Sign::Negative;
  });
  const bool is_on = c != columns_.end() && compare_x(points_, c->point, q) == Sign::Zero;
  return {static_cast<std::size_t>(c - columns_.begin()), is_on};
}

bool PlaneLocator::locate_on_column(const Column& column, std::size_t vertex_end,
                                    const QueryPoint2& q, PlaneLocation& found) const {
  if (column.line.is_valid()) {
    found = at(column.line);
    return true;
  }
  const auto begin = complex_.vertex_point.begin() + column.vertex_begin;
  const auto end = complex_.vertex_point.begin() + static_cast<std::ptrdiff_t>(vertex_end);
  const auto p = std::partition_point(begin, end, [&](std::uint32_t point) {
    return compare_xy(points_, point, q) == Sign::Negative;
  });
  const VertexId above(static_cast<std::size_t>(p - complex_.vertex_point.begin()));
  if (p != end && compare_xy(points_, *p, q) == Sign::Zero) {
    found = at(above);
    return true;
  }
  // A vertical edge through q leads upward from the vertex below, or downward from the vertex
  // above.
  const VertexId neighbour = p != begin ? VertexId(above.value() - 1U) : above;
  if (complex_.dcel.is_isolated(neighbour)) return false;
  for (const HalfedgeId h : complex_.dcel.around(neighbour)) {
    const bool goes_up = (h.value() & 1U) == 0;
    if (goes_up == (p != begin) && is_vertical(edge_of(h))) {
      found = at(edge_of(h));
      return true;
    }
  }
  return false;
}

/// Returns the highest of the edges of a slab for which is_below_point() holds, or an invalid id if
/// there is none. Requires that it holds exactly for the lower edges.
template <class Below>
EdgeId PlaneLocator::highest_below(std::size_t slab, const Below& is_below_point) const {
  EdgeId best;
  std::size_t node = 1;
  std::size_t begin = 0;
  std::size_t end = columns_.size() + 1;
  for (;;) {
    const std::vector<EdgeId>& list = lists_[node];
    const auto above = std::partition_point(list.begin(), list.end(), is_below_point);
    if (above != list.begin()) {
      const EdgeId e = *(above - 1);
      if (!best.is_valid() || is_below(best, e)) best = e;
    }
    if (end - begin == 1) return best;
    const std::size_t middle = begin + (end - begin) / 2;
    const bool goes_left = slab < middle;
    node = 2 * node + (goes_left ? 0 : 1);
    (goes_left ? end : begin) = middle;
  }
}

EdgeId PlaneLocator::edge_below(const QueryPoint2& q) const {
  const ColumnPlace place = find_column(q);
  return highest_below(place.column + (place.is_on ? 1 : 0),
                       [&](EdgeId e) { return side(e, q) != Sign::Negative; });
}

EdgeId PlaneLocator::edge_below(VertexId v) const {
  const std::uint32_t p = complex_.vertex_point[v];
  return highest_below(column_of(v) + 1, [&](EdgeId e) {
    const PlaneLine& l = complex_.line[e];
    return orient2d(points_, l.a, l.b, p) == Sign::Positive;
  });
}

FaceId PlaneLocator::bottom_face(std::size_t slab) const {
  const auto d = std::partition_point(downs_.begin(), downs_.end(),
                                      [&](const Down& down) { return down.column < slab; });
  return d == downs_.begin() ? FaceId(0) : (d - 1)->right;
}

PlaneLocation PlaneLocator::locate(const QueryPoint2& q) const {
  const ColumnPlace place = find_column(q);
  if (place.is_on) {
    const std::size_t vertex_end = place.column + 1 < columns_.size()
                                       ? columns_[place.column + 1].vertex_begin
                                       : complex_.vertex_count();
    PlaneLocation found;
    if (locate_on_column(columns_[place.column], vertex_end, q, found)) return found;
  }
  // A point on a column that is on no vertex and no vertical edge is located in the slab to the
  // right, because no edge ends at the point.
  const std::size_t slab = place.column + (place.is_on ? 1 : 0);
  const EdgeId e =
      highest_below(slab, [&](EdgeId below) { return side(below, q) != Sign::Negative; });
  if (e.is_valid() && side(e, q) == Sign::Zero) return at(e);
  return at(e.is_valid() ? complex_.dcel.face(first_half(e)) : bottom_face(slab));
}

}  // namespace plumb
