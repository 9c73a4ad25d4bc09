#include "oracle/line_cells.h"

#include <algorithm>
#include <stdexcept>

namespace plumb::testing {
namespace {

CellPoint reduced_point(BigInt x, BigInt y, BigInt w) {
  const BigInt divisor = gcd(gcd(x, y), w) * (w < 0 ? -1 : 1);
  return {x / divisor, y / divisor, w / divisor};
}

CellLine reduced_line(const BigInt& a, const BigInt& b, const BigInt& c) {
  const BigInt divisor = gcd(gcd(a, b), c);
  return {a / divisor, b / divisor, c / divisor};
}

CellLine over_integers(const BigRational& a, const BigRational& b, const BigRational& c) {
  const BigInt w = lcm(lcm(denominator(a), denominator(b)), denominator(c));
  const auto scaled = [&](const BigRational& v) {
    return BigInt(numerator(v) * (w / denominator(v)));
  };
  return reduced_line(scaled(a), scaled(b), scaled(c));
}

BigInt determinant(const CellLine& s, const CellLine& t) { return s.a * t.b - s.b * t.a; }

CellPoint crossing(const CellLine& s, const CellLine& t) {
  return reduced_point(s.b * t.c - s.c * t.b, s.c * t.a - s.a * t.c, determinant(s, t));
}

CellPoint between(const CellPoint& p, const CellPoint& q) {
  return reduced_point(p.x * q.w + q.x * p.w, p.y * q.w + q.y * p.w, 2 * p.w * q.w);
}

// One step along the line, in its direction or against it.
CellPoint moved_along(const CellLine& line, const CellPoint& p, int steps) {
  return reduced_point(p.x + steps * line.b * p.w, p.y - steps * line.a * p.w, p.w);
}

CellPoint any_point_on(const CellLine& line) {
  return reduced_point(-line.a * line.c, -line.b * line.c, line.a * line.a + line.b * line.b);
}

bool less_xy(const CellPoint& p, const CellPoint& q) {
  const BigInt dx = p.x * q.w - q.x * p.w;
  return dx != 0 ? dx < 0 : p.y * q.w < q.y * p.w;
}

BigInt value_at(const CellLine& line, const CellPoint& p) {
  return line.a * p.x + line.b * p.y + line.c * p.w;
}

}  // namespace

bool operator<(const CellLine& s, const CellLine& t) {
  return std::tie(s.a, s.b, s.c) < std::tie(t.a, t.b, t.c);
}

CellLine line_through(const ExactPoint& p, const ExactPoint& q) {
  const BigRational a = p.y - q.y;
  const BigRational b = q.x - p.x;
  return over_integers(a, b, -(a * p.x + b * p.y));
}

CellLine undirected(CellLine line) {
  line = reduced_line(line.a, line.b, line.c);
  const bool backward = line.b < 0 || (line.b == 0 && line.a > 0);
  return backward ? CellLine{-line.a, -line.b, -line.c} : line;
}

CellLine vertical_through(const ExactPoint& p) { return over_integers(-1, 0, p.x); }

CellPoint cell_point(const ExactPoint& p) {
  const BigInt w = lcm(denominator(p.x), denominator(p.y));
  return {numerator(p.x) * (w / denominator(p.x)), numerator(p.y) * (w / denominator(p.y)), w};
}

ExactPoint exact_of(const CellPoint& p) { return {BigRational(p.x, p.w), BigRational(p.y, p.w)}; }

int side(const CellLine& line, const CellPoint& p) { return value_at(line, p).sign(); }

void LineCells::Signs::set(std::size_t line, int sign) {
  positive[line] = sign > 0;
  negative[line] = sign < 0;
}

bool LineCells::Signs::in_closure_of(const Signs& other) const {
  return (positive & ~other.positive).none() && (negative & ~other.negative).none();
}

LineCells::LineCells(std::vector<CellLine> lines) : lines_(std::move(lines)) {
  for (CellLine& line : lines_) line = undirected(line);
  std::sort(lines_.begin(), lines_.end());
  lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
  if (lines_.size() > kMaxLines) throw std::length_error("too many lines for LineCells");
  add_vertices();
  for (std::size_t l = 0; l < lines_.size(); ++l) add_edges_of(l);
  const std::size_t flat = cells_.size();
  for (std::size_t e = 0; e < flat; ++e) {
    for (const int sign : {-1, +1}) add_face_beside(e, sign);
  }
  if (lines_.empty()) add({}, {.dimension = 2, .sample = {0, 0, 1}, .unbounded = true});
  link();
}

std::size_t LineCells::cell_of(const CellPoint& p) const { return index_.at(signs_at(p)); }

std::size_t LineCells::bottom() const {
  Signs signs;
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    signs.set(l, lines_[l].b != 0 ? -lines_[l].b.sign() : -lines_[l].a.sign());
  }
  return index_.at(signs);
}

