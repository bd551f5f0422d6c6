// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/paint_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

/// Of a ribbon that crosses itself: whether the sheet with x > 0 lies in front, everywhere.
bool is_right_in_front(const Snapshot& snapshot, const std::vector<int>& layers) {
  const auto overlaps =
      overlapping_triangles(*snapshot.triangles, snapshot.deformed, CommonCorners::may_overlap);
  EXPECT_FALSE(overlaps.empty());
  const auto is_right = [&](int t) { return (*snapshot.rest)(0, (*snapshot.triangles)(0, t)) > 0; };
  std::vector<bool> in_front;
  for (const Overlap& o : overlaps) {
    if (o.is_contact) continue;
    const int a = layers[static_cast<std::size_t>(o.a)], b = layers[static_cast<std::size_t>(o.b)];
    EXPECT_NE(a, b);
    in_front.push_back(is_right(o.a) == (a > b));
  }
  EXPECT_EQ(std::ranges::count(in_front, in_front.front()), std::ssize(in_front)) << "as one";
  return in_front.front();
}

TEST(PaintOrder, TheSheetOfTheHandleWithTheGreaterDepthIsInFront) {
  Snapshot snapshot = crossing_ribbon();
  PaintOrder order;
  for (const double left : {1.0, -1.0, 3.0, 0.0}) {
    snapshot.handles[0].depth = left;
    snapshot.handles[1].depth = 0.5;
    EXPECT_EQ(is_right_in_front(snapshot, order.layers(snapshot, snapshot.deformed)), left < 0.5)
        << "the same mesh with other depths";
  }
}

TEST(PaintOrder, WithoutDepthsSheetsAreWholeAndTheRightOneIsInFront) {
  Snapshot snapshot = crossing_ribbon();
  EXPECT_TRUE(is_right_in_front(snapshot, PaintOrder().layers(snapshot, snapshot.deformed)));
  snapshot.handles.clear();
  EXPECT_TRUE(is_right_in_front(snapshot, PaintOrder().layers(snapshot, snapshot.deformed)));
}

TEST(PaintOrder, HandlesWithOneDepthSayAsLittleAsHandlesWithout) {
  Snapshot snapshot = crossing_ribbon();
  for (Handle& handle : snapshot.handles) handle.depth = -4;
  EXPECT_TRUE(is_right_in_front(snapshot, PaintOrder().layers(snapshot, snapshot.deformed)));
}

TEST(PaintOrder, FollowsTheSheetsWhileTheyMove) {
  const Snapshot crossed = crossing_ribbon();
  Snapshot moving = crossed;
  PaintOrder order;
  for (const double amount : {0.0, 0.5, 1.0, 0.3, 0.9}) {
    moving.deformed = amount * crossed.deformed + (1 - amount) * *crossed.rest;
    EXPECT_EQ(order.layers(moving, moving.deformed), PaintOrder().layers(moving, moving.deformed))
        << "as one that begins with this mesh";
  }
  EXPECT_EQ(*std::ranges::max_element(order.layers(crossed, crossed.deformed)), 1);
  EXPECT_EQ(*std::ranges::max_element(order.layers(crossed, *crossed.rest)), 0);
}

TEST(PaintOrder, LimbsAreInFrontOfTheMiddle) {
  for (const auto& [from, to] : {std::pair{-1.6, 3.0}, std::pair{-3.0, 1.6}}) {
    const Fixture f = ribbon(60, from, to, 0.15);
    const Snapshot snapshot = posed(f, along(f.rest, loop));
    const bool is_right_far = from < -2;
    EXPECT_EQ(is_right_in_front(snapshot, PaintOrder().layers(snapshot, snapshot.deformed)),
              is_right_far);
  }
}

TEST(PaintOrder, ALaterComponentLiesOnAnEarlierOne) {
  const Fixture bar = ribbon(10, -1, 1, 0.2);
  const Fixture f = both(bar, bar);
  Snapshot snapshot = posed(f, f.rest);
  for (Eigen::Index v = bar.rest.cols(); v < f.rest.cols(); ++v)
    snapshot.deformed.col(v) = Vec2(-f.rest(1, v), f.rest(0, v));
  const std::vector<int> layers = PaintOrder().layers(snapshot, snapshot.deformed);
  const auto half = static_cast<std::ptrdiff_t>(bar.triangles.cols());
  EXPECT_EQ(*std::max_element(layers.begin(), layers.begin() + half), 0);
  EXPECT_EQ(*std::max_element(layers.begin() + half, layers.end()), 1);
  snapshot.handles.push_back({.id = 0, .vertex = 0, .depth = 0.1});
  const std::vector<int> lifted = PaintOrder().layers(snapshot, snapshot.deformed);
  EXPECT_EQ(*std::max_element(lifted.begin(), lifted.begin() + half), 1) << "depth goes first";
}

TEST(PaintOrder, AComponentInsideAnotherLiesOnIt) {
  Fixture small = square_grid(3);
  small.rest *= 0.2;
  small.rest.array() += 1.1;
  const Fixture f = both(square_grid(4), small);
  const Snapshot snapshot = posed(f, f.rest);
  const std::vector<int> layers = PaintOrder().layers(snapshot, snapshot.deformed);
  EXPECT_EQ(*std::max_element(layers.begin(), layers.begin() + 18), 0);
  EXPECT_EQ(*std::min_element(layers.begin() + 18, layers.end()), 1);
}

