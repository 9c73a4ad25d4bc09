// Every array broken on purpose, entry by entry: the audit must notice and name what is wrong.
#include <gtest/gtest.h>

#include <set>

#include "fixtures.h"

namespace plumb {

/// Breaks one entry of one array. The arrays are private: this is their only other reader.
class DcelSurgeon {
 public:
  using Cut = void (*)(Dcel&, std::size_t at, std::uint32_t value);
  struct Array {
    const char* name;
    std::size_t (*size)(const Dcel&);
    Cut set;
  };

  static const std::vector<Array>& arrays() {
    static const std::vector<Array> all = {
        {"origin", halves,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.halfedges_[i].origin = VertexId(x); }},
        {"next", halves,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.halfedges_[i].next = HalfedgeId(x); }},
        {"prev", halves,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.halfedges_[i].prev = HalfedgeId(x); }},
        {"loop", halves,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.halfedges_[i].loop = LoopId(x); }},
        {"vertex to half-edge", points,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.vertices_[i] = HalfedgeId(x); }},
        {"vertex to loop", points,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.vertices_[i] = LoopId(x); }},
        {"loop to half-edge", loops,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.loops_[i].first = HalfedgeId(x); }},
        {"loop to vertex", loops,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.loops_[i].first = VertexId(x); }},
        {"face of loop", loops,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.loops_[i].face = FaceId(x); }},
        {"next loop", loops,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.loops_[i].next = LoopId(x); }},
        {"previous loop", loops,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.loops_[i].prev = LoopId(x); }},
        {"face to loop", faces,
         [](Dcel& d, std::size_t i, std::uint32_t x) { d.faces_[i] = LoopId(x); }},
    };
    return all;
  }

  static void break_counts(Dcel& d) { ++d.counts_.edges; }
  static void break_pinches(Dcel& d) { d.has_pinches_ = !d.has_pinches_; }
  static void break_pairs(Dcel& d) { d.halfedges_.emplace_back(); }

  /// Turns two chains into one, links and all, but keeps the labels of the first: next and prev
  /// stay inverse, so that only the later invariants can notice.
  static void swap_next(Dcel& d, HalfedgeId a, HalfedgeId b) {
    const HalfedgeId na = d.next(a), nb = d.next(b);
    d.link(a, nb);
    d.link(b, na);
  }
  static void set_loop(Dcel& d, HalfedgeId h, LoopId l) { d.halfedges_[h.value()].loop = l; }
  static void set_origin(Dcel& d, HalfedgeId h, VertexId v) { d.halfedges_[h.value()].origin = v; }
  static void swap_loop_next(Dcel& d, LoopId a, LoopId b) {
    std::swap(d.loops_[a.value()].next, d.loops_[b.value()].next);
    std::swap(d.loops_[d.next_loop(a).value()].prev, d.loops_[d.next_loop(b).value()].prev);
  }

 private:
  static std::size_t halves(const Dcel& d) { return d.halfedges_.size(); }
  static std::size_t points(const Dcel& d) { return d.vertices_.size(); }
  static std::size_t loops(const Dcel& d) { return d.loops_.size(); }
  static std::size_t faces(const Dcel& d) { return d.faces_.size(); }
};

