// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/handle_depth.h"

#include <algorithm>
#include <cmath>

#include "app/editor/editor.h"

namespace foldless {
namespace {

constexpr double kMostDepth = 1000;

void shift_depth(Editor& editor, const char* label, double by) {
  editor.edits().change_selected(label, [by](Handle& handle) {
    handle.depth = std::clamp(handle.depth + by, -kMostDepth, kMostDepth);
  });
}

}  // namespace

SelectedDepth selected_depth(const Editor& editor) {
  SelectedDepth selected;
  for (const Handle& handle : editor.document().handles) {
    if (!editor.selection().ids().contains(handle.id)) continue;
    const bool is_first = !selected.is_there;
    selected.is_there = true;
    if (is_first)
      selected.common = handle.depth;
    else if (selected.common != handle.depth)
      selected.common.reset();
  }
  return selected;
}

void bring_forward(Editor& editor) { shift_depth(editor, "Bring forward", 1); }
void send_back(Editor& editor) { shift_depth(editor, "Send back", -1); }

void set_depth(Editor& editor, double depth) {
  if (!std::isfinite(depth)) return;
  depth = std::clamp(depth, -kMostDepth, kMostDepth);
  editor.edits().change_selected("Depth", [depth](Handle& handle) { handle.depth = depth; });
}

}  // namespace foldless
