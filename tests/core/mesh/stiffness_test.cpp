// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/stiffness.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

Points line(std::initializer_list<Vec2> points) {
  Points result(2, static_cast<Eigen::Index>(points.size()));
  Eigen::Index i = 0;
  for (const Vec2& p : points) result.col(i++) = p;
  return result;
}

TEST(Stiffness, IsOneWhereThereIsNoStroke) {
  EXPECT_EQ(Stiffness({}).at({0, 0}), 1);
  EXPECT_EQ(Stiffness({{line({{5, 5}}), 1, 10}}).at({0, 0}), 1);
}

TEST(Stiffness, ReachesTheRadiusRoundALine) {
  const Stiffness stiffness({{line({{0, 0}, {4, 0}, {4, 4}}), 1, 10}});
  for (const Vec2& inside : {Vec2(0, 0), Vec2(2, 1), Vec2(-1, 0), Vec2(5, 2), Vec2(4, 5)})
    EXPECT_EQ(stiffness.at(inside), 10) << inside.transpose();
  for (const Vec2& outside : {Vec2(2, 1.01), Vec2(-0.8, 0.8), Vec2(2, 2), Vec2(4.8, 4.8)})
    EXPECT_EQ(stiffness.at(outside), 1) << outside.transpose();
}

TEST(Stiffness, APointIsADisk) {
  const Stiffness stiffness({{line({{1, 2}}), 0.5, 3}});
  EXPECT_EQ(stiffness.at({1.5, 2}), 3);
  EXPECT_EQ(stiffness.at({1.4, 2.4}), 1);
}

TEST(Stiffness, TheLastStrokeCounts) {
  const Stiffness stiffness(
      {{line({{0, 0}}), 2, 10}, {line({{1, 0}}), 2, 100}, {line({{3, 0}}), 1, 1}});
  EXPECT_EQ(stiffness.at({-1.5, 0}), 10);
  EXPECT_EQ(stiffness.at({0, 0}), 100);
  EXPECT_EQ(stiffness.at({2.5, 0}), 1) << "taken back";
}

TEST(Stiffness, ScalesWithTheUnitOfLength) {
  const Stiffness stiffness({{line({{1, 0}, {2, 1}}), 0.25, 7}});
  const Stiffness scaled = stiffness.scaled(1024);
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const Vec2 p(0.5 + 0.1 * i, -0.5 + 0.1 * j);
      EXPECT_EQ(scaled.at(1024 * p), stiffness.at(p)) << p.transpose();
    }
}

TEST(Stiffness, DisksOfHandlesMultiplyWhatIsPainted) {
  Points rest(2, 2);
  rest << 0, 10, 0, 0;
  const std::vector<Handle> handles{{.id = 0, .vertex = 0, .stiff = StiffDisk{10, 2}},
                                    {.id = 1, .vertex = 1, .stiff = StiffDisk{0.1, 1}},
                                    {.id = 2, .vertex = 1}};
  const auto painted = std::make_shared<const Stiffness>(
      std::vector<StiffStroke>{{line({{1, 0}, {11, 0}}), 0.5, 7}});
  const auto stiffness = stiffness_with(painted, handles, rest);
  EXPECT_EQ(stiffness->at({-1.9, 0}), 10);
  EXPECT_EQ(stiffness->at({1, 0}), 70);
  EXPECT_EQ(stiffness->at({5, 0}), 7);
  EXPECT_DOUBLE_EQ(stiffness->at({10, 0}), 0.7);
  EXPECT_EQ(stiffness->at({-3, 0}), 1);
  EXPECT_EQ(stiffness->scaled(8).at({-15, 0}), 10) << "disks are scaled too";
  EXPECT_EQ(stiffness_with(nullptr, handles, rest)->at({0, 0}), 10);
  EXPECT_EQ(stiffness_with(painted, {handles[2]}, rest), painted);
  EXPECT_EQ(stiffness_with(nullptr, {}, rest), nullptr);
}

TEST(Stiffness, ManyDisksStayWithinTheBounds) {
  const Points rest = Points::Zero(2, 1);
  const std::vector<Handle> stiff(4, {.stiff = StiffDisk{1000, 1}});
  EXPECT_EQ(stiffness_with(nullptr, stiff, rest)->at({0, 0}), kLargestStiffness);
  const std::vector<Handle> soft(4, {.stiff = StiffDisk{0.1, 1}});
  EXPECT_EQ(stiffness_with(nullptr, soft, rest)->at({0, 0}), kLeastStiffness);
}

}  // namespace
}  // namespace foldless
