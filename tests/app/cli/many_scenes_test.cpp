// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/cli/command.h"
#include "tests/app/cli/solved.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::Ended;
using test::expect_valid_results;
using test::flipping_problem;
using test::names_in;
using test::read_text;
using test::TemporaryFolder;
using test::write_scene;
using test::write_text;

/// Three scenes, the second of which cannot be read.
void write_three(const TemporaryFolder& folder) {
  std::filesystem::create_directory(folder / "scenes");
  write_scene(folder / "scenes/a.json", flipping_problem());
  write_text(folder / "scenes/b.json", "{}");
  write_scene(folder / "scenes/c.json", flipping_problem());
}

TEST(ManyScenes, EachOfAFolderIsSolvedIntoAFolderOfItsName) {
  const TemporaryFolder folder;
  write_three(folder);
  const Ended ended = test::run({"solve", folder / "scenes", "-o", folder / "out"});
  EXPECT_EQ(ended.status, 2) << "one is no scene";
  EXPECT_NE(ended.err.find("b.json"), std::string::npos) << ended.err;
  EXPECT_EQ(names_in(folder / "out"), (std::vector<std::string>{"a", "c"}));
  expect_valid_results(folder / "out/a");
  expect_valid_results(folder / "out/c");
}

TEST(ManyScenes, AShardOfAListHasEveryNthOfThem) {
  const TemporaryFolder folder;
  write_three(folder);
  write_text(folder / "list.txt", "scenes/a.json\nscenes/b.json\nscenes/c.json\n");
  const Ended ended =
      test::run({"solve", folder / "list.txt", "-o", folder / "out", "--shard", "1/2"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(names_in(folder / "out"), (std::vector<std::string>{"a", "c"}));
  const Ended single =
      test::run({"solve", folder / "scenes/a.json", "-o", folder / "out", "--shard", "1/2"});
  EXPECT_EQ(single.status, 2);
  EXPECT_NE(single.err.find("--shard goes with a folder or a list"), std::string::npos);
}

TEST(ManyScenes, TwoOfOneNameAreRefusedBeforeAnyIsSolved) {
  const TemporaryFolder folder;
  write_three(folder);
  write_text(folder / "list.txt", "scenes/a.json\nscenes/../scenes/a.json\n");
  const Ended ended = test::run({"solve", folder / "list.txt", "-o", folder / "out"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("has the same name"), std::string::npos) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(ManyScenes, AnObjFileWithHandlesBesideItIsOneOfThem) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "square");
  write_text(folder / "square/input.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1.5 1.2\nvt 0.9 -1\n"
             "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  EXPECT_EQ(test::run({"solve", folder / "square/input.obj", "-o", folder / "no"}).status, 2)
      << "it is but a mesh";
  write_text(folder / "square/handles.txt", "0\n2\n");
  ASSERT_EQ(test::run({"solve", folder / "square", "-o", folder / "out", "--quiet"}).status, 0);
  const LoadedMesh deformed = read_mesh(folder / "out/square/deformed.obj");
  EXPECT_LT((deformed.points.col(2) - Vec2(1.5, 1.2)).norm(), 1e-5);
  ASSERT_EQ(test::run({"bench", folder / "square", "--method", "foldless", "-o", folder / "table"})
                .status,
            0);
  const json rows = json::parse(read_text(folder / "table/results.json"));
  EXPECT_EQ(rows.at(0).at("scene"), "square");
  EXPECT_EQ(rows.at(0).at("reached"), true);
}

}  // namespace
}  // namespace foldless
