// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/data_path.h"
#include "core/files/atomic_file.h"
#include "core/scene/baked_io.h"
#include "render/image.h"
#include "tests/app/cli/command.h"
#include "tests/support/sanitizers.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::TemporaryFolder;

std::string sample(const std::string& name) {
  return data_path("assets/scenes/" + name + ".json").string();
}

/// Files and folders in a folder, hidden ones too.
std::size_t entries_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(AnimateCall, SamplesAreProvedAtEveryMoment) {
  for (const char* name : {"walk", "snap", "turn_360"}) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.foldless";
    const Ended ended = test::run({"animate", sample(name), "-o", file});
    EXPECT_EQ(ended.status, 0) << name << ": " << ended.err;
    EXPECT_NE(ended.out.find("every handle is at its target"), ended.out.npos) << ended.out;
    EXPECT_NE(ended.out.find("proved to be injective at every moment"), ended.out.npos);
    const Ended checked = test::run({"check", file});
    EXPECT_EQ(checked.status, 0) << checked.out;
    EXPECT_EQ(nlohmann::json::parse(checked.out)["unproved_steps"], 0);
    const BakedAnimation baked = read_baked(file);
    EXPECT_LE(baked.rest.cols(), 3 * baked.original_vertices) << name;
  }
}

TEST(AnimateCall, CheckNamesTheMomentThatIsNot) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.foldless";
  ASSERT_EQ(test::run({"animate", sample("walk"), "-o", file, "--quiet"}).status, 0);
  BakedAnimation baked = read_baked(file);
  baked.frames[5].deformed.col(7) -= Vec2(0, 2);  // From the top of the head down.
  write_file_atomically(file, baked_text(baked, {}));
  const Ended checked = test::run({"check", file});
  ASSERT_EQ(checked.status, 1) << checked.out;
  const auto line = nlohmann::json::parse(checked.out);
  EXPECT_EQ(line["ok"], false);
  ASSERT_EQ(line["unproved_steps"], 2);
  EXPECT_NE(line["problems"][0].get<std::string>().find(" has no area at frame 4."),
            std::string::npos)
      << checked.out;
}

TEST(AnimateCall, ASpriteSheetIsNotInMemoryAsAWhole) {
  if (test::kIsSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
  const TemporaryFolder folder;
  const Ended ended = test::run({"animate", sample("snap"), "-o", folder / "a.json", "--size",
                                 "1600x800", "--range", "0-17", "--quiet"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Image sheet = load_image(folder / "a.png");
  EXPECT_GT(4.0 * sheet.width * sheet.height, 85e6) << "bytes of its pixels";
  EXPECT_LT(ended.peak, 300) << "MiB; 550 were its pixels three times";
}

TEST(AnimateCall, AnAnimatedPngMayEndInApng) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.apng"}) {
    const Ended ended = test::run({"animate", sample("snap"), "-o", folder / name, "--size",
                                   "60x30", "--range", "4-9", "--quiet"});
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  EXPECT_EQ(read_file(folder / "a.apng"), read_file(folder / "a.png"));
}

TEST(AnimateCall, PicturesHaveOneSizeAndTheSameBytesEveryTime) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"})
    ASSERT_EQ(test::run({"animate", sample("snap"), "-o", folder / name, "--size", "120x60",
                         "--range", "4-9"})
                  .status,
              0);
  EXPECT_EQ(entries_in(folder / "a"), 6U);
  for (const auto& entry : fs::directory_iterator(folder / "a")) {
    const std::string bytes = read_file(entry.path());
    EXPECT_EQ(bytes, read_file(fs::path(folder / "b") / entry.path().filename()));
    const Image image = decode_image(bytes);
    EXPECT_EQ(image.width, 120);
    EXPECT_EQ(image.height, 60);
  }
  EXPECT_NE(load_image(fs::path(folder / "a") / "000000.png"),
            load_image(fs::path(folder / "a") / "000005.png"));
}

TEST(AnimateCall, ARangeIsAPartOfTheWhole) {
  const TemporaryFolder folder;
  const auto deformed = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"animate", sample("snap"), "-o", folder / "a.foldless",
                                       "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(test::run(arguments).status, 0);
    return read_baked(folder / "a.foldless");
  };
  const BakedAnimation part = deformed({"--range", "3-7"});
  ASSERT_EQ(part.frames.size(), 5U);
  EXPECT_FALSE(part.loops);
  EXPECT_EQ(part.frames.front().frame, 3);
  const BakedAnimation slower = deformed({"--fps", "12"});
  ASSERT_EQ(slower.frames.size(), 18U);
  EXPECT_EQ(slower.frames[4].frame, 8);
}

