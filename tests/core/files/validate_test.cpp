// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/files/mesh_readers.h"
#include "core/files/mesh_text.h"
#include "core/files/twins.h"
#include "core/mesh/injective.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

using test::error_of;

TriangleSoup checked(std::string_view obj) {
  return validated(planar_triangles(read_obj(obj, "a.obj")));
}

std::string error_in_mesh(std::string_view obj) {
  return error_of([&] { checked(obj); });
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Validate, AcceptsAGoodMeshWithoutNotices) {
  const test::Fixture f = test::square_grid(5);
  const TriangleSoup mesh = checked(obj_text(f.triangles, f.rest));
  EXPECT_EQ(mesh.triangles, f.triangles);
  EXPECT_EQ(mesh.points, f.rest);
  EXPECT_TRUE(mesh.notices.empty());
}

TEST(Validate, AcceptsComponentsAndHoles) {
  EXPECT_EQ(error_in_mesh("v 0 0\nv 1 0\nv 0 1\nv 5 0\nv 6 0\nv 5 1\nf 1 2 3\nf 4 5 6\n"), "");
  EXPECT_EQ(error_in_mesh("v 0 0\nv 3 0\nv 0 3\nv .5 .5\nv 1 .5\nv .5 1\n"
                          "f 1 2 4\nf 2 5 4\nf 2 3 5\nf 3 6 5\nf 3 1 6\nf 1 4 6\n"),
            "");
}

TEST(Validate, RefusesCoordinatesThatAreNotFinite) {
  EXPECT_EQ(error_in_mesh("v 0 0\nv nan 0\nv 0 1e999\nf 1 2 3\n"),
            "a.obj:2: vertex 2 has the coordinate nan, which is not finite (2 vertices in all); "
            "every coordinate must be a finite number");
}

TEST(Validate, RefusesLengthsThatCannotBeSquaredTwice) {
  const auto triangle = [](const std::string& x) {
    return "v 0 0 0\nv " + x + " 0 0\nv 0 1 0\nf 1 2 3\n";
  };
  EXPECT_EQ(error_in_mesh(triangle("1e75")), "");
  EXPECT_NE(error_in_mesh(triangle("1e76")).find("a.obj:2: vertex 2 is farther from (0, 0)"),
            std::string::npos)
      << error_in_mesh(triangle("1e76"));
  const std::string tiny = "v 0 0 0\nv 1e-76 0 0\nv 0 1e-76 0\nf 1 2 3\n";
  EXPECT_NE(error_in_mesh(tiny).find("within 1e-75"), std::string::npos) << error_in_mesh(tiny);
}

TEST(Validate, RefusesIndicesOutOfRange) {
  EXPECT_EQ(error_in_mesh(kSquare + "f 1 2 3\nf 1 3 7\nf 0 1 2\n"),
            "a.obj:6: face 2 names vertex 7, but the vertices are 1 to 4 (2 faces in all); a face "
            "may only name vertices of the mesh");
  EXPECT_TRUE(error_in_mesh("f 1 2 3\n")
                  .starts_with(
                      "a.obj:1: face 1 names vertex 1, but there are no vertices (1 face in all)"));
}

TEST(Validate, RefusesRepeatedIndices) {
  EXPECT_EQ(error_in_mesh(kSquare + "f 1 2 3\nf 1 3 1\nf 1 2 3 2\n"),
            "a.obj:6: face 2 names vertex 1 twice (2 faces in all); the corners of a face must be "
            "different vertices");
}

TEST(Validate, RefusesMeshesWithoutFaces) {
  EXPECT_EQ(error_in_mesh(""),
            "a.obj: there are no faces (0 vertices and 0 faces in all); a mesh needs at least one "
            "triangle");
  EXPECT_NE(error_in_mesh(kSquare), "");
}

TEST(Validate, RefusesVaryingZAndSaysByHowMuch) {
  EXPECT_EQ(error_in_mesh("v 0 0 1\nv 1 0 1\nv 0 1 1.5\nv 1 1 .75\nf 1 2 3\n"),
            "a.obj:3: vertex 3 has z = 1.5, but the first vertex has z = 1 (2 vertices in all); z "
            "varies by 0.75 and only planar meshes with constant z can be opened");
  EXPECT_EQ(error_in_mesh("v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n"), "") << "constant, but not 0";
}

