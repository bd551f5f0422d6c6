// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rig/bone_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace foldless {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

Vec2 at(double length, double angle) { return length * Vec2(std::cos(angle), std::sin(angle)); }

/// Bones of these lengths that go on at angles from the x axis.
Points bones(const std::vector<double>& lengths, const std::vector<double>& angles) {
  Points joints = Points::Zero(2, static_cast<Eigen::Index>(lengths.size()) + 1);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    joints.col(k + 1) = joints.col(k) + at(lengths[i], angles[i]);
  }
  return joints;
}

BoneChain random_chain(Random& random, int count) {
  std::vector<double> lengths, rest, now;
  for (int i = 0; i < count; ++i) {
    lengths.push_back(uniform(random, 0.2, 2));
    rest.push_back(uniform(random, -1, 1));
    now.push_back(uniform(random, -3, 3));
  }
  BoneChain chain{bones(lengths, rest), bones(lengths, now)};
  chain.joints.colwise() += Vec2(uniform(random, -5, 5), uniform(random, -5, 5));
  return chain;
}

double length(const Points& joints, Eigen::Index bone) {
  return (joints.col(bone + 1) - joints.col(bone)).norm();
}

double whole(const BoneChain& chain) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < chain.rest.cols(); ++i) sum += length(chain.rest, i);
  return sum;
}

double longest(const BoneChain& chain) {
  double most = 0;
  for (Eigen::Index i = 0; i + 1 < chain.rest.cols(); ++i)
    most = std::max(most, length(chain.rest, i));
  return most;
}

void expect_lengths(const BoneChain& chain, const Points& joints) {
  for (Eigen::Index i = 0; i + 1 < joints.cols(); ++i)
    EXPECT_NEAR(length(joints, i), length(chain.rest, i), 1e-13 * whole(chain)) << "bone " << i;
}

Eigen::Index last(const BoneChain& chain) { return chain.joints.cols() - 1; }

Points pulled(const BoneChain& chain, const Vec2& hand) {
  const std::array moved{MovedJoint{last(chain), hand}};
  return with_moved_joints(chain, moved);
}

double turn_at(const Points& joints, Eigen::Index joint) {
  return cross(joints.col(joint) - joints.col(joint - 1),
               joints.col(joint + 1) - joints.col(joint));
}

TEST(BoneChain, MeetsWhateverIsInReachWithItsLengthsAndItsRoot) {
  Random random(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const BoneChain chain = random_chain(random, 2 + trial % 6);
    const double inner = std::max(0.0, 2 * longest(chain) - whole(chain));
    const double distance = uniform(random, inner, whole(chain));
    const Vec2 hand = chain.joints.col(0) + at(distance, uniform(random, -4, 4));
    const Points joints = pulled(chain, hand);
    expect_lengths(chain, joints);
    EXPECT_EQ(joints.col(0), chain.joints.col(0));
    EXPECT_LT((joints.col(last(chain)) - hand).norm(), 1e-9 * whole(chain))
        << trial << ": " << distance << " of " << inner << " to " << whole(chain);
  }
}

TEST(BoneChain, BeyondItsReachItIsALineTowardsTheHand) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const BoneChain chain = random_chain(random, 1 + trial % 6);
    const Vec2 way = at(1, uniform(random, -4, 4));
    const Points joints =
        pulled(chain, chain.joints.col(0) + uniform(random, 1, 3) * whole(chain) * way);
    expect_lengths(chain, joints);
    const Vec2 end = chain.joints.col(0) + whole(chain) * way;
    EXPECT_LT((joints.col(last(chain)) - end).norm(), 1e-12 * whole(chain));
  }
}

TEST(BoneChain, NearerThanItsLongestBoneAllowsItFoldsTowardsTheHand) {
  const BoneChain chain{bones({1, 5, 2}, {0, 0.1, 0}), bones({1, 5, 2}, {0, 0.4, 1})};
  const Points joints = pulled(chain, {0, 1});
  expect_lengths(chain, joints);
  EXPECT_LT((joints.col(3) - Vec2(0, 2)).norm(), 1e-12) << "the nearest place that it gets to";
}

TEST(BoneChain, TwoBonesKeepTheSideTheyAreBentTo) {
  Random random(3);
  for (int trial = 0; trial < 500; ++trial) {
    const BoneChain chain = random_chain(random, 2);
    const double a = length(chain.rest, 0), b = length(chain.rest, 1);
    const double distance =
        std::abs(a - b) + uniform(random, 0.05, 0.95) * (a + b - std::abs(a - b));
    const Points joints = pulled(chain, chain.joints.col(0) + at(distance, uniform(random, -4, 4)));
    EXPECT_GT(turn_at(joints, 1) * turn_at(chain.joints, 1), 0) << trial;
  }
}

TEST(BoneChain, OneThatWasStretchedBendsAsAtRest) {
  for (const double bend : {0.5, -0.5}) {
    const BoneChain arm{bones({2, 1}, {0, bend}), bones({2, 1}, {1, 1})};
    EXPECT_GT(turn_at(pulled(arm, {1, 2}), 1) * bend, 0);
    const BoneChain tail{bones({1, 1, 1, 1}, {0, bend, 2 * bend, 3 * bend}),
                         bones({1, 1, 1, 1}, {1, 1, 1, 1})};
    for (Eigen::Index i = 1; i < 4; ++i) EXPECT_GT(turn_at(pulled(tail, {1, 2}), i) * bend, 0);
  }
}

