// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/vertex_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/threads/team.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// By range, which triangles its runs have.
std::vector<bool> taken(const VertexRange& range, Eigen::Index triangles) {
  std::vector<bool> is_taken(static_cast<std::size_t>(triangles));
  for (const auto& [begin, end] : range.runs)
    for (int t = begin; t < end; ++t) is_taken[static_cast<std::size_t>(t)] = true;
  return is_taken;
}

TEST(VertexRanges, HaveEveryVertexOnceAndAllTrianglesAtIt) {
  Team team(2);
  for (const int cells : {20, 70, 120}) {  // of the last there are more than one part of triangles
    SCOPED_TRACE(cells);
    const test::Fixture shape = test::square_grid(cells);
    const auto vertices = static_cast<std::size_t>(shape.rest.cols());
    const std::vector<VertexRange> alone = compact_ranges(shape.triangles, vertices, 8);
    const WithTeam with(&team);
    const std::vector<VertexRange> ranges = compact_ranges(shape.triangles, vertices, 8);
    ASSERT_GT(ranges.size(), 1u);
    ASSERT_EQ(alone.size(), ranges.size());
    int next = 0;
    for (const VertexRange& range : ranges) {
      EXPECT_EQ(range.begin, next);
      next = range.end;
      EXPECT_TRUE(range.owns(range.begin) && range.owns(range.end - 1) && !range.owns(range.end));
      for (std::size_t i = 1; i < range.runs.size(); ++i)
        EXPECT_GT(range.runs[i].begin, range.runs[i - 1].end);
      const std::vector<bool> is_taken = taken(range, shape.triangles.cols());
      for (Eigen::Index t = 0; t < shape.triangles.cols(); ++t) {
        const auto corners = shape.triangles.col(t);
        const bool touches = std::ranges::any_of(corners, [&](int v) { return range.owns(v); });
        ASSERT_EQ(is_taken[static_cast<std::size_t>(t)], touches) << t;
      }
    }
    EXPECT_EQ(next, static_cast<int>(vertices));
  }
}

TEST(VertexRanges, AreNoneWhereTrianglesAreInNoOrder) {
  test::Fixture shape = test::square_grid(60);
  std::vector<int> order;  // a step that has no factor in common with their number
  for (Eigen::Index t = 0; t < shape.triangles.cols(); ++t)
    order.push_back(static_cast<int>(t * 1009 % shape.triangles.cols()));
  const Triangles scattered = shape.triangles(Eigen::all, order);
  const auto vertices = static_cast<std::size_t>(shape.rest.cols());
  EXPECT_FALSE(compact_ranges(shape.triangles, vertices, 8).empty());
  EXPECT_TRUE(compact_ranges(scattered, vertices, 8).empty());
}

}  // namespace
}  // namespace foldless
