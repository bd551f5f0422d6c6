// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "app/editor/editor.h"
#include "app/gui/preview.h"

namespace foldless {

/// What the editor shows without being asked to by an event.
struct News {
  bool asks = false;        ///< before something is lost
  std::size_t toasts = 0;   ///< messages on screen
  bool previews = false;    ///< something else than the document
  std::string words;        ///< on that
  bool is_solving = false;  ///< lists grow until it ends
  std::size_t tick = 0;     ///< of a race: its table has other numbers
  Beside beside = Beside::nothing;
  bool operator==(const News&) const = default;
};

inline News news_of(const Editor& editor) {
  const auto preview = preview_of(editor);
  return {editor.files().is_asking(),
          editor.messages().toasts().size(),
          preview.has_value(),
          preview ? preview->words : "",
          editor.playback().is_solving(),
          editor.race().is_open() ? editor.race().tick() + 1 : 0,
          editor.view().beside()};
}

}  // namespace foldless
