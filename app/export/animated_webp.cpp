// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/export/film.h"
#include "app/export/late_webp.h"
#include "core/error.h"

namespace foldless {
namespace {

struct EncoderDeleter {
  void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};

/// A picture of the library's own kind, of an image.
class WebpPicture {
 public:
  explicit WebpPicture(const Image& image) {
    if (WebPPictureInitInternal(&picture_, WEBP_ENCODER_ABI_VERSION) == 0)
      throw Error("the WebP library is of another version");
    picture_.use_argb = 1;
    picture_.width = image.width;
    picture_.height = image.height;
    if (WebPPictureImportRGBA(&picture_, image.pixels.data(), 4 * image.width) == 0)
      throw Error("not enough memory for a WebP picture");
  }
  ~WebpPicture() { WebPPictureFree(&picture_); }
  WebpPicture(const WebpPicture&) = delete;
  WebpPicture& operator=(const WebpPicture&) = delete;

  WebPPicture* get() { return &picture_; }

 private:
  WebPPicture picture_{};
};

class AnimatedWebp : public Film {
 public:
  explicit AnimatedWebp(const FilmOptions& options) : options_(options) {
    if (WebPConfigInitInternal(&config_, WEBP_PRESET_DEFAULT, 75, WEBP_ENCODER_ABI_VERSION) == 0)
      throw Error("the WebP library is of another version");
    config_.lossless = 1;
    config_.quality = 50;  // Of a lossless picture: effort.
    config_.method = 3;
    config_.exact = 0;
  }

  void add(const Image& image) override {
    if (!encoder_) begin(image);
    WebpPicture picture(image);
    if (WebPAnimEncoderAdd(encoder_.get(), picture.get(), time_of(added_++), &config_) == 0) fail();
  }

  std::string finish() override {
    WebPData data{};
    if (WebPAnimEncoderAdd(encoder_.get(), nullptr, time_of(added_), nullptr) == 0 ||
        WebPAnimEncoderAssemble(encoder_.get(), &data) == 0)
      fail();
    std::string file(reinterpret_cast<const char*>(data.bytes), data.size);
    WebPFree(const_cast<std::uint8_t*>(data.bytes));
    return file;
  }

 private:
  void begin(const Image& image) {
    if (std::max(image.width, image.height) > WEBP_MAX_DIMENSION)
      throw Error("WebP takes pictures of at most " + std::to_string(WEBP_MAX_DIMENSION) +
                  " pixels a side");
    WebPAnimEncoderOptions options;
    if (WebPAnimEncoderOptionsInitInternal(&options, WEBP_MUX_ABI_VERSION) == 0)
      throw Error("the WebP library is of another version");
    options.anim_params.loop_count = options_.loops ? 0 : 1;
    options.anim_params.bgcolor = 0;
    encoder_.reset(
        WebPAnimEncoderNewInternal(image.width, image.height, &options, WEBP_MUX_ABI_VERSION));
    if (!encoder_) throw Error("not enough memory for an animated WebP");
  }

  /// [ms]
  int time_of(std::size_t picture) const {
    return static_cast<int>(std::lround(1000 * static_cast<double>(picture) / options_.fps));
  }

  [[noreturn]] void fail() const {
    throw Error(std::string("the animated WebP cannot be made: ") +
                WebPAnimEncoderGetError(encoder_.get()));
  }

  FilmOptions options_;
  WebPConfig config_{};
  std::unique_ptr<WebPAnimEncoder, EncoderDeleter> encoder_;
  std::size_t added_ = 0;
};

}  // namespace

std::unique_ptr<Film> make_animated_webp(const FilmOptions& options) {
  return std::make_unique<AnimatedWebp>(options);
}

}  // namespace foldless
