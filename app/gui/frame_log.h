// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>

namespace foldless {

/// One drawn frame.
struct FrameTimes {
  double start = 0;            ///< since the window opened [s]
  double work = 0;             ///< from the events to the end of our drawing calls [s]
  double shown = 0;            ///< from the events to the picture's hand-over [s]
  bool is_editing = false;     ///< a gesture was under way
  std::size_t iterations = 0;  ///< of the solver since the last edit
};

/// A CSV of frame times, for measuring how the window feels while the solver works.
class FrameLog {
 public:
  /// An empty path writes nothing. Throws Error when the file cannot be made.
  explicit FrameLog(const std::filesystem::path& file);
  void add(const FrameTimes& times);

 private:
  std::ofstream out_;
};

}  // namespace foldless
