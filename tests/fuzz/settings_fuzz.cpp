// SPDX-License-Identifier: GPL-3.0-or-later
// Settings: whatever the file is, there are settings, and they read as they were written.
#include "app/gui/settings.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  const fuzz::MemoryFile file(fuzz::Input(data, size).rest());
  Settings settings = load_settings(file.path());
  settings.problem.clear();
  const fuzz::MemoryFile again(settings_text(settings));
  fuzz::expect(load_settings(again.path()) == settings, "settings read as they were written");
  return 0;
}
