// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/interrupt.h"

#include <atomic>

namespace foldless {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

/// Signals belong to the process, so a handler has no other place to leave its note.
std::atomic<bool> has_come = false;
static_assert(std::atomic<bool>::is_always_lock_free, "or a handler must not set it");

void note(int) { has_come = true; }

/// Notes a signal from now on, unless it is ignored; what happened before stays in `previous`.
void begin_noting(int signal, struct sigaction& previous) {
  sigaction(signal, nullptr, &previous);
  if (previous.sa_handler == SIG_IGN) return;
  struct sigaction noting {};
  noting.sa_handler = note;
  noting.sa_flags = SA_RESTART;
  sigaction(signal, &noting, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  has_come = false;
  for (std::size_t i = 0; i < kSignals.size(); ++i) begin_noting(kSignals[i], previous_[i]);
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &previous_[i], nullptr);
}

bool Interrupt::is_requested() const { return has_come; }

}  // namespace foldless
