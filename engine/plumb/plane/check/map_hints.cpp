// Hints, from the claims of regions (map_claims.h) and the borders of the listed faces.
//
// An open edge is judged by the cycles and regions at its missing side. If cycles list that side by
// way of other vertices, it is a T-junction, or vertices have equal coordinates. If another region
// claims it, the regions overlap. If no region claims any place beside the chain of the border, the
// orientation of the chain decides: the chain is a gap, or an outer boundary that is not listed.
// The orientation alone is not enough, because the border of an overlap of two neighbours is
// clockwise, too.
//
// An overlap of two regions along one border is repaired by a change of path: between two common
// vertices, one region follows the other. At all other places, the texts only name the overlap.
//
// Tested by tests/plane/map_hints_test.cpp, which follows the hints, and
// tests/plane/map_describe_test.cpp.

#include "plumb/plane/check/map_hints.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "plumb/base/internal/message_text.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {

std::string number(std::size_t index) { return std::to_string(index + 1); }

namespace {

constexpr std::uint32_t kNoCycle = MapEdges::kNoCycle;
// The greatest number of vertices in one list of a hint.
constexpr std::size_t kMaxSpelledVertices = 12;
// The greatest number of corners of two faces whose paths are compared. It applies to each pair of
// faces.
constexpr std::size_t kMaxCompared = 1000;

const char* const kCut = "cut the overlap off one of them";

std::string regions_overlap(std::uint32_t a, std::uint32_t b) {
  return "regions " + number(std::min(a, b)) + " and " + number(std::max(a, b)) + " overlap";
}

}  // namespace

MapHints::MapHints(const MapFindings& findings, const Map& map) : findings_(findings), map_(map) {
  for (std::uint32_t c = 0; c < findings.chains.size(); ++c) {
    const auto& halfedges = findings.chains[c].halfedges;
    for (std::uint32_t i = 0; i < halfedges.size(); ++i) place_[halfedges[i]] = {c, i};
  }
  for (const EdgeContact& contact : findings.contacts.described) {
    if (contact.kind != EdgeContact::Kind::Cross) continue;
    const std::optional<std::uint32_t> a = chain_at(contact.edge_a), b = chain_at(contact.edge_b);
    if (a && a == b) crossing_.emplace(*a, &contact);
  }
}

// Returns the border chain that an edge is part of.
std::optional<std::uint32_t> MapHints::chain_at(std::uint32_t edge) const {
  for (const std::uint32_t h : {2 * edge, 2 * edge + 1}) {
    const auto found = place_.find(h);
    if (found != place_.end()) return found->second.chain;
  }
  return {};
}

std::string MapHints::vertex_name(std::uint32_t v) const {
  if (!findings_.names_places) return number(v);
  if (map_.points.is_double(v)) {
    const Point2 p = map_.points.approx(v);
    return "(" + format_double(p.x) + "," + format_double(p.y) + ")";
  }
  const RationalPoint2 p = map_.points.exact(v);
  return "(" + p.x.str() + "," + p.y.str() + ")";
}

std::string MapHints::edge_name(std::uint32_t from, std::uint32_t to) const {
  return vertex_name(from) + "-" + vertex_name(to);
}

std::string MapHints::spelled(std::span<const std::uint32_t> vertices) const {
  std::string text;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i == kMaxSpelledVertices) return text + " ...";
    text += (i == 0 ? "" : " ") + vertex_name(vertices[i]);
  }
  return text;
}

std::string MapHints::between_vertices(std::uint32_t p, std::uint32_t q) const {
  return " between vertices " + vertex_name(std::min(p, q)) + " and " + vertex_name(std::max(p, q));
}

// The change of path by which a face follows the border of another face.
std::string MapHints::follow(std::span<const std::uint32_t> path,
                             std::span<const std::uint32_t> instead_of, std::uint32_t face) const {
  return "let both follow one line, for example " + spelled(path) + " instead of " +
         spelled(instead_of) + " in face " + number(face);
}

std::span<const std::uint32_t> MapHints::corner_halfedges(std::uint32_t cycle) const {
  return {edges().at_corner.data() + map_.cycle_begin[cycle],
          edges().at_corner.data() + map_.cycle_begin[cycle + 1]};
}

