// Minkowski sums and erosions, and polyhedral balls for offsets.
//
// Both operands are decomposed into convex parts, each pair of parts that can matter is added
// (sum/convex_sum.h), and the sums are united. Every mark is exact because R(S) + R(T) = R(S + T)
// for the relative interiors of convex sets (R. T. Rockafellar, Convex Analysis, 1970, section 6):
// closed operands are unions of closed parts, any other operand is a union of relatively open
// parts, the cells of its convex parts. An open facet is further divided into open triangles and
// the open diagonals between them. A convex part with interior points stays whole: the sum of two
// such parts gets its marks from the marks of their faces (sum/half_open_body.h).
//
// PairFilter leaves out pairs that cannot matter: a sum with an open body is open, and does not
// change when the other operand is replaced by a dense part of it. So a body is added to maximal
// parts only, those in the boundary of no other part of their set. Erosion by B is the complement
// of (complement of A) + (-B); for bounded A the complement is taken within a box that is wide
// enough. Proofs: docs/design/walls.md, section Minkowski sums.
//
// With threads, closed operands are decomposed at the same time, and ranges of their pairs are
// added in parallel. The list of sums does not depend on the number of threads.
// Tested by tests/convex/minkowski_test.cpp.
#include "plumb/convex/minkowski.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/parallel_ranges.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/part/cut_set.h"
#include "plumb/convex/sum/convex_sum.h"
#include "plumb/convex/sum/half_open_body.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/complex/tidy_tables.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/set/nef3_state.h"

namespace plumb {
namespace {

constexpr unsigned kMaxRounds = 7;
// No coordinate of a ball of this radius underflows, so each keeps all bits of a double.
constexpr double kLeastRadius = 0x1p-900;

/// An octahedron of radius 1 whose triangles are divided into four, again and again.
class BallMesh {
 public:
  BallMesh() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        std::array<double, 3> p{};
        p[axis] = sign;
        mesh_.points.push_back({p[0], p[1], p[2]});
      }
    }
    // Vertex 2 axis + 0 is on the positive half of the axis, 2 axis + 1 on the negative half.
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const std::uint32_t x = octant & 1U, y = octant >> 1U & 1U, z = octant >> 2U & 1U;
      const bool is_mirrored = (x + y + z) % 2 == 1;
      triangle_.push_back(is_mirrored ? Triangle{x, 4 + z, 2 + y} : Triangle{x, 2 + y, 4 + z});
    }
  }

  void divide() {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangle_) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangle_ = std::move(finer);
  }

  PolygonMesh mesh(double radius) && {
    for (Point3& p : mesh_.points) p = {p.x * radius, p.y * radius, p.z * radius};
    for (const Triangle& t : triangle_) mesh_.add_face(t);
    return std::move(mesh_);
  }

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(mesh_.points.size());
    const auto [at, is_new] = middle_.try_emplace(std::minmax(a, b), next);
    if (is_new) {
      const Point3 p = mesh_.points[a], q = mesh_.points[b];
      const std::array<double, 3> m{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
      const double scale = 1 / std::hypot(m[0], m[1], m[2]);
      mesh_.points.push_back({m[0] * scale, m[1] * scale, m[2] * scale});
    }
    return at->second;
  }

  PolygonMesh mesh_;
  std::vector<Triangle> triangle_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_;
};

}  // namespace

Nef3 polyhedral_ball(double radius, unsigned rounds, Context& context) {
  if (!std::isfinite(radius) || !(radius > 0)) {
    throw Error(ErrorCode::BadArgument, "a ball needs a positive radius");
  }
  if (rounds > 0 && radius < kLeastRadius) {
    throw Error(ErrorCode::BadArgument, "a ball too small to round its vertices to doubles");
  }
  if (rounds > kMaxRounds) {
    throw Error(ErrorCode::ResourceLimit, "a ball of more than 7 rounds of subdivision");
  }
  BallMesh ball;
  for (unsigned i = 0; i < rounds; ++i) ball.divide();
  return Nef3::from_mesh(std::move(ball).mesh(radius), {.rule = WindingRule::Positive}, context);
}

