// Readers and malformed files.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hostile_text.h"
#include "plumb/predicates/error.h"

namespace plumb::testing {

/// `read` must refuse each with its message at its place in the file "some.file".
template <class Read>
void expect_refusals(const std::vector<HostileText>& texts, Read read) {
  for (const HostileText& hostile : texts) {
    SCOPED_TRACE(hostile.name);
    try {
      read(hostile.bytes);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.place().file, "some.file");
      EXPECT_EQ(error.place().line, hostile.line) << error.what();
      EXPECT_EQ(error.place().column, hostile.column) << error.what();
      EXPECT_NE(error.message().find(hostile.message), std::string::npos) << error.what();
      EXPECT_LT(error.message().size(), 200U);
      EXPECT_EQ(error.message().find('\n'), std::string::npos);
    }
  }
}

}  // namespace plumb::testing
