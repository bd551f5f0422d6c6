// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foldless {

/// The document that copies are of.
struct Origin {
  std::filesystem::path path;  ///< of the scene file; empty: never saved
  std::string name;            ///< for the user

  bool operator==(const Origin&) const = default;
};

/// A folder of copies of one document, the last five, as scene files with ascending numbers. One
/// process at a time has it: it holds a lock, which goes away with the process, however that ends.
class AutosaveFolder {
 public:
  /// Makes one in `root`. Throws Error.
  static AutosaveFolder create(const std::filesystem::path& root);
  /// Takes one that is there; nothing where another process has it, or it is none. Throws Error
  /// where that cannot be known.
  static std::optional<AutosaveFolder> take(const std::filesystem::path& folder);

  AutosaveFolder(AutosaveFolder&& other) noexcept;
  AutosaveFolder& operator=(AutosaveFolder&& other) noexcept;
  /// Leaves the copies where they are, for the next process.
  ~AutosaveFolder();

  const std::filesystem::path& path() const { return path_; }
  /// What the copies are of; empty when that was never written. Throws Error where it cannot be
  /// read.
  Origin origin() const;
  /// Newest first. Throws Error where the folder cannot be read.
  std::vector<std::filesystem::path> copies() const;
  /// Where the next copy is to be written. Throws Error.
  std::filesystem::path next_copy() const;
  /// Before the first copy of a document. Throws Error.
  void set_origin(const Origin& origin);
  /// Removes all but the newest five.
  void trim();
  /// Removes the copies, the oldest first, and the folder, which stays where something else is in
  /// it.
  void remove();

 private:
  AutosaveFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}
  void release();

  std::filesystem::path path_;
  int lock_ = -1;  ///< a file descriptor
};

/// What ended without being saved and nobody has.
struct LostWork {
  std::vector<AutosaveFolder> folders;  ///< with copies, the newest first
  std::string problem;  ///< why there may be more; one sentence, empty: there is not
};

/// Looks for it in `root`. Folders without copies are removed on the way, also those that somebody
/// began to make an hour ago and did not end; what cannot be read stays.
LostWork find_lost_work(const std::filesystem::path& root);

/// When a copy was written, as "today 14:05", "yesterday 23:10" or "21 Nov 2026, 09:30".
std::string time_words(std::filesystem::file_time_type written);

}  // namespace foldless
