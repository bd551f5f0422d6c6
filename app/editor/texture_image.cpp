// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/texture_image.h"

#include <exception>
#include <utility>

#include "core/exception_words.h"

namespace foldless {

TextureImage::TextureImage(std::function<void()> wake) : wake_(std::move(wake)) {}

void TextureImage::follow(const std::filesystem::path& file, const Parts& parts) {
  if (file == file_ && parts == parts_) return;
  adopt(file, parts, nullptr, stamp_of(file));
  is_reading_ = !file.empty();
  if (is_reading_) start();
}

void TextureImage::refresh(bool always) {
  if (file_.empty() || is_reading_ || is_refreshing_) return;
  const std::optional<FileStamp> stamp = stamp_of(file_);
  // A file that is being replaced may be gone for a moment.
  if (!stamp || (stamp == stamp_ && !always)) return;
  stamp_ = stamp;
  is_refreshing_ = true;
  start();
}

void TextureImage::start() {
  job_.start([this, request = ++request_, file = file_,
              parts = parts_](const std::stop_token& stop) { read(request, file, parts, stop); });
}

void TextureImage::adopt(const std::filesystem::path& file, const Parts& parts,
                         std::shared_ptr<const TexturePieces> image,
                         const std::optional<FileStamp>& stamp) {
  job_.cancel();
  ++request_;
  file_ = file;
  parts_ = parts;
  image_ = std::move(image);
  notices_.clear();
  problem_.clear();
  stamp_ = stamp;
  is_reading_ = is_refreshing_ = is_refreshed_ = false;
}

bool TextureImage::poll() {
  std::optional<Result> result;
  {
    const std::lock_guard lock(mutex_);
    result = std::exchange(result_, std::nullopt);
  }
  if (!result || result->request != request_) return false;
  is_refreshed_ = is_refreshing_;
  if (result->texture.pieces || !is_refreshed_) image_ = std::move(result->texture.pieces);
  notices_ = std::move(result->texture.notices);
  problem_ = std::move(result->problem);
  is_reading_ = is_refreshing_ = false;
  return true;
}

void TextureImage::read(int request, const std::filesystem::path& file, const Parts& parts,
                        const std::stop_token& stop) {
  Result result{request, {}, {}};
  try {
    result.texture = load_texture(file, parts.get());
  } catch (const std::exception& failure) {
    result.problem = words_of_exception(failure, file);
  }
  if (stop.stop_requested()) return;
  {
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
  }
  if (wake_) wake_();
}

}  // namespace foldless
