// Makes the faces of the regions of facets.
//
// A region becomes one polygon if the options allow it and its outline is one cycle without
// repeated vertices. Otherwise, it is triangulated. Each edge of the complex in an outline is
// replaced by the chain of the vertices inside of it, so that faces of different facets meet in
// common edges.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/region_faces.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "plumb/predicates/space/rounded_point3.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/planar/triangulate.h"
#include "plumb/space/set/whole_facets.h"

namespace plumb {
namespace {

/// Returns the outline of a whole facet that gets vertices inside its edges.
Outline outline_of_facet(const SpaceComplex& c, FacetId f) {
  Outline outline;
  for_each_use(c, f, [&](UseId u) {
    outline.edges.push_back(
        {c.use_origin(u), c.use_origin(c.use_next[u]), SpaceComplex::edge_of(c.use_halfedge[u])});
  });
  const auto inner = c.inner_of(f);
  outline.inner.assign(inner.begin(), inner.end());
  return outline;
}

/// Makes faces of regions.
class RegionFaces {
 public:
  RegionFaces(const CutState& state, CutBoundary& result)
      : complex_(state.complex()),
        cuts_(state.edge_cuts),
        faces_(state.options.faces),
        shown_(state.tables().points),
        of_facet_(state.complex()),
        result_(result) {}

  /// Adds the faces of a region that has an outline.
  void add(const Region& region, const Outline& outline) {
    chains_.clear();
    for (const RegionEdge& e : outline.edges) add_chain(e);
    if (chains_.size() == 3 && outline.inner.empty()) {
      cycle_ = {chains_[0].first, chains_[1].first, chains_[2].first};
      if (chains_[0].second != cycle_[1]) std::swap(cycle_[1], cycle_[2]);
      return add_face(region, cycle_);
    }
    if (outline.inner.empty() && is_cycle() && may_be_polygon()) return add_face(region, cycle_);
    triangulate_region(region, outline.inner);
  }

  /// Adds the faces of a region that is a whole facet and has no vertices inside its edges.
  void add_facet(const Region& region, FacetId f) {
    if (complex_.cycles_of(f).size() == 1 && complex_.inner_of(f).empty()) {
      cycle_.clear();
      for_each_use(complex_, f, [&](UseId u) { cycle_.push_back(complex_.use_origin(u)); });
      if (cycle_.size() == 3 || (may_be_polygon() && !has_repeats())) {
        return add_face(region, cycle_);
      }
    }
    of_facet_.for_each(f, [&](VertexId a, VertexId b, VertexId c) {
      add_face(region, std::array{a, b, c});
    });
  }

 private:
  void add_face(const Region& region, std::span<const VertexId> cycle) {
    auto& corners = result_.corners;
    corners.insert(corners.end(), cycle.begin(), cycle.end());
    if (region.is_reversed) {
      // The first corner remains the first.
      std::reverse(corners.end() - static_cast<std::ptrdiff_t>(cycle.size()) + 1, corners.end());
    }
    result_.face_begin.push_back(static_cast<std::uint32_t>(corners.size()));
    result_.piece.push_back(region.piece);
  }

  /// Whether the options allow cycle_ as a face.
  bool may_be_polygon() const {
    if (faces_ != MeshFaces::PlanarPolygons) return faces_ == MeshFaces::Polygons;
    return std::all_of(cycle_.begin(), cycle_.end(), [&](VertexId v) {
      return rounded(complex_.points(), complex_.vertex_point[v]).is_exact;
    });
  }
  bool has_repeats() {
    vertices_ = cycle_;
    std::sort(vertices_.begin(), vertices_.end());
    return std::adjacent_find(vertices_.begin(), vertices_.end()) != vertices_.end();
  }

