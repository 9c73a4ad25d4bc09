#include "generate/space_scenes.h"

#include <algorithm>
#include <map>
#include <memory>

#include "plumb/space/query/volumes.h"

namespace plumb::testing {
namespace {

bool is_zero(const RationalPoint3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// The sum of cross products of consecutive corners: twice the area, along the normal.
RationalPoint3 area_normal(const SpaceScene& scene, const std::vector<std::uint32_t>& cycle) {
  RationalPoint3 sum{0, 0, 0};
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const RationalPoint3& a = scene.points[cycle[i]];
    const RationalPoint3& b = scene.points[cycle[(i + 1) % cycle.size()]];
    sum = sum + cross(a, b);
  }
  return sum;
}

class SceneBuilder {
 public:
  explicit SceneBuilder(const SpaceScene& scene)
      : scene_(scene), tables_(std::make_shared<SpaceTables>()) {}

  SpaceComplex run() {
    out_.tables = tables_;
    add_vertices();
    for (const SceneFacet& facet : scene_.facets) add_facet(facet);
    for (const auto& [a, b] : scene_.free_edges) edge_between(a, b);
    for (std::size_t e = 0; e < out_.edge_count(); ++e) {
      choose_planes(e);
      link_radial(e);
    }
    out_.list_stars(out_.vertex_count());
    return std::move(out_);
  }

 private:
  void add_vertices() {
    const std::size_t n = scene_.points.size();
    for (const RationalPoint3& p : scene_.points) {
      out_.vertex_point.push_back(add_point(*tables_, p));
    }
    out_.vertex_mark.assign(n, 0);
    out_.vertex_facet.assign(n, FacetId());
    out_.vertex_volume.assign(n, VolumeId());
    out_.cycle_begin = out_.inner_begin = {0};
  }

  OrientedPlane plane_of(const std::vector<std::uint32_t>& cycle) {
    const RationalPoint3 n = area_normal(scene_, cycle);
    const bool is_triangle =
        cycle.size() == 3 && std::all_of(cycle.begin(), cycle.end(), [&](std::uint32_t v) {
          return out_.vertex_point[v].is_input();
        });
    const auto input = [&](std::size_t i) { return out_.vertex_point[cycle[i]].input(); };
    if (is_triangle) return tables_->planes.intern(input(0), input(1), input(2));
    return tables_->planes.intern(n.x, n.y, n.z, Rational(-dot(n, scene_.points[cycle[0]])));
  }

  /// Cycles run around the canonical normal.
  void add_facet(const SceneFacet& facet) {
    const FacetId f(out_.facet_count());
    const OrientedPlane plane = plane_of(facet.cycles[0]);
    out_.facet_plane.push_back(plane.plane());
    out_.facet_mark.push_back(0);
    out_.facet_origin.push_back(f.value());
    for (std::vector<std::uint32_t> cycle : facet.cycles) {
      if (plane.is_opposite()) std::reverse(cycle.begin(), cycle.end());
      add_cycle(f, cycle);
    }
    for (const std::uint32_t v : facet.inner) {
      out_.inner.push_back(VertexId(v));
      out_.vertex_facet[v] = f;
    }
    out_.cycle_begin.push_back(static_cast<std::uint32_t>(out_.cycle.size()));
    out_.inner_begin.push_back(static_cast<std::uint32_t>(out_.inner.size()));
  }

  void add_cycle(FacetId f, const std::vector<std::uint32_t>& cycle) {
    const std::size_t first = out_.use_count(), n = cycle.size();
    out_.cycle.push_back(UseId(first));
    for (std::size_t i = 0; i < n; ++i) {
      const UseId u(first + i);
      const HalfedgeId h = edge_between(cycle[i], cycle[(i + 1) % n]);
      out_.use_halfedge.push_back(h);
      out_.use_next.push_back(UseId(first + (i + 1) % n));
      out_.use_prev.push_back(UseId(first + (i + n - 1) % n));
      out_.use_radial.push_back(u);
      out_.use_facet.push_back(f);
      uses_[h.value() / 2].push_back(u);
    }
  }

