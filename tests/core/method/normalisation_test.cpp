// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/normalisation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/method/satisfied.h"
#include "core/threads/team.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

TEST(Normalisation, MakesTheDiagonalAboutOneWithAPowerOfTwo) {
  for (const double size : {1e-6, 0.3, 1.0, 777.0, 1e7}) {
    const Points rest = test::square_grid(4).rest * size;
    const Normalisation n = normalisation_for(rest);
    const double diagonal = bounding_box_diagonal(n.to_unit_rest(rest));
    EXPECT_GT(diagonal, std::sqrt(0.5) * (1 - 1e-12));
    EXPECT_LE(diagonal, std::sqrt(2.0) * (1 + 1e-12));
    int exponent = 0;
    EXPECT_EQ(std::frexp(n.scale, &exponent), 0.5);
  }
}

TEST(Normalisation, RestPositionsComeBackBitForBit) {
  const Points rest = (test::square_grid(5).rest * 0.1).colwise() + Vec2(1e5 / 3, -7e4 / 3);
  const Normalisation n = normalisation_for(rest);
  EXPECT_EQ(n.from_unit_rest(n.to_unit_rest(rest)), rest);
}

TEST(Normalisation, DeformedPositionsComeBackWithinRoundingAndAroundTheOrigin) {
  const Points rest = test::square_grid(5).rest.colwise() + Vec2(1e5, 2e5);
  const Normalisation n = normalisation_for(rest);
  EXPECT_LT(n.to_unit(rest).cwiseAbs().maxCoeff(), 1);
  EXPECT_LT((n.from_unit(n.to_unit(rest)) - rest).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Normalisation, ThreadsMakeTheSameBits) {
  const Points points = Points::Random(2, 10'000);
  const Normalisation n{0.25, {3, -0.7}};
  const Points unit = n.to_unit(points), back = n.from_unit(points);
  EXPECT_EQ(unit, Points((points.colwise() - n.offset) * n.scale));
  EXPECT_EQ(back, Points((points / n.scale).colwise() + n.offset));
  Team team(3);
  const WithTeam with(&team);
  EXPECT_EQ(n.to_unit(points), unit);
  EXPECT_EQ(n.from_unit(points), back);
}

}  // namespace
}  // namespace foldless
