// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/texture_image.h"

#include <exception>
#include <utility>

namespace foldless {

TextureImage::TextureImage(std::function<void()> wake) : wake_(std::move(wake)) {}

void TextureImage::follow(const std::filesystem::path& file, const Parts& parts) {
  if (file == file_ && parts == parts_) return;
  adopt(file, parts, nullptr);
  is_reading_ = !file.empty();
  if (!is_reading_) return;
  job_.start([this, request = request_, file, parts](const std::stop_token& stop) {
    read(request, file, parts, stop);
  });
}

void TextureImage::adopt(const std::filesystem::path& file, const Parts& parts,
                         std::shared_ptr<const TexturePieces> image) {
  job_.cancel();
  ++request_;
  file_ = file;
  parts_ = parts;
  image_ = std::move(image);
  notices_.clear();
  problem_.clear();
  is_reading_ = false;
}

bool TextureImage::poll() {
  std::optional<Result> result;
  {
    const std::lock_guard lock(mutex_);
    result = std::exchange(result_, std::nullopt);
  }
  if (!result || result->request != request_ || !is_reading_) return false;
  image_ = std::move(result->texture.pieces);
  notices_ = std::move(result->texture.notices);
  problem_ = std::move(result->problem);
  is_reading_ = false;
  return true;
}

void TextureImage::read(int request, const std::filesystem::path& file, const Parts& parts,
                        const std::stop_token& stop) {
  Result result{request, {}, {}};
  try {
    result.texture = load_texture(file, parts.get());
  } catch (const std::bad_alloc&) {
    result.problem = file.string() + ": there is not enough memory for this image";
  } catch (const std::exception& failure) {
    result.problem = failure.what();
  }
  if (stop.stop_requested()) return;
  {
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
  }
  if (wake_) wake_();
}

}  // namespace foldless
