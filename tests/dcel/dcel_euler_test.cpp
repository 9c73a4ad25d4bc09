// Random walks of Euler operators, against the model, the audit and their own partners.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <random>

#include "dcel_model.h"
#include "fixtures.h"
#include "generate/test_share.h"
#include "plumb/predicates/error.h"
namespace plumb::test::dcel_euler_test {
namespace {
/// Picks present elements of a structure by random numbers.
class Picker {
 public:
  Picker(const Dcel& dcel, std::uint64_t seed) : d_(dcel), random_(seed) {}
  std::size_t below(std::size_t n) { return random_() % n; }
  template <class Id>
  Id any(std::size_t slots) {
    std::vector<Id> present;
    for (std::size_t i = 0; i < slots; ++i) {
      if (d_.contains(Id(i))) present.push_back(Id(i));
    }
    return present.empty() ? Id() : present[below(present.size())];
  }
  FaceId face() { return any<FaceId>(d_.face_slots()); }
  VertexId vertex() { return any<VertexId>(d_.vertex_slots()); }
  HalfedgeId halfedge() { return any<HalfedgeId>(d_.halfedge_slots()); }
  /// A corner in face f; none if f has no loops.
  Corner corner(FaceId f) {
    std::vector<Corner> corners;
    for (const LoopId l : d_.loops_of(f)) {
      if (d_.first(l).is_other()) corners.push_back(d_.first(l));
      for (const HalfedgeId h : d_.along(l)) corners.emplace_back(h);
    }
    return corners.empty() ? Corner() : corners[below(corners.size())];
  }
  std::vector<LoopId> some_loops(FaceId f) {
    std::vector<LoopId> chosen;
    for (const LoopId l : d_.loops_of(f)) {
      if (below(2) == 0) chosen.push_back(l);
    }
    return chosen;
  }