  HalfedgeId edge_between(std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] = edges_.try_emplace(std::minmax(a, b), out_.edge_count());
    if (is_new) {
      out_.origin.push_back(VertexId(a));
      out_.origin.push_back(VertexId(b));
      out_.edge_planes.emplace_back();
      out_.edge_mark.push_back(0);
      out_.edge_use.emplace_back();
      out_.edge_volume.emplace_back();
      uses_.emplace_back();
    }
    const bool is_forward = out_.origin[2 * at->second] == VertexId(a);
    return HalfedgeId(2 * at->second + (is_forward ? 0 : 1));
  }

  RationalPoint3 direction(std::size_t e) const {
    return scene_.points[out_.origin[2 * e + 1].value()] -
           scene_.points[out_.origin[2 * e].value()];
  }

  RationalPoint3 normal(PlaneId plane) const {
    const IntegerRow row = tables_->planes.coefficients(plane);
    return {row[0], row[1], row[2]};
  }

  /// Facets' planes where two are not parallel; else planes along the axes.
  void choose_planes(std::size_t e) {
    const RationalPoint3 d = direction(e), &at = scene_.points[out_.origin[2 * e].value()];
    std::vector<PlaneId> candidates;
    for (const UseId u : uses_[e]) {
      candidates.push_back(out_.facet_plane[out_.use_facet[u.value()].value()]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const RationalPoint3 n = cross(d, rational_point(axis == 0, axis == 1, axis == 2));
      if (is_zero(n)) continue;
      const auto plane = tables_->planes.intern(n.x, n.y, n.z, Rational(-dot(n, at)));
      candidates.push_back(plane.plane());
    }
    const PlaneId p = candidates[0];
    for (const PlaneId q : candidates) {
      const RationalPoint3 along = cross(normal(p), normal(q));
      if (is_zero(along)) continue;
      if (dot(along, d) > 0) {
        out_.edge_planes[e] = {p, q};
      } else {
        out_.edge_planes[e] = {q, p};
      }
      return;
    }
  }

  /// Where a use's facet lies, turning around d from w counter-clockwise.
  struct Spoke {
    UseId use;
    int half;
    Rational x;
    Rational y;
  };

  void link_radial(std::size_t e) {
    if (uses_[e].empty()) return;
    const RationalPoint3 d = direction(e);
    std::vector<Spoke> spokes;
    RationalPoint3 w;
    for (const UseId u : uses_[e]) {
      const bool is_reverse = SpaceComplex::is_reverse(out_.use_halfedge[u.value()]);
      const RationalPoint3 n = normal(out_.facet_plane[out_.use_facet[u.value()].value()]);
      const RationalPoint3 inward = is_reverse ? cross(d, n) : cross(n, d);
      if (spokes.empty()) w = inward;
      const Rational x = dot(inward, w), y = dot(inward, cross(d, w));
      spokes.push_back({u, y < 0 || (y == 0 && x < 0) ? 1 : 0, x, y});
    }
    // y is scaled by |d|, the same for all.
    std::stable_sort(spokes.begin(), spokes.end(), [](const Spoke& s, const Spoke& t) {
      return s.half != t.half ? s.half < t.half : s.x * t.y - s.y * t.x > 0;
    });
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      out_.use_radial[spokes[i].use.value()] = spokes[(i + 1) % spokes.size()].use;
    }
    out_.edge_use[e] = spokes[0].use;
  }

  const SpaceScene& scene_;
  std::shared_ptr<SpaceTables> tables_;
  SpaceComplex out_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> edges_;
  std::vector<std::vector<UseId>> uses_;
};

}  // namespace