LineCells::Signs LineCells::signs_at(const CellPoint& p) const {
  Signs signs;
  for (std::size_t l = 0; l < lines_.size(); ++l) signs.set(l, side(lines_[l], p));
  return signs;
}

bool LineCells::add(const Signs& signs, Cell cell) {
  if (!index_.emplace(signs, cells_.size()).second) return false;
  cell.point = exact_of(cell.sample);
  cells_.push_back(std::move(cell));
  signs_.push_back(signs);
  return true;
}

void LineCells::add_vertices() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (determinant(lines_[i], lines_[j]) == 0) continue;
      const CellPoint p = crossing(lines_[i], lines_[j]);
      add(signs_at(p), {.dimension = 0, .sample = p});
    }
  }
}

void LineCells::add_edges_of(std::size_t line) {
  std::vector<CellPoint> stops;
  for (const Cell& v : cells_) {
    if (v.dimension == 0 && side(lines_[line], v.sample) == 0) stops.push_back(v.sample);
  }
  if (stops.empty()) return add_edge(line, any_point_on(lines_[line]), true);
  std::sort(stops.begin(), stops.end(), less_xy);
  add_edge(line, moved_along(lines_[line], stops.front(), -1), true);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    add_edge(line, between(stops[i], stops[i + 1]), false);
  }
  add_edge(line, moved_along(lines_[line], stops.back(), +1), true);
}

void LineCells::add_edge(std::size_t line, CellPoint sample, bool unbounded) {
  const Signs signs = signs_at(sample);
  add(signs, {.dimension = 1, .sample = std::move(sample), .line = line, .unbounded = unbounded});
}

// The face has the signs of the edge but for the line it lies on.
void LineCells::add_face_beside(std::size_t edge, int sign) {
  if (cells_[edge].dimension != 1) return;
  Signs signs = signs_[edge];
  signs.set(*cells_[edge].line, sign);
  if (index_.contains(signs)) return;
  add(signs, {.dimension = 2, .sample = beside(cells_[edge], sign)});
}

// Half the way to the first line met straight to that side.
CellPoint LineCells::beside(const Cell& edge, int sign) const {
  const CellLine& line = lines_[*edge.line];
  const BigInt dx = sign * line.a;
  const BigInt dy = sign * line.b;
  BigRational step = 1;
  for (const CellLine& other : lines_) {
    const BigInt slope = (other.a * dx + other.b * dy) * edge.sample.w;
    if (slope == 0) continue;
    const BigRational met = BigRational(-value_at(other, edge.sample)) / slope;
    if (met > 0) step = std::min<BigRational>(step, met / 2);
  }
  const ExactPoint& p = edge.point;
  return cell_point({p.x + step * dx, p.y + step * dy});
}

void LineCells::link() {
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (cells_[c].dimension == 2) continue;
    for (std::size_t d = 0; d < cells_.size(); ++d) {
      if (cells_[d].dimension <= cells_[c].dimension || !signs_[c].in_closure_of(signs_[d])) {
        continue;
      }
      cells_[c].around.push_back(d);
      if (cells_[c].dimension == 0) cells_[d].corners.push_back(c);
      if (cells_[c].dimension == 1 && cells_[c].unbounded) cells_[d].unbounded = true;
    }
  }
  for (Cell& cell : cells_) {
    if (cell.dimension == 2 && !cell.unbounded) cell.area = area_of(cell);
  }
}

// A bounded face is the hull of its corners, which are in order around any of its points.
BigRational LineCells::area_of(const Cell& face) const {
  std::vector<ExactPoint> ring;
  const ExactPoint& centre = face.point;
  for (const std::size_t v : face.corners) {
    const ExactPoint& p = cells_[v].point;
    ring.push_back({p.x - centre.x, p.y - centre.y});
  }
  const auto upper = [](const ExactPoint& p) { return p.y > 0 || (p.y == 0 && p.x > 0); };
  std::sort(ring.begin(), ring.end(), [&](const ExactPoint& p, const ExactPoint& q) {
    return upper(p) != upper(q) ? upper(p) : p.x * q.y - p.y * q.x > 0;
  });
  BigRational doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint& p = ring[i];
    const ExactPoint& q = ring[(i + 1) % ring.size()];
    doubled += p.x * q.y - p.y * q.x;
  }
  return doubled / 2;
}

}  // namespace plumb::testing
