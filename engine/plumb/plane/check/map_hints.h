// The hints of a map check. The hint of a defect is a sentence that says what is wrong and how to
// correct it.
//
// A hint that names a change leads to a valid map if it is followed, where the defect is the only
// one; tests/plane/map_hints_test.cpp follows every kind of hint. If another defect must be mended
// first, because otherwise a change would lead to this other defect, the hint says so.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plumb/plane/check/map_describe.h"
#include "plumb/plane/map.h"

namespace plumb {

/// Makes the hints of one map. In all texts, faces are counted from 1. Vertices are counted from 1,
/// too, unless MapFindings::names_places is set.
class MapHints {
 public:
  /// Requires that both outlive the object.
  MapHints(const MapFindings& findings, const Map& map);

  std::string duplicate(const MapEdges::ExtraUse& use);
  std::string open(std::uint32_t h);
  std::string crossing(const EdgeContact& contact) const;
  std::string twin(std::uint32_t edge, std::uint32_t cycle) const;
  /// `cycles` are the listed cycles with half-edges in the orbit, ascending.
  std::string mixed(const MapOrbits::Orbit& orbit, const std::vector<std::uint32_t>& cycles);
  std::string nested(const NestedComponent& nested, std::uint32_t inner) const;

 private:
  using Vertices = std::vector<std::uint32_t>;

  /// The kinds of claims at the missing sides of a border chain.
  struct Border {
    /// A part of the chain of which the twins are listed by one face, and claimed by one region.
    struct Part {
      std::uint32_t from, to;  ///< Positions in the chain; the part may run over its end.
      std::uint32_t owner;     ///< The face.
      std::uint32_t claimant;  ///< Another region that claims the missing side, or kNoCycle.
      std::string hint;        ///< The hint of all its edges, when it is known.
    };
    std::vector<Part> parts;
    std::vector<std::uint32_t> part_of;  ///< For each half-edge of the chain, its part.
    std::vector<std::uint32_t> faces;    ///< All faces at the missing sides, ascending.
    std::vector<std::size_t> changes;    ///< Positions where the face beside the chain changes.
    std::size_t overlap = 0;             ///< The first part with a claimant, if there is one.
    bool has_overlap() const { return overlap < parts.size(); }
  };
  struct Position {
    std::uint32_t chain, place;
  };

  const MapEdges& edges() const { return findings_.edges; }
  const OpenChain& chain(std::uint32_t c) const { return findings_.chains[c]; }
  std::string vertex_name(std::uint32_t v) const;
  std::string edge_name(std::uint32_t from, std::uint32_t to) const;
  std::string spelled(std::span<const std::uint32_t> vertices) const;
  std::string between_vertices(std::uint32_t p, std::uint32_t q) const;
  std::string follow(std::span<const std::uint32_t> path, std::span<const std::uint32_t> instead_of,
                     std::uint32_t face) const;
  std::span<const std::uint32_t> corner_halfedges(std::uint32_t cycle) const;
  bool is_region(std::uint32_t cycle);
  Vertices part_of_cycle(std::uint32_t cycle, std::size_t first, std::size_t end) const;

  std::string without_detour(std::uint32_t face, std::size_t first, std::size_t last) const;
  std::string both_use(std::uint32_t a, std::uint32_t b);
  bool is_same_cycle(std::uint32_t a, std::uint32_t b) const;
  bool runs_wrong_way(std::uint32_t cycle);
  std::pair<Vertices, Vertices> divided_at_common_path(std::uint32_t cycle,
                                                       std::uint32_t other) const;
  std::string cut_along_common_edges(std::uint32_t a, std::uint32_t b) const;

  std::optional<std::uint32_t> chain_at(std::uint32_t edge) const;
  std::string covered_by(std::uint32_t h) const;
  std::string part_of_edge(std::uint32_t h, std::uint32_t lister) const;
  std::string beside_chain(Position at);
  std::string without_chain(std::uint32_t h);
  Border& border(std::uint32_t chain);
  static void join_ends(Border& border);
  void divide(std::uint32_t chain, Border& border) const;
  std::string conflict(const Border::Part& part) const;
  std::string overlap_at(std::uint32_t chain, const Border& border, const Border::Part& part) const;
  Vertices chain_path(std::uint32_t chain, std::size_t from, std::size_t to) const;
  Vertices path_inside(std::uint32_t region, std::uint32_t from, std::uint32_t to,
                       std::uint32_t other) const;
  std::string one_line(std::uint32_t a, Vertices path_a, std::uint32_t b, Vertices path_b) const;
  std::string lies_inside(std::uint32_t chain, const Border& border) const;
  std::string chain_as_cycle(const OpenChain& chain) const;

  std::string overlap_in_orbit(const MapOrbits::Orbit& orbit, std::uint32_t a,
                               std::uint32_t b) const;
  bool is_turned(std::uint32_t component);
  std::string wrong_way_round(std::uint32_t cycle) const;
  std::uint32_t stray_among(const std::vector<std::uint32_t>& cycles);

  const MapFindings& findings_;
  const Map& map_;
  std::unordered_map<std::uint32_t, Position> place_;  // Of half-edges in chains.
  std::unordered_map<std::uint32_t, Border> borders_;  // Of chains.
  std::unordered_map<std::uint32_t, const EdgeContact*>
      crossing_;                                       // One of each chain that has one.
  std::unordered_map<std::uint32_t, bool> is_region_;  // Of cycles.
  std::unordered_map<std::uint32_t, bool> wrong_way_;  // Of cycles.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> both_use_;
  std::vector<char> is_turned_;  // Of components.
};

/// Returns the number of an index for a text, counted from 1.
std::string number(std::size_t index);

}  // namespace plumb