bool MapHints::is_region(std::uint32_t cycle) {
  if (findings_.claims.is_known()) return findings_.claims.is_region(cycle);
  const auto [found, is_new] = is_region_.try_emplace(cycle, false);
  if (is_new) {
    found->second = polygon_area_sign(map_.points, map_.cycle(cycle)) == Sign::Positive;
  }
  return found->second;
}

// Returns the corners of a cycle from one corner to the corner before `end`. At most one corner
// more is returned than the text spells out.
MapHints::Vertices MapHints::part_of_cycle(std::uint32_t cycle, std::size_t first,
                                           std::size_t end) const {
  const auto corners = map_.cycle(cycle);
  Vertices part;
  for (std::size_t i = first % corners.size(); i != end && part.size() <= kMaxSpelledVertices;
       i = (i + 1) % corners.size()) {
    part.push_back(corners[i]);
  }
  return part;
}

// Describes a path of a face that leads from a vertex back to the same vertex, and is to be
// replaced by this vertex.
std::string MapHints::without_detour(std::uint32_t face, std::size_t first,
                                     std::size_t last) const {
  Vertices path = part_of_cycle(face, first, last);
  if (path.size() <= kMaxSpelledVertices) path.push_back(path.front());
  return spelled({path.data(), 1}) + " instead of " + spelled(path) + " in face " + number(face);
}

// ---------------------------------------------------------------- duplicate

std::string MapHints::duplicate(const MapEdges::ExtraUse& use) {
  const std::uint32_t h = use.halfedge;
  const std::uint32_t first = edges().cycle_of[h];
  const std::string edge = "the directed edge " + edge_name(edges().origin(h), edges().target(h));
  if (first != use.cycle) {
    return "faces " + number(first) + " and " + number(use.cycle) + " both use " + edge + ": " +
           both_use(first, use.cycle);
  }
  const auto halfedges = corner_halfedges(first);
  const auto at = std::ranges::find(halfedges, h);
  const auto again = std::find(at + 1, halfedges.end(), h);
  auto i = static_cast<std::size_t>(at - halfedges.begin());
  auto j = static_cast<std::size_t>(again - halfedges.begin());
  const std::size_t inside = j - i, outside = halfedges.size() - inside;
  if (outside < 3 || (inside >= 3 && outside < inside)) std::swap(i, j);
  return "face " + number(first) + " uses " + edge + " more than once: " +
         (std::max(inside, outside) < 3 ? "remove the face"
                                        : "run along it once, " + without_detour(first, i, j));
}

// Returns the advice about two faces at one side of an edge.
std::string MapHints::both_use(std::uint32_t a, std::uint32_t b) {
  const auto [found, is_new] = both_use_.try_emplace({a, b});
  if (!is_new) return found->second;
  std::string& text = found->second;
  if (is_same_cycle(a, b)) {
    text = "they are the same cycle; remove face " + number(b);
  } else if (runs_wrong_way(b) || runs_wrong_way(a)) {
    text = "face " + number(runs_wrong_way(b) ? b : a) + " runs the wrong way; reverse it";
  } else if (is_region(a) && is_region(b)) {
    const std::string cut = cut_along_common_edges(a, b);
    text = regions_overlap(a, b) + "; " + (cut.empty() ? kCut : cut);
  } else {
    const std::uint32_t clockwise = is_region(b) ? a : b;
    text = "face " + number(clockwise) +
           " runs clockwise, but is neither a hole nor an outer boundary; remove it";
  }
  return text;
}

bool MapHints::is_same_cycle(std::uint32_t a, std::uint32_t b) const {
  const auto p = corner_halfedges(a);
  const auto q = corner_halfedges(b);
  if (p.size() != q.size()) return false;
  const auto start = std::ranges::find(q, p.front());
  const auto tail = static_cast<std::size_t>(q.end() - start);
  return start != q.end() && std::equal(start, q.end(), p.begin()) &&
         std::equal(q.begin(), start, p.begin() + static_cast<std::ptrdiff_t>(tail));
}

