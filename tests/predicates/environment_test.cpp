// The self-test tells what the environment is, and the predicates do not mind it.
#include "plumb/predicates/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "float_environment.h"

namespace plumb::test::environment_test {
namespace {

bool mentions(const SelfTestReport& r, const std::string& words) {
  return std::any_of(r.notes.begin(), r.notes.end(),
                     [&](const std::string& s) { return s.find(words) != std::string::npos; });
}

TEST(SelfTest, PassesAndNotesTheEnvironment) {
  for (const testing_environment::Setting& mode : testing_environment::kSettings) {
    const testing_environment::Scope scope(mode);
    const SelfTestReport r = self_test();
    EXPECT_TRUE(r.ok) << mode.name << ": " << (r.failures.empty() ? "" : r.failures.front());
    EXPECT_EQ(mentions(r, "rounding mode"), mode.rounding != FE_TONEAREST) << mode.name;
#if defined(__x86_64__)
    EXPECT_EQ(mentions(r, "flushed"), mode.flush) << mode.name;
    EXPECT_EQ(mentions(r, "read as zero"), mode.flush) << mode.name;
#endif
    EXPECT_FALSE(mentions(r, "fused")) << mode.name;
  }
}

}  // namespace
}  // namespace plumb::test::environment_test
