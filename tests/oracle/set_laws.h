// What holds for sets of any space that are closed under Booleans: Nef2, NefSphere, Nef3.
#pragma once

#include <gtest/gtest.h>

namespace plumb::testing {

template <class Nef>
void expect_boolean_laws(const Nef& a, const Nef& b, const Nef& c, const Nef& all) {
  const Nef none;
  EXPECT_TRUE(a == !!a);
  EXPECT_TRUE(a + b == b + a && a * b == b * a && (a ^ b) == (b ^ a));
  EXPECT_TRUE((a + b) + c == a + (b + c) && (a * b) * c == a * (b * c));
  EXPECT_TRUE(((a ^ b) ^ c) == (a ^ (b ^ c)));
  EXPECT_TRUE((!a * !b) == !(a + b) && (!a + !b) == !(a * b));
  EXPECT_TRUE(a + a * b == a && a * (a + b) == a);
  EXPECT_TRUE(a * (b + c) == a * b + a * c && a + b * c == (a + b) * (a + c));
  EXPECT_TRUE(a - b == a * !b && (a ^ b) == (a - b) + (b - a));
  EXPECT_TRUE((a - b) + a * b == a);
  EXPECT_TRUE((a ^ all) == !a && (a ^ a) == none && (a ^ a).is_empty() && a + !a == all);
  EXPECT_TRUE(a + none == a && a * all == a && a - all == none);
}

template <class Nef>
void expect_topological_laws(const Nef& a, const Nef& b, const Nef& all) {
  EXPECT_TRUE(a.interior() == !(!a).closure() && a.closure() == !(!a).interior());
  EXPECT_TRUE(a.boundary() == a.closure() - a.interior() && a.boundary() == (!a).boundary());
  EXPECT_TRUE(a.exterior() == (!a).interior());
  EXPECT_TRUE(a.interior() + a.boundary() + a.exterior() == all);
  EXPECT_TRUE(a.closure().closure() == a.closure() && a.interior().interior() == a.interior());
  EXPECT_TRUE(a.regularization().regularization() == a.regularization());
  EXPECT_TRUE(a.closure() + b.closure() == (a + b).closure());
  EXPECT_TRUE(a.interior() * b.interior() == (a * b).interior());
}

template <class Nef>
void expect_laws_of_inclusion(const Nef& a, const Nef& b) {
  EXPECT_TRUE((a * b).is_subset_of(a) && a.is_subset_of(a + b));
  EXPECT_TRUE(a.interior().is_subset_of(a) && a.is_subset_of(a.closure()));
  EXPECT_EQ(a.is_subset_of(b), (a - b).is_empty());
  EXPECT_EQ(a == b, a.is_subset_of(b) && b.is_subset_of(a));
}

template <class Nef>
void expect_laws(const Nef& a, const Nef& b, const Nef& c, const Nef& all) {
  expect_boolean_laws(a, b, c, all);
  expect_topological_laws(a, b, all);
  expect_laws_of_inclusion(a, b);
}

}  // namespace plumb::testing
