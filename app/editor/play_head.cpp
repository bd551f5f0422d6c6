// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/play_head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/editor/key_edits.h"

namespace foldless {

const Animation& animation_in(const Document& document) {
  static const Animation none;
  return document.animation ? *document.animation : none;
}

void PlayHead::go_to(int frame) {
  frame_ = std::clamp(frame, 0, last_frame());
  between_.reset();
  if (play_) play_ = Playing{messages_.now(), frame_};
  messages_.redraw();
}

/// In a loop there are moments after the last frame too.
void PlayHead::go_between(double moment) {
  stop();
  const double possible = std::clamp(moment, 0.0, static_cast<double>(end()));
  go_to(static_cast<int>(std::lround(possible)));
  if (possible < end() && possible != std::floor(possible)) between_ = possible;
}

void PlayHead::step_forward() {
  const int frame = static_cast<int>(std::floor(moment()));
  go_to(frame < last_frame() ? frame + 1 : 0);
}

void PlayHead::step_back() {
  const int frame = static_cast<int>(std::ceil(moment()));
  go_to(frame > 0 ? frame - 1 : last_frame());
}

std::optional<int> PlayHead::key_after() const {
  std::optional<int> next;
  for (const KeyPlace& key : keys_of(animation()))
    if (key.frame > frame_) next = std::min(next.value_or(key.frame), key.frame);
  return next;
}

std::optional<int> PlayHead::key_before() const {
  std::optional<int> before;
  for (const KeyPlace& key : keys_of(animation()))
    if (key.frame < frame_) before = std::max(before.value_or(key.frame), key.frame);
  return before;
}

void PlayHead::next_key() {
  if (const auto frame = key_after()) go_to(*frame);
}

void PlayHead::previous_key() {
  if (const auto frame = key_before()) go_to(*frame);
}

void PlayHead::toggle_play() {
  messages_.redraw();
  if (play_) return play_.reset();
  draft_.interrupt();
  between_.reset();
  play_ = Playing{messages_.now(), frame_};
}

void PlayHead::stay_in_cycle() {
  frame_ = std::clamp(frame_, 0, last_frame());
  if (between_ && *between_ >= end()) between_.reset();
}

/// A slow frame drops some.
void PlayHead::advance() {
  if (!play_) return;
  const double passed = (messages_.now() - play_->since) * animation().fps;
  const int count = animation().cycle.frames;
  const int frame = static_cast<int>(std::fmod(play_->from + passed + 1e-6, count));
  if (frame != std::exchange(frame_, frame)) messages_.redraw();
}

std::optional<double> PlayHead::next_wake() const {
  if (!play_) return std::nullopt;
  const double passed = (messages_.now() - play_->since) * animation().fps;
  return play_->since + (std::floor(passed + 1e-6) + 1) / animation().fps;
}

std::string moment_words(double moment) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), moment == std::floor(moment) ? "%.0f" : "%.2f", moment);
  return text.data();
}

}  // namespace foldless
