// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace foldless {

/// A hidden file or folder beside a result while that is made. It takes the result's name at the
/// end, or goes. A process that is killed leaves it: the next that makes the same result removes
/// it.
class Staged {
 public:
  enum class What { file, folder };

  /// Makes it, empty. Throws Error when it cannot be made.
  Staged(std::filesystem::path result, What what);
  /// Removes it where it has not taken the name.
  ~Staged();
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Renames it, within its folder; a file or an empty folder of that name is replaced. Throws
  /// Error.
  void take_name(const std::filesystem::path& name);
  void take_name() { take_name(result_); }

 private:
  bool make(What what);

  std::filesystem::path result_, path_;
  int lock_ = -1;  ///< tells other processes that this one lives
};

/// Removes what processes that were killed left of making a result; never what one that lives
/// works on.
void remove_leftovers(const std::filesystem::path& result);

}  // namespace foldless