namespace {

/// A closed or relatively open convex part of an operand, represented by its closure.
struct ConvexPart {
  ConvexBody body;
  bool is_maximal = false;  ///< Whether the part is in the boundary of no other part of its set.
};

constexpr const char* kMemoryName = "a Minkowski sum";

std::uint64_t memory_of(const std::vector<ConvexPart>& parts) {
  std::uint64_t bytes = 0;
  for (const ConvexPart& part : parts) bytes += sizeof(part) + memory_bytes(part.body);
  return bytes;
}

bool has_mark(const std::vector<Mark>& marks, Mark mark) {
  return std::find(marks.begin(), marks.end(), mark) != marks.end();
}

/// Whether a convex set is its own relative interior.
bool is_relatively_open(const SpaceComplex& c) {
  if (has_mark(c.volume_mark, 1)) {
    return !has_mark(c.facet_mark, 1) && !has_mark(c.edge_mark, 1) && !has_mark(c.vertex_mark, 1);
  }
  if (has_mark(c.facet_mark, 1)) return !has_mark(c.edge_mark, 1) && !has_mark(c.vertex_mark, 1);
  return !has_mark(c.edge_mark, 1) || !has_mark(c.vertex_mark, 1);
}

ConvexBody body_of(const Nef3& convex) { return convex_body_of(convex.closure().complex()); }

/// The relatively open parts of one convex piece: its body and the marked cells of its boundary.
class OpenParts {
 public:
  OpenParts(const Nef3& piece, std::vector<ConvexPart>& parts, Context& context)
      : piece_(piece), c_(piece.complex()), parts_(parts), context_(context) {}

  /// Adds the parts. `is_flat` says that the piece is a facet in the boundary of a body.
  void run(bool is_flat = false) {
    const bool has_body = is_flat || has_mark(c_.volume_mark, 1);
    if (has_body && !is_flat) parts_.push_back({body_of(piece_.interior()), true});
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (c_.facet_mark[f] == 1) add_facet(FacetId(f), !has_body);
    }
    const bool has_facet = has_mark(c_.facet_mark, 1);
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_mark[e] != 1) continue;
      add({point(c_.origin[2 * e]), point(c_.origin[2 * e + 1])}, !has_body && !has_facet);
    }
    const bool has_edge = has_mark(c_.edge_mark, 1);
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.vertex_mark[v] != 1) continue;
      add({point(VertexId(v))}, !has_body && !has_facet && !has_edge);
    }
  }

 private:
  /// Adds the open triangles of a facet and the open diagonals between them. The triangulation
  /// ignores slits, so a facet with a slit is first cut into convex pieces.
  void add_facet(FacetId f, bool is_maximal) {
    if (has_slit(f)) return add_slit_facet(f, is_maximal);
    std::map<std::array<std::uint32_t, 2>, int> times;
    FacetTriangles(c_).for_each(f, [&](VertexId a, VertexId b, VertexId c) {
      add({point(a), point(b), point(c)}, is_maximal);
      for (const auto& [v, w] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
        ++times[{std::min(v, w).value(), std::max(v, w).value()}];
      }
    });
    for (const auto& [ends, count] : times) {
      if (count < 2) continue;
      add({point(VertexId(ends[0])), point(VertexId(ends[1]))}, false);
    }
  }

  bool has_slit(FacetId f) const {
    for (const UseId cycle : c_.cycles_of(f)) {
      UseId u = cycle;
      do {
        const UseId other = c_.use_radial[u];
        if (other != u && c_.use_facet[other] == f) return true;
        u = c_.use_next[u];
      } while (u != cycle);
    }
    return false;
  }

  void add_slit_facet(FacetId f, bool is_maximal) {
    SpaceMarks alone{std::vector<Mark>(c_.vertex_count(), 0), std::vector<Mark>(c_.edge_count(), 0),
                     std::vector<Mark>(c_.facet_count(), 0),
                     std::vector<Mark>(c_.volume_count(), 0)};
    alone.facet[f.value()] = 1;
    for (const Nef3& piece : cut_set({piece_.with_marks(alone, context_), 2}, {}, context_)) {
      OpenParts(piece, parts_, context_).run(!is_maximal);
    }
  }

  void add(const std::vector<RationalPoint3>& points, bool is_maximal) {
    parts_.push_back({convex_body_of(points), is_maximal});
  }
  RationalPoint3 point(VertexId v) const { return exact(c_.points(), c_.vertex_point[v]); }

  const Nef3& piece_;
  const SpaceComplex& c_;
  std::vector<ConvexPart>& parts_;
  Context& context_;
};

std::vector<Nef3> convex_pieces(const Nef3& set, bool closed, Context& context) {
  if (set.is_convex()) return {set};
  return decompose(set, {DecomposeMethod::Best, closed}, context).pieces;
}

