// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "core/files/mesh_readers.h"
#include "tests/support/errors.h"

namespace foldless {
namespace {

using test::error_of;

const std::string kAscii = "ply\nformat ascii 1.0\n";
const std::string kVertices =
    "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string error_in_ply(std::string_view text) {
  return error_of([&] { read_ply(text, "a.ply"); });
}

template <typename T>
void append_bytes(std::string& text, T value, bool big_endian) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (big_endian) std::reverse(bytes, bytes + sizeof(T));
  text.append(bytes, sizeof(T));
}

std::string binary_triangle(bool big_endian) {
  std::string text = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\ncomment made by a test\n" + kVertices + kFaces;
  for (const double x : {0.0, 0.0, 7.0, 0.1 + 0.2, 0.0, 7.0, 0.0, 1e-3, 7.0})
    append_bytes(text, x, big_endian);
  append_bytes(text, std::uint8_t{3}, big_endian);
  for (const std::int32_t v : {0, 1, 2}) append_bytes(text, v, big_endian);
  return text;
}

TEST(PlyReader, KeepsDoublesOfTextFilesExactly) {
  const PolygonSoup soup = read_ply(
      kAscii + kVertices + kFaces + "0 0 0\n0.30000000000000004 0 0\n0 1 0\n3 0 1 2\n", "a.ply");
  ASSERT_EQ(soup.vertices.size(), 3u);
  EXPECT_EQ(soup.vertices[1][0], 0.1 + 0.2);
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(soup.source.at_vertex(1), "a.ply:11: vertex 1");
  EXPECT_EQ(soup.source.at_face(0), "a.ply:13: face 0");
}

TEST(PlyReader, KeepsDoublesOfBinaryFilesExactly) {
  for (const bool big_endian : {false, true}) {
    const PolygonSoup soup = read_ply(binary_triangle(big_endian), "a.ply");
    ASSERT_EQ(soup.vertices.size(), 3u);
    EXPECT_EQ(soup.vertices[1], (std::array<double, 3>{0.1 + 0.2, 0, 7}));
    EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
  }
}

TEST(PlyReader, SkipsOtherElementsAndProperties) {
  const PolygonSoup soup = read_ply(
      "ply\r\nformat ascii 1.0\r\nobj_info scanned\r\nelement camera 1\r\nproperty float x\r\n"
      "property list uchar float zoom\r\nelement vertex 3\r\nproperty float x\r\n"
      "property uchar red\r\nproperty float y\r\nelement halfedge 1\r\nproperty char source\r\n"
      "element face 1\r\nproperty uchar flags\r\nproperty list ushort uint vertex_index\r\n"
      "end_header\r\n9 2 8 8\r\n0 255 0\r\n1 0 0\r\n0 7 .5\r\n1\r\n4 3 0 1 2\r\n",
      "a.ply");
  ASSERT_EQ(soup.vertices.size(), 3u);
  EXPECT_EQ(soup.vertices[2], (std::array<double, 3>{0, 0.5, 0}));
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
}

TEST(PlyReader, RefusesWrongHeaders) {
  EXPECT_EQ(error_in_ply("OFF\n"), "a.ply:1: a PLY file begins with the line 'ply'");
  EXPECT_EQ(error_in_ply("ply\nformat text 1.0\n"), "a.ply:2: the format 'text' is unknown");
  EXPECT_EQ(error_in_ply("ply\nformat ascii 1.0\n"),
            "a.ply:2: the header of the PLY file has no end");
  EXPECT_EQ(error_in_ply("ply\nend_header\n"), "a.ply:2: the header does not give a format");
  EXPECT_EQ(error_in_ply("ply\nproperty float x\n"),
            "a.ply:2: a property comes before every element");
  EXPECT_EQ(error_in_ply("ply\nelement vertex many\n"),
            "a.ply:2: the element 'vertex' has the count 'many'");
  EXPECT_EQ(error_in_ply("ply\nelement vertex 1\nproperty real x\n"),
            "a.ply:3: the type 'real' is unknown");
  EXPECT_EQ(error_in_ply("ply\nhello\n"), "a.ply:2: the header has the unknown word 'hello'");
}

TEST(PlyReader, RefusesHeadersOfOtherThings) {
  const std::string start = kAscii + "element vertex 1\nproperty float x\nproperty float y\n";
  EXPECT_EQ(error_in_ply(kAscii + kFaces), "a.ply:5: the PLY file has no element 'vertex'");
  EXPECT_EQ(error_in_ply(start + "end_header\n0 0\n"),
            "a.ply:6: the PLY file has no element 'face'");
  EXPECT_EQ(error_in_ply(kAscii + "element vertex 1\nproperty float x\n" + kFaces),
            "a.ply:3: the vertices need one x and one y");
  EXPECT_EQ(error_in_ply(kAscii + "element vertex 1\nproperty int x\nproperty float y\n" + kFaces),
            "a.ply:3: the coordinate x of the vertices is of type int; float or double is needed");
  EXPECT_EQ(error_in_ply(start + "element face 1\nproperty uchar red\nend_header\n"),
            "a.ply:6: the faces have no list vertex_indices");
  EXPECT_EQ(error_in_ply(start +
                         "element face 1\nproperty list uchar float vertex_indices\nend_header\n"),
            "a.ply:6: the property vertex_indices must be a list of int or uint");
  EXPECT_NE(
      error_in_ply(start + "element face 1\nproperty list int int vertex_indices\nend_header\n"),
      "");
}

TEST(PlyReader, RefusesFilesThatAreCutShort) {
  const std::string ascii = kAscii + kVertices + kFaces;
  EXPECT_TRUE(
      error_in_ply(ascii + "0 0 0\n1 0 0\n").starts_with("a.ply:12: vertex 2 cannot be read"));
  EXPECT_TRUE(error_in_ply(ascii + "0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n")
                  .starts_with("a.ply:11: vertex 1 cannot be read"));
  EXPECT_TRUE(error_in_ply(ascii + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n")
                  .starts_with("a.ply:13: face 0 cannot be read"));
  const std::string binary = binary_triangle(false);
  for (std::size_t n = binary.find("end_header") + 11; n < binary.size(); ++n)
    EXPECT_NE(error_in_ply(std::string_view(binary).substr(0, n)), "") << n;
}

}  // namespace
}  // namespace foldless
