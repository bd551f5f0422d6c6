// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/wire_corners.h"

#include <gtest/gtest.h>

#include <array>

namespace foldless::test {
namespace {

/// A square with the diagonal from 0 to 2; 4 long, 3 high.
constexpr std::array<float, 8> kPositions{0, 0, 4, 0, 4, 3, 0, 3};
const std::vector<std::uint32_t> kCorners{0, 1, 2, 0, 2, 3};

std::vector<bool> outline() { return hidden_edges(kCorners, mesh_edges(kCorners).boundary); }

TEST(WireCorners, OnlyBoundaryEdgesAreHidden) {
  // The diagonal lies opposite corner 1 of the first triangle and corner 2 of the second.
  EXPECT_EQ(outline(), (std::vector<bool>{true, false, true, true, true, false}));
}

TEST(WireCorners, HeightsAndLengthsAreThoseOfTheTriangles) {
  const auto wire = wire_corners(kCorners, {0, 1}, std::vector<bool>(6, false), kPositions);
  ASSERT_EQ(wire.size(), 6U);
  EXPECT_EQ(wire[0].lengths, glm::vec3(3, 5, 4));
  EXPECT_FLOAT_EQ(wire[0].height, 4);
  EXPECT_FLOAT_EQ(wire[1].height, 12.0F / 5);
  EXPECT_FLOAT_EQ(wire[2].height, 3);
  EXPECT_EQ(wire[4].position, glm::vec2(4, 3));
}

TEST(WireCorners, TrianglesComeInTheOrderInWhichTheyArePainted) {
  const auto wire = wire_corners(kCorners, {1, 0}, outline(), kPositions);
  EXPECT_EQ(wire[2].position, glm::vec2(0, 3));
  EXPECT_EQ(wire[0].lengths, glm::vec3(-1, -1, 5));
  EXPECT_EQ(wire[3].lengths, glm::vec3(-1, 5, -1));
}

TEST(WireCorners, ATriangleWithoutAreaHasNoHeights) {
  constexpr std::array<float, 6> kPoint{1, 1, 1, 1, 1, 1};
  const auto wire =
      wire_corners(std::vector<std::uint32_t>{0, 1, 2}, {0}, std::vector<bool>(3, false), kPoint);
  for (const WireCorner& corner : wire) EXPECT_EQ(corner.height, 0);
}

}  // namespace
}  // namespace foldless::test
