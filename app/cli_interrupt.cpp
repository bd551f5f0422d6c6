// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_interrupt.h"

#include <atomic>

namespace foldless {
namespace {

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
  begin_noting(SIGINT, previous_int_);
  begin_noting(SIGTERM, previous_term_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &previous_int_, nullptr);
  sigaction(SIGTERM, &previous_term_, nullptr);
}

bool Interrupt::is_requested() const { return has_come; }

}  // namespace foldless
