// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/shapes.h"

#include <gtest/gtest.h>

#include "tests/support/mesh_measures.h"

namespace foldless {
namespace {

struct Named {
  const char* name;
  Drawing (*draw)();
  int euler;
};

class Drawings : public testing::TestWithParam<Named> {};

TEST_P(Drawings, AreSimpleOutlinesAtEverySampling) {
  for (const int points : {80, 150, 400, 800}) {
    const Shape shape = triangulate(sampled(GetParam().draw(), points), {});
    EXPECT_EQ(test::euler_characteristic(shape), GetParam().euler) << points;
    EXPECT_GT(test::min_angle(shape), 0) << points;
  }
}

TEST_P(Drawings, HaveAsManySamplesAsAskedFor) {
  const Outline outline = sampled(GetParam().draw(), 321);
  std::size_t count = outline.boundary.size();
  for (const Loop& hole : outline.holes) count += hole.size();
  EXPECT_EQ(count, 321u);
}

INSTANTIATE_TEST_SUITE_P(All, Drawings,
                         testing::Values(Named{"gingerbread", gingerbread, 1},
                                         Named{"alligator", alligator, 1},
                                         Named{"cowboy", cowboy, 1},
                                         Named{"bar_with_hole", bar_with_hole, 0}),
                         [](const auto& named) { return std::string(named.param.name); });

}  // namespace
}  // namespace foldless
