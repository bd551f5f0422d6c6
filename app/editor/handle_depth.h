// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace foldless {

class Editor;

/// Whether handles are selected, and the depth that all of them have, if it is one.
struct SelectedDepth {
  bool is_there = false;
  std::optional<double> common;
};
SelectedDepth selected_depth(const Editor& editor);

// Each gives the selected handles other depths, which is one undo step; see Handle::depth.

void bring_forward(Editor& editor);  ///< by 1
void send_back(Editor& editor);      ///< by 1
/// A depth that is not finite is refused without a word, one beyond ±1000 is clamped.
void set_depth(Editor& editor, double depth);

}  // namespace foldless
