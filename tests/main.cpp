// The main function of a program of tests. Its arguments are names of test files without the
// extension, for example nef3_test: then it runs the tests of these files, otherwise all tests.
// Options of GoogleTest come before the names.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <string>

namespace {

/// Returns a filter of GoogleTest that selects the tests of one file; empty if it has no test.
std::string tests_of(const std::string& name) {
  std::string filter;
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const ::testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const ::testing::TestInfo& test = *suite.GetTestInfo(j);
      if (std::filesystem::path(test.file()).stem() != name) continue;
      filter += std::string(suite.name()) + '.' + test.name() + ':';
    }
  }
  return filter;
}

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  std::string filter;
  for (int i = 1; i < argc; ++i) {
    const std::string tests = tests_of(argv[i]);
    if (tests.empty()) {
      std::cerr << argv[0] << ": no tests of a file " << argv[i] << ".cpp\n";
      return 2;
    }
    filter += tests;
  }
  if (!filter.empty()) ::testing::GTEST_FLAG(filter) = filter;
  return RUN_ALL_TESTS();
}
