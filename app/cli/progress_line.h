// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace foldless {

/// One line on stderr that is written over, a few times a second, where a person looks on.
class ProgressLine {
 public:
  explicit ProgressLine(bool is_wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// True when the line is shown and it is time for the next.
  bool is_due() const;
  void show(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_shown_;
  bool was_written_ = false;
  Clock::time_point last_ = Clock::now();
};

}  // namespace foldless
