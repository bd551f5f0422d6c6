// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/foldless.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "tests/support/random_scene.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::is_valid;

Problem grid_problem(const std::vector<std::pair<int, Vec2>>& handles) {
  const Shape shape = grid({.columns = 8, .rows = 8, .width = 0.7, .height = 0.7});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  for (const auto& [vertex, move] : handles) {
    Handle handle;
    handle.id = static_cast<int>(problem.handles.size());
    handle.vertex = vertex;
    handle.target = shape.rest.col(vertex) + move;
    problem.handles.push_back(handle);
  }
  return problem;
}

/// The boundary of a grid held, a core of four vertices turned by 180° about the middle.
Problem swirl() {
  std::vector<std::pair<int, Vec2>> handles;
  const auto rest = grid_problem({}).mesh.rest();
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 8; ++i) {
      const int v = 9 * j + i;
      if (i == 0 || j == 0 || i == 8 || j == 8) handles.emplace_back(v, Vec2(0, 0));
      if ((i == 3 || i == 5) && (j == 3 || j == 5))
        handles.emplace_back(v, 2 * (Vec2(0.35, 0.35) - rest.col(v)));
    }
  return grid_problem(handles);
}

/// Handles that trade places, two scenes in three with the boundary held: few come home by
/// approaching alone.
Problem trading_places(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto rest = grid_problem({}).mesh.rest();
  std::vector<int> vertices;
  std::vector<std::pair<int, Vec2>> handles;
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 8; ++i) {
      const int v = 9 * j + i;
      const bool is_boundary = i == 0 || j == 0 || i == 8 || j == 8;
      if (!is_boundary) vertices.push_back(v);
      if (is_boundary && seed % 3 != 0) handles.emplace_back(v, Vec2(0, 0));
    }
  std::shuffle(vertices.begin(), vertices.end(), random);
  vertices.resize(6);
  for (std::size_t k = 0; k < vertices.size(); ++k)
    handles.emplace_back(vertices[k],
                         rest.col(vertices[(k + 1) % vertices.size()]) - rest.col(vertices[k]));
  return grid_problem(handles);
}

bool is_on_boundary(int v) { return v % 9 == 0 || v % 9 == 8 || v < 9 || v >= 72; }

/// The boundary of the grid held, but for `but`, and other vertices moved.
Problem held_grid(const std::vector<std::pair<int, Vec2>>& moved, int but = -1) {
  std::vector<std::pair<int, Vec2>> handles = moved;
  for (int v = 0; v < 81; ++v)
    if (is_on_boundary(v) && v != but) handles.emplace_back(v, Vec2(0, 0));
  return grid_problem(handles);
}

/// True when the boundary has the vertices of the grid and no others.
bool has_boundary_of_the_grid(const MeshPair& mesh) {
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_boundary_vertex(v) != (v < 81 && is_on_boundary(v))) return false;
  return true;
}

/// Runs to the end; every mesh on the way is proved.
std::set<Phase> run(Foldless& method, int most_steps = 3000) {
  std::set<Phase> phases;
  for (int step = 0; step < most_steps; ++step) {
    const auto iteration = method.step({});
    if (!iteration) break;
    phases.insert(iteration->phase);
    EXPECT_TRUE(is_valid(method.mesh())) << "step " << step;
  }
  return phases;
}

TEST(Foldless, SatisfiedMeansExactlyOnTarget) {
  Problem problem = grid_problem({{0, {0, 0}}, {8, {0.1, 0}}, {40, {-0.05, 0.12}}});
  const auto handles = problem.handles;
  Foldless method(std::move(problem));
  run(method);
  ASSERT_EQ(method.outcome(), Outcome::gradient);
  for (const Handle& handle : handles)
    EXPECT_EQ(Vec2(method.mesh().deformed().col(handle.vertex)), handle.target);
}

TEST(Foldless, AShortWayTakesFewFactorizations) {
  Foldless method(grid_problem({{0, {0, 0}}, {80, {0.002, 0.001}}}));
  std::optional<Iteration> last;
  while (const auto iteration = method.step({})) last = iteration;
  EXPECT_LE(last->factorizations, 8);
}

TEST(Foldless, ReachesACoreThatTurnsByHalfACircle) {
  Problem problem = swirl();
  const auto handles = problem.handles;
  Foldless method(std::move(problem));
  run(method);
  ASSERT_EQ(method.outcome(), Outcome::gradient);
  for (const Handle& handle : handles)
    EXPECT_EQ(Vec2(method.mesh().deformed().col(handle.vertex)), handle.target);
}

