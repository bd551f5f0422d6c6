// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <csignal>

namespace foldless {

/// While it lives, SIGINT, SIGTERM and SIGHUP are noted instead of ending the program, whichever
/// thread they reach, so that it can end by itself with whole files. One that was ignored stays so,
/// as under nohup. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// True once one of them has come. Any thread may ask.
  bool is_requested() const;

 private:
  std::array<struct sigaction, 3> previous_{};
};

}  // namespace foldless