TEST(BoneChain, OneThatIsInALineAtRestTooBends) {
  for (int count = 2; count < 8; ++count) {
    const std::vector<double> lengths(static_cast<std::size_t>(count), 1), line(lengths.size(), 0);
    const BoneChain chain{bones(lengths, line), bones(lengths, line)};
    for (const double part : {0.1, 0.5, 0.9, 0.999}) {
      const Vec2 hand(part * count, 0);
      const Points joints = pulled(chain, hand);
      expect_lengths(chain, joints);
      EXPECT_LT((joints.col(count) - hand).norm(), 1e-9) << count << " bones, " << part;
    }
  }
}

/// How far joints go while the hand goes along a circle, and from far to near, in small steps.
TEST(BoneChain, ASmallMoveOfTheHandIsASmallMoveOfTheJoints) {
  Random random(4);
  constexpr double kStep = 1e-4;
  for (int trial = 0; trial < 40; ++trial) {
    const BoneChain chain = random_chain(random, 2 + trial % 4);
    const double inner = std::max(0.0, 2 * longest(chain) - whole(chain));
    const double room = whole(chain) - inner;
    const double from = inner + 0.1 * room;
    const Vec2 way = at(1, uniform(random, -4, 4));
    for (double d = from; d < whole(chain) + 0.1 * room; d += kStep * room * 25) {
      const Points now = pulled(chain, chain.joints.col(0) + d * way);
      const Points next = pulled(chain, chain.joints.col(0) + (d + kStep * room) * way);
      // Where it comes to its full length joints go as the square root of the hand's way.
      EXPECT_LT((next - now).cwiseAbs().maxCoeff(), 4 * std::sqrt(kStep) * whole(chain))
          << trial << " at " << d / whole(chain);
      if (d < inner + 0.9 * room) {
        EXPECT_LT((next - now).cwiseAbs().maxCoeff(), 40 * kStep * whole(chain))
            << trial << " at " << d / whole(chain);
      }
    }
    Points last_one = pulled(chain, chain.joints.col(0) + from * way);
    for (double angle = 0; angle < 6; angle += 0.02) {
      const Eigen::Rotation2D<double> turn(angle);
      const Points now = pulled(chain, chain.joints.col(0) + from * (turn * way));
      EXPECT_LT((now - last_one).cwiseAbs().maxCoeff(), 0.03 * whole(chain)) << trial;
      last_one = now;
    }
  }
}

TEST(BoneChain, HandThereAndBackAllIsAsItWas) {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    BoneChain chain = random_chain(random, 2 + trial % 5);
    const Points back = pulled(chain, chain.joints.col(last(chain)));
    EXPECT_LT((back - chain.joints).cwiseAbs().maxCoeff(), 1e-12 * whole(chain));
    const Points near = pulled(chain, chain.joints.col(last(chain)) + Vec2(1e-7, 1e-7));
    EXPECT_LT((near - chain.joints).cwiseAbs().maxCoeff(), 1e-3) << trial;
  }
}

TEST(BoneChain, ItsRootTakesItAlong) {
  Random random(6);
  const BoneChain chain = random_chain(random, 4);
  const std::array moved{MovedJoint{0, chain.joints.col(0) + Vec2(3, -2)}};
  const Points joints = with_moved_joints(chain, moved);
  EXPECT_LT((joints - (chain.joints.colwise() + Vec2(3, -2))).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BoneChain, WhatLiesBeyondAJointFollowsRigidly) {
  Random random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const BoneChain chain = random_chain(random, 5);
    const Vec2 hand = chain.joints.col(2) + Vec2(0.1, 0.05);
    const std::array moved{MovedJoint{2, hand}};
    const Points joints = with_moved_joints(chain, moved);
    expect_lengths(chain, joints);
    for (Eigen::Index i = 2; i < 5; ++i)
      EXPECT_NEAR(turn_at(joints, i), turn_at(chain.joints, i), 1e-10) << i;
  }
}

TEST(BoneChain, SeveralThatAreMovedAreMetOneAfterTheOther) {
  const std::vector<double> lengths{1, 1, 1, 1};
  const BoneChain chain{bones(lengths, {0, 0, 0, 0}), bones(lengths, {0.3, -0.3, 0.3, -0.3})};
  const std::array moved{MovedJoint{0, {5, 5}}, MovedJoint{2, {6, 6}}, MovedJoint{4, {7, 5}}};
  const Points joints = with_moved_joints(chain, moved);
  expect_lengths(chain, joints);
  for (const auto& [joint, to] : moved) EXPECT_LT((joints.col(joint) - to).norm(), 1e-12) << joint;
}

TEST(BoneChain, TakesItsLengthsFromTheRestShape) {
  const BoneChain chain{bones({1, 2, 3}, {0, 1, 0}), bones({9, 0.1, 4}, {0, 1, 2})};
  expect_lengths(chain, pulled(chain, {2, 3}));
}

TEST(BoneChain, BonesWithoutLengthAndHandsAtTheRootGiveNumbers) {
  const BoneChain none{bones({0, 0}, {0, 0}), bones({0, 0}, {0, 0})};
  EXPECT_EQ(pulled(none, {3, 4}), Points::Zero(2, 3));
  const BoneChain one{bones({1, 0, 1}, {0, 0, 0.5}), bones({1, 0, 1}, {0, 0, 0.5})};
  const Points joints = pulled(one, {0.5, 1});
  expect_lengths(one, joints);
  EXPECT_LT((joints.col(3) - Vec2(0.5, 1)).norm(), 1e-9);
  for (int count = 1; count < 6; ++count) {
    const std::vector<double> lengths(static_cast<std::size_t>(count), 1), line(lengths.size(), 0);
    const BoneChain chain{bones(lengths, line), bones(lengths, line)};
    const Points folded = pulled(chain, {0, 0});
    expect_lengths(chain, folded);
    const double left = count % 2 == 1 && count == 1 ? 1 : 0;
    EXPECT_NEAR(folded.col(count).norm(), left, 1e-9) << count;
  }
}

}  // namespace
}  // namespace foldless
