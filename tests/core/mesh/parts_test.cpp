// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/parts.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_pair.h"
#include "core/mesh/shape.h"
#include "tests/support/meshes.h"

namespace foldless::test {
namespace {

Shape shape_of(const Fixture& fixture) { return {fixture.triangles, fixture.rest}; }

TEST(MeshParts, HoldTheirComponents) {
  Shape shape = shape_of(unit_square());
  append(shape_of(square_grid(3)), shape);
  append(shape_of(unit_square()), shape);
  // The first two components are one part.
  const MeshParts parts{{"A", 0, 13, 0}, {"B", 13, 4, 1}};
  const std::vector<int> of_triangle = parts_of_triangles(shape.triangles, 17, parts);
  for (std::size_t t = 0; t < of_triangle.size(); ++t)
    EXPECT_EQ(of_triangle[t], t + 2 < of_triangle.size() ? 0 : 1) << t;
  EXPECT_EQ(parts_of_triangles(shape.triangles, 17, {}), std::vector<int>(of_triangle.size(), 0));
}

TEST(MeshParts, HoldVerticesOfSplits) {
  Shape shape = shape_of(unit_square());
  append(shape_of(unit_square()), shape);
  MeshPair mesh(shape.triangles, shape.rest);
  // Triangles of new vertices alone, too.
  for (int round = 0; round < 4; ++round)
    mesh.split_triangle(mesh.face_count() - 1, Eigen::Vector3d::Constant(1.0 / 3));
  const MeshParts parts{{"A", 0, 4, 0}, {"B", 4, 4, 1}};
  const std::vector<int> of_triangle =
      parts_of_triangles(mesh.triangles(), mesh.vertex_count(), parts);
  int second = 0;
  for (const int part : of_triangle) second += part;
  EXPECT_EQ(second, mesh.face_count() - 2);
}

}  // namespace
}  // namespace foldless::test
