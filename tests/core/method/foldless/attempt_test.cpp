// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/attempt.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/method/foldless/transport_plans.h"
#include "tests/core/method/foldless/held_frame.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

constexpr int kMostStepsOfAnAttempt = 3000;

Progress run_to_its_end(Attempt& attempt) {
  Progress progress = Progress::running;
  for (int step = 0; step < kMostStepsOfAnAttempt && progress == Progress::running; ++step) {
    VertexUpdate update;
    progress = attempt.step({}, update);
    EXPECT_TRUE(test::is_valid(attempt.work.mesh));
  }
  return progress;
}

Attempt all_together(const Workspace& workspace, bool is_persistent) {
  const Points starts = held_where_they_are(workspace.constraints, workspace.mesh.deformed()).targets;
  const TransportPlan plan = transport_plans(starts, workspace.constraints.targets, 0).front();
  return Attempt::transport(workspace, workspace.system.objective().settings(), plan,
                            is_persistent);
}

struct LockedTransport {
  std::uint64_t seed;
  Workspace at_rest, locked;
};

std::vector<LockedTransport> locked_transports() {
  std::vector<LockedTransport> found;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Workspace at_rest = test::held_frame(seed);
    Attempt plain = all_together(at_rest, false);
    if (run_to_its_end(plain) == Progress::locked) found.push_back({seed, at_rest, plain.work});
  }
  EXPECT_GE(found.size(), 8U) << "the claims would be empty";
  return found;
}

TEST(Attempt, APersistentTransportArrivesWhereAnotherLocks) {
  int arrived = 0;
  for (const auto& [seed, at_rest, locked] : locked_transports()) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Attempt persistent = all_together(at_rest, true);
    if (run_to_its_end(persistent) != Progress::arrived) continue;
    ++arrived;
    EXPECT_EQ(persistent.work.error(), 0);
  }
  EXPECT_GE(arrived, 3);
}

TEST(Attempt, GoesOnFromWhereATransportLocked) {
  const std::vector<LockedTransport> transports = locked_transports();
  std::size_t nearer = 0;
  for (const auto& [seed, at_rest, locked] : transports) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Attempt on = Attempt::going_on(locked, at_rest.system.objective().settings());
    EXPECT_TRUE(on.is_transport());
    EXPECT_EQ(on.work.error(), locked.error());
    run_to_its_end(on);
    nearer += on.work.error() < locked.error();
  }
  EXPECT_GT(2 * nearer, transports.size());
}

TEST(Attempt, AnApproachThatFollowsATransportHasTheEnergyOfTheScene) {
  const Workspace workspace = test::held_frame(1);
  Attempt attempt = all_together(workspace, false);
  const Density* of_scene = workspace.system.objective().settings().density;
  EXPECT_NE(attempt.work.system.objective().settings().density, of_scene);
  attempt.begin_approach();
  EXPECT_FALSE(attempt.is_transport());
  EXPECT_EQ(attempt.work.system.objective().settings().density, of_scene);
}

}  // namespace
}  // namespace foldless
