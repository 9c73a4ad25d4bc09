#include "oracle/sphere_check.h"

#include <algorithm>
#include <map>

#include "plumb/sphere/overlay/sphere_overlay.h"
#include "plumb/sphere/sphere_audit.h"

namespace plumb::testing {
namespace {

using Item = SphereItems::Item;

std::string to_text(const CellVector& v) {
  return '(' + v[0].str() + ", " + v[1].str() + ", " + v[2].str() + ')';
}

std::string to_text(Item item) {
  static constexpr const char* kNames[] = {"point ", "arc ", "face "};
  return kNames[item.dimension] + std::to_string(item.index);
}

Item item_of(SphereCell cell) { return {static_cast<int>(cell.kind()), cell.index()}; }

bool mark_of(const SphereMap& map, Item item) {
  const std::vector<Mark>& marks = item.dimension == 0   ? map.point_mark
                                   : item.dimension == 1 ? map.arc_mark
                                                         : map.face_mark;
  return marks[item.index] != 0;
}

Rational rational_of(const BigInt& n) { return testing::to_rational(BigRational(n)); }

OrientedPlane plane_in(PlaneTable& planes, const CellVector& n) {
  return planes.intern(rational_of(n[0]), rational_of(n[1]), rational_of(n[2]), Rational(0));
}

// The twin's items and the engine's, paired by where cells lie.
struct Match {
  SphereItems items;
  std::map<Item, Item> engine_item;
  std::string difference;
};

Match match(const SphereMap& map, const SphereCells& cells, const CellMarks& marks,
            const std::vector<SphereCell>& located) {
  Match m{minimal_items(cells, marks), {}, ""};
  const std::array<std::size_t, 3> count{map.point_count(), map.arc_count(), map.face_count()};
  if (count != m.items.count) {
    m.difference = "points, arcs, faces: engine";
    for (const std::size_t n : count) m.difference += ' ' + std::to_string(n);
    m.difference += ", twin";
    for (const std::size_t n : m.items.count) m.difference += ' ' + std::to_string(n);
    return m;
  }
  std::map<Item, Item> twin_item;
  for (std::size_t c = 0; c < cells.size() && m.difference.empty(); ++c) {
    const Item got = item_of(located[c]);
    const Item expected = m.items.item_of[c];
    const bool is_right = got.dimension == expected.dimension &&
                          m.engine_item.try_emplace(expected, got).first->second == got &&
                          twin_item.try_emplace(got, expected).first->second == expected;
    const std::string where = "at " + to_text(cells[c].sample) + ": engine ";
    if (!is_right) {
      m.difference = where + to_text(got) + ", twin " + to_text(expected);
    } else if (mark_of(map, got) != marks[c]) {
      m.difference = where + (marks[c] ? "unmarked" : "marked");
    }
  }
  return m;
}

std::string flaw_in(const std::optional<DcelFlaw>& flaw) {
  return flaw ? "audit: " + flaw->invariant + " at " + flaw->place : "";
}

// ---------------------------------------------------------------- great circles

// The cells met on a great circle, in order, with the first direction of each.
class Round {
 public:
  Round(const SphereCells& cells, const CellVector& origin, const CellVector& towards)
      : cells_(cells), normal_(cross(origin, towards)), stops_{origin} {
    for (const CellVector& n : cells.normals()) {
      const CellVector u = cross(normal_, n);
      if (u == CellVector{0, 0, 0}) continue;
      stops_.push_back(u);
      stops_.push_back({-u[0], -u[1], -u[2]});
    }
    std::sort(stops_.begin() + 1, stops_.end(),
              [&](const CellVector& u, const CellVector& v) { return is_before(u, v); });
  }

  struct Hit {
    std::size_t cell;
    CellVector direction;
  };
  std::optional<Hit> first(const std::vector<bool>& accepted) const {
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      const CellVector& here = stops_[i];
      const std::size_t on = cells_.cell_of(here);
      if (accepted[on]) return Hit{on, here};
      const std::size_t after = cells_.cell_of(between(here, stops_[(i + 1) % stops_.size()]));
      if (accepted[after]) return Hit{after, here};
    }
    return std::nullopt;
  }

