// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "core/mesh/boundary.h"
#include "core/mesh/generate.h"

namespace foldless {
namespace {

/// 11 × 11 vertices; vertex (column, row) has index 11 row + column.
const Shape& square() {
  static const Shape shape = grid({.columns = 10, .rows = 10});
  return shape;
}
int vertex(int column, int row) { return 11 * row + column; }

std::vector<bool> marked(const std::vector<int>& vertices) {
  std::vector<bool> marks(static_cast<std::size_t>(square().rest.cols()));
  for (const int v : vertices) marks[static_cast<std::size_t>(v)] = true;
  return marks;
}

/// The third vertex of the triangle (v, w, ·).
int after(int w, int v, const Triangles& triangles) {
  for (const auto& t : triangles.colwise())
    for (int c = 0; c < 3; ++c)
      if (t[c] == v && t[(c + 1) % 3] == w) return t[(c + 2) % 3];
  return -1;
}

TEST(Grow, AddsWhatSoManyEdgesReach) {
  std::vector<bool> marks = marked({vertex(5, 5)});
  grow(marks, square().triangles, 0);
  EXPECT_EQ(marks, marked({vertex(5, 5)}));
  grow(marks, square().triangles, 1);
  // Diagonals rise: of the eight neighbours two are no neighbours in the triangulation.
  EXPECT_EQ(marks, marked({vertex(4, 4), vertex(5, 4), vertex(4, 5), vertex(5, 5), vertex(6, 5),
                           vertex(5, 6), vertex(6, 6)}));
  grow(marks, square().triangles, 2);
  EXPECT_EQ(std::ranges::count(marks, true), 37) << "1 + 6 + 12 + 18: a hexagon";
}

TEST(Patches, HaveNoVertexThatIsFreeInTwo) {
  const std::vector<Patch> found =
      patches(square().triangles, marked({vertex(2, 2), vertex(3, 2), vertex(7, 7)}));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].triangles.cols(), 10) << "6 + 6, of which two are at both";
  EXPECT_EQ(found[1].triangles.cols(), 6);
  EXPECT_EQ(found[1].vertices.size(), 7U);
}

TEST(Patches, HaveAVertexThatStaysOnceForEveryFan) {
  // A chain of free vertices leads from one neighbour of (5, 5) round to the opposite one.
  const std::vector<Patch> found =
      patches(square().triangles, marked({vertex(4, 5), vertex(4, 6), vertex(5, 7), vertex(6, 7),
                                          vertex(7, 7), vertex(7, 6), vertex(6, 5)}));
  ASSERT_EQ(found.size(), 1U);
  const Patch& patch = found[0];
  EXPECT_EQ(std::ranges::count(patch.vertices, vertex(5, 5)), 2);
}

TEST(Patches, AreManifoldAndHoldAllTrianglesAtFreeVertices) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::vector<bool> is_free(static_cast<std::size_t>(square().rest.cols()));
    for (int row = 1; row < 10; ++row)
      for (int column = 1; column < 10; ++column)
        is_free[static_cast<std::size_t>(vertex(column, row))] = random() % 3 == 0;
    std::set<std::set<int>> expected, found;
    for (const auto& t : square().triangles.colwise())
      if (std::ranges::any_of(t, [&](int v) { return is_free[static_cast<std::size_t>(v)]; }))
        expected.insert({t[0], t[1], t[2]});
    for (const Patch& patch : patches(square().triangles, is_free)) {
      const auto neighbours =
          boundary_neighbours(patch.triangles, static_cast<int>(patch.vertices.size()));
      std::vector<int> corners(patch.vertices.size());
      for (const auto& t : patch.triangles.colwise()) {
        std::set<int> in_mesh;
        for (const int v : t) {
          in_mesh.insert(patch.vertices[static_cast<std::size_t>(v)]);
          ++corners[static_cast<std::size_t>(v)];
        }
        EXPECT_TRUE(found.insert(in_mesh).second) << "in one patch only";
      }
      for (std::size_t v = 0; v < patch.vertices.size(); ++v)
        if (is_free[static_cast<std::size_t>(patch.vertices[v])]) {
          EXPECT_FALSE(neighbours[v].are_there()) << "a free vertex is inside";
          EXPECT_EQ(corners[v], 6);
        } else {
          ASSERT_TRUE(neighbours[v].are_there() || corners[v] == 6);
          int steps = 0;  // from one end of the fan to the other
          for (int w = neighbours[v].next; w != neighbours[v].previous && steps < 7; ++steps)
            w = after(w, static_cast<int>(v), patch.triangles);
          if (neighbours[v].are_there()) {
            EXPECT_EQ(steps, corners[v]);
          }
        }
    }
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace foldless
