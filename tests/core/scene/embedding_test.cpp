// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/embedding.h"

#include <gtest/gtest.h>

#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

using test::TemporaryFolder;

/// A square at rest whose map folds.
constexpr const char* kFolded = R"(v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 2 0
vt 0.5 -1
vt 0 1
f 1/1 2/2 3/3
f 1/1/1 3/-2/1 4/4/1
)";

TEST(Embedding, HandlesStayWhereTheTextureCoordinatesHaveThem) {
  const TemporaryFolder folder;
  folder.write("input.obj", kFolded);
  EXPECT_FALSE(is_embedding(folder / "input.obj"));
  folder.write("handles.txt", "3 0\n2 # the last\n");
  ASSERT_TRUE(is_embedding(folder / "input.obj"));
  const Scene scene = scene_from_embedding(folder / "input.obj").scene;
  ASSERT_EQ(scene.handles.size(), 3U);
  EXPECT_EQ(scene.handles[0].vertex, 3);
  EXPECT_EQ(scene.handles[0].kind, HandleKind::pin) << "it is where it was";
  EXPECT_EQ(scene.handles[2].vertex, 2);
  EXPECT_EQ(scene.handles[2].target, Vec2(0.5, -1));
  EXPECT_EQ(scene.handles[2].kind, HandleKind::drag);
  EXPECT_EQ(scene.rest.col(2), Vec2(1, 1));
  EXPECT_FALSE(scene.state) << "the map folds, so that nothing can begin at it";
}

TEST(Embedding, FacesMayComeBeforeTheVerticesThatTheyName) {
  const TemporaryFolder folder;
  folder.write("input.obj", "vt 0 0\nvt 3 0\nvt 0 3\nf 1/1 2/2 3/3\nv 0 0\nv 1 0\nv 0 1\n");
  folder.write("handles.txt", "2\n");
  const Scene scene = scene_from_embedding(folder / "input.obj").scene;
  EXPECT_EQ(scene.handles.at(0).target, Vec2(0, 3));
}

TEST(Embedding, RefusesHandlesThatAreNone) {
  const TemporaryFolder folder;
  folder.write("input.obj", kFolded + std::string("v 5 5 0\n"));
  const auto error = [&](const char* handles) {
    folder.write("handles.txt", handles);
    return test::error_of([&] { scene_from_embedding(folder / "input.obj"); });
  };
  const std::string file = (folder / "handles.txt").string();
  EXPECT_EQ(error("\n0 7\n"), file + ":2: '7' is no vertex; they are 0 to 4");
  EXPECT_EQ(error("-1"), file + ":1: '-1' is no vertex; they are 0 to 4");
  EXPECT_EQ(error("x"), file + ":1: 'x' is no vertex; they are 0 to 4");
  EXPECT_EQ(error("4"), file + ":1: '4' is a vertex that belongs to no triangle");
  EXPECT_EQ(error("1\n1"), file + ":2: '1' is named twice");
  EXPECT_EQ(error("# none\n"), file + ": names no vertex");
}

TEST(Embedding, RefusesTextureCoordinatesThatSayNoPlaceForAVertex) {
  const TemporaryFolder folder;
  folder.write("handles.txt", "2\n");
  const auto error = [&](const std::string& coordinates, const std::string& faces) {
    folder.write("input.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + coordinates + faces);
    return test::error_of([&] { scene_from_embedding(folder / "input.obj"); });
  };
  const std::string file = (folder / "input.obj").string();
  EXPECT_NE(error("", "f 1 2 3\nf 1 3 4\n").find("is a vertex without texture coordinates"),
            std::string::npos);
  EXPECT_EQ(error("vt 0\n", "f 1 2 3\n"),
            file + ":5: texture coordinates need two numbers: vt u v");
  EXPECT_EQ(error("vt 0 0\n", "f 1/1 2/1 3/2\n"),
            file + ":6: the corner '3/2' names texture coordinates that did not go before");
  EXPECT_EQ(error("vt 0 0\nvt 1 1\n", "f 1/1 2/1 3/1\nf 1/1 3/2 4/1\n"),
            file +
                ":8: the corner '3/2' gives other texture coordinates to a vertex that has "
                "some; one place a vertex is needed");
}

}  // namespace
}  // namespace foldless
