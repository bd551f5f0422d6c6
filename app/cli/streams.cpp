// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <iostream>

#include "core/error.h"

namespace foldless {

void prepare_streams() {
  std::signal(SIGXFSZ, SIG_IGN);
  // Opened the wrong way round, so that what is printed is still known to be lost. The lowest
  // number that is free is taken, which is the one that was closed.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0)
      ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void expect_output_arrived() {
  if (!std::cout.flush())
    throw Error("standard output cannot be written to: what was to be printed there is lost");
}

}  // namespace foldless
