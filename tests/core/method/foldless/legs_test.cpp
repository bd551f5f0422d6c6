// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/legs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/pursue.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

const Vec2 kMiddle(0.35, 0.35);

/// Four vertices about the middle of the grid turned by so many degrees; the boundary held or free.
Problem turned_core(double degrees, bool is_held) {
  const auto moved = test::turned({30, 32, 48, 50}, degrees);
  return is_held ? test::held_grid(moved) : test::grid_problem(moved);
}

TEST(Legs, OfATurnAreSixtyDegreesAtMostAndOnItsCircle) {
  for (const int degrees : {90, 91, 120, 121, 150, 179, 181, 210, 270}) {
    SCOPED_TRACE(degrees);
    const Problem problem = turned_core(degrees, true);
    const OwnWorkspace own = test::workspace_of(problem);
    const std::vector<Points> stops = legs_of(own.work);
    const int shortest_way = std::min(degrees, 360 - degrees);
    EXPECT_EQ(stops.size(), static_cast<std::size_t>(std::ceil(shortest_way / 60.0)));
    EXPECT_EQ(stops.back(), own.work.constraints.targets) << "bit for bit";
    Points before = own.work.handles();
    for (const Points& stop : stops) {
      for (int i = 0; i < 4; ++i) {
        const Vec2 from = before.col(i) - kMiddle, to = stop.col(i) - kMiddle;
        EXPECT_NEAR(to.norm(), from.norm(), 1e-12);
        EXPECT_LT(std::acos(from.dot(to) / from.squaredNorm()), std::numbers::pi / 3 + 1e-9);
      }
      EXPECT_EQ(stop.rightCols(stop.cols() - 4), before.rightCols(stop.cols() - 4));
      before = stop;
    }
  }
}

TEST(Legs, ThereIsOneWhereHandlesDoNotTurnFarTogether) {
  const auto count = [](const Problem& problem) {
    return legs_of(test::workspace_of(problem).work).size();
  };
  EXPECT_EQ(count(turned_core(89, true)), 1u);
  Problem two = turned_core(170, false);
  two.handles.resize(2);
  EXPECT_EQ(count(two), 1u) << "two always move by one similarity";
  Problem mirrored = turned_core(0, false);
  for (Handle& handle : mirrored.handles) handle.target.x() = 0.7 - handle.target.x();
  EXPECT_EQ(count(mirrored), 1u);
}

TEST(Legs, OtherPartsGoStraightBesideThem) {
  const Problem one = turned_core(170, false);
  const Eigen::Index n = one.mesh.vertex_count(), m = one.mesh.face_count();
  Points rest(2, 2 * n);
  rest << one.mesh.rest(), one.mesh.rest().colwise() + Vec2(2, 0);
  Triangles triangles(3, 2 * m);
  triangles << one.mesh.triangles(), one.mesh.triangles().array() + static_cast<int>(n);
  std::vector<Handle> handles = one.handles;
  const int other = static_cast<int>(n) + 40;
  const Vec2 way(0.3, 0.6);
  handles.push_back({.id = 99, .vertex = other, .target = rest.col(other) + way});
  const OwnWorkspace own = test::workspace_of(MeshPair(triangles, rest), handles);
  const std::vector<Points> stops = legs_of(own.work);
  ASSERT_EQ(stops.size(), 3u);
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(
        (stops[static_cast<std::size_t>(k)].col(4) - rest.col(other) - (k + 1) / 3.0 * way).norm(),
        1e-12);
}

TEST(Legs, APursuitStopsAtEach) {
  OwnWorkspace own = test::workspace_of(turned_core(175, false));
  const std::vector<Points> stops = legs_of(own.work);
  StageRunner<Progress> runner(pursue(own.work));
  std::size_t next = 0;
  while (!runner.has_ended()) {
    const auto record = runner.step();
    if (record->step_length < 1) continue;
    ASSERT_LT(next, stops.size());
    EXPECT_EQ(own.work.handles(), stops[next++]);
  }
  EXPECT_EQ(runner.result(), Progress::arrived);
  EXPECT_EQ(next, stops.size());
}

TEST(Legs, LeadAnApproachWhereStraightWaysMeetInAPoint) {
  OwnWorkspace straight = test::workspace_of(turned_core(180, true));
  EXPECT_EQ(test::run_to_the_end(approach(straight.work, FactorUse::lagged)), Progress::locked);
  for (const double degrees : {150, 165, 180, 195, 210}) {
    SCOPED_TRACE(degrees);
    OwnWorkspace led = test::workspace_of(turned_core(degrees, true));
    EXPECT_EQ(test::run_to_the_end(approach(led.work, FactorUse::lagged, legs_of(led.work))),
              Progress::arrived);
    EXPECT_EQ(led.work.error(), 0);
    EXPECT_LT(led.effort.factorizations, 20);
  }
}

}  // namespace
}  // namespace foldless
