// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/motion.h"

#include <utility>

namespace foldless {

Motion::Motion(Draft& draft, Messages& messages, std::function<void()> wake)
    : draft_(draft),
      messages_(messages),
      play_head_(draft, messages),
      keys_(draft, play_head_, messages),
      frames_(wake),
      bake_(std::move(wake)) {
  draft_.on_commit([this](const Document& before, Document& after) {
    if (is_open_) keys_.key_what_changed(before, after);
  });
}

void Motion::toggle() {
  draft_.interrupt();
  is_open_ = !is_open_;
  play_head_.stop();
  if (!is_open_ && std::exchange(shown_, nullptr)) draft_.look_at_newest();
  messages_.redraw();
}

void Motion::toggle_onion_skin() {
  has_onion_skin_ = !has_onion_skin_;
  messages_.redraw();
}

std::optional<double> Motion::next_wake() const {
  return is_open_ ? play_head_.next_wake() : std::nullopt;
}

void Motion::update() {
  if (std::exchange(original_, draft_.document().original) != draft_.document().original &&
      has_keys())
    is_open_ = true;
  if (!is_open_) return bake_.update(draft_.document(), frames_, false);
  play_head_.stay_in_cycle();
  frames_.hold(draft_.is_editing());
  if (draft_.is_editing()) bake_.update(draft_.document(), frames_, false);
  if (draft_.is_editing()) return play_head_.stop();
  keys_.select(Keys(keys_.selected()));
  frames_.follow(draft_.document());
  bake_.update(draft_.document(), frames_, true);
  if (std::exchange(proof_, bake_.status().state) != proof_) messages_.redraw();
  play_head_.advance();
  show();
}

std::shared_ptr<const SolvedFrame> Motion::solved() const {
  if (!play_head_.is_between()) return frames_.frame(play_head_.frame());
  const bool is_there = solved_between_ && solved_between_->frame == play_head_.moment();
  return is_there ? solved_between_ : nullptr;
}

std::optional<double> Motion::gap() const {
  const std::optional<double> gap = frames_.status().gap;
  if (!gap || draft_.document().is_empty()) return std::nullopt;
  const Points& rest = draft_.document().original->rest;
  if (*gap <= closing_tolerance(rest)) return std::nullopt;
  return *gap / usual_pixel(rest);
}

/// While a frame is not solved what was on screen stays there.
void Motion::show() {
  solved_between_ = play_head_.is_between() ? frames_.between(play_head_.moment()) : nullptr;
  const auto solved = this->solved();
  const auto& animation = draft_.document().animation;
  const bool is_on_screen = draft_.look_back() && !draft_.look_back()->iteration;
  if (!solved || (is_on_screen && solved == shown_ && of_ == animation)) return;
  shown_ = solved;
  of_ = animation;
  draft_.solving().hold();
  draft_.look_at({std::nullopt, pose_of(draft_.document(), *solved)});
}

std::vector<std::shared_ptr<const Snapshot>> Motion::neighbours() const {
  std::vector<std::shared_ptr<const Snapshot>> poses;
  if (!is_open_ || !has_onion_skin_ || play_head_.is_playing()) return poses;
  for (const auto& frame : {play_head_.key_before(), play_head_.key_after()})
    if (const auto solved = frame ? frames_.frame(*frame) : nullptr)
      poses.push_back(solved->snapshot);
  return poses;
}

}  // namespace foldless
