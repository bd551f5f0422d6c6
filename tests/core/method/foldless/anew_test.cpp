// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/anew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/method/foldless/candidates.h"
#include "core/method/foldless/settle.h"
#include "core/method/satisfied.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/curled_bar.h"

namespace foldless {
namespace {

constexpr int kPositions = 200;

Points targets_at_rest(const Problem& problem) {
  return handle_positions(constraints_of(problem.handles), problem.mesh.rest());
}

/// The way of the last handle along a bow to `reach` from where it is, in 200 positions.
std::vector<Points> bow(const Problem& problem, const Vec2& reach, double bend) {
  std::vector<Points> way;
  Points targets = targets_at_rest(problem);
  const Vec2 from = targets.rightCols(1), across(-reach.y(), reach.x());
  for (int i = 1; i <= kPositions; ++i) {
    const double t = static_cast<double>(i) / kPositions;
    targets.rightCols(1) = from + t * reach + bend * t * (1 - t) * across;
    way.push_back(targets);
  }
  return way;
}

/// The way of the last handle once round a centre, in 200 positions.
std::vector<Points> circle(const Problem& problem, const Vec2& centre) {
  std::vector<Points> way;
  const Points start = targets_at_rest(problem);
  Points targets = start;
  for (int i = 1; i < kPositions; ++i) {
    const Eigen::Rotation2Dd turn(2 * std::numbers::pi * i / kPositions);
    targets.rightCols(1) = centre + turn * (start.rightCols<1>() - centre);
    way.push_back(targets);
  }
  way.push_back(start);
  return way;
}

/// The shape at rest after a drag of which every so many positions are seen, two steps each.
MeshPair dragged(const Problem& problem, const std::vector<Points>& way, std::size_t every) {
  Foldless method(problem);
  while (method.step({})) continue;
  for (std::size_t i = std::min(every, way.size()) - 1;; i = std::min(i + every, way.size() - 1)) {
    method.set_targets(way[i]);
    if (i + 1 == way.size()) break;
    for (int step = 0; step < 2; ++step) method.step({});
  }
  while (method.step({})) EXPECT_TRUE(test::is_valid(method.mesh()));
  EXPECT_EQ(method.outcome(), Outcome::gradient);
  return method.mesh();
}

/// A bar that is held at its left end and dragged at the middle of its right one.
Problem bar_problem() {
  const Shape shape = grid({.columns = 24, .rows = 4, .width = 0.9, .height = 0.15});
  Problem problem{
      MeshPair(shape.triangles, shape.rest), find_density("arap"), test::left_end(shape.rest), {}};
  const int tip = 24 + 2 * 25;
  problem.handles.push_back({.id = 1000, .vertex = tip, .target = shape.rest.col(tip)});
  return problem;
}

/// A grid whose corners and middle are handles.
Problem corners_problem() {
  return test::grid_problem({{0, {0, 0}}, {8, {0, 0}}, {72, {0, 0}}, {80, {0, 0}}, {40, {0, 0}}});
}

double farthest(const MeshPair& a, const MeshPair& b, int vertices) {
  return (a.deformed() - b.deformed()).leftCols(vertices).colwise().norm().maxCoeff();
}

TEST(StartAnew, HowOftenAHandIsLookedAtDoesNotChangeTheShape) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int alike = 0, drags = 0;
  for (const Problem& problem : {bar_problem(), corners_problem()})
    for (int k = 0; k < 6; ++k, ++drags) {
      const Vec2 reach = 0.3 * Vec2(unit(random), unit(random));
      const std::vector<Points> way = bow(problem, reach, unit(random));
      const MeshPair often = dragged(problem, way, 1), seldom = dragged(problem, way, 10),
                     once = dragged(problem, way, 1000);
      const int vertices = problem.mesh.vertex_count();
      const double D = bounding_box_diagonal(problem.mesh.rest());
      if (farthest(often, seldom, vertices) < 1e-3 * D &&
          farthest(often, once, vertices) < 1e-3 * D)
        ++alike;
      else
        RecordProperty("other_shape", testing::PrintToString(reach.transpose()));
    }
  EXPECT_GE(alike, drags - 1) << "a better minimum that only a way leads to is kept";
}

/// Ends at once, with a mesh that is given.
class AtOnce final : public SteppedMethod {
 public:
  explicit AtOnce(MeshPair mesh) : mesh_(std::move(mesh)) { begin(end()); }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points&) override { begin(end()); }

 private:
  static Steps<Outcome> end() { co_return Outcome::gradient; }
  MeshPair mesh_;
};

