// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/other_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/construct/pinned_disk.h"
#include "core/method/foldless/transport_plans.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless {
namespace {

using Kind = Way::Kind;

constexpr std::size_t kRandomOrders = 16;

std::vector<Way> ways_of(const Workspace& work, bool with_approach = false) {
  return other_ways(work.mesh, work.constraints, with_approach);
}

std::vector<TransportPlan> plans_of(const Workspace& work, int random_orders) {
  return transport_plans(work.handles(), work.constraints.targets, random_orders);
}

/// A frame for which no map is constructed: its boundary is held, that of a hole as well.
test::OwnWorkspace frame_with_a_hole(std::uint64_t seed) {
  const test::OwnWorkspace held = test::held_frame(seed);
  const MeshPair& mesh = held.work.mesh;
  const int middle = mesh.vertex_count() / 2;
  std::vector<int> kept;
  for (int t = 0; t < mesh.face_count(); ++t)
    if (!(mesh.triangles().col(t).array() == middle).any()) kept.push_back(t);
  const MeshPair frame(mesh.triangles()(Eigen::all, kept), mesh.rest());
  std::vector<Handle> handles;
  for (int v = 0; v < frame.vertex_count(); ++v)
    if (!frame.is_isolated(v) && frame.is_boundary_vertex(v))
      handles.push_back({.id = v, .vertex = v, .target = mesh.rest().col(v)});
  const Constraints& all = held.work.constraints;
  for (int i = 0; i < all.count(); ++i) {
    const int v = all.vertices[static_cast<std::size_t>(i)];
    if (!frame.is_isolated(v) && !frame.is_boundary_vertex(v))
      handles.push_back({.id = v, .vertex = v, .target = all.targets.col(i)});
  }
  return {frame, constraints_of(handles), held.settings};
}

bool is_plain_transport(const Way& way) {
  return way.kind == Kind::transport && !way.is_refined && !way.goes_in_rounds;
}

TEST(OtherWays, BeginWithAnApproachWhereNoneBeganAtRest) {
  const test::OwnWorkspace own = test::held_frame(1);
  const std::vector<Way> after_rest = ways_of(own.work), after_a_drag = ways_of(own.work, true);
  EXPECT_EQ(after_rest.front().kind, Kind::transport);
  EXPECT_EQ(after_a_drag.front().kind, Kind::approach);
  EXPECT_EQ(after_a_drag.size(), after_rest.size() + 1);
}

TEST(OtherWays, ComeInTheirOrder) {
  const test::OwnWorkspace own = test::held_frame(1);
  const std::vector<Way> ways = ways_of(own.work);
  const std::size_t first = plans_of(own.work, 0).size();
  const std::vector<TransportPlan> plans = plans_of(own.work, kRandomOrders);
  constexpr std::size_t kCuts = kClassesOfPinnedDisks;
  ASSERT_EQ(ways.size(), first + kCuts + 2 + kRandomOrders + plans.size());
  for (std::size_t i = 0; i < first; ++i) {
    EXPECT_TRUE(is_plain_transport(ways[i])) << i;
    EXPECT_EQ(ways[i].plan.groups, plans[i].groups) << i;
  }
  for (std::size_t i = first; i < first + kCuts; ++i) {
    EXPECT_EQ(ways[i].kind, Kind::cut);
    EXPECT_EQ(ways[i].boundary, CutBoundary::held);
    EXPECT_EQ(ways[i].choice, static_cast<int>(i - first));
  }
  for (const std::size_t i : {first + kCuts, first + kCuts + 1}) {
    EXPECT_EQ(ways[i].kind, Kind::onwards);
    EXPECT_EQ(ways[i].is_refined, i == first + kCuts + 1);
  }
  for (std::size_t i = first + kCuts + 2; i < ways.size(); ++i) {
    const bool is_refined = i >= first + kCuts + 2 + kRandomOrders;
    const std::size_t plan = is_refined ? i - first - kCuts - 2 - kRandomOrders : i - kCuts - 2;
    EXPECT_EQ(ways[i].kind, Kind::transport) << i;
    EXPECT_TRUE(ways[i].goes_in_rounds) << i;
    EXPECT_EQ(ways[i].is_refined, is_refined) << i;
    EXPECT_EQ(ways[i].plan.groups, plans[plan].groups) << i;
  }
}

TEST(OtherWays, BeginWithTheQuickestCutWhereABoundaryIsFree) {
  const test::OwnWorkspace own = test::held_frame(1);
  std::vector<Handle> handles;
  for (int i = own.work.constraints.count() - 4; i < own.work.constraints.count(); ++i)
    handles.push_back({.id = i,
                       .vertex = own.work.constraints.vertices[static_cast<std::size_t>(i)],
                       .target = own.work.constraints.targets.col(i)});
  const std::vector<Way> ways = other_ways(own.work.mesh, constraints_of(handles), false);
  EXPECT_EQ(std::ranges::count(ways, Kind::cut, &Way::kind), 2);
  EXPECT_EQ(ways[0].kind, Kind::cut);
  EXPECT_EQ(ways[0].boundary, CutBoundary::free);
  EXPECT_EQ(ways[0].choice, kClassOfShortestSlits);
  EXPECT_EQ(ways[1].kind, Kind::cut);
  EXPECT_NE(ways[1].choice, kClassOfShortestSlits);
}

TEST(OtherWays, AfterACutThatArrivesOnlyCutsAreLeft) {
  int arrived = 0;
  for (std::uint64_t seed = 1; seed <= 30 && arrived == 0; ++seed) {
    test::OwnWorkspace own = test::held_frame(seed);
    Problem problem;
    problem.mesh = own.work.mesh;
    const std::vector<Way> all = ways_of(own.work);
    OtherWays ways(problem, false);
    for (std::size_t i = 0; all[i].kind != Kind::onwards; ++i) {
      const Progress progress = test::run_to_the_end(ways.try_next(own.work));
      if (progress != Progress::arrived) continue;
      if (all[i].kind != Kind::cut) break;
      ++arrived;
      while (all[++i].kind == Kind::cut) test::run_to_the_end(ways.try_next(own.work));
      EXPECT_TRUE(ways.have_ended());
      break;
    }
  }
  EXPECT_EQ(arrived, 1) << "the claim would be empty";
}

TEST(OtherWays, BeginWhereTheMeshIsAtRestWhereverTheRestMeshLies) {
  const Vec2 offset(0.5, -0.25);
  test::OwnWorkspace here = test::held_frame(1), there = test::held_frame(1);
  const MeshPair rest = here.work.mesh;
  const MeshPair placed(rest.triangles(), rest.rest(), rest.rest().colwise() + offset);
  there.work.set_mesh(placed);
  there.work.constraints.targets.colwise() += offset;
  for (const auto boundary : {CutBoundary::held, CutBoundary::free})
    EXPECT_EQ(handles_to_cut(placed, there.work.constraints, boundary),
              handles_to_cut(rest, here.work.constraints, boundary));
  const Constraints idle = with_targets(there.work.constraints, there.work.handles());
  EXPECT_EQ(handles_to_cut(placed, idle, CutBoundary::held), 0);
  Problem problem;
  problem.mesh = rest;
  Problem of_place = problem;
  of_place.offset = offset;
  OtherWays ways(problem, false), of_placed(of_place, false);
  test::StageRunner<Progress> runner(ways.try_next(here.work)),
      of_other(of_placed.try_next(there.work));
  for (int step = 0; step < 5; ++step) {
    const auto record = runner.step(), other = of_other.step();
    ASSERT_TRUE(record && other);
    EXPECT_NEAR(record->energy, other->energy, 1e-6 * record->energy);
    EXPECT_NEAR(record->handle_error_squared, other->handle_error_squared, 1e-9);
  }
}

TEST(OtherWays, OfALargeMeshAreFewer) {
  for (const int columns : {30, 32, 49, 51}) {
    const Shape shape = grid({.columns = columns, .rows = columns, .width = 0.7, .height = 0.7});
    const MeshPair mesh(shape.triangles, shape.rest);
    std::vector<Handle> handles;
    for (int v = 0; v < 5; ++v)
      handles.push_back({.id = v, .vertex = v, .target = shape.rest.col((v + 1) % 5)});
    const std::vector<Way> ways = other_ways(mesh, constraints_of(handles), false);
    const auto transports = std::ranges::count(ways, Kind::transport, &Way::kind);
    const bool is_refined = std::ranges::any_of(
        ways, [](const Way& way) { return way.is_refined && way.kind == Kind::transport; });
    EXPECT_EQ(is_refined, mesh.face_count() <= 2000) << mesh.face_count();
    EXPECT_EQ(transports > 6, mesh.face_count() <= 5000) << mesh.face_count();
  }
}

TEST(OtherWays, KeepTheNearestMeshOnShowAndGoOnFromTheNearestLockOfATransport) {
  int farther = 0, approached = 0, went_on = 0, not_the_last = 0;
  for (std::uint64_t seed = 141; seed <= 260; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::OwnWorkspace own = frame_with_a_hole(seed);
    Workspace& work = own.work;
    Problem problem;
    problem.mesh = work.mesh;
    const std::vector<Way> all = ways_of(work);
    OtherWays ways(problem, false);
    double nearest = std::numeric_limits<double>::infinity(), last = nearest;
    for (std::size_t i = 0; all[i].kind != Kind::onwards || !all[i].is_refined; ++i) {
      const double shown = work.error();
      test::StageRunner<Progress> runner(ways.try_next(work));
      runner.run();
      EXPECT_LE(work.error(), shown);
      if (runner.result() == Progress::arrived) break;
      const std::vector<Iteration>& records = runner.records();
      if (all[i].kind == Kind::onwards) {
        EXPECT_EQ(records.front().phase, Phase::settle);
        EXPECT_NEAR(records.front().handle_error_squared, nearest, 1e-12);
        ++went_on;
        not_the_last += nearest < last;
        continue;
      }
      for (const Iteration& record : records)
        if (record.phase == Phase::transport) last = record.handle_error_squared;
      const auto approach = std::ranges::find(records, Phase::approach, &Iteration::phase);
      if (approach != records.begin() && approach != records.end()) {
        EXPECT_LT((approach - 1)->handle_error_squared, shown);
        ++approached;
      }
      farther += last > shown;
      nearest = std::min(nearest, last);
    }
  }
  EXPECT_GE(std::min({farther, approached, went_on, not_the_last}), 2)
      << farther << ' ' << approached << ' ' << went_on << ' ' << not_the_last;
}

}  // namespace
}  // namespace foldless
