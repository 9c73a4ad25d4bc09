// Cuts by planes through reflex edges, for solids (SolidCutter) and for parts of any kind
// (SetCutter).
//
// SolidCutter works on one pool of half-edges (CutSurface) and keeps a stack of pieces. Invariants:
// every piece has a connected surface, and no cut makes a reflex edge; so when no edge is reflex
// the piece is convex. If no plane divides a piece, the piece is stuck, and SetCutter divides it by
// Booleans with half-spaces. Of the points on the plane, the lower half keeps the points in the
// closure of its interior, and the upper half gets the rest. So every point of the set belongs to
// one piece, with its mark.
//
// The greedy rule usually makes fewer pieces, but has no bound. If it makes more than 1 + (r^2 + r)
// / 2 pieces, the solid is cut again with fixed planes, and the result with fewer pieces is kept.
// Proofs: docs/design/walls.md, section Cuts; B. Chazelle, Convex partitions of polyhedra: a lower
// bound and worst-case optimal algorithm, SIAM Journal on Computing 13 (1984).
// Tested by tests/convex/convex_pieces_test.cpp and tests/convex/decompose_property_test.cpp.
#include "plumb/convex/part/cut_set.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "plumb/convex/convexity.h"
#include "plumb/convex/part/choose_plane.h"
#include "plumb/convex/part/merge_parts.h"
#include "plumb/convex/part/surface_cut.h"
#include "plumb/convex/wall/set_parts.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {
namespace {

class SolidCutter {
 public:
  SolidCutter(CutSurface& surface, CutRule rule, Context& context)
      : s_(surface),
        rule_(rule),
        context_(context),
        charge_(context),
        cut_(surface),
        chooser_(surface) {}

  /// Cuts depth first with a stack of pieces, so that only few pieces are incomplete at any time.
  SolidPieces run() {
    std::vector<FaceId> all;
    for (std::size_t f = 0; f < s_.faces.size(); ++f) all.push_back(FaceId(f));
    std::vector<std::vector<FaceId>> left{std::move(all)};
    SolidPieces done;
    // The number of cuts is limited. Every cut reduces the angle at its edge, and few planes
    // contain the edge, so the limit has never been reached.
    std::size_t cuts = 0;
    find_reflex(left[0]);
    done.reflex_edges = reflex_.size();
    if (rule_ == CutRule::Fixed) planes_.emplace(s_, reflex_, context_);
    // The number of faces of the pieces, which every cut increases.
    std::size_t faces_done = 0, faces_left = s_.faces.size();
    const std::size_t most = 64 + 4 * (reflex_.size() + 1) * (reflex_.size() + 1);
    while (!left.empty()) {
      std::vector<FaceId> piece = std::move(left.back());
      left.pop_back();
      context_.checkpoint("cutting", faces_done, faces_done + faces_left);
      faces_left -= piece.size();
      find_reflex(piece);
      if (reflex_.empty()) {
        faces_done += piece.size();
        done.convex.push_back(std::move(piece));
        continue;
      }
      CutPieces parts = cuts++ < most ? cut(piece) : CutPieces();
      charge_growth();
      if (parts.empty()) {
        faces_done += piece.size();
        done.stuck.push_back(std::move(piece));
        continue;
      }
      for (std::size_t i = parts.size(); i-- > 0;) {
        faces_left += parts[i].size();
        left.push_back(std::move(parts[i]));
      }
    }
    return done;
  }

 private:
  /// Charges memory for the growth of the pool, and for the notes of the cuts on each cell.
  void charge_growth() {
    constexpr std::size_t kNotes = 16;
    const std::size_t bytes = s_.halves.capacity() * (sizeof(CutSurface::Half) + kNotes) +
                              s_.faces.capacity() * (sizeof(CutSurface::Face) + kNotes) +
                              s_.point.capacity() * (sizeof(SpacePoint) + kNotes);
    charge_.add(bytes - std::exchange(charged_, bytes), "pieces");
  }

  void find_reflex(std::span<const FaceId> piece) {
    reflex_.clear();
    for (const FaceId f : piece) {
      s_.for_each_half(f, [this](HalfedgeId h) {
        if (s_.half(h).is_reflex && h < s_.half(h).twin) reflex_.push_back(h);
      });
    }
  }

  CutPieces cut(std::span<const FaceId> piece) {
    return rule_ == CutRule::Fixed ? cut_first(piece) : cut_best(piece);
  }