 private:
  const Dcel& d_;
  std::mt19937_64 random_;
};
bool can_join(const Dcel& d, HalfedgeId n) {
  return d.contains(n) && edge_of(d.prev(n)) != edge_of(n) && d.next(twin(n)) == twin(d.prev(n));
}
/// A structure and its model, changed in step.
struct Pair {
  Dcel dcel;
  Model model;
  void add_vertex(FaceId f) {
    const auto l = static_cast<std::uint32_t>(dcel.loop_slots());
    model.loops[l] = {f.value(), dcel.add_vertex(f), {}};
  }
  void remove_vertex(VertexId v) {
    if (!dcel.contains(v) || !dcel.is_isolated(v)) return;
    model.loops.erase(dcel.isolated_loop(v).value());
    dcel.remove_vertex(v);
  }
  void add_edge(Corner a, Corner b) {
    if (!a.is_valid()) return;
    const auto l = static_cast<std::uint32_t>(dcel.loop_slots());
    const HalfedgeId h(dcel.halfedge_slots());
    model.add_edge(a, b, h, l);
    EXPECT_EQ(dcel.add_edge(a, b), h);
  }
  void remove_edge(HalfedgeId h) {
    if (!h.is_valid() || dcel.face(h) != dcel.face(twin(h))) return;
    model.remove_edge(h, static_cast<std::uint32_t>(dcel.loop_slots()));
    dcel.remove_edge(h);
  }
  void split_edge(HalfedgeId h) {
    if (!h.is_valid()) return;
    const HalfedgeId n = dcel.split_edge(h);
    model.split_edge(h, n, dcel.origin(n));
  }
  void join_edge(HalfedgeId n) {
    if (!can_join(dcel, n)) return;
    model.join_edge(n);
    dcel.join_edge(n);
  }
  void split_face(const std::vector<LoopId>& loops) {
    if (loops.empty()) return;
    const FaceId f = dcel.split_face(loops);
    model.faces.insert(f.value());
    for (const LoopId l : loops) model.loops[l.value()].face = f.value();
  }
  void join_faces(FaceId kept, FaceId gone) {
    if (kept == gone) return;
    dcel.join_faces(kept, gone);
    model.faces.erase(gone.value());
    for (auto& [l, loop] : model.loops) {
      if (loop.face == gone.value()) loop.face = kept.value();
    }
  }
  void random_step(std::uint64_t seed) {
    Picker pick(dcel, seed);
    switch (const FaceId f = pick.face(); pick.below(10)) {
      case 0:
        return add_vertex(f);
      case 1:
        return remove_vertex(pick.vertex());
      case 2:
      case 3:
      case 4:
        return add_edge(pick.corner(f), pick.corner(f));
      case 5:
        return remove_edge(pick.halfedge());
      case 6:
        return split_edge(pick.halfedge());
      case 7:
        return join_edge(pick.halfedge());
      case 8:
        return split_face(pick.some_loops(f));
      default:
        return join_faces(f, pick.face());
    }
  }
};
std::string told(const std::optional<DcelFlaw>& flaw) {
  return flaw ? flaw->invariant + " at " + flaw->place : "";
}
Pair walked(const std::vector<std::uint64_t>& steps) {
  Pair p;
  p.model.faces.insert(p.dcel.add_face().value());
  p.add_vertex(FaceId(0));
  for (const auto seed : steps) p.random_step(seed);
  return p;
}
TEST(DcelEuler, RandomWalksAgreeWithTheModelAndPassTheAudit) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint64_t>& steps) {
    Pair p = walked({});
    for (const auto seed : steps) {
      p.random_step(seed);
      RC_ASSERT(told(p.dcel.audit()) == "");
      RC_ASSERT(p.model.normal() == Model::read(p.dcel));
    }
  }));
}
TEST(DcelEuler, LongWalkAgreesWithTheModel) {
  std::mt19937_64 random(20);
  Pair p = walked({});
  for (int i = 0; i < 3000; ++i) {
    p.random_step(random());
    if (p.model.loops.empty()) p.add_vertex(FaceId(*p.model.faces.begin()));
    if (i % 50 == 0) {
      ASSERT_EQ(told(p.dcel.audit()), "") << i;
    }
  }
  EXPECT_EQ(told(p.dcel.audit()), "");
  EXPECT_EQ(p.model.normal(), Model::read(p.dcel));
  EXPECT_GT(p.dcel.edge_count(), 10U);  // the walk went somewhere
}
/// Applies one operator and its partner; false if the operator was not applicable.
bool there_and_back(Dcel& d, Picker& pick, Renaming& names) {
  const auto rename_edge = [&names](HalfedgeId now, HalfedgeId before) {
    names.halfedge = {{now, before}, {twin(now), twin(before)}};
  };
  const FaceId f = pick.face();
  const HalfedgeId h = pick.halfedge();
  switch (pick.below(8)) {
    case 0:
      return d.remove_vertex(d.add_vertex(f)), true;
    case 1: {
      const VertexId v = pick.vertex();
      if (!v.is_valid() || !d.is_isolated(v)) return false;
      const FaceId home = d.face(d.isolated_loop(v));
      d.remove_vertex(v);
      names.vertex[d.add_vertex(home)] = v;
      return true;
    }
    case 2: {
      const Corner a = pick.corner(f), b = pick.corner(f);
      if (!a.is_valid()) return false;
      const HalfedgeId e = d.add_edge(a, b);
      d.remove_edge(pick.below(2) == 0 ? e : twin(e));
      return true;
    }
    case 3: {
      if (!h.is_valid() || d.face(h) != d.face(twin(h))) return false;
      const VertexId va = d.origin(h), vb = d.target(h);
      HalfedgeId a = d.turn_right(h), b = d.next(h);
      const bool alone = b == h, twin_alone = a == twin(h);  // self-loops with nothing inside
      if (alone) b = a;
      if (twin_alone) a = b;
      d.remove_edge(h);
      const Corner at_a = d.is_isolated(va) ? Corner(va) : Corner(a);
      const Corner at_b = d.is_isolated(vb) ? Corner(vb) : Corner(b);
      const HalfedgeId e = d.add_edge(at_a, at_b);
      rename_edge(twin_alone && !alone ? twin(e) : e, h);
      return true;
    }
    case 4:
      return h.is_valid() && (d.join_edge(d.split_edge(h)), true);
    case 5: {
      if (!can_join(d, h)) return false;
      const VertexId w = d.origin(h);
      const HalfedgeId before = d.prev(h);
      d.join_edge(h);
      const HalfedgeId e = d.split_edge(before);
      rename_edge(e, h);
      names.vertex[d.origin(e)] = w;
      return true;
    }
    case 6: {
      const auto loops = pick.some_loops(f);
      if (loops.empty()) return false;
      d.join_faces(f, d.split_face(loops));
      return true;
    }
    default: {
      const FaceId g = pick.face();
      std::vector<LoopId> loops;
      for (const LoopId l : d.loops_of(g)) loops.push_back(l);
      if (f == g || loops.empty()) return false;
      d.join_faces(f, g);
      names.face[d.split_face(loops).value()] = g.value();
      return true;
    }
  }
}
TEST(DcelEuler, EveryOperatorIsUndoneByItsPartner) {
  std::size_t applied = 0;
  EXPECT_TRUE(rc::check([&applied](const std::vector<std::uint64_t>& steps, std::uint64_t seed) {
    Dcel d = walked(steps).dcel;
    const auto before = Renaming{}.shape(d);
    Renaming names;
    Picker pick(d, seed);
    if (there_and_back(d, pick, names)) ++applied;
    RC_ASSERT(told(d.audit()) == "");
    RC_ASSERT(names.shape(d) == before);
  }));
  EXPECT_GT(applied, testing::share_of(80));
}
/// Cuts the plane up as a map is drawn: an edge across a face splits the face at once.
void planar_step(Dcel& d, std::uint64_t seed) {
  Picker pick(d, seed);
  const FaceId f = pick.face();
  const std::size_t what = pick.below(4);
  if (what == 0) d.add_vertex(f);
  if (what == 1) {
    if (const HalfedgeId h = pick.halfedge(); h.is_valid()) d.split_edge(h);
  }
  if (what == 2) {
    const Corner a = pick.corner(f), b = pick.corner(f);
    if (!a.is_valid()) return;
    const bool splits = d.loop_at(a) == d.loop_at(b);
    const LoopId l = d.loop(d.add_edge(a, b));
    if (!splits) return;
    std::vector<LoopId> inside = {l};  // any of the others may lie on this side
    for (const LoopId other : pick.some_loops(f)) {
      if (other != l && other != d.loop(twin(d.first(l).halfedge()))) inside.push_back(other);
    }
    d.split_face(inside);
  }
  if (what == 3) {
    const HalfedgeId h = pick.halfedge();
    if (!h.is_valid()) return;
    if (d.face(h) != d.face(twin(h))) d.join_faces(d.face(h), d.face(twin(h)));
    d.remove_edge(h);
  }
}
TEST(DcelEuler, DrawingInThePlaneKeepsEulersFormula) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint64_t>& steps) {
    Dcel d;
    d.add_face();
    for (const auto seed : steps) {
      planar_step(d, seed);
      RC_ASSERT(told(d.audit()) == "");
      RC_ASSERT(told(d.audit_planar()) == "");
    }
  }));
}
TEST(DcelEuler, CompactKeepsTheStructureAndMovesPayloads) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint64_t>& steps) {
    Dcel d = walked(steps).dcel;
    const auto before = Renaming{}.shape(d);
    std::vector<std::size_t> tag(d.vertex_slots());
    for (std::size_t i = 0; i < tag.size(); ++i) tag[i] = i;
    const DcelCompaction to = d.compact();
    follow(to.vertex, tag);
    RC_ASSERT(told(d.audit()) == "");
    RC_ASSERT(d.vertex_slots() == d.vertex_count() && d.halfedge_slots() == d.halfedge_count());
    RC_ASSERT(d.loop_slots() == d.loop_count() && d.face_slots() == d.face_count());
    RC_ASSERT(tag.size() == d.vertex_slots());
    Renaming back;
    for (std::size_t v = 0; v < tag.size(); ++v) back.vertex[VertexId(v)] = VertexId(tag[v]);
    for (std::size_t h = 0; h < 2 * to.edge.size(); ++h) {
      if (to.halfedge(HalfedgeId(h)).is_valid())
        back.halfedge[to.halfedge(HalfedgeId(h))] = HalfedgeId(h);
    }
    for (std::uint32_t f = 0; f < to.face.size(); ++f) {
      if (to.face[f].is_valid()) back.face[to.face[f].value()] = f;
    }
    RC_ASSERT(back.shape(d) == before);
  }));
}
TEST(DcelEulerDeathTest, RefusesBrokenPreconditions) {
  Dcel d = grid(2).build().dcel;
  const HalfedgeId inner = d.first(LoopId(1)).halfedge(), other = d.first(LoopId(4)).halfedge();
  EXPECT_THROW(d.add_edge(inner, other), BrokenInvariant);  // different faces
  EXPECT_THROW(d.remove_edge(inner), BrokenInvariant);
  EXPECT_THROW(d.join_edge(d.halfedge(VertexId(4))), BrokenInvariant);  // degree 4
  EXPECT_THROW(d.remove_vertex(VertexId(0)), BrokenInvariant);
  EXPECT_THROW(d.remove_face(FaceId(0)), BrokenInvariant);
  EXPECT_THROW(d.join_faces(FaceId(1), FaceId(1)), BrokenInvariant);
  const std::vector<LoopId> twice = {LoopId(1), LoopId(1)};
  EXPECT_THROW(d.split_face(twice), BrokenInvariant);
  Dcel p = pinched().build().dcel;
  EXPECT_THROW(p.split_edge(HalfedgeId(0)), BrokenInvariant);
}
}  // namespace
}  // namespace plumb::test::dcel_euler_test
