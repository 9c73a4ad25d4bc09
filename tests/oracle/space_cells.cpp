#include "oracle/space_cells.h"

#include <algorithm>
#include <bit>
#include <set>
#include <stdexcept>

namespace plumb::testing {
namespace {

CellPoint3 reduced_point(CellVector v, BigInt w) {
  const BigInt divisor = gcd(gcd(gcd(v.x, v.y), v.z), w) * (w < 0 ? -1 : 1);
  return {{v.x / divisor, v.y / divisor, v.z / divisor}, w / divisor};
}

CellPlane reduced_plane(const CellVector& n, const BigInt& d) {
  const BigInt divisor = gcd(gcd(gcd(n.x, n.y), n.z), d);
  return {{n.x / divisor, n.y / divisor, n.z / divisor}, d / divisor};
}

CellVector minus(const CellVector& u, const CellVector& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}

BigInt value_at(const CellPlane& plane, const CellPoint3& p) {
  return dot(plane.n, p.v) + plane.d * p.w;
}

// p + t direction
CellPoint3 moved(const CellPoint3& p, const CellVector& direction, const BigRational& t) {
  const BigInt up = numerator(t) * p.w;
  const BigInt down = denominator(t);
  return reduced_point({p.v.x * down + up * direction.x, p.v.y * down + up * direction.y,
                        p.v.z * down + up * direction.z},
                       p.w * down);
}

CellPoint3 any_point_on(const CellPlane& p, const CellPlane& q, const CellVector& direction) {
  return reduced_point(cross(minus(q.d * p.n, p.d * q.n), direction), dot(direction, direction));
}

// When p + t direction is on the plane; requires that it moves through the plane.
BigRational meeting_time(const CellPlane& plane, const CellPoint3& p, const CellVector& direction) {
  return BigRational(-value_at(plane, p)) / (dot(plane.n, direction) * p.w);
}

bool contains(const std::vector<std::size_t>& some, std::size_t one) {
  return std::find(some.begin(), some.end(), one) != some.end();
}

}  // namespace

// ---------------------------------------------------------------- vectors, planes, points, lines

CellVector operator*(const BigInt& factor, const CellVector& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
CellVector cross(const CellVector& u, const CellVector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
BigInt dot(const CellVector& u, const CellVector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
bool is_zero(const CellVector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
int direction_sign(const CellVector& v) {
  return v.x != 0 ? v.x.sign() : v.y != 0 ? v.y.sign() : v.z.sign();
}
CellVector reduced(const CellVector& v) {
  const BigInt divisor = gcd(gcd(v.x, v.y), v.z);
  return {v.x / divisor, v.y / divisor, v.z / divisor};
}

bool operator<(const CellPlane& p, const CellPlane& q) {
  return std::tie(p.n.x, p.n.y, p.n.z, p.d) < std::tie(q.n.x, q.n.y, q.n.z, q.d);
}

CellPlane opposite(const CellPlane& plane) { return {BigInt(-1) * plane.n, -plane.d}; }

CellPlane plane_of(const BigRational& a, const BigRational& b, const BigRational& c,
                   const BigRational& d) {
  const BigInt w = lcm(lcm(denominator(a), denominator(b)), lcm(denominator(c), denominator(d)));
  const auto scaled = [&](const BigRational& v) {
    return BigInt(numerator(v) * (w / denominator(v)));
  };
  return reduced_plane({scaled(a), scaled(b), scaled(c)}, scaled(d));
}

CellPlane plane_at(const ExactPoint3& p, const ExactPoint3& normal) {
  return plane_of(normal.x, normal.y, normal.z, -dot(normal, p));
}

CellPlane plane_through(const ExactPoint3& p, const ExactPoint3& q, const ExactPoint3& r) {
  return plane_at(p, cross(q - p, r - p));
}

CellPlane unoriented(const CellPlane& plane) {
  return direction_sign(plane.n) < 0 ? opposite(plane) : plane;
}

CellPoint3 cell_point(const ExactPoint3& p) {
  const BigInt w = lcm(lcm(denominator(p.x), denominator(p.y)), denominator(p.z));
  const auto scaled = [&](const BigRational& v) {
    return BigInt(numerator(v) * (w / denominator(v)));
  };
  return {{scaled(p.x), scaled(p.y), scaled(p.z)}, w};
}

ExactPoint3 exact_of(const CellPoint3& p) {
  return {BigRational(p.v.x, p.w), BigRational(p.v.y, p.w), BigRational(p.v.z, p.w)};
}

int side(const CellPlane& plane, const CellPoint3& p) { return value_at(plane, p).sign(); }

bool operator<(const CellLine3& s, const CellLine3& t) {
  const auto key = [](const CellLine3& l) {
    return std::tie(l.direction.x, l.direction.y, l.direction.z, l.moment.x, l.moment.y,
                    l.moment.z);
  };
  return key(s) < key(t);
}

CellLine3 line_of(const CellPlane& p, const CellPlane& q) {
  const CellVector direction = reduced(cross(p.n, q.n));
  const ExactPoint3 u{direction.x, direction.y, direction.z};
  return {direction, cross(exact_of(any_point_on(p, q, cross(p.n, q.n))), u)};
}

CellLine3 undirected(const CellLine3& line) {
  if (direction_sign(line.direction) > 0) return line;
  return {BigInt(-1) * line.direction, BigRational(-1) * line.moment};
}

// ---------------------------------------------------------------- cells

void SpaceCells::Signs::set(std::size_t plane, int sign) {
  const std::uint64_t bit = std::uint64_t{1} << plane;
  positive = sign > 0 ? positive | bit : positive & ~bit;
  negative = sign < 0 ? negative | bit : negative & ~bit;
}

int SpaceCells::Signs::operator[](std::size_t plane) const {
  return static_cast<int>((positive >> plane) & 1U) - static_cast<int>((negative >> plane) & 1U);
}

SpaceCells::SpaceCells(std::vector<CellPlane> planes) : planes_(std::move(planes)) {
  for (CellPlane& plane : planes_) plane = unoriented(plane);
  std::sort(planes_.begin(), planes_.end());
  planes_.erase(std::unique(planes_.begin(), planes_.end()), planes_.end());
  if (planes_.size() > kMaxPlanes) throw std::length_error("too many planes for SpaceCells");
  for (std::size_t j = 0; j < planes_.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) add_cells_of_line(i, j);
  }
  const std::size_t flat = cells_.size();
  for (std::size_t e = 0; e < flat; ++e) {
    if (cells_[e].dimension == 1) add_facets_at(e);
  }
  for (std::size_t p = 0; p < planes_.size(); ++p) add_facet_of_plane(p);
  const std::size_t thin = cells_.size();
  for (std::size_t f = flat; f < thin; ++f) add_volumes_at(f);
  if (planes_.empty()) cells_[find_or_add(3, {}, {{0, 0, 0}, 1})].unbounded = true;
  link();
}

std::size_t SpaceCells::cell_of(const CellPoint3& p) const { return index_.at(signs_at(p)); }

SpaceCells::Signs SpaceCells::signs_at(const CellPoint3& p) const {
  Signs signs;
  for (std::size_t k = 0; k < planes_.size(); ++k) signs.set(k, side(planes_[k], p));
  return signs;
}

std::size_t SpaceCells::find_or_add(int dimension, const Signs& signs, CellPoint3 sample) {
  const auto [place, added] = index_.emplace(signs, cells_.size());
  if (added) {
    cells_.push_back({.dimension = dimension, .signs = signs, .sample = std::move(sample)});
    cells_.back().point = exact_of(cells_.back().sample);
  }
  return place->second;
}

// The line of planes i and j, unless another pair of planes has given it.
void SpaceCells::add_cells_of_line(std::size_t i, std::size_t j) {
  const CellVector direction = cross(planes_[i].n, planes_[j].n);
  if (is_zero(direction)) return;
  const CellPoint3 start = any_point_on(planes_[i], planes_[j], direction);
  std::vector<BigRational> stops;
  for (std::size_t k = 0; k < planes_.size(); ++k) {
    if (dot(planes_[k].n, direction) != 0) {
      stops.push_back(meeting_time(planes_[k], start, direction));
    } else if (k < j && k != i && side(planes_[k], start) == 0) {
      return;
    }
  }
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  if (stops.empty()) return add_edge(start, true, {});
  std::vector<std::size_t> vertices;
  for (const BigRational& t : stops) {
    const CellPoint3 p = moved(start, direction, t);
    vertices.push_back(find_or_add(0, signs_at(p), p));
  }
  add_edge(moved(start, direction, stops.front() - 1), true, {vertices.front()});
  for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
    add_edge(moved(start, direction, (stops[s] + stops[s + 1]) / 2), false,
             {vertices[s], vertices[s + 1]});
  }
  add_edge(moved(start, direction, stops.back() + 1), true, {vertices.back()});
}

void SpaceCells::add_edge(CellPoint3 sample, bool unbounded, std::vector<std::size_t> ends) {
  const Signs signs = signs_at(sample);
  Cell& edge = cells_[find_or_add(1, signs, std::move(sample))];
  edge.unbounded = unbounded;
  edge.faces = std::move(ends);
}

// In each plane through the edge, on both sides of it.
void SpaceCells::add_facets_at(std::size_t edge) {
  std::vector<std::size_t> through;
  for (std::size_t k = 0; k < planes_.size(); ++k) {
    if (cells_[edge].signs[k] == 0) through.push_back(k);
  }
  const CellVector along = cross(planes_[through[0]].n, planes_[through[1]].n);
  for (const std::size_t p : through) {
    for (const int sign : {-1, +1}) {
      const CellVector across = BigInt(sign) * cross(planes_[p].n, along);
      Signs signs = cells_[edge].signs;
      for (const std::size_t k : through) signs.set(k, dot(planes_[k].n, across).sign());
      add_beside(edge, 2, signs, across);
    }
  }
}

void SpaceCells::add_facet_of_plane(std::size_t plane) {
  const CellVector& n = planes_[plane].n;
  for (const CellPlane& other : planes_) {
    if (!is_zero(cross(n, other.n))) return;
  }
  const CellPoint3 foot = reduced_point(-planes_[plane].d * n, dot(n, n));
  cells_[find_or_add(2, signs_at(foot), foot)].unbounded = true;
}

void SpaceCells::add_volumes_at(std::size_t facet) {
  const auto plane = static_cast<std::size_t>(std::countr_zero(planes_through(facet)));
  for (const int sign : {-1, +1}) {
    Signs signs = cells_[facet].signs;
    signs.set(plane, sign);
    add_beside(facet, 3, signs, BigInt(sign) * planes_[plane].n);
  }
}

void SpaceCells::add_beside(std::size_t cell, int dimension, const Signs& signs,
                            const CellVector& direction) {
  const auto found = index_.find(signs);
  const std::size_t beside_it =
      found != index_.end() ? found->second
                            : find_or_add(dimension, signs, beside(cells_[cell].sample, direction));
  cells_[beside_it].faces.push_back(cell);
}

// Half the way to the first plane met, or one step.
CellPoint3 SpaceCells::beside(const CellPoint3& p, const CellVector& direction) const {
  BigRational step = 1;
  for (const CellPlane& plane : planes_) {
    if (dot(plane.n, direction) == 0) continue;
    const BigRational met = meeting_time(plane, p, direction);
    if (met > 0) step = std::min<BigRational>(step, met / 2);
  }
  return moved(p, direction, step);
}

// Upward through the faces: what is around a cell, corners, and what reaches to infinity.
void SpaceCells::link() {
  std::vector<std::set<std::size_t>> below(cells_.size());
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      Cell& cell = cells_[c];
      if (cell.dimension != dimension) continue;
      for (const std::size_t face : cell.faces) {
        below[c].insert(face);
        below[c].insert(below[face].begin(), below[face].end());
        cell.unbounded = cell.unbounded || cells_[face].unbounded;
      }
      for (const std::size_t lower : below[c]) {
        cells_[lower].around.push_back(c);
        if (cells_[lower].dimension == 0) cell.corners.push_back(lower);
      }
    }
  }
}

// Pyramids over its facets from one of its corners; each facet in triangles from one of its own.
BigRational SpaceCells::volume_of(std::size_t cell) const {
  BigRational sixfold = 0;
  const std::size_t apex = cells_[cell].corners.front();
  for (const std::size_t facet : cells_[cell].faces) {
    if (contains(cells_[facet].corners, apex)) continue;
    const std::size_t pivot = cells_[facet].corners.front();
    for (const std::size_t edge : cells_[facet].faces) {
      const std::vector<std::size_t>& ends = cells_[edge].corners;
      if (contains(ends, pivot)) continue;
      const ExactPoint3& from = cells_[apex].point;
      const BigRational piece =
          dot(cells_[pivot].point - from,
              cross(cells_[ends[0]].point - from, cells_[ends[1]].point - from));
      sixfold += piece < 0 ? BigRational(-piece) : piece;
    }
  }
  return sixfold / 6;
}

}  // namespace plumb::testing
