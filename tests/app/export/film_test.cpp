// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/film.h"

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "render/png_chunks.h"

namespace foldless {
namespace {

/// A disk that wanders over half a picture, its edge half transparent.
Image picture(int i) {
  Image image(60, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      const int dx = x - 10 - 4 * i, dy = y - 20, distance = dx * dx + dy * dy;
      std::uint8_t* p = image.at(x, y);
      const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
      if (distance < 64) p[0] = byte(200 + i), p[1] = byte(4 * x), p[2] = byte(6 * y), p[3] = 255;
      if (distance >= 64 && distance < 81) p[0] = 10, p[1] = 20, p[2] = 30, p[3] = 128;
    }
  return image;
}

constexpr int kCount = 9;

std::string film_of(std::unique_ptr<Film> film) {
  for (int i = 0; i < kCount; ++i) film->add(picture(i));
  return film->finish();
}

FilmOptions options(double fps, bool loops) { return {fps, loops, kCount, {{"Scene", "a disk"}}}; }

std::uint32_t u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// An APNG as it is played.
struct Played {
  std::vector<Image> pictures;
  std::vector<std::pair<int, int>> delays;  ///< numerator and denominator of seconds
  std::uint32_t promised = 0, plays = 0, sequence = 0;
  std::string ihdr;
};

void draw_part(Played& played, std::string_view control, const std::string& pixels) {
  std::string header(control.substr(4, 8));
  header += played.ihdr.substr(8);
  std::string png(kPngSignature);
  png += png_chunk({"IHDR", header}) + png_chunk({"IDAT", pixels}) + png_chunk({"IEND", ""});
  const Image part = decode_image(png);
  const int x0 = static_cast<int>(u32(control, 12)), y0 = static_cast<int>(u32(control, 16));
  Image whole = played.pictures.empty() ? Image(60, 40) : played.pictures.back();
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) std::memcpy(whole.at(x0 + x, y0 + y), part.at(x, y), 4);
  played.pictures.push_back(whole);
  const auto u16 = [&](std::size_t at) { return static_cast<int>(u32(control, at) >> 16); };
  played.delays.emplace_back(u16(20), static_cast<int>(u32(control, 20) & 0xFFFF));
}

Played played(const std::string& file) {
  Played result;
  std::size_t offset = kPngSignature.size();
  std::string control, pixels;
  const auto end_part = [&] {
    if (!control.empty()) draw_part(result, control, pixels);
    pixels.clear();
  };
  while (const auto chunk = next_png_chunk(file, offset)) {
    if (chunk->type == "IHDR") result.ihdr = chunk->data;
    if (chunk->type == "acTL") {
      result.promised = u32(chunk->data, 0);
      result.plays = u32(chunk->data, 4);
    }
    if (chunk->type == "fcTL") {
      end_part();
      control = chunk->data;
    }
    if (chunk->type == "IDAT") pixels += chunk->data;
    if (chunk->type == "fdAT") pixels += chunk->data.substr(4);
    if (chunk->type == "fcTL" || chunk->type == "fdAT") {
      EXPECT_EQ(u32(chunk->data, 0), result.sequence);
      ++result.sequence;
    }
  }
  end_part();
  return result;
}

TEST(Apng, IsPlayedAsItWasMade) {
  const Played film = played(film_of(make_apng(options(24, true))));
  EXPECT_EQ(film.promised, kCount);
  EXPECT_EQ(film.plays, 0U) << "for ever";
  ASSERT_EQ(film.pictures.size(), kCount);
  for (int i = 0; i < kCount; ++i) {
    EXPECT_EQ(film.pictures[static_cast<std::size_t>(i)], picture(i)) << i;
    EXPECT_EQ(film.delays[static_cast<std::size_t>(i)], std::pair(1, 24));
  }
}

TEST(Apng, OnceAndAtAnySpeed) {
  const Played film = played(film_of(make_apng(options(23.976, false))));
  EXPECT_EQ(film.plays, 1U);
  EXPECT_EQ(film.delays[3], std::pair(42, 1000));
}

TEST(Apng, ShowsItsFirstPictureToProgramsThatKnowPngAlone) {
  const std::string file = film_of(make_apng(options(24, true)));
  EXPECT_EQ(decode_image(file), picture(0));
  EXPECT_NE(file.find("a disk"), file.npos);
}

TEST(Apng, KeepsOnlyWhatDiffers) {
  const auto size_of = [](int distinct) {
    FilmOptions many = options(24, true);
    many.count = 20;
    const auto film = make_apng(many);
    for (int i = 0; i < 20; ++i) film->add(picture(std::min(i, distinct - 1)));
    return film->finish().size();
  };
  EXPECT_LT(size_of(1), encode_png(picture(0)).size() + 20 * 160);
  EXPECT_GT(size_of(8), size_of(1));
}

/// A GIF as it is played, opaque or with nothing where alpha is 0.
struct PlayedGif {
  std::vector<Image> pictures;
  std::vector<int> delays;  ///< hundredths of a second
  bool loops = false;
};

PlayedGif played_gif(const std::string& file) {
  struct Source {
    const std::string& bytes;
    std::size_t at = 0;
  } source{file};
  const auto read = [](GifFileType* gif, GifByteType* bytes, int count) {
    Source& from = *static_cast<Source*>(gif->UserData);
    const std::size_t n = std::min(static_cast<std::size_t>(count), from.bytes.size() - from.at);
    std::memcpy(bytes, from.bytes.data() + from.at, n);
    from.at += n;
    return static_cast<int>(n);
  };
  PlayedGif result;
  GifFileType* gif = DGifOpen(&source, read, nullptr);
  if (!gif || DGifSlurp(gif) == GIF_ERROR) return result;
  for (int k = 0; k < gif->SavedImages[0].ExtensionBlockCount; ++k)
    result.loops = result.loops ||
                   gif->SavedImages[0].ExtensionBlocks[k].Function == APPLICATION_EXT_FUNC_CODE;
  Image canvas(gif->SWidth, gif->SHeight);
  for (int i = 0; i < gif->ImageCount; ++i) {
    const SavedImage& saved = gif->SavedImages[i];
    GraphicsControlBlock control{};
    DGifSavedExtensionToGCB(gif, i, &control);
    const GifImageDesc& part = saved.ImageDesc;
    for (int y = 0; y < part.Height; ++y)
      for (int x = 0; x < part.Width; ++x) {
        const int index = saved.RasterBits[y * part.Width + x];
        if (index == control.TransparentColor) continue;
        const GifColorType& colour = gif->SColorMap->Colors[index];
        std::uint8_t* p = canvas.at(part.Left + x, part.Top + y);
        p[0] = colour.Red, p[1] = colour.Green, p[2] = colour.Blue, p[3] = 255;
      }
    result.pictures.push_back(canvas);
    result.delays.push_back(control.DelayTime);
    if (control.DisposalMode == DISPOSE_BACKGROUND) canvas = Image(gif->SWidth, gif->SHeight);
  }
  DGifCloseFile(gif, nullptr);
  return result;
}

std::string gif_of(const std::vector<Image>& pictures, const FilmOptions& film_options) {
  const auto film = make_gif(film_options);
  EXPECT_TRUE(film->wants_samples());
  for (const Image& image : pictures) film->sample(image);
  for (const Image& image : pictures) film->add(image);
  return film->finish();
}

/// On white, so that it is opaque; with few colours or many.
Image opaque_picture(int i, bool has_many_colours) {
  Image image = picture(i);
  for (std::size_t p = 0; p < image.pixels.size(); p += 4) {
    const std::size_t pixel = p / 4;
    if (has_many_colours) {
      image.pixels[p] = static_cast<std::uint8_t>(4 * (pixel % 60));
      image.pixels[p + 1] = static_cast<std::uint8_t>(6 * (pixel / 60));
      image.pixels[p + 2] = 60;
    } else if (image.pixels[p + 3] < 255) {
      image.pixels[p] = image.pixels[p + 1] = image.pixels[p + 2] = 250;
    } else {
      image.pixels[p] = image.pixels[p + 1] = 30;
      image.pixels[p + 2] = static_cast<std::uint8_t>(100 + i);
    }
    image.pixels[p + 3] = 255;
  }
  return image;
}

std::vector<Image> opaque_pictures(bool has_many_colours) {
  std::vector<Image> pictures;
  for (int i = 0; i < kCount; ++i) pictures.push_back(opaque_picture(i, has_many_colours));
  return pictures;
}

TEST(Gif, FewColoursAreExact) {
  const std::vector<Image> pictures = opaque_pictures(false);
  const PlayedGif film = played_gif(gif_of(pictures, options(25, true)));
  EXPECT_EQ(film.pictures, pictures);
  EXPECT_TRUE(film.loops);
  EXPECT_EQ(film.delays, std::vector<int>(kCount, 4));
  EXPECT_FALSE(played_gif(gif_of(pictures, options(25, false))).loops);
}

TEST(Gif, ARateThatHundredthsDoNotDivideIsKeptInTheMean) {
  const PlayedGif film = played_gif(gif_of(opaque_pictures(false), options(24, true)));
  EXPECT_EQ(std::accumulate(film.delays.begin(), film.delays.end(), 0), 38) << "9 / 24 s";
  for (const int delay : film.delays) EXPECT_TRUE(delay == 4 || delay == 5);
}

TEST(Gif, ManyColoursAreNearAndRightInTheMean) {
  const std::vector<Image> pictures = opaque_pictures(true);
  const PlayedGif film = played_gif(gif_of(pictures, options(25, true)));
  ASSERT_EQ(film.pictures.size(), pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    double sum = 0, absolute = 0;
    for (std::size_t p = 0; p < pictures[i].pixels.size(); ++p) {
      const int d = film.pictures[i].pixels[p] - pictures[i].pixels[p];
      sum += d;
      absolute += std::abs(d);
    }
    const auto count = static_cast<double>(pictures[i].pixels.size());
    EXPECT_LT(absolute / count, 8) << i;
    EXPECT_LT(std::abs(sum / count), 1) << i;
  }
}

TEST(Gif, WhatIsTransparentIsClearedAway) {
  std::vector<Image> pictures;
  for (int i = 0; i < kCount; ++i) pictures.push_back(picture(i));
  const PlayedGif film = played_gif(gif_of(pictures, options(25, true)));
  ASSERT_EQ(film.pictures.size(), pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t p = 3; p < pictures[i].pixels.size(); p += 4)
      ASSERT_EQ(film.pictures[i].pixels[p] == 255, pictures[i].pixels[p] >= 128) << i;
}

TEST(Gif, TheSamePicturesGiveTheSameBytes) {
  const std::vector<Image> pictures = opaque_pictures(true);
  EXPECT_EQ(gif_of(pictures, options(25, true)), gif_of(pictures, options(25, true)));
}

TEST(AnimatedWebp, IsPlayedAsItWasMade) {
  const std::string file = film_of(make_animated_webp(options(25, true)));
  const WebPData data{reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
  WebPAnimDecoderOptions decoding;
  ASSERT_NE(WebPAnimDecoderOptionsInit(&decoding), 0);
  decoding.color_mode = MODE_RGBA;
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, &decoding);
  ASSERT_NE(decoder, nullptr);
  WebPAnimInfo info;
  WebPAnimDecoderGetInfo(decoder, &info);
  EXPECT_EQ(info.frame_count, kCount);
  EXPECT_EQ(info.loop_count, 0U) << "for ever";
  std::uint8_t* pixels = nullptr;
  int end = 0, i = 0;
  while (WebPAnimDecoderGetNext(decoder, &pixels, &end) != 0) {
    const Image expected = picture(i++);
    EXPECT_EQ(end, 40 * i) << "milliseconds";
    for (std::size_t p = 0; p < expected.pixels.size(); p += 4) {
      ASSERT_EQ(pixels[p + 3], expected.pixels[p + 3]) << i;
      if (expected.pixels[p + 3] != 255) continue;
      ASSERT_EQ(std::memcmp(pixels + p, &expected.pixels[p], 3), 0) << i;
    }
  }
  EXPECT_EQ(i, kCount);
  WebPAnimDecoderDelete(decoder);
}

TEST(AnimatedWebp, RefusesWhatTheFormatCannotHold) {
  const auto film = make_animated_webp(options(25, true));
  EXPECT_ANY_THROW(film->add(Image(16384, 1)));
}

}  // namespace
}  // namespace foldless
