// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/files/mesh_readers.h"
#include "tests/support/errors.h"

namespace foldless {
namespace {

using test::error_of;

std::string error_in_obj(std::string_view text) {
  return error_of([&] { read_obj(text, "a.obj"); });
}

void expect_unit_triangle(const PolygonSoup& soup) {
  ASSERT_EQ(soup.vertices.size(), 3u);
  EXPECT_EQ(soup.vertices[1], (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(soup.vertices[2], (std::array<double, 3>{0.1, 1e-3, 0}));
  ASSERT_EQ(soup.face_count(), 1);
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
}

TEST(ObjReader, TakesEveryKindOfFace) {
  for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1/1/1 2/2/2 3/3/3",
                           "f -3 -2 -1", "f -3/-3 2 -1//-1", "f\t1  2\t3  "})
    expect_unit_triangle(read_obj(
        std::string("v 0 0 0\nv 1 0 0\nv .1 +1e-3 0\nvt 0 0\nvn 0 0 1\n") + face, "a.obj"));
}

TEST(ObjReader, TakesCommentsCrLfAndContinuedLines) {
  expect_unit_triangle(
      read_obj("# v 9 9 9\r\nv 0 0 0 # first\r\nv 1 \\\r\n0 0\r\n\r\n"
               "v 0.1 0.001 0\r\nf 1 2 \\\r\n  3 # face\r\n",
               "a.obj"));
}

TEST(ObjReader, SkipsExtraElementsColoursAndWeights) {
  expect_unit_triangle(
      read_obj("mtllib a.mtl\no shape\ng part\nv 0 0 0 1\nv 1 0 0 .2 .3 .4\n"
               "v 0.1 0.001\ns off\nusemtl red\nl 1 2\np 1\nvp 1 2\nf 1 2 3\n"
               "something else\n",
               "a.obj"));
}

TEST(ObjReader, CountsBackFromTheVerticesSoFar) {
  const PolygonSoup soup =
      read_obj("v 0 0\nv 1 0\nv 0 1\nf -3 -2 -1\nv 1 1\nv 2 2\nf -4 -2 -3\n", "a.obj");
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 1, 3, 2}));
}

TEST(ObjReader, KeepsDoublesExactly) {
  const PolygonSoup soup = read_obj("v 0.30000000000000004 123456789.123456789 0\n", "a.obj");
  EXPECT_EQ(soup.vertices[0], (std::array<double, 3>{0.1 + 0.2, 123456789.123456789, 0}));
}

TEST(ObjReader, KnowsTheLinesOfVerticesAndFaces) {
  const PolygonSoup soup = read_obj("\nv 0 0\n#\nv 1 \\\n0\nv 0 1\n\nf 1 2 3", "a.obj");
  EXPECT_EQ(soup.source.vertex_lines, (std::vector<int>{2, 4, 6}));
  EXPECT_EQ(soup.source.face_lines, (std::vector<int>{8}));
  EXPECT_EQ(soup.source.at_face(0), "a.obj:8: face 1");
}

TEST(ObjReader, NamesTheFirstUnreadableNumberAndTheCount) {
  EXPECT_EQ(error_in_obj("v 0 0 0\nv 1,5 0 0\nv x y z\n"),
            "a.obj:2: vertex 2 has the coordinate '1,5', which is not a number (2 vertices in "
            "all); a vertex needs two or three numbers: v x y z");
  EXPECT_EQ(error_in_obj("v 3\n"),
            "a.obj:1: vertex 1 has only 1 coordinate (1 vertex in all); a vertex needs two or "
            "three numbers: v x y z");
}

TEST(ObjReader, NamesUnreadableCorners) {
  const std::string error = error_in_obj("v 0 0\nf 1 b 1\nf /1 1 1\n");
  EXPECT_TRUE(
      error.starts_with("a.obj:2: face 1 has the corner 'b', which is not a vertex number "
                        "(2 corners in all)"))
      << error;
}

TEST(ObjReader, NamesFacesWithTooFewCorners) {
  const std::string error = error_in_obj("v 0 0\nf 1 1\nf\n");
  EXPECT_TRUE(error.starts_with("a.obj:2: face 1 has 2 corners (2 faces in all)")) << error;
}

TEST(ObjReader, NamesReferencesBeyondTheBeginning) {
  const std::string error = error_in_obj("v 0 0\nv 1 0\nf -1 -2 -3\n");
  EXPECT_TRUE(
      error.starts_with("a.obj:3: face 1 names vertex -3 from the back, but only 2 "
                        "vertices went before (1 corner in all)"))
      << error;
}

}  // namespace
}  // namespace foldless
