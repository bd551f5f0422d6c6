// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/legs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/method/handle_paths.h"

namespace foldless {
namespace legs {

constexpr double kLeastTurn = std::numbers::pi / 2;
constexpr double kLongestLeg = std::numbers::pi / 3;
/// The turn together may leave this part of the ways, in the root of the sum of squares.
constexpr double kMostLeft = 0.6;
/// Two handles always move by one similarity.
constexpr int kLeastHandles = 3;

bool turn_far_together(const CommonTurn& turn) {
  return std::abs(turn.angle) >= kLeastTurn && turn.moving >= kLeastHandles &&
         turn.left <= kMostLeft;
}

}  // namespace legs

std::vector<Points> legs_of(const Workspace& work) {
  using namespace legs;
  const Points starts = work.handles(), &targets = work.constraints.targets;
  std::vector<HandlePaths> paths;
  int count = 1;
  for (const std::vector<int>& part : work.parts) {
    const Points from = starts(Eigen::all, part), to = targets(Eigen::all, part);
    const CommonTurn turn = common_turn(from, to);
    const bool turns = turn_far_together(turn);
    paths.emplace_back(turns ? PathKind::turning : PathKind::straight, from, to);
    if (turns)
      count = std::max(count, static_cast<int>(std::ceil(std::abs(turn.angle) / kLongestLeg)));
  }
  std::vector<Points> stops(static_cast<std::size_t>(count), targets);
  for (int k = 0; k + 1 < count; ++k)
    for (std::size_t i = 0; i < paths.size(); ++i)
      stops[static_cast<std::size_t>(k)](Eigen::all, work.parts[i]) =
          paths[i].at((k + 1.0) / count);
  return stops;
}

std::vector<Points> straight_legs(const Workspace& work, int count) {
  const Points starts = work.handles();
  std::vector<Points> stops(static_cast<std::size_t>(count), work.constraints.targets);
  for (int k = 0; k + 1 < count; ++k)
    stops[static_cast<std::size_t>(k)] =
        starts + (k + 1.0) / count * (work.constraints.targets - starts);
  return stops;
}

}  // namespace foldless