/// Two parts of which the second is the same mesh again, or a copy beside it.
std::pair<Snapshot, std::shared_ptr<const MeshParts>> two_parts(const Vec2& shift) {
  const Fixture one = square_grid(5);
  Fixture other = one;
  other.rest.colwise() += shift;
  const Fixture f = both(one, other);
  const int vertices = static_cast<int>(one.rest.cols());
  return {posed(f, f.rest), std::make_shared<const MeshParts>(
                                MeshParts{{"A", 0, vertices, 0}, {"B", vertices, vertices, 1}})};
}

/// 1: the later part lies on the earlier one wherever they overlap, -1: the other way round.
int front_of(const Snapshot& snapshot, const std::vector<int>& layers) {
  const int half = static_cast<int>(layers.size()) / 2;
  int later = 0, pairs = 0;
  for (const Overlap& o :
       overlapping_triangles(*snapshot.triangles, *snapshot.rest, CommonCorners::apart)) {
    if (o.is_contact || o.a >= half || o.b < half) continue;
    ++pairs;
    const int difference =
        layers[static_cast<std::size_t>(o.b)] - layers[static_cast<std::size_t>(o.a)];
    later += difference > 0 ? 1 : difference < 0 ? -1 : 0;
  }
  EXPECT_GT(pairs, 0);
  return std::abs(later) == pairs ? later / pairs : 0;
}

TEST(PaintOrder, PartsLieOverEachOtherByTheirDepths) {
  // Somewhere over each other, with edges in common, and all over each other.
  for (const Vec2& shift : {Vec2(0.3, 0.2), Vec2(1, 0), Vec2(0, 0)}) {
    auto [snapshot, parts] = two_parts(shift);
    PaintOrder order;
    order.set_parts(parts);
    EXPECT_EQ(front_of(snapshot, order.layers(snapshot, *snapshot.rest)), 1) << shift.transpose();
    MeshParts swapped = *parts;
    swapped[0].depth = 2;
    order.set_parts(std::make_shared<const MeshParts>(swapped));
    EXPECT_EQ(front_of(snapshot, order.layers(snapshot, *snapshot.rest)), -1) << shift.transpose();
  }
}

TEST(PaintOrder, DepthsOfHandlesCountFromThatOfTheirPart) {
  auto [snapshot, parts] = two_parts(Vec2(0.3, 0.2));
  PaintOrder order;
  order.set_parts(parts);
  for (const auto& [depth, front] : {std::pair{0.5, 1}, std::pair{1.5, -1}, std::pair{-3.0, 1}}) {
    snapshot.handles = {{.id = 0, .vertex = 0, .depth = depth}};
    EXPECT_EQ(front_of(snapshot, order.layers(snapshot, *snapshot.rest)), front) << depth;
  }
}

TEST(PaintOrder, PartsWhoseDepthsMixAreComparedWhereTheyOverlap) {
  const Fixture one = ribbon(20, -2, 2, 0.2);
  const Fixture f = both(one, one);
  const int vertices = static_cast<int>(one.rest.cols());
  Snapshot snapshot = posed(f, f.rest);
  // The second lies across the first at its left end, where that is behind, or at its right end.
  for (const double place : {-1.5, 1.5}) {
    for (int v = vertices; v < 2 * vertices; ++v)
      snapshot.deformed.col(v) = Vec2(place - f.rest(1, v), f.rest(0, v));
    const auto vertex_near = [&](double x) {
      Eigen::Index nearest = 0;
      (f.rest.leftCols(vertices).colwise() - Vec2(x, 0)).colwise().norm().minCoeff(&nearest);
      return static_cast<int>(nearest);
    };
    snapshot.handles = {{.id = 0, .vertex = vertex_near(-2), .depth = -4},
                        {.id = 1, .vertex = vertex_near(2), .depth = 6}};
    PaintOrder order;
    order.set_parts(std::make_shared<const MeshParts>(
        MeshParts{{"A", 0, vertices, 0}, {"B", vertices, vertices, 1}}));
    const std::vector<int>& layers = order.layers(snapshot, snapshot.deformed);
    const auto half = static_cast<std::ptrdiff_t>(one.triangles.cols());
    const int first = *std::max_element(layers.begin(), layers.begin() + half);
    const int second = *std::max_element(layers.begin() + half, layers.end());
    EXPECT_EQ(first > second, place > 0) << place;
  }
}

TEST(PaintOrder, AMapThatFoldsHasNoSheets) {
  Snapshot snapshot = crossing_ribbon();
  PaintOrder order;
  ASSERT_EQ(*std::ranges::max_element(order.layers(snapshot, snapshot.deformed)), 1);
  snapshot.folded_triangles = 1;
  snapshot.deformed *= 2;
  EXPECT_EQ(*std::ranges::max_element(order.layers(snapshot, snapshot.deformed)), 0);
}

}  // namespace
}  // namespace foldless::test
