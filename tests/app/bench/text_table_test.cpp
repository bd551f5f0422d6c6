// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/text_table.h"

#include <gtest/gtest.h>

#include <limits>

namespace foldless {
namespace {

TEST(NumberText, KeepsSignificantDigits) {
  EXPECT_EQ(number_text(123.456), "123");
  EXPECT_EQ(number_text(12345.6), "12346");
  EXPECT_EQ(number_text(1.23456), "1.23");
  EXPECT_EQ(number_text(0.0123456), "0.0123");
  EXPECT_EQ(number_text(1.23456e-9, 2), "1.2e-09");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1e-5, 1), "1e-05");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "infinite");
}

TEST(TextTable, AlignsColumnsByCharactersAndNumbersToTheRight) {
  TextTable table({"δ", "count"});
  table.add({"no", "7"});
  table.add({"yes", "1234"});
  EXPECT_EQ(table.plain(), "δ    count\nno       7\nyes   1234\n");
}

TEST(TextTable, WritesMarkdown) {
  TextTable table({"a", "b"});
  table.add({"1", "x"});
  EXPECT_EQ(table.markdown(), "| a | b |\n|---|---|\n| 1 | x |\n");
}

TEST(TextTable, QuotesInCsvWhatNeedsIt) {
  TextTable table({"a", "b"});
  table.add({"1,5", "say \"no\""});
  EXPECT_EQ(table.csv(), "a,b\n\"1,5\",\"say \"\"no\"\"\"\n");
}

}  // namespace
}  // namespace foldless
