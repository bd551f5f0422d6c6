// SPDX-License-Identifier: GPL-3.0-or-later
// What a run comes to depends on its scene alone, and little on how that is written down.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "core/error.h"
#include "core/method/methods.h"
#include "core/threads/team.h"
#include "tests/core/run/calm_scenes.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

using test::calm_scenes;
using test::end_of;
using test::expect_same_distortion;

struct Result {
  Triangles triangles;
  Points rest, deformed;
  bool operator==(const Result&) const = default;
};

/// Nothing where the method does not take the energy.
std::optional<Result> result_of(Problem problem, std::string_view method) {
  problem.parameters.method = method;
  try {
    Run run(problem);
    test::finish(run, 20000);
    const Snapshot& end = *run.snapshot();
    return Result{*end.triangles, *end.rest, end.deformed};
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// By a right angle, which no rounding has a part in.
Problem turned(Problem problem) {
  const auto turn = [](const Points& p) -> Points {
    Points q(2, p.cols());
    q << -p.row(1), p.row(0);
    return q;
  };
  const MeshPair& mesh = problem.mesh;
  problem.mesh = MeshPair(mesh.triangles(), turn(mesh.rest()), turn(mesh.deformed()));
  for (Handle& handle : problem.handles) handle.target = turn(handle.target);
  return problem;
}

/// With vertices and triangles in another order, and corners of triangles moved on.
Problem renumbered(Problem problem, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const MeshPair& mesh = problem.mesh;
  const auto shuffled = [&](int size) {
    Eigen::VectorXi order = Eigen::VectorXi::LinSpaced(size, 0, size - 1);
    std::ranges::shuffle(order, random);
    return order;
  };
  const Eigen::VectorXi place = shuffled(mesh.vertex_count()), face = shuffled(mesh.face_count());
  Points rest(2, place.size()), deformed(2, place.size());
  for (Eigen::Index v = 0; v < place.size(); ++v) {
    rest.col(place[v]) = mesh.rest().col(v);
    deformed.col(place[v]) = mesh.deformed().col(v);
  }
  Triangles triangles(3, face.size());
  for (Eigen::Index f = 0; f < face.size(); ++f)
    for (int k = 0; k < 3; ++k) triangles((k + f) % 3, face[f]) = place[mesh.triangles()(k, f)];
  problem.mesh = MeshPair(triangles, rest, deformed);
  for (Handle& handle : problem.handles) handle.vertex = place[handle.vertex];
  return problem;
}

std::string name_of_row(const testing::TestParamInfo<MethodRow>& row) {
  std::string name(row.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
}

class Determinism : public testing::TestWithParam<MethodRow> {};

TEST_P(Determinism, TwiceItIsTheSameBits) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = test::random_problem(seed);
    EXPECT_EQ(result_of(problem, GetParam().name), result_of(problem, GetParam().name));
  }
}

TEST_P(Determinism, AnyNumberOfThreadsGivesTheSameBits) {
  // Of 2,048 triangles and more the sums of energies are shared.
  const Problem problem = test::grid_problem(40, Vec2(0.4, 0.3));
  const std::optional<Result> alone = result_of(problem, GetParam().name);
  for (const int threads : {2, 3}) {
    SCOPED_TRACE(threads);
    Team team(threads);
    const WithTeam with(&team);
    EXPECT_EQ(result_of(problem, GetParam().name), alone);
  }
}

TEST_P(Determinism, AQuarterTurnOfThePlaneIsOfNoConsequence) {
  for (const auto& [name, problem] : calm_scenes()) {
    SCOPED_TRACE(name);
    const test::End expected = end_of(problem, GetParam().name);
    const test::End found = end_of(turned(problem), GetParam().name);
    EXPECT_EQ(found, expected);
    expect_same_distortion(found, expected);
  }
}

// Edges that gain as much are flipped in the order of their numbers, so meshes that flip may end in
// another triangulation: their shape is compared where nothing was flipped.
TEST_P(Determinism, NumbersOfVerticesAndTrianglesAreOfNoConsequence) {
  int compared = 0;
  for (const auto& [name, problem] : calm_scenes()) {
    const test::End expected = end_of(problem, GetParam().name);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
      const test::End found = end_of(renumbered(problem, seed), GetParam().name);
      EXPECT_EQ(found.outcome, expected.outcome);
      EXPECT_EQ(found.satisfied, expected.satisfied);
      if (expected.outcome == "refused" || expected.flips + found.flips > 0) continue;
      ++compared;
      expect_same_distortion(found, expected);
    }
  }
  EXPECT_GT(compared, 0) << "the claim would be empty";
}

INSTANTIATE_TEST_SUITE_P(Methods, Determinism,
                         testing::ValuesIn(methods().begin(), methods().end()), name_of_row);

}  // namespace
}  // namespace foldless