/// Decomposes an operand of a sum of closed sets.
std::vector<ConvexPart> closed_parts(const Nef3& set, Context& context) {
  std::vector<ConvexPart> parts;
  for (const Nef3& piece : convex_pieces(set, true, context)) {
    parts.push_back({body_of(piece), true});
  }
  return parts;
}

/// Returns the set with the numbers of its facets as their origins, so that is_wall() is right for
/// the facets of its pieces.
Nef3 with_own_origins(const Nef3& set) {
  SpaceComplex c = set.complex();
  std::iota(c.facet_origin.begin(), c.facet_origin.end(), 0U);
  return Nef3::from_minimal_unchecked(std::move(c));
}

/// An operand of a sum with at least one operand that is not closed, as convex pieces. Pieces with
/// interior points are bodies. The other pieces are relatively open parts.
class OpenOperand {
 public:
  OpenOperand(const Nef3& set, Context& context) : context_(context) {
    const Nef3 hull = set.closure(context);
    for (const Nef3& piece : convex_pieces(with_own_origins(set), false, context)) {
      if (has_mark(piece.complex().volume_mark, 1)) {
        bodies_.emplace_back(piece, hull, context);
        pieces_.push_back(piece);
      } else {
        add_parts(piece, thin_);
      }
    }
  }

  const std::vector<HalfOpenBody>& bodies() const { return bodies_; }
  /// Returns the parts of the pieces without interior points.
  const std::vector<ConvexPart>& thin_parts() const { return thin_; }
  /// Returns the relatively open parts of the bodies.
  std::vector<ConvexPart> parts_of_bodies() const {
    std::vector<ConvexPart> parts;
    for (const Nef3& piece : pieces_) add_parts(piece, parts);
    return parts;
  }

  std::uint64_t bytes() const {
    std::uint64_t bytes = memory_of(thin_);
    for (const HalfOpenBody& body : bodies_) bytes += body.bytes();
    return bytes;
  }

 private:
  void add_parts(const Nef3& piece, std::vector<ConvexPart>& parts) const {
    if (is_relatively_open(piece.complex())) {
      parts.push_back({body_of(piece), true});
    } else {
      OpenParts(piece, parts, context_).run();
    }
  }

  Context& context_;
  std::vector<HalfOpenBody> bodies_;
  std::vector<Nef3> pieces_;  // The piece of each body.
  std::vector<ConvexPart> thin_;
};

/// Decides which pairs matter. A sum with an open operand does not change if the other operand is
/// replaced by a dense part of it. An open body is an open operand.
class PairFilter {
 public:
  PairFilter(const Nef3& a, const Nef3& b) : is_open_{a.is_open(), b.is_open()} {}

  bool needs(const ConvexPart& a, const ConvexPart& b) const {
    if ((is_open_[0] || is_body(a)) && !b.is_maximal) return false;
    return !((is_open_[1] || is_body(b)) && !a.is_maximal);
  }

 private:
  static bool is_body(const ConvexPart& part) {
    return part.body.dimension == 3 && part.is_maximal;
  }

  std::array<bool, 2> is_open_;
};

/// Step 2 of the main flow: the sums of pairs of parts. The class reports one phase for all pairs.
class PairSums {
 public:
  explicit PairSums(Context& context)
      : context_(context),
        quiet_(Context::of_job(context, {}, context.threads(), JobProgress::Silent)),
        memory_(context) {}

  void charge(std::uint64_t bytes) { memory_.add(bytes, kMemoryName); }
  /// States that `count` pairs follow.
  void expect(std::size_t count) { expected_ += count; }
  void begin_pair() { context_.checkpoint("sums of parts", begun_++, expected_); }
  void add(Nef3 sum) {
    sums_.push_back(std::move(sum));
    charge(sums_.back().bytes() + kBytesPerSet);
  }
  Context& quiet() { return quiet_; }
  std::vector<Nef3> take() { return std::move(sums_); }

 private:
  Context& context_;
  Context quiet_;
  MemoryCharge memory_;
  std::vector<Nef3> sums_;
  std::size_t begun_ = 0, expected_ = 0;
};

/// A pair of parts, one of each operand.
using PartPair = std::pair<const ConvexPart*, const ConvexPart*>;