 private:
  /// 0: the origin, 1: less than half a circle from it, 2: opposite, 3: more.
  int turn(const CellVector& u) const {
    const int side = dot(normal_, cross(stops_[0], u)).sign();
    if (side != 0) return side > 0 ? 1 : 3;
    return dot(stops_[0], u) > 0 ? 0 : 2;
  }
  bool is_before(const CellVector& u, const CellVector& v) const {
    const int s = turn(u);
    const int t = turn(v);
    return s != t ? s < t : dot(normal_, cross(u, v)) > 0;
  }
  /// Neighbours are the same or less than half a circle apart.
  static CellVector between(const CellVector& u, const CellVector& v) {
    const CellVector a = reduced(u);
    const CellVector b = reduced(v);
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }

  const SphereCells& cells_;
  CellVector normal_;
  std::vector<CellVector> stops_;
};

// Every check throws the first difference, as text.
class DeepChecker {
 public:
  DeepChecker(const SphereCells& cells, const TwoSpheres& sets)
      : cells_(cells), engine_(sets.engine), twin_(sets.twin) {}

  std::string run() {
    try {
      check_answers();
      check_operators();
      check_marks();
      check_rounds();
    } catch (const std::string& difference) {
      return difference;
    }
    return "";
  }

 private:
  static void expect(bool right, const std::string& what) {
    if (!right) throw what;
  }

  void check_answers() {
    std::vector<SphereCell> located;
    for (const auto& l : located_in(cells_, engine_)) {
      expect(l.marked == mark_of(engine_.map(), item_of(l.cell)), "marked is not the mark");
      located.push_back(l.cell);
    }
    match_ = match(engine_.map(), cells_, twin_, located);
    expect(match_.difference.empty(), match_.difference);
    expect(engine_.is_empty() == std::none_of(twin_.begin(), twin_.end(), [](bool b) { return b; }),
           "is_empty");
    expect(engine_.is_whole() == std::all_of(twin_.begin(), twin_.end(), [](bool b) { return b; }),
           "is_sphere");
    expect(engine_.is_closed() == (closure_of(cells_, twin_) == twin_), "is_closed");
    expect(engine_.is_open() == (interior_of(cells_, twin_) == twin_), "is_open");
  }

  void check_derived(const NefSphere& engine, const CellMarks& twin, const char* name) const {
    const std::string wrong = difference(cells_, {engine, twin});
    if (!wrong.empty()) throw name + (": " + wrong);
  }

  void check_operators() const {
    const CellMarks inner = interior_of(cells_, twin_);
    const CellMarks closed = closure_of(cells_, twin_);
    check_derived(!engine_, complement_of(twin_), "complement");
    check_derived(engine_.interior(), inner, "interior");
    check_derived(engine_.closure(), closed, "closure");
    check_derived(engine_.boundary(), combined(kDifference, closed, inner), "boundary");
    check_derived(engine_.exterior(), interior_of(cells_, complement_of(twin_)), "exterior");
    check_derived(engine_.regularization(), closure_of(cells_, inner), "regularization");
  }

  void check_marks() const {
    expect(engine_.with_marks(engine_.marks()) == engine_, "with_marks of its own marks");
    expect(NefSphere::from_complex(engine_.complex()) == engine_, "from_map of its own map");
    SphereMarks flipped = engine_.marks();
    for (auto* marks : {&flipped.point, &flipped.arc, &flipped.face}) {
      for (Mark& m : *marks) m = m == 0 ? 1 : 0;
    }
    expect(engine_.with_marks(flipped) == !engine_, "with_marks of flipped marks");
    for (std::uint32_t v = 0; v < engine_.map().point_count(); ++v) {
      expect(engine_.locate(engine_.direction(v)).cell == SphereCell::point(v),
             "direction() of a point");
    }
  }

