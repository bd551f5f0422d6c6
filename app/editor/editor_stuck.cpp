// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "app/editor/editor.h"

namespace foldless {

void Editor::toggle_stuck() {
  stuck_.show(!stuck_.is_shown());
  redraw();
}

const StuckHandle* Editor::stuck_handle() const {
  const auto& handles = stuck_.handles();
  if (handles.empty()) return nullptr;
  const auto chosen = std::ranges::find_if(
      handles, [this](const StuckHandle& h) { return selection_.contains(h.id); });
  return chosen == handles.end() ? &handles.front() : &*chosen;
}

void Editor::flip_blocking() {
  const StuckHandle* stuck = stuck_handle();
  if (!stuck) return;
  if (auto flipped = with_blocking_flipped(document_, stuck->id))
    edit("Flip blocking edges", *std::move(flipped), Change::mesh);
  else
    toast(ToastKind::notice, "None of these edges can be flipped: a triangle would fold");
}

void Editor::split_blocking() {
  const StuckHandle* stuck = stuck_handle();
  if (!stuck) return;
  if (auto split = with_blocking_split(document_, stuck->id))
    edit("Split blocking edges", *std::move(split), Change::mesh);
  else
    toast(ToastKind::notice, "None of these edges can be split: they would become too short");
}

}  // namespace foldless
