// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace foldless {

Motion::Motion(Draft& draft, Messages& messages, std::function<void()> wake)
    : draft_(draft), messages_(messages), frames_(wake), bake_(std::move(wake)) {
  draft_.on_commit(
      [this](const Document& before, Document& after) { key_what_changed(before, after); });
}

const Animation& Motion::animation() const {
  static const Animation none;
  return draft_.document().animation ? *draft_.document().animation : none;
}

void Motion::toggle() {
  draft_.interrupt();
  is_open_ = !is_open_;
  play_.reset();
  if (!is_open_ && std::exchange(shown_, nullptr)) draft_.look_at_newest();
  messages_.redraw();
}

void Motion::go_to(int frame) {
  frame_ = std::clamp(frame, 0, last_frame());
  between_.reset();
  if (play_) play_ = Playing{messages_.now(), frame_};
  messages_.redraw();
}

/// In a loop there are moments after the last frame too.
void Motion::go_between(double moment) {
  stop();
  const double possible = std::clamp(moment, 0.0, static_cast<double>(end()));
  go_to(static_cast<int>(std::lround(possible)));
  if (possible < end() && possible != std::floor(possible)) between_ = possible;
}

void Motion::step_forward() {
  const int frame = static_cast<int>(std::floor(moment()));
  go_to(frame < last_frame() ? frame + 1 : 0);
}

void Motion::step_back() {
  const int frame = static_cast<int>(std::ceil(moment()));
  go_to(frame > 0 ? frame - 1 : last_frame());
}

std::optional<int> Motion::key_after(int frame) const {
  std::optional<int> next;
  for (const KeyPlace& key : keys_of(animation()))
    if (key.frame > frame) next = std::min(next.value_or(key.frame), key.frame);
  return next;
}

std::optional<int> Motion::key_before(int frame) const {
  std::optional<int> before;
  for (const KeyPlace& key : keys_of(animation()))
    if (key.frame < frame) before = std::max(before.value_or(key.frame), key.frame);
  return before;
}

void Motion::next_key() {
  if (const auto frame = key_after(frame_)) go_to(*frame);
}

void Motion::previous_key() {
  if (const auto frame = key_before(frame_)) go_to(*frame);
}

void Motion::toggle_play() {
  messages_.redraw();
  if (play_) return play_.reset();
  draft_.interrupt();
  between_.reset();
  play_ = Playing{messages_.now(), frame_};
}

/// A slow frame drops some.
void Motion::advance() {
  if (!play_) return;
  const double passed = (messages_.now() - play_->since) * animation().fps;
  const int count = animation().cycle.frames;
  const int frame = static_cast<int>(std::fmod(play_->from + passed + 1e-6, count));
  if (frame != std::exchange(frame_, frame)) messages_.redraw();
}

std::optional<double> Motion::next_wake() const {
  if (!play_ || !is_open_) return std::nullopt;
  const double passed = (messages_.now() - play_->since) * animation().fps;
  return play_->since + (std::floor(passed + 1e-6) + 1) / animation().fps;
}

void Motion::update() {
  if (std::exchange(original_, draft_.document().original) != draft_.document().original &&
      has_keys())
    is_open_ = true;
  if (!is_open_) return bake_.update(draft_.document(), frames_, false);
  frame_ = std::clamp(frame_, 0, last_frame());
  if (between_ && *between_ >= end()) between_.reset();
  frames_.hold(draft_.is_editing());
  if (draft_.is_editing()) bake_.update(draft_.document(), frames_, false);
  if (draft_.is_editing()) return play_.reset();
  select(Keys(selected_));
  frames_.follow(draft_.document());
  bake_.update(draft_.document(), frames_, true);
  if (std::exchange(proof_, bake_.status().state) != proof_) messages_.redraw();
  advance();
  show();
}

std::shared_ptr<const SolvedFrame> Motion::solved() const {
  if (!between_) return frames_.frame(frame_);
  const bool is_there = solved_between_ && solved_between_->frame == *between_;
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
  solved_between_ = between_ ? frames_.between(*between_) : nullptr;
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
  if (!is_open_ || !has_onion_skin_ || play_) return poses;
  for (const auto& frame : {key_before(frame_), key_after(frame_)})
    if (const auto solved = frame ? frames_.frame(*frame) : nullptr)
      poses.push_back(solved->snapshot);
  return poses;
}

std::string moment_words(double moment) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), moment == std::floor(moment) ? "%.0f" : "%.2f", moment);
  return text.data();
}

}  // namespace foldless
