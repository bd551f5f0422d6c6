// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/session_recorder.h"

#include <array>
#include <cstdio>

#include "core/error.h"

namespace foldless {

void SessionRecorder::follow(double time, const SessionWindow& window,
                             const std::filesystem::path& file) {
  if (!is_on() || (out_.is_open() && window == window_)) return;
  window_ = window;
  if (out_.is_open()) return write(line_of(time, window));
  out_.open(path_);
  write(first_line(window, file, std::filesystem::absolute(path_).parent_path()));
}

void SessionRecorder::add(double time, const UiEvent& event) {
  if (!out_.is_open()) return;
  const auto* input = std::get_if<InputEvent>(&event);
  const auto* key = input ? std::get_if<KeyPressed>(input) : nullptr;
  if (!key || key->key != Key::f12 || !key->modifiers.shift) return write(line_of(time, event));
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "%04d", ++shots_);
  write(line_of(time, Shot{name.data()}));
}

void SessionRecorder::write(const std::string& line) {
  out_ << line << std::flush;
  if (!out_) throw Error(path_.string() + ": the session cannot be recorded there");
}

}  // namespace foldless
