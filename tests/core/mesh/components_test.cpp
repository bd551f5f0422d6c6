// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/components.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(Components, TrianglesConnectTheirVerticesAndNobodyElse) {
  Triangles triangles(3, 3);
  triangles << 0, 3, 5,  //
      1, 4, 6,           //
      2, 5, 3;
  const std::vector<int> component = components_of(triangles, 8);
  ASSERT_EQ(component.size(), 8u);
  EXPECT_EQ(component[0], component[1]);
  EXPECT_EQ(component[0], component[2]);
  for (const int v : {4, 5, 6}) EXPECT_EQ(component[3], component[static_cast<std::size_t>(v)]);
  EXPECT_NE(component[0], component[3]);
  EXPECT_NE(component[7], component[0]);
  EXPECT_NE(component[7], component[3]);
}

}  // namespace
}  // namespace foldless
