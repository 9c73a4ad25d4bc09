// Choice of the planes that cut pieces. The score of a plane estimates the number of cuts that it
// makes and causes. It counts one cut, or one for each stretch of the section if the plane enters
// the solid on both sides of its edge. It adds one for each reflex edge that the plane divides, and
// subtracts the cuts of the edges that it resolves. Scores are computed in doubles, only from the
// ends of reflex edges, with a tolerance relative to their coordinates. A wrong sign costs at most
// one piece, because the cut itself uses exact signs.
//
// Numbers stay short because a plane is only proposed if it can be written with input data: through
// an input edge and an input vertex, or c1 r1 + c2 r2 with factors |c| <= 16 and the primitive rows
// of the edge's two faces. These faces are never walls (docs/design/walls.md, Lemma 2), so this
// does not compound.
//
// FixedPlanes is the rule of B. Chazelle, SIAM Journal on Computing 13 (1984), with planes that
// avoid tips; its bound is proved in docs/design/walls.md, section Cuts.
// Tested by tests/convex/cut_surface_test.cpp and tests/convex/convex_pieces_test.cpp.
#include "plumb/convex/part/choose_plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/point3_table.h"

namespace plumb {
namespace {

using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

constexpr std::size_t kMostKept = 6;
// If there are more reflex edges, balance is worth additional pieces.
constexpr std::size_t kLarge = 500;
// Balance is worth one piece for so many edges on the smaller side.
constexpr int kWorthOnePiece = 16;
// If a piece has at most so many reflex edges, all its vertices are tried.
constexpr std::size_t kAllVertices = 48;
constexpr int kMostFactor = 16;  // The greatest factor of a pencil.
constexpr double kNearFactor = 1e-9;

}  // namespace

/// The table's rows are multiples of the primitive ones, so the factors of a Pencil are multiplied
/// accordingly; `multiple` returns that multiple of a plane.
PlaneId intern_pencil(PlaneTable& planes, PlaneId p, PlaneId q, std::array<int, 2> c) {
  const auto multiple = [&planes](PlaneId of) -> Integer {
    const IntegerRow row = planes.coefficients(of), primitive = planes.primitive(of);
    const std::size_t i = primitive[0] != 0 ? 0 : primitive[1] != 0 ? 1 : 2;
    return row[i] / primitive[i];
  };
  const OrientedPlane plane = planes.intern(Pencil{p, q, -c[1] * multiple(p), c[0] * multiple(q)});
  return plane.is_valid() ? plane.plane() : PlaneId();
}

/// Returns the index of the vertex in ends_. Appends the vertex if it is new in this search.
std::uint32_t CutChooser::end_of(VertexId v) {
  if (end_stamp_[v] != stamp_) {
    end_stamp_[v] = stamp_;
    end_index_[v] = static_cast<std::uint32_t>(ends_.size());
    ends_.push_back(s_.points().box(s_.point[v]).mid);
    end_vertex_.push_back(v);
  }
  return end_index_[v];
}

void CutChooser::gather(std::span<const FaceId> faces, std::span<const HalfedgeId> reflex) {
  ++stamp_;
  end_stamp_.resize(s_.point.size(), 0);
  end_index_.resize(s_.point.size());
  edges_.clear();
  ends_.clear();
  end_vertex_.clear();
  const auto normal = [this](HalfedgeId h) {
    const OrientedPlane plane = s_.plane_of(h);
    Vector n = s_.planes().row(plane.plane()).n;
    const double scale = (plane.is_opposite() ? -1 : 1) / std::sqrt(dot(n, n));
    for (double& x : n) x *= scale;
    return n;
  };
  for (const HalfedgeId h : reflex) {
    const std::uint32_t a = end_of(s_.half(h).origin);
    const std::uint32_t b = end_of(s_.target(h));
    edges_.push_back({h, a, b, normal(h), normal(s_.half(h).twin)});
  }
  signs_.resize(ends_.size());
  targets_ = end_vertex_;
  if (reflex.size() <= kAllVertices) {
    for (const FaceId f : faces) {
      s_.for_each_half(f, [this](HalfedgeId h) {
        const VertexId v = s_.half(h).origin;
        if (end_stamp_[v] == stamp_) return;
        end_stamp_[v] = stamp_;
        targets_.push_back(v);
      });
    }
  }
  const auto constructed = std::stable_partition(
      targets_.begin(), targets_.end(), [this](VertexId v) { return s_.point[v].is_input(); });
  input_targets_ = static_cast<std::size_t>(constructed - targets_.begin());
  double size = 0;
  for (const Vector& p : ends_) {
    for (const double x : p) size = std::max(size, std::abs(x));
  }
  tolerance_ = size * 1e-11;
}

// Counts the effect of the plane on each reflex edge. A plane that contains an edge makes its cut
// unnecessary, and the cuts of the edges that this cut would have crossed (Edge::alone).
CutCandidate CutChooser::judged(const Row& row, CutCandidate candidate) {
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const double at = row[0] * ends_[i][0] + row[1] * ends_[i][1] + row[2] * ends_[i][2] + row[3];
    signs_[i] = static_cast<signed char>((at > tolerance_ ? 1 : 0) - (at < -tolerance_ ? 1 : 0));
  }
  int spared = 0, below = 0, above = 0;
  for (const Edge& edge : edges_) {
    const signed char a = signs_[edge.a], b = signs_[edge.b];
    if (a * b < 0) ++candidate.crossed;
    below += a + b < 0 ? 1 : 0;
    above += a + b > 0 ? 1 : 0;
    if (a != 0 || b != 0) continue;
    ++candidate.resolved;
    spared += 1 + edge.alone;
  }
  candidate.lesser = std::min(below, above);
  // If the plane enters the solid on both sides of its edges, each stretch of the section between
  // two of them is a cut.
  const int cuts = candidate.sheets == 1 ? 1 : candidate.resolved + 1;
  candidate.score = cuts + candidate.crossed - spared;
  if (edges_.size() > kLarge) candidate.score -= candidate.lesser / kWorthOnePiece;
  return candidate;
}

