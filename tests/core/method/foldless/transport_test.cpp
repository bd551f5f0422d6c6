// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "core/method/foldless/transport_plans.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

constexpr int kMostTransportSteps = 3000;

/// Runs to the end; every mesh on the way is proved.
Progress run_validly(StageRunner<Progress>& runner, const Workspace& work) {
  for (int step = 0; step < kMostTransportSteps && !runner.has_ended(); ++step) {
    runner.step();
    EXPECT_TRUE(test::is_valid(work.mesh)) << "step " << step;
  }
  return runner.has_ended() ? runner.result() : Progress::locked;
}

Progress run_validly(Steps<Progress> steps, const Workspace& work) {
  StageRunner<Progress> runner(std::move(steps));
  return run_validly(runner, work);
}

TransportPlan all_together(const Workspace& work) {
  return transport_plans(work.handles(), work.constraints.targets, 0).front();
}

/// Frames whose handles lock when they are carried all together, where they locked.
struct LockedTransport {
  std::uint64_t seed;
  std::unique_ptr<OwnWorkspace> locked;
};

std::vector<LockedTransport> locked_transports() {
  std::vector<LockedTransport> found;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::unique_ptr<OwnWorkspace> own(new OwnWorkspace(test::held_frame(seed)));
    if (run_validly(transport(own->work, all_together(own->work)), own->work) == Progress::locked)
      found.push_back({seed, std::move(own)});
  }
  EXPECT_GE(found.size(), 8U) << "the claims would be empty";
  return found;
}

TEST(Transport, InRoundsArrivesWhereAPlainOneLocks) {
  int arrived = 0;
  for (const auto& [seed, locked] : locked_transports()) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = test::held_frame(seed);
    Workspace& work = own.work;
    StageRunner<Progress> runner(transport_in_rounds(work, all_together(work)));
    const Progress progress = run_validly(runner, work);
    // The mesh settles before every round, with the handles where they are.
    const std::vector<Iteration>& records = runner.records();
    std::vector<double> errors;
    for (std::size_t i = 1; i < records.size(); ++i)
      if (records[i].phase == Phase::settle && records[i - 1].phase == Phase::transport)
        errors.push_back(records[i].handle_error_squared);
    EXPECT_FALSE(errors.empty());
    EXPECT_LE(errors.size(), 8U);
    for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_LT(errors[i], 0.8 * errors[i - 1]);
    if (progress != Progress::arrived) continue;
    ++arrived;
    EXPECT_EQ(work.error(), 0);
  }
  EXPECT_GE(arrived, 3);
}

TEST(Transport, GoesOnFromWhereOneLockedAndSettlesFirst) {
  const std::vector<LockedTransport> transports = locked_transports();
  std::size_t nearer = 0;
  for (const auto& [seed, locked] : transports) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Workspace& work = locked->work;
    const double error = work.error();
    StageRunner<Progress> runner(transport_onwards(work));
    ASSERT_TRUE(runner.step());
    EXPECT_EQ(runner.records().front().phase, Phase::settle);
    EXPECT_EQ(work.error(), error) << "handles stay where they are meanwhile";
    run_validly(runner, work);
    nearer += work.error() < error;
  }
  EXPECT_GT(2 * nearer, transports.size());
}

TEST(Transport, GroupsTravelOneAfterTheOther) {
  const Shape shape = grid({.columns = 12, .rows = 12, .width = 0.7, .height = 0.7});
  const Vec2 ways[] = {{0.2, 0.1}, {0.1, 0.25}};
  const int vertices[] = {57, 96};
  std::vector<Handle> handles;
  for (int i = 0; i < 2; ++i)
    handles.push_back(
        {.id = i, .vertex = vertices[i], .target = shape.rest.col(vertices[i]) + ways[i]});
  OwnWorkspace own = test::workspace_of(MeshPair(shape.triangles, shape.rest), handles);
  Workspace& work = own.work;
  const Points starts = work.handles();
  const TransportPlan plan{PathKind::straight, {{1}, {0}, {0, 1}}};
  StageRunner<Progress> runner(transport(work, plan));
  int first_alone = 0;
  while (!runner.has_ended()) {
    runner.step();
    const Points now = work.handles();
    const double gone = (now.col(0) - starts.col(0)).norm();
    const double left = (work.constraints.targets.col(1) - now.col(1)).norm();
    if (left > plan.stride) {
      ++first_alone;
      EXPECT_LT(gone, 0.3 * plan.stride) << "it waits while the other has " << left << " to go";
    }
  }
  EXPECT_GE(first_alone, 3);
  EXPECT_EQ(runner.result(), Progress::arrived);
}

TEST(Transport, EdgesAheadOfHandlesThatStayBehindAreSplit) {
  const std::vector<LockedTransport> transports = locked_transports();
  const auto split = std::ranges::count_if(
      transports, [](const LockedTransport& one) { return one.locked->effort.splits > 0; });
  EXPECT_GT(2 * split, std::ssize(transports));
}

TEST(Transport, HandlesThatTurnKeepStepWhateverTheirDistanceFromTheCentre) {
  const Shape shape = grid({.columns = 12, .rows = 12, .width = 0.7, .height = 0.7});
  const Vec2 centre(0.35, 0.35);
  std::vector<Handle> handles;
  for (const int v : {81, 83, 85, 87}) {  // along a line, at distances of one and three cells
    const Vec2 from = shape.rest.col(v) - centre;
    handles.push_back({.id = v, .vertex = v, .target = centre + Vec2(-from.y(), from.x())});
  }
  test::OwnWorkspace own = test::workspace_of(MeshPair(shape.triangles, shape.rest), handles);
  Workspace& work = own.work;
  const Points starts = work.handles();
  StageRunner<Progress> runner(transport(work, {PathKind::turning, {{0, 1, 2, 3}}}));
  double largest_turn = 0;
  while (!runner.has_ended()) {
    runner.step();
    double least = 10, most = -10;
    for (int i = 0; i < 4; ++i) {
      const Vec2 a = starts.col(i) - centre, b = work.handles().col(i) - centre;
      const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      least = std::min(least, turn);
      most = std::max(most, turn);
    }
    EXPECT_LT(most - least, 0.3);
    EXPECT_LT(most - largest_turn, 0.5) << "strides are short";
    largest_turn = std::max(largest_turn, most);
  }
  EXPECT_EQ(runner.result(), Progress::arrived);
}

}  // namespace
}  // namespace foldless
