// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/bake.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/mesh/injective.h"
#include "core/motion/frame_map.h"
#include "tests/core/motion/remeshed_frames.h"

namespace foldless {
namespace {

using test::Fixture;
using test::PlaneMap;

Vec2 turned(const Vec2& p, double angle) {
  return Eigen::Rotation2Dd(angle).toRotationMatrix() * p;
}

/// Bends the plane, the more the later.
PlaneMap bent(double amount) {
  return [amount](const Vec2& p) {
    return Vec2(p.x() + amount * std::sin(2 * p.y()), p.y() + amount * std::sin(2 * p.x()));
  };
}

using States = std::vector<std::shared_ptr<const Snapshot>>;

std::optional<States> no_states(std::size_t) {
  ADD_FAILURE() << "nothing between the frames is needed";
  return std::nullopt;
}

FramesToBake frames_of(const Fixture& f, int count, int changes, unsigned seed) {
  std::mt19937 random(seed);
  FramesToBake frames;
  frames.original = f.triangles;
  frames.cycle_frames = count;
  for (int i = 0; i < count; ++i) {
    frames.moments.push_back(i);
    frames.snapshots.push_back(test::remeshed_frame(f, bent(0.02 * i), random, i * changes));
  }
  return frames;
}

/// The mesh is injective at rest and in every frame, and is where the frames' maps have it.
void expect_faithful(const BakedAnimation& baked, const FramesToBake& frames, double tolerance) {
  ASSERT_TRUE(is_injective(baked.triangles, baked.rest));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const Points original = frames.snapshots[0]->rest->leftCols(baked.original_vertices);
  EXPECT_EQ(baked.rest.leftCols(baked.original_vertices), original);
  for (std::size_t i = 0; i < frames.snapshots.size(); ++i) {
    const Points& deformed = baked.frames[i].deformed;
    EXPECT_TRUE(is_injective(baked.triangles, deformed)) << i;
    const FrameMap map(frames.snapshots[i], frames.original);
    for (const auto& t : baked.triangles.colwise())
      for (int trial = 0; trial < 3; ++trial) {
        Eigen::Vector3d weights(unit(random), unit(random), unit(random));
        weights /= weights.sum();
        const Vec2 rest = corners_of(baked.rest, t) * weights;
        const Vec2 here = corners_of(deformed, t) * weights;
        double nearest = 1e9;  // The original triangle that holds the point.
        for (int o = 0; o < frames.original.cols(); ++o)
          if (barycentric(corners_of(original, frames.original.col(o)), rest).minCoeff() > -1e-9)
            nearest = std::min(nearest, (map.at(rest, o) - here).norm());
        ASSERT_LE(nearest, tolerance) << "frame " << i;
      }
  }
}

BakedAnimation whole_frames_of(BakedAnimation baked) {
  std::erase_if(baked.frames,
                [](const BakedFrame& frame) { return frame.frame != std::floor(frame.frame); });
  return baked;
}

TEST(Bake, TheDrawingsOwnTrianglesNeedNoMore) {
  const Fixture f = test::square_grid(6);
  const FramesToBake frames = frames_of(f, 4, 0, 1);
  const auto baked = bake(frames, {1e-9, 16}, no_states, {});
  ASSERT_TRUE(baked);
  EXPECT_EQ(baked->rest.cols(), f.rest.cols());
  EXPECT_EQ(baked->deviation, 0);
  EXPECT_TRUE(failures_of(*baked).empty());
  expect_faithful(*baked, frames, 1e-12);
}

TEST(Bake, TellsHowFarItIsAndNeverLess) {
  const Fixture f = test::square_grid(7);
  const FramesToBake frames = frames_of(f, 5, 20, 2);
  const auto nothing_between = [](std::size_t) { return std::optional<States>(States()); };
  std::vector<double> shares;
  const auto note = [&](double share) { shares.push_back(share); };
  ASSERT_TRUE(bake(frames, {0.001, 100, note}, nothing_between, {}));
  EXPECT_GT(shares.size(), 20U);
  EXPECT_TRUE(std::ranges::is_sorted(shares, std::less_equal()));
  EXPECT_LT(shares.front(), 0.1);
  EXPECT_EQ(shares.back(), 1);
}

TEST(Bake, VerticesAreAddedUntilTheToleranceIsKept) {
  const Fixture f = test::square_grid(7);
  const FramesToBake frames = frames_of(f, 5, 20, 2);
  // Frames whose triangulations have nothing in common: what is between them is not the point.
  const auto nothing_between = [](std::size_t) { return std::optional<States>(States()); };
  Eigen::Index before = 0;
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    const auto baked = bake(frames, {tolerance, 100}, nothing_between, {});
    ASSERT_TRUE(baked);
    EXPECT_LE(baked->deviation, tolerance);
    EXPECT_GE(baked->rest.cols(), before) << "the finer the more";
    before = baked->rest.cols();
    expect_faithful(whole_frames_of(*baked), frames, tolerance);
  }
  EXPECT_GT(before, f.rest.cols() + 20);
}

/// The same, with arrays of its own.
std::shared_ptr<const Snapshot> apart(const Snapshot& frame) {
  auto copy = std::make_shared<Snapshot>(frame);
  copy->triangles = std::make_shared<const Triangles>(*frame.triangles);
  copy->rest = std::make_shared<const Points>(*frame.rest);
  return copy;
}

TEST(Bake, FramesThatShareAMeshAreBakedAsThoseThatHaveTheirOwn) {
  const Fixture f = test::square_grid(7);
  FramesToBake shared = frames_of(f, 2, 20, 2);
  auto later = std::make_shared<Snapshot>(*shared.snapshots[1]);
  for (Eigen::Index v = 0; v < later->deformed.cols(); ++v)
    later->deformed.col(v) = bent(0.1)(later->deformed.col(v));
  auto slid = std::make_shared<Snapshot>(*later);
  Points rest = *later->rest;
  ASSERT_GT(rest.cols(), slid->original_vertices);
  for (Eigen::Index v = slid->original_vertices; v < rest.cols(); ++v)
    rest.col(v) += Vec2(0.003, 0.002);
  slid->rest = std::make_shared<const Points>(rest);
  shared.snapshots.insert(shared.snapshots.end(), {later, slid, later});
  shared.moments = {0, 1, 2, 3, 4};
  FramesToBake own = shared;
  for (auto& snapshot : own.snapshots) snapshot = apart(*snapshot);
  const auto nothing_between = [](std::size_t) { return std::optional<States>(States()); };
  const auto a = bake(shared, {0.001, 100}, nothing_between, {});
  const auto b = bake(own, {0.001, 100}, nothing_between, {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->rest, b->rest);
  EXPECT_EQ(a->deviation, b->deviation);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(a->frames[i].deformed, b->frames[i].deformed) << i;
}

TEST(Bake, DeviationIsWhatItSays) {
  const Fixture f = test::square_grid(7);
  const FramesToBake frames = frames_of(f, 5, 20, 3);
  const auto coarse = bake(frames, {1, 1}, no_states, {});
  ASSERT_TRUE(coarse);
  EXPECT_GT(coarse->deviation, 0.001);
  expect_faithful(*coarse, frames, coarse->deviation * 1.0000001);
}

/// A grid that is turned by half a turn a frame.
class BakedTurn : public testing::Test {
 protected:
  std::shared_ptr<const Snapshot> at(double moment) const {
    std::mt19937 random(4);
    const auto map = [=](const Vec2& p) { return turned(p, moment * std::numbers::pi); };
    return test::remeshed_frame(grid_, map, random, 0);
  }
  FramesToBake frames(const std::vector<double>& moments) const {
    FramesToBake frames;
    frames.original = grid_.triangles;
    frames.cycle_frames = 3;
    for (const double moment : moments) {
      frames.moments.push_back(moment);
      frames.snapshots.push_back(at(moment));
    }
    return frames;
  }

  Fixture grid_ = test::square_grid(4);
};

TEST_F(BakedTurn, StatesBetweenAreAddedWhereAStepIsNotProved) {
  std::vector<std::size_t> asked;
  const auto baked = bake(frames({0, 1, 1.25}), {1e-9, 16},
                          [&](std::size_t frame) {
                            asked.push_back(frame);
                            States states;
                            for (int i = 1; i < 10; ++i) states.push_back(at(0.1 * i));
                            return std::optional(states);
                          },
                          {});
  ASSERT_TRUE(baked);
  EXPECT_EQ(asked, std::vector<std::size_t>{0});
  ASSERT_EQ(baked->frames.size(), 4U) << "one is enough";
  EXPECT_NEAR(baked->frames[1].frame, 0.5, 1e-12);
  EXPECT_EQ(baked->frames[1].deformed, at(0.5)->deformed);
  EXPECT_TRUE(failures_of(*baked).empty());
}

TEST_F(BakedTurn, AJumpThatNoStatesBridgeIsNamed) {
  FramesToBake loop = frames({0, 1});
  loop.loops = true;
  const auto baked = bake(
      loop, {1e-9, 16},
      [&](std::size_t frame) {
        return std::optional(frame == 0 ? States{at(0), at(1)} : States{at(1), at(0.5), at(0)});
      },
      {});
  ASSERT_TRUE(baked);
  EXPECT_EQ(baked->frames.size(), 5U) << "both states of the first step, one of the second";
  const std::vector<BakedFailure> failures = failures_of(*baked);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_NEAR(baked->frames[failures[0].from].frame, 1.0 / 3, 1e-12);
  EXPECT_NEAR(baked->frames[failures[0].from + 1].frame, 2.0 / 3, 1e-12);
  EXPECT_NEAR(failures[0].failure.moment, 0.5, 1e-12);
}

TEST_F(BakedTurn, StatesThatTakeManyVerticesForNoProofAreLeftOut) {
  const FramesToBake jump = frames({0, 1});
  std::size_t asked = 0;
  const auto states = [&](std::size_t) {
    ++asked;
    States remeshed;
    for (unsigned seed = 1; seed < 9; ++seed) {
      std::mt19937 random(seed);
      const PlaneMap map =
          seed < 5 ? bent(0) : [](const Vec2& p) { return turned(p, std::numbers::pi); };
      remeshed.push_back(test::remeshed_frame(grid_, map, random, 60));
    }
    return std::optional(remeshed);
  };
  const auto baked = bake(jump, {1e-3, 16}, states, {});
  ASSERT_TRUE(baked);
  EXPECT_EQ(asked, 1U);
  EXPECT_EQ(baked->frames.size(), 2U);
  EXPECT_EQ(baked->rest.cols(), 16) << "as many as the frames need";
  const std::vector<BakedFailure> failures = failures_of(*baked);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_NEAR(failures[0].failure.moment, 0.5, 1e-12);
}

TEST(Bake, EndsWhenItIsStopped) {
  const Fixture f = test::square_grid(5);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(bake(frames_of(f, 4, 20, 2), {1e-3, 16}, no_states, stop.get_token()));
}

}  // namespace
}  // namespace foldless