// Keeps the best kMostKept candidates, sorted.
void CutChooser::keep(const CutCandidate& candidate) {
  const auto is_better = [](const CutCandidate& a, const CutCandidate& b) {
    return std::tuple(a.score, a.sheets, -a.resolved, -a.lesser) <
           std::tuple(b.score, b.sheets, -b.resolved, -b.lesser);
  };
  best_.insert(std::upper_bound(best_.begin(), best_.end(), candidate, is_better), candidate);
  if (best_.size() > kMostKept) best_.pop_back();
}

CutCandidate CutChooser::judged_face(const Edge& edge, bool is_first) {
  const HalfedgeId twin = s_.half(edge.half).twin;
  const PlaneId p = s_.plane_of(is_first ? edge.half : twin).plane();
  const PlaneRow& row = s_.planes().row(p);
  return judged({row.n[0], row.n[1], row.n[2], row.d}, {edge.half, p, {}});
}

void CutChooser::propose_points(const Edge& edge, std::size_t budget) {
  const bool is_input = s_.half(edge.half).line[0].is_valid();
  const std::span<const VertexId> all(targets_);
  const auto propose = [&](std::span<const VertexId> targets, bool by_factors) {
    const std::size_t step = std::max<std::size_t>(1, targets.size() / budget);
    for (std::size_t i = 0; i < targets.size(); i += step) {
      propose_point(edge, targets[i], by_factors);
    }
  };
  const bool is_small = edges_.size() <= kAllVertices;
  if (is_input || is_small) propose(all.first(input_targets_), !is_input);
  if (is_small) propose(all.subspan(input_targets_), true);
}

