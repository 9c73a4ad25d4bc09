// Is a Minkowski sum right, place by place? By Booleans: x is a sum of A and B where A and x - B
// meet.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "plumb/space/nef3.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

/// Of a bounded set.
std::vector<RationalPoint3> vertices(const Nef3& set);
RationalPoint3 plus(const RationalPoint3& p, const RationalPoint3& q);

/// Is x = a + b for some a in A and b in B?
bool is_sum(const Nef3& a, const Nef3& b, const RationalPoint3& x);

/// What the audit of `both` says, else the first place where it is not the sum of A and B, else
/// nothing. `samples` are drawn of places in and beside its items, and of those of A moved.
/// Requires bounded sets, none of them empty.
std::string wrong_place(const Nef3& both, const Nef3& a, const Nef3& b, Dice& dice,
                        std::size_t samples);

}  // namespace plumb::testing
