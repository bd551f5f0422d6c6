// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/animation_export.h"
#include "app/gui/figure_export.h"
#include "app/gui/layout.h"
#include "app/gui/look.h"
#include "app/gui/sequence_export.h"

namespace foldless {

/// What is written while the user goes on.
struct BackgroundExports {
  FigureExport figure;
  SequenceExport sequence;
  AnimationExport animation;

  bool is_busy() const { return figure.is_busy() || sequence.is_busy() || animation.is_busy(); }
};

/// Goes on with them. Keeps the framebuffer that is bound.
void update_exports(BackgroundExports& exports, Editor& editor, double time);

/// How far sequences and animations are, with a button that cancels; nothing while none is written.
void draw_progress(BackgroundExports& exports, const Rectangle& canvas, const Look& look);

}  // namespace foldless
