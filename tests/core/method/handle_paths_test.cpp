// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/handle_paths.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace foldless {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr PathKind kKinds[] = {PathKind::straight, PathKind::similar, PathKind::turning};

Points ring(int count, double radius, double turn, const Vec2& centre) {
  Points points(2, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count + turn;
    points.col(i) = centre + radius * Vec2(std::cos(angle), std::sin(angle));
  }
  return points;
}

/// Four points on a circle about (1, 2), and one that stays.
Points start() {
  Points p(2, 5);
  p << 2, 1, 0, 1, 7,  //
      2, 3, 2, 1, 7;
  return p;
}

Points turned(double degrees, double scale) {
  const Eigen::Rotation2Dd turn(degrees * kPi / 180);
  Points p = start();
  for (int i = 0; i < 4; ++i)
    p.col(i) = scale * (turn * (p.col(i) - Vec2(1, 2))) + Vec2(1, 2) + Vec2(0.5, 0);
  return p;
}

TEST(HandlePaths, LeadFromTheStartToTheTargetsBitForBit) {
  const Points target = turned(170, 0.7);
  for (const PathKind kind : kKinds) {
    SCOPED_TRACE(static_cast<int>(kind));
    const HandlePaths paths(kind, start(), target);
    EXPECT_EQ(paths.kind(), kind);
    EXPECT_LT((paths.at(0) - start()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(paths.at(1), target);
    EXPECT_EQ(paths.at(0.3).col(4), start().col(4)) << "a handle that does not move";
    EXPECT_EQ(paths.length(4), 0);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(paths.at(i, 0.3), Vec2(paths.at(0.3).col(i)));
  }
}

TEST(HandlePaths, ASimilarityTurnsAHalfTurnHalfWay) {
  const HandlePaths paths(PathKind::similar, start(), turned(180, 1));
  const Points middle = paths.at(0.5);
  const Vec2 centre = middle.leftCols(4).rowwise().mean();
  EXPECT_LT((centre - Vec2(1.25, 2)).norm(), 1e-12);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((middle.col(i) - centre).norm(), 1, 1e-12);
  const Points lines = HandlePaths(PathKind::straight, start(), turned(180, 1)).at(0.5);
  EXPECT_LT((lines.col(0) - lines.col(2)).norm(), 1e-12) << "straight lines meet";
}

TEST(HandlePaths, WhatIsNoSimilarityGoesStraightInAddition) {
  Points target = turned(90, 1);
  target.col(0) += Vec2(0.3, 0.4);
  const HandlePaths paths(PathKind::similar, start(), target);
  EXPECT_LT((paths.at(1 - 1e-9) - target).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(HandlePaths, ASingleHandleGoesStraight) {
  Points target = start();
  target.col(2) += Vec2(1, 1);
  for (const PathKind kind : kKinds) {
    const HandlePaths paths(kind, start(), target);
    EXPECT_EQ(paths.kind(), PathKind::straight);
    EXPECT_EQ(paths.at(0.5).col(2), start().col(2) + Vec2(0.5, 0.5));
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

TEST(HandlePaths, TheLengthOfASpiralIsThatOfItsArc) {
  const HandlePaths paths(PathKind::turning, ring(6, 1, 0, {1, 1}), ring(6, 1, 2, {1, 1}));
  EXPECT_NEAR(paths.length(3), 2, 0.01) << "the chord is 1.68";
}

TEST(HandlePaths, TurningHandlesGoRoundTheFixedPointOfTheirSimilarity) {
  // A quarter turn about the origin and on by (2, 0) is one about (1, 1).
  const Points starts = ring(4, 0.5, 0.3, {0, 0}), targets = ring(4, 0.5, 0.3 + kPi / 2, {2, 0});
  const HandlePaths paths(PathKind::turning, starts, targets);
  for (int i = 0; i < 4; ++i)
    for (const double lambda : {0.2, 0.5, 0.9})
      EXPECT_NEAR((paths.at(i, lambda) - Vec2(1, 1)).norm(), (starts.col(i) - Vec2(1, 1)).norm(),
                  1e-9);
}

TEST(HandlePaths, CommonTurnIsTheAngleOfTheHandlesThatMove) {
  Points starts(2, 5), targets(2, 5);
  starts.leftCols(4) = ring(4, 1, 0, {0, 0});
  targets.leftCols(4) = ring(4, 1, 0.8, {0, 0});
  starts.col(4) = targets.col(4) = Vec2(5, 5);
  EXPECT_NEAR(common_turn(starts, targets).angle, 0.8, 1e-12);
  EXPECT_EQ(common_turn(starts, starts).angle, 0);
}

TEST(HandlePaths, ATranslationIsStraightWhateverWasAskedFor) {
  const Points starts = ring(3, 1, 0, {0, 0});
  const Points targets = starts.colwise() + Vec2(2, 0);
  for (const PathKind kind : kKinds) {
    const HandlePaths paths(kind, starts, targets);
    EXPECT_EQ(paths.kind(), PathKind::straight);
    EXPECT_LE((paths.at(1, 0.5) - (starts.col(1) + Vec2(1, 0))).norm(), 1e-9);
    EXPECT_NEAR(paths.length(1), 2, 1e-9);
  }
}

}  // namespace
}  // namespace foldless
