// The defects and warnings of a checked map in words, with their places.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/check/map_claims.h"
#include "plumb/plane/check/map_contacts.h"
#include "plumb/plane/check/map_edges.h"
#include "plumb/plane/check/map_orbits.h"
#include "plumb/plane/map_check.h"

namespace plumb {

/// A component that lies in a face of another one and is not listed as its hole.
struct NestedComponent {
  std::uint32_t component;  ///< The component.
  std::uint32_t container;  ///< The listed cycle in which it lies.
};

/// The results of all phases of check_map().
struct MapFindings {
  MapEdges edges;                       ///< The edges.
  MapComponents components;             ///< The connected components.
  MapContacts contacts;                 ///< Contacts of edges.
  MapOrbits orbits;                     ///< Empty if there are duplicates, open edges or contacts.
  std::vector<OpenChain> chains;        ///< Borders that no cycle lists.
  std::vector<NestedComponent> nested;  ///< Components that are not listed as holes.
  std::vector<std::uint32_t> merged;    ///< Vertices merged into another, ascending.
  std::vector<std::uint32_t> inferred;  ///< Cycles that OuterRule::Infer added.
  bool open_is_defect = true;           ///< Whether open edges are defects.
  MapClaims claims;                     ///< Known only for defective maps.
  bool names_places = false;            ///< Whether hints name vertices by their coordinates.
};

/// Returns all cycles that list an edge, in either direction. A cycle that lists it several times
/// occurs as often.
std::vector<std::uint32_t> cycles_at(const MapEdges& edges, std::uint32_t edge);

/// Sets report.defects: at most max_defects, by kind, then by position. Requires that the counts of
/// the report are set.
void describe_defects(const MapFindings& findings, std::uint64_t max_defects, MapReport& report);

/// Sets report.warnings. At most max_warnings of each kind are spelled out, then one line says how
/// many more there are.
void describe_warnings(const MapFindings& findings, std::uint64_t max_warnings, MapReport& report);

}  // namespace plumb
