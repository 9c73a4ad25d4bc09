// The contacts of two complexes by trying every pair of items in rational coordinates: the twin of
// find_contacts().
#pragma once

#include <vector>

#include "generate/complex_draft.h"

namespace plumb::testing {

struct ExpectedContact {
  SpaceItem a;
  SpaceItem b;
  ExactPoint3 point;
};

/// Of the complexes built from two drafts; sorted by (a, b). Only the ends of edges are read from
/// the complexes, so that their numbers are known.
std::vector<ExpectedContact> contacts_by_force(const ComplexDraft& a, const SpaceComplex& built_a,
                                               const ComplexDraft& b, const SpaceComplex& built_b);

}  // namespace plumb::testing
