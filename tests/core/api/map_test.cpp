// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/core/api/api_fixture.h"

namespace foldless {
namespace {

using test::farthest;
using test::solved;
using test::Task;
using test::words_of_error;

const double kTolerance = 1e-12 * std::numbers::sqrt2;

/// A remeshed result: on 3 × 3 cells with vertices of splits, on 12 × 12 with 288 flips.
class Map : public testing::TestWithParam<int> {
 protected:
  const Task& task() const { return task_; }
  const Result& result() const { return result_; }

 private:
  Task task_ = test::swapped_square(GetParam());
  Result result_ = solved(task_);
};
INSTANTIATE_TEST_SUITE_P(, Map, testing::Values(3, 12));

TEST(Remeshing, OfTheTestsHasSplitsAndFlips) {
  const Task task = test::swapped_square(3);
  const Result result = solved(task);
  EXPECT_GT(result.rest.rows(), task.rest.rows());
  EXPECT_GT(result.log.back().flips, 0);
}

TEST_P(Map, TakesVerticesOfTheInputToWhereTheyAre) {
  PointMatrix expected(task().rest.rows(), 2);
  for (Eigen::Index v = 0; v < expected.rows(); ++v)
    expected.row(v) = result().deformed.row(result().parents.outputs[v]);
  EXPECT_LE(farthest(result().map(task().rest), expected), kTolerance);
}

TEST_P(Map, TakesVerticesOfTheOutputToWhereTheyAre) {
  EXPECT_LE(farthest(result().map(result().rest), result().deformed), kTolerance);
}

TEST_P(Map, IsLinearInEveryTriangleOfTheOutput) {
  const TriangleMatrix& triangles = result().triangles;
  PointMatrix points(triangles.rows(), 2), expected(triangles.rows(), 2);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Eigen::RowVector3d weights(0.2, 0.3, 0.5);
    for (int axis = 0; axis < 2; ++axis) {
      points(t, axis) = weights.dot(Eigen::RowVector3d(result().rest(triangles(t, 0), axis),
                                                       result().rest(triangles(t, 1), axis),
                                                       result().rest(triangles(t, 2), axis)));
      expected(t, axis) = weights.dot(Eigen::RowVector3d(result().deformed(triangles(t, 0), axis),
                                                         result().deformed(triangles(t, 1), axis),
                                                         result().deformed(triangles(t, 2), axis)));
    }
  }
  EXPECT_LE(farthest(result().map(points), expected), 1e-9);
}

TEST_P(Map, ByTriangleAndCoordinatesIsThatByPosition) {
  const Task& input = task();
  Eigen::VectorXi inputs(input.triangles.rows());
  CoordinateMatrix coordinates(input.triangles.rows(), 3);
  PointMatrix points(input.triangles.rows(), 2);
  std::mt19937 random(1);
  for (Eigen::Index t = 0; t < inputs.size(); ++t) {
    inputs[t] = static_cast<int>(t);
    for (int k = 0; k < 3; ++k) coordinates(t, k) = 1 + static_cast<double>(random() % 100);
    coordinates.row(t) /= coordinates.row(t).sum();
    points.row(t).setZero();
    for (int k = 0; k < 3; ++k)
      points.row(t) += coordinates(t, k) * input.rest.row(input.triangles(t, k));
  }
  EXPECT_LE(farthest(result().map(inputs, coordinates), result().map(points)), 1e-12);
}

TEST(MapBesideTheMesh, TakesPointsOfTheBoundaryThatRoundingPutsOutside) {
  // On slanting sides every third coordinate or so lies beside the line.
  Task turned = test::pulled_square(6);
  const double c = std::cos(0.3), s = std::sin(0.3);
  Eigen::Matrix2d turn;
  turn << c, s, -s, c;
  turned.rest = (turned.rest * turn).eval();
  const Result pulled = solved(turned);
  PointMatrix points(100, 2);
  for (int i = 0; i < 100; ++i)
    points.row(i) = (turned.rest.row(0) * (99 - i) + turned.rest.row(6) * i) / 99;
  const PointMatrix places = pulled.map(points);
  EXPECT_LE((places.row(0) - pulled.deformed.row(0)).norm(), kTolerance);
  EXPECT_LE((places.row(99) - pulled.deformed.row(6)).norm(), kTolerance);
}

TEST_P(Map, RefusesWhatIsNotInTheMesh) {
  PointMatrix outside(2, 2);
  outside << 0.5, 0.5, 1.5, 0.5;
  EXPECT_EQ(words_of_error([&] { result().map(outside); }),
            "point 1 at (1.5, 0.5) lies outside of the mesh; only points of the mesh are mapped");
  CoordinateMatrix coordinates(1, 3);
  coordinates << 0.5, 0.5, 0.5;
  const Eigen::VectorXi first = Eigen::VectorXi::Zero(1);
  EXPECT_NE(words_of_error([&] { result().map(first, coordinates); }), "");
  EXPECT_NE(words_of_error(
                [&] { result().map(Eigen::VectorXi::Constant(1, -1), CoordinateMatrix(1, 3)); }),
            "");
}

/// Three quarters of a ring and more: its ends lie over each other at rest.
Task overlapping_ring() {
  constexpr int kSectors = 40;
  Task task;
  task.rest.resize(2 * (kSectors + 1), 2);
  task.triangles.resize(2 * kSectors, 3);
  for (int i = 0; i <= kSectors; ++i) {
    const double angle = 2.2 * std::numbers::pi * i / kSectors;
    const Eigen::RowVector2d out(std::cos(angle), std::sin(angle));
    task.rest.row(2 * i) = out;
    task.rest.row(2 * i + 1) = 2 * out;
  }
  for (int i = 0; i < kSectors; ++i) {
    task.triangles.row(2 * i) << 2 * i, 2 * i + 1, 2 * i + 3;
    task.triangles.row(2 * i + 1) << 2 * i, 2 * i + 3, 2 * i + 2;
  }
  task.handles = {0, 2 * kSectors};
  task.targets.resize(2, 2);
  task.targets.row(0) = task.rest.row(0);
  task.targets.row(1) << -3, 0;
  return task;
}

TEST(MapOfOverlappingMeshes, TellsSheetsApartByTheirTriangles) {
  const Task ring = overlapping_ring();
  const Result straightened = solved(ring);
  const auto at_corner = [&](int triangle, int corner) {
    CoordinateMatrix coordinates = CoordinateMatrix::Zero(1, 3);
    coordinates(0, corner) = 1;
    return straightened.map(Eigen::VectorXi::Constant(1, triangle), coordinates);
  };
  for (const int t : {0, 1, 2, 77, 78, 79})
    for (int corner = 0; corner < 3; ++corner)
      EXPECT_LE(
          (at_corner(t, corner) - straightened.deformed.row(ring.triangles(t, corner))).norm(),
          4e-12);
}

TEST_P(Map, HasParentsThatPutEveryOutputVertexWhereItIsAtRest) {
  const Parents& parents = result().parents;
  ASSERT_EQ(parents.triangles.size(), result().rest.rows());
  for (Eigen::Index v = 0; v < result().rest.rows(); ++v) {
    Eigen::RowVector2d place(0, 0);
    for (int k = 0; k < 3; ++k)
      place +=
          parents.coordinates(v, k) * task().rest.row(task().triangles(parents.triangles[v], k));
    EXPECT_LE((place - result().rest.row(v)).norm(), kTolerance) << v;
    EXPECT_GE(parents.coordinates.row(v).minCoeff(), 0);
  }
}

TEST_P(Map, HasParentsThatNameTheOutputVertexOfEveryInputVertex) {
  const Parents& parents = result().parents;
  ASSERT_EQ(parents.outputs.size(), task().rest.rows());
  for (Eigen::Index v = 0; v < task().rest.rows(); ++v) {
    EXPECT_EQ(result().rest.row(parents.outputs[v]), task().rest.row(v));
    EXPECT_EQ(parents.coordinates.row(parents.outputs[v]).maxCoeff(), 1);
  }
}

/// Two squares beside each other, the first with the handles.
Task with_an_idle_square(const Task& first) {
  Task both = first;
  const Eigen::Index vertices = first.rest.rows(), faces = first.triangles.rows();
  both.rest.conservativeResize(2 * vertices, 2);
  both.rest.bottomRows(vertices) = first.rest.rowwise() + Eigen::RowVector2d(3, 0);
  both.triangles.conservativeResize(2 * faces, 3);
  both.triangles.bottomRows(faces) = first.triangles.array() + static_cast<int>(vertices);
  return both;
}

TEST(ParentsOfResults, KeepTheVerticesOfAPartWithoutHandles) {
  const Task task = with_an_idle_square(test::swapped_square(3));
  const Result moved = solved(task);
  ASSERT_GT(moved.rest.rows(), task.rest.rows());
  const PointMatrix idle = task.rest.bottomRows(16);
  EXPECT_EQ(moved.map(idle), idle);
  for (int v = 0; v < task.rest.rows(); ++v)
    EXPECT_EQ(moved.rest.row(moved.parents.outputs[v]), task.rest.row(v));
  EXPECT_LE(farthest(moved.map(moved.rest), moved.deformed), 4 * kTolerance);
}

TEST(ParentsOfResults, OfAVertexWithoutATriangleAreNone) {
  Task task = test::pulled_square(4);
  task.rest.conservativeResize(26, 2);
  task.rest.row(25) << 5, 5;
  const Result pulled = solved(task);
  EXPECT_EQ(pulled.parents.triangles[25], -1);
  EXPECT_TRUE(pulled.parents.coordinates.row(25).isZero());
  EXPECT_EQ(pulled.deformed.row(25), task.rest.row(25));
}

}  // namespace
}  // namespace foldless
