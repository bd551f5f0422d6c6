// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/paint_group.h"

#include <gtest/gtest.h>

#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

/// How many groups three squares over each other are in, as parts with these depths.
std::size_t group_count(const std::vector<double>& depths,
                        const std::vector<HandleDepth>& handles) {
  const Fixture one = square_grid(4);
  const Fixture f = both(both(one, one), one);
  MeshParts parts;
  for (const double depth : depths)
    parts.push_back({"L", static_cast<int>(16 * parts.size()), 16, depth});
  return paint_groups(std::make_shared<const Triangles>(f.triangles), 48, parts, handles).size();
}

TEST(PaintGroups, ArePartsWhoseDepthsDoNotMix) {
  EXPECT_EQ(group_count({0, 1, 2}, {}), 3U);
  EXPECT_EQ(group_count({0, 0, 2}, {}), 2U) << "equal depths do";
  EXPECT_EQ(group_count({0, 1, 2}, {{0, 0.5}}), 3U);
  EXPECT_EQ(group_count({0, 1, 2}, {{0, 1.5}}), 3U) << "as a whole over the second";
  EXPECT_EQ(group_count({0, 1, 2}, {{0, 0.5}, {3, 1.5}}), 2U) << "partly over the second";
  EXPECT_EQ(group_count({0, 1, 2}, {{0, -1}, {3, 5}}), 1U);
  EXPECT_EQ(group_count({}, {}), 1U) << "no parts";
}

TEST(PaintGroups, GoFromBackToFront) {
  const Fixture one = square_grid(4);
  const Fixture f = both(one, one);
  const MeshParts parts{{"Front", 0, 16, 3}, {"Back", 16, 16, -1}};
  const auto groups = paint_groups(std::make_shared<const Triangles>(f.triangles), 32, parts, {});
  std::vector<int> layers(36, -1);
  int next = 0;
  for (const PaintGroup& group : groups) next = group.paint_flat(next, layers);
  EXPECT_EQ(next, 2);
  for (std::size_t t = 0; t < layers.size(); ++t) EXPECT_EQ(layers[t], t < 18 ? 1 : 0) << t;
}

}  // namespace
}  // namespace foldless::test