  /// Sets cycle_ to the vertices along chains_. Returns false if they do not form a single cycle
  /// that visits no vertex twice.
  bool is_cycle() {
    std::sort(chains_.begin(), chains_.end());
    const auto next = [&](VertexId v) {
      return std::partition_point(chains_.begin(), chains_.end(),
                                  [v](const auto& e) { return e.first < v; });
    };
    const auto is_same_start = [](const auto& e, const auto& f) { return e.first == f.first; };
    if (std::adjacent_find(chains_.begin(), chains_.end(), is_same_start) != chains_.end()) {
      return false;
    }
    cycle_.clear();
    VertexId v = chains_.front().first;
    do {
      cycle_.push_back(v);
      const auto at = next(v);
      PLUMB_CHECK(at != chains_.end() && at->first == v);
      v = at->second;
    } while (v != cycle_.front());
    return cycle_.size() == chains_.size();
  }

  void triangulate_region(const Region& region, std::span<const VertexId> inner) {
    list_vertices(inner);
    shown_.reset(FlatView::of_plane(complex_.planes(), region.plane));
    for (const VertexId v : vertices_) shown_.push_back(complex_.vertex_point[v]);
    std::vector<IndexEdge> edges;
    for (const auto& [v, w] : chains_) edges.push_back({index_of(v), index_of(w)});
    std::vector<IndexTriangle> triangles;
    PLUMB_CHECK(triangulate(shown_, edges, triangles));
    for (const IndexTriangle& t : triangles) {
      add_face(region, std::array{vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]});
    }
  }
  void add_chain(const RegionEdge& e) {
    const RegionEdge part{cuts_.merged(e.from), cuts_.merged(e.to), e.edge};
    chain_.assign(1, part.from);
    if (part.edge.is_valid()) cuts_.append_between(part, chain_);
    chain_.push_back(part.to);
    for (std::size_t i = 0; i + 1 < chain_.size(); ++i) {
      chains_.emplace_back(chain_[i], chain_[i + 1]);
    }
  }
  void list_vertices(std::span<const VertexId> inner) {
    vertices_.assign(inner.begin(), inner.end());
    for (const auto& [v, w] : chains_) {
      vertices_.push_back(v);
      vertices_.push_back(w);
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }
  std::uint32_t index_of(VertexId v) const {
    return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                                      vertices_.begin());
  }

  const SpaceComplex& complex_;
  const EdgeCuts& cuts_;
  MeshFaces faces_;
  FlatPoints shown_;
  FacetTriangles of_facet_;
  CutBoundary& result_;
  std::vector<std::pair<VertexId, VertexId>> chains_;  // The edges of the region.
  std::vector<VertexId> chain_;
  std::vector<VertexId> cycle_;
  std::vector<VertexId> vertices_;
};

/// Whether a facet has an edge with vertices inside.
bool has_cut_edge(const CutState& state, FacetId f) {
  if (state.edge_cuts.is_empty()) return false;
  bool has_cut = false;
  for_each_use(state.complex(), f, [&](UseId u) {
    const EdgeId e = SpaceComplex::edge_of(state.complex().use_halfedge[u]);
    has_cut = has_cut || state.edge_cuts.has(e);
  });
  return has_cut;
}

}  // namespace

CutBoundary faces_of_regions(CutState& state) {
  CutBoundary result;
  result.corners.reserve(3 * state.regions.size());
  result.face_begin.reserve(state.regions.size() + 1);
  result.piece.reserve(state.regions.size());
  RegionFaces faces(state, result);
  for (std::size_t r = 0; r < state.regions.size(); ++r) {  // Regions may be added during the loop.
    const Region region = state.regions[r];
    const FacetId facet = state.pieces[region.piece].facet;
    if (region.outline != kNone) {
      faces.add(region, state.outlines[region.outline]);
    } else if (!has_cut_edge(state, facet)) {
      faces.add_facet(region, facet);
    } else if (!add_triangles_of_cut_face(state, region)) {
      faces.add(region, outline_of_facet(state.complex(), facet));
    }
  }
  result.pieces = std::move(state.pieces);
  return result;
}

}  // namespace plumb