// Whether other faces list every edge of a face in the same direction, and no face lists any in the
// opposite direction.
bool MapHints::runs_wrong_way(std::uint32_t cycle) {
  const auto [found, is_new] = wrong_way_.try_emplace(cycle, false);
  if (is_new) {
    found->second = std::ranges::all_of(corner_halfedges(cycle), [&](std::uint32_t h) {
      return edges().cycle_of[h ^ 1U] == kNoCycle && edges().uses(h).size() > 1;
    });
  }
  return found->second;
}

// Divides a cycle into the path that it has in common with another cycle, and the rest. Both have
// their two ends. Both are empty unless there is exactly one such path.
std::pair<MapHints::Vertices, MapHints::Vertices> MapHints::divided_at_common_path(
    std::uint32_t cycle, std::uint32_t other) const {
  const auto own = corner_halfedges(cycle);
  const auto theirs = corner_halfedges(other);
  const std::set<std::uint32_t> others(theirs.begin(), theirs.end());
  const std::size_t size = own.size();
  std::size_t start = 0, starts = 0, common = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (!others.contains(own[i])) continue;
    ++common;
    if (others.contains(own[(i == 0 ? size : i) - 1])) continue;
    start = i;
    ++starts;
  }
  std::pair<Vertices, Vertices> parts;
  for (std::size_t i = 0; i <= size && starts == 1; ++i) {
    const std::uint32_t v = map_.cycle(cycle)[(start + i) % size];
    if (i <= common) parts.first.push_back(v);
    if (i >= common) parts.second.push_back(v);
  }
  return parts;
}

// For two regions at one side of a common path, and of no other edge: the region with the greater
// area can follow the rest of the other region backwards.
std::string MapHints::cut_along_common_edges(std::uint32_t a, std::uint32_t b) const {
  if (std::max(map_.cycle(a).size(), map_.cycle(b).size()) > kMaxCompared) return {};
  if (twice_polygon_area(map_.points, map_.cycle(a)) <
      twice_polygon_area(map_.points, map_.cycle(b))) {
    std::swap(a, b);
  }
  const auto [path, rest] = divided_at_common_path(a, b);
  auto [other_path, other_rest] = divided_at_common_path(b, a);
  if (path.empty() || path != other_path) return {};
  std::ranges::reverse(other_rest);
  return follow(other_rest, path, a);
}

// ---------------------------------------------------------------- open

std::string MapHints::open(std::uint32_t h) {
  const std::string lead = "no face lists " + edge_name(edges().target(h), edges().origin(h)) +
                           ", the other side of " +
                           edge_name(edges().origin(h), edges().target(h)) + ": ";
  const std::string covered = covered_by(h);
  if (!covered.empty()) return lead + covered;
  const std::uint32_t missing = h ^ 1U;
  const MapClaims& claims = findings_.claims;
  if (claims.is_known()) {
    if (!claims.has_length(h / 2)) {
      return lead + "its ends are one point; use one vertex for both, or --merge-vertices";
    }
    if (claims.unlisted_faces(missing).empty()) {
      return lead + part_of_edge(h, claims.lister_beside(missing));
    }
  }
  const auto at = place_.find(missing);
  return lead + (at == place_.end() ? without_chain(h) : beside_chain(at->second));
}

// Returns the hint for a T-junction: the other side of an edge is listed in pieces, by way of
// vertices on the edge. Returns an empty text if it is not a T-junction.
std::string MapHints::covered_by(std::uint32_t h) const {
  const std::uint32_t edge = h / 2;
  const auto& on_edge = findings_.contacts.on_edge;
  const auto less = [](const VertexOnEdge& p, std::uint32_t e) { return p.edge < e; };
  auto it = std::lower_bound(on_edge.begin(), on_edge.end(), edge, less);
  Vertices path = {edges().ends[edge].from};
  for (; it != on_edge.end() && it->edge == edge; ++it) path.push_back(it->vertex);
  if (path.size() == 1) return {};
  if (compare_xy(map_.points, path[0], edges().ends[edge].to) == Sign::Positive) {
    std::reverse(path.begin() + 1, path.end());
  }
  path.push_back(edges().ends[edge].to);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (edges().find(path[i], path[i + 1]) == edges().edge_count()) return {};
  }
  std::string text;
  for (const std::uint32_t v : path) text += (text.empty() ? "" : "-") + vertex_name(v);
  return "T-junction, edge " + edge_name(path.front(), path.back()) + " is covered by " + text +
         "; insert the vertices between into face " + number(edges().cycle_of[h]);
}

