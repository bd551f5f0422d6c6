// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace foldless {

/// While it lives, SIGINT and SIGTERM wait instead of ending the program, so that it can end by
/// itself with whole files. To be made before any thread is started.
class Interrupt {
 public:
  Interrupt();
  /// Forgets signals that came meanwhile.
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// True once one of them has come.
  bool is_requested() const;

 private:
  sigset_t signals_;   ///< the two
  sigset_t previous_;  ///< the mask before
};

}  // namespace foldless
