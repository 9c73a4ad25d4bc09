// The claims of regions, from the arrangement of all edges of the map.
//
// The arrangement says for each of its edges which edges of the map contain it. Both run from left
// to right or not, so a half-edge of the map is matched with the half-edges of the arrangement on
// it by the order of its ends. Claims are collected as pairs of a face and a region and sorted.
//
// Tested by tests/plane/map_hints_test.cpp.

#include "plumb/plane/check/map_claims.h"

#include <algorithm>

#include "plumb/plane/arrangement.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {

// Collects the claims that follow from the arrangement.
class MapClaims::Collector {
 public:
  Collector(const Map& map, const MapEdges& edges, Context& context, MapClaims& result)
      : map_(map),
        edges_(edges),
        arrangement_(arrange(map.points, edges.ends, context)),
        result_(result) {}

  void run() {
    result_.is_known_ = true;
    find_regions();
    const std::size_t count = arrangement_.complex.edge_count();
    result_.face_left_of_.resize(2 * count);
    result_.lister_.assign(2 * count, kNoEdge);
    for (std::uint32_t a = 0; a < count; ++a) visit(a);
    number_pieces();
    number_claims();
  }

 private:
  // A face or an edge, and a region or edge that belongs to it.
  using Entry = std::pair<std::uint32_t, std::uint32_t>;

  void find_regions();
  void visit(std::uint32_t edge);
  void visit_use(std::uint32_t h, std::uint32_t arranged);
  void claim(std::uint32_t arranged, std::uint32_t cycle);
  bool runs_right(std::uint32_t edge) const;
  void number_pieces();
  void number_claims();
  static std::vector<std::uint32_t> begins(const std::vector<Entry>& sorted, std::size_t count);

  const Map& map_;
  const MapEdges& edges_;
  Arrangement arrangement_;
  MapClaims& result_;
  std::vector<SegmentId> origins_;
  std::vector<Entry> pieces_;  // The edges of the map, each with a half-edge of the arrangement.
  std::vector<Entry> claims_;  // The faces, each with a region.
};

void MapClaims::Collector::find_regions() {
  for (std::size_t c = 0; c < map_.cycle_count(); ++c) {
    const bool is_region = polygon_area_sign(map_.points, map_.cycle(c)) == Sign::Positive;
    result_.is_region_.push_back(is_region ? 1 : 0);
  }
}

// Whether the first half-edge of an edge of the arrangement leads to a greater point.
bool MapClaims::Collector::runs_right(std::uint32_t edge) const {
  const PlaneComplex& complex = arrangement_.complex;
  const HalfedgeId h = first_half(EdgeId(edge));
  const std::uint32_t from = complex.vertex_point[complex.dcel.origin(h)];
  const std::uint32_t to = complex.vertex_point[complex.dcel.target(h)];
  return compare_xy(PlanePointsView(complex.points), from, to) == Sign::Negative;
}

void MapClaims::Collector::visit(std::uint32_t edge) {
  const Dcel& dcel = arrangement_.complex.dcel;
  for (const std::uint32_t h : {2 * edge, 2 * edge + 1}) {
    result_.face_left_of_[h] = dcel.face(HalfedgeId(h)).value();
  }
  origins_.clear();
  arrangement_.origin_sets.append(arrangement_.origins[edge], origins_);
  const bool is_right = runs_right(edge);
  for (const SegmentId s : origins_) {
    const SweepSegment& ends = edges_.ends[s.value()];
    const bool is_same =
        (compare_xy(map_.points, ends.from, ends.to) == Sign::Negative) == is_right;
    const std::uint32_t along = 2 * edge + (is_same ? 0 : 1);
    pieces_.emplace_back(s.value(), along);
    visit_use(2 * s.value(), along);
    visit_use(2 * s.value() + 1, along ^ 1U);
  }
}

