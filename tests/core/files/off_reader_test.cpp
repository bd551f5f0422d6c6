// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/files/mesh_readers.h"
#include "tests/support/errors.h"

namespace foldless {
namespace {

using test::error_of;

std::string error_in_off(std::string_view text) {
  return error_of([&] { read_off(text, "a.off"); });
}

TEST(OffReader, TakesEveryFormOfTheHeader) {
  for (const char* header : {"OFF\n3 1 0\n", "OFF 3 1 3\n", "3 1 0\n", "COFF\n# counts\n3 1\n",
                             "\n# made by hand\nSTCNOFF\r\n\r\n3 1 0\r\n"}) {
    const PolygonSoup soup = read_off(
        std::string(header) + "0 0 0\n1 0 0 255 0 0\n.5 1\n3 0 1 2 0.5 0.5 0.5\n", "a.off");
    ASSERT_EQ(soup.vertices.size(), 3u) << header;
    EXPECT_EQ(soup.vertices[2], (std::array<double, 3>{0.5, 1, 0}));
    EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
  }
}

TEST(OffReader, CountsFromZeroInMessages) {
  const PolygonSoup soup = read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off");
  EXPECT_EQ(soup.source.at_vertex(2), "a.off:5: vertex 2");
  EXPECT_EQ(soup.source.at_face(0), "a.off:6: face 0");
}

TEST(OffReader, KeepsPolygons) {
  const PolygonSoup soup = read_off("OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "a.off");
  EXPECT_EQ(soup.corners.size(), 4u);
  EXPECT_EQ(soup.face_count(), 1);
}

TEST(OffReader, RefusesOtherHeaders) {
  EXPECT_EQ(error_in_off("solid\n"), "a.off:1: an OFF file begins with OFF, not with 'solid'");
  EXPECT_EQ(error_in_off("OFF BINARY\n"), "a.off:1: this OFF file is binary; save it as text");
  EXPECT_EQ(error_in_off("OFF\n-1 0 0\n"),
            "a.off:2: the numbers of vertices and faces are expected, not '-1'");
}

TEST(OffReader, RefusesFilesThatAreCutShort) {
  EXPECT_EQ(error_in_off("OFF\n3 1 0\n0 0 0\n"),
            "a.off:3: the file ends after 1 of 3 vertices; it has been cut short");
  EXPECT_EQ(error_in_off("OFF\n1 2000000000 0\n0 0 0\n"),
            "a.off:3: the file ends after 0 of 2000000000 faces; it has been cut short");
}

TEST(OffReader, NamesUnreadableNumbersAndTheCount) {
  const std::string vertex = error_in_off("OFF\n2 0 0\n0 zero 0\n1\n");
  EXPECT_TRUE(
      vertex.starts_with("a.off:3: vertex 0 has the coordinate 'zero', which is not a "
                         "number (2 vertices in all)"))
      << vertex;
  const std::string face = error_in_off("OFF\n1 2 0\n0 0 0\n3 0 0\n3.5 0 0 0\n");
  EXPECT_TRUE(
      face.starts_with("a.off:4: face 0 has the corner '', which is not a vertex number "
                       "(2 faces in all)"))
      << face;
  const std::string few = error_in_off("OFF\n1 1 0\n0 0 0\n2 0 0\n");
  EXPECT_TRUE(few.starts_with("a.off:4: face 0 has 2 corners (1 face in all)")) << few;
}

}  // namespace
}  // namespace foldless
