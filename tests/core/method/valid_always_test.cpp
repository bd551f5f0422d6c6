// SPDX-License-Identifier: GPL-3.0-or-later
// No step of Algorithm 1 leaves the set of locally injective maps: proved on random scenes, with
// exact predicates, at the ends of the steps and on the way.
#include <gtest/gtest.h>

#include "core/mesh/injective.h"
#include "core/method/remeshing_assisted.h"
#include "core/remesh/flip_edges.h"
#include "core/solve/relax_vertices.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

constexpr int kScenes = 200;
constexpr int kRounds = 12;
constexpr int kRelaxations = 8;

double rest_area(const MeshPair& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise()) sum += signed_area(mesh.rest(), t);
  return sum;
}

void expect_valid_between(const MeshPair& mesh, const Points& from, const Points& to) {
  const InjectivityChecker checker(mesh.triangles(), mesh.vertex_count());
  for (int k = 0; k <= 8; ++k)
    ASSERT_TRUE(checker.is_injective_inside(from + k / 8.0 * (to - from))) << k << "/8 of the step";
}

/// What a scene is run through, checked after every subroutine.
struct CheckedRun {
  explicit CheckedRun(const Problem& problem)
      : mesh(problem.mesh),
        energy{energy_settings(problem), constraints_of(problem.handles)},
        system(mesh, energy.constraints, effort),
        settings{energy.settings, problem.parameters.eta, true},
        area(rest_area(mesh)) {}

  void update() {
    const Points before = mesh.deformed();
    update_vertices(system, mesh, energy, {});
    expect_valid_between(mesh, before, mesh.deformed());
  }

  void relax() {
    for (int i = 0; i < kRelaxations; ++i) {
      const Points before = mesh.deformed();
      if (!relax_vertices(system, mesh, energy, {})) return;
      expect_valid_between(mesh, before, mesh.deformed());
    }
  }

  void flip() {
    const EnergyTerms before = system.objective().value(energy, mesh.deformed());
    const int flips = flip_edges(mesh, settings);
    if (flips == 0) return;
    flipped += flips;
    system.follow_flips(mesh);
    const EnergyTerms after = system.objective().value(energy, mesh.deformed());
    EXPECT_LE(after.distortion + after.barrier, before.distortion + before.barrier);
    EXPECT_NEAR(rest_area(mesh), area, 1e-12 * area);
    ASSERT_TRUE(is_injective_inside(mesh.triangles(), mesh.rest(), mesh.deformed()));
  }

  MeshPair mesh;
  Energy energy;
  Effort effort;
  DampedSystem system;
  FlipSettings settings;
  double area;
  int flipped = 0;
};

TEST(ValidAlways, NoStepOfAlgorithm1LeavesTheFeasibleSetAndNoFlipRaisesTheEnergy) {
  int flipped = 0;
  for (int seed = 1; seed <= kScenes; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CheckedRun run(test::random_problem(static_cast<std::uint64_t>(seed)));
    for (int round = 0; round < kRounds && !HasFatalFailure(); ++round) {
      run.update();
      run.flip();
      run.relax();
    }
    flipped += run.flipped;
    if (HasFatalFailure()) return;
  }
  // The claim would be empty on scenes that flip nothing.
  EXPECT_GT(flipped, kScenes);
}

TEST(ValidAlways, EveryMeshOfAWholeRunIsInjectiveWhereverItIsCancelled) {
  for (int seed = 1000; seed < 1040; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RemeshingAssisted method(test::random_problem(static_cast<std::uint64_t>(seed)),
                             {.flips = true});
    for (int step = 0; step < 60 && method.step({}); ++step)
      ASSERT_TRUE(is_injective_inside(method.mesh().triangles(), method.mesh().rest(),
                                      method.mesh().deformed()))
          << "step " << step;
  }
}

}  // namespace
}  // namespace foldless
