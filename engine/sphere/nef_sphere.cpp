#include "plumb/sphere/nef_sphere.h"

#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/sphere/sphere_simplify.h"
#include "plumb/sphere/sphere_vectors.h"

namespace plumb {

struct NefSphere::State {
  std::shared_ptr<const PlaneTable> planes;
  SphereMap map;
};

namespace {

constexpr std::uint32_t kNone = SphereMap::kNone;

NefSphere one_face(Mark mark) {
  static const auto no_planes = std::make_shared<const PlaneTable>();
  SphereMap map;
  map.face_mark.assign(1, mark);
  return NefSphere::from_minimal(no_planes, std::move(map));
}

NefSphere simplified(std::shared_ptr<const PlaneTable> planes, SphereMap map) {
  SphereMap minimal;
  const bool changed = SphereSimplifier().run(map, minimal);
  return NefSphere::from_minimal(std::move(planes), std::move(changed ? minimal : map));
}

void flip(std::vector<Mark>& marks) {
  for (Mark& m : marks) m = m == 0 ? 1 : 0;
}

/// Of each item the marks of all that is around it, combined.
template <class Combine>
SphereItemMarks neighbourhood_marks(const SphereMap& map, Combine combine) {
  SphereItemMarks marks{map.point_mark, map.arc_mark, map.face_mark};
  for (std::size_t a = 0; a < map.arc_count(); ++a) {
    marks.arc[a] = combine(
        marks.arc[a], combine(map.face_mark[map.face[2 * a]], map.face_mark[map.face[2 * a + 1]]));
  }
  for (std::size_t v = 0; v < map.point_count(); ++v) {
    const std::uint32_t first = map.first_out[v];
    if (first == kNone) {
      marks.point[v] = combine(marks.point[v], map.face_mark[map.point_face[v]]);
      continue;
    }
    std::uint32_t h = first;
    do {  // the new marks of arcs hold those of the faces beside them
      marks.point[v] = combine(marks.point[v], marks.arc[h / 2]);
      h = map.clockwise(h);
    } while (h != first);
  }
  return marks;
}

SphereItemMarks interior_marks(const SphereMap& map) {
  return neighbourhood_marks(map, [](Mark a, Mark b) -> Mark { return a != 0 && b != 0 ? 1 : 0; });
}
SphereItemMarks closure_marks(const SphereMap& map) {
  return neighbourhood_marks(map, [](Mark a, Mark b) -> Mark { return a != 0 || b != 0 ? 1 : 0; });
}

bool are_marks_of(const SphereMap& map, const SphereItemMarks& marks) {
  return marks.point == map.point_mark && marks.arc == map.arc_mark && marks.face == map.face_mark;
}

void take_off(std::vector<Mark>& from, const std::vector<Mark>& what) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (what[i] != 0) from[i] = 0;
  }
}

bool is_one_face(const SphereMap& map, Mark mark) {
  return map.point_count() == 0 && map.arc_count() == 0 && map.face_mark[0] == mark;
}

}  // namespace

SphereFaceBoundary face_boundary(const SphereMap& map, std::uint32_t face) try {
  SphereFaceBoundary boundary;
  std::vector<std::uint8_t> is_walked(map.next.size(), 0);
  for (std::uint32_t first = 0; first < map.next.size(); ++first) {
    if (map.face[first] != face || is_walked[first] != 0) continue;
    boundary.half_arcs.push_back(first);
    for (std::uint32_t h = first; is_walked[h] == 0; h = map.next[h]) is_walked[h] = 1;
  }
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (map.point_face[v] == face) boundary.points.push_back(v);
  }
  return boundary;
} catch (...) {
  rethrow_refused_memory();
}

// ---------------------------------------------------------------- sets and what they hold

