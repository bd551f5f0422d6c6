// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/fill_texture.h"

#include <string>

#include "core/error.h"

namespace foldless {
namespace {

void check_size(const TextureLevels& levels) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (levels.empty()) throw Error("the texture image is empty");
  const Image& image = levels.front();
  if (image.width > limit || image.height > limit)
    throw Error("the texture image has " + std::to_string(image.width) + " x " +
                std::to_string(image.height) + " pixels; use one of at most " +
                std::to_string(limit) + " a side");
}

}  // namespace

FillTexture::FillTexture(const TextureLevels& levels, Beyond beyond) {
  check_size(levels);
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  // Before the image, so that room for the mipmaps is made with it and not in a second copy.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  GLint level = 0;
  for (const Image& image : levels)
    glTexImage2D(GL_TEXTURE_2D, level++, GL_RGBA8, image.width, image.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, image.pixels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  // The colour of a border is transparent unless another is set.
  const GLint wrap = beyond == Beyond::edge ? GL_CLAMP_TO_EDGE : GL_CLAMP_TO_BORDER;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace foldless
