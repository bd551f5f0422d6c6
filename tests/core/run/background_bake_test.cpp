// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/background_bake.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/run/background_moment.h"
#include "core/run/frames_box.h"
#include "tests/support/patience.h"

namespace foldless {
namespace {

/// A bar that is held at one corner and goes nowhere.
class InBackground : public testing::Test {
 protected:
  InBackground() {
    const Shape shape = bar(4, 1, 4);
    Problem at_rest;
    at_rest.mesh = MeshPair(shape.triangles, shape.rest);
    at_rest.energy = find_density("arap");
    Handle handle;
    handle.target = shape.rest.col(0);
    at_rest.handles = {handle};
    Animation animation;
    animation.cycle = {2, false};
    frames_ = std::make_shared<const Frames>(at_rest, animation);
    const auto still = frames_->solve(0, nullptr, {});
    wanted_.original = shape.triangles;
    wanted_.solved = {*still, *still};
    wanted_.solved[1].frame = 1;
    wanted_.tolerance = 1e-3;
  }

  /// The second frame, turned about the origin.
  void turn(double radians) {
    auto turned = std::make_shared<Snapshot>(*wanted_.solved[1].snapshot);
    turned->deformed = Eigen::Rotation2Dd(radians).toRotationMatrix() * turned->deformed;
    wanted_.solved[1].snapshot = turned;
  }

  std::shared_ptr<const Frames> frames_;
  SolvedToBake wanted_;
  std::atomic<int> news_ = 0;
  BackgroundBake bake_{[this] { ++news_; }};
};

TEST_F(InBackground, ABakeIsProvedAndToldOf) {
  turn(0.5);
  bake_.start(frames_, wanted_);
  ASSERT_TRUE(test::comes_true([this] { return news_ == 1; }));
  const auto result = bake_.result();
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->failure);
  EXPECT_TRUE(result->error.empty());
  EXPECT_EQ(result->baked.frames.size(), 2U);
}

TEST_F(InBackground, ABakeNamesTheFirstMomentThatIsNotProved) {
  turn(EIGEN_PI);  // Half way every triangle is a point.
  bake_.start(frames_, wanted_);
  ASSERT_TRUE(test::comes_true([this] { return bake_.result() != nullptr; }));
  const auto result = bake_.result();
  const auto& failure = result->failure;
  ASSERT_TRUE(failure);
  EXPECT_EQ(result->baked.frames[failure->from + 1].frame, 1) << "the step to the turned frame";
  EXPECT_NEAR(failure->failure.moment, 0.5, 1e-9);
}

TEST_F(InBackground, WhatIsCancelledNeverBecomesAResult) {
  for (int i = 0; i < 20; ++i) {
    bake_.start(frames_, wanted_);
    std::this_thread::sleep_for(std::chrono::microseconds(50 * i));
    bake_.cancel();
    EXPECT_FALSE(bake_.result());
  }
  bake_.start(frames_, wanted_);
  ASSERT_TRUE(test::comes_true([this] { return bake_.result() != nullptr; }));
}

TEST_F(InBackground, AMomentIsSolvedOnceAsTheSolverDoes) {
  std::atomic<int> solved = 0;
  BackgroundMoment moment([&] { ++solved; });
  const auto before = std::make_shared<const SolvedFrame>(wanted_.solved[0]);
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(test::comes_true([&] { return moment.at(0.25, before, frames_) != nullptr; }));
    EXPECT_EQ(moment.at(0.25, before, frames_)->frame, 0.25);
  }
  ASSERT_TRUE(test::comes_true([&] { return solved > 0; })) << "told after it is there";
  EXPECT_EQ(solved, 1);
  EXPECT_EQ(moment.at(0.75, before, frames_), nullptr) << "another is never shown in its place";
  ASSERT_TRUE(test::comes_true([&] { return moment.at(0.75, before, frames_) != nullptr; }));
  EXPECT_EQ(moment.at(0.75, before, frames_)->snapshot->deformed,
            frames_->solve(0.75, before->snapshot.get(), {})->snapshot->deformed);
}

TEST_F(InBackground, PicturesHaveEvenSidesAndAMarginRoundAllFrames) {
  wanted_.solved[1].snapshot = wanted_.solved[0].snapshot;
  const FramesBox box = box_round(wanted_.solved);
  EXPECT_NEAR(box.width(), 4 * 1.06, 1e-12);
  EXPECT_NEAR(box.height(), 1 + 4 * 0.06, 1e-12);
  EXPECT_EQ(size_for(box), (PictureSize{1024, 300}));
  EXPECT_DOUBLE_EQ(length_of_a_pixel(box, PictureSize{106, 1000}), 0.04);
}

}  // namespace
}  // namespace foldless
