// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads/values_of_ranges.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace foldless {
namespace {

TEST(ValuesOfRanges, AreInTheOrderOfTheirRangesWithAnyNumberOfThreads) {
  using Range = std::pair<std::ptrdiff_t, std::ptrdiff_t>;
  for (const int threads : {1, 2, 5}) {
    Team team(threads);
    const WithTeam with(&team);
    const auto ranges =
        values_of_ranges(23, 10, [](std::ptrdiff_t begin, std::ptrdiff_t end) -> Range {
          return {begin, end};
        });
    EXPECT_EQ(ranges, (std::vector<Range>{{0, 10}, {10, 20}, {20, 23}})) << threads;
  }
}

TEST(ValuesOfRanges, WhatTheyListIsJoinedInThatOrder) {
  for (const int threads : {1, 2, 5}) {
    Team team(threads);
    const WithTeam with(&team);
    const auto odd = joined_ranges(102, 4, [](std::ptrdiff_t begin, std::ptrdiff_t end) {
      std::vector<std::ptrdiff_t> own;
      for (std::ptrdiff_t i = begin; i < end; ++i)
        if (i % 2 == 1) own.push_back(i);
      return own;
    });
    ASSERT_EQ(odd.size(), 51U) << threads;
    for (std::size_t k = 0; k < odd.size(); ++k)
      ASSERT_EQ(odd[k], static_cast<std::ptrdiff_t>(2 * k + 1)) << threads;
  }
}

}  // namespace
}  // namespace foldless
