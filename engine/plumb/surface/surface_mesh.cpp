// Construction of triangle meshes: half-edges, orientation, edges and fans, with a check that the
// mesh is an orientable manifold.
//
// Half-edge 3 f + i runs along side i of face f. Edges are found by sorting half-edges by their
// vertices (a counting sort by the lower one); two form an edge, one is a border, more are refused.
// Faces are then oriented by a search over edges: a face reached across an edge on which both
// half-edges run the same way is turned around, and a contradiction means that the component is not
// orientable. Last, the faces around each vertex must form one fan; otherwise the vertex is not
// manifold.
//
// Invariants afterwards: twins run against each other; the first half-edge of a vertex at the
// border is the one that begins its fan. Cost: O(n log d) for n faces and vertices of degree d.
// Errors list the first places only.
// Tested by tests/surface/surface_arrangement_test.cpp.
#include "plumb/surface/surface_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// SurfacePointTable has 30 bits for vertices and for edges.
constexpr std::size_t kMaxVertices = 0x3fffffffU;
constexpr std::size_t kMaxFaces = kMaxVertices / 3;

/// The first few places where a mesh is not an orientable manifold.
class Places {
 public:
  void add(const std::string& place) {
    if (++count_ <= kShown) text_ += (text_.empty() ? "" : "; ") + place;
  }
  void throw_if_any(const std::string& what) const {
    if (count_ == 0) return;
    const std::string more =
        count_ > kShown ? "; and " + std::to_string(count_ - kShown) + " more" : "";
    throw Error(ErrorCode::BadShape, what + ": " + text_ + more);
  }

 private:
  static constexpr std::size_t kShown = 10;
  std::size_t count_ = 0;
  std::string text_;
};

std::string edge_text(std::uint32_t a, std::uint32_t b) {
  return "edge " + std::to_string(std::min(a, b)) + "-" + std::to_string(std::max(a, b));
}

/// Returns half-edges sorted by the lower vertex of their edge, then by the higher one.
std::vector<HalfedgeId> halfedges_by_edge(const std::vector<SurfaceTriangle>& corners,
                                          std::size_t vertices) {
  const auto ends = [&](std::size_t h) -> std::pair<std::uint32_t, std::uint32_t> {
    const SurfaceTriangle& t = corners[h / 3];
    return std::minmax({t[h % 3], t[(h + 1) % 3]});
  };
  std::vector<std::uint32_t> begin(vertices + 1);
  const std::size_t n = 3 * corners.size();
  for (std::size_t h = 0; h < n; ++h) ++begin[ends(h).first + 1];
  for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
  std::vector<HalfedgeId> sorted(n);
  std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
  for (std::size_t h = 0; h < n; ++h) sorted[at[ends(h).first]++] = HalfedgeId(h);
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(sorted.begin() + begin[v], sorted.begin() + begin[v + 1],
              [&](HalfedgeId g, HalfedgeId h) {
                return std::pair(ends(g.value()).second, g) < std::pair(ends(h.value()).second, h);
              });
  }
  return sorted;
}

}  // namespace

SurfaceMesh::SurfaceMesh(std::vector<Point3> points, std::vector<SurfaceTriangle> triangles)
    : points_(std::move(points)), corners_(std::move(triangles)) {
  check_corners();
  pair_halfedges();
  orient_faces();
  number_edges();
  find_fans();
}

/// Throws unless every index exists, no triangle repeats a vertex, and there are enough ids.
void SurfaceMesh::check_corners() const {
  if (corners_.size() > kMaxFaces || points_.size() > kMaxVertices) {
    throw Error(ErrorCode::ResourceLimit, "a mesh of more faces than ids");
  }
  for (std::size_t f = 0; f < corners_.size(); ++f) {
    const SurfaceTriangle& t = corners_[f];
    for (const std::uint32_t v : t) {
      if (v >= points_.size()) {
        throw Error(ErrorCode::BadIndex,
                    "face " + std::to_string(f) + ": no vertex " + std::to_string(v));
      }
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      throw Error(ErrorCode::DegenerateFace, "face " + std::to_string(f) + ": a repeated vertex");
    }
  }
}

/// The two half-edges of an edge are twins. An edge with more half-edges is not a manifold. Whether
/// twins have opposite directions is decided later.
void SurfaceMesh::pair_halfedges() {
  twin_.assign(3 * corners_.size(), HalfedgeId{});
  const std::vector<HalfedgeId> sorted = halfedges_by_edge(corners_, points_.size());
  const auto ends = [&](HalfedgeId h) -> std::pair<std::uint32_t, std::uint32_t> {
    return std::minmax({origin(h).value(), target(h).value()});
  };
  Places places;
  for (std::size_t i = 0, j = 0; i < sorted.size(); i = j) {
    while (j < sorted.size() && ends(sorted[j]) == ends(sorted[i])) ++j;
    if (j == i + 2) {
      twin_[sorted[i]] = sorted[i + 1];
      twin_[sorted[i + 1]] = sorted[i];
    } else if (j > i + 2) {
      std::string faces;
      for (std::size_t k = i; k < j; ++k) faces += " " + std::to_string(face(sorted[k]).value());
      const auto [a, b] = ends(sorted[i]);
      places.add(edge_text(a, b) + " (faces" + faces + ")");
    }
  }
  places.throw_if_any("not a manifold");
}

