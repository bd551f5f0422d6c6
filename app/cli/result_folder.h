// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/cli/manifest.h"

namespace foldless {

/// Keeps other processes from taking the same lock while it lives.
class FolderLock {
 public:
  FolderLock() = default;
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False when another process has it.
  bool take(const std::filesystem::path& folder);

 private:
  int descriptor_ = -1;
};

/// A folder that is there while this lives, and afterwards when something was put into it.
class MadeFolder {
 public:
  /// Makes it, and those above it, where it is not there. Throws Error when it cannot be made.
  explicit MadeFolder(std::filesystem::path folder);
  /// Removes it where it was made and nothing is in it.
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

 private:
  std::filesystem::path folder_;
  bool was_made_;
};

/// The folder of a result, which is replaced as a whole.
///
/// Everything is written into `.foldless-staged` inside the folder first, with a manifest of what
/// is there. Renaming that to `.foldless-committed` makes it the result; its files then take their
/// names one by one, and the manifest is the last. So at every moment, power cuts included:
///   - without `.foldless-committed` the files that manifest.json names are one whole result;
///   - with it, a file in it is newer than that of the same name beside it, and its manifest
///   counts.
///     The next `solve` into the folder goes on from there.
/// Only files that a manifest names and that are as it says are ever replaced or removed, and what
/// is in these two folders.
class ResultFolder {
 public:
  /// Makes the folder where there is none, finishes or removes what a run that was killed left, and
  /// keeps other runs out while it lives. Throws Error when the folder cannot be written to.
  explicit ResultFolder(std::filesystem::path folder);
  /// Removes what is staged, and the folder where it was made and nothing is in it.
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Throws Error where something has one of the names, but is not as `solve` left it.
  void expect_free(const std::string& name) const;
  /// The same for all frames.
  void expect_free_frames() const;

  /// Where the files of the new result are to be written; it is new, and its names reach the disk
  /// with commit().
  std::filesystem::path staged() const;
  /// A message about files that are staged, with the names that they would get.
  std::string with_final_names(std::string message) const;
  /// Puts what is staged in the place of the earlier result. Throws Error; then the earlier result
  /// is whole, or `.foldless-committed` is there.
  void commit();

 private:
  /// True for a file that is as the earlier result left it.
  bool is_own(const std::string& name) const;
  bool has_only_own_frames() const;
  void take_names();
  void take_frames(const Manifest& manifest) const;
  /// Removes files of the earlier result that are not in the new one.
  void remove_obsolete(const Manifest& manifest) const;

  std::filesystem::path folder_;
  MadeFolder made_;
  FolderLock lock_;
  Manifest earlier_;  ///< what the result before consists of
};

/// Makes a folder and those above it. Throws Error when it cannot be made.
void make_folder(const std::filesystem::path& folder);

/// `file`, or the newer one that has not taken its name yet; see ResultFolder.
std::filesystem::path newest_of_result(const std::filesystem::path& file);

}  // namespace foldless
