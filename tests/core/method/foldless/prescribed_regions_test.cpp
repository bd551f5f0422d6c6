// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/prescribed_regions.h"

#include <gtest/gtest.h>

#include "core/mesh/generate.h"
#include "core/mesh/winding.h"

namespace foldless {
namespace {

MeshPair mesh_of(const Shape& shape) { return {shape.triangles, shape.rest}; }

/// Every vertex of the mesh a handle where it is.
std::vector<Handle> all_held(const MeshPair& mesh) {
  std::vector<Handle> handles;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    handles.push_back({.id = v, .vertex = v, .target = mesh.rest().col(v)});
  return handles;
}

TEST(PrescribedRegions, KnowTheirLoopsWithTheRegionOnTheLeftAndTheirTopology) {
  const AnnulusOptions options{.sectors = 12, .layers = 3};
  const MeshPair mesh = mesh_of(annulus(options));
  const Constraints constraints = constraints_of(all_held(mesh));
  const std::vector<PrescribedRegion> regions = prescribed_regions(mesh, constraints);
  ASSERT_EQ(regions.size(), 1U);
  ASSERT_EQ(regions[0].loops.size(), 2U);
  EXPECT_EQ(regions[0].inside.size(), 24U);
  EXPECT_EQ(regions[0].euler_characteristic, 0);
  // Vertices go from inside outwards, so the first loop is that of the hole.
  EXPECT_EQ(turning_number(constraints.targets(Eigen::all, regions[0].loops[0])), -1);
  EXPECT_EQ(turning_number(constraints.targets(Eigen::all, regions[0].loops[1])), 1);
  EXPECT_EQ(boundary_vertices(regions, constraints).size(), 24U);
}

TEST(PrescribedRegions, NeedEveryBoundaryVertexAndNoSoftHandle) {
  const MeshPair mesh = mesh_of(grid({.columns = 4, .rows = 4}));
  const std::vector<Handle> handles = all_held(mesh);
  EXPECT_EQ(prescribed_regions(mesh, constraints_of(handles)).size(), 1U);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const std::size_t expected = mesh.is_boundary_vertex(v) ? 0 : 1;
    std::vector<Handle> fewer = handles, softer = handles;
    fewer.erase(fewer.begin() + v);
    softer[static_cast<std::size_t>(v)].kind = HandleKind::soft;
    EXPECT_EQ(prescribed_regions(mesh, constraints_of(fewer)).size(), expected) << v;
    const std::vector<PrescribedRegion> regions = prescribed_regions(mesh, constraints_of(softer));
    ASSERT_EQ(regions.size(), expected) << v;
    EXPECT_TRUE(regions.empty() || regions[0].inside.size() == 8) << v;
  }
}

TEST(PrescribedRegions, AreComponentsByThemselves) {
  const Shape one = grid({.columns = 3, .rows = 2});
  const auto n = static_cast<int>(one.rest.cols());
  Shape two;
  two.triangles.resize(3, 2 * one.triangles.cols());
  two.triangles << one.triangles, one.triangles.array() + n;
  two.rest.resize(2, 2 * n);
  two.rest << one.rest, one.rest.colwise() + Vec2(5, 0);
  const MeshPair mesh = mesh_of(two);
  std::vector<Handle> handles = all_held(mesh);
  EXPECT_EQ(prescribed_regions(mesh, constraints_of(handles)).size(), 2U);
  handles.erase(handles.begin());
  const Constraints constraints = constraints_of(handles);
  const std::vector<PrescribedRegion> regions = prescribed_regions(mesh, constraints);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].euler_characteristic, 1);
  EXPECT_EQ(boundary_vertices(regions, constraints).front(), n);
}

}  // namespace
}  // namespace foldless
