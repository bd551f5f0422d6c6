// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/playback.h"

#include <algorithm>
#include <string>
#include <utility>

namespace foldless {

void Playback::toggle_pause() {
  if (draft_.document().is_empty()) return;
  draft_.look_at_newest();
  draft_.solving().toggle_pause(draft_.document());
  messages_.redraw();
}

void Playback::stop() {
  draft_.solving().stop();
  messages_.redraw();
}

void Playback::set_pace(std::optional<double> pace) {
  if (pace) pace = std::clamp(*pace, 1.0, 60.0);
  pace_ = pace;
  draft_.solving().set_pace(pace);
  race_.set_pace(pace);
  messages_.redraw();
}

bool Playback::can_scrub() const {
  return !is_solving() && !draft_.is_editing() && !iterations().empty();
}

std::optional<std::size_t> Playback::scrubbed() const {
  if (!draft_.look_back()) return std::nullopt;
  return draft_.look_back()->iteration;
}

void Playback::scrub(std::size_t index) {
  next_.reset();
  show(index);
}

void Playback::show(std::size_t index) {
  if (!can_scrub()) return;
  if (index + 1 >= iterations().size()) return draft_.look_at_newest();
  const auto snapshot = draft_.solving().snapshot_of(index);
  if (!snapshot)
    return messages_.toast(ToastKind::notice, "That iteration was let go to save memory");
  const Document& document = draft_.document();
  draft_.look_at({index, with_looks_of(document, adopted_pose(snapshot, *document.pose))});
}

void Playback::step_forward() {
  if (const auto shown = scrubbed()) return scrub(*shown + 1);
  draft_.solving().step(draft_.document());
  messages_.redraw();
}

void Playback::step_back() {
  if (is_solving()) {
    draft_.solving().pause();
    messages_.redraw();
  }
  const std::size_t newest = iterations().empty() ? 0 : iterations().size() - 1;
  const std::size_t shown = scrubbed().value_or(newest);
  if (shown > 0) scrub(shown - 1);
}

void Playback::first() { scrub(0); }

void Playback::last() {
  next_.reset();
  draft_.look_at_newest();
}

void Playback::toggle_play() {
  messages_.redraw();
  if (is_playing()) return next_.reset();
  if (!can_scrub() || iterations().size() < 2) return;
  if (!scrubbed()) show(0);
  next_ = messages_.now() + 1 / pace_.value_or(kFullSpeed);
}

void Playback::update() {
  if (!is_playing()) return;
  if (!can_scrub()) return next_.reset();
  const double period = 1 / pace_.value_or(kFullSpeed);
  while (is_playing() && messages_.now() >= *next_) {
    *next_ = std::max(*next_ + period, messages_.now() - period);  // a slow frame drops some
    if (const auto shown = scrubbed())
      show(*shown + 1);
    else if (loops_)
      show(0);
    else
      next_.reset();
  }
}

void Playback::use_iteration() {
  draft_.interrupt();
  if (!draft_.look_back()) return;
  if (!draft_.look_back()->pose->is_valid())
    return messages_.toast(ToastKind::error, "This iteration is folded; choose one that is not");
  if (!scrubbed()) return draft_.take_over_look_back();
  const std::string label = "Use iteration " + std::to_string(*scrubbed() + 1);
  draft_.begin_edit();
  Document document = draft_.document();
  document.standing = {};
  draft_.apply(std::move(document), Change::appearance);
  draft_.commit(label);
}

}  // namespace foldless