// Returns the hint for an edge whose other side is listed by way of other vertices.
std::string MapHints::part_of_edge(std::uint32_t h, std::uint32_t lister) const {
  const SweepSegment& whole = edges().ends[lister];
  const auto lies_between = [&](std::uint32_t v) {
    return compare_xy(map_.points, v, whole.from) != Sign::Zero &&
           compare_xy(map_.points, v, whole.to) != Sign::Zero;
  };
  const std::uint32_t from = edges().origin(h), to = edges().target(h);
  std::uint32_t face = edges().cycle_of[2 * lister];
  if (face == kNoCycle) face = edges().cycle_of[2 * lister + 1];
  if (!lies_between(from) && !lies_between(to)) {
    return "face " + number(face) + " lists it as edge " + edge_name(whole.from, whole.to) +
           ", whose ends have equal coordinates; use the same vertices, or --merge-vertices";
  }
  std::string inserted;
  for (const std::uint32_t v : {from, to}) {
    if (lies_between(v)) inserted += (inserted.empty() ? "" : " and ") + vertex_name(v);
  }
  return "T-junction, it is a part of edge " + edge_name(whole.from, whole.to) +
         "; insert vertex " + inserted + " into face " + number(face);
}

// Returns the hint for an open edge in a map whose borders have no unique continuation because of
// duplicate uses.
std::string MapHints::without_chain(std::uint32_t h) {
  const std::uint32_t face = edges().cycle_of[h];
  if (runs_wrong_way(face)) return "face " + number(face) + " runs the wrong way; reverse it";
  const MapClaims& claims = findings_.claims;
  if (claims.is_known() && is_region(face)) {
    const std::uint32_t other = claims.other_claimant(claims.unlisted_faces(h ^ 1U), face);
    if (other != kNoCycle) {
      return regions_overlap(face, other) + " there; mend the duplicate uses first";
    }
  }
  return "mend the duplicate uses first";
}

std::string MapHints::beside_chain(Position at) {
  Border& beside = border(at.chain);
  if (!findings_.claims.is_known()) return "mend the crossings first";
  if (!beside.has_overlap()) {
    const auto crossing = crossing_.find(at.chain);
    if (crossing == crossing_.end()) return chain_as_cycle(chain(at.chain));
    const SweepSegment& a = edges().ends[crossing->second->edge_a];
    const SweepSegment& b = edges().ends[crossing->second->edge_b];
    return "this border crosses itself; mend the crossing of edges " + edge_name(a.from, a.to) +
           " and " + edge_name(b.from, b.to) + " first";
  }
  Border::Part& part = beside.parts[beside.part_of[at.place]];
  if (part.hint.empty()) {
    part.hint = lies_inside(at.chain, beside);
    if (part.hint.empty() && part.claimant != kNoCycle) {
      part.hint = overlap_at(at.chain, beside, part);
    }
  }
  if (!part.hint.empty()) return part.hint;
  const Border::Part& overlap = beside.parts[beside.overlap];
  return "this border goes on where " + conflict(overlap) + "; mend the overlap at edge " +
         edge_name(edges().target(chain(at.chain).halfedges[overlap.from]),
                   edges().origin(chain(at.chain).halfedges[overlap.from])) +
         " first";
}

MapHints::Border& MapHints::border(std::uint32_t c) {
  const auto [found, is_new] = borders_.try_emplace(c);
  if (is_new && findings_.claims.is_known()) divide(c, found->second);
  return found->second;
}

// Joins the last part of a chain to the first part if they are of the same kind.
void MapHints::join_ends(Border& border) {
  auto& parts = border.parts;
  if (parts.size() > 1 && parts.front().owner == parts.back().owner &&
      parts.front().claimant == parts.back().claimant) {
    parts.front().from = parts.back().from;
    for (std::uint32_t& p : border.part_of) p = p + 1 == parts.size() ? 0 : p;
    parts.pop_back();
  }
}

