#include "oracle/plane_set.h"

#include <algorithm>

namespace plumb::testing {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

// A straight piece of a chain, of some length.
struct Piece {
  ExactPoint from;
  ExactPoint to;
  CellLine line;
};

// Closed chains come back to their first point.
std::vector<Piece> pieces_of(const std::vector<Chain>& chains, bool closed) {
  std::vector<Piece> pieces;
  for (const Chain& chain : chains) {
    for (std::size_t i = 0; i + (closed ? 0 : 1) < chain.size(); ++i) {
      const ExactPoint& p = chain[i];
      const ExactPoint& q = chain[(i + 1) % chain.size()];
      if (!(p == q)) pieces.push_back({p, q, line_through(p, q)});
    }
  }
  return pieces;
}

// ---------------------------------------------------------------- lines and points

// The line a -> b, and one across it at `stop`.
void add_stop(const CellLine& line, const ExactPoint& stop, std::vector<CellLine>& lines) {
  lines.push_back(line.b != 0 ? vertical_through(stop) : line_through(stop, {stop.x + 1, stop.y}));
}

void add_point_lines(const ExactPoint& p, std::vector<CellLine>& lines) {
  lines.push_back(vertical_through(p));
  lines.push_back(line_through(p, {p.x + 1, p.y}));
}

bool is_point(const Chain& chain) {
  return !chain.empty() && std::all_of(chain.begin(), chain.end(),
                                       [&](const ExactPoint& p) { return p == chain.front(); });
}

void add_chains_lines(const std::vector<Chain>& chains, bool closed, std::vector<CellLine>& lines) {
  for (const Piece& piece : pieces_of(chains, closed)) {
    lines.push_back(piece.line);
    add_stop(piece.line, piece.from, lines);
    add_stop(piece.line, piece.to, lines);
  }
  for (const Chain& chain : chains) {
    if (is_point(chain)) add_point_lines(chain.front(), lines);
  }
}

// ---------------------------------------------------------------- membership of leaves

using Sample = LineCells::Cell;

bool lies_on(const Sample& r, const Piece& piece) {
  if (side(piece.line, r.sample) != 0) return false;
  return r.point == piece.from || r.point == piece.to ||
         (piece.from < r.point) != (piece.to < r.point);
}

bool lies_on_some(const Sample& r, const std::vector<Piece>& pieces) {
  return std::any_of(pieces.begin(), pieces.end(),
                     [&](const Piece& piece) { return lies_on(r, piece); });
}

// How often the pieces go around a point that lies on none of them: upward ones crossed by the
// horizontal ray to the right, less downward ones.
int winding_number(const Sample& r, const std::vector<Piece>& pieces) {
  int number = 0;
  for (const Piece& piece : pieces) {
    const BigRational& y = r.point.y;
    const bool upward = piece.from.y <= y && y < piece.to.y;
    const bool downward = piece.to.y <= y && y < piece.from.y;
    if (upward && side(piece.line, r.sample) > 0) ++number;
    if (downward && side(piece.line, r.sample) < 0) --number;
  }
  return number;
}

bool is_inside(WindingRule rule, int number) {
  switch (rule) {
    case WindingRule::NonZero:
      return number != 0;
    case WindingRule::EvenOdd:
      return number % 2 != 0;
    default:
      return number > 0;
  }
}

class PolygonMarks {
 public:
  PolygonMarks(const SetPolygons& set, const LineCells& cells)
      : set_(set),
        cells_(cells),
        pieces_(pieces_of(set.chains, true)),
        closed_(set.boundary == Boundary::Closed) {}

  CellMarks run() {
    marks_.assign(cells_.size(), false);
    winding_.assign(cells_.size(), 0);
    for (const int dimension : {2, 1, 0}) {
      for (std::size_t c = 0; c < cells_.size(); ++c) {
        if (cells_[c].dimension == dimension) marks_[c] = mark_of(c);
      }
    }
    return marks_;
  }

 private:
  bool mark_of(std::size_t c) {
    const Sample& p = cells_[c];
    if (cells_[c].dimension == 2) {
      winding_[c] = winding_number(p, pieces_);
      return is_inside(set_.rule, winding_[c]);
    }
    return cells_[c].dimension == 1 ? mark_of_edge(c, p) : mark_of_vertex(c, p.point);
  }

  bool mark_of_edge(std::size_t c, const Sample& p) const {
    const CellLine& line = cells_.lines()[*cells_[c].line];
    int left = 0;
    int right = 0;
    for (const std::size_t f : cells_[c].around) {
      (side(line, cells_[f].sample) > 0 ? left : right) = winding_[f];
    }
    const auto [up, down] = crossings(p, line);
    if (closed_) {
      const bool back_and_forth = up > 0 && up == down;
      return is_inside(set_.rule, left) || is_inside(set_.rule, right) || back_and_forth;
    }
    bool all = true;
    for (int w = left - up; w <= left + down; ++w) all = all && is_inside(set_.rule, w);
    return all;
  }

