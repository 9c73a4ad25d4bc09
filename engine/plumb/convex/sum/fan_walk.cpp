#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "plumb/convex/sum/convex_sum.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ConvexBody::kNone;

/// A direction, exact and in balls.
struct Heading {
  const RationalPoint3& exact;
  const BallVector& rough;
};

Heading normal_of(const ConvexBody& body, std::uint32_t f) {
  return {body.normal[f], body.rough_normal[f]};
}

/// From vertex `from` to vertex `to` of a body; rationals only when asked.
struct Step {
  const ConvexBody* body;
  std::uint32_t from;
  std::uint32_t to;
  BallVector rough;

  Step(const ConvexBody& of, std::uint32_t i, std::uint32_t j)
      : body(&of), from(i), to(j), rough(of.rough_point[j] - of.rough_point[i]) {}
  RationalPoint3 exact() const { return body->point[to] - body->point[from]; }
};

Sign dot_sign(const Step& w, const Heading& n) {
  const FilteredSign s = dot(w.rough, n.rough).sign();
  return is_decided(s) ? decided(s) : sign_of(dot(w.exact(), n.exact));
}

/// The sign of det(d, v, w).
Sign det_sign(const Step& d, const Step& v, const Step& w) {
  const FilteredSign s = dot(cross(d.rough, v.rough), w.rough).sign();
  return is_decided(s) ? decided(s) : sign_of(dot(cross(d.exact(), v.exact()), w.exact()));
}

/// The sign of det(d, n, w): is w ahead when a direction turns about d, leaving n?
Sign ahead_sign(const Step& d, const Heading& n, const Step& w) {
  const FilteredSign s = dot(cross(d.rough, n.rough), w.rough).sign();
  return is_decided(s) ? decided(s) : sign_of(dot(cross(d.exact(), n.exact), w.exact()));
}

/// A vertex that is greatest in the direction, by steps uphill.
std::uint32_t climb(const ConvexBody& body, std::uint32_t v, const Heading& n) {
  for (;;) {
    std::uint32_t better = kNone;
    for (const std::uint32_t w : body.star(v)) {
      if (dot_sign(Step(body, v, w), n) != Sign::Positive) continue;
      better = w;
      break;
    }
    if (better == kNone) return v;
    v = better;
  }
}

/// The facets of a body, each found from one beside it: visit(facet, where to start) -> where it
/// ended.
template <class Visit>
void for_each_facet_nearby(const ConvexBody& body, const Visit& visit) {
  std::vector<std::vector<std::uint32_t>> beside(body.facet_count());
  for (const ConvexBody::Edge& e : body.edge) {
    beside[e.side[0]].push_back(e.side[1]);
    beside[e.side[1]].push_back(e.side[0]);
  }
  std::vector<std::uint32_t> queue{0}, start(body.facet_count(), kNone);
  start[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t end = visit(queue[i], start[queue[i]]);
    for (const std::uint32_t g : beside[queue[i]]) {
      if (start[g] != kNone) continue;
      start[g] = end;
      queue.push_back(g);
    }
  }
}

/// The vertices around which the walk of one edge turns, of the other operand.
class EdgeWalk {
 public:
  /// `d` is the edge walked about; `body` the other operand.
  EdgeWalk(const ConvexBody& body, const Step& d, const Heading& from, const Heading& to)
      : body_(body), d_(d), from_(from), to_(to) {}

  /// Calls visit(v, w) for every edge of the body, not parallel to d, that is extreme in a
  /// direction strictly between. Requires v extreme in the first direction.
  template <class Visit>
  void run(std::uint32_t v, const Visit& visit) {
    settle(v);
    for (;;) {
      gather_next();
      if (next_.empty() || dot_sign(next_[0], to_) != Sign::Positive) return;
      if (next_.size() == 1) visit(next_[0].from, next_[0].to);
      cross_over();
    }
  }

 private:
  /// Off the first direction: as far ahead as what is extreme there reaches.
  void settle(std::uint32_t v) {
    for (bool moves = true; moves;) {
      moves = false;
      for (const std::uint32_t w : body_.star(v)) {
        const Step step(body_, v, w);
        if (dot_sign(step, from_) != Sign::Zero) continue;
        if (ahead_sign(d_, from_, step) != Sign::Positive) continue;
        v = w;
        moves = true;
        break;
      }
    }
    stand_at(v);
  }

  /// At v, and at the other end of an edge parallel to d if there is one.
  void stand_at(std::uint32_t v) {
    at_ = {v, kNone};
    for (const std::uint32_t w : body_.star(v)) {
      const Step step(body_, v, w);
      if (dot_sign(step, from_) == Sign::Zero && ahead_sign(d_, from_, step) == Sign::Zero) {
        at_[1] = w;
      }
    }
  }

  /// The edges met next, all in one direction seen along d: gift wrapping.
  void gather_next() {
    next_.clear();
    for (const std::uint32_t v : at_) {
      if (v == kNone) continue;
      for (const std::uint32_t w : body_.star(v)) {
        if (w == at_[0] || w == at_[1]) continue;
        const Step step(body_, v, w);
        const Sign turn = next_.empty() ? Sign::Zero : det_sign(d_, next_[0], step);
        if (turn == Sign::Negative) next_.clear();
        if (turn != Sign::Positive) next_.push_back(step);
      }
    }
  }

