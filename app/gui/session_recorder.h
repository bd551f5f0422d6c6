// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>

#include "app/gui/session_file.h"

namespace foldless {

/// Writes what a user does to a session file, line by line, so that what led to a crash is there.
/// Shift+F12 takes a picture when the session is replayed.
class SessionRecorder {
 public:
  /// An empty path records nothing. Throws Error when the file cannot be written.
  explicit SessionRecorder(const std::filesystem::path& path) : path_(path) {}

  bool is_on() const { return !path_.empty(); }
  /// The window of the frame that is drawn next, and at first the file that was opened.
  void follow(double time, const SessionWindow& window, const std::filesystem::path& file);
  void add(double time, const UiEvent& event);

 private:
  void write(const std::string& line);

  std::filesystem::path path_;
  std::ofstream out_;
  SessionWindow window_;
  int shots_ = 0;
};

}  // namespace foldless
