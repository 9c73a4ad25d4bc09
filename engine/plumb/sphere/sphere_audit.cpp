// The audit of a sphere map: whether arrays, planes, links, geometry and faces satisfy the
// invariants that sphere_audit.h lists.
//
// Checks run from cheap to expensive, and each check relies on the checks before it: sizes, ids,
// planes, links, the order around points by signs, meetings away from points by an overlay of the
// map with itself, faces, minimal form. Links alone do not prove the faces of a map that is not
// connected. Euler's formula on the sphere, V - E + F = 1 + parts, gives the number of faces, and
// the links between parts (SphereParts) say which cycles must share one; docs/design/sphere.md,
// Lemmas 2 and 3.
//
// Tested by tests/sphere/nef_sphere_test.cpp and tests/sphere/sphere_locator_test.cpp.

#include "plumb/sphere/sphere_audit.h"

#include <set>
#include <string>
#include <vector>

#include "plumb/predicates/plane_signs.h"
#include "plumb/sphere/arcs/sphere_arcs.h"
#include "plumb/sphere/overlay/sphere_contacts.h"
#include "plumb/sphere/overlay/sphere_simplify.h"

namespace plumb {
namespace {

/// One audit, which keeps the first flaw that it finds.
class SphereAudit {
 public:
  SphereAudit(const PlaneTable& planes, const SphereMap& map) : planes_(planes), map_(map) {}

  std::optional<DcelFlaw> run(AuditForm form) {
    const bool holds = has_right_sizes() && has_ids_in_range() && has_right_planes() &&
                       is_linked() && turns_clockwise() && meets_at_points() &&
                       bounds_right_faces() && (form == AuditForm::Any || is_minimal());
    return holds ? std::nullopt : std::optional<DcelFlaw>(flaw_);
  }

 private:
  bool require(bool holds, const char* invariant, const std::string& place) {
    if (!holds) flaw_ = DcelFlaw{invariant, place};
    return holds;
  }
  bool require_at(bool holds, const char* invariant, const char* kind, std::size_t index) {
    return require(holds, invariant, holds ? "" : kind + std::to_string(index));
  }

  bool has_right_sizes();
  bool has_ids_in_range();
  bool has_right_planes();
  bool is_linked();
  bool has_one_ring(std::uint32_t v, std::size_t& seen);
  bool turns_clockwise();
  bool turns_clockwise(std::uint32_t v);
  bool meets_at_points();
  bool bounds_right_faces();
  bool is_minimal();

  std::uint32_t face_of(SphereSlot slot) const {
    return slot.half_arc != kNone ? map_.face[slot.half_arc] : map_.point_face[slot.point];
  }

