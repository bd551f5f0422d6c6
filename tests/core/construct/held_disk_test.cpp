// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/held_disk.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/generate.h"
#include "tests/support/glued_polygon.h"
#include "tests/support/sanitizers.h"
#include "tests/support/spiral.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

MeshPair as_mesh(const Shape& shape) { return {shape.triangles, shape.rest}; }

/// The boundary of a disk, its triangles on the left, in a mesh whose components before `first`
/// are others.
std::vector<int> loop_of(const MeshPair& mesh, int first = 0) {
  while (!mesh.is_boundary_vertex(first)) ++first;
  return boundary_loop(boundary_neighbours(mesh.triangles(), mesh.vertex_count()), first);
}

/// Meshes at rest: a disk, a grid with straight sides, a strip that lies over itself.
MeshPair mesh_of(std::uint64_t seed) {
  if (seed % 3 == 0)
    return as_mesh(disk({.rings = 5, .boundary_vertices = 24, .vertices = 76, .radius = 1}));
  if (seed % 3 == 1)
    return as_mesh(grid({.columns = 7, .rows = 6, .diagonal = Diagonal::alternating}));
  return as_mesh(test::wound_strip(24, 2, 1.3));
}

void expect_held(const MeshPair& mesh, const std::vector<int>& loop, const MeshPair& before,
                 const Points& targets) {
  EXPECT_TRUE(test::is_valid(mesh));
  EXPECT_EQ(mesh.rest().leftCols(before.vertex_count()), before.rest());
  EXPECT_EQ(Points(mesh.deformed()(Eigen::all, loop)), targets);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto side = mesh.find_edge(loop[i], loop[(i + 1) % loop.size()]);
    EXPECT_TRUE(side && mesh.is_boundary_edge(*side));
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_FALSE(mesh.is_isolated(v)) << v;
}

TEST(HeldDisk, GoesToAnyPolygonThatBoundsADisk) {
  for (std::uint64_t seed = 1; seed <= test::seeds(300); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair before = mesh_of(seed);
    const std::vector<int> loop = loop_of(before);
    const Points targets = test::glued_polygon(random, static_cast<int>(loop.size()));
    const auto mesh = with_held_disk(before, loop, targets);
    ASSERT_TRUE(mesh);
    expect_held(*mesh, loop, before, targets);
  }
}

TEST(HeldDisk, KeepsTheRestOfADiskThatStaysAndItsRestTrianglesAreDelaunayWithinChords) {
  const MeshPair before = mesh_of(0);
  const std::vector<int> loop = loop_of(before);
  const auto mesh = with_held_disk(before, loop, before.rest()(Eigen::all, loop));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->vertex_count(), before.vertex_count());
  EXPECT_LT((mesh->deformed() - before.rest()).lpNorm<Eigen::Infinity>(), 1e-5);
}

TEST(HeldDisk, LeavesOtherComponentsAlone) {
  const Shape one = disk({.rings = 3, .boundary_vertices = 14, .vertices = 30, .radius = 1});
  const int count = static_cast<int>(one.rest.cols());
  Triangles triangles(3, 2 * one.triangles.cols());
  triangles << one.triangles, one.triangles.array() + count;
  Points rest(2, 2 * count), deformed(2, 2 * count);
  rest << one.rest, one.rest;
  deformed << 0.5 * one.rest, one.rest;
  const MeshPair before(triangles, rest, deformed);
  const std::vector<int> loop = loop_of(before, count);
  std::mt19937_64 random(1);
  const Points targets = test::glued_polygon(random, static_cast<int>(loop.size()));
  const auto mesh = with_held_disk(before, loop, targets);
  ASSERT_TRUE(mesh);
  expect_held(*mesh, loop, before, targets);
  EXPECT_EQ(mesh->deformed().leftCols(count), deformed.leftCols(count));
  for (const auto& t : one.triangles.colwise()) {
    EXPECT_TRUE(mesh->find_edge(t[0], t[1]));
    EXPECT_TRUE(mesh->find_edge(t[1], t[2]));
  }
}

TEST(HeldDisk, IsNothingWhereTheTargetsBoundNoDisk) {
  const MeshPair before = mesh_of(0);
  const std::vector<int> loop = loop_of(before);
  const Points backwards = test::regular_polygon(static_cast<int>(loop.size())).rowwise().reverse();
  EXPECT_FALSE(with_held_disk(before, loop, backwards));
}

}  // namespace
}  // namespace foldless
