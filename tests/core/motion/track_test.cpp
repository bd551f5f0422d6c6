// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foldless {
namespace {

constexpr Cycle kOnce{20, false};
constexpr Cycle kLoop{20, true};

TEST(Track, GoesFromKeyToKeyAndStaysBeforeAndAfter) {
  const Track<double> track{{4, 10, {}}, {8, 30, {}}, {10, 0, {}}};
  EXPECT_EQ(value_at(track, 0, kOnce), 10);
  EXPECT_EQ(value_at(track, 4, kOnce), 10);
  EXPECT_EQ(value_at(track, 5, kOnce), 15);
  EXPECT_EQ(value_at(track, 6.5, kOnce), 22.5) << "between frames";
  EXPECT_EQ(value_at(track, 8, kOnce), 30);
  EXPECT_EQ(value_at(track, 9, kOnce), 15);
  EXPECT_EQ(value_at(track, 20, kOnce), 0);
}

TEST(Track, ALoopGoesOnFromTheLastKeyToTheFirst) {
  const Track<double> track{{4, 10, {}}, {16, 30, {}}};
  EXPECT_EQ(value_at(track, 16, kLoop), 30);
  EXPECT_EQ(value_at(track, 18, kLoop), 25);
  EXPECT_EQ(value_at(track, 20, kLoop), 20);
  EXPECT_EQ(value_at(track, 0, kLoop), 20) << "the first frame is that after the last";
  EXPECT_EQ(value_at(track, 2, kLoop), 15);
}

TEST(Track, AKeyAtTheEndOfALoopNeedNotBeTheFirst) {
  const Track<double> turn{{0, 0, {}}, {20, 360, {}}};
  EXPECT_EQ(value_at(turn, 0, kLoop), 0);
  EXPECT_EQ(value_at(turn, 15, kLoop), 270);
  EXPECT_EQ(value_at(turn, 20, kLoop), 360);
}

TEST(Track, OneKeyIsAlwaysTheSame) {
  for (const Cycle& cycle : {kOnce, kLoop})
    for (const double frame : {0.0, 3.0, 7.5, 20.0})
      EXPECT_EQ(value_at({{3, 5, {}}}, frame, cycle), 5);
}

TEST(Track, AHeldKeyJumpsAtTheNext) {
  const Track<double> track{{0, 1, *find_easing("hold")}, {5, 2, {}}};
  EXPECT_EQ(value_at(track, 4.999, kOnce), 1);
  EXPECT_EQ(value_at(track, 5, kOnce), 2);
}

TEST(Track, AStraightPathIsEasedAlongItsLine) {
  const Track<Vec2> track{{0, {0, 0}, *find_easing("both")}, {10, {4, 2}, {}}};
  EXPECT_TRUE(point_at(track, 5, kOnce, {}).isApprox(Vec2(2, 1)));
  EXPECT_LT(point_at(track, 2, kOnce, {}).x(), 0.5);
  EXPECT_TRUE(point_at(track, 10, kOnce, {}).isApprox(Vec2(4, 2)));
}

TEST(Track, ASmoothPathMeetsItsKeysWithOneTangent) {
  const Track<Vec2> track{{0, {0, 0}, {}}, {5, {1, 0}, {}}, {10, {1, 3}, {}}, {15, {-2, 3}, {}}};
  const Path path{PathShape::smooth, {}};
  constexpr double kStep = 1e-6;
  for (const Cycle& cycle : {kOnce, kLoop})
    for (const Keyframe<Vec2>& key : track) {
      EXPECT_TRUE(point_at(track, key.frame, cycle, path).isApprox(key.value));
      if (!cycle.loops && (key.frame == 0 || key.frame == 15)) continue;
      const double before = key.frame == 0 ? 20 - kStep : key.frame - kStep;
      const Vec2 in = key.value - point_at(track, before, cycle, path);
      const Vec2 out = point_at(track, key.frame + kStep, cycle, path) - key.value;
      EXPECT_NEAR(cross(in.normalized(), out.normalized()), 0, 1e-4) << key.frame;
      EXPECT_GT(in.dot(out), 0) << key.frame;
    }
}

TEST(Track, ASmoothPathThroughPointsOfALineStaysOnIt) {
  const Track<Vec2> track{{0, {0, 0}, {}}, {5, {1, 2}, {}}, {10, {1, 2}, {}}, {15, {4, 8}, {}}};
  for (double frame = 0; frame <= 20; frame += 0.25) {
    const Vec2 p = point_at(track, frame, kOnce, {PathShape::smooth, {}});
    EXPECT_NEAR(p.y(), 2 * p.x(), 1e-12) << frame;
  }
  EXPECT_EQ(point_at(track, 7, kOnce, {PathShape::smooth, {}}), Vec2(1, 2)) << "it rests there";
}

TEST(Track, ASwingKeepsItsRadiusAndGoesTheShorterWay) {
  const Track<Vec2> track{{0, {1, 0}, {}}, {10, {0, 1}, {}}, {20, {0, 2}, {}}};
  const Path path{PathShape::swing, Vec2::Zero()};
  for (const double frame : {1.0, 2.5, 5.0, 9.0}) {
    const Vec2 p = point_at(track, frame, kOnce, path);
    EXPECT_NEAR(p.norm(), 1, 1e-14);
    EXPECT_NEAR(std::atan2(p.y(), p.x()), frame / 10 * std::numbers::pi / 2, 1e-14);
  }
  EXPECT_NEAR(point_at(track, 15, kOnce, path).norm(), std::sqrt(2), 1e-14) << "evenly by factors";
  const Track<Vec2> back{{0, {-1, 0.1}, {}}, {10, {-1, -0.1}, {}}};
  EXPECT_LT(point_at(back, 5, kOnce, path).x(), -1) << "not round the front";
  const Track<Vec2> away{{0, {0, 0}, {}}, {10, {2, 4}, {}}};
  EXPECT_TRUE(point_at(away, 5, kOnce, path).isApprox(Vec2(1, 2))) << "from the centre itself";
}

}  // namespace
}  // namespace foldless