TEST(Validate, RefusesTrianglesOfExactlyZeroArea) {
  EXPECT_EQ(error_in_mesh("v 0 0\nv .1 .1\nv .3 .3\nv 1 0\nf 1 4 3\nf 1 3 2\n"),
            "a.obj:6: face 2 (vertices 1 3 2) has zero area (1 triangle in all); every triangle "
            "must have an area");
}

TEST(Validate, AcceptsTheThinnestTriangle) {
  const double above = std::nextafter(1.0, 2.0);
  Points points(2, 3);
  points << 0, 0.5, 1,  //
      0, 0.5, above;
  const Triangles triangle = Triangles::Map(std::array{0, 1, 2}.data(), 3, 1);
  EXPECT_EQ(error_in_mesh(obj_text(triangle, points)), "");
}

TEST(Validate, RefusesMixedOrientationAndNamesTheFewer) {
  EXPECT_EQ(error_in_mesh(kSquare + "v 2 0 0\nf 1 2 3\nf 1 4 3\nf 2 5 3\n"),
            "a.obj:7: face 2 (vertices 1 4 3) is clockwise, others are counter-clockwise: mixed "
            "orientation (1 triangle in all); orient all faces the same way and unfold the mesh");
  const std::string fewer = error_in_mesh(kSquare + "v 2 0 0\nf 1 3 2\nf 1 3 4\nf 2 3 5\n");
  EXPECT_TRUE(fewer.starts_with("a.obj:7: face 2 (vertices 1 3 4) is counter-clockwise")) << fewer;
}

TEST(Validate, RefusesNonManifoldEdges) {
  EXPECT_EQ(error_in_mesh("v 0 0\nv 1 0\nv 0 1\nv 1 1\nv .3 .9\nf 1 2 3\nf 2 4 3\nf 2 5 3\n"),
            "a.obj:6: face 1 (vertices 1 2 3) has the edge 2-3 of 3 triangles (1 non-manifold edge "
            "in all); an edge can have two triangles at most");
}

TEST(Validate, RefusesTrianglesOnTheSameSideOfAnEdge) {
  const std::string error = error_in_mesh("v 0 0\nv 1 0\nv 0 1\nv 1 1\nf 1 2 3\nf 1 2 4\n");
  EXPECT_TRUE(
      error.starts_with("a.obj:5: face 1 (vertices 1 2 3) and its neighbour pass the edge "
                        "1-2 in the same direction (1 edge in all)"))
      << error;
}

TEST(Validate, RefusesBowTies) {
  const std::string error =
      error_in_mesh("v 0 0\nv 1 0\nv 1 1\nv -1 0\nv -1 -1\nf 1 2 3\nf 1 4 5\n");
  EXPECT_TRUE(
      error.starts_with("a.obj:1: vertex 1 is a bow tie: triangles meet there in one point "
                        "only (1 non-manifold vertex in all)"))
      << error;
}

TEST(Validate, RefusesTwoClosedFansAtAVertex) {
  // Two rings of four triangles round vertex 1: every edge at it is inside.
  std::string text = "v 0 0\n";
  for (const double r : {1.0, 2.0})
    for (int k = 0; k < 4; ++k)
      text += "v " + std::to_string(r * std::cos(k * std::numbers::pi / 2)) + ' ' +
              std::to_string(r * std::sin(k * std::numbers::pi / 2)) + '\n';
  text += "f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\nf 1 6 7\nf 1 7 8\nf 1 8 9\nf 1 9 6\n";
  EXPECT_TRUE(error_in_mesh(text).starts_with("a.obj:1: vertex 1 is a bow tie"))
      << error_in_mesh(text);
}

TEST(Validate, RefusesAMultipleCover) {
  std::string text = "v 0 0\n", faces;
  for (int k = 0; k < 8; ++k) {
    const double angle = 4 * std::numbers::pi * k / 8 + 0.1;
    text += "v " + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + '\n';
    faces += "f 1 " + std::to_string(k + 2) + ' ' + std::to_string((k + 1) % 8 + 2) + '\n';
  }
  EXPECT_EQ(error_in_mesh(text + faces),
            "a.obj:1: vertex 1 is covered more than once: the angles round it add up to more than "
            "a full turn (1 interior vertex in all); lay the mesh flat without overlap round its "
            "interior vertices");
}