  /// To the far end of the edge or facet that holds next_: uphill along it.
  void cross_over() {
    const Step first = next_[0];
    std::uint32_t v = first.to;
    if (next_.size() > 1) {
      const RationalPoint3 along = first.exact(), d = d_.exact();
      const RationalPoint3 normal = cross(along, d), ahead = cross(d, normal);
      for (bool moves = true; moves;) {
        moves = false;
        for (const std::uint32_t w : body_.star(v)) {
          const RationalPoint3 step = body_.point[w] - body_.point[v];
          if (dot(step, normal) != 0 || dot(step, ahead) <= 0) continue;
          v = w;
          moves = true;
          break;
        }
      }
    }
    stand_at(v);
  }

  const ConvexBody& body_;
  const Step& d_;
  Heading from_, to_;
  std::array<std::uint32_t, 2> at_{};
  std::vector<Step> next_;
};

/// The directions of a sum, seen from operand `own` with facets; `is_swapped`: it is the second
/// one.
class Directions {
 public:
  Directions(const ConvexBody& own, const ConvexBody& other, bool is_swapped,
             const std::function<void(const FacetDirection&)>& visit)
      : own_(own), other_(other), is_swapped_(is_swapped), visit_(visit) {
    facets_at_.resize(other.point.size());
    for (std::uint32_t f = 0; f < other.facet_count(); ++f) {
      for (const std::uint32_t v : other.corners(f)) facets_at_[v].push_back(f);
    }
  }

  /// A vertex of the other operand for each facet of `own`; visits them, but those with a facet on
  /// the other side if `skips_common`.
  void facets(bool skips_common) {
    extreme_.resize(own_.facet_count());
    for_each_facet_nearby(own_, [&](std::uint32_t f, std::uint32_t start) {
      extreme_[f] = climb(other_, start, normal_of(own_, f));
      face_of(extreme_[f], normal_of(own_, f));
      if (!skips_common || face_.size() < 3) emit(normal_of(own_, f), own_.corners(f), face_);
      return extreme_[f];
    });
  }

  /// Requires facets() before.
  void edges(Context& context) {
    for (std::size_t e = 0; e < own_.edge.size(); ++e) {
      if (e % 1024 == 0) context.checkpoint("convex sum", e, own_.edge.size());
      walk(own_.edge[e]);
    }
  }

 private:
  void walk(const ConvexBody::Edge& edge) {
    const Step d(own_, edge.end[0], edge.end[1]);
    const auto [left, right] = edge.side;
    EdgeWalk walk(other_, d, normal_of(own_, left), normal_of(own_, right));
    walk.run(extreme_[left], [&](std::uint32_t v, std::uint32_t w) {
      const Step step(other_, v, w);
      const RationalPoint3 normal = cross(step.exact(), d.exact());
      const BallVector rough = cross(step.rough, d.rough);
      const std::array<std::uint32_t, 2> other{v, w};
      emit({normal, rough}, edge.end, other);
    });
  }

  /// The face of the other operand in a direction, v being one of its vertices.
  void face_of(std::uint32_t v, const Heading& n) {
    face_.assign(1, v);
    for (const std::uint32_t w : other_.star(v)) {
      if (dot_sign(Step(other_, v, w), n) == Sign::Zero) face_.push_back(w);
    }
    if (face_.size() < 3) return;
    const auto f = std::find_if(facets_at_[v].begin(), facets_at_[v].end(), [&](std::uint32_t g) {
      return is_parallel(other_.normal[g], n.exact);
    });
    PLUMB_CHECK(f != facets_at_[v].end());
    face_.assign(other_.corners(*f).begin(), other_.corners(*f).end());
  }

  static bool is_parallel(const RationalPoint3& m, const RationalPoint3& n) {
    const RationalPoint3 c = cross(m, n);
    return c.x == 0 && c.y == 0 && c.z == 0 && dot(m, n) > 0;
  }

  void emit(const Heading& normal, std::span<const std::uint32_t> own,
            std::span<const std::uint32_t> other) {
    if (is_swapped_) {
      visit_({normal.exact, normal.rough, other, own});
    } else {
      visit_({normal.exact, normal.rough, own, other});
    }
  }

  const ConvexBody& own_;
  const ConvexBody& other_;
  bool is_swapped_;
  const std::function<void(const FacetDirection&)>& visit_;
  std::vector<std::vector<std::uint32_t>> facets_at_;  // per vertex of other_
  std::vector<std::uint32_t> extreme_;                 // per facet of own_: a vertex of other_
  std::vector<std::uint32_t> face_;
};

}  // namespace

void for_each_direction(const ConvexBody& a, const ConvexBody& b,
                        const std::function<void(const FacetDirection&)>& visit, Context& context) {
  PLUMB_CHECK(a.facet_count() + b.facet_count() > 0);
  Directions of_a(a, b, false, visit), of_b(b, a, true, visit);
  if (a.facet_count() > 0) of_a.facets(false);
  if (b.facet_count() > 0) of_b.facets(a.facet_count() > 0);
  // Crossings of arcs are found from either side.
  (a.facet_count() > 0 ? of_a : of_b).edges(context);
}

}  // namespace plumb
