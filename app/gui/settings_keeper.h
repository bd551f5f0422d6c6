// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/messages.h"
#include "app/gui/settings.h"

namespace foldless {

/// Writes settings to disk when they have changed and come to rest: what changes from frame to
/// frame, as the size of a window, is written once.
class SettingsKeeper {
 public:
  /// An empty folder keeps nothing.
  explicit SettingsKeeper(const std::filesystem::path& state_folder);

  /// Those that were kept the last time.
  Settings load();
  /// Call it in every frame; returns whether they have changed since the last call. Where they
  /// cannot be written that is said, once in a row of failures.
  bool follow(const Settings& settings, Messages& messages);
  /// When follow() has something to write, if ever. [s]
  std::optional<double> due() const { return due_; }
  /// Writes now what waits for it: nobody is told of a failure any more.
  void end();

 private:
  std::filesystem::path file_;
  Settings known_;
  std::optional<double> due_;
  bool has_failed_ = false;  ///< since the last success
};

}  // namespace foldless
