// Defects and warnings in words, with places.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/check/map_contacts.h"
#include "plumb/plane/check/map_edges.h"
#include "plumb/plane/check/map_orbits.h"
#include "plumb/plane/map_check.h"

namespace plumb {

/// A component that lies in a face of another one without being listed as its hole.
struct NestedComponent {
  std::uint32_t component;
  std::uint32_t container;  ///< the listed cycle it lies in
};

/// Everything the phases of check_map found, for describing.
struct MapFindings {
  MapEdges edges;
  MapComponents components;
  MapContacts contacts;
  MapOrbits orbits;  ///< empty when there are duplicates, open edges or contacts
  std::vector<OpenChain> chains;
  std::vector<NestedComponent> nested;
  std::vector<std::uint32_t> merged;    ///< vertices merged into another, ascending
  std::vector<std::uint32_t> inferred;  ///< cycles added by OuterRule::Infer
  bool open_is_defect = true;
};

/// Fills in report.defects (at most max_defects, by kind, then by position). Counts must be set.
void describe_defects(const MapFindings& findings, std::uint64_t max_defects, MapReport& report);

/// Fills in report.warnings; at most max_warnings of each kind are spelled out, then one line says
/// how many more there are.
void describe_warnings(const MapFindings& findings, std::uint64_t max_warnings, MapReport& report);

}  // namespace plumb
