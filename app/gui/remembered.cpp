// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/remembered.h"

#include "app/gui/interface_commands.h"

namespace foldless {

void bring_back(const Settings& settings, Editor& editor) {
  editor.keys() = all_keys();
  editor.keys().choose(settings.keys);
  editor.playback().set_pace(settings.pace);
  if (settings.layers) editor.view().options().layers = *settings.layers;
  if (!settings.problem.empty()) editor.messages().toast(ToastKind::error, settings.problem);
}

void remember(const Editor& editor, Settings& settings) {
  settings.keys = editor.keys().choice();
  settings.pace = editor.playback().pace();
  const Document& document = editor.document();
  if (!document.is_empty() && document.texture.empty())
    settings.layers = editor.view().options().layers;
}

}  // namespace foldless
