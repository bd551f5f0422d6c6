// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/judge/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace judge {
namespace {

using Sentences = std::vector<std::string>;

/// A centre, vertex 0, and `count` triangles round it that turn by `angle` in all.
Mesh fan(int count, double angle, bool is_closed) {
  Mesh mesh{{{0, 0}}, {}};
  const int spokes = is_closed ? count : count + 1;
  for (int i = 0; i < spokes; ++i)
    mesh.points.push_back({std::cos(angle * i / count), std::sin(angle * i / count)});
  for (int i = 0; i < count; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % spokes});
  return mesh;
}

constexpr double kTurn = 2 * std::numbers::pi;

TEST(Judge, AcceptsTrianglesThatGoRoundAVertexOnce) {
  EXPECT_EQ(objections_to(fan(5, kTurn, true)), Sentences{});
}

TEST(Judge, SeesAVertexThatIsGoneRoundTwice) {
  EXPECT_EQ(objections_to(fan(9, 2 * kTurn, true)), Sentences{"vertex 0 is gone round 2 times"});
}

TEST(Judge, SeesABoundaryVertexThatOverlapsItself) {
  const Sentences reached{"the angles at boundary vertex 0 reach 2π"};
  EXPECT_EQ(objections_to(fan(7, 0.999 * kTurn, false)), Sentences{});
  EXPECT_EQ(objections_to(fan(7, 1.001 * kTurn, false)), reached);
  EXPECT_EQ(objections_to(fan(9, 1.6 * kTurn, false)), reached);
  EXPECT_EQ(objections_to(fan(19, 2.7 * kTurn, false)), reached);
}

TEST(Judge, SeesAnglesThatAddUpToTwoPiExactly) {
  Mesh slit{{{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {2, 0}},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
  EXPECT_EQ(objections_to(slit), Sentences{"the angles at boundary vertex 0 reach 2π"});
  slit.points[5][1] = -std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(objections_to(slit), Sentences{});
}

TEST(Judge, DecidesAreasExactly) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  Mesh mesh{{{0, 0}, {1e300, 1e300}, {0.5, 0.5}}, {{0, 1, 2}}};
  EXPECT_EQ(objections_to(mesh), Sentences{"triangle 0 has no area"});
  mesh.points[0] = {0, -tiny};
  EXPECT_EQ(objections_to(mesh), Sentences{});
  mesh.points[0] = {0, tiny};
  EXPECT_EQ(objections_to(mesh), Sentences{"triangle 0 is clockwise"});
}

TEST(Judge, DecidesNextToADiagonalWhereDoublesAreWrong) {
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const Mesh mesh{{{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, {12, 12}, {24, 24}}, {{0, 1, 2}}};
      EXPECT_EQ(objections_to(mesh), i < j    ? Sentences{}
                                     : i == j ? Sentences{"triangle 0 has no area"}
                                              : Sentences{"triangle 0 is clockwise"});
    }
}

TEST(Judge, SeesWhatIsNoMesh) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0.5}};
  const auto first = [&](std::vector<Triangle> triangles) {
    const Sentences all = objections_to({square, std::move(triangles)});
    return all.empty() ? "" : all.front();
  };
  EXPECT_EQ(first({{0, 1, 5}}), "triangle 0 names vertex 5, which is not there");
  EXPECT_EQ(first({{0, 1, 2}, {0, 1, 3}}), "triangle 1 is the second on one side of the edge 0 1");
  EXPECT_EQ(first({{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}), "");
  const std::vector<Point> bow{{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  EXPECT_EQ(objections_to({bow, {{0, 1, 2}, {0, 3, 4}}}),
            Sentences{"the triangles of vertex 0 are no one fan"});
  EXPECT_EQ(objections_to({{{0, 0}, {1, 0}, {0, std::nan("")}}, {{0, 1, 2}}}),
            Sentences{"vertex 2 is not finite"});
}

TEST(Judge, ReadsTrianglesOfAnObjFile) {
  std::istringstream text("# a comment\nv 0 0 0\nv 1e-3 0 0\nvt 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n");
  const Mesh mesh = read_obj(text);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0}, {1e-3, 0}, {0, 1}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  std::istringstream smallest("v 5e-324 -1.5\r\n");
  EXPECT_EQ(read_obj(smallest).points, (std::vector<Point>{{5e-324, -1.5}}));
  std::istringstream word("v 0 none\n");
  EXPECT_THROW(read_obj(word), std::runtime_error);
  std::istringstream quad("v 0 0\nv 1 0\nv 1 1\nv 0 1\nf 1 2 3 4\n");
  EXPECT_THROW(read_obj(quad), std::runtime_error);
}

}  // namespace
}  // namespace judge