  // Tries candidates until one divides the piece.
  CutPieces cut_best(std::span<const FaceId> piece) {
    for (const CutCandidate& candidate : chooser_.candidates(piece, reflex_)) {
      const PlaneId plane = chooser_.intern(candidate);
      if (!plane.is_valid()) continue;
      CutPieces parts = cut_.run(piece, plane, candidate.seed);
      if (!parts.empty()) return parts;
    }
    return {};
  }

  /// Cuts through the first edge. If a tip obstructs this cut, the edges of the tip are tried
  /// first.
  CutPieces cut_first(std::span<const FaceId> piece) {
    const auto edge = [this](HalfedgeId h) { return s_.half(h).edge; };
    std::ranges::sort(reflex_, {}, edge);
    std::vector<EdgeId> tried;
    HalfedgeId seed = reflex_[0];
    while (seed.is_valid()) {
      CutPieces parts = cut_.run(piece, planes_->plane(edge(seed)), seed);
      if (!parts.empty()) return parts;
      tried.push_back(edge(seed));
      const VertexId tip = cut_.puncture();
      const auto next = std::ranges::find_if(reflex_, [&](HalfedgeId h) {
        const bool is_at = s_.half(h).origin == tip || s_.target(h) == tip;
        return is_at && std::ranges::find(tried, edge(h)) == tried.end();
      });
      seed = next == reflex_.end() ? HalfedgeId() : *next;
    }
    return {};
  }

  CutSurface& s_;
  CutRule rule_;
  Context& context_;
  MemoryCharge charge_;
  std::size_t charged_ = 0;
  PlaneCut cut_;
  CutChooser chooser_;
  std::optional<FixedPlanes> planes_;
  std::vector<HalfedgeId> reflex_;
};

}  // namespace

SolidPieces cut_solid(CutSurface& surface, CutRule rule, Context& context) {
  return SolidCutter(surface, rule, context).run();
}

// Cuts sets that a surface cannot represent, by Booleans with half-spaces.

namespace {

/// Returns the relative interior of a part: its facet or its volume.
Nef3 relative_interior(const SetPart& part, Context& context) {
  if (part.dimension == 3) return part.set.interior();
  const SpaceComplex& c = part.set.complex();
  return part.set.with_marks({std::vector<Mark>(c.vertex_count(), 0),
                              std::vector<Mark>(c.edge_count(), 0), c.facet_mark, c.volume_mark},
                             context);
}

/// Finds a plane that divides a set that is not convex: a plane of a cell that violates convexity.
class DividingPlane {
 public:
  DividingPlane(const SpaceComplex& complex, int dimension, Context& context)
      : c_(complex), dimension_(dimension), context_(context) {}

  /// Returns a plane, or no value if the set only lacks points that are not defined by planes
  /// (plane_through_lone_vertex()).
  std::optional<Plane3> find() {
    if (dimension_ == 3) {
      gather_in_space();
    } else {
      gather_in_plane();
    }
    if (planes_.empty()) gather_vertices();
    if (planes_.empty()) return std::nullopt;
    std::sort(planes_.begin(), planes_.end());
    planes_.erase(std::unique(planes_.begin(), planes_.end()), planes_.end());
    const PlaneId best = best_of(planes_);
    const IntegerRow row = c_.planes().primitive(best);
    return Plane3{Rational(row[0]), Rational(row[1]), Rational(row[2]), Rational(row[3])};
  }

 private:
  /// Every plane of a facet at a reflex edge divides the set. For a free edge, every plane through
  /// its line does.
  void gather_in_space() {
    for (const EdgeId e : reflex_edges(c_)) {
      edges_.push_back(e);
      const UseId first = c_.edge_use[e];
      if (!first.is_valid()) {
        for (const PlaneId p : c_.edge_planes[e]) take(p);
        continue;
      }
      UseId u = first;
      do {
        take(c_.facet_plane[c_.use_facet[u]]);
        u = c_.use_radial[u];
      } while (u != first);
    }
  }

  /// Collects the lines of sides that end in a corner of more than half a turn, or that run into
  /// the facet.
  void gather_in_plane() {
    const FacetId f = marked_facet();
    flat_ = c_.facet_plane[f];
    for (const UseId cycle : c_.cycles_of(f)) {
      UseId u = cycle;
      do {
        const UseId before = c_.use_prev[u];
        const EdgeId e = SpaceComplex::edge_of(c_.use_halfedge[u]);
        const bool is_slit = e == SpaceComplex::edge_of(c_.use_halfedge[before]);
        if (c_.vertex_mark[c_.use_origin(u)] != kBeyond &&
            (is_slit || corner_sign(c_, u) == Sign::Negative)) {
          for (const PlaneId p : c_.edge_planes[e]) take(p);
        }
        u = c_.use_next[u];
      } while (u != cycle);
    }
  }

