#include <algorithm>
#include <optional>
#include <utility>

#include "plumb/convex/choose_plane.h"
#include "plumb/convex/cuts.h"
#include "plumb/convex/fixed_planes.h"
#include "plumb/convex/plane_cut.h"

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

  SolidPieces run() {
    std::vector<FaceId> all;
    for (std::size_t f = 0; f < s_.faces.size(); ++f) all.push_back(FaceId(f));
    std::vector<std::vector<FaceId>> left{std::move(all)};
    SolidPieces done;
    // Every cut takes from the angle at its edge, and planes through it are few; never seen to be many.
    std::size_t cuts = 0;
    find_reflex(left[0]);
    done.reflex_edges = reflex_.size();
    if (rule_ == CutRule::Fixed) planes_.emplace(s_, reflex_, context_);
    std::size_t faces_done = 0, faces_left = s_.faces.size();  // of pieces: more at every cut
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
  /// Of the pool, and of what cuts note for each of its items.
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

  CutPieces cut_best(std::span<const FaceId> piece) {
    for (const CutCandidate& candidate : chooser_.candidates(piece, reflex_)) {
      const PlaneId plane = chooser_.intern(candidate);
      if (!plane.is_valid()) continue;
      CutPieces parts = cut_.run(piece, plane, candidate.seed);
      if (!parts.empty()) return parts;
    }
    return {};
  }

  /// Where a tip is in the way, its edges first.
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

}  // namespace plumb
