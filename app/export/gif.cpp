// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "app/export/film.h"
#include "app/export/palette.h"
#include "core/error.h"
#include "render/late_gif.h"

namespace foldless {
namespace {

constexpr int kColours = 256;
constexpr std::uint8_t kNothing = kColours - 1;  ///< the index of what is transparent

/// A picture in colours of the palette.
struct Indexed {
  int width = 0, height = 0;
  std::vector<std::uint8_t> indices;

  std::uint8_t at(int x, int y) const {
    return indices[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
};

/// The pixels of [left, right) × [top, bottom).
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// All pictures have one palette, made of some of them. Of an opaque picture the part that differs
/// from the one before is drawn over it, what does not differ transparent; others are drawn whole,
/// and cleared away.
class Gif : public Film {
 public:
  explicit Gif(FilmOptions options) : options_(std::move(options)) {}
  ~Gif() override {
    if (gif_) EGifCloseFile(gif_, nullptr);
  }

  bool wants_samples() const override { return true; }
  void sample(const Image& image) override { colours_.add(image); }

  void add(const Image& image) override {
    if (!gif_) begin(image);
    const Indexed now = indexed(image);
    const PixelBox frame =
        before_ && !is_transparent_ ? what_differs(now) : PixelBox{0, 0, now.width, now.height};
    put_control();
    if (EGifPutImageDesc(gif_, frame.left, frame.top, frame.right - frame.left,
                         frame.bottom - frame.top, false, nullptr) == GIF_ERROR)
      fail();
    for (int y = frame.top; y < frame.bottom; ++y) put_line(now, frame, y);
    before_ = now;
    ++added_;
  }

  std::string finish() override {
    GifFileType* const gif = std::exchange(gif_, nullptr);
    int problem = 0;
    if (EGifCloseFile(gif, &problem) == GIF_ERROR) fail(problem);
    return std::move(file_);
  }

 private:
  static int write(GifFileType* gif, const GifByteType* bytes, int count) {
    static_cast<Gif*>(gif->UserData)
        ->file_.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
  }

  void begin(const Image& image) {
    if (std::max(image.width, image.height) > 65535)
      throw Error("GIF takes pictures of at most 65535 pixels a side");
    if (colours_.is_empty()) colours_.add(image);
    palette_.emplace(colours_, kColours - 1);
    for (std::size_t p = 3; p < image.pixels.size() && !is_transparent_; p += 4)
      is_transparent_ = image.pixels[p] < 128;
    int problem = 0;
    gif_ = EGifOpen(this, write, &problem);
    if (!gif_) fail(problem);
    EGifSetGifVersion(gif_, true);
    std::array<GifColorType, kColours> table{};
    for (std::size_t i = 0; i < palette_->colours().size(); ++i) {
      const Rgb& colour = palette_->colours()[i];
      table[i] = {colour[0], colour[1], colour[2]};
    }
    ColorMapObject* const map = GifMakeMapObject(kColours, table.data());
    if (!map) throw Error("not enough memory for a GIF");
    const bool is_good = EGifPutScreenDesc(gif_, image.width, image.height, 8, 0, map) == GIF_OK;
    GifFreeMapObject(map);
    if (!is_good) fail();
    if (options_.loops) put_loop();
  }

  /// For ever: the extension that all programs know.
  void put_loop() {
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    if (EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_ERROR ||
        EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") == GIF_ERROR ||
        EGifPutExtensionBlock(gif_, kForEver.size(), kForEver.data()) == GIF_ERROR ||
        EGifPutExtensionTrailer(gif_) == GIF_ERROR)
      fail();
  }

  void put_control() {
    GraphicsControlBlock control{};
    control.DisposalMode = is_transparent_ ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT;
    control.DelayTime = time_of(added_ + 1) - time_of(added_);
    control.TransparentColor = kNothing;
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    if (EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, bytes.size(), bytes.data()) == GIF_ERROR)
      fail();
  }

  /// Hundredths of a second: the frames of a rate that these do not divide are shown by turns a
  /// little longer and shorter.
  int time_of(std::size_t picture) const {
    return static_cast<int>(std::lround(100 * static_cast<double>(picture) / options_.fps));
  }

  Indexed indexed(const Image& image) const {
    Indexed result{image.width, image.height, {}};
    result.indices.reserve(image.pixels.size() / 4);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* p = image.at(x, y);
        result.indices.push_back(p[3] < 128 ? kNothing
                                            : palette_->dithered({p[0], p[1], p[2]}, x, y));
      }
    return result;
  }

  /// The smallest rectangle outside which the picture is as the one before; one pixel where all is.
  PixelBox what_differs(const Indexed& now) const {
    PixelBox frame{now.width, now.height, 0, 0};
    for (int y = 0; y < now.height; ++y)
      for (int x = 0; x < now.width; ++x) {
        if (now.at(x, y) == before_->at(x, y)) continue;
        frame = {std::min(frame.left, x), std::min(frame.top, y), std::max(frame.right, x + 1),
                 std::max(frame.bottom, y + 1)};
      }
    return frame.right > 0 ? frame : PixelBox{0, 0, 1, 1};
  }

  void put_line(const Indexed& now, const PixelBox& frame, int y) {
    line_.clear();
    for (int x = frame.left; x < frame.right; ++x) {
      const bool is_shown = before_ && !is_transparent_ && now.at(x, y) == before_->at(x, y);
      line_.push_back(is_shown ? kNothing : now.at(x, y));
    }
    if (EGifPutLine(gif_, line_.data(), static_cast<int>(line_.size())) == GIF_ERROR) fail();
  }

  [[noreturn]] void fail() const { fail(gif_->Error); }
  [[noreturn]] static void fail(int problem) {
    const char* const words = GifErrorString(problem);
    throw Error(std::string("the GIF cannot be made: ") + (words ? words : "unknown problem"));
  }

  FilmOptions options_;
  ColourCount colours_;
  std::optional<Palette> palette_;
  bool is_transparent_ = false;
  GifFileType* gif_ = nullptr;
  std::string file_;
  std::optional<Indexed> before_;
  std::vector<GifPixelType> line_;
  std::size_t added_ = 0;
};

}  // namespace

std::unique_ptr<Film> make_gif(const FilmOptions& options) {
  return std::make_unique<Gif>(options);
}

}  // namespace foldless