  /// Collects planes that define a removed point.
  void gather_vertices() {
    for (std::size_t v = 0; v < c_.vertex_count() && planes_.empty(); ++v) {
      if (c_.vertex_mark[v] == kBeyond || !c_.star_of(VertexId(v)).empty()) continue;
      const SpacePoint x = c_.vertex_point[v];
      if (!x.is_input()) {
        const PointSource& source = c_.points().source(x);
        for (std::size_t i = 0; i < source.plane_count(); ++i) take(source.plane(i));
      }
    }
  }

  FacetId marked_facet() const {
    const auto f = std::find(c_.facet_mark.begin(), c_.facet_mark.end(), Mark{1});
    return FacetId(static_cast<std::size_t>(f - c_.facet_mark.begin()));
  }

  void take(PlaneId p) {
    if (p != flat_ && !c_.planes().is_frame(p)) planes_.push_back(p);
  }

  /// Returns the plane that crosses the fewest edges that violate convexity, where edges in the
  /// plane count negatively. If there are many planes, a sample is examined.
  PlaneId best_of(const std::vector<PlaneId>& planes) const {
    constexpr std::size_t kMost = 64, kEdgesPerCheckpoint = 4096;
    PlaneId best;
    std::int64_t best_score = 0;
    const std::size_t step = 1 + planes.size() / kMost;
    for (std::size_t i = 0; i < planes.size(); i += step) {
      std::int64_t score = 0;
      for (std::size_t k = 0; k < edges_.size(); ++k) {
        if (k % kEdgesPerCheckpoint == 0) context_.checkpoint("cutting", 0, 0);
        const EdgeId e = edges_[k];
        const Sign a = side_of_end(2 * e.value(), planes[i]),
                   b = side_of_end(2 * e.value() + 1, planes[i]);
        if (a * b == Sign::Negative) ++score;
        if (a == Sign::Zero && b == Sign::Zero) --score;
      }
      if (!best.is_valid() || score < best_score)
        std::tie(best, best_score) = std::pair(planes[i], score);
    }
    return best;
  }
  Sign side_of_end(std::size_t h, PlaneId p) const {
    return side(c_.points(), c_.vertex_point[c_.origin[h]], p);
  }

  const SpaceComplex& c_;
  int dimension_;
  Context& context_;
  PlaneId flat_;
  std::vector<PlaneId> planes_;
  std::vector<EdgeId> edges_;
};

/// Returns the plane x = c through a lone vertex, or y = c if the set lies in such a plane; no
/// value if no lone vertex is an input point.
std::optional<Plane3> plane_through_lone_vertex(const SetPart& part) {
  const SpaceComplex& c = part.set.complex();
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    if (c.vertex_mark[v] == kBeyond || !c.star_of(VertexId(v)).empty()) continue;
    if (!c.vertex_point[v].is_input()) continue;
    const Point3& at = c.points().planes().point(c.vertex_point[v].input());
    const FacetId f = c.vertex_facet[v];
    const bool is_flat = part.dimension == 2 && f.is_valid() &&
                         minor_sign(c.planes(), c.facet_plane[f], kPlaneX, 1) == Sign::Zero &&
                         minor_sign(c.planes(), c.facet_plane[f], kPlaneX, 2) == Sign::Zero;
    if (is_flat) return Plane3{0, 1, 0, -Rational(at.y)};
    return Plane3{1, 0, 0, -Rational(at.x)};
  }
  return std::nullopt;
}

/// Marks the facets that a half-space made as walls. All facets of the set have ids (decompose()).
Nef3 with_walls_named(const Nef3& cut) {
  const SpaceComplex& c = cut.complex();
  std::vector<std::uint32_t> origins = c.facet_origin;
  for (std::size_t f = 0; f < origins.size(); ++f) {
    if (origins[f] == kNoOrigin && c.facet_mark[f] != kBeyond) origins[f] = kWallOrigin;
  }
  return cut.with_origins(origins);
}

class SetCutter {
 public:
  SetCutter(CutRule rule, const DecomposeOptions& options, Context& context)
      : rule_(rule), options_(options), context_(context), memory_(context) {}

  std::vector<Nef3> run(SetPart part) {
    left_.push_back(std::move(part));
    while (!left_.empty()) {
      context_.checkpoint("cutting", done_.size(), done_.size() + left_.size());
      const SetPart next = std::move(left_.back());
      left_.pop_back();
      if (next.dimension == 3 && cut_as_solid(next)) continue;
      const Nef3 inside = next.dimension < 2 ? Nef3() : relative_interior(next, context_);
      if (next.dimension < 2 || inside.is_convex()) {
        add(next.set);
      } else {
        divide(next, plane_of({inside, next.dimension}));
      }
    }
    if (is_one_solid_) return std::move(done_);
    if (options_.method == DecomposeMethod::Best) merge_sets(done_, context_);
    if (options_.closed) {
      for (Nef3& piece : done_) piece = piece.closure();
    }
    return std::move(done_);
  }