/// Flips faces such that twins have opposite directions. If this would flip more than half of the
/// faces of a component, the other faces are flipped instead.
void SurfaceMesh::orient_faces() {
  constexpr std::uint32_t kUnseen = ~std::uint32_t{0};
  is_flipped_.assign(corners_.size(), 0);
  component_.assign(corners_.size(), kUnseen);
  Places places;
  std::vector<std::uint32_t> open, seen;  // The faces of one component.
  for (std::size_t start = 0; start < corners_.size(); ++start) {
    if (component_[start] != kUnseen) continue;
    const auto id = static_cast<std::uint32_t>(component_count_++);
    component_[start] = id;
    open.push_back(static_cast<std::uint32_t>(start));
    seen.clear();
    std::size_t flipped = 0;
    while (!open.empty()) {
      const FaceId f(open.back());
      open.pop_back();
      seen.push_back(f.value());
      flipped += is_flipped_[f];
      for (std::size_t i = 0; i < 3; ++i) {
        const HalfedgeId h = halfedge(f, i), g = twin(h);
        if (!g.is_valid()) continue;
        const std::uint32_t across = face(g).value();
        const bool agrees = origin(h) == target(g);
        const auto wanted = static_cast<std::uint8_t>(agrees == (is_flipped_[f] != 0) ? 1 : 0);
        if (component_[across] == kUnseen) {
          component_[across] = id;
          is_flipped_[across] = wanted;
          open.push_back(across);
        } else if (is_flipped_[across] != wanted && f.value() < across) {
          places.add(edge_text(origin(h).value(), target(h).value()) + " (faces " +
                     std::to_string(f.value()) + " " + std::to_string(across) + ")");
        }
      }
    }
    if (2 * flipped <= seen.size()) continue;
    for (const std::uint32_t f : seen) is_flipped_[f] ^= 1U;
  }
  places.throw_if_any("not orientable");
  const auto moved = [&](HalfedgeId h) {
    if (!h.is_valid() || is_flipped_[face(h)] == 0) return h;
    return halfedge(face(h), 2 - side(h));
  };
  for (HalfedgeId& h : twin_) h = moved(h);
  for (std::size_t f = 0; f < corners_.size(); ++f) {
    if (is_flipped_[f] == 0) continue;
    std::swap(corners_[f][1], corners_[f][2]);
    std::swap(twin_[3 * f], twin_[3 * f + 2]);
  }
}

void SurfaceMesh::number_edges() {
  edge_.resize(twin_.size());
  edge_halfedge_.reserve(twin_.size() / 2 + 1);
  for (std::size_t i = 0; i < twin_.size(); ++i) {
    const HalfedgeId h(i);
    if (twin(h).is_valid() && twin(h) < h) {
      edge_[i] = edge(twin(h));
    } else {
      edge_[i] = EdgeId(edge_halfedge_.size());
      edge_halfedge_.push_back(h);
    }
  }
}

/// Counts the half-edges that leave each vertex, and those reached by turning around it. If the
/// numbers differ, the faces around it form more than one fan.
void SurfaceMesh::find_fans() {
  vertex_halfedge_.assign(points_.size(), HalfedgeId{});
  std::vector<std::uint32_t> degree(points_.size());
  for (std::size_t i = 0; i < twin_.size(); ++i) {
    const HalfedgeId h(i);
    const std::uint32_t v = origin(h).value();
    ++degree[v];
    if (!vertex_halfedge_[v].is_valid() || is_border(h)) vertex_halfedge_[v] = h;
  }
  Places places;
  for (std::size_t v = 0; v < points_.size(); ++v) {
    const HalfedgeId first = vertex_halfedge_[v];
    std::uint32_t seen = 0;
    for (HalfedgeId h = first; h.is_valid();) {
      ++seen;
      h = twin(prev(h));
      if (h == first) break;
    }
    if (seen != degree[v]) places.add("vertex " + std::to_string(v));
  }
  places.throw_if_any("not a manifold");
}

VertexId SurfaceMesh::lower(EdgeId e) const {
  const HalfedgeId h = halfedge(e);
  return std::min(origin(h), target(h));
}

VertexId SurfaceMesh::upper(EdgeId e) const {
  const HalfedgeId h = halfedge(e);
  return std::max(origin(h), target(h));
}

}  // namespace plumb