/// Adds the parts of each pair. Each sum depends only on its pair, and the sums have the order of
/// the pairs. Their memory is charged to `charges`.
std::vector<Nef3> sums_of_pairs(std::span<const PartPair> pairs, std::deque<MemoryCharge>& charges,
                                Context& context) {
  // From this number of pairs on, one more thread saves time.
  constexpr std::size_t kLeastPairs = 4;
  std::vector<Nef3> sums(pairs.size());
  const std::size_t ranges = count_ranges(context, pairs.size(), kLeastPairs);
  const std::size_t first = charges.size();
  for (std::size_t i = 0; i < ranges; ++i) charges.emplace_back(context);
  run_ranges(context, pairs.size(), kLeastPairs,
             [&](std::size_t range, std::size_t begin, std::size_t end, Context& own) {
               // Reports one phase for all pairs.
               Context quiet = Context::of_job(own, {}, own.threads(), JobProgress::Silent);
               for (std::size_t i = begin; i < end; ++i) {
                 own.checkpoint("sums of parts", i, pairs.size());
                 sums[i] = convex_sum(pairs[i].first->body, pairs[i].second->body, SumMarks::Closed,
                                      quiet);
                 charges[first + range].add(sums[i].bytes() + kBytesPerSet, kMemoryName);
               }
             });
  return sums;
}

/// The sums of pairs of parts of closed operands. A deque does not move its elements.
std::vector<Nef3> sums_of_closed(const Nef3& a, const Nef3& b, std::deque<MemoryCharge>& charges,
                                 Context& context) {
  WorkPhase phase("convex parts");
  std::array<std::vector<ConvexPart>, 2> parts;
  run_jobs(context, 2,
           [&](std::size_t i, Context& own) { parts[i] = closed_parts(i == 0 ? a : b, own); });
  charges.emplace_back(context).add(memory_of(parts[0]) + memory_of(parts[1]), kMemoryName);
  std::vector<PartPair> pairs;
  for (const ConvexPart& p : parts[0]) {
    for (const ConvexPart& q : parts[1]) pairs.emplace_back(&p, &q);
  }
  phase.next("sums of parts");
  return sums_of_pairs(pairs, charges, context);
}

/// The sums of pairs of parts if at least one operand is not closed.
class OpenSums {
 public:
  OpenSums(const Nef3& a, const Nef3& b, Context& context)
      : filter_(a, b),
        is_open_(a.is_open() || b.is_open()),
        context_(context),
        a_(a, context),
        b_(b, context),
        sums_(context) {}

  std::vector<Nef3> run() {
    sums_.charge(a_.bytes() + b_.bytes());
    add_bodies();
    add_parts(a_.thin_parts(), b_.thin_parts());
    if (!b_.thin_parts().empty()) add_parts(a_.parts_of_bodies(), b_.thin_parts());
    if (!a_.thin_parts().empty()) add_parts(a_.thin_parts(), b_.parts_of_bodies());
    return sums_.take();
  }

 private:
  void add_bodies() {
    sums_.expect(a_.bodies().size() * b_.bodies().size());
    for (const HalfOpenBody& p : a_.bodies()) {
      for (const HalfOpenBody& q : b_.bodies()) {
        sums_.begin_pair();
        if (is_open_) {
          sums_.add(convex_sum(p.body(), q.body(), SumMarks::Open, sums_.quiet()));
        } else {
          add_half_open(p, q);
        }
      }
    }
  }

  void add_half_open(const HalfOpenBody& p, const HalfOpenBody& q) {
    const auto add_faces = [&](BodyFace f, BodyFace g, bool is_parallel) {
      // In nearly all visited pairs of parallel faces, one face has no marked item. Such pairs are
      // skipped.
      if (!p.has_part(f, is_parallel) || !q.has_part(g, is_parallel)) return;
      add_parts(parts_of(p, f, is_parallel), parts_of(q, g, is_parallel));
    };
    sums_.add(half_open_sum(p, q, add_faces, sums_.quiet()));
  }

  /// Returns the marked parts of a face. None of them can be omitted, so all are maximal.
  std::vector<ConvexPart> parts_of(const HalfOpenBody& body, BodyFace face, bool with_boundary) {
    std::vector<ConvexPart> parts;
    const Nef3 marked = body.part(face, with_boundary, sums_.quiet());
    if (!marked.is_empty()) OpenParts(marked, parts, sums_.quiet()).run();
    for (ConvexPart& part : parts) part.is_maximal = true;
    return parts;
  }

  void add_parts(const std::vector<ConvexPart>& a, const std::vector<ConvexPart>& b) {
    MemoryCharge memory(context_);
    memory.add(memory_of(a) + memory_of(b), kMemoryName);
    sums_.expect(a.size() * b.size());
    for (const ConvexPart& p : a) {
      for (const ConvexPart& q : b) {
        sums_.begin_pair();
        if (filter_.needs(p, q)) {
          sums_.add(convex_sum(p.body, q.body, SumMarks::Open, sums_.quiet()));
        }
      }
    }
  }