NefSphere::NefSphere() try : NefSphere(empty()) {
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::empty() try {
  static const NefSphere none = one_face(0);
  return none;
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::sphere() try {
  static const NefSphere all = one_face(1);
  return all;
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::from_minimal(std::shared_ptr<const PlaneTable> planes, SphereMap map) try {
  return NefSphere(std::make_shared<const State>(State{std::move(planes), std::move(map)}));
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::from_map(const PlaneTable& planes, const SphereMap& map) try {
  if (const auto flaw = plumb::audit(planes, map, false)) {
    throw Error(ErrorCode::BadArgument,
                "not a map of the sphere: " + flaw->invariant + ", " + flaw->place);
  }
  SphereMap own = map;
  own.centre_mark = 0;
  for (auto* marks : {&own.point_mark, &own.arc_mark, &own.face_mark}) {
    for (Mark& m : *marks) m = m == 1 ? 1 : 0;
  }
  std::shared_ptr<const PlaneTable> table = centred(planes, own);
  return simplified(std::move(table), std::move(own));
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::with_marks(SphereItemMarks marks) const try {
  if (marks.point.size() != map().point_count() || marks.arc.size() != map().arc_count() ||
      marks.face.size() != map().face_count()) {
    throw Error(ErrorCode::BadArgument, "one mark is needed for each point, arc and face");
  }
  SphereMap changed = map();
  changed.point_mark = std::move(marks.point);
  changed.arc_mark = std::move(marks.arc);
  changed.face_mark = std::move(marks.face);
  for (auto* some : {&changed.point_mark, &changed.arc_mark, &changed.face_mark}) {
    for (Mark& m : *some) m = m != 0 ? 1 : 0;
  }
  return simplified(state_->planes, std::move(changed));
} catch (...) {
  rethrow_refused_memory();
}

const SphereMap& NefSphere::map() const { return state_->map; }
const std::shared_ptr<const PlaneTable>& NefSphere::shared_planes() const { return state_->planes; }

SphereItemMarks NefSphere::marks() const try {
  return {map().point_mark, map().arc_mark, map().face_mark};
} catch (...) {
  rethrow_refused_memory();
}

SphereVector NefSphere::direction(std::uint32_t point) const {
  return exact_direction(planes(), map().direction[point]);
}
SphereVector NefSphere::normal(std::uint32_t arc) const {
  return exact_normal(planes(), map().circle[arc]);
}

bool NefSphere::is_empty() const { return is_one_face(map(), 0); }
bool NefSphere::is_sphere() const { return is_one_face(map(), 1); }
bool NefSphere::is_closed() const try {
  return are_marks_of(map(), closure_marks(map()));
} catch (...) {
  rethrow_refused_memory();
}
bool NefSphere::is_open() const try {
  return are_marks_of(map(), interior_marks(map()));
} catch (...) {
  rethrow_refused_memory();
}

std::optional<DcelFlaw> NefSphere::audit() const try {
  return plumb::audit(planes(), map(), true);
} catch (...) {
  rethrow_refused_memory();
}

// ---------------------------------------------------------------- operators of topology

NefSphere NefSphere::complement() const try {
  SphereMap flipped = map();
  for (auto* marks : {&flipped.point_mark, &flipped.arc_mark, &flipped.face_mark}) flip(*marks);
  return from_minimal(state_->planes, std::move(flipped));
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::interior() const try {
  return with_marks(interior_marks(map()));
} catch (...) {
  rethrow_refused_memory();
}
NefSphere NefSphere::closure() const try { return with_marks(closure_marks(map())); } catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::boundary() const try {
  SphereItemMarks marks = closure_marks(map());
  const SphereItemMarks inner = interior_marks(map());
  take_off(marks.point, inner.point);
  take_off(marks.arc, inner.arc);
  take_off(marks.face, inner.face);
  return with_marks(std::move(marks));
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::exterior() const { return complement().interior(); }
NefSphere NefSphere::regularization() const { return interior().closure(); }

// ---------------------------------------------------------------- comparison

bool operator==(const NefSphere& a, const NefSphere& b) try {
  if (a.state_ == b.state_) return true;
  const SphereMap& s = a.map();
  const SphereMap& t = b.map();
  return s.point_count() == t.point_count() && s.arc_count() == t.arc_count() &&
         s.face_count() == t.face_count() && (a ^ b).is_empty();
} catch (...) {
  rethrow_refused_memory();
}

bool operator<=(const NefSphere& a, const NefSphere& b) { return (a - b).is_empty(); }

}  // namespace plumb
