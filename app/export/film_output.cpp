// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/film_output.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "app/export/animation_format.h"
#include "app/export/sprite_sheet.h"
#include "app/export/video_file.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/file_group.h"
#include "core/files/staged.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// The path of a file that can be made. Throws Error.
fs::path checked(fs::path path) {
  if (fs::is_directory(path)) throw Error(path.string() + ": is a folder");
  const fs::path parent = fs::absolute(path).parent_path();
  if (!fs::is_directory(parent))
    throw Error(path.string() + ": there is no folder " + parent.string());
  return path;
}

class FilmFile : public FilmOutput {
 public:
  FilmFile(fs::path path, std::unique_ptr<Film> film)
      : path_(checked(std::move(path))), film_(std::move(film)) {}

  bool wants_samples() const override { return film_->wants_samples(); }
  void sample(const Image& image) override { film_->sample(image); }
  void add(const Image& image) override { film_->add(image); }
  void finish() override {
    remove_leftovers(path_);
    write_file_atomically(path_, film_->finish());
  }

 private:
  fs::path path_;
  std::unique_ptr<Film> film_;
};

std::unique_ptr<Film> film(std::string_view ending, const FilmOptions& options) {
  if (ending == ".png" || ending == ".apng") return make_apng(options);
  if (ending == ".gif") return make_gif(options);
  return make_animated_webp(options);
}

/// The pictures are written into a hidden folder beside it, which takes the name at the end.
class PictureFolder : public FilmOutput {
 public:
  PictureFolder(const fs::path& path, ImageTexts texts)
      : path_(free(path)), texts_(std::move(texts)), staged_(path_, Staged::What::folder) {}

  void add(const Image& image) override {
    std::string number = std::to_string(count_++);
    number.insert(0, 6 - std::min<std::size_t>(6, number.size()), '0');
    const std::string name = number + ".png";
    write_new_file(staged_.path() / name, encode_png(image, texts_), path_ / name);
  }
  void finish() override { staged_.take_name(); }

 private:
  /// Without the slash of `folder/`. Throws Error where something is in it.
  static fs::path free(const fs::path& path) {
    fs::path whole = fs::absolute(path).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();
    std::error_code ignored;
    if (fs::exists(whole) && !fs::is_empty(whole, ignored))
      throw Error(whole.string() + ": is there already; name a new folder");
    return whole;
  }

  fs::path path_;
  ImageTexts texts_;
  Staged staged_;
  int count_ = 0;
};

/// Two files: NAME.json and the picture NAME.png that it speaks of.
class SheetFiles : public FilmOutput {
 public:
  SheetFiles(fs::path path, const FilmOptions& options)
      : path_(checked(std::move(path))), options_(options), sprites_(options.fps) {}

  void add(const Image& image) override { sprites_.add(image); }
  void finish() override {
    const std::string picture = picture_of_sheet(path_).filename();
    write_files_together(path_, sprites_.json(options_.power_of_two, picture),
                         {{picture, sprites_.png(options_.power_of_two, options_.texts)}});
  }

 private:
  fs::path path_;
  FilmOptions options_;
  SpriteSheet sprites_;
};

}  // namespace

fs::path picture_of_sheet(const fs::path& path) { return fs::path(path).replace_extension(".png"); }

std::unique_ptr<FilmOutput> film_output(const fs::path& path, const FilmOptions& options) {
  using Kind = AnimationFormat::Kind;
  const AnimationFormat* const format = find_animation_format(path);
  if (format && format->kind == Kind::sheet) return std::make_unique<SheetFiles>(path, options);
  if (format && format->kind == Kind::video) return video_file(checked(path), options);
  if (format && format->kind == Kind::film)
    return std::make_unique<FilmFile>(path, film(format->ending, options));
  return std::make_unique<PictureFolder>(path, options.texts);
}

}  // namespace foldless