/// A square held at a corner and stretched, too large for candidates.
struct StretchedSquare {
  StretchedSquare() {
    const Shape shape = grid({.columns = 39, .rows = 39});
    problem.mesh = MeshPair(shape.triangles, shape.rest);
    problem.energy = find_density("arap");
    problem.handles.push_back({.id = 1, .vertex = 0, .target = problem.mesh.rest().col(0)});
  }
  MeshPair stretched(double length) const {
    MeshPair mesh = problem.mesh;
    Points u = mesh.rest();
    u.row(0) *= length;
    mesh.set_deformed(std::move(u));
    return mesh;
  }
  double merit(double length) const {
    return merit_of(test::workspace_of(stretched(length), problem.handles).work);
  }
  /// A length at which E Kᵉ is that much.
  double length_of(double merit_sought) const {
    double shorter = 1, longer = 4;
    for (int i = 0; i < 30; ++i) {
      const double middle = (shorter + longer) / 2;
      (merit(middle) < merit_sought ? shorter : longer) = middle;
    }
    return shorter;
  }
  Problem problem;
};

TEST(StartAnew, TheShapeFromRestIsTakenUpTo15PercentAboveThatOfTheWay) {
  const StretchedSquare square;
  ASSERT_GT(square.problem.mesh.face_count(), kLargestWithCandidates);
  const MeshPair of_the_way = square.stretched(1.5);
  for (const auto& [factor, is_taken] : {std::pair(1.03, true), {1.14, true}, {1.16, false}}) {
    SCOPED_TRACE(factor);
    const MeshPair from_rest = square.stretched(square.length_of(factor * square.merit(1.5)));
    test::OwnWorkspace own = test::workspace_of(of_the_way, square.problem.handles);
    const Solver solver = [&](const Problem& rest) {
      EXPECT_EQ(rest.mesh.deformed(), square.problem.mesh.rest());
      return std::make_unique<AtOnce>(from_rest);
    };
    ASSERT_TRUE(test::StageRunner(
                    start_anew(own.work, square.problem, square.problem.mesh.triangles(), solver))
                    .run());
    EXPECT_EQ(own.work.mesh.deformed(), (is_taken ? from_rest : of_the_way).deformed());
  }
}

TEST(StartAnew, ABarWhoseTipWentRoundItsHeldEndKeepsNoCurl) {
  const Problem problem = bar_problem();
  const MeshPair mesh = dragged(problem, circle(problem, Vec2(0, 0.075)), 1);
  EXPECT_EQ(mesh.triangles(), problem.mesh.triangles());
  EXPECT_LT((mesh.deformed() - problem.mesh.rest()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(StartAnew, WalksToTheBetterShapeInSteps) {
  const Problem problem = bar_problem();
  const std::vector<Points> way = circle(problem, Vec2(0, 0.075));
  Foldless method(problem);
  while (method.step({})) continue;
  for (const Points& targets : way) {
    method.set_targets(targets);
    for (int step = 0; step < 2; ++step) method.step({});
  }
  int steps = 0;
  double longest = 0;
  Points before = method.mesh().deformed();
  while (const auto record = method.step({})) {
    EXPECT_TRUE(test::is_valid(method.mesh()));
    const Points now = method.mesh().deformed();
    if (record->phase == Phase::anew) {
      EXPECT_EQ(now, before) << "what is tried is not seen";
    }
    if (record->phase == Phase::walk) {
      ++steps;
      longest = std::max(longest, (now - before).leftCols(125).colwise().norm().maxCoeff());
    }
    before = now;
  }
  EXPECT_GT(steps, 5);
  EXPECT_LT(longest, 0.3) << "of a bar of length 0.9";
}

TEST(StartAnew, TheWayMattersWhereHandlesMayHaveGoneRoundEachOther) {
  const auto matters = [](const Problem& problem) {
    return does_way_matter(prescribed_regions(problem.mesh, constraints_of(problem.handles)));
  };
  EXPECT_TRUE(matters(test::swirl())) << "handles inside of a held boundary";
  EXPECT_FALSE(matters(test::held_grid({})));
  EXPECT_FALSE(matters(corners_problem()));
  EXPECT_FALSE(matters(bar_problem()));
}

TEST(StartAnew, ARingInsideOfAHeldBoundaryStaysTurned) {
  const Problem problem = test::held_grid(test::turned({30, 32, 48, 50}, 0));
  Foldless method(problem);
  while (method.step({})) continue;
  std::set<Phase> phases;
  for (int k = 1; k <= 4; ++k) {
    const Problem turned = test::held_grid(test::turned({30, 32, 48, 50}, 20 * k));
    Points targets(2, static_cast<Eigen::Index>(turned.handles.size()));
    for (Eigen::Index i = 0; i < targets.cols(); ++i)
      targets.col(i) = turned.handles[static_cast<std::size_t>(i)].target;
    method.set_targets(targets);
    while (const auto record = method.step({})) phases.insert(record->phase);
  }
  EXPECT_FALSE(phases.contains(Phase::anew));
}

}  // namespace
}  // namespace foldless
