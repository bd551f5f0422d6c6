// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/handle_path.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace foldless {
namespace {

/// Four points on a circle about (1, 2), and one that stays.
Points start() {
  Points p(2, 5);
  p << 2, 1, 0, 1, 7,  //
      2, 3, 2, 1, 7;
  return p;
}

Points turned(double degrees, double scale) {
  const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
  Points p = start();
  for (int i = 0; i < 4; ++i)
    p.col(i) = scale * (turn * (p.col(i) - Vec2(1, 2))) + Vec2(1, 2) + Vec2(0.5, 0);
  return p;
}

TEST(HandlePath, LeadsFromTheStartToTheTargetsBitForBit) {
  const Points target = turned(170, 0.7);
  for (const HandlePath& path :
       {HandlePath::straight(start(), target), HandlePath::similar(start(), target)}) {
    EXPECT_LT((path.at(0) - start()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(path.at(1), target);
    EXPECT_EQ(path.at(0.3).col(4), start().col(4)) << "a handle that does not move";
  }
}

TEST(HandlePath, ASimilarityTurnsAHalfTurnHalfWay) {
  const HandlePath path = HandlePath::similar(start(), turned(180, 1));
  ASSERT_TRUE(path.is_similar());
  const Points middle = path.at(0.5);
  const Vec2 centre = middle.leftCols(4).rowwise().mean();
  EXPECT_LT((centre - Vec2(1.25, 2)).norm(), 1e-12);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((middle.col(i) - centre).norm(), 1, 1e-12);
  const Points lines = HandlePath::straight(start(), turned(180, 1)).at(0.5);
  EXPECT_LT((lines.col(0) - lines.col(2)).norm(), 1e-12) << "straight lines meet";
}

TEST(HandlePath, WhatIsNoSimilarityGoesStraightInAddition) {
  Points target = turned(90, 1);
  target.col(0) += Vec2(0.3, 0.4);
  const HandlePath path = HandlePath::similar(start(), target);
  EXPECT_LT((path.at(1 - 1e-9) - target).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(HandlePath, ASingleHandleGoesStraight) {
  Points target = start();
  target.col(2) += Vec2(1, 1);
  const HandlePath path = HandlePath::similar(start(), target);
  EXPECT_FALSE(path.is_similar());
  EXPECT_EQ(path.at(0.5).col(2), start().col(2) + Vec2(0.5, 0.5));
}

}  // namespace
}  // namespace foldless
