// Models of OpenSCAD against the oracle of cells of half-spaces.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace plumb::testing {

/// Reads and evaluates the model of a program (model_program.h). Returns the empty text if
///   - the solid passes its audit, is closed, and is its own regularization,
///   - all planes of its facets are planes of leaves of the model,
///   - in every cell of these planes a point belongs to it exactly if the Boolean function of the
///     leaves says so, and a corner exactly if a cell around it belongs to it,
///   - the model in another order, and the model evaluated node by node, give the same bytes in
///     canonical form.
/// The first three say that the solid is the right one. Otherwise returns what is wrong.
std::string flaw_of_model(std::span<const std::uint8_t> program);

}  // namespace plumb::testing
