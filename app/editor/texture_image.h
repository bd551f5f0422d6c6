// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/run/latest_job.h"
#include "render/texture_levels.h"

namespace foldless {

/// The image of a document's texture, read on a thread of its own.
class TextureImage {
 public:
  /// `wake` is called on that thread when poll() has news.
  explicit TextureImage(std::function<void()> wake = {});

  /// The file that is wanted from now on; empty: none. Reading begins when it is another.
  void follow(const std::filesystem::path& file);
  /// The image of a file that was read already.
  void adopt(const std::filesystem::path& file, std::shared_ptr<const TextureLevels> image);
  /// Takes what was read; returns whether there was anything new.
  bool poll();

  /// Null while there is none: nothing is wanted, it is being read, or it cannot be.
  const std::shared_ptr<const TextureLevels>& image() const { return image_; }
  /// Why the file cannot be read; empty: it can, or nobody knows yet.
  const std::string& problem() const { return problem_; }
  /// True from follow() until poll() has the image or the problem.
  bool is_reading() const { return is_reading_; }

 private:
  struct Result {
    std::filesystem::path file;
    std::shared_ptr<const TextureLevels> image;
    std::string problem;
  };

  static Result read(const std::filesystem::path& file);

  std::function<void()> wake_;
  std::filesystem::path file_;
  std::shared_ptr<const TextureLevels> image_;
  std::string problem_;
  bool is_reading_ = false;
  std::mutex mutex_;  ///< of what follows
  std::optional<Result> result_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
