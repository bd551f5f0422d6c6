// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/film_output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "app/export/video_file.h"
#include "app/export/sprite_sheet.h"
#include "core/error.h"
#include "core/files/atomic_file.h"

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
  void finish() override { write_file_atomically(path_, film_->finish()); }

 private:
  fs::path path_;
  std::unique_ptr<Film> film_;
};

/// The pictures are written into a hidden folder beside it, which takes the name at the end.
class PictureFolder : public FilmOutput {
 public:
  PictureFolder(const fs::path& path, ImageTexts texts)
      : path_(named(path)), texts_(std::move(texts)) {
    std::error_code problem;
    if (fs::exists(path_) && !fs::is_empty(path_, problem))
      throw Error(path_.string() + ": is there already; name a new folder");
    std::string staged = path_.parent_path() / ("." + path_.filename().string() + ".XXXXXX");
    if (!mkdtemp(staged.data())) fail();
    staged_ = staged;
    fs::permissions(staged_, fs::perms(0755), fs::perm_options::replace, problem);
  }
  ~PictureFolder() override {
    std::error_code ignored;
    if (!staged_.empty()) fs::remove_all(staged_, ignored);
  }

  void add(const Image& image) override {
    std::string number = std::to_string(count_++);
    number.insert(0, 6 - std::min<std::size_t>(6, number.size()), '0');
    save_png(staged_ / (number + ".png"), image, texts_);
  }

  void finish() override {
    if (std::rename(staged_.c_str(), path_.c_str()) != 0) fail();
    staged_.clear();
    sync_folder(path_.parent_path());
  }

 private:
  /// `folder/` is `folder`.
  static fs::path named(const fs::path& path) {
    const fs::path whole = fs::absolute(path).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
  }
  [[noreturn]] void fail() const {
    throw Error(path_.string() + ": cannot be written: " + std::strerror(errno));
  }

  fs::path path_, staged_;
  ImageTexts texts_;
  int count_ = 0;
};

/// Two files: NAME.json and the picture NAME.png that it speaks of.
class SheetFiles : public FilmOutput {
 public:
  SheetFiles(fs::path path, const FilmOptions& options)
      : path_(checked(std::move(path))), options_(options), sprites_(options.fps) {}

  void add(const Image& image) override { sprites_.add(image); }
  void finish() override {
    const Image sheet = sprites_.sheet(options_.power_of_two);
    const fs::path picture = picture_of_sheet(path_);
    save_png(picture, sheet, options_.texts);
    write_file_atomically(path_, sprites_.json(sheet, picture.filename().string()));
  }

 private:
  fs::path path_;
  FilmOptions options_;
  SpriteSheet sprites_;
};

}  // namespace

fs::path picture_of_sheet(const fs::path& path) { return fs::path(path).replace_extension(".png"); }

std::unique_ptr<FilmOutput> film_output(const fs::path& path, const FilmOptions& options) {
  const std::string ending = path.extension();
  if (ending == ".json") return std::make_unique<SheetFiles>(path, options);
  if (ending == ".png") return std::make_unique<FilmFile>(path, make_apng(options));
  if (ending == ".gif") return std::make_unique<FilmFile>(path, make_gif(options));
  if (ending == ".webp") return std::make_unique<FilmFile>(path, make_animated_webp(options));
  if (is_video(path)) return video_file(checked(path), options);
  return std::make_unique<PictureFolder>(path, options.texts);
}

}  // namespace foldless
