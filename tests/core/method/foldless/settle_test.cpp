// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

#include <gtest/gtest.h>

#include "core/mesh/quality.h"
#include "tests/core/method/foldless/settle_fixture.h"

namespace foldless {
namespace {

using test::arrived_workspace;

void run(Settle& settle, Workspace& workspace) {
  VertexUpdate update;
  while (settle.step(workspace, {}, update) == Progress::running) {
  }
}

Quality settled_quality(std::uint64_t seed, double exponent) {
  Workspace workspace = arrived_workspace(seed);
  Settle settle(workspace, exponent);
  run(settle, workspace);
  const MeshPair& mesh = workspace.mesh;
  return quality_of(mesh.triangles(), mesh.rest(), mesh.deformed());
}

TEST(Settle, NeverRaisesEnergyTimesDistortionAndStaysValid) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Workspace workspace = arrived_workspace(seed);
    Settle settle(workspace);
    VertexUpdate update;
    double merit = settle.merit_of(workspace);
    Progress progress = Progress::running;
    while (progress == Progress::running) {
      progress = settle.step(workspace, {}, update);
      EXPECT_LE(settle.merit_of(workspace), merit * (1 + 1e-9));
      EXPECT_TRUE(test::is_valid(workspace.mesh));
      merit = settle.merit_of(workspace);
    }
  }
}

TEST(Settle, HoldsTheHandlesWhereTheyAre) {
  Workspace workspace = arrived_workspace(3);
  Settle settle(workspace);
  run(settle, workspace);
  EXPECT_EQ(workspace.error(), 0);
}

TEST(Settle, LeavesTheEnergyOfTheSceneToOthers) {
  Workspace workspace = arrived_workspace(3);
  Settle settle(workspace);
  VertexUpdate update;
  settle.step(workspace, {}, update);
  EXPECT_EQ(workspace.system.objective().settings().conformal_weight, 0);
}

TEST(Settle, ALargerExponentLowersTheDistortions) {
  constexpr int kSeeds = 200;
  int lower_mean = 0, lower_max = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Quality plain = settled_quality(seed, 0);
    const Quality better = settled_quality(seed, 0.2);
    lower_mean += better.mean_conformal_distortion < plain.mean_conformal_distortion;
    lower_max += better.max_conformal_distortion < plain.max_conformal_distortion;
  }
  // Three of four; either comes to four of five.
  EXPECT_GE(lower_mean, 0.75 * kSeeds);
  EXPECT_GE(lower_max, 0.75 * kSeeds);
}

/// A grid at rest but for a vertex next to the opposite edge of one of its triangles; in the map
/// that vertex is where it belongs. Its Jacobians are in the order of 1/height.
Workspace crushed_workspace(double height) {
  const Shape shape = grid({.columns = 8, .rows = 8, .width = 0.7, .height = 0.7});
  Points rest = shape.rest;
  const Vec2 foot = 0.5 * (rest.col(39) + rest.col(49));
  rest.col(40) = foot + height * (rest.col(40) - foot);
  const MeshPair mesh(shape.triangles, rest, shape.rest);
  Constraints constraints = held_where_they_are(
      constraints_of({{.id = 0, .vertex = 0}, {.id = 1, .vertex = 80}}), mesh.deformed());
  EnergySettings energy{.density = find_density("green-strain"), .beta = 2, .delta = 1e-12};
  NewtonSystem system(energy, mesh, constraints);
  return {mesh, std::move(constraints), std::move(system), 1e-3, true};
}

TEST(Settle, FindsItsWayOutOfTrianglesThatAreNearlyCrushed) {
  for (const double height : {1e-2, 1e-4, 1e-6}) {
    SCOPED_TRACE(height);
    Workspace workspace = crushed_workspace(height);
    ASSERT_TRUE(test::is_valid(workspace.mesh));
    Settle settle(workspace);
    run(settle, workspace);
    const MeshPair& mesh = workspace.mesh;
    EXPECT_LT(quality_of(mesh.triangles(), mesh.rest(), mesh.deformed()).max_conformal_distortion,
              10);
  }
}

}  // namespace
}  // namespace foldless
