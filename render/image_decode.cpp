// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/gif_image.h"
#include "render/image.h"
#include "render/jpeg_scans.h"
#include "render/late_images.h"
#include "render/layered/layer_formats.h"
#include "render/png_chunks.h"

namespace foldless {
namespace {

constexpr int kLongestSide = 16384;
constexpr long kMostPixels = 100'000'000;

const unsigned char* bytes_of(std::string_view file) {
  return reinterpret_cast<const unsigned char*>(file.data());
}

/// The chunks that make the picture. For texts and profiles libpng takes as much memory as they ask
/// for, before it sees that they are not there or what they unpack to.
std::string without_extras(std::string_view file) {
  constexpr std::array<std::string_view, 7> kNeeded{"IHDR", "PLTE", "tRNS", "gAMA",
                                                    "sRGB", "IDAT", "IEND"};
  std::string needed(kPngSignature);
  std::size_t begin = kPngSignature.size(), end = begin;
  while (const auto chunk = next_png_chunk(file, end)) {
    if (std::ranges::find(kNeeded, chunk->type) != kNeeded.end())
      needed += file.substr(begin, end - begin);
    begin = end;
  }
  return needed;
}

/// Frees what libpng holds, whichever way the function is left. Throws Error where libpng is
/// missing, before there is anything to free.
struct PngReader {
  png_image image{};
  decltype(::png_image_free)* const free = png_image_free;
  PngReader() { image.version = PNG_IMAGE_VERSION; }
  ~PngReader() { free(&image); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

Image decode_png(std::string_view whole) {
  const std::string file = without_extras(whole);
  PngReader png;
  const auto damaged = [&] {
    return Error(std::string("the PNG image is damaged (") + png.image.message + ")");
  };
  if (!png_image_begin_read_from_memory(&png.image, file.data(), file.size())) throw damaged();
  check_image_size(png.image.width, png.image.height);
  png.image.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(png.image.width), static_cast<int>(png.image.height));
  if (!png_image_finish_read(&png.image, nullptr, image.pixels.data(), 0, nullptr)) throw damaged();
  return image;
}

struct DestroyJpeg {
  void operator()(void* handle) const { tjDestroy(handle); }
};

/// From cyan, magenta, yellow and black as printers' programs write them: 255 is no ink.
void convert_from_cmyk(Image& image) {
  for (std::size_t p = 0; p < image.pixels.size(); p += 4) {
    const int light = image.pixels[p + 3];
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[p + c] = static_cast<std::uint8_t>((image.pixels[p + c] * light + 127) / 255);
    image.pixels[p + 3] = 255;
  }
}

Image decode_jpeg(std::string_view file) {
  const std::unique_ptr<void, DestroyJpeg> jpeg(tjInitDecompress());
  const auto damaged = [&] {
    return Error(std::string("the JPEG image is damaged or of an unknown kind (") +
                 tjGetErrorStr2(jpeg.get()) + ")");
  };
  int width = 0, height = 0, subsampling = 0, colour_space = 0;
  if (tjDecompressHeader3(jpeg.get(), bytes_of(file), file.size(), &width, &height, &subsampling,
                          &colour_space) != 0)
    throw damaged();
  check_image_size(width, height);
  check_jpeg_scans(file, long{width} * height);
  Image image(width, height);
  const bool is_cmyk = colour_space == TJCS_CMYK || colour_space == TJCS_YCCK;
  if (tjDecompress2(jpeg.get(), bytes_of(file), file.size(), image.pixels.data(), width, 0, height,
                    is_cmyk ? TJPF_CMYK : TJPF_RGBA,
                    TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS | TJFLAG_STOPONWARNING) != 0)
    throw damaged();
  if (is_cmyk) convert_from_cmyk(image);
  return image;
}

Image decode_webp(std::string_view file) {
  int width = 0, height = 0;
  if (!WebPGetInfo(bytes_of(file), file.size(), &width, &height))
    throw Error("the WebP image is damaged");
  check_image_size(width, height);
  Image image(width, height);
  if (!WebPDecodeRGBAInto(bytes_of(file), file.size(), image.pixels.data(), image.pixels.size(),
                          4 * width))
    throw Error("the WebP image is damaged or an animation");
  return image;
}

bool is_webp(std::string_view file) {
  return file.starts_with("RIFF") && file.size() > 12 && file.substr(8, 4) == "WEBP";
}

}  // namespace

void check_image_size(long width, long height) {
  if (width < 1 || height < 1) throw Error("the image has no pixels");
  if (width > kLongestSide || height > kLongestSide)
    throw Error("the image has " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels; scale it down to " + std::to_string(kLongestSide) + " a side or less");
  if (width * height > kMostPixels)
    throw Error("the image has " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels; scale it down to " + std::to_string(kMostPixels) + " in all or less");
}

Image decode_image(std::string_view bytes) {
  if (bytes.starts_with(kPngSignature)) return decode_png(bytes);
  if (bytes.starts_with("\xFF\xD8\xFF")) return decode_jpeg(bytes);
  if (is_webp(bytes)) return decode_webp(bytes);
  if (is_gif(bytes)) return decode_gif(bytes);
  throw Error("is not a PNG, JPEG, WebP or GIF image");
}

Image load_image(const std::filesystem::path& path) {
  const std::string file = read_file(path);
  try {
    if (is_layered(file)) return decode_layered(file, LayeredParts::merged).merged;
    return decode_image(file);
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what());
  }
}

}  // namespace foldless
