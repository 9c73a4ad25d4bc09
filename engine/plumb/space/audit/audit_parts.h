// The steps of audit() (space_audit.h). Internal.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "plumb/space/space_audit.h"

namespace plumb {

/// What counts a step of the audit; every some hundred are a checkpoint.
class SpaceAuditSteps {
 public:
  /// `part`: how many of the steps of audit() are done.
  SpaceAuditSteps(Context& context, std::uint64_t part) : context_(context), part_(part) {}

  void operator()() {
    constexpr std::uint32_t kBetween = 256;  // exact signs of long numbers take up to 100 us each
    if (++count_ % kBetween == 0) [[unlikely]]
      checkpoint();
  }
  [[gnu::noinline]] void checkpoint() { context_.checkpoint("audit", part_, 5); }
  Context& context() { return context_; }

 private:
  Context& context_;
  std::uint64_t part_;
  std::uint32_t count_ = 0;
};

/// What the steps have in common: the complex, and the first flaw.
class SpaceAuditPart {
 protected:
  SpaceAuditPart(const SpaceComplex& complex, Context& context, std::uint64_t part)
      : c_(complex), step_(context, part) {}

  static std::string name(VertexId v) { return "vertex " + std::to_string(v.value()); }
  static std::string name(EdgeId e) { return "edge " + std::to_string(e.value()); }
  static std::string name(HalfedgeId h) { return "half-edge " + std::to_string(h.value()); }
  static std::string name(UseId u) { return "use " + std::to_string(u.value()); }
  static std::string name(FacetId f) { return "facet " + std::to_string(f.value()); }
  static std::string name(VolumeId v) { return "volume " + std::to_string(v.value()); }

  /// Notes a flaw; returns false.
  bool fail(const char* invariant, std::string place) {
    flaw_ = SpaceFlaw{invariant, std::move(place)};
    return false;
  }
  template <class... Ids>
  bool require(bool holds, const char* invariant, Ids... ids) {
    return holds || fail_at(invariant, ids...);
  }

  template <class... Ids>
  [[gnu::cold, gnu::noinline]] bool fail_at(const char* invariant, Ids... ids) {
    std::string place;
    ((place += (place.empty() ? "" : ", ") + name(ids)), ...);
    return fail(invariant, place.empty() ? "complex" : place);
  }

  SpacePoint at(VertexId v) const { return c_.vertex_point[v.value()]; }
  HalfedgeId halfedge(UseId u) const { return c_.use_halfedge[u.value()]; }
  /// Against the corner of u: the half-edge where it ends.
  HalfedgeId corner_end(UseId u) const {
    return SpaceComplex::twin(halfedge(c_.use_prev[u.value()]));
  }
  FacetId facet(UseId u) const { return c_.use_facet[u.value()]; }
  PlaneId plane(FacetId f) const { return c_.facet_plane[f.value()]; }
  PlaneId plane(UseId u) const { return plane(facet(u)); }
  /// Does `holds`, asked of 0, 1, ... as ids, for all of so many items? Each is a step.
  template <class Id, class Holds>
  bool all_of(std::size_t count, const Holds& holds) const {
    for (std::size_t i = 0; i < count; ++i) {
      step_();
      if (!holds(Id(i))) return false;
    }
    return true;
  }
  template <class Visit>
  bool all_of_cycle(UseId first, Visit visit) const {
    UseId u = first;
    do {
      step_();
      if (!visit(u)) return false;
      u = c_.use_next[u.value()];
    } while (u != first);
    return true;
  }

  const SpaceComplex& c_;
  mutable SpaceAuditSteps step_;
  std::optional<SpaceFlaw> flaw_;
};

/// Where a point of a facet's plane lies: on an edge (or its end), else inside or outside.
struct FacetPlace {
  bool is_inside = false;
  HalfedgeId on;
};
/// Inside: the cycle goes around x an odd number of times. x: of the complex, or of a copy with
/// more points.
FacetPlace place_in_cycle(const SpaceComplex& complex, UseId cycle, const Point3Table& points,
                          SpacePoint x, SpaceAuditSteps& step);
/// The same, of all cycles of a facet together.
FacetPlace place_in_facet(const SpaceComplex& complex, FacetId f, const Point3Table& points,
                          SpacePoint x, SpaceAuditSteps& step);

std::optional<SpaceFlaw> audit_links(const SpaceComplex& complex, Context& context);
/// has_fan: per vertex (mesh_topology.h).
std::optional<SpaceFlaw> audit_places(const SpaceComplex& complex,
                                      std::span<const std::uint8_t> has_fan, Context& context);
std::optional<SpaceFlaw> audit_cycles(const SpaceComplex& complex, Context& context);
std::optional<SpaceFlaw> audit_meeting(const SpaceComplex& complex,
                                       std::span<const std::uint8_t> has_fan, Context& context);
std::optional<SpaceFlaw> audit_marks(const SpaceComplex& complex,
                                     std::span<const std::uint8_t> has_fan, AuditForm form,
                                     Context& context);

}  // namespace plumb
