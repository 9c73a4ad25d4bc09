// A half-edge structure so simple that it is right by looking at it: lists of names.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "plumb/dcel/dcel.h"

namespace plumb::test {

/// Loops as lists of half-edges; the operators as cutting and gluing lists. Oracle for Dcel.
struct Model {
  struct Loop {
    std::uint32_t face = 0;
    VertexId isolated;                ///< valid exactly when there are no half-edges
    std::vector<HalfedgeId> members;  ///< in order, starting anywhere
    friend auto operator<=>(const Loop&, const Loop&) = default;
  };

  std::map<std::uint32_t, Loop> loops;
  std::map<HalfedgeId, VertexId> origin;
  std::set<std::uint32_t> faces;

  static Model read(const Dcel& d) {
    Model m;
    for (std::uint32_t f = 0; f < d.face_slots(); ++f) {
      if (!d.contains(FaceId(f))) continue;
      m.faces.insert(f);
      for (const LoopId l : d.loops_of(FaceId(f))) {
        Loop& loop = m.loops[l.value()];
        loop = {f, d.first(l).other(), {}};
        for (const HalfedgeId h : d.along(l)) {
          loop.members.push_back(h);
          m.origin[h] = d.origin(h);
        }
      }
    }
    return m.normal();
  }

  /// The list of h's loop, turned so that it starts with h, and the loop's number.
  std::pair<std::uint32_t, std::vector<HalfedgeId>> from(HalfedgeId h) const {
    for (const auto& [l, loop] : loops) {
      auto list = loop.members;
      const auto at = std::find(list.begin(), list.end(), h);
      if (at == list.end()) continue;
      std::rotate(list.begin(), at, list.end());
      return {l, list};
    }
    return {};
  }

  std::pair<std::uint32_t, std::vector<HalfedgeId>> from(Corner c) const {
    if (c.is_halfedge()) return from(c.halfedge());
    for (const auto& [l, loop] : loops) {
      if (loop.isolated == c.other()) return {l, {}};
    }
    return {};
  }

  VertexId vertex_at(Corner c) const {
    return c.is_halfedge() ? origin.at(c.halfedge()) : c.other();
  }

  void set(std::uint32_t l, std::uint32_t face, std::vector<HalfedgeId> members, VertexId v) {
    loops[l] = {face, members.empty() ? v : VertexId(), std::move(members)};
  }

  void add_edge(Corner a, Corner b, HalfedgeId h, std::uint32_t new_loop) {
    origin[h] = vertex_at(a);
    origin[twin(h)] = vertex_at(b);
    const auto [la, list_a] = from(a);
    const auto [lb, list_b] = from(b);
    const std::uint32_t face = loops[la].face;
    std::vector<HalfedgeId> left = {h}, right = {twin(h)};
    if (la == lb) {
      const auto cut =
          a == b ? list_a.end() : std::find(list_a.begin(), list_a.end(), b.halfedge());
      right.insert(right.end(), list_a.begin(), cut);
      left.insert(left.end(), cut, list_a.end());
      if (a == b) std::tie(left, right) = std::tuple(std::vector{h}, right);
      set(new_loop, face, left, {});
      set(la, face, right, {});
    } else {
      left.insert(left.end(), list_b.begin(), list_b.end());
      left.insert(left.end(), right.begin(), right.end());
      left.insert(left.end(), list_a.begin(), list_a.end());
      loops.erase(lb);
      set(la, face, left, {});
    }
  }

  void remove_edge(HalfedgeId h, std::uint32_t new_loop) {
    const HalfedgeId t = twin(h);
    auto [lh, list_h] = from(h);
    auto [lt, list_t] = from(t);
    const std::uint32_t face = loops[lt].face;
    if (lh != lt) {
      list_h.insert(list_h.end(), list_t.begin() + 1, list_t.end());
      loops.erase(lh);
      set(lt, face, {list_h.begin() + 1, list_h.end()}, origin[h]);
    } else {
      const auto cut = std::find(list_h.begin(), list_h.end(), t);
      set(new_loop, face, {list_h.begin() + 1, cut}, origin[t]);
      set(lt, face, {cut + 1, list_h.end()}, origin[h]);
    }
    origin.erase(h);
    origin.erase(t);
  }

  void split_edge(HalfedgeId h, HalfedgeId n, VertexId w) {
    const HalfedgeId t = twin(h);
    origin[n] = w;
    origin[twin(n)] = std::exchange(origin[t], w);
    for (auto& [l, loop] : loops) {
      auto& list = loop.members;
      if (auto i = std::find(list.begin(), list.end(), h); i != list.end()) list.insert(i + 1, n);
      if (auto i = std::find(list.begin(), list.end(), t); i != list.end()) list.insert(i, twin(n));
    }
  }

  void join_edge(HalfedgeId n) {
    const auto [l, list] = from(n);
    origin[twin(list.back())] = origin[twin(n)];
    for (auto& [k, loop] : loops) {
      std::erase_if(loop.members, [n](HalfedgeId h) { return edge_of(h) == edge_of(n); });
    }
    origin.erase(n);
    origin.erase(twin(n));
  }

  /// Every list turned to start with its lowest half-edge.
  Model normal() const {
    Model m = *this;
    for (auto& [l, loop] : m.loops) {
      auto& list = loop.members;
      std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
    }
    return m;
  }

  friend bool operator==(const Model&, const Model&) = default;
};

/// The structure without loop names, other names changed on the way: equal when isomorphic by them.
struct Renaming {
  std::map<HalfedgeId, HalfedgeId> halfedge;
  std::map<VertexId, VertexId> vertex;
  std::map<std::uint32_t, std::uint32_t> face;

  template <class Id>
  static Id get(const std::map<Id, Id>& names, Id id) {
    const auto i = names.find(id);
    return i == names.end() ? id : i->second;
  }

  using Shape = std::tuple<std::set<std::uint32_t>, std::multiset<Model::Loop>,
                           std::map<HalfedgeId, VertexId>>;
  Shape shape(const Dcel& d) const {
    Model m = Model::read(d);
    Shape s;
    for (const auto f : m.faces) std::get<0>(s).insert(get(face, f));
    for (auto& [l, loop] : m.loops) {
      loop.face = get(face, loop.face);
      loop.isolated = get(vertex, loop.isolated);
      for (HalfedgeId& h : loop.members) h = get(halfedge, h);
    }
    for (const auto& [l, loop] : m.normal().loops) std::get<1>(s).insert(loop);
    for (const auto& [h, v] : m.origin) std::get<2>(s)[get(halfedge, h)] = get(vertex, v);
    return s;
  }
};

}  // namespace plumb::test
