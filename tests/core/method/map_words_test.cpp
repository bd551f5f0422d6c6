// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/map_words.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

InjectivityReport report(int inverted, int degenerate, int branch_vertices) {
  InjectivityReport report;
  report.inverted = inverted;
  report.degenerate = degenerate;
  report.branch_vertices = branch_vertices;
  return report;
}

TEST(MapWords, FoldsAreNamedBeforeWhatWindsTwice) {
  EXPECT_EQ(words_on(report(0, 0, 0)), "");
  EXPECT_EQ(words_on(report(3, 1, 2)), "4 triangles folded");
  EXPECT_EQ(words_on(report(1, 0, 0)), "1 triangle folded");
  EXPECT_EQ(words_on(report(0, 0, 7)), "fold-free but 7 interior vertices wind twice");
  EXPECT_EQ(words_on(report(0, 0, 1)), "fold-free but 1 interior vertex winds twice");
}

}  // namespace
}  // namespace foldless
