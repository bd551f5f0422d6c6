// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <csignal>
#include <optional>

namespace foldless {

/// While it lives, SIGINT, SIGTERM and SIGHUP are handled so, but those that were ignored, as under
/// nohup; after it as before.
class HandledSignals {
 public:
  explicit HandledSignals(void (*handler)(int));
  ~HandledSignals();
  HandledSignals(const HandledSignals&) = delete;
  HandledSignals& operator=(const HandledSignals&) = delete;

 private:
  std::array<struct sigaction, 3> previous_{};
};

/// While it lives, signals end the program at once with a status: where it has nothing to keep yet.
/// One at a time.
class EndAtOnce {
 public:
  explicit EndAtOnce(int status);

 private:
  std::optional<HandledSignals> signals_;
};

/// While it lives, signals are noted instead of ending the program, whichever thread they reach, so
/// that it can end by itself with whole files. One at a time.
class Interrupt {
 public:
  Interrupt();

  /// True once one of them has come. Any thread may ask.
  bool is_requested() const;

 private:
  std::optional<HandledSignals> signals_;
};

}  // namespace foldless
