// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/session_recorder.h"

#include <array>
#include <cstdio>

#include "core/error.h"

namespace foldless {

SessionRecorder::SessionRecorder(const std::filesystem::path& path) : path_(path) {
  if (path.empty()) return;
  out_.open(path);
  if (!out_) throw Error(path.string() + ": the session cannot be recorded there");
}

void SessionRecorder::follow(double time, const SessionWindow& window, const SessionStart& start) {
  if (!is_on() || window == window_) return;
  const bool is_first = !window_;
  window_ = window;
  write(is_first ? first_line(window, start, std::filesystem::absolute(path_).parent_path())
                 : line_of(time, window));
}

void SessionRecorder::add(double time, const UiEvent& event) {
  if (!is_on()) return;
  const auto* input = std::get_if<InputEvent>(&event);
  const auto* key = input ? std::get_if<KeyPressed>(input) : nullptr;
  if (!key || key->key != Key::f12 || !key->modifiers.shift) return write(line_of(time, event));
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "%04d", ++shots_);
  write(line_of(time, Shot{name.data()}));
}

void SessionRecorder::write(const std::string& line) {
  out_ << line << std::flush;
  if (out_) return;
  out_.close();
  throw Error(path_.string() +
              ": recording has ended here, as what follows could not be "
              "written; make room there and begin again");
}

}  // namespace foldless
