// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/transport_plans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace foldless {
namespace {

/// Handle i goes i + 1 to the right.
struct Row {
  explicit Row(int handles) : starts(Points::Zero(2, handles)), targets(starts) {
    for (int i = 0; i < handles; ++i) {
      starts(1, i) = i;
      targets.col(i) = starts.col(i) + Vec2(i + 1, 0);
    }
  }
  Points starts, targets;
};

TEST(TransportPlans, EveryPlanCarriesEveryHandle) {
  const Row row(5);
  for (const TransportPlan& plan : transport_plans(row.starts, row.targets, 7)) {
    std::set<int> carried;
    for (const std::vector<int>& group : plan.groups) carried.insert(group.begin(), group.end());
    EXPECT_EQ(carried.size(), 5U);
    EXPECT_EQ(plan.groups.back().size(), 5U) << "all are put right in the end";
    EXPECT_GT(plan.stride, 0);
  }
}

TEST(TransportPlans, RandomOrdersComeLastAreDifferentAndTheSameEveryTime) {
  const Row row(5);
  const auto few = transport_plans(row.starts, row.targets, 0);
  const auto many = transport_plans(row.starts, row.targets, 16);
  ASSERT_EQ(many.size(), few.size() + 16);
  std::set<std::vector<std::vector<int>>> orders;
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(many[i].groups, few[i].groups);
  for (std::size_t i = few.size(); i < many.size(); ++i) orders.insert(many[i].groups);
  EXPECT_GE(orders.size(), 12U) << "of 120 orders of five handles";
  const auto again = transport_plans(row.starts, row.targets, 16);
  for (std::size_t i = 0; i < many.size(); ++i) EXPECT_EQ(many[i].groups, again[i].groups);
}

TEST(TransportPlans, HandlesThatStayAreNoReasonForAnOrder) {
  Row row(5);
  row.targets.rightCols(3) = row.starts.rightCols(3);
  const auto few = transport_plans(row.starts, row.targets, 0);
  EXPECT_EQ(transport_plans(row.starts, row.targets, 16).size(), few.size());
}

}  // namespace
}  // namespace foldless
