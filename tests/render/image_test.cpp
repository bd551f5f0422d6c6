// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>
#include <webp/encode.h>

#include <array>
#include <memory>
#include <random>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/png_chunks.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

using test::error_of;
using test::TemporaryFolder;

Image random_image(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image(width, height);
  for (auto& byte : image.pixels) byte = static_cast<std::uint8_t>(random());
  return image;
}

/// Opaque and smooth, so that JPEG keeps it nearly as it is.
Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = image.at(x, y);
      pixel[0] = static_cast<std::uint8_t>(255 * x / width);
      pixel[1] = static_cast<std::uint8_t>(255 * y / height);
      pixel[2] = 90;
      pixel[3] = 255;
    }
  return image;
}

int largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  return largest;
}

std::string jpeg_of(const Image& image, int pixel_format = TJPF_RGBA) {
  void* encoder = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder, image.pixels.data(), image.width, 0, image.height, pixel_format, &bytes,
              &size, TJSAMP_444, 95, 0);
  std::string file(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(encoder);
  return file;
}

std::string webp_of(const Image& image) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(image.pixels.data(), image.width, image.height,
                                                  4 * image.width, &bytes);
  std::string file(reinterpret_cast<char*>(bytes), size);
  WebPFree(bytes);
  return file;
}

TEST(Image, ReadsAJpegForPrint) {
  const TemporaryFolder folder;
  Image inks(8, 8);
  for (std::size_t p = 0; p < inks.pixels.size(); p += 4)
    for (std::size_t c = 0; c < 4; ++c)
      inks.pixels[p + c] = std::array<std::uint8_t, 4>{250, 100, 0, 128}[c];
  const Image image = load_image(folder.write("print.jpg", jpeg_of(inks, TJPF_CMYK)));
  const std::uint8_t* pixel = image.at(4, 4);
  EXPECT_NEAR(pixel[0], 125, 4);
  EXPECT_NEAR(pixel[1], 50, 4);
  EXPECT_NEAR(pixel[2], 0, 4);
  EXPECT_EQ(pixel[3], 255);
}

TEST(Image, PngKeepsEveryByte) {
  const TemporaryFolder folder;
  const Image image = random_image(37, 21, 5);
  save_png(folder / "a.png", image);
  EXPECT_EQ(load_image(folder / "a.png"), image);
}

TEST(Image, PngKeepsItsTexts) {
  const TemporaryFolder folder;
  const ImageTexts texts{
      {"Scene", "Köln ∇E"}, {"Iteration", "17"}, {"Energy", "0.1250"}, {"E", ""}};
  const Image image = random_image(3, 4, 6);
  save_png(folder / "a.png", image, texts);
  EXPECT_EQ(read_png_texts(folder / "a.png"), texts);
  EXPECT_EQ(load_image(folder / "a.png"), image);
}

TEST(Image, SaveReplacesTheFileAsAWhole) {
  const TemporaryFolder folder;
  save_png(folder / "a.png", random_image(50, 50, 7));
  EXPECT_THROW(save_png(folder / "a.png", Image{}), Error);
  EXPECT_EQ(load_image(folder / "a.png"), random_image(50, 50, 7));
}

TEST(Image, ReadsJpeg) {
  const TemporaryFolder folder;
  const Image image = gradient(64, 48);
  const Image loaded = load_image(folder.write("a.jpg", jpeg_of(image)));
  ASSERT_EQ(loaded.width, 64);
  ASSERT_EQ(loaded.height, 48);
  EXPECT_LE(largest_difference(loaded, image), 6);
}

TEST(Image, ReadsWebpWithItsAlpha) {
  const TemporaryFolder folder;
  Image image = gradient(30, 20);
  image.at(3, 4)[3] = 100;
  EXPECT_EQ(load_image(folder.write("a.webp", webp_of(image))), image);
}

TEST(Image, TheFirstBytesTellTheFormatNotTheName) {
  const TemporaryFolder folder;
  const Image image = random_image(5, 5, 8);
  EXPECT_EQ(load_image(folder.write("a.jpg", encode_png(image))), image);
}

TEST(Image, RefusesWhatIsNoImageAndNamesTheFile) {
  const TemporaryFolder folder;
  const auto file = folder.write("mesh.obj", "v 0 0 0\n");
  EXPECT_EQ(error_of([&] { load_image(file); }),
            file.string() + ": is not a PNG, JPEG, WebP or GIF image");
  EXPECT_NE(error_of([&] { load_image(folder / "absent.png"); }), "");
  EXPECT_NE(error_of([&] { read_png_texts(file); }), "");
}

TEST(Image, RefusesEveryFileThatWasCutShort) {
  const TemporaryFolder folder;
  const Image image = gradient(24, 24);
  for (const std::string& whole : {encode_png(image), jpeg_of(image), webp_of(image)})
    for (const std::size_t kept : {whole.size() / 8, whole.size() / 2, whole.size() * 3 / 4}) {
      const auto file = folder.write("cut", whole.substr(0, kept));
      EXPECT_NE(error_of([&] { load_image(file); }), "") << kept << " bytes of " << whole.size();
    }
}

TEST(Image, RefusesASizeBeforeItAsksForMemory) {
  const TemporaryFolder folder;
  std::string file = encode_png(random_image(2, 2, 9));
  file[18] = '\x7F';  // width 2 + 0x7F00
  EXPECT_NE(error_of([&] { load_image(folder.write("a.png", file)); }), "");
}

TEST(Image, IgnoresChunksThatArePromisedAndNotThere) {
  const TemporaryFolder folder;
  const Image image = random_image(3, 2, 4);
  const std::string whole = encode_png(image);
  const std::size_t header_end = 33;
  for (const char* type : {"zTXt", "iCCP", "tEXt", "eXIf"}) {
    const std::string promise = std::string("\x7F\xFF\xFF\xFF", 4) + type;
    const auto cut = folder.write("cut.png", whole.substr(0, header_end) + promise + "abc");
    EXPECT_NE(error_of([&] { load_image(cut); }), "") << type;
    const std::string extra = png_chunk({type, "nonsense"});
    std::string with = whole;
    with.insert(header_end, extra);
    EXPECT_EQ(load_image(folder.write("with.png", with)), image) << type;
  }
}

TEST(Image, RefusesMoreThanAHundredMillionPixels) {
  const TemporaryFolder folder;
  std::string file = jpeg_of(random_image(2, 2, 9));
  const std::size_t frame = file.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  file.replace(frame + 5, 4, "\x2E\xE0\x2E\xE0");  // 12000 x 12000
  EXPECT_NE(error_of([&] { load_image(folder.write("a.jpg", file)); }).find("100000000 in all"),
            std::string::npos);
}

TEST(Image, RandomBytesAfterAHeaderNeverCrash) {
  constexpr unsigned seed = 11;
  SCOPED_TRACE(seed);
  const TemporaryFolder folder;
  std::mt19937 random(seed);
  const Image image = gradient(16, 16);
  for (const std::string& whole : {encode_png(image), jpeg_of(image), webp_of(image)})
    for (int trial = 0; trial < 40; ++trial) {
      std::string damaged = whole;
      for (int i = 0; i < 4; ++i)
        damaged[8 + random() % (damaged.size() - 8)] = static_cast<char>(random());
      const auto file = folder.write("damaged", damaged);
      try {
        const Image loaded = load_image(file);
        EXPECT_EQ(loaded.pixels.size(), 4U * static_cast<unsigned>(loaded.width * loaded.height));
      } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": "));
      }
    }
}

}  // namespace
}  // namespace foldless
