// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/fill_texture.h"

#include <algorithm>
#include <string>
#include <utility>

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

FillTexture::FillTexture(std::shared_ptr<const TextureLevels> levels, Beyond beyond)
    : levels_(std::move(levels)) {
  check_size(*levels_);
  bind();
  // Before the image, so that room for the mipmaps is made with it and not in a second copy.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  GLint level = 0;
  for (const Image& image : *levels_)
    glTexImage2D(GL_TEXTURE_2D, level++, GL_RGBA8, image.width, image.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  // The colour of a border is transparent unless another is set.
  const GLint wrap = beyond == Beyond::edge ? GL_CLAMP_TO_EDGE : GL_CLAMP_TO_BORDER;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  glBindTexture(GL_TEXTURE_2D, 0);
  level_ = levels_->size() - 1;
  upload(1);
}

std::size_t FillTexture::upload(std::size_t pixels) {
  std::size_t done = 0;
  bind();
  while (levels_ && done < pixels) {
    const Image& image = (*levels_)[level_];
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t wanted = std::max<std::size_t>(1, (pixels - done) / width);
    const int rows =
        std::min(static_cast<int>(std::min<std::size_t>(wanted, 1U << 20U)), image.height - rows_);
    upload_rows(rows);
    done += width * static_cast<std::size_t>(rows);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  return done;
}

/// A level is seen once it is whole.
void FillTexture::upload_rows(int rows) {
  const Image& image = (*levels_)[level_];
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(level_), 0, rows_, image.width, rows, GL_RGBA,
                  GL_UNSIGNED_BYTE, image.at(0, rows_));
  rows_ += rows;
  if (rows_ < image.height) return;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, static_cast<GLint>(level_));
  rows_ = 0;
  if (level_ == 0)
    levels_.reset();
  else
    --level_;
}

}  // namespace foldless