// Divides a chain into parts.
void MapHints::divide(std::uint32_t c, Border& border) const {
  const auto& halfedges = chain(c).halfedges;
  for (std::uint32_t i = 0; i < halfedges.size(); ++i) {
    const std::uint32_t owner = edges().cycle_of[halfedges[i] ^ 1U];
    const auto faces = findings_.claims.unlisted_faces(halfedges[i]);
    border.faces.insert(border.faces.end(), faces.begin(), faces.end());
    const std::uint32_t before = halfedges[(i == 0 ? halfedges.size() : i) - 1];
    if (edges().cycle_of[before ^ 1U] != owner) border.changes.push_back(i);
    const std::uint32_t claimant = findings_.claims.other_claimant(faces, owner);
    const auto goes_on = [&](const Border::Part& p) {
      return p.owner == owner && p.claimant == claimant;
    };
    if (border.parts.empty() || !goes_on(border.parts.back())) {
      border.parts.push_back({i, i, owner, claimant, {}});
    }
    border.parts.back().to = i;
    border.part_of.push_back(static_cast<std::uint32_t>(border.parts.size() - 1));
  }
  join_ends(border);
  std::ranges::sort(border.faces);
  border.faces.erase(std::unique(border.faces.begin(), border.faces.end()), border.faces.end());
  const auto found = std::ranges::find_if(
      border.parts, [](const Border::Part& p) { return p.claimant != kNoCycle; });
  border.overlap = static_cast<std::size_t>(found - border.parts.begin());
}

// Returns the hint for a component, or for a face that touches the region around it, that lies
// inside of a region as an island whose hole is not listed. Returns an empty text if there is no
// such island.
std::string MapHints::lies_inside(std::uint32_t c, const Border& border) const {
  const std::uint32_t around = border.parts.front().claimant;
  const bool is_around = std::ranges::all_of(border.faces, [&](std::uint32_t face) {
    return findings_.claims.is_only_claimant(around, face);
  });
  const bool is_owner =
      std::ranges::any_of(border.parts, [&](const Border::Part& p) { return p.owner == around; });
  if (!is_around || is_owner || chain(c).area != Sign::Negative) return {};
  const std::uint32_t inner = border.parts.front().owner;
  return regions_overlap(inner, around) + ", as region " + number(inner) + " lies inside region " +
         number(around) + "; to cut a hole for it, list the clockwise cycle " +
         spelled(cycle_of_chain(edges(), chain(c)));
}

std::string MapHints::conflict(const Border::Part& part) const {
  if (findings_.claims.is_region(part.owner)) return regions_overlap(part.owner, part.claimant);
  return "clockwise face " + number(part.owner) + " lies inside region " + number(part.claimant);
}

// Returns the hint for an edge whose missing side is claimed by another region. One region can
// follow the other if both should have the same line between two vertices. This is the case for a
// chain along two faces, even if the faces cross each other on the way, and for a part of a chain
// that ends in vertices of both faces.
std::string MapHints::overlap_at(std::uint32_t c, const Border& border,
                                 const Border::Part& part) const {
  const auto& halfedges = chain(c).halfedges;
  const auto owner = [&](std::size_t i) { return edges().cycle_of[halfedges[i] ^ 1U]; };
  const std::vector<std::size_t>& changes = border.changes;
  const std::string overlap = conflict(part);
  const bool is_between_two = changes.size() == 2 && (owner(changes[0]) == part.claimant ||
                                                      owner(changes[1]) == part.claimant);
  if (is_between_two) {
    const std::size_t own = owner(changes[0]) == part.owner ? 0 : 1;
    const Vertices back = chain_path(c, changes[own], changes[1 - own]);
    const Vertices other = chain_path(c, changes[1 - own], changes[own]);
    return overlap + one_line(part.owner, {back.rbegin(), back.rend()}, part.claimant,
                              {other.rbegin(), other.rend()});
  }
  if (!findings_.claims.is_region(part.owner)) {
    return "region " + number(part.claimant) + " lies there; face " + number(part.owner) +
           " runs clockwise, but is neither a hole nor an outer boundary; remove it";
  }
  const std::size_t beyond = (part.to + 1) % halfedges.size();
  const Vertices back = chain_path(c, part.from, beyond);
  const Vertices own = {back.rbegin(), back.rend()};
  Vertices other = path_inside(part.claimant, own.back(), own.front(), part.owner);
  if (!other.empty()) {
    return overlap + one_line(part.owner, own, part.claimant, std::move(other));
  }
  const bool is_closed = border.parts.size() == 1;
  return overlap +
         (is_closed ? " all along this border; "
                    : between_vertices(back.front(), back.back()) + "; ") +
         kCut;
}