TEST(Validate, TurnsOverAMeshThatIsAllClockwise) {
  const test::Fixture f = test::square_grid(4);
  Triangles clockwise = f.triangles;
  clockwise.row(1).swap(clockwise.row(2));
  const TriangleSoup mesh = checked(obj_text(clockwise, f.rest));
  EXPECT_TRUE(is_injective(mesh.triangles, mesh.points));
  EXPECT_EQ(mesh.points, f.rest);
  ASSERT_EQ(mesh.notices.size(), 1u);
  EXPECT_EQ(
      mesh.notices[0],
      "a.obj: all triangles were clockwise (18 triangles in all); they have been turned over");
}

TEST(Validate, CutsPolygonsConvexOrNot) {
  const TriangleSoup mesh =
      checked("v 0 0\nv 4 0\nv 1 1\nv 0 4\nv 4 4\nf 1 2 3 4\nf 2 5 4 3\nv -1 2\nf 1 4 6\n");
  EXPECT_EQ(mesh.triangles.cols(), 5);
  EXPECT_TRUE(is_injective(mesh.triangles, mesh.points));
  ASSERT_EQ(mesh.notices.size(), 1u);
  EXPECT_EQ(mesh.notices[0],
            "a.obj:6: face 1 is a polygon (2 polygons in all); polygons have been cut into "
            "triangles");
}

TEST(Validate, TurnsOverClockwisePolygons) {
  const TriangleSoup mesh = checked(kSquare + "f 4 3 2 1\n");
  EXPECT_TRUE(is_injective(mesh.triangles, mesh.points));
  EXPECT_EQ(mesh.notices.size(), 2u);
}

TEST(Validate, RefusesPolygonsThatCrossThemselves) {
  const std::string error = error_in_mesh(kSquare + "f 1 3 2 4\n");
  EXPECT_TRUE(
      error.starts_with("a.obj:5: face 1, a polygon of 4 corners, crosses or touches itself"))
      << error;
}

TEST(Validate, NamesTheFaceThatATriangleWasCutFrom) {
  const std::string error = error_in_mesh(kSquare + "v 2 0 0\nf 1 2 3 4\nf 2 3 5\n");
  EXPECT_TRUE(error.starts_with("a.obj:7: face 2 (vertices 2 3 5) is clockwise")) << error;
}

TEST(Validate, RefusesAMeshThatOverlapsItselfAtABoundaryVertex) {
  const test::Fixture open = test::open_fan(359), round = test::open_fan(400);
  EXPECT_TRUE(checked(obj_text(open.triangles, open.rest)).notices.empty());
  const std::string error = error_in_mesh(obj_text(round.triangles, round.rest));
  EXPECT_NE(error.find("vertex 1 overlaps itself: its angles add up to a full turn or more"),
            error.npos)
      << error;
  EXPECT_NE(error.find("open the gap"), error.npos) << error;
}

TEST(Validate, DeformedPositionsMayOverlapAtTheBoundaryWhereThatIsAllowed) {
  const test::Fixture round = test::open_fan(400);
  MeshSource source;
  source.name = "a.obj";
  EXPECT_NE(error_of([&] { check_positions(round.triangles, round.rest, source); }), "");
  EXPECT_EQ(error_of([&] {
              check_positions(round.triangles, round.rest, source, BoundaryOverlaps::allowed);
            }),
            "");
}

TEST(Validate, KeepsUnreferencedVerticesWithANotice) {
  const TriangleSoup mesh = checked("v 9 9\n" + kSquare + "v 8 8\nf 2 3 4\nf 2 4 5\n");
  EXPECT_EQ(mesh.points.cols(), 6);
  EXPECT_EQ(mesh.triangles(0, 0), 1);
  ASSERT_EQ(mesh.notices.size(), 1u);
  EXPECT_EQ(mesh.notices[0],
            "a.obj:1: vertex 1 belongs to no face (2 vertices in all); such vertices are kept but "
            "stay where they are");
}

TEST(Validate, FindsTheTwinOfEveryHalfedge) {
  const test::Fixture f = test::square_grid(6);
  const Twins twins = find_twins(f.triangles, 36);
  int boundary = 0;
  for (int h = 0; h < 150; ++h) {
    const int twin = twins.twin[static_cast<std::size_t>(h)];
    boundary += twin < 0;
    if (twin < 0) continue;
    EXPECT_EQ(halfedge_ends(f.triangles, h), halfedge_ends(f.triangles, twin).reverse());
  }
  EXPECT_EQ(boundary, 20);
  EXPECT_EQ(twins.crowded_edges + twins.same_side_edges, 0);
}

}  // namespace
}  // namespace foldless
