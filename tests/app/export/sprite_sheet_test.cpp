// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/sprite_sheet.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

namespace foldless {
namespace {

/// A rectangle that wanders, of another size each time; the last picture is empty.
Image sprite(int i) {
  Image image(40, 30);
  if (i == 6) return image;
  for (int y = 3 + i; y < 10 + 2 * i; ++y)
    for (int x = 5 + 2 * i; x < 12 + 3 * i; ++x) {
      std::uint8_t* p = image.at(x, y);
      p[0] = static_cast<std::uint8_t>(30 * i);
      p[1] = static_cast<std::uint8_t>(x);
      p[2] = static_cast<std::uint8_t>(y);
      p[3] = static_cast<std::uint8_t>(100 + y);
    }
  return image;
}

/// The pictures that an engine makes of a sheet.
std::vector<Image> unpacked(const Image& sheet, const nlohmann::json& text) {
  std::vector<Image> images;
  for (const auto& item : text["frames"]) {
    Image image(item["sourceSize"]["w"], item["sourceSize"]["h"]);
    const auto& on = item["frame"];
    const auto& from = item["spriteSourceSize"];
    EXPECT_EQ(on["w"], from["w"]);
    EXPECT_EQ(on["h"], from["h"]);
    for (int y = 0; y < on["h"].get<int>(); ++y)
      for (int x = 0; x < on["w"].get<int>(); ++x)
        std::memcpy(image.at(from["x"].get<int>() + x, from["y"].get<int>() + y),
                    sheet.at(on["x"].get<int>() + x, on["y"].get<int>() + y), 4);
    images.push_back(image);
  }
  return images;
}

SpriteSheet seven() {
  SpriteSheet sheet(24);
  for (int i = 0; i < 7; ++i) sheet.add(sprite(i));
  return sheet;
}

TEST(SpriteSheet, GivesItsPicturesBack) {
  const SpriteSheet sprites = seven();
  for (const bool power_of_two : {false, true}) {
    const Image sheet = decode_image(sprites.png(power_of_two, {}));
    const auto text = nlohmann::json::parse(sprites.json(power_of_two, "walk.png"));
    const std::vector<Image> images = unpacked(sheet, text);
    ASSERT_EQ(images.size(), 7U);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(images[static_cast<std::size_t>(i)], sprite(i)) << i;
    EXPECT_EQ(text["meta"]["size"]["w"], sheet.width);
    EXPECT_EQ(text["meta"]["image"], "walk.png");
  }
}

TEST(SpriteSheet, SidesArePowersOfTwoOnRequest) {
  const Image plain = decode_image(seven().png(false, {}));
  const Image padded = decode_image(seven().png(true, {}));
  EXPECT_EQ(padded.width & (padded.width - 1), 0);
  EXPECT_EQ(padded.height & (padded.height - 1), 0);
  EXPECT_GE(padded.width, plain.width);
  EXPECT_LT(padded.width, 2 * plain.width);
}

TEST(SpriteSheet, DurationsAddUp) {
  const SpriteSheet sprites = seven();
  const auto text = nlohmann::json::parse(sprites.json(false, "a.png"));
  int sum = 0;
  for (const auto& item : text["frames"]) sum += item["duration"].get<int>();
  EXPECT_EQ(sum, 292) << "7 / 24 s";
}

TEST(SpriteSheet, RefusesMoreThanAPictureMayBe) {
  SpriteSheet sheet(24);
  Image large(6000, 6000);
  std::ranges::fill(large.pixels, std::uint8_t{255});
  sheet.add(large);
  sheet.add(large);
  EXPECT_ANY_THROW(sheet.add(large));
}

}  // namespace
}  // namespace foldless
