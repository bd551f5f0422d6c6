// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/error.h"
#include "tests/support/mesh_measures.h"

namespace foldless {
namespace {

using test::area_of;
using test::euler_characteristic;
using test::max_edge_length;
using test::min_angle;

Loop box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double polygon_area(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// A random polygon that is star-shaped about the origin, without sharp spikes.
Loop random_star(std::mt19937& random, int corners) {
  std::uniform_real_distribution<double> radius(0.7, 1.3);
  Loop loop;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners, r = radius(random);
    loop.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return loop;
}

std::string message_of(const Outline& outline, const TriangulateOptions& options = {}) {
  try {
    triangulate(outline, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Triangulate, KeepsTheBoundsOnAnglesAndEdges) {
  const Shape shape = triangulate({box(0, 0, 3, 1), {}}, {.edge_length = 0.2, .min_angle = 25});
  EXPECT_GE(min_angle(shape), 25);
  EXPECT_LE(max_edge_length(shape), 0.2 + 1e-12);
  EXPECT_NEAR(area_of(shape), 3, 1e-12);
  EXPECT_EQ(euler_characteristic(shape), 1);
}

TEST(Triangulate, LeavesHolesOut) {
  const Outline outline{box(0, 0, 4, 2), {box(0.5, 0.5, 1.5, 1.5), box(2.5, 0.5, 3.5, 1.5)}};
  const Shape shape = triangulate(outline, {.edge_length = 0.3});
  EXPECT_NEAR(area_of(shape), 6, 1e-12);
  EXPECT_EQ(euler_characteristic(shape), -1);
  EXPECT_GE(min_angle(shape), 20.7);
}

TEST(Triangulate, CornersComeFirstAndStayWhereTheyAre) {
  const Outline outline{box(0, 0, 4, 2), {box(1, 0.5, 2, 1.5)}};
  const Shape shape = triangulate(outline, {.edge_length = 0.5});
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(shape.rest.col(i), outline.boundary[i]);
    EXPECT_EQ(shape.rest.col(4 + i), outline.holes[0][i]);
  }
}

TEST(Triangulate, ClockwiseOutlinesMeanTheSame) {
  Outline outline{box(0, 0, 4, 2), {box(1, 0.5, 2, 1.5)}};
  const double area = area_of(triangulate(outline, {}));
  std::reverse(outline.boundary.begin(), outline.boundary.end());
  EXPECT_NEAR(area_of(triangulate(outline, {})), area, 1e-12);
}

TEST(Triangulate, RandomStarsAreFilledExactly) {
  const unsigned seed = 20240517;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 40; ++trial) {
    const Loop loop = random_star(random, 8 + 3 * trial);
    const Shape shape = triangulate({loop, {}}, {.edge_length = 0.3});
    EXPECT_GT(min_angle(shape), 0);
    EXPECT_EQ(euler_characteristic(shape), 1);
    EXPECT_NEAR(area_of(shape), polygon_area(loop), 1e-12);
  }
}

TEST(Triangulate, TheSameInputGivesTheSameMesh) {
  std::mt19937 random(7);
  const Outline outline{random_star(random, 60), {}};
  const Shape a = triangulate(outline, {.edge_length = 0.1});
  const Shape b = triangulate(outline, {.edge_length = 0.1});
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.rest, b.rest);
}

TEST(Triangulate, RefusesLoopsThatCrossOrTouch) {
  EXPECT_NE(message_of({{{0, 0}, {2, 2}, {2, 0}, {0, 2.5}}, {}}).find("crosses"),
            std::string::npos);
  EXPECT_NE(message_of({{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}, {}}).find("touches"),
            std::string::npos);
  EXPECT_NE(message_of({{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {-1, 1}}, {}}).find("twice"),
            std::string::npos);
  EXPECT_NE(message_of({box(0, 0, 2, 2), {box(1, 1, 3, 3)}}).find("crosses"), std::string::npos);
}

TEST(Triangulate, RefusesHolesThatAreNotInsideTheBoundaryAlone) {
  EXPECT_NE(message_of({box(0, 0, 1, 1), {box(2, 2, 3, 3)}}).find("inside"), std::string::npos);
  EXPECT_NE(message_of({box(0, 0, 9, 9), {box(1, 1, 8, 8), box(2, 2, 3, 3)}}).find("inside"),
            std::string::npos);
}

TEST(Triangulate, RefusesOutlinesWithoutAnInside) {
  EXPECT_NE(message_of({{{0, 0}, {1, 0}}, {}}).find("fewer than 3"), std::string::npos);
  EXPECT_NE(message_of({{{0, 0}, {1, 0}, {2, 0}}, {}}).find("no area"), std::string::npos);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of({{{0, 0}, {1, nan}, {2, 0}}, {}}).find("finite"), std::string::npos);
}

TEST(Triangulate, RefusesOptionsOutOfRange) {
  const Outline outline{box(0, 0, 1, 1), {}};
  EXPECT_NE(message_of(outline, {.edge_length = -1}), "");
  EXPECT_NE(message_of(outline, {.min_angle = 40}), "");
  EXPECT_NE(message_of(outline, {.edge_length = 0.01, .vertex_limit = 100}).find("100 vertices"),
            std::string::npos);
}

}  // namespace
}  // namespace foldless