namespace test::dcel_audit_test {
namespace {

std::string broken(const Dcel& d) {
  const auto flaw = d.audit();
  return flaw ? flaw->invariant : "";
}

/// A structure with every kind of entry: islands, isolated vertices, removed elements.
Dcel specimen() {
  Dcel d = nested().build().dcel;
  const VertexId v = d.add_vertex(FaceId(1));
  const HalfedgeId h = d.add_edge(v, d.first(LoopId(0)));
  d.add_vertex(FaceId(2));
  d.remove_edge(h);
  d.join_edge(d.split_edge(HalfedgeId(0)));
  d.remove_vertex(v);
  d.add_face();
  d.remove_face(d.add_face());
  return d;
}

/// Values that differ from the one there, among them every small id, holes and nonsense.
std::vector<std::uint32_t> wrong_values() {
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 40; ++i) values.push_back(i);
  for (const std::uint32_t x : {1000U, 0x7fffffffU, 0x80000000U, 0xfffffffeU, 0xffffffffU})
    values.push_back(x);
  return values;
}

/// Equal content of all that can be read, walks included.
bool reads_the_same(const Dcel& a, const Dcel& b) {
  for (std::size_t i = 0; i < a.halfedge_slots(); ++i) {
    const HalfedgeId h(i);
    if (a.origin(h) != b.origin(h) || a.next(h) != b.next(h) || a.prev(h) != b.prev(h) ||
        a.loop(h) != b.loop(h))
      return false;
  }
  return true;
}

TEST(DcelAudit, FindsEveryWrongEntryOfEveryArray) {
  const Dcel good = specimen();
  ASSERT_EQ(broken(good), "");
  std::set<std::string> named;
  for (const auto& array : DcelSurgeon::arrays()) {
    std::size_t found = 0, tried = 0;
    for (std::size_t i = 0; i < array.size(good); ++i) {
      for (const std::uint32_t x : wrong_values()) {
        Dcel bad = good;
        array.set(bad, i, x);
        ++tried;
        if (const auto flaw = broken(bad); !flaw.empty()) {
          named.insert(flaw);
          ++found;
        } else {
          EXPECT_TRUE(reads_the_same(good, bad)) << array.name << " " << i << " := " << x;
        }
      }
    }
    EXPECT_GT(found, tried * 3 / 4) << array.name;
  }
  EXPECT_GE(named.size(), 13U);
}

TEST(DcelAudit, FindsWrongCountsPairsAndPinches) {
  Dcel d = specimen();
  DcelSurgeon::break_counts(d);
  EXPECT_EQ(broken(d), "the counts are those of the arrays");
  d = specimen();
  DcelSurgeon::break_pinches(d);
  EXPECT_EQ(broken(d), "a vertex without a pinch has one ring of half-edges");
  d = specimen();
  DcelSurgeon::break_pairs(d);
  EXPECT_EQ(broken(d), "half-edges come in pairs");
}

TEST(DcelAudit, FindsALoopMadeOfTwoChains) {
  // A figure of eight through one vertex, its two rounds cut apart behind the loop's back.
  Listing eight;
  eight.vertices = 5;
  eight.add({0, 1, 2}, 1);
  eight.add({0, 3, 4}, 2);
  eight.add({0, 2, 1, 0, 4, 3}, 0);
  auto built = eight.build();
  const auto& at = built.halfedge_of_corner;
  DcelSurgeon::swap_next(built.dcel, at[8], at[11]);  // both end at vertex 0
  EXPECT_EQ(broken(built.dcel), "a loop is one chain of half-edges");
}

TEST(DcelAudit, FindsNextThatGoesElsewhereOrChangesLoop) {
  auto built = grid(2).build();
  const auto& at = built.halfedge_of_corner;
  Dcel d = built.dcel;
  DcelSurgeon::swap_next(d, at[8], at[20]);
  EXPECT_EQ(broken(d), "next begins where this one ends");
  d = built.dcel;
  DcelSurgeon::set_loop(d, at[9], LoopId(2));  // not the first one of its loop
  EXPECT_EQ(broken(d), "next is in the same loop");
  d = pinched().build().dcel;
  DcelSurgeon::swap_next(d, d.prev(d.first(LoopId(1)).halfedge()),
                         d.prev(d.first(LoopId(3)).halfedge()));
  EXPECT_EQ(broken(d), "next is in the same loop");
}

TEST(DcelAudit, FindsFacesWhoseLoopsAreTwoRings) {
  Listing g = nested();
  g.isolated = {{VertexId(9), FaceId(0)}, {VertexId(10), FaceId(0)}};
  Dcel d = g.build().dcel;  // face 0: loops 1, 6, 7 in a ring
  DcelSurgeon::swap_loop_next(d, LoopId(1), LoopId(7));
  EXPECT_EQ(broken(d), "the loops of a face form one ring");
}

TEST(DcelAudit, PlanarAuditTellsATorusAndAWrongNesting) {
  Listing torus;  // one square, opposite sides the same: an edge each way, one vertex
  torus.vertices = 1;
  torus.corners = {0, 0, 0, 0};
  torus.cycle_begin = {0, 4};
  torus.face_of_cycle = {0};
  const std::vector<std::uint32_t> twin = {2, 3, 0, 1};
  const Dcel t =
      Dcel::from_cycles(1, torus.corners, torus.cycle_begin, twin, torus.face_of_cycle).dcel;
  EXPECT_EQ(broken(t), "");
  ASSERT_TRUE(t.audit_planar());
  EXPECT_EQ(t.audit_planar()->invariant, "rings - edges + loops = 2");

  Listing wrong = nested();
  wrong.face_of_cycle[3] = 0;  // the filling of the hole is in face 2; now it has none with its rim
  const Dcel w = wrong.build().dcel;
  EXPECT_EQ(broken(w), "");
  EXPECT_TRUE(w.audit_planar());

  Listing apart = nested();
  apart.face_of_cycle[2] = 4;  // the hole has left its face: two maps side by side
  ASSERT_TRUE(apart.build().dcel.audit_planar());
  EXPECT_EQ(apart.build().dcel.audit_planar()->invariant, "faces and components are connected");
}

}  // namespace
}  // namespace test::dcel_audit_test
}  // namespace plumb
