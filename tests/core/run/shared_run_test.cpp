// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/run/run.h"
#include "core/threads/team.h"
#include "tests/core/run/run_fixture.h"

namespace foldless {
namespace {

/// A bar of about so many triangles whose ends are twisted against each other: edges flip.
Problem twisted_bar(int cells) {
  const Shape shape = foldless::bar(4, 1, cells);
  Problem problem;
  problem.mesh = MeshPair(shape.triangles, shape.rest, shape.rest);
  problem.energy = find_density("arap");
  for (int v = 0; v < problem.mesh.vertex_count(); ++v) {
    const Vec2 p = shape.rest.col(v);
    if (p.x() > 0 && p.x() < 4) continue;
    const bool is_right = p.x() > 0;
    problem.handles.push_back({.vertex = v, .target = is_right ? Vec2(2 - p.y(), 1.5 + p.y()) : p});
  }
  return problem;
}

TEST(SharedRun, HasTheSameBitsWithAnyNumberOfThreads) {
  const Problem problem = twisted_bar(26);
  ASSERT_GT(problem.mesh.face_count(), 4096);
  std::vector<std::shared_ptr<const Snapshot>> ends;
  std::vector<std::vector<Iteration>> records;
  for (const int threads : {1, 2, 3}) {
    Team team(threads);
    const WithTeam with(&team);
    foldless::Run run(problem);
    records.push_back(test::finish(run));
    ends.push_back(run.snapshot());
    EXPECT_TRUE(run.is_satisfied());
  }
  EXPECT_GT(records[0].back().flips, 0);
  EXPECT_GT(records[0].back().factorizations, 1);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    SCOPED_TRACE(testing::Message() << i + 1 << " threads");
    ASSERT_EQ(records[i].size(), records[0].size());
    for (std::size_t k = 0; k < records[0].size(); ++k)
      ASSERT_EQ(records[i][k].energy, records[0][k].energy) << "iteration " << k;
    EXPECT_EQ(*ends[i]->triangles, *ends[0]->triangles);
    EXPECT_EQ(ends[i]->deformed, ends[0]->deformed);
  }
}

}  // namespace
}  // namespace foldless