TEST(AnimateCall, ARangeHasTheFramesOfTheWhole) {
  const TemporaryFolder folder;
  const std::string whole = folder / "whole.foldless", part = folder / "part.foldless";
  ASSERT_EQ(test::run({"animate", sample("walk"), "-o", whole, "--quiet"}).status, 0);
  ASSERT_EQ(test::run({"animate", sample("walk"), "-o", part, "--range", "5-9", "--quiet"}).status,
            0);
  const BakedAnimation all = read_baked(whole), some = read_baked(part);
  ASSERT_EQ(all.frames.size(), 24U);
  ASSERT_EQ(some.frames.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(some.frames[i].deformed.leftCols(some.original_vertices),
              all.frames[5 + i].deformed.leftCols(all.original_vertices))
        << i;
}

TEST(AnimateCall, WhatItIsMadeOfIsNotWrittenOver) {
  const TemporaryFolder folder;
  const std::string scene = folder / "walk.json";
  std::string text = read_file(sample("walk"));
  const std::string mesh = "../meshes/gingerbread.obj";
  text.replace(text.find(mesh), mesh.size(), "body.obj");
  text.insert(text.find("\"energy\""), "\"texture\": \"walk.png\", ");
  write_file_atomically(scene, text);
  fs::copy_file(data_path("assets/meshes/gingerbread.obj"), folder / "body.obj");
  save_png(folder / "walk.png", Image(4, 4));
  const std::string picture = read_file(folder / "walk.png");
  for (const char* name : {"walk.json", "walk.png", "walk.tscn", "walk.spine.json"}) {
    const Ended ended = test::run({"animate", scene, "-o", folder / name});
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find("the animation is made of it"), ended.err.npos) << ended.err;
  }
  EXPECT_EQ(read_file(scene), text);
  EXPECT_EQ(read_file(folder / "walk.png"), picture);
  EXPECT_EQ(entries_in(folder.path()), 3U);
}