TEST(Foldless, WhileATransportIsUnderWayTheBestMeshStaysOnShow) {
  int transports = 0;
  for (std::uint64_t seed = 1; seed <= 40 && transports < 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Foldless method(trading_places(seed));
    bool was_transport = false;
    for (int step = 0; step < 400 && !method.outcome(); ++step) {
      const Points shown = method.mesh().deformed();
      const auto iteration = method.step({});
      const bool is_transport = iteration && iteration->phase == Phase::transport;
      const bool has_arrived = iteration && iteration->handle_error_squared == 0;
      if (is_transport && was_transport && !has_arrived) {
        EXPECT_EQ(method.mesh().deformed(), shown);
        ++transports;
      }
      was_transport = is_transport;
    }
  }
  EXPECT_GE(transports, 50) << "the claim would be empty";
}

/// The problem with a triangle of its own that has no handle, in a pose of its own.
Problem with_idle_triangle(Problem problem) {
  const MeshPair& mesh = problem.mesh;
  const int n = mesh.vertex_count();
  Triangles triangles(3, mesh.face_count() + 1);
  triangles << mesh.triangles(), Eigen::Vector3i(n, n + 1, n + 2);
  Points rest(2, n + 3), deformed(2, n + 3);
  rest << mesh.rest(), Vec2(0.8, 0), Vec2(0.9, 0), Vec2(0.9, 0.1);
  deformed << mesh.deformed(), Vec2(0.8, 0.3), Vec2(0.9, 0.5), Vec2(0.7, 0.6);
  problem.mesh = MeshPair(triangles, rest, deformed);
  return problem;
}

TEST(Foldless, AComponentWithoutAHandleStaysWhereItIsWhateverIsTried) {
  int transports = 0;
  for (const std::uint64_t seed : {1, 2, 4}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = with_idle_triangle(trading_places(seed));
    Foldless method(problem);
    for (int step = 0; step < 400 && !method.outcome(); ++step) {
      const auto iteration = method.step({});
      ASSERT_TRUE(iteration);
      ASSERT_EQ(method.mesh().deformed().middleCols(81, 3),
                problem.mesh.deformed().middleCols(81, 3))
          << "step " << step;
      transports += iteration->phase == Phase::transport;
    }
  }
  EXPECT_GT(transports, 50) << "the claim would be empty";
}

TEST(Foldless, IsValidOnRandomScenesWhateverIsCancelledAndResumed) {
  std::set<Phase> phases;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Foldless method(seed % 2 ? test::random_problem(seed) : trading_places(seed));
    std::mt19937_64 random(seed);
    std::stop_source stopped;
    stopped.request_stop();
    for (int step = 0; step < 400 && !method.outcome(); ++step) {
      if (random() % 4 == 0) {
        const Points before = method.mesh().deformed();
        EXPECT_FALSE(method.step(stopped.get_token()).has_value());
        EXPECT_EQ(method.mesh().deformed(), before);
      }
      if (const auto iteration = method.step({})) phases.insert(iteration->phase);
      ASSERT_TRUE(is_valid(method.mesh())) << "step " << step;
    }
  }
  // The claim would be empty if a stage were never entered.
  EXPECT_EQ(phases, (std::set{Phase::approach, Phase::transport, Phase::pursue, Phase::settle}));
}

