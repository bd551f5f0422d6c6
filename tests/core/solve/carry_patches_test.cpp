// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/carry_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "core/solve/descent.h"
#include "core/solve/line_search.h"
#include "core/solve/newton_step.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// A grid of edge length 1 with two vertices held, and a third that a step leads as far as the
/// triangles let it.
struct Stopped {
  /// The third is in the middle of a row of vertices.
  Stopped(int side, const Vec2& way, int row)
      : mesh(grid(side)),
        energy(energy_of(mesh, side, way, row)),
        system(mesh, energy.constraints, effort) {
    before = mesh.deformed();
    Points of_handles = Points::Zero(2, before.cols());
    of_handles.col(moved()) = way;
    system.assemble(energy, before, 1);
    EXPECT_TRUE(factorize_clamped(system, {}));
    step = carrying_step(system, energy.settings, before, of_handles);
    end = before + step;
    for (int i = 0; i < energy.constraints.count(); ++i)
      end.col(energy.constraints.vertices[static_cast<std::size_t>(i)]) =
          energy.constraints.targets.col(i);
    const double largest = system.objective().largest_step(energy.settings, before, step);
    t = std::min(1.0, kFirstTrial * largest);
    mesh.set_deformed(before + t * step);
  }

  Stopped(int side, const Vec2& way) : Stopped(side, way, side / 2) {}

  static MeshPair grid(int side) {
    const auto f = test::square_grid(side);
    return MeshPair(f.triangles, f.rest);
  }
  static Energy energy_of(const MeshPair& mesh, int side, const Vec2& way, int row) {
    const int moved = row * side + side / 2;
    const auto handle = [&](int v, const Vec2& by) {
      return Handle{.id = v, .vertex = v, .target = mesh.rest().col(v) + by};
    };
    Energy energy;
    energy.constraints = held(constraints_of({handle(5 * side + 5, {0, 0}), handle(moved, way),
                                              handle((side - 6) * side + side - 6, {0, 0})}));
    energy.settings.density = find_density("arap");
    energy.settings.beta = 0.01;
    return energy;
  }
  int moved() const { return energy.constraints.vertices[1]; }

  std::optional<Points> carried(const std::stop_token& token = {}) {
    return carry_patches(system, mesh, {energy, before, step, end}, token);
  }

  MeshPair mesh;
  Energy energy;
  Effort effort;
  NewtonSystem system;
  Points before, step, end;
  double t = 0;
};

/// Of the vertices, how many are not where the whole step ends.
int expect_carried(const Stopped& s, const Points& u) {
  EXPECT_EQ(handle_error_squared(s.energy.constraints, u), 0);
  EXPECT_TRUE(is_injective(s.mesh.triangles(), s.mesh.rest(), u));
  int others = 0;
  for (int v = 0; v < s.mesh.vertex_count(); ++v) {
    const bool is_at_the_end = u.col(v) == s.end.col(v);
    others += is_at_the_end ? 0 : 1;
    EXPECT_TRUE(is_at_the_end || !s.mesh.is_boundary_vertex(v)) << v;
  }
  return others;
}

TEST(CarryPatches, WhatIsRoundTheTrianglesInTheWayFollowsAndTheRestGoesTheWholeStep) {
  int arrived = 0, locked = 0;
  for (const double length : {6.5, 8.0, 9.0, 9.5})
    for (const double heading : {0.2, 1.3, 2.5, 3.7, 5.1}) {
      SCOPED_TRACE(testing::Message() << "by " << length << " to " << heading);
      Stopped s(90, length * Vec2(std::cos(heading), std::sin(heading)));
      const std::optional<Points> u = s.carried();
      (u ? arrived : locked) += 1;
      if (!u) continue;
      const int others = expect_carried(s, *u);
      EXPECT_GT(others, 0);
      EXPECT_LT(others, 0.05 * s.mesh.vertex_count());
    }
  EXPECT_GT(arrived, 5) << "the claim would be empty";
  EXPECT_GT(locked, 2);
}

TEST(CarryPatches, BoundaryVerticesGoTheWholeStep) {
  int arrived = 0;
  for (const double heading : {0.2, 1.3, 2.5, 3.7, 5.1}) {
    SCOPED_TRACE(testing::Message() << "to " << heading);
    Stopped s(90, 8 * Vec2(std::cos(heading), std::sin(heading)), 6);
    const std::optional<Points> u = s.carried();
    if (!u) continue;
    ++arrived;
    expect_carried(s, *u);
  }
  EXPECT_GT(arrived, 1) << "the claim would be empty";
}

TEST(CarryPatches, TrianglesThatAreNotNearHaveTheirStepBoundedAlongItsLine) {
  Stopped s(90, {7, 1.6});
  ASSERT_LT(s.t, 1);
  const std::optional<Points> u = s.carried();
  ASSERT_TRUE(u);
  std::vector<Eigen::Vector3i> on_the_line;
  for (const auto& t : s.mesh.triangles().colwise())
    if (std::ranges::all_of(t, [&](int v) { return u->col(v) == s.end.col(v); }))
      on_the_line.emplace_back(t);
  EXPECT_GT(on_the_line.size(), 1000U);
  for (int k = 0; k <= 8; ++k) {
    const Points on_the_way = s.before + k / 8.0 * (s.end - s.before);
    for (const Eigen::Vector3i& t : on_the_line) ASSERT_GT(signed_area(on_the_way, t), 0);
  }
}

TEST(CarryPatches, AHandleArrivesInOneCarryThatHasPassedItsNeighbours) {
  Stopped s(90, {7, 1.6});
  s.mesh.set_deformed(s.before);
  Effort effort;
  NewtonSystem system(s.mesh, s.energy.constraints, effort);
  const VertexUpdate update = carry_handles_and_patches(system, s.mesh, s.energy, {});
  EXPECT_EQ(update.step_length, 1);
  EXPECT_EQ(handle_error_squared(s.energy.constraints, s.mesh.deformed()), 0);
  EXPECT_GT(effort.updates, 1) << "those of a patch count";
  EXPECT_GT(effort.factorizations, 1);
  EXPECT_EQ(update.step_infinity_norm, (s.mesh.deformed() - s.before).cwiseAbs().maxCoeff());
}

TEST(CarryPatches, AreNotTakenWhereTheyWouldBeMuchOfTheMesh) {
  Stopped s(30, {7, 1.6});
  ASSERT_LT(s.t, 1);
  EXPECT_FALSE(s.carried());
}

TEST(CarryPatches, AreGivenUpWhereTheyDoNotArriveAndWhereTheyAreStopped) {
  Stopped too_far(90, {25, 4});
  ASSERT_LT(too_far.t, 1);
  const Points on_the_way = too_far.mesh.deformed();
  EXPECT_FALSE(too_far.carried());
  EXPECT_EQ(too_far.mesh.deformed(), on_the_way);

  Stopped near(90, {7, 1.6});
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(near.carried(source.get_token()));
  EXPECT_TRUE(near.carried());
}

}  // namespace
}  // namespace foldless