TEST(AnimateCall, ASpriteSheetHasItsPictureBesideIt) {
  const TemporaryFolder folder;
  const Ended ended = test::run({"animate", sample("snap"), "-o", folder / "a.json", "--size",
                                 "90x60", "--transparent", "--power-of-two"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const auto text = nlohmann::json::parse(read_file(folder / "a.json"));
  EXPECT_EQ(text["frames"].size(), 36U);
  EXPECT_EQ(text["frames"][0]["trimmed"], true);
  EXPECT_EQ(text["meta"]["image"], "a.png");
  const Image sheet = load_image(folder / "a.png");
  EXPECT_EQ(sheet.width & (sheet.width - 1), 0);
  EXPECT_EQ(text["meta"]["size"]["h"], sheet.height);
  EXPECT_EQ(entries_in(folder.path()), 2U);
}

TEST(AnimateCall, GltfIsProvedInSinglePrecision) {
  const TemporaryFolder folder;
  for (const char* name : {"walk", "turn_360"}) {
    const Ended ended = test::run({"animate", sample(name), "-o", folder / "a.glb"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("proved to be injective at every moment"), ended.out.npos)
        << ended.out;
    const std::string bytes = read_file(folder / "a.glb");
    EXPECT_TRUE(bytes.starts_with("glTF"));
    const auto document = nlohmann::json::parse(bytes.substr(20, bytes.find("BIN") - 24));
    EXPECT_GE(document["meshes"][0]["primitives"][0]["targets"].size(), 23U);
  }
}

TEST(AnimateCall, FilesOfEnginesHaveTheirPicturesBesideThem) {
  const TemporaryFolder folder;
  for (const char* name : {"a.spine.json", "b.tscn"}) {
    const Ended ended = test::run({"animate", sample("turn_360"), "-o", folder / name});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("proved to be injective at every moment"), ended.out.npos)
        << ended.out;
  }
  EXPECT_EQ(entries_in(folder.path()), 5U);
  const auto skeleton = nlohmann::json::parse(read_file(folder / "a.spine.json"));
  EXPECT_EQ(skeleton["animations"]["a"]["attachments"]["default"]["a"]["a"]["deform"].size(), 49U);
  EXPECT_NEAR(skeleton["skeleton"]["width"].get<double>(), 1024, 2) << "a disk at rest";
  EXPECT_NEAR(skeleton["skeleton"]["x"].get<double>(), -512, 1) << "about its middle";
  const Image picture = load_image(folder / "a.png");
  EXPECT_TRUE(read_file(folder / "a.atlas")
                  .starts_with("a.png\nsize:" + std::to_string(picture.width) + "," +
                               std::to_string(picture.height) + "\n"));
  EXPECT_EQ(load_image(folder / "b.png"), picture);
  EXPECT_NE(read_file(folder / "b.tscn").find("path=\"b.png\""), std::string::npos);
}

TEST(AnimateCall, FilmsAreWhole) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.gif", "a.webp"}) {
    const Ended ended = test::run(
        {"animate", sample("walk"), "-o", folder / name, "--size", "64x64", "--transparent"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(ended.out.starts_with("24 frames: every handle is at its target; the loop comes"));
  }
  EXPECT_EQ(load_image(folder / "a.png").at(0, 0)[3], 0) << "transparent";
  EXPECT_EQ(entries_in(folder.path()), 3U);
}

TEST(AnimateCall, SaysWhatIsWrongAndWritesNothing) {
  const TemporaryFolder folder;
  const auto error = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"animate"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ended ended = test::run(all);
    EXPECT_EQ(ended.status, 2) << ended.err;
    return ended.err;
  };
  const std::string out = folder / "a.png";
  EXPECT_NE(error({sample("welcome"), "-o", out}).find("has no animation"), std::string::npos);
  EXPECT_NE(error({sample("walk"), "-o", folder / "a.gifff"}).find("animate writes .png"),
            std::string::npos);
  EXPECT_EQ(error({sample("walk"), "-o", out, "--range", "5-3"}),
            "foldless: --range takes FIRST-LAST, such as 0-23, not '5-3'\n");
  EXPECT_EQ(error({sample("walk"), "-o", out, "--range", "5-24"}),
            "foldless: --range ends with frame 24, but the last is 23\n");
  EXPECT_EQ(error({sample("walk"), "-o", out, "--fps", "0"}),
            "foldless: --fps takes a number from 0.1 to 1000, not '0'\n");
  EXPECT_NE(error({sample("walk"), "-o", folder / "none/a.png"}).find("there is no folder"),
            std::string::npos);
  EXPECT_EQ(entries_in(folder.path()), 0U);
  fs::create_directory(folder / "full");
  write_file_atomically(folder / "full/x", "x");
  EXPECT_NE(error({sample("walk"), "-o", folder / "full"}).find("is there already"),
            std::string::npos);
  EXPECT_EQ(entries_in(folder.path()), 1U);
}

TEST(AnimateCall, InterruptedLeavesNothing) {
  for (const char* name : {"a", "a.webp"}) {
    const TemporaryFolder folder;
    const Ended ended = test::interrupt(
        {"animate", sample("turn_360"), "-o", folder / name, "--size", "1000x1000"}, SIGINT,
        [](const test::Command& command) { return command.processor_seconds() > 0.2; },
        [&] { fs::remove_all(folder / name); });
    EXPECT_EQ(ended.status, 130) << ended.err;
    EXPECT_EQ(entries_in(folder.path()), 0U) << name;
  }
}

}  // namespace
}  // namespace foldless
