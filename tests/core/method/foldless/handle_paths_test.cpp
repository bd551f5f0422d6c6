// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/handle_paths.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foldless {
namespace {

constexpr double kPi = std::numbers::pi;

Points ring(int count, double radius, double turn, const Vec2& centre) {
  Points points(2, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count + turn;
    points.col(i) = centre + radius * Vec2(std::cos(angle), std::sin(angle));
  }
  return points;
}

TEST(HandlePaths, BeginAtTheStartsAndEndExactlyAtTheTargets) {
  const Points starts = ring(5, 1, 0, {3, 1}), targets = ring(5, 0.7, 2, {2.5, 1});
  for (const PathKind kind : {PathKind::straight, PathKind::turning}) {
    const HandlePaths paths(kind, starts, targets);
    for (int i = 0; i < 5; ++i) {
      EXPECT_LE((paths.at(i, 0) - starts.col(i)).norm(), 1e-12);
      EXPECT_EQ(paths.at(i, 1), Vec2(targets.col(i)));
    }
  }
}

TEST(HandlePaths, ARingThatTurnsByHalfACircleKeepsItsSize) {
  const Vec2 centre(0.4, -0.2);
  const HandlePaths paths(PathKind::turning, ring(8, 1, 0, centre), ring(8, 1, kPi, centre));
  for (int i = 0; i < 8; ++i)
    for (const double lambda : {0.25, 0.5, 0.75})
      EXPECT_NEAR((paths.at(i, lambda) - centre).norm(), 1, 1e-9);
  // All the same way round, although each alone could go either way.
  for (int i = 0; i < 8; ++i) {
    const Vec2 half = paths.at(i, 0.5) - centre;
    const Vec2 next = paths.at((i + 1) % 8, 0.5) - centre;
    EXPECT_NEAR(half.dot(next), std::cos(kPi / 4), 1e-9);
  }
}

TEST(HandlePaths, CommonTurnIsTheAngleOfTheHandlesThatMove) {
  Points starts(2, 5), targets(2, 5);
  starts.leftCols(4) = ring(4, 1, 0, {0, 0});
  targets.leftCols(4) = ring(4, 1, 0.8, {0, 0});
  starts.col(4) = targets.col(4) = Vec2(5, 5);
  EXPECT_NEAR(HandlePaths::common_turn(starts, targets), 0.8, 1e-12);
  EXPECT_EQ(HandlePaths::common_turn(starts, starts), 0);
}

TEST(HandlePaths, ATranslationIsStraightWhateverWasAskedFor) {
  const Points starts = ring(3, 1, 0, {0, 0});
  const Points targets = starts.colwise() + Vec2(2, 0);
  const HandlePaths paths(PathKind::turning, starts, targets);
  EXPECT_LE((paths.at(1, 0.5) - (starts.col(1) + Vec2(1, 0))).norm(), 1e-9);
  EXPECT_NEAR(paths.length(1), 2, 1e-9);
}

}  // namespace
}  // namespace foldless
