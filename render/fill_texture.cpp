// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/fill_texture.h"

#include <string>

#include "core/error.h"

namespace foldless {
namespace {

/// Filtering straight alpha would bring in the colour of transparent pixels: a dark or bright seam.
std::vector<std::uint8_t> premultiplied(const Image& image) {
  std::vector<std::uint8_t> pixels = image.pixels;
  for (std::size_t p = 0; p < pixels.size(); p += 4)
    for (std::size_t c = 0; c < 3; ++c)
      pixels[p + c] = static_cast<std::uint8_t>((pixels[p + c] * pixels[p + 3] + 127) / 255);
  return pixels;
}

void check_size(const Image& image) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (image.width < 1 || image.height < 1) throw Error("the texture image is empty");
  if (image.width > limit || image.height > limit)
    throw Error("the texture image has " + std::to_string(image.width) + " x " +
                std::to_string(image.height) + " pixels; use one of at most " +
                std::to_string(limit) + " a side");
}

}  // namespace

FillTexture::FillTexture(const Image& image) {
  check_size(image);
  const std::vector<std::uint8_t> pixels = premultiplied(image);
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace foldless
