// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/interrupt.h"

#include <unistd.h>

#include <atomic>

namespace foldless {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

/// Signals belong to the process, so a handler has no other place to leave its note.
std::atomic<bool> has_come = false;
static_assert(std::atomic<bool>::is_always_lock_free, "or a handler must not set it");

void note(int) { has_come = true; }

/// What the program ends with.
std::atomic<int> status_at_once = 0;
static_assert(std::atomic<int>::is_always_lock_free, "or a handler must not read it");

void end_at_once(int) { _exit(status_at_once); }

}  // namespace

HandledSignals::HandledSignals(void (*handler)(int)) {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &previous_[i]);
    if (previous_[i].sa_handler == SIG_IGN) continue;
    struct sigaction handling {};
    handling.sa_handler = handler;
    handling.sa_flags = SA_RESTART;
    sigaction(kSignals[i], &handling, nullptr);
  }
}

HandledSignals::~HandledSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &previous_[i], nullptr);
}

EndAtOnce::EndAtOnce(int status) {
  status_at_once = status;
  signals_.emplace(end_at_once);
}

Interrupt::Interrupt() {
  has_come = false;
  signals_.emplace(note);
}

bool Interrupt::is_requested() const { return has_come; }

}  // namespace foldless
