#include "sim/results/recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace wale {
namespace {

TEST(Recorder, FillsLackingNumbersWithNaNBothWays) {
  Table table;
  append_row(table, {{"t", "s", 0}, {"energy.stretch", "J", 1}});
  append_row(table, {{"t", "s", 1}, {"force", "N", 2}});
  append_row(table, {{"force", "N", 3}});
  ASSERT_EQ(table.rows(), 3U);
  ASSERT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.columns[0].name, "t");
  EXPECT_EQ(table.columns[2].unit, "N");
  for (const Column& column : table.columns) ASSERT_EQ(column.values.size(), 3U);
  EXPECT_TRUE(std::isnan(table.find("force")->values[0]));
  EXPECT_EQ(table.find("force")->values[2], 3);
  EXPECT_TRUE(std::isnan(table.find("energy.stretch")->values[1]));
  EXPECT_TRUE(std::isnan(table.find("t")->values[2]));
  EXPECT_EQ(table.find("energy.bend"), nullptr);
}

TEST(Recorder, RefusesTwoValuesForOneColumnAndAChangeOfUnit) {
  Table table;
  append_row(table, {{"t", "s", 0}});
  EXPECT_THROW(append_row(table, {{"t", "ms", 1}}), std::invalid_argument);
  EXPECT_THROW(append_row(table, {{"t", "s", 1}, {"t", "s", 2}}), std::invalid_argument);
}

}  // namespace
}  // namespace wale