/// The normal is m = c1 n1 + c2 n2 for the outward normals of the faces. If c1 c2 > 0, both faces
/// are on one side of the plane. The plane then enters the solid on both sides of the edge, which
/// gives two sheets.
void CutChooser::propose_point(const Edge& edge, VertexId target, bool by_factors) {
  const Vector a = ends_[edge.a], along = ends_[edge.b] - a, w = cross(edge.n1, edge.n2);
  const SpacePoint point = s_.point[target];
  const Vector at = s_.points().box(point).mid;
  Vector m = cross(along, at - a);
  const double length = std::sqrt(dot(m, m));
  if (!(length > 0)) return;
  for (double& x : m) x /= length;
  const double c2 = -dot(cross(m, edge.n1), w), c1 = dot(cross(m, edge.n2), w);
  if (std::abs(c1) < 1e-12 || std::abs(c2) < 1e-12) return;  // This is the plane of a face.
  CutCandidate candidate{edge.half, {}, {}, {}, c1 * c2 > 0 ? 2 : 1};
  if (by_factors) {
    const std::optional<std::array<int, 2>> factors = small_factors(edge, at);
    if (!factors) return;
    candidate.pencil = *factors;
  } else {
    candidate.through = point.input();
  }
  keep(judged({m[0], m[1], m[2], -dot(m, a)}, candidate));
}

const CutChooser::Row& CutChooser::primitive(PlaneId p) {
  if (p.value() >= primitive_.size()) primitive_.resize(s_.planes().size());
  Row& row = primitive_[p];
  if (row == Row{}) {
    const IntegerRow exact = s_.planes().primitive(p);
    for (std::size_t i = 0; i < 4; ++i) row[i] = nearest_double(Rational(exact[i]));
  }
  return row;
}

/// The plane through the edge and a point at heights h1, h2 over the planes of its faces has the
/// row h1 r2 - h2 r1.
std::optional<std::array<int, 2>> CutChooser::small_factors(const Edge& edge, const Vector& at) {
  const auto height = [&](HalfedgeId h) {
    const Row& row = primitive(s_.plane_of(h).plane());
    return row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3];
  };
  const double h1 = height(edge.half), h2 = height(s_.half(edge.half).twin);
  const double larger = std::max(std::abs(h1), std::abs(h2));
  for (int q = 1; q <= kMostFactor; ++q) {
    // The larger of the two heights becomes q.
    const double p1 = h1 / larger * q, p2 = h2 / larger * q;
    if (!(std::abs(p1 - std::round(p1)) + std::abs(p2 - std::round(p2)) < kNearFactor)) continue;
    return std::array<int, 2>{-static_cast<int>(std::round(p2)), static_cast<int>(std::round(p1))};
  }
  return std::nullopt;
}

std::span<const CutCandidate> CutChooser::candidates(std::span<const FaceId> faces,
                                                     std::span<const HalfedgeId> reflex) {
  gather(faces, reflex);
  best_.clear();
  // The product of the numbers of candidates and of ends is bounded. The candidates are divided
  // among the seeds, which are distributed evenly over the edges.
  const std::size_t affordable = 60000 / (ends_.size() + 8);
  const std::size_t seeds = std::min(edges_.size(), std::max<std::size_t>(4, affordable / 8));
  const std::size_t budget = std::max<std::size_t>(4, affordable / seeds);
  const bool is_small = edges_.size() <= 2 * kAllVertices;
  for (Edge& edge : edges_) {
    if (!is_small) break;
    edge.alone = std::max(judged_face(edge, true).crossed, judged_face(edge, false).crossed);
  }
  for (std::size_t i = 0; i < (is_small ? edges_.size() : seeds); ++i) {
    const Edge& edge = edges_[is_small ? i : i * edges_.size() / seeds];
    keep(judged_face(edge, true));
    keep(judged_face(edge, false));
  }
  for (std::size_t i = 0; i < seeds; ++i) {
    propose_points(edges_[i * edges_.size() / seeds], budget);
  }
  const HalfedgeId first = edges_[0].half;
  best_.push_back({first, s_.plane_of(first).plane(), {}});
  best_.push_back({first, s_.plane_of(s_.half(first).twin).plane(), {}});
  return best_;
}