// Returns the vertices of a chain from one place to another. If the places are the same, the
// vertices lead around once.
MapHints::Vertices MapHints::chain_path(std::uint32_t c, std::size_t from, std::size_t to) const {
  const auto& halfedges = chain(c).halfedges;
  Vertices vertices = {edges().origin(halfedges[from])};
  std::size_t i = from;
  do {
    vertices.push_back(edges().target(halfedges[i]));
    i = (i + 1) % halfedges.size();
  } while (i != to);
  return vertices;
}

// If the left side of a region's path between two vertices lies inside another region everywhere,
// returns this path; otherwise nothing.
MapHints::Vertices MapHints::path_inside(std::uint32_t region, std::uint32_t from, std::uint32_t to,
                                         std::uint32_t other) const {
  const auto corners = map_.cycle(region);
  const auto halfedges = corner_halfedges(region);
  const auto start = static_cast<std::size_t>(std::ranges::find(corners, from) - corners.begin());
  if (start == corners.size() || from == to) return {};
  Vertices vertices = {from};
  for (std::size_t n = 0; n < corners.size() && vertices.back() != to; ++n) {
    const std::uint32_t h = halfedges[(start + n) % corners.size()];
    if (!findings_.claims.overlap_beside(h / 2, {&region, 1}, {&other, 1})) return {};
    vertices.push_back(edges().target(h));
  }
  return vertices.back() == to ? vertices : Vertices();
}

// Names the vertices between which two paths lie that have opposite directions. The hint lets one
// of the faces follow the other.
std::string MapHints::one_line(std::uint32_t a, Vertices path_a, std::uint32_t b,
                               Vertices path_b) const {
  const auto is_open = [&](const Vertices& path) {
    const auto e = static_cast<std::uint32_t>(edges().find(path[0], path[1]));
    return edges().is_open(2 * e) || edges().is_open(2 * e + 1);
  };
  // The hint prefers a boundary to a region, an open path to a path that other faces list, and the
  // lesser number.
  const auto rank = [&](std::uint32_t face, const Vertices& path) {
    return std::tuple(findings_.claims.is_known() && findings_.claims.is_region(face),
                      !is_open(path), face);
  };
  if (rank(b, path_b) < rank(a, path_a)) {
    std::swap(a, b);
    std::swap(path_a, path_b);
  }
  std::ranges::reverse(path_b);
  return between_vertices(path_a.front(), path_a.back()) + "; " + follow(path_b, path_a, a);
}

std::string MapHints::chain_as_cycle(const OpenChain& chain) const {
  const std::string cycle = spelled(cycle_of_chain(edges(), chain));
  const std::string size = std::to_string(chain.halfedges.size());
  if (chain.area == Sign::Negative) {
    return "missing outer boundary of " + size + " edges; list the clockwise cycle " + cycle;
  }
  return "gap of " + size + " edges in the coverage; list the missing face " + cycle;
}

// ---------------------------------------------------------------- crossing

std::string MapHints::crossing(const EdgeContact& contact) const {
  const SweepSegment& a = edges().ends[contact.edge_a];
  const SweepSegment& b = edges().ends[contact.edge_b];
  const std::string names = "edges " + edge_name(a.from, a.to) + " and " + edge_name(b.from, b.to);
  switch (contact.kind) {
    case EdgeContact::Kind::Cross: {
      if (!findings_.claims.is_known()) return names + " cross: move a vertex";
      const auto overlap = findings_.claims.overlap_beside(
          contact.edge_a, cycles_at(edges(), contact.edge_a), cycles_at(edges(), contact.edge_b));
      if (!overlap) return names + " cross: move a vertex";
      return names + " cross, so " + regions_overlap(overlap->first, overlap->second) +
             " there: move a vertex, or " + kCut;
    }
    case EdgeContact::Kind::Touch:
      return names + " touch: vertex " + vertex_name(contact.vertex) +
             " lies inside one of them; insert it into the faces there";
    case EdgeContact::Kind::Alias:
      return names +
             " meet at two vertices with equal coordinates: use one vertex, or "
             "--merge-vertices";
    case EdgeContact::Kind::Overlap:
      return names + " overlap from vertex " + vertex_name(contact.vertex) +
             " on: insert the vertices of each into the other";
  }
  return names;
}