RationalPoint3 rational_point(int x, int y, int z) { return {x, y, z}; }
RationalPoint3 operator+(const RationalPoint3& a, const RationalPoint3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
RationalPoint3 operator*(const Rational& s, const RationalPoint3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
RationalPoint3 cross(const RationalPoint3& a, const RationalPoint3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Rational dot(const RationalPoint3& a, const RationalPoint3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

std::uint32_t SpaceScene::add_point(const RationalPoint3& p) {
  const auto known = std::find(points.begin(), points.end(), p);
  const auto index = static_cast<std::uint32_t>(known - points.begin());
  if (index == points.size()) points.push_back(p);
  return index;
}

void SpaceScene::add_facet(const std::vector<RationalPoint3>& corners,
                           const std::vector<std::vector<RationalPoint3>>& holes) {
  SceneFacet facet;
  const auto add_cycle = [&](const std::vector<RationalPoint3>& cycle) {
    facet.cycles.emplace_back();
    for (const RationalPoint3& p : cycle) facet.cycles.back().push_back(add_point(p));
  };
  add_cycle(corners);
  for (const auto& hole : holes) add_cycle(hole);
  facets.push_back(std::move(facet));
}

void SpaceScene::add_free_edge(const RationalPoint3& a, const RationalPoint3& b) {
  const std::uint32_t i = add_point(a);
  free_edges.emplace_back(i, add_point(b));
}

SpaceComplex complex_without_volumes(const SpaceScene& scene) { return SceneBuilder(scene).run(); }

SpaceComplex complex_of(const SpaceScene& scene) {
  SpaceComplex complex = complex_without_volumes(scene);
  Context context;
  label_volumes(complex, context);
  return complex;
}

// --- solids

namespace {

/// The corner of a box that takes the high coordinate where `bits` has a 1: x 1, y 2, z 4.
RationalPoint3 corner(const RationalPoint3& low, const RationalPoint3& high, unsigned bits) {
  return {(bits & 1U) != 0 ? high.x : low.x, (bits & 2U) != 0 ? high.y : low.y,
          (bits & 4U) != 0 ? high.z : low.z};
}

std::vector<RationalPoint3> corners(const RationalPoint3& low, const RationalPoint3& high,
                                    std::array<unsigned, 4> bits) {
  std::vector<RationalPoint3> result;
  for (const unsigned b : bits) result.push_back(corner(low, high, b));
  return result;
}

constexpr std::array<std::array<unsigned, 4>, 4> kWalls = {
    {{0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
constexpr std::array<unsigned, 4> kBottom = {0, 2, 3, 1}, kTop = {4, 5, 7, 6};

}  // namespace

void add_box(SpaceScene& scene, const RationalPoint3& low, const RationalPoint3& high) {
  for (const auto& wall : kWalls) scene.add_facet(corners(low, high, wall));
  scene.add_facet(corners(low, high, kBottom));
  scene.add_facet(corners(low, high, kTop));
}

void add_tetrahedron(SpaceScene& scene, const std::array<RationalPoint3, 4>& p) {
  for (std::size_t i = 0; i < 4; ++i) {
    scene.add_facet({p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]});
  }
}

void add_frame_box(SpaceScene& scene, const RationalPoint3& low, const RationalPoint3& high) {
  const Rational third(1, 3);
  const RationalPoint3 step = third * (high - low);
  const RationalPoint3 in{low.x + step.x, low.y + step.y, low.z};
  const RationalPoint3 out{high.x - step.x, high.y - step.y, high.z};
  for (const auto& wall : kWalls) {
    scene.add_facet(corners(low, high, wall));
    scene.add_facet(corners(in, out, wall));
  }
  const auto reversed = [](std::vector<RationalPoint3> cycle) {
    std::reverse(cycle.begin(), cycle.end());
    return cycle;
  };
  scene.add_facet(corners(low, high, kBottom), {reversed(corners(in, out, kBottom))});
  scene.add_facet(corners(low, high, kTop), {reversed(corners(in, out, kTop))});
}

// --- the frame

void add_slabs(SpaceScene& scene, const std::vector<int>& at, const Rational& slope) {
  std::vector<std::vector<RationalPoint3>> stations;
  const auto add_station = [&](const Rational& x, const Rational& by_y) {
    stations.emplace_back();
    for (const auto& [y, z] :
         {std::pair{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}}) {
      stations.back().push_back({x + by_y * y, y, z});
    }
  };
  add_station(-kFar, 0);
  for (const int x : at) add_station(x, slope);
  add_station(kFar, 0);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    scene.add_facet(stations[i]);
    for (std::size_t j = 0; j < 4 && i > 0; ++j) {
      const std::size_t k = (j + 1) % 4;
      scene.add_facet({stations[i - 1][j], stations[i - 1][k], stations[i][k], stations[i][j]});
    }
  }
}

namespace {

class Framer {
 public:
  explicit Framer(SpaceComplex complex)
      : out_(std::move(complex)),
        tables_(copy(*out_.tables)),
        frame_(tables_->planes.intern_frame()) {
    map_planes();
    mark_frame();
    for (std::size_t v = 0; v < out_.vertex_count(); ++v) {
      if (out_.vertex_mark[v] == kBeyond) out_.vertex_point[v] = frame_point(VertexId(v));
    }
    out_.tables = tables_;
  }
  SpaceComplex take() { return std::move(out_); }

 private:
  PlaneId mapped(PlaneId p) const {
    const IntegerRow row = tables_->planes.primitive(p);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (row[axis] != 1 || row[(axis + 1) % 3] != 0 || row[(axis + 2) % 3] != 0) continue;
      if (row[3] == kFar) return frame_[2 * axis];
      if (row[3] == -kFar) return frame_[2 * axis + 1];
    }
    return p;
  }
  void map_planes() {
    for (PlaneId& p : out_.facet_plane) p = mapped(p);
    for (auto& [p, q] : out_.edge_planes) {
      p = mapped(p);
      q = mapped(q);
    }
  }
  void mark_frame() {
    for (std::size_t u = 0; u < out_.use_count(); ++u) {
      const FacetId f = out_.use_facet[u];
      if (!tables_->planes.is_frame(out_.facet_plane[f.value()])) continue;
      out_.facet_mark[f.value()] = kBeyond;
      out_.edge_mark[out_.use_halfedge[u].value() / 2] = kBeyond;
      out_.vertex_mark[out_.use_origin(UseId(u)).value()] = kBeyond;
    }
  }
  /// Of the planes around.
  SpacePoint frame_point(VertexId v) {
    std::vector<PlaneId> planes;
    for (const HalfedgeId h : out_.star_of(v)) {
      for (const PlaneId p : out_.edge_planes[h.value() / 2]) planes.push_back(p);
    }
    for (const PlaneId p : planes) {
      for (const PlaneId q : planes) {
        for (const PlaneId r : planes) {
          const SpacePoint found = tables_->points.add(p, q, r);
          if (found.is_valid()) return found;
        }
      }
    }
    return {};
  }

  SpaceComplex out_;
  std::shared_ptr<SpaceTables> tables_;
  std::array<PlaneId, 6> frame_;
};

}  // namespace

SpaceComplex framed(SpaceComplex complex) { return Framer(std::move(complex)).take(); }

// --- random scenes

namespace {

/// A piece in the cube [0, 3]^3.
class Piece {
 public:
  explicit Piece(Dice& dice) : dice_(dice) {}

  SpaceScene make() {
    switch (dice_.below(9)) {
      case 0:
        return boxes();
      case 1:
        return tetrahedron();
      case 2:
        return void_box();
      case 3:
        return frame_box();
      case 4:
        return polygon();
      case 5:
        return chain();
      case 6:
        return lone_point();
      case 7:
        return tetrahedra_at_edge();
      default:
        return fan();
    }
  }

 private:
  RationalPoint3 at(int x, int y, int z) const { return rational_point(x, y, z); }
  RationalPoint3 any() {
    const auto c = [&] { return static_cast<int>(dice_.between(0, 3)); };
    const int x = c(), y = c();
    return at(x, y, c());
  }

  SpaceScene boxes() {
    SpaceScene s;
    const int x = static_cast<int>(dice_.between(0, 1));
    const RationalPoint3 low = at(x, static_cast<int>(dice_.between(0, 1)), 0);
    add_box(s, low, low + at(static_cast<int>(dice_.between(1, 2)), 2, 1));
    return s;
  }
  SpaceScene tetrahedron() {
    for (;;) {
      const std::array<RationalPoint3, 4> p = {any(), any(), any(), any()};
      if (dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) == 0) continue;
      SpaceScene s;
      add_tetrahedron(s, p);
      return s;
    }
  }
  SpaceScene void_box() {
    SpaceScene s;
    add_box(s, at(0, 0, 0), at(3, 3, 3));
    add_box(s, at(1, 1, 1), at(2, 2, 2));
    return s;
  }
  SpaceScene frame_box() {
    SpaceScene s;
    add_frame_box(s, at(0, 0, 0), at(3, 3, 3));
    return s;
  }
  /// A polygon that is not convex, with a hole, a vertex inside and an edge that leaves there.
  SpaceScene polygon() {
    SpaceScene s;
    const Rational half(1, 2);
    s.add_facet({at(0, 0, 1), at(3, 0, 1), at(3, 3, 1), at(2, 1, 1), at(0, 3, 1)},
                {{half * at(1, 1, 2), half * at(1, 2, 2), half * at(2, 2, 2)}});
    const std::uint32_t tip = s.add_point({Rational(1, 2), Rational(3, 2), 1});
    s.facets[0].inner.push_back(tip);
    if (dice_.below(2) == 0) s.add_free_edge(RationalPoint3(s.points[tip]), at(0, 1, 3));
    return s;
  }
  SpaceScene chain() {
    SpaceScene s;
    RationalPoint3 last = any();
    last.x = 0;
    for (int x = 1; x <= 3; ++x) {
      RationalPoint3 next = any();
      next.x = x;
      s.add_free_edge(last, next);
      last = next;
    }
    return s;
  }
  SpaceScene lone_point() {
    SpaceScene s;
    s.add_point(any());
    return s;
  }
  SpaceScene tetrahedra_at_edge() {
    SpaceScene s;
    add_tetrahedron(s, {at(1, 1, 0), at(1, 1, 3), at(3, 0, 1), at(2, 3, 2)});
    add_tetrahedron(s, {at(1, 1, 0), at(1, 1, 3), at(0, 0, 1), at(0, 3, 2)});
    return s;
  }
  SpaceScene fan() {
    SpaceScene s;
    const std::array<RationalPoint3, 6> tips = {at(3, 1, 1), at(3, 3, 2), at(1, 3, 1),
                                                at(0, 2, 0), at(0, 1, 3), at(2, 0, 2)};
    for (const RationalPoint3& tip : tips) {
      if (dice_.below(3) != 0) s.add_facet({at(1, 1, 0), at(1, 1, 3), tip});
    }
    if (s.facets.empty()) s.add_free_edge(at(1, 1, 0), at(1, 1, 3));
    return s;
  }

  Dice& dice_;
};

void append(SpaceScene& scene, SpaceScene piece) {
  const auto offset = static_cast<std::uint32_t>(scene.points.size());
  scene.points.insert(scene.points.end(), piece.points.begin(), piece.points.end());
  for (SceneFacet& facet : piece.facets) {
    for (auto& cycle : facet.cycles) {
      for (std::uint32_t& v : cycle) v += offset;
    }
    for (std::uint32_t& v : facet.inner) v += offset;
    scene.facets.push_back(std::move(facet));
  }
  for (const auto& [a, b] : piece.free_edges) scene.free_edges.emplace_back(a + offset, b + offset);
}

}  // namespace

SpaceScene random_scene(Dice& dice) {
  SpaceScene scene;
  const auto pieces = dice.between(1, 5);
  std::vector<std::uint32_t> cells(27);
  std::iota(cells.begin(), cells.end(), 0U);
  for (std::int64_t i = 0; i < pieces; ++i) {
    const std::uint32_t at = dice.below(cells.size());
    const auto cell = static_cast<int>(cells[at]);
    cells.erase(cells.begin() + at);
    SpaceScene piece = Piece(dice).make();
    const std::uint32_t turn = dice.below(3);
    const RationalPoint3 shift = rational_point(4 * (cell % 3), 4 * (cell / 3 % 3), 4 * (cell / 9));
    for (RationalPoint3& p : piece.points) {
      for (std::uint32_t k = 0; k < turn; ++k) p = {p.y, p.z, p.x};
      p = p + shift;
    }
    append(scene, std::move(piece));
  }
  // Sheared: parallel to no axis. Thirds: coordinates that are no doubles.
  const std::uint32_t kind = dice.below(3);
  for (RationalPoint3& p : scene.points) {
    if (kind == 1) p = {p.x + p.y, p.y - 2 * p.z, p.z + p.x};
    if (kind == 2) p = Rational(1, 3) * p;
  }
  return scene;
}

}  // namespace plumb::testing
