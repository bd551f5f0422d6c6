// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/frame_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/motion/remeshed_frames.h"

namespace foldless {
namespace {

Vec2 sheared(const Vec2& p) { return {p.x() + 0.3 * p.y(), p.y() + 0.1 * p.x()}; }

TEST(FrameMap, GivesAnAffineMapBackWhateverTheTriangulationIs) {
  std::mt19937 random(5);
  const test::Fixture f = test::square_grid(6);
  const auto frame = test::remeshed_frame(f, sheared, random, 120);
  ASSERT_NE(frame->triangles->cols(), f.triangles.cols());
  const FrameMap map(frame, f.triangles);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int t = 0; t < f.triangles.cols(); ++t)
    for (int trial = 0; trial < 10; ++trial) {
      Eigen::Vector3d weights(unit(random), unit(random), unit(random));
      weights /= weights.sum();
      const Vec2 p = corners_of(f.rest, f.triangles.col(t)) * weights;
      EXPECT_LT((map.at(p, t) - sheared(p)).norm(), 1e-12) << t;
    }
}

TEST(FrameMap, AnOriginalTriangleIsCoveredByThoseThatShareAreaWithIt) {
  std::mt19937 random(6);
  const test::Fixture f = test::square_grid(5);
  const auto frame = test::remeshed_frame(f, sheared, random, 90);
  const FrameMap map(frame, f.triangles);
  int more_than_one = 0;
  for (int t = 0; t < f.triangles.cols(); ++t) {
    std::set<int> expected;
    const auto corners = corners_of(f.rest, f.triangles.col(t));
    for (int other = 0; other < frame->triangles->cols(); ++other)
      if (share_area(corners_of(*frame->rest, frame->triangles->col(other)), corners))
        expected.insert(other);
    const auto found = map.covering(t);
    EXPECT_EQ(std::set<int>(found.begin(), found.end()), expected) << t;
    EXPECT_EQ(found.size(), expected.size());
    if (found.size() > 1) ++more_than_one;
  }
  EXPECT_GT(more_than_one, 10);
}

TEST(FrameMap, StaysOnItsSheetWhereTheRestMeshLiesOverItself) {
  // A ribbon that goes round one and a half times at rest, and is straight in the frame.
  constexpr int kCells = 36;
  test::Fixture f;
  f.rest.resize(2, 2 * (kCells + 1));
  f.triangles.resize(3, 2 * kCells);
  Points straight(2, 2 * (kCells + 1));
  for (int i = 0; i <= kCells; ++i)
    for (int side = 0; side < 2; ++side) {
      const double angle = 3 * std::numbers::pi * i / kCells;
      f.rest.col(2 * i + side) = (2.0 - side) * Vec2(std::cos(angle), std::sin(angle));
      straight.col(2 * i + side) = Vec2(i, side);
    }
  for (int i = 0; i < kCells; ++i) {
    f.triangles.col(2 * i) << 2 * i, 2 * i + 2, 2 * i + 1;
    f.triangles.col(2 * i + 1) << 2 * i + 2, 2 * i + 3, 2 * i + 1;
  }
  MeshPair mesh(f.triangles, f.rest, straight);
  for (int i = 0; i < kCells; i += 2) {
    const auto e = mesh.find_edge(2 * i + 2, 2 * i + 1);
    ASSERT_TRUE(e);
    if (mesh.is_flip_legal(*e)) mesh.flip(*e);
  }
  const FrameMap map(test::snapshot_of(mesh, static_cast<int>(f.rest.cols())), f.triangles);
  for (int t = 0; t < f.triangles.cols(); ++t) {
    EXPECT_LE(map.covering(t).size(), 2U) << t;
    const Vec2 middle = corners_of(f.rest, f.triangles.col(t)).rowwise().mean();
    const Vec2 expected = corners_of(straight, f.triangles.col(t)).rowwise().mean();
    EXPECT_LT((map.at(middle, t) - expected).norm(), 1) << t;
  }
}

TEST(FrameMap, TrianglesThatTouchShareNoArea) {
  const auto corners = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    Eigen::Matrix<double, 2, 3> m;
    m << a, b, c;
    return m;
  };
  const auto t = corners({0, 0}, {1, 0}, {0, 1});
  EXPECT_FALSE(share_area(t, corners({1, 0}, {1, 1}, {0, 1})));
  EXPECT_FALSE(share_area(t, corners({1, 0}, {2, 0}, {2, 1})));
  EXPECT_TRUE(share_area(t, corners({0.9, 0}, {1, 1}, {0, 1})));
  EXPECT_TRUE(share_area(t, t));
  EXPECT_TRUE(share_area(t, corners({-5, -5}, {5, -5}, {0, 5})));
  EXPECT_TRUE(share_area(t, corners({0.1, 0.1}, {0.2, 0.1}, {0.1, 0.2})));
}

}  // namespace
}  // namespace foldless