// ---------------------------------------------------------------- twin

// A cycle that uses an edge in both directions falls into two closed parts without it. A part of
// fewer than three corners is a spike. Two larger parts are a shell and a hole, or two faces.
std::string MapHints::twin(std::uint32_t edge, std::uint32_t cycle) const {
  const SweepSegment& ends = edges().ends[edge];
  const auto halfedges = corner_halfedges(cycle);
  const auto place = [&](std::uint32_t h) {
    return static_cast<std::size_t>(std::ranges::find(halfedges, h) - halfedges.begin());
  };
  const std::size_t size = halfedges.size(), forth = place(2 * edge), back = place(2 * edge + 1);
  const std::string lead = "face " + number(cycle) + " runs along edge " +
                           edge_name(ends.from, ends.to) + " in both directions: ";
  // The parts between the two uses, without the ends of the edge to which they return.
  const std::size_t after_forth = (back + size - forth - 1) % size;
  const std::size_t after_back = size - 2 - after_forth;
  if (std::max(after_forth, after_back) < 3) return lead + "remove the face";
  const std::size_t from = after_forth <= after_back ? forth : back;
  const std::size_t to = after_forth <= after_back ? back : forth;
  const std::string path = without_detour(cycle, from, (to + 1) % size);
  if (std::min(after_forth, after_back) < 3) return lead + "remove the spike, " + path;
  return lead + "split the face; list " + spelled(part_of_cycle(cycle, from + 1, to)) +
         " as a face, and " + path;
}

// ---------------------------------------------------------------- mixed, nested

std::string MapHints::mixed(const MapOrbits::Orbit& orbit,
                            const std::vector<std::uint32_t>& cycles) {
  std::vector<std::uint32_t> regions;
  for (const std::uint32_t c : cycles) {
    if (is_region(c)) regions.push_back(c);
  }
  if (is_turned(findings_.components.of_vertex[edges().origin(orbit.halfedge)])) {
    return "all faces of this component are listed the wrong way round: reverse each of them";
  }
  // A counter-clockwise face on the outside of a component, or on a part of it.
  if (!orbit.counterclockwise && !regions.empty()) return wrong_way_round(regions.front());
  if (regions.size() > 1) return overlap_in_orbit(orbit, regions[0], regions[1]);
  if (cycles.size() == 1) return wrong_way_round(cycles.front());
  const std::string lead =
      "one region is bounded by edges of " + std::to_string(cycles.size()) + " listed faces";
  const std::uint32_t stray = stray_among(cycles);
  if (stray == kNoCycle) return lead + ", which do not fit together: remove or reverse one";
  return lead + ": face " + number(stray) +
         " runs clockwise, but is neither a hole nor an outer boundary; remove it";
}

// Whether every face of a component, with its direction reversed, would bound one face of the
// plane.
bool MapHints::is_turned(std::uint32_t component) {
  if (is_turned_.empty()) {
    const MapOrbits& orbits = findings_.orbits;
    is_turned_.assign(findings_.components.count, orbits.of_halfedge.empty() ? 0 : 1);
    std::vector<std::uint32_t> length(orbits.orbits.size(), 0);
    for (const std::uint32_t o : orbits.of_halfedge) ++length[o];
    for (std::uint32_t c = 0; c < map_.cycle_count() && !orbits.of_halfedge.empty(); ++c) {
      const auto halfedges = corner_halfedges(c);
      const std::uint32_t first = orbits.of_halfedge[halfedges.front() ^ 1U];
      const bool is_orbit =
          length[first] == halfedges.size() && std::ranges::all_of(halfedges, [&](std::uint32_t h) {
            return orbits.of_halfedge[h ^ 1U] == first;
          });
      if (!is_orbit) is_turned_[findings_.components.of_vertex[map_.cycle(c).front()]] = 0;
    }
  }
  return is_turned_[component] != 0;
}

