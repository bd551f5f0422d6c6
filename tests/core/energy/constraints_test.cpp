// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/constraints.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

Points two_vertices() {
  Points u(2, 2);
  u << 0, 1,  //
      0, 1;
  return u;
}

/// A hard handle 5 away from its target, and a soft one 1 away.
Constraints hard_and_soft() {
  return constraints_of(
      {Handle{.vertex = 0, .target = Vec2(3, 4), .weight = 7},
       Handle{.vertex = 1, .target = Vec2(1, 2), .kind = HandleKind::soft, .weight = 2}});
}

TEST(Constraints, SoftHandlesPullButDoNotCount) {
  const Points u = two_vertices();
  const Constraints constraints = hard_and_soft();
  EXPECT_DOUBLE_EQ(penalty(constraints, u), 25 + 2);
  EXPECT_DOUBLE_EQ(handle_error_squared(constraints, u), 25);
  EXPECT_DOUBLE_EQ(penalty(with_targets(constraints, handle_positions(constraints, u)), u), 0);
}

TEST(Constraints, AWeightIsThatOfASoftHandleOnly) {
  EXPECT_EQ(hard_and_soft().weights, Eigen::Vector2d(1, 2));
}

TEST(Constraints, TellWhichVerticesHaveHardHandles) {
  EXPECT_EQ(have_hard_handles(hard_and_soft(), 3), (std::vector{true, false, false}));
}

TEST(Constraints, HeldHandlesHaveNoPenaltyButAreNotThereForThat) {
  const Points u = two_vertices();
  const Constraints constraints = held(hard_and_soft());
  EXPECT_TRUE(constraints.is_eliminated(0));
  EXPECT_FALSE(constraints.is_eliminated(1));
  EXPECT_FALSE(hard_and_soft().is_eliminated(0));
  EXPECT_DOUBLE_EQ(penalty(constraints, u), 2) << "of the soft one";
  EXPECT_DOUBLE_EQ(handle_error_squared(constraints, u), 25);
}

TEST(Constraints, OtherTargetsAreThoseOfTheSameHandles) {
  const Points u = two_vertices();
  Points targets = handle_positions(hard_and_soft(), u);
  EXPECT_EQ(targets, u);
  targets.col(0) = Vec2(0, 2);
  const Constraints moved = with_targets(hard_and_soft(), targets);
  EXPECT_DOUBLE_EQ(penalty(moved, u), 4);
  EXPECT_DOUBLE_EQ(handle_error_squared(moved, u), 4);
  EXPECT_EQ(moved.vertices, hard_and_soft().vertices);
}

}  // namespace
}  // namespace foldless
