// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/fill_texture.h"

#include <algorithm>
#include <string>

#include "core/error.h"

namespace foldless {
namespace {

constexpr int kRowsAtATime = 64;

/// Rows of an image, their colours times their alpha: filtering straight alpha would bring in the
/// colour of transparent pixels, a dark or bright seam.
std::vector<std::uint8_t> premultiplied(const Image& image, int first_row, int end_row) {
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  const std::uint8_t* begin = image.at(0, first_row);
  std::vector<std::uint8_t> pixels(begin,
                                   begin + row * static_cast<std::size_t>(end_row - first_row));
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
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  // Before the image, so that room for the mipmaps is made with it and not in a second copy.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               nullptr);
  // Part by part: a picture may be large, and a premultiplied copy of it would be as large.
  for (int y = 0; y < image.height; y += kRowsAtATime) {
    const int end = std::min(y + kRowsAtATime, image.height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, y, image.width, end - y, GL_RGBA, GL_UNSIGNED_BYTE,
                    premultiplied(image, y, end).data());
  }
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace foldless