TEST(Foldless, ACopyGoesOnLikeTheOriginal) {
  Foldless method(swirl());
  for (int i = 0; i < 10; ++i) method.step({});
  const std::unique_ptr<Method> copy = method.clone();
  for (int i = 0; i < 5; ++i) {
    method.step({});
    copy->step({});
  }
  EXPECT_LE((method.mesh().deformed() - copy->mesh().deformed()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Foldless, NewTargetsStartFromTheMeshAsItIs) {
  Problem problem = grid_problem({{0, {0, 0}}, {80, {0.1, 0.1}}});
  Points targets(2, 2);
  targets << problem.handles[0].target, problem.handles[1].target;
  Foldless method(std::move(problem));
  run(method);
  targets.col(1) += Vec2(0.01, -0.02);
  method.set_targets(targets);
  EXPECT_FALSE(method.outcome().has_value());
  run(method);
  ASSERT_EQ(method.outcome(), Outcome::gradient);
  EXPECT_EQ(Vec2(method.mesh().deformed().col(80)), Vec2(targets.col(1)));
}

TEST(Foldless, AHandleThatIsToLeaveTheHeldBoundaryIsProvedInfeasible) {
  Foldless method(held_grid({{40, {0.6, 0.05}}}));
  EXPECT_EQ(method.verdict(), "");
  run(method);
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_EQ(method.verdict(),
            "infeasible: vertex 40 is to go out of the held boundary, or onto it");
  EXPECT_TRUE(has_boundary_of_the_grid(method.mesh()));
  EXPECT_GT(method.mesh().deformed()(0, 40), 0.6) << "it is brought near";
}

TEST(Foldless, HandlesThatAreToMeetInsideTheHeldBoundaryAreProvedInfeasible) {
  Problem problem = held_grid({{40, {0, 0}}, {41, {0, 0}}});
  problem.handles[1].target = problem.handles[0].target;
  Foldless method(std::move(problem));
  run(method);
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_TRUE(method.verdict().starts_with("infeasible: vertices 40 and 41 ")) << method.verdict();
}

TEST(Foldless, NothingIsProvedWhereAVertexOfTheBoundaryIsFree) {
  Foldless method(held_grid({{40, {0.6, 0.05}}}, 44));
  run(method);
  EXPECT_EQ(method.outcome(), Outcome::gradient) << "the boundary bends";
  EXPECT_EQ(method.verdict(), "");
}

TEST(Foldless, TargetsThatComeBackWithinReachAreReached) {
  const Problem problem = held_grid({{40, {0.6, 0.05}}});
  Points targets = constraints_of(problem.handles).targets;
  Foldless method(problem);
  run(method);
  ASSERT_EQ(method.outcome(), Outcome::infeasible);
  for (const double x : {0.9, 0.6, 0.8, 0.4}) {
    targets.col(0) = Vec2(x, 0.3);
    method.set_targets(targets);
    EXPECT_FALSE(method.outcome());
    EXPECT_EQ(method.verdict(), "");
    run(method);
    ASSERT_EQ(method.outcome(), x < 0.7 ? Outcome::gradient : Outcome::infeasible) << x;
  }
  EXPECT_EQ(Vec2(method.mesh().deformed().col(40)), Vec2(0.4, 0.3));
  EXPECT_EQ(method.verdict(), "");
}

TEST(Foldless, TheHeldBoundaryIsNotSplit) {
  int splits = 0;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    if (seed % 3 == 0) continue;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Foldless method(trading_places(seed));
    for (int step = 0; step < 400 && !method.outcome(); ++step) {
      if (const auto iteration = method.step({})) splits = std::max(splits, iteration->splits);
      ASSERT_TRUE(has_boundary_of_the_grid(method.mesh())) << "step " << step;
    }
    EXPECT_NE(method.outcome(), Outcome::infeasible) << method.verdict();
  }
  EXPECT_GT(splits, 0) << "the claim would be empty";
}

/// The grid problem after somebody split the first edges of its mesh; handles may sit on the new
/// vertices, which begin at 81.
Problem split_grid_problem(int splits, const std::vector<std::pair<int, Vec2>>& handles) {
  const Problem before = grid_problem({});
  Problem problem = before;
  for (int e = 0; e < splits; ++e) problem.mesh.split_edge(e, 0.4);
  for (const auto& [vertex, move] : handles)
    problem.handles.push_back({.id = static_cast<int>(problem.handles.size()),
                               .vertex = vertex,
                               .target = problem.mesh.rest().col(vertex) + move});
  problem.original = OriginalMesh{std::make_shared<const Triangles>(before.mesh.triangles()),
                                  before.mesh.vertex_count()};
  return problem;
}

TEST(Foldless, VerticesOfSplitsThatNobodyNeedsGo) {
  const Problem problem = split_grid_problem(12, {{0, {0, 0}}, {80, {0.1, 0.05}}});
  ASSERT_EQ(problem.mesh.vertex_count(), 93);
  Foldless method(problem);
  run(method);
  ASSERT_EQ(method.outcome(), Outcome::gradient);
  EXPECT_LE(method.mesh().vertex_count(), 81 + 81 / 10);
  EXPECT_EQ(method.mesh().rest().leftCols(81), problem.mesh.rest().leftCols(81));
}

TEST(Foldless, AHandleOnAVertexOfASplitKeepsItsVertex) {
  const Problem problem = split_grid_problem(12, {{0, {0, 0}}, {84, {0.1, 0.05}}});
  Foldless method(problem);
  run(method);
  ASSERT_EQ(method.outcome(), Outcome::gradient);
  EXPECT_LT(method.mesh().vertex_count(), 93);
  EXPECT_EQ(method.mesh().rest().leftCols(85), problem.mesh.rest().leftCols(85));
  EXPECT_EQ(Vec2(method.mesh().deformed().col(84)), problem.handles[1].target);
}

TEST(Foldless, NewTargetsGoOnFromAMeshThatLostVertices) {
  const Problem problem = split_grid_problem(12, {{0, {0, 0}}, {80, {0.1, 0.05}}});
  Foldless method(problem);
  run(method);
  ASSERT_LT(method.mesh().vertex_count(), 93);
  Points targets(2, 2);
  targets << problem.handles[0].target, problem.handles[1].target + Vec2(0.05, -0.1);
  method.set_targets(targets);
  run(method);
  ASSERT_EQ(method.outcome(), Outcome::gradient);
  EXPECT_EQ(Vec2(method.mesh().deformed().col(80)), Vec2(targets.col(1)));
}

}  // namespace
}  // namespace foldless
