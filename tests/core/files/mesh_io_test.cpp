// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/mesh_io.h"

#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <random>

#include "core/files/atomic_file.h"
#include "core/files/mesh_readers.h"
#include "core/files/mesh_text.h"
#include "core/files/validate.h"
#include "core/mesh/injective.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"
#include "tests/support/mutation.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

using test::error_of;
using test::TemporaryFolder;

/// A grid whose coordinates need every digit of a double.
test::Fixture jittered_grid(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  test::Fixture f = test::square_grid(9);
  for (double& x : f.rest.reshaped()) x = (x + jitter(random)) * 1e-3;
  return f;
}

TEST(MeshIo, ReadsBackWhatItWroteBitForBit) {
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  const test::Fixture f = jittered_grid(seed);
  const TemporaryFolder folder;
  for (const char* name : {"a.obj", "a.off", "a.ply", "b.OBJ"}) {
    write_mesh(folder / name, f.triangles, f.rest, &f.rest);
    const LoadedMesh mesh = read_mesh(folder / name);
    EXPECT_EQ(mesh.triangles, f.triangles) << name;
    EXPECT_EQ(mesh.points, f.rest) << name;
    EXPECT_TRUE(mesh.notices.empty()) << name;
  }
}

/// A locale whose decimal separator is a comma.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(MeshIo, DoesNotDependOnTheLocale) {
  const test::Fixture f = jittered_grid(4);
  const TemporaryFolder folder;
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // where it is installed
  for (const char* name : {"a.obj", "a.off", "a.ply"}) {
    write_mesh(folder / name, f.triangles, f.rest);
    EXPECT_EQ(read_mesh(folder / name).points, f.rest) << name;
  }
  std::setlocale(LC_NUMERIC, "C");
  std::locale::global(before);
}

TEST(MeshIo, WritesTextureCoordinatesInTheUnitSquare) {
  test::Fixture f = test::square_grid(3);
  f.rest.row(1) *= 0.5;
  f.rest.colwise() += Vec2(7, -3);
  const std::string text = obj_text(f.triangles, f.rest, &f.rest);
  EXPECT_NE(text.find("\nvt 0 0\n"), text.npos);
  EXPECT_NE(text.find("\nvt 1 0.5\n"), text.npos) << "x and y have the same scale";
  EXPECT_NE(text.find("\nf 1/1 2/2 5/5\n"), text.npos);
}

TEST(MeshIo, HasRoomForTheLongestNumbers) {
  Points p(2, 1);
  p << -2.2250738585072014e-308, -1.7976931348623157e+308;
  EXPECT_EQ(obj_text(Triangles(3, 0), p),
            "v -2.2250738585072014e-308 -1.7976931348623157e+308 0\n");
}

TEST(MeshIo, RefusesUnknownFormats) {
  EXPECT_EQ(error_of([] { read_mesh("a.stl"); }),
            "a.stl: not a known mesh format; use .obj, .off or .ply");
  EXPECT_NE(error_of([] { write_mesh("a", Triangles(), Points()); }), "");
  EXPECT_TRUE(is_mesh_file("x/y.PLY"));
  EXPECT_FALSE(is_mesh_file("y.png"));
}

TEST(MeshIo, NamesAMissingFile) {
  EXPECT_TRUE(
      error_of([] { read_mesh("/no/such.obj"); }).starts_with("/no/such.obj: cannot be read"));
}

TEST(MeshIo, ReadsAnyShapeButNotAnyConnectivity) {
  test::Fixture f = test::square_grid(4);
  f.rest.col(5) += Vec2(1.5, 0);
  const TemporaryFolder folder;
  write_mesh(folder / "folded.obj", f.triangles, f.rest);
  EXPECT_NE(error_of([&] { read_mesh(folder / "folded.obj"); }), "");
  EXPECT_EQ(read_mesh_of_any_shape(folder / "folded.obj").points, f.rest);
  folder.write("bow.obj", "v 0 0\nv 1 0\nv 1 1\nv -1 0\nv -1 -1\nf 1 2 3\nf 1 4 5\n");
  EXPECT_NE(error_of([&] { read_mesh_of_any_shape(folder / "bow.obj"); }), "");
}

/// Whatever the bytes are, a mesh is refused with an Error or it is one that the solver can take.
template <typename Reader>
void expect_survives_mutations(const std::string& text, unsigned seed, const Reader& reader) {
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int loaded = 0, refused = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::string bytes = test::mutated(text, random);
    try {
      const TriangleSoup mesh = validated(planar_triangles(reader(bytes, "fuzz")));
      EXPECT_TRUE(is_injective(mesh.triangles, mesh.points)) << bytes;
      ++loaded;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string_view(error.what()).starts_with("fuzz:")) << error.what();
      EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
      ++refused;
    }
  }
  EXPECT_GT(loaded, 20);
  EXPECT_GT(refused, 200);
}

TEST(MeshIo, SurvivesMutatedFiles) {
  const test::Fixture f = test::square_grid(3);
  const std::string obj =
      obj_text(f.triangles, f.rest, &f.rest) + "v 5 5\nv 6 5\nv 5 6\nf -3 -2 -1\n";
  expect_survives_mutations(obj, 1, read_obj);
  expect_survives_mutations("v 0 0\nv 4 0\nv 1 1\nv 0 4\nv -1 1\nf 1 2 3 4 5 # comment\n", 2,
                            read_obj);
  expect_survives_mutations(off_text(f.triangles, f.rest), 3, read_off);
  expect_survives_mutations("OFF\n5 1 0\n0 0 0\n4 0 0\n1 1 0\n0 4 0\n-1 1 0\n5 0 1 2 3 4\n", 4,
                            read_off);
  expect_survives_mutations(ply_text(f.triangles, f.rest), 5, read_ply);
}

}  // namespace
}  // namespace foldless
