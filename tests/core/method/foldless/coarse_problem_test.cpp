// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/coarse_problem.h"

#include <gtest/gtest.h>

#include "tests/core/method/foldless/coarse_scenes.h"

namespace foldless {
namespace {

using test::bent_bar;
using test::bent_grid;
using test::kSmall;

TEST(CoarseProblem, AMeshIsDenseFromTwoThousandVertices) {
  EXPECT_FALSE(coarse_problem(bent_grid(44, 43), {}));  // 45 × 44
  EXPECT_TRUE(coarse_problem(bent_grid(45, 43), {}));   // 46 × 44
}

TEST(CoarseProblem, HasAboutTheVerticesThatWereAskedForAndTheSameHandles) {
  Problem problem = bent_bar();
  problem.handles.push_back(test::soft_handle_of(problem));
  const auto coarse = coarse_problem(problem, kSmall);
  ASSERT_TRUE(coarse);
  const MeshPair& mesh = coarse->problem.mesh;
  EXPECT_NEAR(mesh.vertex_count(), 915 / 4, 20);
  ASSERT_EQ(coarse->vertices.size(), static_cast<std::size_t>(mesh.vertex_count()));
  ASSERT_EQ(coarse->problem.handles.size(), problem.handles.size());
  for (std::size_t i = 0; i < problem.handles.size(); ++i) {
    Handle handle = coarse->problem.handles[i];
    handle.vertex = coarse->vertices[static_cast<std::size_t>(handle.vertex)];
    EXPECT_EQ(handle, problem.handles[i]);
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const int fine = coarse->vertices[static_cast<std::size_t>(v)];
    EXPECT_EQ(mesh.rest().col(v), problem.mesh.rest().col(fine));
  }
}

TEST(CoarseProblem, IsAsStiff) {
  Problem problem = bent_bar();
  problem.mesh.set_stiffness(std::make_shared<const Stiffness>(
      std::vector<StiffStroke>{{problem.mesh.rest().col(0), 0.1, 10}}));
  const auto coarse = coarse_problem(problem, kSmall);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->problem.mesh.stiffness(), problem.mesh.stiffness());
}

TEST(CoarseProblem, ThereIsNoneWhereEveryHandleHasAShortWay) {
  Problem problem = bent_bar();
  const double D = bounding_box_diagonal(problem.mesh.rest());
  for (Handle& handle : problem.handles) handle.target = problem.mesh.rest().col(handle.vertex);
  EXPECT_FALSE(coarse_problem(problem, kSmall));
  problem.handles[3].target += Vec2(0.049 * D, 0);
  EXPECT_FALSE(coarse_problem(problem, kSmall));
  problem.handles[5].target += Vec2(0, 0.051 * D);
  EXPECT_TRUE(coarse_problem(problem, kSmall)) << "one goes far enough";
}

TEST(CoarseProblem, ThereIsNoneWhenItIsCancelled) {
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_FALSE(coarse_problem(bent_bar(), kSmall, stopped.get_token()));
}

TEST(CoarseProblem, ThereIsNoneWhereFewVerticesMayGo) {
  EXPECT_FALSE(coarse_problem(bent_grid(300, 2), kSmall));
}

}  // namespace
}  // namespace foldless
