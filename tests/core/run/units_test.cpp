// SPDX-License-Identifier: GPL-3.0-or-later
// The unit of length, the place in the plane and what is idle have no influence.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "core/method/methods.h"
#include "core/run/active_part.h"
#include "core/run/publisher.h"
#include "tests/core/run/calm_scenes.h"
#include "tests/core/run/run_fixture.h"

namespace foldless {
namespace {

using test::calm_scenes;
using test::End;
using test::end_of;
using test::expect_same_distortion;
using test::placed;

double diagonal_of(const Problem& problem) {
  return active_diagonal(problem.mesh.triangles(), problem.mesh.rest(), problem.handles);
}

/// The problem with a vertex that no triangle uses, far away, and a part without a handle that is
/// squashed to a ten thousandth.
Problem with_idle_things(const Problem& problem) {
  const double D = diagonal_of(problem);
  const MeshPair& mesh = problem.mesh;
  const int vertices = mesh.vertex_count();
  Triangles triangles(3, mesh.face_count() + 2);
  triangles.leftCols(2) << 0, 0,  //
      1, 2,                       //
      2, 3;
  // The idle square comes first, so that every index of the active part is another one.
  triangles.rightCols(mesh.face_count()) = mesh.triangles().array() + 4;
  Points rest(2, vertices + 5), deformed(2, vertices + 5);
  rest.leftCols(4) << 3, 4, 4, 3,  //
      0, 0, 1, 1;
  rest.leftCols(4) *= D;
  deformed.leftCols(4) = rest.leftCols(4);
  deformed.leftCols(4).row(1) *= 1e-4;
  rest.middleCols(4, vertices) = mesh.rest();
  deformed.middleCols(4, vertices) = mesh.deformed();
  rest.col(vertices + 4) = deformed.col(vertices + 4) = Vec2(1e6, -1e6) * D;
  Problem wider = problem;
  wider.mesh = MeshPair(triangles, rest, deformed);
  for (Handle& handle : wider.handles) handle.vertex += 4;
  return wider;
}

class Units : public testing::TestWithParam<MethodRow> {};

TEST_P(Units, TheUnitOfLengthHasNoInfluence) {
  for (const auto& [name, problem] : calm_scenes()) {
    const End expected = end_of(problem, GetParam().name);
    for (const double scale : {1e-6, 1.3, 7.0, 1e6}) {
      SCOPED_TRACE(testing::Message() << name << " × " << scale);
      const End found = end_of(placed(problem, scale, Vec2::Zero()), GetParam().name);
      EXPECT_EQ(found, expected);
      expect_same_distortion(found, expected, scale);
    }
  }
}

TEST_P(Units, ThePlaceHasNoInfluence) {
  for (const auto& [name, problem] : calm_scenes()) {
    SCOPED_TRACE(name);
    const Vec2 far = Vec2(1e3, 1e3) * diagonal_of(problem);
    const End expected = end_of(problem, GetParam().name);
    const End found = end_of(placed(problem, 1, far), GetParam().name);
    EXPECT_EQ(found, expected);
    expect_same_distortion(found, expected);
  }
}

TEST_P(Units, WhatIsIdleHasNoInfluence) {
  for (const auto& [name, problem] : calm_scenes()) {
    const End expected = end_of(problem, GetParam().name);
    const Problem wider = with_idle_things(problem);
    for (const double scale : {1.0, 1e-6, 1.3, 7.0, 1e6}) {
      SCOPED_TRACE(testing::Message() << name << " × " << scale);
      EXPECT_EQ(end_of(placed(wider, scale, Vec2::Zero()), GetParam().name), expected);
    }
  }
}

TEST(Place, OfAMeshAtRestIsToldToTheMethod) {
  for (const auto& [name, calm] : calm_scenes()) {
    SCOPED_TRACE(name);
    Problem problem = placed(calm, 1.3, Vec2(3, -7));
    problem.mesh.set_deformed(problem.mesh.rest());
    problem.original = OriginalMesh{std::make_shared<const Triangles>(problem.mesh.triangles()),
                                    problem.mesh.vertex_count()};
    const Problem part =
        Publisher(problem, ActivePart(problem.mesh, problem.handles), 1).part_of(problem);
    EXPECT_NE(part.mesh.rest(), part.mesh.deformed()) << "the claim would be empty";
    EXPECT_EQ(part.at_rest(), part.mesh.deformed());
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Units, testing::ValuesIn(methods().begin(), methods().end()),
                         [](const auto& row) {
                           std::string name(row.param.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace foldless
