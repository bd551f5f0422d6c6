// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/stuck_help.h"

#include <algorithm>
#include <utility>

namespace foldless {

void StuckHelp::update(bool rests) {
  if (stuck_.follow(draft_.document(), rests)) messages_.redraw();
}

void StuckHelp::toggle() {
  stuck_.show(!stuck_.is_shown());
  messages_.redraw();
}

const StuckHandle* StuckHelp::handle() const {
  const auto& all = stuck_.handles();
  if (all.empty()) return nullptr;
  const auto chosen = std::ranges::find_if(
      all, [this](const StuckHandle& h) { return draft_.selection().ids().contains(h.id); });
  return chosen == all.end() ? &all.front() : &*chosen;
}

void StuckHelp::flip_blocking() {
  const StuckHandle* stuck = handle();
  if (!stuck) return;
  if (auto flipped = with_blocking_flipped(draft_.document(), stuck->id))
    draft_.edit("Flip blocking edges", *std::move(flipped), Change::mesh);
  else
    messages_.toast(ToastKind::notice, "None of these edges can be flipped: a triangle would fold");
}

void StuckHelp::split_blocking() {
  const StuckHandle* stuck = handle();
  if (!stuck) return;
  if (auto split = with_blocking_split(draft_.document(), stuck->id))
    draft_.edit("Split blocking edges", *std::move(split), Change::mesh);
  else
    messages_.toast(ToastKind::notice,
                    "None of these edges can be split: they would become too short");
}

}  // namespace foldless