  PairFilter filter_;
  bool is_open_;
  Context& context_;
  OpenOperand a_, b_;
  PairSums sums_;
};

void require_bounded(const Nef3& set) {
  if (set.is_bounded()) return;
  throw Error(ErrorCode::BadArgument, "a Minkowski sum needs bounded operands");
}

// ---- erosion

AffineMap3 scaling(int factor) {
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) map.matrix[i][i] = factor;
  return map;
}

/// Returns the range of a coordinate over a bounded set that is not empty.
std::array<Rational, 2> range_of(const Nef3& set, std::size_t axis) {
  const SpaceComplex& c = set.complex();
  SpacePoint low = c.vertex_point[0], high = low;
  for (const SpacePoint p : c.vertex_point) {
    if (compare_axis(c.points(), p, low, axis) == Sign::Negative) low = p;
    if (compare_axis(c.points(), p, high, axis) == Sign::Positive) high = p;
  }
  const auto coordinate = [&](SpacePoint p) {
    const RationalPoint3 at = exact(c.points(), p);
    return axis == 0 ? at.x : axis == 1 ? at.y : at.z;
  };
  return {coordinate(low), coordinate(high)};
}

/// Returns a box around A that contains x + B for every x in the box of A - B, with a margin. If A
/// is closed, the box is open, so that the box without A is open. Otherwise, the box is closed.
Nef3 room_around(const Nef3& a, const Nef3& b, Context& context) {
  const Boundary boundary = a.is_closed() ? Boundary::Open : Boundary::Closed;
  std::vector<HalfSpace3> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low_a, high_a] = range_of(a, axis);
    const auto [low_b, high_b] = range_of(b, axis);
    const Rational margin = high_b - low_b + 1;
    for (const int sign : {-1, 1}) {
      std::array<Rational, 3> n;
      n[axis] = sign;
      const Rational at = sign < 0 ? Rational(low_a - margin) : Rational(high_a + margin);
      sides.push_back({{n[0], n[1], n[2], Rational(-sign * at)}, boundary});
    }
  }
  return Nef3::intersection(sides, context);
}

}  // namespace

Nef3 minkowski_sum(const Nef3& a, const Nef3& b, Context& context) {
  if (a.is_empty() || b.is_empty()) return Nef3::empty();
  require_bounded(a);
  require_bounded(b);
  // The memory of the sums stays charged until they are united.
  std::deque<MemoryCharge> charges;
  std::vector<Nef3> sums;
  std::optional<OpenSums> open_sums;
  if (a.is_closed() && b.is_closed()) {
    sums = sums_of_closed(a, b, charges, context);
  } else {
    sums = open_sums.emplace(a, b, context).run();
  }
  const WorkPhase phase("union of the sums");
  return united(std::move(sums), context);
}

Nef3 minkowski_sum(std::span<const Nef3> sets, Context& context) {
  if (std::any_of(sets.begin(), sets.end(), [](const Nef3& set) { return set.is_empty(); })) {
    return Nef3::empty();
  }
  if (sets.empty()) return Nef3::point({0, 0, 0});
  std::vector<Nef3> ordered(sets.begin(), sets.end());
  std::stable_partition(ordered.begin(), ordered.end(),
                        [](const Nef3& set) { return set.is_convex(); });
  Nef3 sum = ordered[0];
  for (std::size_t i = 1; i < ordered.size(); ++i) sum = minkowski_sum(sum, ordered[i], context);
  return sum;
}

Nef3 minkowski_erosion(const Nef3& a, const Nef3& b, Context& context) {
  require_bounded(b);
  if (b.is_empty()) return Nef3::whole();
  const Nef3 mirrored = b.transformed(scaling(-1));
  if (!a.is_bounded()) return !minkowski_sum(!a, mirrored, context);
  if (a.is_empty()) return a;
  // If x + B is contained in A, then x is in the translate of A by minus one point of B. For such
  // x, the set x + B is contained in the box, so the sum with the rest of the box finds all x that
  // are removed.
  const Nef3 lost = minkowski_sum(boolean_op(room_around(a, b, context), a, kDifference, context),
                                  mirrored, context);
  const Nef3 candidates = minkowski_sum(a, mirrored, context);
  return boolean_op(candidates, lost, kDifference, context);
}

}  // namespace plumb
