// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary vertices that overlap themselves: what a run makes public of them.
#include <gtest/gtest.h>

#include "core/mesh/injective.h"
#include "tests/core/run/run_fixture.h"
#include "tests/support/notched_disk.h"

namespace foldless {
namespace {

using test::Script;
using test::starter_of;

constexpr double kGap = 0.5;

/// A notched disk whose notch is `now`, with a handle on its far side.
Problem notched_problem(double now) {
  const test::Fixture f = test::notched_disk(kGap);
  Problem problem;
  problem.mesh = MeshPair(f.triangles, f.rest, test::with_notch(f.rest, kGap, now));
  problem.energy = find_density("arap");
  problem.handles = {{.id = 1, .vertex = 14, .target = f.rest.col(14)}};
  return problem;
}

/// Closes the notch in the second iteration and opens it again in the fourth.
std::shared_ptr<Script> closing_script() {
  const auto script = std::make_shared<Script>();
  script->change = [](MeshPair& mesh, int k) {
    const Vec2 tip = mesh.deformed().col(0);
    const Points rest = mesh.rest().colwise() - Vec2(mesh.rest().col(0));
    const double notch = k == 2 || k == 3 ? -0.2 : 0.3;
    mesh.set_deformed(test::with_notch(rest, kGap, notch).colwise() + tip);
  };
  return script;
}

TEST(RunBoundary, FoldlessNeverPublishesAVertexThatOverlapsItself) {
  foldless::Run run(notched_problem(kGap), 0, starter_of(closing_script()));
  for (int k = 1; k <= 4; ++k) {
    const auto before = run.snapshot();
    ASSERT_TRUE(run.step({}));
    const Snapshot& now = *run.snapshot();
    EXPECT_EQ(run.snapshot() == before, k == 2 || k == 3) << k;
    EXPECT_EQ(now.overlapping_boundary_vertices, 0);
    EXPECT_TRUE(is_injective(*now.triangles, *now.rest, now.deformed));
  }
}

TEST(RunBoundary, ThoseOfTheOtherMethodsArePublishedAndCounted) {
  for (const char* method : {"paper", "paper-flip", "paper-noflip", "lim", "bounded-conformal",
                             "injective-projection"}) {
    Problem problem = notched_problem(kGap);
    problem.parameters.method = method;
    foldless::Run run(problem, 0, starter_of(closing_script()));
    for (int k = 1; k <= 4; ++k) {
      const auto before = run.snapshot();
      ASSERT_TRUE(run.step({}));
      EXPECT_NE(run.snapshot(), before) << method << " " << k;
      EXPECT_EQ(run.snapshot()->overlapping_boundary_vertices, k == 2 || k == 3) << k;
      EXPECT_TRUE(run.snapshot()->is_valid()) << "it may be gone on from";
    }
  }
}

TEST(RunBoundary, FoldlessGoesOnFromOneThatAnotherMethodLeft) {
  foldless::Run run(notched_problem(-0.1), 0, starter_of(closing_script()));
  EXPECT_EQ(run.snapshot()->overlapping_boundary_vertices, 1);
  for (int k = 1; k <= 4; ++k) {
    const auto before = run.snapshot();
    ASSERT_TRUE(run.step({}));
    EXPECT_NE(run.snapshot(), before) << k;
    EXPECT_EQ(run.snapshot()->overlapping_boundary_vertices, k == 2 || k == 3) << k;
  }
}

TEST(RunBoundary, ThoseOfIdlePartsAreCountedToo) {
  const Problem one = notched_problem(-0.1);
  const int n = one.mesh.vertex_count();
  Points rest(2, 2 * n), deformed(2, 2 * n);
  rest << one.mesh.rest(), one.mesh.rest().colwise() + Vec2(3, 0);
  deformed << one.mesh.deformed(), one.mesh.deformed().colwise() + Vec2(3, 0);
  Triangles triangles(3, 2 * one.mesh.face_count());
  triangles << one.mesh.triangles(), one.mesh.triangles().array() + n;
  Problem both = one;
  both.mesh = MeshPair(triangles, rest, deformed);
  EXPECT_EQ(foldless::Run(both).snapshot()->overlapping_boundary_vertices, 2);
}

}  // namespace
}  // namespace foldless
