/// Recorded outputs in tests/golden/.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace wale {

/// Compares with the file `name` in tests/golden/. Where they differ, the message holds the text that came.
inline void expect_golden(const std::string& name, const std::string& text) {
  std::ifstream file(std::string(WALE_SOURCE_DIR) + "/tests/golden/" + name);
  ASSERT_TRUE(file) << "no golden file " << name << "; the text was\n" << text;
  const std::string recorded{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(recorded, text) << name;
}

}  // namespace wale
