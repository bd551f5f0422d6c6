// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/file_stamp.h"
#include "core/run/latest_job.h"
#include "render/texture_pieces.h"

namespace foldless {

/// The image of a document's texture, read on a thread of its own.
class TextureImage {
 public:
  /// `wake` is called on that thread when poll() has news.
  explicit TextureImage(std::function<void()> wake = {});

  using Parts = std::shared_ptr<const MeshParts>;

  /// The file that is wanted from now on, and of which mesh it is the texture; empty: none. Reading
  /// begins when either is another.
  void follow(const std::filesystem::path& file, const Parts& parts);
  /// The image of a file that was read already, when it had this stamp.
  void adopt(const std::filesystem::path& file, const Parts& parts,
             std::shared_ptr<const TexturePieces> image, const std::optional<FileStamp>& stamp);
  /// Reads the file again when it has changed since; `always`: in any case. The image stays as it
  /// is until the new one is there, and where that cannot be read.
  void refresh(bool always = false);
  /// Takes what was read; returns whether there was anything new.
  bool poll();

  /// Null while there is none: nothing is wanted, it is being read, or it cannot be.
  const std::shared_ptr<const TexturePieces>& image() const { return image_; }
  /// What the file was like before it was read.
  const std::optional<FileStamp>& stamp() const { return stamp_; }
  /// What was read last came by refresh().
  bool is_refreshed() const { return is_refreshed_; }
  /// Why the file cannot be read; empty: it can, or nobody knows yet.
  const std::string& problem() const { return problem_; }
  /// What of the image is missing, one sentence each.
  const std::vector<std::string>& notices() const { return notices_; }
  /// True from follow() until poll() has the image or the problem.
  bool is_reading() const { return is_reading_; }

 private:
  struct Result {
    int request = 0;
    LoadedTexture texture;
    std::string problem;
  };

  void start();
  void read(int request, const std::filesystem::path& file, const Parts& parts,
            const std::stop_token& stop);

  std::function<void()> wake_;
  std::filesystem::path file_;
  Parts parts_;
  int request_ = 0;  ///< results of earlier ones are dropped
  std::shared_ptr<const TexturePieces> image_;
  std::vector<std::string> notices_;
  std::string problem_;
  std::optional<FileStamp> stamp_;
  bool is_reading_ = false;
  bool is_refreshing_ = false;
  bool is_refreshed_ = false;
  std::mutex mutex_;  ///< of what follows
  std::optional<Result> result_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
