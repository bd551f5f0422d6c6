// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/mesh_at_rest.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"

namespace foldless {
namespace {

Handle handle_at(int id, int vertex) {
  Handle handle;
  handle.id = id;
  handle.vertex = vertex;
  return handle;
}

/// A bar whose first added vertices are at the points.
Points with_points(const Points& rest, const Points& points) {
  Points all(2, rest.cols() + points.cols());
  all << rest, points;
  return all;
}

TEST(MeshAtRest, IsTheShapeWhereHandlesAreAtItsVertices) {
  const Shape shape = bar(4, 1, 4);
  const auto made = mesh_at_rest(shape, {handle_at(3, 7), handle_at(1, 2)}, shape.rest, 1e-5);
  EXPECT_EQ(made.mesh.triangles(), shape.triangles);
  EXPECT_EQ(made.mesh.rest(), shape.rest);
  EXPECT_EQ(made.handles, (std::vector{handle_at(3, 7), handle_at(1, 2)}));
}

TEST(MeshAtRest, MadeAnewFromItsOwnVerticesIsTheSameBitForBit) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0.01, 3.99), y(0.01, 0.99);
  const Shape shape = bar(4, 1, 4);
  const int n = static_cast<int>(shape.rest.cols());
  for (int trial = 0; trial < 50; ++trial) {
    Points points(2, 4);
    std::vector<Handle> handles;
    for (int i = 0; i < 4; ++i) {
      points.col(i) = Vec2(x(random), y(random));
      handles.push_back(handle_at(i, n + i));
    }
    const auto once = mesh_at_rest(shape, handles, with_points(shape.rest, points), 1e-5);
    EXPECT_TRUE(is_injective(once.mesh.triangles(), once.mesh.rest(), once.mesh.deformed()));
    const auto again = mesh_at_rest(shape, once.handles, once.mesh.rest(), 1e-5);
    ASSERT_EQ(again.mesh.rest().cols(), once.mesh.rest().cols()) << trial;
    EXPECT_EQ(again.mesh.rest(), once.mesh.rest()) << trial;
    EXPECT_EQ(again.mesh.triangles(), once.mesh.triangles()) << trial;
    EXPECT_EQ(again.handles, once.handles) << trial;
  }
}

TEST(MeshAtRest, LeavesOutTheSecondOfTwoHandlesAtOneVertex) {
  const Shape shape = bar(4, 1, 4);
  const auto made = mesh_at_rest(shape, {handle_at(0, 5), handle_at(1, 5)}, shape.rest, 1e-5);
  EXPECT_EQ(made.handles, std::vector{handle_at(0, 5)});
}

}  // namespace
}  // namespace foldless