  // Pieces at p, which run with the line and against it: left of one that runs with the line the
  // winding number is one more than right of it.
  std::pair<int, int> crossings(const Sample& p, const CellLine& line) const {
    std::pair<int, int> count{0, 0};
    for (const Piece& piece : pieces_) {
      if (lies_on(p, piece)) ++(piece.line == line ? count.first : count.second);
    }
    return count;
  }

  bool mark_of_vertex(std::size_t c, const ExactPoint& p) const {
    const auto& around = cells_[c].around;
    const auto marked = [&](std::size_t d) { return static_cast<bool>(marks_[d]); };
    if (!closed_) return std::all_of(around.begin(), around.end(), marked);
    return std::any_of(around.begin(), around.end(), marked) ||
           std::any_of(set_.chains.begin(), set_.chains.end(),
                       [&](const Chain& chain) { return is_point(chain) && chain.front() == p; });
  }

  const SetPolygons& set_;
  const LineCells& cells_;
  std::vector<Piece> pieces_;
  bool closed_;
  CellMarks marks_;
  std::vector<int> winding_;
};

template <class Contains>
CellMarks marks_where(const LineCells& cells, const Contains& contains) {
  CellMarks marks(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) marks[c] = contains(cells[c]);
  return marks;
}

CellMarks marks_of_ray(const SetRay& ray, const LineCells& cells) {
  const CellLine line = line_through(ray.a, ray.b);
  return marks_where(cells, [&](const Sample& p) {
    if (side(line, p.sample) != 0) return false;
    const ExactPoint& q = p.point;
    if (q == ray.a) return ray.boundary == Boundary::Closed;
    return (ray.a < ray.b) == (ray.a < q);
  });
}

CellMarks marks_of_polylines(const SetPolylines& set, const LineCells& cells) {
  const std::vector<Piece> pieces = pieces_of(set.chains, false);
  return marks_where(cells, [&](const Sample& q) {
    return lies_on_some(q, pieces) ||
           std::any_of(set.chains.begin(), set.chains.end(), [&](const Chain& chain) {
             return is_point(chain) && chain.front() == q.point;
           });
  });
}

CellMarks marks_of_points(const SetPoints& set, const LineCells& cells) {
  return marks_where(cells, [&](const Sample& p) {
    return std::find(set.points.begin(), set.points.end(), p.point) != set.points.end();
  });
}

}  // namespace

PlaneSetPointer apply(SetOperator op, PlaneSetPointer first, PlaneSetPointer second) {
  return set_of(SetOperation{op, std::move(first), std::move(second)});
}

void add_lines(const PlaneSet& set, std::vector<CellLine>& lines) {
  std::visit(Overloaded{
                 [&](const SetHalfPlane& h) { lines.push_back(line_through(h.a, h.b)); },
                 [&](const SetLine& l) { lines.push_back(line_through(l.a, l.b)); },
                 [&](const SetRay& r) {
                   lines.push_back(line_through(r.a, r.b));
                   add_stop(lines.back(), r.a, lines);
                 },
                 [&](const SetPolygons& p) { add_chains_lines(p.chains, true, lines); },
                 [&](const SetPolylines& p) { add_chains_lines(p.chains, false, lines); },
                 [&](const SetPoints& p) {
                   for (const ExactPoint& point : p.points) add_point_lines(point, lines);
                 },
                 [&](const SetOperation& o) {
                   add_lines(*o.first, lines);
                   if (o.second) add_lines(*o.second, lines);
                 },
             },
             set.node);
}

void add_points(const PlaneSet& set, std::vector<ExactPoint>& points) {
  const auto add_chains = [&](const std::vector<Chain>& chains) {
    for (const Chain& chain : chains) points.insert(points.end(), chain.begin(), chain.end());
  };
  std::visit(Overloaded{
                 [&](const SetPolygons& p) { add_chains(p.chains); },
                 [&](const SetPolylines& p) { add_chains(p.chains); },
                 [&](const SetPoints& p) {
                   points.insert(points.end(), p.points.begin(), p.points.end());
                 },
                 [&](const SetOperation& o) {
                   add_points(*o.first, points);
                   if (o.second) add_points(*o.second, points);
                 },
                 [&](const auto& two) {
                   points.push_back(two.a);
                   points.push_back(two.b);
                 },
             },
             set.node);
}

CellMarks marks_of(const PlaneSet& set, const LineCells& cells) {
  return std::visit(
      Overloaded{
          [&](const SetHalfPlane& h) {
            const CellLine line = line_through(h.a, h.b);
            const int least = h.boundary == Boundary::Closed ? 0 : 1;
            return marks_where(cells,
                               [&](const Sample& p) { return side(line, p.sample) >= least; });
          },
          [&](const SetLine& l) {
            const CellLine line = line_through(l.a, l.b);
            return marks_where(cells, [&](const Sample& p) { return side(line, p.sample) == 0; });
          },
          [&](const SetPolygons& p) { return PolygonMarks(p, cells).run(); },
          [&](const SetOperation& o) {
            return apply(o.op, cells, marks_of(*o.first, cells),
                         o.second ? marks_of(*o.second, cells) : CellMarks());
          },
          [&](const SetRay& r) { return marks_of_ray(r, cells); },
          [&](const SetPolylines& p) { return marks_of_polylines(p, cells); },
          [&](const SetPoints& p) { return marks_of_points(p, cells); },
      },
      set.node);
}

