// Exceptions: where an Error is, and what a broken invariant does to its host.
#include "plumb/predicates/error.h"

#include <gtest/gtest.h>

#include <string>

namespace plumb::error_test {
namespace {

void break_invariant(int sides) { PLUMB_CHECK(sides == 3); }

TEST(Error, NamesTheFileLineAndColumn) {
  const Error everywhere(ErrorCode::Syntax, "expected a number", {"a.off", 3, 7});
  EXPECT_STREQ(everywhere.what(), "a.off:3:7: expected a number");
  EXPECT_EQ(everywhere.message(), "expected a number");
  EXPECT_EQ(everywhere.code(), ErrorCode::Syntax);
  EXPECT_STREQ(Error(ErrorCode::CannotOpen, "no such file", {"a.off"}).what(),
               "a.off: no such file");
  EXPECT_STREQ(Error(ErrorCode::BadArgument, "no direction").what(), "no direction");
}

TEST(BrokenInvariant, IsThrownAndNamesTheCondition) {
  EXPECT_NO_THROW(break_invariant(3));
  try {
    break_invariant(4);
    FAIL() << "nothing was thrown";
  } catch (const BrokenInvariant& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("sides == 3"), std::string::npos) << text;
    EXPECT_NE(text.find("error_test.cpp"), std::string::npos) << text;
  }
}

struct HostError {
  std::string condition;
};

TEST(BrokenInvariant, AsksTheHandlerOfTheHostFirst) {
  const auto previous = set_invariant_handler(
      [](const char* condition, const char*, int) { throw HostError{condition}; });
  EXPECT_EQ(previous, nullptr);
  try {
    break_invariant(5);
    FAIL() << "nothing was thrown";
  } catch (const HostError& error) {
    EXPECT_EQ(error.condition, "sides == 3");
  }
  EXPECT_NE(set_invariant_handler(nullptr), nullptr);
  EXPECT_THROW(break_invariant(6), BrokenInvariant);
}

/// A handler that returns has only watched.
TEST(BrokenInvariant, IsThrownAfterAHandlerThatReturns) {
  static int calls = 0;
  set_invariant_handler([](const char*, const char*, int) { ++calls; });
  EXPECT_THROW(break_invariant(7), BrokenInvariant);
  set_invariant_handler(nullptr);
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace plumb::error_test
