// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/edits.h"
#include "core/handle.h"

namespace foldless {

class Editor;

/// What the selected handles have in common.
struct SelectedHandles {
  bool are_there = false;
  std::optional<HandleKind> kind;
  std::optional<double> weight;
  std::optional<double> depth;
  std::optional<std::string> name;
  std::optional<double> x, y;  ///< of the target [length]
  std::optional<bool> turns;   ///< whether there is a Turn
  std::optional<double> angle, radius;
  std::optional<double> stiffness;     ///< 1 without a StiffDisk
  std::optional<double> stiff_radius;  ///< of that, 0 without
};
SelectedHandles selected_handles(const Editor& editor);
/// Where they should be now.
std::vector<Target> selected_targets(const Editor& editor);

// Each changes the selected handles, which is one undo step. A number that is not finite is refused
// without a word, one out of range is clamped.

void set_kind(Editor& editor, HandleKind kind);
void toggle_pin(Editor& editor);                 ///< pins become drag handles, others pins
void set_weight(Editor& editor, double weight);  ///< 0.001 … 1000
void set_depth(Editor& editor, double depth);    ///< −1000 … 1000, see Handle::depth
void set_name(Editor& editor, const std::string& name);
void set_coordinate(Editor& editor, int axis, double value);  ///< of the target: 0 is x, 1 is y
/// 0.1 … 1000 times as stiff round them; 1 is as stiff as ever. A radius there was not is a tenth
/// of the drawing's diagonal.
void set_stiffness(Editor& editor, double factor);
void set_stiff_radius(Editor& editor, double radius);  ///< > 0 [length]
void bring_forward(Editor& editor);                    ///< depth by 1
void send_back(Editor& editor);                        ///< depth by −1

/// Moves the targets by a pixel of the picture, or of the screen where there is none; with Shift by
/// ten, with Alt by a tenth. Repeated within a second it is one step.
void nudge(Editor& editor, const Vec2& direction);

}  // namespace foldless
