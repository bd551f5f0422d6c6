// SPDX-License-Identifier: GPL-3.0-or-later
// The bound on steps that keeps gaps at the boundary open holds for every step there is.
#include <gtest/gtest.h>

#include <random>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "core/solve/carry_handles.h"
#include "core/solve/descent.h"
#include "core/solve/line_search.h"
#include "tests/support/notched_disk.h"

namespace foldless {
namespace {

/// A notched disk whose lips' ends are to go past each other.
struct CrossingLips {
  CrossingLips(double gap, double way, double gap_weight)
      : f(test::notched_disk(gap)), mesh(f.triangles, f.rest) {
    std::vector<Handle> handles;
    for (const int v : {10, 18, 14})
      handles.push_back({.id = v, .vertex = v, .target = f.rest.col(v)});
    handles[0].target.y() -= way;
    handles[1].target.y() += way;
    energy.constraints = constraints_of(handles);
    energy.settings.density = find_density("symmetric-dirichlet");
    energy.settings.alpha = 100;
    energy.settings.beta = 2;
    energy.settings.barrier_area_weighted = true;
    energy.settings.gap_weight = gap_weight;
  }
  NewtonSystem system() { return {mesh, energy.constraints, effort}; }
  bool overlaps() const {
    return !overlapping_boundary_vertices(mesh.triangles(), mesh.deformed()).empty();
  }

  test::Fixture f;
  MeshPair mesh;
  Energy energy;
  Effort effort;
};

TEST(GuardedSteps, ALineSearchGoesEightTenthsOfTheWayToWhereAGapCloses) {
  CrossingLips lips(0.5, 1, 0.5);
  const Points step = test::with_notch(lips.f.rest, 0.5, 0.4) - lips.f.rest;
  const Objective objective(lips.mesh, {});
  const double t_max = objective.largest_step(lips.energy.settings, lips.f.rest, step);
  ASSERT_TRUE(std::isfinite(t_max));
  // Every vertex is pulled past that.
  const Points pulled = 2 * t_max * step;
  std::vector<Handle> handles;
  for (int v = 0; v < lips.mesh.vertex_count(); ++v)
    handles.push_back({.id = v, .vertex = v, .target = lips.f.rest.col(v) + pulled.col(v)});
  lips.energy.constraints = constraints_of(handles);
  lips.energy.settings.alpha = 1e6;
  const Objective of_all(lips.mesh, lips.energy.constraints);
  const EnergyGradient start = of_all.gradient(lips.energy, lips.f.rest);
  const LineSearchResult found = line_search(
      of_all, lips.energy,
      {lips.f.rest, pulled, start.energy.total(), start.gradient.dot(pulled.reshaped())});
  EXPECT_NEAR(found.step_length, 0.4, 1e-9);
}

TEST(GuardedSteps, CarriedHandlesCloseNoGap) {
  int overlaps_without = 0;
  for (const double gap : {0.2, 0.6, 1.2})
    for (const double way : {0.3, 0.8}) {
      SCOPED_TRACE(testing::Message() << "gap " << gap << ", way " << way);
      CrossingLips guarded(gap, way, 0.5), plain(gap, way, 0);
      for (CrossingLips* lips : {&guarded, &plain}) {
        lips->energy.constraints.held = true;
        NewtonSystem system = lips->system();
        for (int step = 0; step < 12; ++step) {
          carry_handles(system, lips->mesh, lips->energy, {});
          EXPECT_FALSE(lips == &guarded && lips->overlaps()) << "step " << step;
        }
      }
      overlaps_without += plain.overlaps();
    }
  EXPECT_GT(overlaps_without, 3) << "the claim would be empty";
}

TEST(GuardedSteps, NoStepOfADescentClosesAGap) {
  int overlaps_without = 0;
  for (const double gap : {0.2, 0.6, 1.2}) {
    CrossingLips guarded(gap, 0.5, 0.5), plain(gap, 0.5, 0);
    for (CrossingLips* lips : {&guarded, &plain}) {
      NewtonSystem system = lips->system();
      Descent descent;
      double E = system.objective().value(lips->energy, lips->mesh.deformed()).total();
      for (int step = 0; step < 40; ++step) {
        descent.step(system, lips->mesh, lips->energy, {});
        const double now = system.objective().value(lips->energy, lips->mesh.deformed()).total();
        EXPECT_LE(now, E * (1 + 1e-12));
        E = now;
        EXPECT_FALSE(lips == &guarded && lips->overlaps()) << "step " << step;
      }
    }
    overlaps_without += plain.overlaps();
  }
  EXPECT_GT(overlaps_without, 1) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
