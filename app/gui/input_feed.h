// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <set>
#include <vector>

#include "app/gui/ui_event.h"

struct ImGuiIO;

namespace foldless {

/// A queue of events on their way into ImGui, which sees only the state of the keyboard and the
/// mouse at each frame: a press and its release must come to different frames, the pointer may not
/// move on in the frame in which a button changed, and Ctrl may not go in the frame of Ctrl+N.
class InputFeed {
 public:
  /// Tells ImGui which numbers our keys have; once a context.
  static void map_keys(ImGuiIO& io);

  void push(const UiEvent& event) { queue_.push_back(event); }
  bool is_empty() const { return queue_.empty(); }

  /// Takes the events of one frame, sets `io` to the state after them, and returns them with
  /// pointer positions in framebuffer pixels. `pixels`: framebuffer pixels a window coordinate.
  std::vector<UiEvent> take_frame(ImGuiIO& io, const Vec2& pixels);

  /// Modifier keys held now.
  const Modifiers& modifiers() const { return modifiers_; }

 private:
  /// What changed in the frame that is being put together.
  struct Frame {
    bool has_button_change = false;
    std::set<Key> changed_keys;
  };
  bool fits(const UiEvent& event, Frame& frame) const;
  void apply(const InputEvent& event, ImGuiIO& io);
  void apply(const UiEvent& event, ImGuiIO& io);

  std::deque<UiEvent> queue_;
  Modifiers modifiers_;
};

}  // namespace foldless
