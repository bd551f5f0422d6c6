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

foldless::Image picture(const std::filesystem::path& file,
                        const std::optional<std::array<int, 2>>& size,
                        std::optional<foldless::Theme> theme) {
  const auto [width, height] = size.value_or(std::array{1280, 800});
  return foldless::picture_of_editor(file, {width, height}, theme);
}

}  // namespace

int main(int argc, char** argv) {
  return foldless::run_command_line(argc, argv, {foldless::run_editor, replay, picture});
}
