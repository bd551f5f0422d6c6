// SPDX-License-Identifier: GPL-3.0-or-later
// No stage lets a boundary vertex overlap itself.
#include <gtest/gtest.h>

#include <utility>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/foldless.h"
#include "core/method/foldless/pursue.h"
#include "core/method/foldless/transport.h"
#include "core/method/foldless/transport_plans.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/notched_disk.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

constexpr int kMostSteps = 300;

/// A notched disk with the far side held; the ends of the lips are to go past each other.
OwnWorkspace crossing_lips(double gap, double way, double gap_weight) {
  const test::Fixture f = test::notched_disk(gap);
  std::vector<Handle> handles;
  for (const int v : {10, 18, 13, 14, 15})
    handles.push_back({.id = v, .vertex = v, .target = f.rest.col(v)});
  handles[0].target.y() -= way;
  handles[1].target.y() += way;
  const MeshPair mesh(f.triangles, f.rest);
  RunSettings settings = test::run_settings(find_density("arap"), mesh);
  settings.energy.gap_weight = gap_weight;
  return {mesh, constraints_of(handles), std::move(settings)};
}

using Stage = Steps<Progress> (*)(Workspace& work);

/// How many meshes of a stage overlap themselves.
int overlaps_of(const Stage& stage, double gap_weight) {
  int overlaps = 0;
  for (const double gap : {0.3, 0.8})
    for (const double way : {0.4, 0.9}) {
      OwnWorkspace own = crossing_lips(gap, way, gap_weight);
      StageRunner<Progress> runner(stage(own.work));
      for (int step = 0; step < kMostSteps && !runner.has_ended(); ++step) {
        runner.step();
        const MeshPair& mesh = own.work.mesh;
        EXPECT_TRUE(is_injective_inside(mesh.triangles(), mesh.rest(), mesh.deformed()));
        overlaps += !test::is_valid(mesh);
      }
    }
  return overlaps;
}

void expect_guarded(const Stage& stage) {
  EXPECT_EQ(overlaps_of(stage, Foldless::kGapWeight), 0);
  EXPECT_GT(overlaps_of(stage, 0), 0) << "the claim would be empty";
}

TEST(GuardedStages, APursuitClosesNoGap) {
  expect_guarded([](Workspace& work) { return pursue(work); });
}

TEST(GuardedStages, AnApproachClosesNoGap) {
  expect_guarded([](Workspace& work) { return approach(work, FactorUse::lagged); });
}

TEST(GuardedStages, ATransportClosesNoGap) {
  expect_guarded([](Workspace& work) {
    return transport(work, transport_plans(work.handles(), work.constraints.targets, 0).front());
  });
}

}  // namespace
}  // namespace foldless
