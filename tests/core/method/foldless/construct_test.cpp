// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/construct.h"

#include <gtest/gtest.h>

#include "core/construct/held_disk.h"
#include "core/mesh/quality.h"
#include "core/method/foldless/tidy.h"
#include "core/method/satisfied.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/held_disks.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless {
namespace {

using test::OwnWorkspace;

OwnWorkspace held_disk_workspace(const Problem& problem) {
  RunSettings settings = test::run_settings(problem.energy, problem.mesh);
  settings.diagonal = bounding_box_diagonal(problem.mesh.rest());
  return {problem.mesh, constraints_of(problem.handles), std::move(settings)};
}

Progress construct_in(OwnWorkspace& own, const Problem& problem) {
  return test::run_to_the_end(
      construct(own.work, problem.mesh, prescribed_regions(problem.mesh, own.work.constraints)));
}

TEST(Construct, ArrivesAtAnyPolygonThatBoundsADiskFromWhereverTheMeshIs) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = test::disk_to_glued_polygon(seed);
    OwnWorkspace own = held_disk_workspace(problem);
    if (seed % 2 == 0) own.work.mesh.set_deformed(2 * problem.mesh.rest());
    ASSERT_EQ(construct_in(own, problem), Progress::arrived);
    EXPECT_TRUE(test::is_valid(own.work.mesh));
    EXPECT_EQ(own.work.handles(), own.work.constraints.targets);
  }
}

double least_area_ratio(const MeshPair& mesh) {
  return quality_of(mesh.triangles(), mesh.rest(), mesh.deformed()).min_area_ratio;
}

/// The mesh that the stage begins with.
MeshPair mesh_before_opening(const Problem& problem) {
  const Constraints constraints = constraints_of(problem.handles);
  const PrescribedRegion region = prescribed_regions(problem.mesh, constraints).front();
  std::vector<int> loop;
  for (const int handle : region.loops.front())
    loop.push_back(constraints.vertices[static_cast<std::size_t>(handle)]);
  return *with_held_disk(problem.mesh, loop, constraints.targets(Eigen::all, region.loops.front()));
}

TEST(Construct, OpensTrianglesThatTheSceneForbidsAndLeavesTheMeshAsItWasWhereItCannot) {
  constexpr double kForbidden = 0.03;
  int opened = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = test::disk_to_glued_polygon(seed);
    const bool is_allowed = least_area_ratio(mesh_before_opening(problem)) > kForbidden;
    OwnWorkspace own = held_disk_workspace(problem);
    own.settings.energy.delta = kForbidden;
    const Progress progress = construct_in(own, problem);
    if (progress == Progress::arrived)
      EXPECT_GT(least_area_ratio(own.work.mesh), kForbidden);
    else
      EXPECT_EQ(own.work.mesh.revision(), problem.mesh.revision());
    if (!is_allowed) (progress == Progress::arrived ? opened : left) += 1;
  }
  EXPECT_GT(opened, 3) << "the claim would be empty";
  EXPECT_GT(left, 5) << "the claim would be empty";
}

TEST(Construct, RefinesCrushedTrianglesThatHaveHeldCornersAlone) {
  int mended = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = test::disk_to_glued_polygon(seed);
    for (Handle& handle : problem.handles) handle.target.y() *= 0.02;
    if (!is_crushed(mesh_before_opening(problem))) continue;
    OwnWorkspace own = held_disk_workspace(problem);
    if (construct_in(own, problem) == Progress::arrived && !is_crushed(own.work.mesh)) ++mended;
  }
  EXPECT_GT(mended, 3);
}

TEST(Construct, CarriesHandlesInsideOrLeavesTheMeshAsItWas) {
  int arrived = 0, locked = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = test::disk_to_glued_polygon(seed);
    // The middle goes to the middle of the first side's triangle, which may not be in the disk.
    const Vec2 target = (problem.handles[0].target + problem.handles[1].target +
                         problem.handles[static_cast<std::size_t>(2 + seed % 20)].target) /
                        3;
    problem.handles.push_back({.id = 999, .vertex = 0, .target = target});
    OwnWorkspace own = held_disk_workspace(problem);
    const Progress progress = construct_in(own, problem);
    EXPECT_TRUE(test::is_valid(own.work.mesh));
    (progress == Progress::arrived ? arrived : locked) += 1;
    if (progress == Progress::arrived)
      EXPECT_EQ(own.work.handles(), own.work.constraints.targets);
    else
      EXPECT_EQ(own.work.mesh.deformed(), problem.mesh.deformed());
  }
  EXPECT_GT(arrived, 2) << "the claim would be empty";
  EXPECT_GT(locked, 2) << "the claim would be empty";
}

TEST(Construct, LeavesBoundariesAloneThatAreOnTheirTargetsOrPartlyFree) {
  for (const bool is_on_target : {true, false}) {
    Problem problem = test::disk_to_glued_polygon(1);
    if (is_on_target)
      for (Handle& handle : problem.handles) handle.target = problem.mesh.rest().col(handle.vertex);
    else
      problem.handles.pop_back();
    OwnWorkspace own = held_disk_workspace(problem);
    EXPECT_EQ(construct_in(own, problem), Progress::locked);
    EXPECT_EQ(own.effort.updates + own.effort.steps, 0);
    EXPECT_EQ(own.work.mesh.revision(), problem.mesh.revision());
  }
}

TEST(Construct, HeldDisksAreReachedByRunsThatEndSettledAndTidied) {
  int constructed = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = test::disk_to_glued_polygon(seed);
    Foldless method(problem);
    const std::vector<Iteration> records = test::run_validly(method);
    test::expect_on_target(method, problem);
    const std::set<Phase> phases = test::phases_of(records);
    if (phases.contains(Phase::construct)) ++constructed;
    EXPECT_TRUE(phases.contains(Phase::settle));
  }
  EXPECT_GT(constructed, 4) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
