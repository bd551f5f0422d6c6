// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/coarsen.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "tests/support/mesh_measures.h"
#include "tests/support/meshes.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

MeshPair mesh_of(const Shape& shape) { return {shape.triangles, shape.rest}; }

Shape rest_of(const MeshPair& mesh) { return {mesh.triangles(), mesh.rest()}; }

MeshPair square_mesh(int cells) {
  return mesh_of(grid({.columns = cells, .rows = cells, .diagonal = Diagonal::alternating}));
}

bool has(const CoarseMesh& coarse, int vertex) {
  return std::ranges::binary_search(coarse.vertices, vertex);
}

/// What every coarse mesh keeps of its fine one.
void expect_same_domain(const CoarseMesh& coarse, const MeshPair& fine,
                        const std::vector<int>& kept) {
  const MeshPair& mesh = coarse.mesh;
  ASSERT_EQ(mesh.vertex_count(), static_cast<int>(coarse.vertices.size()));
  EXPECT_TRUE(std::ranges::is_sorted(coarse.vertices));
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const int v = coarse.vertices[static_cast<std::size_t>(i)];
    EXPECT_EQ(Vec2(mesh.rest().col(i)), Vec2(fine.rest().col(v)));
    EXPECT_EQ(Vec2(mesh.deformed().col(i)), Vec2(fine.deformed().col(v)));
    EXPECT_EQ(mesh.is_isolated(i), fine.is_isolated(v));
    EXPECT_EQ(mesh.is_boundary_vertex(i), fine.is_boundary_vertex(v));
  }
  for (int v = 0; v < fine.vertex_count(); ++v) {
    if (fine.is_boundary_vertex(v) || fine.is_isolated(v)) {
      EXPECT_TRUE(has(coarse, v)) << v;
    }
  }
  for (const int v : kept) EXPECT_TRUE(has(coarse, v)) << v;
  EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest()));
  const double area = test::area_of(rest_of(fine));
  EXPECT_NEAR(test::area_of(rest_of(mesh)), area, 1e-12 * area);
  EXPECT_EQ(test::euler_characteristic(rest_of(mesh)), test::euler_characteristic(rest_of(fine)));
}

TEST(Coarsened, HasAsManyVerticesAsAskedFor) {
  const MeshPair fine = square_mesh(40);
  for (const int goal : {900, 400, 300}) {
    SCOPED_TRACE(goal);
    const CoarseMesh coarse = coarsened(fine, {840}, goal);
    expect_same_domain(coarse, fine, {840});
    EXPECT_EQ(coarse.mesh.vertex_count(), goal);
  }
}

TEST(Coarsened, TrianglesStayRoundAndGrowWithTheDistanceFromTheBoundary) {
  const Shape shape = disk({.rings = 30, .boundary_vertices = 180, .vertices = 2900});
  const CoarseMesh coarse = coarsened(mesh_of(shape), {}, 500);
  EXPECT_LE(coarse.mesh.vertex_count(), 520);
  EXPECT_GT(test::min_angle(rest_of(coarse.mesh)), 10);
  double largest_at_boundary = 0, largest = 0;
  for (const auto& t : coarse.mesh.triangles().colwise()) {
    const double area = signed_area(coarse.mesh.rest(), t);
    largest = std::max(largest, area);
    const auto at_boundary = [&](int v) { return coarse.mesh.is_boundary_vertex(v); };
    if (std::ranges::count_if(t, at_boundary) == 2)
      largest_at_boundary = std::max(largest_at_boundary, area);
  }
  EXPECT_GT(largest, 3 * largest_at_boundary);
}

TEST(Coarsened, AGoalThatIsMetTakesNothing) {
  const MeshPair fine = square_mesh(6);
  EXPECT_EQ(coarsened(fine, {}, 49).mesh.triangles(), fine.triangles());
}

TEST(Coarsened, StopsWhereNothingMayGo) {
  const MeshPair fine = square_mesh(6);
  std::vector<int> all;
  for (int v = 0; v < fine.vertex_count(); ++v) all.push_back(v);
  EXPECT_EQ(coarsened(fine, all, 0).mesh.triangles(), fine.triangles());

  const auto hexagon = test::hexagon();
  const MeshPair small(hexagon.triangles, hexagon.rest);
  EXPECT_EQ(coarsened(small, {0}, 0).mesh.vertex_count(), 7);
  EXPECT_EQ(coarsened(small, {}, 0).mesh.vertex_count(), 6) << "only the middle may go";
}

TEST(Coarsened, NoCollapseMakesANeedle) {
  // Every vertex is in a strip of the height of one cell: nothing else would be left.
  Points rest = square_mesh(10).rest();
  rest.row(1) *= 0.01;
  const MeshPair fine(square_mesh(10).triangles(), rest);
  EXPECT_EQ(coarsened(fine, {}, 0).mesh.vertex_count(), fine.vertex_count());
}

TEST(Coarsened, VerticesThatNoTriangleUsesStay) {
  const MeshPair square = square_mesh(8);
  Points rest(2, 82);
  rest << square.rest(), Vec2(5, 5);
  const MeshPair fine(square.triangles(), rest);
  const CoarseMesh coarse = coarsened(fine, {}, 50);
  expect_same_domain(coarse, fine, {81});
}

TEST(Coarsened, RandomMeshesKeepTheirDomainAndWhatIsToBeKept) {
  int gone = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair fine = mesh_of(test::random_shape(random));
    std::vector<int> kept;
    for (int k = 0; k < 5; ++k)
      kept.push_back(static_cast<int>(random() % static_cast<unsigned>(fine.vertex_count())));
    const int goal = fine.vertex_count() / (1 + static_cast<int>(random() % 4));
    const CoarseMesh coarse = coarsened(fine, kept, goal);
    expect_same_domain(coarse, fine, kept);
    EXPECT_GE(coarse.mesh.vertex_count(), goal);
    gone += fine.vertex_count() - coarse.mesh.vertex_count();
  }
  EXPECT_GT(gone, 100 * 10) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