  void check_rounds() const {
    std::vector<bool> on_boundary(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      on_boundary[c] = match_.items.item_of[c].dimension < 2;
    }
    const std::size_t step = 1 + cells_.size() / 12;
    for (std::size_t c = 0; c < cells_.size(); c += step) {
      for (const std::size_t d :
           {c * 7 % cells_.size(), (c + 1) % cells_.size(), cells_.size() / 2}) {
        const CellVector& origin = cells_[c].sample;
        const CellVector& towards = cells_[d].sample;
        if (cross(origin, towards) == CellVector{0, 0, 0}) continue;
        const Round round(cells_, origin, towards);
        const SphereVector u = vector_of(origin);
        const SphereVector v = vector_of(towards);
        const std::string what = "from " + to_text(origin) + " towards " + to_text(towards);
        check_hit(engine_.shoot(u, v), round.first(twin_), "shoot " + what);
        check_hit(engine_.shoot_to_boundary(u, v), round.first(on_boundary),
                  "shoot_to_boundary " + what);
      }
    }
  }

  void check_hit(const std::optional<SphereHit>& got, const std::optional<Round::Hit>& expected,
                 const std::string& what) const {
    expect(got.has_value() == expected.has_value(), what + ": hits or not");
    if (!got) return;
    const Item on = match_.engine_item.at(match_.items.item_of[expected->cell]);
    if (item_of(got->location.cell) != on) {
      throw what + ": engine " + to_text(item_of(got->location.cell)) + ", twin " + to_text(on);
    }
    expect(got->location.marked == twin_[expected->cell], what + ": mark");
    expect(is_same_direction(got->point, vector_of(expected->direction)), what + ": direction");
  }

 public:
  static std::vector<SphereLocation> located_in(const SphereCells& cells, const NefSphere& set) {
    std::vector<SphereVector> samples;
    for (std::size_t c = 0; c < cells.size(); ++c) samples.push_back(vector_of(cells[c].sample));
    return set.locate(samples);
  }

 private:
  const SphereCells& cells_;
  const NefSphere& engine_;
  const CellMarks& twin_;
  Match match_;
};

}  // namespace

SphereVector vector_of(const CellVector& v) {
  return {rational_of(v[0]), rational_of(v[1]), rational_of(v[2])};
}

CellVector cell_vector(const SphereVector& v) {
  const std::array<BigRational, 3> r{exact_of(v.x), exact_of(v.y), exact_of(v.z)};
  const BigInt common = lcm(lcm(denominator(r[0]), denominator(r[1])), denominator(r[2]));
  CellVector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = numerator(BigRational(r[i] * common));
  return reduced(result);
}

/// (v x e1) x (v x e2) = v (v . e3)
SphereDirection direction_in(PlaneTable& planes, const CellVector& v) {
  std::size_t axis = 0;
  while (v[axis] == 0) ++axis;
  CellVector first{};
  CellVector second{};
  first[(axis + 1) % 3] = 1;
  second[(axis + 2) % 3] = 1;
  const OrientedPlane p = plane_in(planes, cross(v, first));
  const OrientedPlane q = plane_in(planes, cross(v, second));
  const bool is_opposite = (v[axis] < 0) != (p.is_opposite() != q.is_opposite());
  const SphereDirection u{p.plane(), q.plane()};
  return is_opposite ? u.opposite() : u;
}

std::string difference(PlaneTable& planes, const SphereMap& map, const SphereCells& cells,
                       const CellMarks& marks) {
  const std::string flaw = flaw_in(audit(planes, map, AuditForm::Minimal));
  if (!flaw.empty()) return flaw;
  std::vector<SphereCell> located;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    located.push_back(locate(planes, map, direction_in(planes, cells[c].sample)));
  }
  return match(map, cells, marks, located).difference;
}

std::string difference(const SphereCells& cells, const TwoSpheres& sets) {
  const std::string flaw = flaw_in(sets.engine.audit());
  if (!flaw.empty()) return flaw;
  std::vector<SphereCell> located;
  for (const auto& l : DeepChecker::located_in(cells, sets.engine)) located.push_back(l.cell);
  return match(sets.engine.map(), cells, sets.twin, located).difference;
}

std::string deep_difference(const SphereCells& cells, const TwoSpheres& sets) {
  const std::string shallow = difference(cells, sets);
  return shallow.empty() ? DeepChecker(cells, sets).run() : shallow;
}

}  // namespace plumb::testing
