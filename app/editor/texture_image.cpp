// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/texture_image.h"

#include <exception>
#include <utility>

namespace foldless {

TextureImage::TextureImage(std::function<void()> wake) : wake_(std::move(wake)) {}

void TextureImage::follow(const std::filesystem::path& file) {
  if (file == file_) return;
  adopt(file, nullptr);
  is_reading_ = !file.empty();
  if (!is_reading_) return;
  job_.start([this, file](const std::stop_token& stop) {
    Result result = read(file);
    if (stop.stop_requested()) return;
    {
      const std::lock_guard lock(mutex_);
      result_ = std::move(result);
    }
    if (wake_) wake_();
  });
}

void TextureImage::adopt(const std::filesystem::path& file,
                         std::shared_ptr<const TextureLevels> image) {
  job_.cancel();
  file_ = file;
  image_ = std::move(image);
  problem_.clear();
  is_reading_ = false;
}

bool TextureImage::poll() {
  std::optional<Result> result;
  {
    const std::lock_guard lock(mutex_);
    result = std::exchange(result_, std::nullopt);
  }
  if (!result || result->file != file_ || !is_reading_) return false;
  image_ = std::move(result->image);
  problem_ = std::move(result->problem);
  is_reading_ = false;
  return true;
}

TextureImage::Result TextureImage::read(const std::filesystem::path& file) {
  try {
    return {file, std::make_shared<const TextureLevels>(texture_levels(load_image(file))), {}};
  } catch (const std::bad_alloc&) {
    return {file, nullptr, file.string() + ": there is not enough memory for this image"};
  } catch (const std::exception& failure) {
    return {file, nullptr, failure.what()};
  }
}

}  // namespace foldless
