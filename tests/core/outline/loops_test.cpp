// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/loops.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

const Loop kNotched{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};

TEST(Loops, AreaIsPositiveWhenCounterClockwise) {
  EXPECT_EQ(area_of(kNotched), 10);
  EXPECT_EQ(area_of(Loop(kNotched.rbegin(), kNotched.rend())), -10);
}

TEST(Loops, EncloseWhatIsInside) {
  EXPECT_TRUE(encloses(kNotched, {0.5, 2}));
  EXPECT_TRUE(encloses(kNotched, {3.5, 2}));
  EXPECT_FALSE(encloses(kNotched, {2, 2}));
  EXPECT_FALSE(encloses(kNotched, {-1, 1}));
  EXPECT_FALSE(encloses(kNotched, {5, 0}));
}

}  // namespace
}  // namespace foldless