// Notes the edge and the regions that list half-edge h of the map. A half-edge of the arrangement
// is a piece of h.
void MapClaims::Collector::visit_use(std::uint32_t h, std::uint32_t arranged) {
  if (edges_.cycle_of[h] == MapEdges::kNoCycle) return;
  if (result_.lister_[arranged] == kNoEdge) result_.lister_[arranged] = h / 2;
  claim(arranged, edges_.cycle_of[h]);
  const auto& extra = edges_.extra_uses;
  const auto less = [](const MapEdges::ExtraUse& use, std::uint32_t key) {
    return use.halfedge < key;
  };
  for (auto it = std::lower_bound(extra.begin(), extra.end(), h, less);
       it != extra.end() && it->halfedge == h; ++it) {
    claim(arranged, it->cycle);
  }
}

void MapClaims::Collector::claim(std::uint32_t arranged, std::uint32_t cycle) {
  if (result_.is_region(cycle)) claims_.emplace_back(result_.face_left_of_[arranged], cycle);
}

std::vector<std::uint32_t> MapClaims::Collector::begins(const std::vector<Entry>& sorted,
                                                        std::size_t count) {
  std::vector<std::uint32_t> begin(count + 1, 0);
  for (const Entry& e : sorted) ++begin[e.first + 1];
  for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];
  return begin;
}

// The pieces of an edge remain in the order of the arrangement.
void MapClaims::Collector::number_pieces() {
  std::stable_sort(pieces_.begin(), pieces_.end(),
                   [](const Entry& p, const Entry& q) { return p.first < q.first; });
  result_.piece_begin_ = begins(pieces_, edges_.edge_count());
  for (const Entry& p : pieces_) result_.pieces_.push_back(p.second);
}

void MapClaims::Collector::number_claims() {
  std::sort(claims_.begin(), claims_.end());
  claims_.erase(std::unique(claims_.begin(), claims_.end()), claims_.end());
  result_.claim_begin_ = begins(claims_, arrangement_.complex.dcel.face_count());
  for (const Entry& c : claims_) result_.claims_.push_back(c.second);
}

MapClaims::MapClaims(const Map& map, const MapEdges& edges, Context& context) {
  Collector(map, edges, context, *this).run();
}

std::vector<std::uint32_t> MapClaims::unlisted_faces(std::uint32_t h) const {
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t along : pieces(h / 2)) {
    const std::uint32_t piece = along ^ (h & 1U);
    if (lister_[piece] == kNoEdge) faces.push_back(face_left_of_[piece]);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::uint32_t MapClaims::other_claimant(const std::vector<std::uint32_t>& faces,
                                        std::uint32_t but) const {
  std::uint32_t least = kNoCycle;
  for (const std::uint32_t face : faces) {
    const auto here = claims(face);
    const auto found = std::ranges::find_if(here, [&](std::uint32_t c) { return c != but; });
    if (found != here.end()) least = std::min(least, *found);
  }
  return least;
}

std::uint32_t MapClaims::lister_beside(std::uint32_t h) const {
  const std::uint32_t e = h / 2;
  return has_length(e) ? lister_[pieces(e).front() ^ (h & 1U)] : kNoEdge;
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> MapClaims::overlap_beside(
    std::uint32_t e, std::span<const std::uint32_t> first,
    std::span<const std::uint32_t> second) const {
  for (const std::uint32_t along : pieces(e)) {
    for (const std::uint32_t piece : {along, along ^ 1U}) {
      const auto here = claims(face_left_of_[piece]);
      const auto is_here = [&](std::uint32_t c) { return std::ranges::binary_search(here, c); };
      for (const std::uint32_t a : first) {
        if (!is_here(a)) continue;
        const auto b =
            std::ranges::find_if(second, [&](std::uint32_t c) { return c != a && is_here(c); });
        if (b != second.end()) return std::pair(a, *b);
      }
    }
  }
  return std::nullopt;
}

}  // namespace plumb
