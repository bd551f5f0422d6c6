// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"
#include "app/gui/replay.h"
#include "app/gui/run_editor.h"

namespace {

int replay(const std::filesystem::path& session, const std::filesystem::path& shots,
           const std::optional<std::array<int, 2>>& size) {
  foldless::ReplayOptions options{session, shots};
  if (size) options.size = foldless::Extent{size->front(), size->back()};
  return foldless::replay_session(options);
}

}  // namespace

int main(int argc, char** argv) {
  return foldless::run_command_line(argc, argv, {foldless::run_editor, replay});
}
