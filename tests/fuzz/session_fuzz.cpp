// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded sessions, without playing them.
#include "app/gui/session_file.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  fuzz::refuse_or_do(
      [&] { parse_session(std::string(fuzz::Input(data, size).rest()), "session", "/"); });
  return 0;
}