// Returns the hint for a face that two regions claim. If the boundary of the face consists of two
// of their paths, the first region can follow the second.
std::string MapHints::overlap_in_orbit(const MapOrbits::Orbit& orbit, std::uint32_t a,
                                       std::uint32_t b) const {
  std::vector<std::uint32_t> halfedges;
  std::uint32_t h = orbit.halfedge;
  do {
    halfedges.push_back(h);
    h = findings_.contacts.rotation.orbit_next[h];
  } while (h != orbit.halfedge);
  const auto owner = [&](std::size_t i) { return edges().cycle_of[halfedges[i]]; };
  const auto starts = [&](std::size_t i) {
    return owner(i) != owner((i == 0 ? halfedges.size() : i) - 1);
  };
  std::size_t first = 0;
  while (first < halfedges.size() && !(starts(first) && owner(first) == a)) ++first;
  std::size_t changes = 0;
  for (std::size_t i = 0; i < halfedges.size(); ++i) changes += starts(i) ? 1 : 0;
  if (changes != 2 || first == halfedges.size()) return regions_overlap(a, b) + "; " + kCut;
  std::rotate(halfedges.begin(), halfedges.begin() + static_cast<std::ptrdiff_t>(first),
              halfedges.end());
  Vertices path, rest;
  for (const std::uint32_t e : halfedges) {
    (edges().cycle_of[e] == a ? path : rest).push_back(edges().origin(e));
  }
  path.push_back(rest.front());
  rest.push_back(path.front());
  return regions_overlap(a, b) + one_line(a, path, b, rest);
}

// A face that touches itself may have the wrong direction around one of its parts. In this case, it
// should be split.
std::string MapHints::wrong_way_round(std::uint32_t cycle) const {
  const auto corners = map_.cycle(cycle);
  const std::string lead =
      "face " + number(cycle) + " is listed the wrong way round for the region it bounds: ";
  std::unordered_map<std::uint32_t, std::size_t> seen;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [before, is_new] = seen.emplace(corners[i], i);
    if (is_new) continue;
    const Vertices part = part_of_cycle(cycle, before->second, i);
    const Vertices rest = part_of_cycle(cycle, i, before->second);
    return lead + "split it at vertex " + vertex_name(corners[i]) + "; list " + spelled(part) +
           " and " + spelled(rest);
  }
  return lead + "reverse it";
}

// Returns a clockwise face that lies in several regions, and is therefore a hole of none of them.
// If there is no such face, returns any clockwise face, or kNoCycle.
std::uint32_t MapHints::stray_among(const std::vector<std::uint32_t>& cycles) {
  std::uint32_t any = kNoCycle;
  for (const std::uint32_t c : cycles) {
    if (is_region(c)) continue;
    if (any == kNoCycle) any = c;
    const MapOrbits& orbits = findings_.orbits;
    const auto halfedges = corner_halfedges(c);
    const bool is_in_one =
        orbits.of_halfedge.empty() || std::ranges::all_of(halfedges, [&](std::uint32_t h) {
          return orbits.of_halfedge[h] == orbits.of_halfedge[halfedges.front()];
        });
    if (!is_in_one) return c;
  }
  return any;
}

std::string MapHints::nested(const NestedComponent& nested, std::uint32_t inner) const {
  const std::uint32_t outside = findings_.orbits.outside[nested.component];
  const std::uint32_t start = findings_.orbits.orbits[outside].halfedge;
  Vertices boundary;
  bool is_unlisted = true;
  std::uint32_t h = start;
  do {
    boundary.push_back(edges().origin(h));
    is_unlisted = is_unlisted && edges().cycle_of[h] == kNoCycle;
    h = findings_.contacts.rotation.orbit_next[h];
  } while (h != start);
  return "face " + number(inner) + " lies inside face " + number(nested.container) +
         ", whose hole is not listed: list the clockwise " +
         (is_unlisted ? "cycle " + spelled(boundary) : "boundary of the island");
}

}  // namespace plumb