  /// Returns the greatest number of pieces that a solid may have if its surface is a 2-manifold.
  /// For any other set, returns the greatest number of the type.
  std::size_t most() const { return most_; }

 private:
  /// Cuts the part as a solid. Returns false if the part was not cut. If a surface touches itself
  /// along an edge, the result is used only if all pieces are convex. In such a surface, cuts make
  /// separate points in each wedge, so a stuck piece would not know where it touches itself
  /// (touches_itself()).
  bool cut_as_solid(const SetPart& part) {
    MemoryCharge memory(context_);
    memory.add(part.set.bytes(), "the surface of a solid");
    std::optional<CutSurface> surface = cut_surface_of(part.set.complex());
    if (!surface) return false;
    std::vector<FaceId> all;
    for (std::size_t f = 0; f < surface->faces.size(); ++f) all.push_back(FaceId(f));
    const bool touches = touches_itself(*surface, all);
    SolidPieces cut = cut_solid(*surface, rule_, context_);
    if (cut.convex.empty() && cut.stuck.size() == 1) return false;
    if (touches && !cut.stuck.empty()) return false;
    const auto is_no_set = [&](const auto& faces) { return touches_itself(*surface, faces); };
    if (std::ranges::any_of(cut.stuck, is_no_set)) return false;
    if (options_.method == DecomposeMethod::Best) merge_pieces(*surface, cut.convex, context_);
    const bool is_whole = left_.empty() && done_.empty();
    if (is_whole && !touches) most_ = most_pieces(cut.reflex_edges);
    is_one_solid_ = is_whole && cut.stuck.empty();
    for (const auto& faces : cut.convex) {
      add(set_of_piece(*surface, faces, is_one_solid_ && options_.closed, context_));
    }
    for (const auto& faces : cut.stuck) {
      left_.push_back({set_of_piece(*surface, faces, false, context_), 3});
    }
    return true;
  }

  void add(Nef3 piece) {
    memory_.add(bytes_beside_tables(piece), "convex pieces");
    done_.push_back(std::move(piece));
  }

  Plane3 plane_of(const SetPart& inside) {
    std::optional<Plane3> plane =
        DividingPlane(inside.set.complex(), inside.dimension, context_).find();
    if (!plane) plane = plane_through_lone_vertex(inside);
    PLUMB_CHECK(plane.has_value());
    return *plane;
  }

  /// Divides the part by a plane. The lower side keeps the points of the plane that are in the
  /// closure of its interior. The remaining parts of lower dimension in the plane go to the upper
  /// side.
  void divide(const SetPart& part, const Plane3& plane) {
    const auto cut = [&](MarkFunction f) {
      return with_walls_named(boolean_op(part.set, plane, Section::ClosedHalfSpace, f, context_));
    };
    const Nef3 low = cut(kIntersection);
    Nef3 high = cut(kDifference);
    // The pieces use the tables of both halves.
    memory_.add(low.bytes() + high.bytes(), "convex pieces");
    std::vector<SetPart> below = parts_of(low, context_);
    for (const SetPart& p : below) {
      if (p.dimension < part.dimension) high = boolean_op(high, p.set, kUnion, context_);
    }
    std::vector<SetPart> above = parts_of(high, context_);
    std::erase_if(below, [&](const SetPart& p) { return p.dimension < part.dimension; });
    PLUMB_CHECK(!below.empty() && !above.empty());
    std::move(above.rbegin(), above.rend(), std::back_inserter(left_));
    std::move(below.rbegin(), below.rend(), std::back_inserter(left_));
  }

  CutRule rule_;
  const DecomposeOptions options_;
  Context& context_;
  MemoryCharge memory_;
  std::vector<SetPart> left_;
  std::vector<Nef3> done_;
  bool is_one_solid_ = false;
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace

std::vector<Nef3> cut_set(const SetPart& part, const DecomposeOptions& options, Context& context,
                          std::size_t most) {
  SetCutter greedy(CutRule::Greedy, options, context);
  std::vector<Nef3> pieces = greedy.run(part);
  if (pieces.size() <= std::min(most, greedy.most())) return pieces;
  std::vector<Nef3> bounded = SetCutter(CutRule::Fixed, options, context).run(part);
  return bounded.size() < pieces.size() ? bounded : pieces;
}

}  // namespace plumb
