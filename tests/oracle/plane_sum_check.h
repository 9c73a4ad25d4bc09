// Is this the Minkowski sum of two sets of the plane? By the Boolean of A with p - B at single
// points p.
#pragma once

#include <string>

#include "plumb/plane/nef2.h"

namespace plumb::testing {

/// Empty, or what is wrong with minkowski_sum(a, b): an audit rejects it, it depends on the order
/// of the operands, it is not closed although both operands are, or a point is in the sum although
/// A does not meet p - B, or the other way round. The points are those at which two sets that
/// differ are likely to differ: the vertices and edges of the sum, sums of vertices, and points
/// between these. Requires bounded operands.
std::string flaw_of_sum(const Nef2& a, const Nef2& b);

}  // namespace plumb::testing
