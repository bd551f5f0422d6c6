// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures for regression tests of others: drawn as they ask, and compared.
#include <gtest/gtest.h>

#include "render/image.h"
#include "tests/app/cli/command.h"
#include "tests/app/cli/solved.h"

namespace foldless {
namespace {

using test::Ended;
using test::flipping_problem;
using test::TemporaryFolder;
using test::write_scene;

class ComparedPictures : public testing::Test {
 protected:
  ComparedPictures() { write_scene(folder_ / "scene.json", flipping_problem()); }

  Ended draw(const std::string& name, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{
        "render", folder_ / "scene.json", "-o", folder_ / name, "--size", "160x120"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  }
  Image picture(const std::string& name) const { return load_image(folder_ / name); }
  Ended compare(const std::string& a, const std::string& b,
                std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"compare", folder_ / a, folder_ / b};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(ComparedPictures, TheSameSceneTwiceIsAlikePixelForPixel) {
  ASSERT_EQ(draw("a.png").status, 0);
  ASSERT_EQ(draw("b.png").status, 0);
  const Ended ended = compare("a.png", "b.png");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "alike, pixel for pixel\n");
}

TEST_F(ComparedPictures, WhatDiffersIsToldAndDrawn) {
  ASSERT_EQ(draw("a.png").status, 0);
  ASSERT_EQ(draw("b.png", {"--line-width", "3"}).status, 0);
  const Ended ended = compare("a.png", "b.png", {"--diff", folder_ / "diff.png"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_TRUE(ended.out.starts_with("different: ")) << ended.out;
  EXPECT_EQ(picture("diff.png").width, 160);
  EXPECT_EQ(compare("a.png", "b.png", {"--tolerance", "255"}).status, 0);
}

TEST_F(ComparedPictures, OfOtherSizesAreDifferent) {
  ASSERT_EQ(draw("a.png").status, 0);
  ASSERT_EQ(draw("b.png", {"--size", "80x60"}).status, 2) << "twice the same option";
  save_png(folder_ / "b.png", Image(80, 60));
  const Ended ended = compare("a.png", "b.png");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.out.find("160 × 120"), std::string::npos) << ended.out;
}

TEST_F(ComparedPictures, UnreadableOnesAndBadTolerancesAreErrors) {
  ASSERT_EQ(draw("a.png").status, 0);
  EXPECT_EQ(compare("a.png", "none.png").status, 2);
  EXPECT_EQ(compare("a.png", "scene.json").status, 2);
  EXPECT_EQ(compare("a.png", "a.png", {"--tolerance", "300"}).status, 2);
  EXPECT_EQ(compare("a.png", "a.png", {"--diff", folder_ / "diff.jpg"}).status, 2);
}

TEST_F(ComparedPictures, AreDrawnInAThemeOnAColourFromAPlace) {
  ASSERT_EQ(draw("light.png").status, 0);
  ASSERT_EQ(draw("dark.png", {"--theme", "dark"}).status, 0);
  EXPECT_EQ(compare("light.png", "dark.png").status, 1);
  ASSERT_EQ(draw("red.png", {"--background", "#FF0080"}).status, 0);
  const Image red = picture("red.png");
  EXPECT_EQ(red.at(0, 0)[0], 255);
  EXPECT_EQ(red.at(0, 0)[1], 0);
  EXPECT_EQ(red.at(0, 0)[2], 128);
  EXPECT_EQ(red.at(0, 0)[3], 255);
  // So far away that the mesh is out of sight.
  ASSERT_EQ(draw("empty.png", {"--camera", "1000,0,10", "--background", "#FF0080"}).status, 0);
  const Image empty = picture("empty.png");
  for (std::size_t i = 0; i < empty.pixels.size(); i += 4) ASSERT_EQ(empty.pixels[i + 2], 128);
}

TEST_F(ComparedPictures, OptionsThatMakeNoSenseAreNamed) {
  const auto error = [&](const std::string& option, const std::string& value) {
    const Ended ended = draw("x.png", {option, value});
    EXPECT_EQ(ended.status, 2) << option;
    EXPECT_NE(ended.err.find(option), std::string::npos) << ended.err;
  };
  error("--theme", "pink");
  error("--background", "red");
  error("--background", "#12345G");
  for (const char* camera : {"1,2", "1,2,0", "1,2,-3", "a,b,c", "1,2,3,4", "nan,0,1"})
    error("--camera", camera);
  error("--line-width", "0");
  EXPECT_EQ(draw("x.png", {"--transparent", "--background", "#000000"}).status, 2);
}

}  // namespace
}  // namespace foldless
