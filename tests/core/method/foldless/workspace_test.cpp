// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/workspace.h"

#include <gtest/gtest.h>

#include "tests/core/method/foldless/workspaces.h"

namespace foldless {
namespace {

using test::OwnWorkspace;

TEST(Workspace, StaysAsStiffWithAnotherMesh) {
  OwnWorkspace own = test::arrived_workspace(1);
  Workspace& work = own.work;
  const auto stiffness = std::make_shared<const Stiffness>(
      std::vector<StiffStroke>{{work.mesh.rest().col(0), 0.1, 10}});
  work.mesh.set_stiffness(stiffness);
  work.set_mesh({work.mesh.triangles(), work.mesh.rest()});
  EXPECT_EQ(work.mesh.stiffness(), stiffness);
}

TEST(Workspace, ARecordIsOfTheRealTargetsWhateverItAimedAt) {
  OwnWorkspace own = test::arrived_workspace(3);
  Workspace& work = own.work;
  work.constraints.targets.colwise() += Vec2(0.1, 0);
  Energy aimed{own.settings.energy, work.constraints};
  aimed.constraints.targets.colwise() += Vec2(0, 3);
  const Iteration record = work.record({}, aimed, Phase::approach);
  EXPECT_EQ(record.handle_error_squared, work.error());
  EXPECT_NEAR(record.penalty_energy, aimed.settings.alpha * work.error(), 1e-6);
  EXPECT_EQ(record.inner, 1);
  EXPECT_EQ(work.record({}, aimed, Phase::approach).inner, 2) << "they count through";
}

TEST(Workspace, ACopyAddsToTheSameEffort) {
  OwnWorkspace own = test::arrived_workspace(3);
  Workspace copy = own.work;
  copy.refine();
  EXPECT_GT(own.effort.splits, 0);
  EXPECT_LT(own.work.mesh.vertex_count(), copy.mesh.vertex_count());
}

TEST(Workspace, WhereHandlesAreHeldBarriersHaveATwentiethOfTheirWeights) {
  const OwnWorkspace own = test::arrived_workspace(3);
  const Energy energy = own.work.held_energy();
  EXPECT_TRUE(energy.constraints.held);
  EXPECT_DOUBLE_EQ(20 * energy.settings.beta, own.settings.energy.beta);
  EXPECT_DOUBLE_EQ(20 * energy.settings.gap_weight, own.settings.energy.gap_weight);
}

}  // namespace
}  // namespace foldless
