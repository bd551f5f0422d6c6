// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/snap.h"

#include <gtest/gtest.h>

#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/notched_disk.h"
#include "tests/support/random_vector.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::OwnWorkspace;

/// Targets of all handles moved from where they are by up to `reach`.
void move_targets(Workspace& work, double reach, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-reach, reach);
  for (auto target : work.constraints.targets.colwise())
    target += test::random_vector(unit, random);
}

TEST(Snap, SnapsExactlyWhereNoTriangleFoldsAndTheEnergyGrowsByLessThanHalf) {
  int snapped = 0, folded = 0, grown = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    OwnWorkspace own = test::arrived_workspace(seed);
    Workspace& work = own.work;
    move_targets(work, std::pow(10.0, -1 - static_cast<int>(seed % 4)), random);
    const Points before = work.mesh.deformed();
    Points u = before;
    u(Eigen::all, work.constraints.vertices) = work.constraints.targets;
    const Objective& objective = work.system.objective();
    const bool folds = objective.largest_step(own.settings.energy, before, u - before) <= 1;
    const Energy energy{own.settings.energy, held(work.constraints)};
    const double E = objective.value(energy, before).total();
    const bool grows = !folds && objective.value(energy, u).total() > 1.5 * E;
    EXPECT_EQ(snap(work, own.settings.energy), !folds && !grows);
    EXPECT_EQ(work.mesh.deformed(), folds || grows ? before : u);
    EXPECT_TRUE(test::is_valid(work.mesh));
    folded += folds;
    grown += grows;
    snapped += !folds && !grows;
  }
  EXPECT_GE(std::min({snapped, folded, grown}), 4)
      << "the claim would be empty: " << snapped << ' ' << folded << ' ' << grown;
}

TEST(Snap, DoesNotSnapWhereAGapAtTheBoundaryWouldClose) {
  const test::Fixture f = test::notched_disk(0.4);
  const MeshPair mesh(f.triangles, f.rest);
  std::vector<Handle> handles;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    handles.push_back({.id = v, .vertex = v, .target = f.rest.col(v)});
  OwnWorkspace own = test::workspace_of(mesh, handles);
  Workspace& work = own.work;
  const Points open = test::with_notch(f.rest, 0.4, 0.02);
  work.mesh.set_deformed(open);
  work.constraints.targets = test::with_notch(f.rest, 0.4, -0.02);
  EXPECT_FALSE(snap(work, own.settings.energy));
  EXPECT_EQ(work.mesh.deformed(), open);
  work.constraints.targets = test::with_notch(f.rest, 0.4, 0.015);
  EXPECT_TRUE(snap(work, own.settings.energy));
  own.settings.energy.gap_weight = 0;
  work.constraints.targets = test::with_notch(f.rest, 0.4, -0.02);
  EXPECT_TRUE(snap(work, own.settings.energy)) << "nothing else speaks against it";
}

TEST(Snap, SoftHandlesAreNotSnapped) {
  OwnWorkspace own = test::arrived_workspace(3);
  Workspace& work = own.work;
  work.constraints.soft[0] = true;
  work.constraints.targets.colwise() += Vec2(1e-4, 0);
  const Vec2 soft = work.handles().col(0);
  ASSERT_TRUE(snap(work, own.settings.energy));
  EXPECT_EQ(work.handles().col(0), soft);
  EXPECT_EQ(work.error(), 0);
}

}  // namespace
}  // namespace foldless
