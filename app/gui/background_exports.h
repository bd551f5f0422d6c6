// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/animation_export.h"
#include "app/gui/file_export.h"
#include "app/gui/layout.h"
#include "app/gui/look.h"
#include "app/gui/sequence_export.h"

namespace foldless {

/// What is written while the user goes on.
struct BackgroundExports {
  FileExport file;
  SequenceExport sequence;
  AnimationExport animation;

  bool is_busy() const { return file.is_busy() || sequence.is_busy() || animation.is_busy(); }
};

/// Goes on with them. Keeps the framebuffer that is bound. The browser asks for another name where
/// a file cannot be written.
void update_exports(BackgroundExports& exports, Editor& editor, FileBrowser& browser, double time);

/// What is written and how far it is, with a button that cancels; nothing while none is written.
void draw_progress(BackgroundExports& exports, const Rectangle& canvas, const Look& look);

}  // namespace foldless
