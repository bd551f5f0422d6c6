// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/triangle_search.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/generate.h"
#include "core/mesh/orientation.h"

namespace foldless {
namespace {

TEST(TriangleSearch, FindsTheTriangleThatHoldsAPointAmongSlivers) {
  Shape shape = grid({.columns = 60, .rows = 60, .diagonal = Diagonal::alternating});
  // The lines of all sides pass near by all points.
  shape.rest.row(0) += 3 * shape.rest.row(1);
  shape.rest.row(1) *= 1e-3;
  const MeshPair mesh(shape.triangles, shape.rest, shape.rest);
  TriangleSearch search(mesh);
  std::mt19937_64 random(1);
  const auto any = [&](int count) { return static_cast<int>(random() % count); };
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3i inside = mesh.triangles().col(any(mesh.face_count()));
    const Vec2 p = mesh.rest()(Eigen::all, inside).rowwise().mean();
    const Eigen::Vector3i t = mesh.triangles().col(search.triangle_of(p, any(mesh.face_count())));
    EXPECT_EQ(t, inside) << i;
  }
}

}  // namespace
}  // namespace foldless
