// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/text_lines.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace foldless {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (TextLines reader(text); reader.next();) lines.emplace_back(reader.line());
  return lines;
}

TEST(TextLines, EndInAnyOfTheThreeWays) {
  const std::vector<std::string> expected{"a", "", "b", "c"};
  EXPECT_EQ(lines_of("a\n\nb\nc"), expected);
  EXPECT_EQ(lines_of("a\r\n\r\nb\r\nc\r\n"), expected);
  EXPECT_EQ(lines_of("a\r\rb\rc\r"), expected);
}

TEST(TextLines, SkipAByteOrderMark) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBFv 1"), std::vector<std::string>{"v 1"});
}

TEST(Words, AreSeparatedByBlanksAndTabs) {
  Words words("  v\t1.5   -2 ");
  EXPECT_EQ(words.next(), "v");
  EXPECT_EQ(words.next(), "1.5");
  EXPECT_EQ(words.next(), "-2");
  EXPECT_EQ(words.next(), "");
}

TEST(ParseNumber, TakesDecimalNumbersOnly) {
  EXPECT_EQ(parse_number("+1.5e3"), 1500);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("7"), 7);
  for (const char* word : {"", "+", "+-1", "1,5", "abc", "1.5x", "0x10", "1.#QNAN", "--1"})
    EXPECT_FALSE(parse_number(word)) << word;
}

TEST(ParseNumber, TellsTooLargeFromTooSmall) {
  EXPECT_EQ(parse_number("1e999"), HUGE_VAL);
  EXPECT_EQ(parse_number("-1e999"), -HUGE_VAL);
  EXPECT_EQ(parse_number("1e-999"), 0);
  for (const char* word : {"0.1e400", "0.001e+999", "+12e308", "1e99999999999999999999"})
    EXPECT_EQ(parse_number(word), HUGE_VAL) << word;
  for (const char* word : {"-0.1E400", "-900.5e307"})
    EXPECT_EQ(parse_number(word), -HUGE_VAL) << word;
  for (const char* word : {"0.1e-400", "12345e-400", "-1000.5E-999", "0.001e-99999999999999999999"})
    EXPECT_EQ(parse_number(word), 0) << word;
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1e300"), 1e-101);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1e10"), 0);
  EXPECT_EQ(parse_number("1" + std::string(400, '0')), HUGE_VAL);
  EXPECT_EQ(parse_number("1" + std::string(400, '0') + "e-400"), 1);
  EXPECT_EQ(parse_number("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
  EXPECT_TRUE(std::isinf(*parse_number("-inf")));
}

TEST(ParseInteger, RefusesWhatDoesNotFit) {
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_EQ(parse_integer("+3"), 3);
  for (const char* word : {"", "1.0", "99999999999", "1a"})
    EXPECT_FALSE(parse_integer(word)) << word;
}

TEST(AppendNumber, ReadsBackBitForBit) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    std::string text;
    append_number(text, value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*parse_number(text)),
              std::bit_cast<std::uint64_t>(value))
        << text;
  }
}

TEST(AppendNumber, IsShortest) {
  std::string text;
  append_number(text, 0.1);
  append_number(text += ' ', 3.0);
  append_number(text += ' ', 1e-5);
  EXPECT_EQ(text, "0.1 3 1e-05");
}

TEST(InQuotes, MakesOneShortPrintableLine) {
  EXPECT_EQ(in_quotes("a\nb\xff"), "'a?b?'");
  EXPECT_EQ(in_quotes(std::string(1000, 'x')).size(), 45u);
}

}  // namespace
}  // namespace foldless
