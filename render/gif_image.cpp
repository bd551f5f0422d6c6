// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gif_image.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "core/error.h"
#include "render/late_gif.h"

namespace foldless {
namespace {

[[noreturn]] void complain_of_gif(int problem) {
  const char* const words = GifErrorString(problem);
  throw Error(std::string("the GIF image is damaged (") + (words ? words : "it ends too soon") +
              ")");
}

/// Reads from memory, picture by picture: DGifSlurp() would take memory for all of a film.
class GifReader {
 public:
  explicit GifReader(std::string_view file) : rest_(file) {
    int problem = 0;
    gif_ = DGifOpen(this, read, &problem);
    if (!gif_) complain_of_gif(problem);
  }
  ~GifReader() { DGifCloseFile(gif_, nullptr); }
  GifReader(const GifReader&) = delete;
  GifReader& operator=(const GifReader&) = delete;

  Image first_picture() {
    check_image_size(gif_->SWidth, gif_->SHeight);
    go_to_picture();
    check_image_size(gif_->Image.Width, gif_->Image.Height);
    Image image(gif_->SWidth, gif_->SHeight);
    if (!gif_->Image.Interlace) {
      read_rows(image, 0, 1);
      return image;
    }
    for (const auto& [first, step] : {std::pair{0, 8}, {4, 8}, {2, 4}, {1, 2}})
      read_rows(image, first, step);
    return image;
  }

 private:
  static int read(GifFileType* gif, GifByteType* bytes, int count) {
    std::string_view& rest = static_cast<GifReader*>(gif->UserData)->rest_;
    const std::size_t taken = std::min(rest.size(), static_cast<std::size_t>(count));
    std::memcpy(bytes, rest.data(), taken);
    rest.remove_prefix(taken);
    return static_cast<int>(taken);
  }

  void expect(int result) const {
    if (result == GIF_ERROR) complain_of_gif(gif_->Error);
  }

  void go_to_picture() {
    for (GifRecordType kind = UNDEFINED_RECORD_TYPE;;) {
      expect(DGifGetRecordType(gif_, &kind));
      if (kind == TERMINATE_RECORD_TYPE) throw Error("the GIF image has no picture");
      if (kind == EXTENSION_RECORD_TYPE) read_extension();
      if (kind == IMAGE_DESC_RECORD_TYPE) return expect(DGifGetImageDesc(gif_));
    }
  }

  void read_extension() {
    int code = 0;
    GifByteType* block = nullptr;  // its length, and its bytes
    expect(DGifGetExtension(gif_, &code, &block));
    GraphicsControlBlock control{};
    if (code == GRAPHICS_EXT_FUNC_CODE && block &&
        DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK)
      transparent_ = control.TransparentColor;
    while (block) expect(DGifGetExtensionNext(gif_, &block));
  }

  void read_rows(Image& image, int first, int step) {
    const GifImageDesc& frame = gif_->Image;
    std::vector<GifPixelType> row(static_cast<std::size_t>(frame.Width));
    for (int y = first; y < frame.Height; y += step) {
      expect(DGifGetLine(gif_, row.data(), frame.Width));
      if (frame.Top + y < image.height) put_row(row, frame.Top + y, image);
    }
  }

  void put_row(const std::vector<GifPixelType>& row, int y, Image& image) const {
    const GifImageDesc& frame = gif_->Image;
    const ColorMapObject* const colours = frame.ColorMap ? frame.ColorMap : gif_->SColorMap;
    if (!colours) throw Error("the GIF image has no colours");
    const int width = std::min(frame.Width, image.width - frame.Left);
    for (int x = 0; x < width; ++x) {
      const int index = row[static_cast<std::size_t>(x)];
      if (index == transparent_) continue;
      if (index >= colours->ColorCount) throw Error("the GIF image has a colour that is not there");
      const GifColorType& colour = colours->Colors[index];
      const std::array<std::uint8_t, 4> pixel{colour.Red, colour.Green, colour.Blue, 255};
      std::ranges::copy(pixel, image.at(frame.Left + x, y));
    }
  }

  std::string_view rest_;
  GifFileType* gif_ = nullptr;
  int transparent_ = NO_TRANSPARENT_COLOR;
};

}  // namespace

bool is_gif(std::string_view file) {
  return file.starts_with("GIF87a") || file.starts_with("GIF89a");
}

Image decode_gif(std::string_view file) { return GifReader(file).first_picture(); }

}  // namespace foldless
