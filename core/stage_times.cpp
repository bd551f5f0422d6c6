// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stage_times.h"

#include <ctime>

namespace foldless {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace foldless
