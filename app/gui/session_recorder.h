// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "app/gui/session_file.h"

namespace foldless {

/// Writes what a user does to a session file, line by line, so that what led to a crash is there.
/// Shift+F12 takes a picture when the session is replayed.
class SessionRecorder {
 public:
  /// An empty path records nothing. Throws Error when the file cannot be made.
  explicit SessionRecorder(const std::filesystem::path& path);

  // Each throws Error when the file can no longer be written; it is off from then on.

  bool is_on() const { return out_.is_open(); }
  /// The window of the frame that is drawn next, and at first what was opened.
  void follow(double time, const SessionWindow& window, const SessionStart& start);
  void add(double time, const UiEvent& event);

 private:
  void write(const std::string& line);

  std::filesystem::path path_;
  std::ofstream out_;
  std::optional<SessionWindow> window_;  ///< nothing before the first line
  int shots_ = 0;
};

}  // namespace foldless