  const PlaneTable& planes_;
  const SphereMap& map_;
  DcelFlaw flaw_;
};

bool SphereAudit::has_right_sizes() {
  const std::size_t points = map_.point_count();
  const std::size_t arcs = map_.arc_count();
  return require(map_.point_mark.size() == points && map_.first_out.size() == points &&
                     map_.point_face.size() == points,
                 "arrays of points have one size", "map") &&
         require(map_.arc_mark.size() == arcs && map_.origin.size() == 2 * arcs &&
                     map_.next.size() == 2 * arcs && map_.face.size() == 2 * arcs,
                 "arrays of arcs have one size, those of half-arcs twice that", "map") &&
         require(map_.face_count() > 0, "there is a face", "map");
}

bool SphereAudit::has_ids_in_range() {
  const auto is_mark = [](Mark m) { return m <= kBeyond; };
  bool holds = require(is_mark(map_.centre_mark), "marks are 0, 1 or beyond", "centre");
  for (std::size_t f = 0; f < map_.face_count() && holds; ++f) {
    holds = require_at(is_mark(map_.face_mark[f]), "marks are 0, 1 or beyond", "face ", f);
  }
  for (std::size_t v = 0; v < map_.point_count() && holds; ++v) {
    const auto& [p, q] = map_.direction[v];
    const bool is_isolated = map_.first_out[v] == kNone;
    holds = require_at(is_mark(map_.point_mark[v]), "marks are 0, 1 or beyond", "point ", v) &&
            require_at(p.value() < planes_.size() && q.value() < planes_.size(),
                       "a direction is of planes there are", "point ", v) &&
            require_at(is_isolated
                           ? map_.point_face[v] < map_.face_count()
                           : map_.first_out[v] < map_.origin.size() && map_.point_face[v] == kNone,
                       "a point has a half-arc there is, or a face there is", "point ", v);
  }
  for (std::size_t a = 0; a < map_.arc_count() && holds; ++a) {
    holds = require_at(is_mark(map_.arc_mark[a]), "marks are 0, 1 or beyond", "arc ", a) &&
            require_at(map_.circle[a].value() < planes_.size(), "a circle is a plane there is",
                       "arc ", a) &&
            require_at((map_.origin[2 * a] == kNone) == (map_.origin[2 * a + 1] == kNone),
                       "a loop has no point, another arc two", "arc ", a);
  }
  for (std::size_t h = 0; h < map_.origin.size() && holds; ++h) {
    const std::uint32_t v = map_.origin[h];
    holds = require_at((v == kNone || v < map_.point_count()) &&
                           map_.next[h] < map_.origin.size() && map_.face[h] < map_.face_count(),
                       "a half-arc names a point, a half-arc and a face there are", "half-arc ", h);
  }
  return holds;
}

/// Compares normals exactly, because all other checks assume that different ids have different
/// normals.
bool SphereAudit::has_right_planes() {
  std::set<PlaneId> used(map_.circle.begin(), map_.circle.end());
  for (std::size_t v = 0; v < map_.point_count(); ++v) {
    const auto& [p, q] = map_.direction[v];
    used.insert(p);
    used.insert(q);
    bool is_direction = false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (minor_sign(planes_, p, q, i) != Sign::Zero) is_direction = true;
    }
    if (!require_at(is_direction, "a direction is of two planes that cross", "point ", v)) {
      return false;
    }
  }
  std::set<IntegerRow> normals;
  for (const PlaneId c : used) {
    const IntegerRow row = planes_.coefficients(c);
    const IntegerRow normal = primitive(IntegerRow{row[0], row[1], row[2], 0});
    if (!require_at(normals.insert(normal).second, "different planes have different normals",
                    "plane ", c.value())) {
      return false;
    }
  }
  return true;
}

/// Goes around the half-arcs of a point. The walk ends after as many half-arcs as the whole map
/// has, so broken links cannot make it endless.
bool SphereAudit::has_one_ring(std::uint32_t v, std::size_t& seen) {
  std::uint32_t h = map_.first_out[v];
  if (h == kNone) return true;
  do {
    if (!require_at(map_.origin[h] == v && seen < map_.origin.size(),
                    "half-arcs around a point leave it", "point ", v)) {
      return false;
    }
    ++seen;
    h = map_.clockwise(h);
  } while (h != map_.first_out[v]);
  return true;
}

/// If next is a permutation that keeps points and faces, the half-arcs of each point lie in one
/// ring if and only if the rings that start at first_out contain all half-arcs.
bool SphereAudit::is_linked() {
  std::size_t seen = 0;
  std::vector<std::uint8_t> follows(map_.next.size(), 0);
  for (std::uint32_t h = 0; h < map_.next.size(); ++h) {
    const std::uint32_t n = map_.next[h];
    if (!require_at(map_.origin[n] == map_.target(h), "half-arcs follow each other", "half-arc ",
                    h) ||
        !require_at(map_.origin[h] != kNone || n == h, "a loop follows itself", "half-arc ", h) ||
        !require_at(map_.face[n] == map_.face[h], "a boundary has one face", "half-arc ", h) ||
        !require_at(follows[n] == 0, "each half-arc follows one", "half-arc ", n)) {
      return false;
    }
    follows[n] = 1;
    if (map_.origin[h] == kNone) ++seen;
  }
  for (std::uint32_t v = 0; v < map_.point_count(); ++v) {
    if (!has_one_ring(v, seen)) return false;
  }
  return require(seen == map_.origin.size(), "one ring of half-arcs around each point", "map");
}

/// Seen from the first half-arc, each half-arc of the clockwise order must precede the one before
/// it in the counter-clockwise order.
bool SphereAudit::turns_clockwise(std::uint32_t v) {
  const std::uint32_t first = map_.first_out[v];
  if (first == kNone) return true;
  const SphereDirection u = map_.direction[v];
  std::uint32_t h = first;
  do {
    if (!require_at(side_of(planes_, u, map_.circle[h / 2]) == Sign::Zero,
                    "a point lies on the circles of its arcs", "point ", v)) {
      return false;
    }
    h = map_.clockwise(h);
  } while (h != first);
  const OrientedPlane from = heading_of(map_, first);
  for (std::uint32_t g = map_.clockwise(first); g != first; g = map_.clockwise(g)) {
    const std::uint32_t later = map_.clockwise(g);
    const OrientedPlane heading = heading_of(map_, g);
    const bool turns =
        heading != from &&
        (later == first || is_before_at(planes_, u, from, heading_of(map_, later), heading));
    if (!require_at(turns, "half-arcs leave a point clockwise", "point ", v)) return false;
  }
  return true;
}

bool SphereAudit::turns_clockwise() {
  for (std::uint32_t v = 0; v < map_.point_count(); ++v) {
    if (!turns_clockwise(v)) return false;
  }
  return true;
}

/// In the overlay of the map with itself, a map whose arcs meet only at points has no contacts
/// other than these points.
bool SphereAudit::meets_at_points() {
  SphereContacts contacts;
  contacts.find(planes_, map_, map_);
  for (std::uint32_t v = 0; v < map_.point_count(); ++v) {
    if (!require_at(contacts.point_of[1][v] == v, "points are different", "point ", v)) {
      return false;
    }
  }
  for (const SphereContacts::Stop& stop : contacts.stops[0]) {
    if (!require_at(false, "arcs meet at points only", "arc ", stop.arc)) return false;
  }
  std::size_t loops = 0;
  for (std::uint32_t a = 0; a < map_.arc_count(); ++a) {
    if (map_.is_loop(a)) ++loops;
  }
  return require(loops <= 1, "there is at most one loop", "map");
}

/// On a sphere, V - E + F = 1 + parts, where a loop counts as a point and an arc. If the number of
/// faces satisfies this formula, each face is used, and both ends of each link have the same face,
/// then the faces are the classes of linked cycles.
bool SphereAudit::bounds_right_faces() {
  std::vector<std::uint8_t> is_used(map_.face_count(), 0);
  std::size_t loops = 0;
  for (std::uint32_t h = 0; h < map_.face.size(); ++h) {
    is_used[map_.face[h]] = 1;
    if (map_.origin[h] == kNone) ++loops;
  }
  for (const std::uint32_t f : map_.point_face) {
    if (f != kNone) is_used[f] = 1;
  }
  if (map_.point_count() + map_.arc_count() == 0) is_used[0] = 1;
  for (std::size_t f = 0; f < is_used.size(); ++f) {
    if (!require_at(is_used[f] != 0, "a face has a boundary", "face ", f)) return false;
  }
  SphereParts parts;
  parts.find(planes_, map_);
  for (const SphereParts::Link& l : parts.links()) {
    if (!require_at(face_of(l.first) == face_of(l.second), "boundaries of one face name it",
                    "face ", face_of(l.first))) {
      return false;
    }
  }
  return require(
      map_.point_count() + loops / 2 + map_.face_count() == map_.arc_count() + 1 + parts.count(),
      "there are as many faces as cycles and parts make", "map");
}

bool SphereAudit::is_minimal() {
  SphereMap smaller;
  return require(!SphereSimplifier().run(map_, smaller), "the map is minimal", "map");
}

}  // namespace

std::optional<DcelFlaw> audit(const PlaneTable& planes, const SphereMap& map, AuditForm form) {
  return SphereAudit(planes, map).run(form);
}

}  // namespace plumb
