// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/editor.h"
#include "app/gui/look.h"

namespace foldless {

/// What the right button offers on the canvas: the commands of handles on a handle, else those of
/// the picture and its view. They are rows of the table of commands.
class ContextMenu {
 public:
  /// Opens where the pointer is. A handle that is not selected becomes the only one that is.
  void open(Editor& editor);
  /// In every frame, outside of windows.
  void draw(Editor& editor, const Look& look);

 private:
  bool is_asked_for_ = false;
  bool is_of_handle_ = false;
};

}  // namespace foldless
