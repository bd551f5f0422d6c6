// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/depth_field.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_pair.h"
#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

Handle handle_of(int vertex, double depth) {
  Handle handle;
  handle.id = vertex;
  handle.vertex = vertex;
  handle.depth = depth;
  return handle;
}

TEST(DepthField, GoesEvenlyAlongAStripBetweenItsEnds) {
  const Fixture f = ribbon(10, 0, 5, 0.5);
  std::vector<Handle> ends;
  for (int j = 0; j < 3; ++j) {
    ends.push_back(handle_of(j, 2));
    ends.push_back(handle_of(30 + j, -3));
  }
  const Eigen::VectorXd depth = depth_field(f.triangles, f.rest, ends);
  for (Eigen::Index v = 0; v < depth.size(); ++v)
    EXPECT_NEAR(depth[v], 2 - f.rest(0, v), 1e-5) << "vertex " << v;
}

TEST(DepthField, OfAGridIsTheMeanOfItsNeighbours) {
  const int n = 9;
  const Fixture f = square_grid(n);
  const std::vector<Handle> handles{handle_of(10, 1), handle_of(70, -2), handle_of(40, 0)};
  const Eigen::VectorXd depth = depth_field(f.triangles, f.rest, handles);
  for (const Handle& handle : handles) EXPECT_EQ(depth[handle.vertex], handle.depth);
  for (int j = 1; j + 1 < n; ++j)
    for (int i = 1; i + 1 < n; ++i) {
      const int v = j * n + i;
      if (v == 10 || v == 70 || v == 40) continue;
      EXPECT_NEAR(depth[v], (depth[v - 1] + depth[v + 1] + depth[v - n] + depth[v + n]) / 4, 1e-4);
    }
}

TEST(DepthField, StaysBetweenTheHandlesWhereTheRestMeshHasNeedles) {
  Fixture f = square_grid(7);
  f.rest.row(0) *= 1e-4;
  for (Eigen::Index v = 0; v < f.rest.cols(); ++v) f.rest(0, v) += 3 * f.rest(1, v);
  const Eigen::VectorXd depth =
      depth_field(f.triangles, f.rest, {handle_of(0, 1), handle_of(48, 2), handle_of(20, 1.5)});
  EXPECT_GE(depth.minCoeff(), 1 - 1e-9);
  EXPECT_LE(depth.maxCoeff(), 2 + 1e-9);
}

TEST(DepthField, IsNothingInAComponentWithoutAHandleAndForAVertexWithoutATriangle) {
  Fixture f = both(ribbon(4, 0, 4, 1), ribbon(4, 0, 4, 1));
  f.rest.conservativeResize(2, f.rest.cols() + 1);
  f.rest.rightCols(1).setZero();
  const Eigen::VectorXd depth = depth_field(f.triangles, f.rest, {handle_of(0, 3)});
  for (int v = 0; v < 15; ++v) EXPECT_NEAR(depth[v], 3, 1e-9) << "all of a component with one";
  for (int v = 15; v < 31; ++v) EXPECT_EQ(depth[v], 0);
}

TEST(DepthField, IsNothingWithoutDepths) {
  const Fixture f = square_grid(3);
  EXPECT_FALSE(has_depths({handle_of(0, 0), handle_of(4, 0)}));
  EXPECT_TRUE(has_depths({handle_of(0, 0), handle_of(4, -0.5)}));
  EXPECT_TRUE(depth_field(f.triangles, f.rest, {handle_of(0, 0)}).isZero(0));
  EXPECT_TRUE(depth_field(f.triangles, f.rest, {}).isZero(0));
}

TEST(DepthField, StaysAsItIsWhereEdgesFlipAndIsTheMeanAtSplits) {
  const Fixture f = square_grid(5);
  const std::vector<Handle> handles{handle_of(0, 1), handle_of(24, -1)};
  DepthField field;
  const Eigen::VectorXd before = field.update(f.triangles, f.rest, handles);
  EXPECT_EQ(before, depth_field(f.triangles, f.rest, handles));
  MeshPair mesh(f.triangles, f.rest);
  mesh.flip(*mesh.find_edge(6, 12));
  EXPECT_EQ(field.update(mesh.triangles(), mesh.rest(), handles), before);
  mesh.split_triangle(0, Eigen::Vector3d::Constant(1.0 / 3));
  const Eigen::VectorXd after = field.update(mesh.triangles(), mesh.rest(), handles);
  EXPECT_EQ(after.head(25), before);
  EXPECT_NEAR(after[25], before(f.triangles.col(0)).mean(), 1e-12);
}

TEST(DepthField, IsSolvedAnewForOtherDepthsHandlesAndMeshes) {
  const Fixture f = square_grid(5), small = square_grid(4);
  DepthField field;
  for (const Fixture& mesh : {f, small, f})
    for (const auto& handles : {std::vector{handle_of(0, 1), handle_of(15, 0)},
                                std::vector{handle_of(0, 2), handle_of(15, 0)},
                                std::vector{handle_of(0, 2), handle_of(15, 0), handle_of(9, 0)}})
      EXPECT_EQ(field.update(mesh.triangles, mesh.rest, handles),
                depth_field(mesh.triangles, mesh.rest, handles));
}

TEST(DepthField, IsThatOfTheHandlesWhereEveryVertexHasOne) {
  const Fixture f = unit_square();
  const Eigen::VectorXd depth = depth_field(
      f.triangles, f.rest, {handle_of(0, 1), handle_of(1, 2), handle_of(2, 3), handle_of(3, 4)});
  EXPECT_EQ(depth, Eigen::Vector4d(1, 2, 3, 4));
}

}  // namespace
}  // namespace foldless::test
