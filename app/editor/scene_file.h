// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/file_stamp.h"

namespace foldless {

/// The file that a document is saved in, which other programs may have in use too: an editor that
/// has it open holds a shared lock on it, and a stamp tells when another program has written it.
class SceneFile {
 public:
  SceneFile() = default;
  ~SceneFile();
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;

  /// Empty: the document was never saved.
  const std::filesystem::path& path() const { return path_; }
  /// The document is what is in a file that had this stamp; nothing: of an unknown one.
  void take(const std::filesystem::path& path, const std::optional<FileStamp>& stamp);
  /// The document has no file.
  void leave();

  /// When it was taken another editor had it open, this one or a program of its own.
  bool is_shared() const { return is_shared_; }
  /// It is there, and not as it was when it was taken.
  bool has_changed() const;

 private:
  void lock();
  void unlock();

  std::filesystem::path path_;
  std::optional<FileStamp> stamp_;
  int lock_ = -1;  ///< a file descriptor
  bool is_shared_ = false;
};

}  // namespace foldless
