// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/transport_plans.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace foldless {
namespace {

/// Handles that turn by more than this turn together. [rad]
constexpr double kTurn = 0.5;
constexpr double kShortStride = 0.02;
/// Of every second pair of those in a random order.
constexpr double kMediumStride = 0.03;

std::vector<std::vector<int>> together(int handles) {
  std::vector<int> all(static_cast<std::size_t>(handles));
  std::iota(all.begin(), all.end(), 0);
  return {all};
}

/// One handle after the other in descending order of their ways. The last group is all of them, so
/// that those which waited can be put right.
std::vector<std::vector<int>> farthest_first(const Points& starts, const Points& targets) {
  std::vector<int> order = together(static_cast<int>(starts.cols())).front();
  const auto way = [&](int i) { return (targets.col(i) - starts.col(i)).norm(); };
  std::ranges::stable_sort(order, std::greater(), way);
  std::vector<std::vector<int>> groups;
  for (const int i : order)
    if (way(i) > 0) groups.push_back({i});
  groups.push_back(order);
  return groups;
}

std::vector<std::vector<int>> nearest_first(const Points& starts, const Points& targets) {
  auto groups = farthest_first(starts, targets);
  std::reverse(groups.begin(), groups.end() - 1);
  return groups;
}

std::vector<std::vector<int>> shuffled(std::vector<std::vector<int>> groups, std::mt19937& random) {
  // Not std::shuffle, whose result every standard library is free to choose.
  for (std::size_t left = groups.size() - 1; left > 1; --left)
    std::swap(groups[left - 1], groups[random() % left]);
  return groups;
}

}  // namespace

bool turn_together(const Points& starts, const Points& targets) {
  return std::abs(common_turn(starts, targets).angle) > kTurn;
}

std::vector<TransportPlan> transport_plans(const Points& starts, const Points& targets,
                                           int random_orders) {
  const auto all = together(static_cast<int>(starts.cols()));
  const bool turns = turn_together(starts, targets);
  const PathKind first = turns ? PathKind::turning : PathKind::straight;
  const PathKind second = turns ? PathKind::straight : PathKind::turning;
  const auto in_turn = farthest_first(starts, targets);
  std::vector<TransportPlan> plans = {{first, all},      {first, in_turn},
                                      {second, all},     {first, nearest_first(starts, targets)},
                                      {second, in_turn}, {first, all, kShortStride}};
  if (in_turn.size() <= 3) return plans;  // two handles have no other order
  std::mt19937 random(1);
  for (int i = 0; i < random_orders; ++i)
    plans.push_back({i % 2 == 0 ? first : second, shuffled(in_turn, random),
                     i % 4 < 2 ? TransportPlan().stride : kMediumStride});
  return plans;
}

TransportPlan plan_of_round(int round, const Points& starts, const Points& targets) {
  const bool are_together = round % 4 < 2;
  return {
      PathKind::straight,
      are_together ? together(static_cast<int>(starts.cols())) : farthest_first(starts, targets),
      round % 2 == 0 ? TransportPlan().stride : kShortStride};
}

}  // namespace foldless
