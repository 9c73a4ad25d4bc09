// Complexes given outright, item by item: for tests of what works on items and asks for no set
// behind them. They need not be minimal, and their items may meet each other.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "plumb/space/space_complex.h"
#include "plumb/testing/dice.h"
#include "plumb/testing/exact.h"

namespace plumb::testing {

struct ComplexDraft {
  /// Corners in either direction. Of two corners: a slit, an edge with the facet on both sides.
  using Cycle = std::vector<std::uint32_t>;
  struct Facet {
    std::vector<Cycle> cycles;  ///< the outer one first, its first three corners not on a line
    std::vector<std::uint32_t> inner;  ///< vertices inside
  };

  std::vector<ExactPoint3> points;  ///< vertex i of the complex is points[i]
  std::vector<Facet> facets;
  std::vector<std::array<std::uint32_t, 2>> free_edges;

  std::uint32_t add(const ExactPoint3& p) {
    points.push_back(p);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  /// Everything of another draft.
  void add(const ComplexDraft& other);
};

/// Vertices that are doubles are input points, but for a third of them (which `dice` picks); the
/// others are constructed of planes. No volumes, all marks 0; radial lists are not in order.
SpaceComplex build_complex(const ComplexDraft& draft, std::shared_ptr<SpaceTables> tables,
                           Dice& dice);

// Shapes. Boxes and prisms are closed.
ComplexDraft tetrahedron_draft(const std::array<ExactPoint3, 4>& corners);
ComplexDraft box_draft(const ExactPoint3& low, const ExactPoint3& high);
/// Over a simple polygon of corners (x, y), from z = low to high.
ComplexDraft prism_draft(const std::vector<std::array<int, 2>>& polygon, int low, int high);

}  // namespace plumb::testing
