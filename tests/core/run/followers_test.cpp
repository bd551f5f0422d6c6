// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/followers.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <set>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/run/run.h"
#include "tests/core/run/run_fixture.h"

namespace foldless {
namespace {

using test::finish;

Handle handle_at(int vertex, const Vec2& target) {
  Handle handle;
  handle.vertex = vertex;
  handle.target = target;
  return handle;
}

std::set<int> vertices_of(const std::vector<Handle>& handles) {
  std::set<int> vertices;
  for (const Handle& handle : handles) vertices.insert(handle.vertex);
  return vertices;
}

/// A grid of 7 × 7 vertices a unit apart.
class FollowersOfAGrid : public testing::Test {
 protected:
  Vec2 at(int v) const { return rest_.col(v); }
  std::vector<Handle> all(const std::vector<Handle>& handles) const {
    return Followers(triangles_, rest_, handles).with_followers(handles);
  }

  test::Fixture grid_ = test::square_grid(7);
  Triangles triangles_ = grid_.triangles;
  Points rest_ = grid_.rest;
};

TEST_F(FollowersOfAGrid, ThereAreNoneOfHandlesThatDoNotTurn) {
  const std::vector<Handle> handles{handle_at(24, Vec2(1, 2))};
  EXPECT_EQ(all(handles), handles);
}

TEST_F(FollowersOfAGrid, AreWithinTheRadiusAndTurnedAboutTheTarget) {
  Handle leader = handle_at(24, Vec2(10, 20));
  leader.turn = Turn{90, 1.5};
  leader.kind = HandleKind::soft;
  leader.weight = 3;
  const auto handles = all({leader});
  EXPECT_EQ(vertices_of(handles), (std::set<int>{16, 17, 18, 23, 24, 25, 30, 31, 32}));
  for (const Handle& handle : handles) {
    const Vec2 offset = at(handle.vertex) - at(24);
    EXPECT_LT((handle.target - Vec2(10 - offset.y(), 20 + offset.x())).norm(), 1e-12);
    EXPECT_EQ(handle.kind, HandleKind::soft);
    EXPECT_EQ(handle.weight, 3);
  }
}

TEST_F(FollowersOfAGrid, AreNeverHandlesThemselvesAndFollowTheNearest) {
  Handle left = handle_at(22, at(22)), right = handle_at(26, at(26) + Vec2(5, 0));
  left.turn = Turn{0, 2.5};
  right.turn = Turn{0, 3.5};
  const auto handles = all({left, right, handle_at(24, Vec2(0, 9))});
  std::map<int, Vec2> targets;
  for (const Handle& handle : handles) {
    EXPECT_TRUE(targets.emplace(handle.vertex, handle.target).second) << handle.vertex;
  }
  EXPECT_EQ(targets.at(24), Vec2(0, 9));
  EXPECT_EQ(targets.at(23), at(23))
      << "nearer to the left one, though within the right one's reach";
  EXPECT_EQ(targets.at(25), at(25) + Vec2(5, 0));
}

TEST_F(FollowersOfAGrid, OfAVertexThatASplitMadeAreFoundFromItsTriangle) {
  Points rest(2, rest_.cols() + 1);
  rest << rest_, Vec2(3.3, 3.2);
  Handle leader = handle_at(static_cast<int>(rest_.cols()), rest.col(rest_.cols()));
  leader.turn = Turn{0, 1.1};
  const Followers followers(triangles_, rest, {leader});
  const auto vertices = vertices_of(followers.with_followers({leader}));
  EXPECT_TRUE(vertices.contains(24));
  EXPECT_TRUE(vertices.contains(25));
  EXPECT_TRUE(vertices.contains(32));
}

TEST(Followers, StayOnTheirLimb) {
  // A U of two bars of width 1 that are 0.2 apart.
  Triangles triangles(3, 0);
  Points rest(2, 0);
  const auto add_box = [&](double x, double y, double w, double h) {
    const auto v = static_cast<int>(rest.cols());
    rest.conservativeResize(2, v + 4);
    rest.rightCols(4) << x, x + w, x + w, x, y, y, y + h, y + h;
    triangles.conservativeResize(3, triangles.cols() + 2);
    triangles.rightCols(2) << v, v, v + 1, v + 2, v + 2, v + 3;
  };
  add_box(0, 0, 1, 1);
  add_box(1.2, 0, 1, 1);
  Handle leader = handle_at(1, rest.col(1));
  leader.turn = Turn{0, 5};
  const auto handles = Followers(triangles, rest, {leader}).with_followers({leader});
  EXPECT_EQ(vertices_of(handles), (std::set<int>{0, 1, 2, 3}));
}

/// A disk whose rim is held and whose middle turns.
Problem turning_disk(double angle) {
  const Shape shape = disk({});
  Problem problem;
  problem.mesh = MeshPair(shape.triangles, shape.rest);
  problem.energy = find_density("arap");
  for (int v = 0; v < shape.rest.cols(); ++v) {
    const double r = shape.rest.col(v).norm();
    if (r < 1e-9 || r > 0.999) problem.handles.push_back(handle_at(v, shape.rest.col(v)));
    if (r < 1e-9) problem.handles.back().turn = Turn{angle, 0.3};
  }
  return problem;
}

void expect_turned(const Snapshot& snapshot, double degrees) {
  const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
  int inside = 0;
  for (int v = 0; v < snapshot.original_vertices; ++v) {
    const Vec2 rest = snapshot.rest->col(v);
    if (rest.norm() > 0.3) continue;
    ++inside;
    EXPECT_LT((snapshot.deformed.col(v) - turn * rest).norm(), 1e-4);
  }
  EXPECT_GT(inside, 10);
  EXPECT_TRUE(is_injective(*snapshot.triangles, *snapshot.rest, snapshot.deformed));
}

TEST(TurningHandle, TakesTheMeshRoundItAlongRigidly) {
  const Problem problem = turning_disk(120);
  foldless::Run run(problem);
  finish(run);
  EXPECT_TRUE(run.is_satisfied());
  expect_turned(*run.snapshot(), 120);
  EXPECT_EQ(run.snapshot()->handles, problem.handles) << "followers are nobody's business";
}

TEST(TurningHandle, IsNotSatisfiedWhileItsFollowersAreNot) {
  const foldless::Run run(turning_disk(30));
  EXPECT_FALSE(run.is_satisfied()) << "the handle itself is where it should be";
  EXPECT_TRUE(foldless::Run(turning_disk(0)).is_satisfied());
}

TEST(TurningHandle, GoesOnFromWhereItIs) {
  const Problem problem = turning_disk(0);
  foldless::Run run(problem);
  finish(run);
  std::vector<double> angles(problem.handles.size(), 0);
  Points targets(2, static_cast<Eigen::Index>(problem.handles.size()));
  for (Eigen::Index i = 0; i < targets.cols(); ++i)
    targets.col(i) = problem.handles[static_cast<std::size_t>(i)].target;
  for (const double angle : {60.0, 130.0, -40.0}) {
    for (std::size_t i = 0; i < angles.size(); ++i)
      if (problem.handles[i].turn) angles[i] = angle;
    run.set_targets(targets, angles);
    finish(run);
    EXPECT_TRUE(run.is_satisfied()) << angle;
    expect_turned(*run.snapshot(), angle);
  }
  run.set_targets(targets);
  EXPECT_TRUE(run.is_satisfied()) << "targets alone leave the angles as they were";
}

}  // namespace
}  // namespace foldless
