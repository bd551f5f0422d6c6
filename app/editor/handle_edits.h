// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/editor/tools/gestures.h"
#include "core/handle.h"

namespace foldless {

/// What the selected handles have in common.
struct SelectedHandles {
  bool are_there = false;
  std::optional<HandleKind> kind;
  std::optional<double> weight;
  std::optional<double> depth;
};
SelectedHandles selected_handles(const Editor& editor);

// Each changes the selected handles, which is one undo step. A number that is not finite is refused
// without a word, one out of range is clamped.

void set_kind(Editor& editor, HandleKind kind);
void toggle_pin(Editor& editor);                 ///< pins become drag handles, others pins
void set_weight(Editor& editor, double weight);  ///< 0.001 … 1000
void set_depth(Editor& editor, double depth);    ///< −1000 … 1000, see Handle::depth
void bring_forward(Editor& editor);              ///< depth by 1
void send_back(Editor& editor);                  ///< depth by −1

/// Moves the targets by a pixel of the picture, or of the screen where there is none; with Shift by
/// ten, with Alt by a tenth. Repeated within a second it is one step.
void nudge(Editor& editor, const Vec2& direction);

/// Begins to turn or scale with the pointer; two handles at least.
void begin_transformation(Editor& editor, Transformation what);

}  // namespace foldless