PlaneId CutChooser::intern(const CutCandidate& candidate) {
  if (candidate.plane.is_valid()) return candidate.plane;
  if (!candidate.through.is_valid()) {
    return intern_pencil(s_.tables->planes, s_.plane_of(candidate.seed).plane(),
                         s_.plane_of(s_.half(candidate.seed).twin).plane(), candidate.pencil);
  }
  const auto& [a, b] = s_.half(candidate.seed).line;
  const OrientedPlane plane = s_.tables->planes.intern(a, b, candidate.through);
  return plane.is_valid() ? plane.plane() : PlaneId();
}

FixedPlanes::FixedPlanes(CutSurface& surface, std::span<const HalfedgeId> reflex, Context& context)
    : s_(surface) {
  find_tips(reflex);
  for (std::size_t i = 0; i < reflex.size(); ++i) {
    context.checkpoint("choosing planes", i, reflex.size());
    const HalfedgeId h = reflex[i];
    const std::size_t e = s_.half(h).edge.value();
    if (plane_.size() <= e) plane_.resize(e + 1);
    plane_[e] = choose(h);
  }
}

void FixedPlanes::find_tips(std::span<const HalfedgeId> reflex) {
  for (const HalfedgeId h : reflex) {
    const VertexId a = s_.half(h).origin, b = s_.target(h);
    spokes_.push_back({a, b});
    spokes_.push_back({b, a});
  }
  std::sort(spokes_.begin(), spokes_.end());
  const auto is_alone = [this](std::size_t i) {
    const bool is_first = i == 0 || spokes_[i - 1][0] != spokes_[i][0];
    return is_first && (i + 1 == spokes_.size() || spokes_[i + 1][0] != spokes_[i][0]);
  };
  std::vector<std::array<VertexId, 2>> shared;
  for (std::size_t i = 0; i < spokes_.size(); ++i) {
    if (!is_alone(i)) shared.push_back(spokes_[i]);
  }
  spokes_ = std::move(shared);
}

Sign FixedPlanes::side_of(VertexId v, PlaneId p) const { return side(s_.points(), s_.point[v], p); }

/// Whether all edges of some tip in p lead to the same side of p. Tips on the line are not tested.
bool FixedPlanes::may_touch(PlaneId p, std::array<PlaneId, 2> line) const {
  for (std::size_t i = 0; i < spokes_.size();) {
    const VertexId tip = spokes_[i][0];
    std::size_t end = i;
    while (end < spokes_.size() && spokes_[end][0] == tip) ++end;
    const auto is_on = [&](PlaneId q) { return side_of(tip, q) == Sign::Zero; };
    if (is_on(p) && !(is_on(line[0]) && is_on(line[1]))) {
      const Sign first = side_of(spokes_[i][1], p);
      bool is_one_side = first != Sign::Zero;
      for (std::size_t k = i + 1; k < end && is_one_side; ++k) {
        is_one_side = side_of(spokes_[k][1], p) == first;
      }
      if (is_one_side) return true;
    }
    i = end;
  }
  return false;
}

PlaneId FixedPlanes::choose(HalfedgeId h) {
  const PlaneId p = s_.plane_of(h).plane(), q = s_.plane_of(s_.half(h).twin).plane();
  if (p == q || !may_touch(p, {p, q})) return p;
  return may_touch(q, {p, q}) ? choose_between(h) : q;
}

/// Tries m = c n1 - (sum - c) n2, n1 and n2 outward and factors coprime, in the order of their
/// sums. Factors of opposite signs put one face on either side of the plane, so it enters the solid
/// on one side of the edge. The loop ends: every tip off the line rules out one plane of the pencil
/// at most.
PlaneId FixedPlanes::choose_between(HalfedgeId h) {
  const OrientedPlane p = s_.plane_of(h), q = s_.plane_of(s_.half(h).twin);
  for (int sum = 2;; ++sum) {
    for (int c = 1; c < sum; ++c) {
      if (std::gcd(c, sum) != 1) continue;
      const PlaneId between =
          intern_pencil(s_.tables->planes, p.plane(), q.plane(),
                        {p.is_opposite() ? -c : c, q.is_opposite() ? sum - c : c - sum});
      if (between.is_valid() && !may_touch(between, {p.plane(), q.plane()})) return between;
    }
  }
}

}  // namespace plumb
