// The minimal form of a marked map on the sphere.
//
// Which arcs are dropped does not depend on the order, because it depends on the marks of the old
// faces, which are equal where faces are joined. Then each point is judged by the half-arcs that it
// keeps. Arcs between dropped points form chains, each of which becomes one arc, or a loop if it is
// closed. No sign is computed, because two kept half-arcs of one circle that leave the same point
// are opposite. Source: docs/design/sphere.md, Minimal form; docs/design/boolean.md, Lemma 2.
//
// Tested by tests/sphere/sphere_overlay_test.cpp.

#include "plumb/sphere/overlay/sphere_simplify.h"

#include <algorithm>
#include <numeric>

namespace plumb {

/// Returns the least face of those that were joined with the given face.
std::uint32_t SphereSimplifier::find(std::uint32_t face) {
  while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
  return face;
}

bool SphereSimplifier::drop_arcs(const SphereMap& in) {
  parent_.resize(in.face_count());
  std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  is_kept_.assign(in.arc_count(), 1);
  bool changed = false;
  for (std::size_t a = 0; a < in.arc_count(); ++a) {
    const std::uint32_t left = in.face[2 * a];
    const std::uint32_t right = in.face[2 * a + 1];
    if (in.arc_mark[a] != in.face_mark[left] || in.arc_mark[a] != in.face_mark[right]) continue;
    is_kept_[a] = 0;
    changed = true;
    const std::uint32_t f = find(left);
    const std::uint32_t g = find(right);
    parent_[std::max(f, g)] = std::min(f, g);
  }
  return changed;
}

/// Sets kept_here_ to the kept half-arcs that leave a point, clockwise.
void SphereSimplifier::collect_kept(const SphereMap& in, std::uint32_t v) {
  kept_here_.clear();
  const std::uint32_t first = in.first_out[v];
  if (first == kNone) return;
  std::uint32_t h = first;
  do {
    if (is_kept_[h / 2] != 0) kept_here_.push_back(h);
    h = in.clockwise(h);
  } while (h != first);
}

/// Whether a point can be merged into the arc or the face around it. Reads kept_here_.
bool SphereSimplifier::is_mere(const SphereMap& in, std::uint32_t v) {
  const Mark mark = in.point_mark[v];
  if (kept_here_.empty()) {
    const std::uint32_t h = in.first_out[v];
    return in.face_mark[h == kNone ? in.point_face[v] : in.face[h]] == mark;
  }
  if (kept_here_.size() != 2) return false;
  const std::uint32_t a = kept_here_[0] / 2;
  const std::uint32_t b = kept_here_[1] / 2;
  return in.circle[a] == in.circle[b] && in.arc_mark[a] == mark && in.arc_mark[b] == mark;
}

/// At a dropped point between two arcs, the arc that arrives continues in the arc that leaves
/// forward.
bool SphereSimplifier::judge_points(const SphereMap& in) {
  new_point_.assign(in.point_count(), kNone);
  goes_on_.assign(in.arc_count(), kNone);
  old_point_.clear();
  for (std::uint32_t v = 0; v < in.point_count(); ++v) {
    collect_kept(in, v);
    if (!is_mere(in, v)) {
      new_point_[v] = static_cast<std::uint32_t>(old_point_.size());
      old_point_.push_back(v);
    } else if (!kept_here_.empty()) {
      const bool first_goes_on = (kept_here_[0] & 1U) == 0;
      const std::uint32_t on = kept_here_[first_goes_on ? 0 : 1] / 2;
      goes_on_[kept_here_[first_goes_on ? 1 : 0] / 2] = on;
    }
  }
  return old_point_.size() != in.point_count();
}

void SphereSimplifier::place_points(const SphereMap& in, SphereMap& out) {
  for (const std::uint32_t v : old_point_) {
    out.direction.push_back(in.direction[v]);
    out.point_mark.push_back(in.point_mark[v]);
    out.first_out.push_back(kNone);
    out.point_face.push_back(kNone);
  }
}

/// Adds the arc or loop that a chain becomes, with the circle and mark of its first arc.
void SphereSimplifier::add_chain(const SphereMap& in, std::uint32_t first, SphereMap& out) {
  std::uint32_t last = first;
  is_chained_[first] = 1;
  while (goes_on_[last] != kNone && goes_on_[last] != first) {
    last = goes_on_[last];
    is_chained_[last] = 1;
  }
  const auto a = static_cast<std::uint32_t>(out.arc_count());
  const std::uint32_t from = in.origin[2 * first];
  const std::uint32_t to = in.origin[2 * last + 1];
  out.circle.push_back(in.circle[first]);
  out.arc_mark.push_back(in.arc_mark[first]);
  for (const std::uint32_t v : {from, to}) out.origin.push_back(v == kNone ? kNone : new_point_[v]);
  for (const std::uint32_t h : {2 * first, 2 * first + 1}) out.face.push_back(in.face[h]);
  out.next.push_back(2 * a);
  out.next.push_back(2 * a + 1);
  new_half_[2 * first] = 2 * a;
  new_half_[2 * last + 1] = 2 * a + 1;
  old_arc_.push_back(first);
}

/// Chains begin at points that are kept. The remaining arcs form closed chains, which become loops.
void SphereSimplifier::chain_arcs(const SphereMap& in, SphereMap& out) {
  old_arc_.clear();
  is_chained_.assign(in.arc_count(), 0);
  new_half_.assign(2 * in.arc_count(), kNone);
  for (std::uint32_t a = 0; a < in.arc_count(); ++a) {
    const std::uint32_t from = in.origin[2 * a];
    if (is_kept_[a] != 0 && (from == kNone || new_point_[from] != kNone)) add_chain(in, a, out);
  }
  for (std::uint32_t a = 0; a < in.arc_count(); ++a) {
    if (is_kept_[a] != 0 && is_chained_[a] == 0) add_chain(in, a, out);
  }
}

void SphereSimplifier::link_points(const SphereMap& in, SphereMap& out) {
  for (std::size_t i = 0; i < old_point_.size(); ++i) {
    const std::uint32_t v = old_point_[i];
    collect_kept(in, v);
    if (kept_here_.empty()) {
      const std::uint32_t h = in.first_out[v];
      out.point_face[i] = h == kNone ? in.point_face[v] : in.face[h];
      continue;
    }
    out.first_out[i] = new_half_[kept_here_[0]];
    for (std::size_t k = 0; k < kept_here_.size(); ++k) {
      const std::uint32_t h = new_half_[kept_here_[k]];
      out.next[SphereMap::twin(h)] = new_half_[kept_here_[k + 1 < kept_here_.size() ? k + 1 : 0]];
    }
  }
}

/// Replaces the numbers of old faces in out.face and out.point_face by the numbers of new faces.
void SphereSimplifier::number_faces(const SphereMap& in, SphereMap& out) {
  new_face_.resize(in.face_count());
  old_face_.clear();
  for (std::uint32_t f = 0; f < in.face_count(); ++f) {
    if (find(f) != f) {
      new_face_[f] = new_face_[find(f)];  // The least face of the class was numbered before.
      continue;
    }
    new_face_[f] = static_cast<std::uint32_t>(old_face_.size());
    old_face_.push_back(f);
    out.face_mark.push_back(in.face_mark[f]);
  }
  for (std::uint32_t& f : out.face) f = new_face_[f];
  for (std::uint32_t& f : out.point_face) {
    if (f != kNone) f = new_face_[f];
  }
}

bool SphereSimplifier::run(const SphereMap& in, SphereMap& out) {
  const bool drops_arcs = drop_arcs(in);
  const bool drops_points = judge_points(in);
  if (!drops_arcs && !drops_points) return false;
  out.clear();
  out.centre_mark = in.centre_mark;
  place_points(in, out);
  chain_arcs(in, out);
  link_points(in, out);
  number_faces(in, out);
  return true;
}

}  // namespace plumb