std::optional<BigRational> area_of(const LineCells& cells, const CellMarks& marks) {
  BigRational sum = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension != 2 || !marks[c]) continue;
    if (cells[c].unbounded) return std::nullopt;
    sum += cells[c].area;
  }
  return sum;
}

// ---------------------------------------------------------------- affine maps

namespace {

class Transformer {
 public:
  explicit Transformer(const AffineMap2& map)
      : xx_(exact_of(map.xx)),
        xy_(exact_of(map.xy)),
        x0_(exact_of(map.x0)),
        yx_(exact_of(map.yx)),
        yy_(exact_of(map.yy)),
        y0_(exact_of(map.y0)),
        mirrors_(xx_ * yy_ < xy_ * yx_) {}

  PlaneSetPointer operator()(const SetHalfPlane& h) const {
    const ExactPoint a = image(h.a);
    const ExactPoint b = image(h.b);
    return mirrors_ ? set_of(SetHalfPlane{b, a, h.boundary})
                    : set_of(SetHalfPlane{a, b, h.boundary});
  }
  PlaneSetPointer operator()(const SetLine& l) const {
    return set_of(SetLine{image(l.a), image(l.b)});
  }
  PlaneSetPointer operator()(const SetRay& r) const {
    return set_of(SetRay{image(r.a), image(r.b), r.boundary});
  }
  PlaneSetPointer operator()(const SetPolygons& p) const {
    SetPolygons result{images(p.chains), p.rule, p.boundary};
    if (mirrors_) {
      for (Chain& chain : result.chains) std::reverse(chain.begin(), chain.end());
    }
    return set_of(std::move(result));
  }
  PlaneSetPointer operator()(const SetPolylines& p) const {
    return set_of(SetPolylines{images(p.chains)});
  }
  PlaneSetPointer operator()(const SetPoints& p) const {
    return set_of(SetPoints{images(p.points)});
  }
  PlaneSetPointer operator()(const SetOperation& o) const {
    return apply(o.op, std::visit(*this, o.first->node),
                 o.second ? std::visit(*this, o.second->node) : nullptr);
  }

 private:
  ExactPoint image(const ExactPoint& p) const {
    return {xx_ * p.x + xy_ * p.y + x0_, yx_ * p.x + yy_ * p.y + y0_};
  }
  Chain images(const Chain& chain) const {
    Chain result;
    for (const ExactPoint& p : chain) result.push_back(image(p));
    return result;
  }
  std::vector<Chain> images(const std::vector<Chain>& chains) const {
    std::vector<Chain> result;
    for (const Chain& chain : chains) result.push_back(images(chain));
    return result;
  }

  BigRational xx_, xy_, x0_, yx_, yy_, y0_;
  bool mirrors_;
};

}  // namespace

PlaneSetPointer transformed(const PlaneSetPointer& set, const AffineMap2& map) {
  return std::visit(Transformer(map), set->node);
}

// ---------------------------------------------------------------- text

namespace {

std::string to_text(const Chain& chain) {
  std::string text;
  for (const ExactPoint& p : chain) text += (text.empty() ? "" : " ") + testing::to_text(p);
  return "[" + text + "]";
}

std::string to_text(const std::vector<Chain>& chains) {
  std::string text;
  for (const Chain& chain : chains) text += to_text(chain);
  return text;
}

std::string to_text(Boundary boundary) {
  return boundary == Boundary::Closed ? "closed " : "open ";
}

}  // namespace

std::string to_text(const ExactPoint& p) { return "(" + p.x.str() + "," + p.y.str() + ")"; }

std::string to_text(const PlaneSet& set) {
  static constexpr const char* kRules[] = {"nonzero", "evenodd", "positive"};
  return std::visit(Overloaded{
                        [](const SetHalfPlane& h) {
                          return to_text(h.boundary) + "half-plane " + to_text(Chain{h.a, h.b});
                        },
                        [](const SetLine& l) {
                          return "line " + to_text(Chain{l.a, l.b});
                        },
                        [](const SetRay& r) {
                          return to_text(r.boundary) + "ray " + to_text(Chain{r.a, r.b});
                        },
                        [](const SetPolygons& p) {
                          return to_text(p.boundary) + kRules[static_cast<int>(p.rule)] +
                                 " polygons " + to_text(p.chains);
                        },
                        [](const SetPolylines& p) { return "polylines " + to_text(p.chains); },
                        [](const SetPoints& p) { return "points " + to_text(p.points); },
                        [](const SetOperation& o) {
                          const std::string first = "(" + testing::to_text(*o.first) + ")";
                          if (!o.second) return name_of(o.op) + first;
                          return first + " " + name_of(o.op) + " (" + testing::to_text(*o.second) +
                                 ")";
                        },
                    },
                    set.node);
}

}  // namespace plumb::testing
