// The steps of audit() (space_audit.h), and the code that they share. Internal.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "plumb/space/space_audit.h"

namespace plumb {

/// Counts the steps of an audit and calls a checkpoint every 256 steps.
class SpaceAuditSteps {
 public:
  /// Takes the context, to which it keeps a reference, and how many of the five parts of audit()
  /// are done.
  SpaceAuditSteps(Context& context, std::uint64_t part) : context_(context), part_(part) {}

  /// Counts a step.
  void operator()() {
    constexpr std::uint32_t kBetween = 256;  // Exact signs of long numbers take up to 100 us each.
    if (++count_ % kBetween == 0) [[unlikely]]
      checkpoint();
  }
  /// Calls a checkpoint now.
  [[gnu::noinline]] void checkpoint() { context_.checkpoint("audit", part_, 5); }
  /// Returns the context.
  Context& context() { return context_; }

 private:
  Context& context_;
  std::uint64_t part_;
  std::uint32_t count_ = 0;
};

/// What the parts of an audit have in common: the complex, and the first flaw.
class SpaceAuditPart {
 protected:
  SpaceAuditPart(const SpaceComplex& complex, Context& context, std::uint64_t part)
      : c_(complex), step_(context, part) {}

  // The names of cells in reports.
  static std::string name(VertexId v) { return "vertex " + std::to_string(v.value()); }
  static std::string name(EdgeId e) { return "edge " + std::to_string(e.value()); }
  static std::string name(HalfedgeId h) { return "half-edge " + std::to_string(h.value()); }
  static std::string name(UseId u) { return "use " + std::to_string(u.value()); }
  static std::string name(FacetId f) { return "facet " + std::to_string(f.value()); }
  static std::string name(VolumeId v) { return "volume " + std::to_string(v.value()); }

  /// Notes a flaw and returns false.
  bool fail(const char* invariant, std::string place) {
    flaw_ = SpaceFlaw{invariant, std::move(place)};
    return false;
  }
  /// Returns `holds`, and notes a flaw at these cells if it is false.
  template <class... Ids>
  bool require(bool holds, const char* invariant, Ids... ids) {
    return holds || fail_at(invariant, ids...);
  }

  /// Notes a flaw at these cells and returns false. Apart from require(), so that names cost
  /// nothing while all is well.
  template <class... Ids>
  [[gnu::cold, gnu::noinline]] bool fail_at(const char* invariant, Ids... ids) {
    std::string place;
    ((place += (place.empty() ? "" : ", ") + name(ids)), ...);
    return fail(invariant, place.empty() ? "complex" : place);
  }

  /// Returns the place of a vertex.
  SpacePoint at(VertexId v) const { return c_.vertex_point[v]; }
  /// Returns the half-edge of an edge use (Weiler).
  HalfedgeId halfedge(UseId u) const { return c_.use_halfedge[u]; }
  /// Returns the half-edge at which the corner of u ends: the reverse of the previous use.
  HalfedgeId corner_end(UseId u) const { return SpaceComplex::twin(halfedge(c_.use_prev[u])); }
  /// Returns the facet of a use.
  FacetId facet(UseId u) const { return c_.use_facet[u]; }
  /// Returns the plane of a facet.
  PlaneId plane(FacetId f) const { return c_.facet_plane[f]; }
  /// Returns the plane of a use's facet.
  PlaneId plane(UseId u) const { return plane(facet(u)); }
  /// Whether `holds` is true for the ids 0, ..., count - 1; stops at the first for which it is not.
  /// Each counts as a step.
  template <class Id, class Holds>
  bool all_of(std::size_t count, const Holds& holds) const {
    for (std::size_t i = 0; i < count; ++i) {
      step_();
      if (!holds(Id(i))) return false;
    }
    return true;
  }
  /// Whether `visit` is true for all uses of a cycle; stops at the first for which it is not.
  template <class Visit>
  bool all_of_cycle(UseId first, Visit visit) const {
    UseId u = first;
    do {
      step_();
      if (!visit(u)) return false;
      u = c_.use_next[u];
    } while (u != first);
    return true;
  }

  const SpaceComplex& c_;
  mutable SpaceAuditSteps step_;
  std::optional<SpaceFlaw> flaw_;  ///< The first one found.
};

/// Where a point of a facet's plane lies: on an edge (or its end), else inside or outside.
struct FacetPlace {
  bool is_inside = false;  ///< Whether it lies inside, if it is on no edge.
  HalfedgeId on;           ///< The half-edge on which it lies; invalid if on none.
};
/// Returns where a point of the facet's plane lies relative to one cycle: inside if the cycle goes
/// around it an odd number of times. The point is one of the complex, or of a copy of its table
/// with more points. O(length of the cycle).
FacetPlace place_in_cycle(const SpaceComplex& complex, UseId cycle, const Point3Table& points,
                          SpacePoint x, SpaceAuditSteps& step);
/// Returns the same for all cycles of a facet together.
FacetPlace place_in_facet(const SpaceComplex& complex, FacetId f, const Point3Table& points,
                          SpacePoint x, SpaceAuditSteps& step);

/// Checks part 1: arrays, ids and links. Reads nothing that it has not checked.
std::optional<SpaceFlaw> audit_links(const SpaceComplex& complex, Context& context);
/// Checks part 2: points, lines and planes, one cell and its neighbours at a time. `has_fan` is the
/// result of find_fans() (mesh_topology.h).
std::optional<SpaceFlaw> audit_places(const SpaceComplex& complex,
                                      std::span<const std::uint8_t> has_fan, Context& context);
/// Checks part 3: boundary cycles of facets in their planes.
std::optional<SpaceFlaw> audit_cycles(const SpaceComplex& complex, Context& context);
/// Checks part 4: cells meet only in common vertices and edges.
std::optional<SpaceFlaw> audit_meeting(const SpaceComplex& complex,
                                       std::span<const std::uint8_t> has_fan, Context& context);
/// Checks part 5: volumes, the frame and, if `minimal`, the minimal form.
std::optional<SpaceFlaw> audit_marks(const SpaceComplex& complex,
                                     std::span<const std::uint8_t> has_fan, AuditForm form,
                                     Context& context);

}  // namespace plumb
