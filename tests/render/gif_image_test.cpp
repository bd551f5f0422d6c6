// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gif_image.h"

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "core/error.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

using test::error_of;

constexpr std::array<GifColorType, 4> kGifColours{
    {{9, 8, 7}, {250, 0, 0}, {0, 240, 0}, {0, 0, 230}}};

/// A frame of a GIF whose pixel (x, y) has the colour (x + y) % 4.
struct GifFrame {
  int left = 0, top = 0, width = 0, height = 0;
  bool is_interlaced = false;
  int transparent = NO_TRANSPARENT_COLOR;
};

/// Written by giflib itself.
class GifFile {
 public:
  GifFile(int width, int height) {
    gif_ = EGifOpen(this, write, nullptr);
    ColorMapObject* const map = GifMakeMapObject(4, kGifColours.data());
    EGifPutScreenDesc(gif_, width, height, 2, 0, map);
    GifFreeMapObject(map);
  }
  void add(const GifFrame& frame) {
    GraphicsControlBlock control{};
    control.TransparentColor = frame.transparent;
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, bytes.size(), bytes.data());
    EGifPutImageDesc(gif_, frame.left, frame.top, frame.width, frame.height, frame.is_interlaced,
                     nullptr);
    const auto rows = frame.is_interlaced
                          ? std::vector<std::pair<int, int>>{{0, 8}, {4, 8}, {2, 4}, {1, 2}}
                          : std::vector<std::pair<int, int>>{{0, 1}};
    for (const auto& [first, step] : rows)
      for (int y = first; y < frame.height; y += step) {
        std::vector<GifPixelType> row(static_cast<std::size_t>(frame.width));
        for (int x = 0; x < frame.width; ++x)
          row[static_cast<std::size_t>(x)] = static_cast<GifPixelType>((x + y) % 4);
        EGifPutLine(gif_, row.data(), frame.width);
      }
  }
  std::string finish() {
    EGifCloseFile(gif_, nullptr);
    return bytes_;
  }

 private:
  static int write(GifFileType* gif, const GifByteType* bytes, int count) {
    static_cast<GifFile*>(gif->UserData)
        ->bytes_.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
  }
  GifFileType* gif_ = nullptr;
  std::string bytes_;
};

std::string gif_of(const GifFrame& frame, int width, int height) {
  GifFile file(width, height);
  file.add(frame);
  return file.finish();
}

std::array<int, 4> colour_at(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.at(x, y);
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

TEST(GifImage, IsTheFirstPictureOfAFilm) {
  GifFile film(5, 4);
  film.add({.width = 5, .height = 4});
  film.add({.left = 1, .top = 1, .width = 2, .height = 2});
  const Image image = decode_image(film.finish());
  ASSERT_EQ(image.width, 5);
  ASSERT_EQ(image.height, 4);
  EXPECT_EQ(colour_at(image, 0, 0), (std::array{9, 8, 7, 255}));
  EXPECT_EQ(colour_at(image, 1, 1), (std::array{0, 240, 0, 255}));
  EXPECT_EQ(colour_at(image, 4, 3), (std::array{0, 0, 230, 255}));
}

TEST(GifImage, IsTransparentWhereItSaysSoAndWhereNothingIs) {
  const GifFrame frame{.left = 2, .top = 1, .width = 4, .height = 4, .transparent = 1};
  const Image image = decode_image(gif_of(frame, 8, 6));
  EXPECT_EQ(colour_at(image, 0, 0)[3], 0) << "beside the frame";
  EXPECT_EQ(colour_at(image, 3, 1)[3], 0) << "the transparent colour";
  EXPECT_EQ(colour_at(image, 2, 1), (std::array{9, 8, 7, 255}));
}

TEST(GifImage, HasItsRowsInOrderWhereTheyAreInterlaced) {
  const GifFrame plain{.width = 7, .height = 19};
  GifFrame interlaced = plain;
  interlaced.is_interlaced = true;
  EXPECT_EQ(decode_image(gif_of(interlaced, 7, 19)), decode_image(gif_of(plain, 7, 19)));
}

TEST(GifImage, IsCutWhereItLeavesItsCanvas) {
  const Image image = decode_image(gif_of({.left = 3, .top = 2, .width = 9, .height = 9}, 5, 4));
  EXPECT_EQ(image.width, 5);
  EXPECT_EQ(colour_at(image, 4, 3), (std::array{0, 240, 0, 255}));
}

TEST(GifImage, RefusesASizeBeforeItAsksForMemory) {
  std::string file = gif_of({.width = 2, .height = 2}, 2, 2);
  file.replace(6, 4, "\xFF\x3F\xFF\x3F");  // 16383 x 16383
  EXPECT_NE(error_of([&] { decode_image(file); }).find("in all or less"), std::string::npos);
}

TEST(GifImage, RefusesWhatWasCutShort) {
  const std::string whole = gif_of({.width = 40, .height = 40}, 40, 40);
  for (const std::size_t kept : {std::size_t{6}, whole.size() / 8, whole.size() / 2})
    EXPECT_NE(error_of([&] { decode_image(whole.substr(0, kept)); }), "") << kept;
}

TEST(GifImage, RefusesAFilmWithoutPictures) {
  EXPECT_NE(error_of([] { decode_image(GifFile(3, 3).finish()); }), "");
}

TEST(GifImage, RandomBytesAfterAHeaderNeverCrash) {
  constexpr unsigned seed = 12;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::string whole = gif_of({.width = 16, .height = 16, .transparent = 2}, 16, 16);
  for (int trial = 0; trial < 200; ++trial) {
    std::string damaged = whole;
    for (int i = 0; i < 4; ++i)
      damaged[10 + random() % (damaged.size() - 10)] = static_cast<char>(random());
    try {
      const Image image = decode_image(damaged);
      EXPECT_EQ(image.pixels.size(), 4U * static_cast<unsigned>(image.width * image.height));
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace foldless
