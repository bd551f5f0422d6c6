// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/progress_line.h"

#include <unistd.h>

#include <iostream>

namespace foldless {

ProgressLine::ProgressLine(bool is_wanted) : is_shown_(is_wanted && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (was_written_) std::cerr << "\r\033[K" << std::flush;
}

bool ProgressLine::is_due() const {
  return is_shown_ && Clock::now() - last_ >= std::chrono::milliseconds(200);
}

void ProgressLine::show(const std::string& text) {
  last_ = Clock::now();
  was_written_ = true;
  std::cerr << "\r\033[K" << text << std::flush;
}

}  // namespace foldless
