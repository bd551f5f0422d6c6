// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/layered_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "core/error.h"
#include "tests/support/errors.h"
#include "tests/support/layered_files.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// Three layers: over the whole canvas, soft and beyond the right edge, and half transparent.
LayeredImage sample() {
  Image noise(70, 66);
  std::mt19937 random(3);
  for (auto& byte : noise.pixels) byte = static_cast<std::uint8_t>(random() | 1);
  LayeredImage painting = painting_of(
      150, 100,
      {block("Paper", 0, 0, plain(150, 100, {250, 240, 200, 255})), block("Noise", 100, 20, noise),
       block("Veil", 10, 30, plain(20, 9, {9, 90, 200, 255}))});
  painting.layers[2].opacity = 0.4;
  painting.merged = composed(painting);
  return painting;
}

int largest_difference(const Image& a, const Image& b) {
  int largest = a.width == b.width && a.height == b.height ? 0 : 999;
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
    largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  return largest;
}

struct Format {
  const char* name;
  std::function<std::string(const LayeredImage&)> bytes;
};

const std::vector<Format>& formats() {
  static const std::vector<Format> all{
      {"a.ora", ora_of},
      {"a.kra", kra_of},
      {"a.psd", [](const LayeredImage& p) { return psd_of(p, PsdPacking::bits); }},
      {"raw.psd", [](const LayeredImage& p) { return psd_of(p, PsdPacking::none); }},
      {"zip.psd", [](const LayeredImage& p) { return psd_of(p, PsdPacking::zip); }},
      {"zipped.psd", [](const LayeredImage& p) { return psd_of(p, PsdPacking::differences); }}};
  return all;
}

class LayeredFile : public testing::TestWithParam<int> {
 protected:
  const Format& format() const { return formats()[static_cast<std::size_t>(GetParam())]; }
  std::filesystem::path write(const LayeredImage& painting) const {
    return folder_.write(format().name, format().bytes(painting));
  }
  TemporaryFolder folder_;
};

TEST_P(LayeredFile, KeepsLayersAsTheyArePainted) {
  LayeredImage painting = sample();
  painting.layers.insert(painting.layers.begin() + 1,
                         block("Hidden", 0, 0, plain(5, 5, {1, 2, 3, 255})));
  painting.layers[1].is_visible = false;
  const LayeredImage read = load_layered(write(painting));
  EXPECT_TRUE(read.notices.empty());
  EXPECT_EQ(read.width, 150);
  EXPECT_EQ(read.height, 100);
  ASSERT_EQ(read.layers.size(), 4U);
  for (std::size_t l = 0; l < 4; ++l) {
    EXPECT_EQ(read.layers[l].name, painting.layers[l].name);
    EXPECT_EQ(read.layers[l].is_visible, l != 1);
    EXPECT_NEAR(read.layers[l].opacity, painting.layers[l].opacity, 1e-6);
  }
  EXPECT_EQ(read.layers[0].image, painting.layers[0].image);
  EXPECT_EQ(read.layers[1].image, Image());
  EXPECT_EQ(read.layers[3].image, painting.layers[3].image);
  EXPECT_EQ(read.layers[3].x, 10);
  EXPECT_EQ(read.layers[3].y, 30);
}

TEST_P(LayeredFile, CutsLayersDownToWhatIsSeen) {
  LayeredImage painting = sample();
  for (int y = 0; y < 66; ++y) painting.layers[1].image.at(0, y)[3] = 0;
  const LayeredImage read = load_layered(write(painting));
  const PictureLayer& noise = read.layers[1];
  EXPECT_EQ(noise.x, 101);
  EXPECT_EQ(noise.y, 20);
  ASSERT_EQ(noise.image.width, 49) << "up to the edge of the canvas";
  ASSERT_EQ(noise.image.height, 66);
  for (int y = 0; y < 66; ++y)
    for (int x = 0; x < 49; ++x)
      ASSERT_TRUE(std::equal(noise.image.at(x, y), noise.image.at(x, y) + 4,
                             painting.layers[1].image.at(x + 1, y)));
}

TEST_P(LayeredFile, LayersBesideTheCanvasAreThereWithoutAPicture) {
  LayeredImage painting = sample();
  for (const auto& [x, y] : {std::pair{170, 120}, {170, -90}, {-90, 120}, {-90, -90}, {150, 10}}) {
    painting.layers[1].x = x;
    painting.layers[1].y = y;
    const LayeredImage read = load_layered(write(painting));
    ASSERT_EQ(read.layers.size(), 3U);
    EXPECT_EQ(read.layers[1].image, Image()) << x << ' ' << y;
  }
}

TEST_P(LayeredFile, OpensMergedAsAnyPicture) {
  LayeredImage painting = sample();
  for (int x = 0; x < 90; ++x) painting.layers[0].image.at(x, 4)[3] = 100;
  painting.merged = composed(painting);
  EXPECT_LE(largest_difference(load_image(write(painting)), painting.merged), 1);
}

TEST_P(LayeredFile, KnowsItsName) {
  EXPECT_TRUE(is_image_file(format().name));
  EXPECT_TRUE(is_layered_file(format().name));
}

TEST_P(LayeredFile, DamagedIsRefusedInASentence) {
  const std::string whole = format().bytes(sample());
  std::mt19937 random(5);
  int refused = 0;
  for (int trial = 0; trial < 120; ++trial) {
    std::string bytes = whole;
    if (trial % 3 == 0) {
      bytes.resize(random() % bytes.size());
    } else {
      // The head and the tables of a file more often than its pixels.
      const std::size_t range =
          trial % 3 == 1 ? std::min<std::size_t>(300, bytes.size()) : bytes.size();
      for (int hit = 0; hit < 4; ++hit) bytes[random() % range] = static_cast<char>(random());
    }
    const std::filesystem::path file = folder_.write(format().name, bytes);
    const std::string words = error_of([&] { load_layered(file); });
    if (words.empty()) continue;
    ++refused;
    EXPECT_TRUE(words.starts_with(file.string() + ": ")) << words;
    EXPECT_EQ(words.find('\n'), std::string::npos);
  }
  EXPECT_GT(refused, 40);
}

INSTANTIATE_TEST_SUITE_P(Formats, LayeredFile, testing::Range(0, 6));

TEST(LayeredImage, ComposesAsLayersArePainted) {
  LayeredImage painting = painting_of(2, 1,
                                      {block("Red", 0, 0, plain(2, 1, {255, 0, 0, 255})),
                                       block("Blue", 1, 0, plain(1, 1, {0, 0, 255, 128}))});
  painting.layers[1].opacity = 0.5;
  const Image image = composed(painting);
  EXPECT_EQ(image.at(0, 0)[0], 255);
  EXPECT_EQ(image.at(1, 0)[0], 191);
  EXPECT_EQ(image.at(1, 0)[2], 64);
  EXPECT_EQ(image.at(1, 0)[3], 255);
}

TEST(LayeredImage, GivesEveryLayerANameOfItsOwn) {
  const TemporaryFolder folder;
  const Image dot = plain(2, 2, {1, 1, 1, 255});
  const auto file = folder.write(
      "a.ora",
      ora_of(painting_of(
          9, 9, {block("Arm", 0, 0, dot), block("Arm", 3, 0, dot), block("", 6, 0, dot)})));
  const auto layers = load_layered(file).layers;
  EXPECT_EQ(layers[0].name, "Arm");
  EXPECT_EQ(layers[1].name, "Arm (2)");
  EXPECT_EQ(layers[2].name, "Layer");
}

}  // namespace
}  // namespace foldless::test
