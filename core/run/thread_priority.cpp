// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/thread_priority.h"

#include <sys/resource.h>

namespace foldless {

void give_way_to_the_window() {
  constexpr id_t kThisThread = 0;
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, kThisThread, kNice);
}

}  // namespace foldless
