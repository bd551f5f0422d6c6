// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <csignal>

namespace foldless {

/// What signals did before; does it again when it goes.
class EarlierSignals {
 public:
  EarlierSignals() = default;
  ~EarlierSignals();
  EarlierSignals(const EarlierSignals&) = delete;
  EarlierSignals& operator=(const EarlierSignals&) = delete;

  /// Lets SIGINT, SIGTERM and SIGHUP be handled so from now on, but those that are ignored.
  void replace(void (*handler)(int));

 private:
  std::array<struct sigaction, 3> previous_{};
};

/// While it lives, SIGINT, SIGTERM and SIGHUP end the program at once with a status: where it has
/// nothing to keep yet. One that was ignored stays so. One at a time.
class EndAtOnce {
 public:
  explicit EndAtOnce(int status);

 private:
  EarlierSignals earlier_;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP are noted instead of ending the program, whichever
/// thread they reach, so that it can end by itself with whole files. One that was ignored stays so,
/// as under nohup. One at a time.
class Interrupt {
 public:
  Interrupt();

  /// True once one of them has come. Any thread may ask.
  bool is_requested() const;

 private:
  EarlierSignals earlier_;
};

}  // namespace foldless
