// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/ui_event.h"

struct GLFWwindow;

namespace foldless {

/// What a window's callbacks keep.
struct WindowEvents {
  std::vector<UiEvent> events;  ///< in the order in which they happened
  bool is_damaged = false;      ///< what the window showed is lost
  /// Where the pointer was at the newest event. GLFW asks the X server for the position of now,
  /// which in a slow frame is not where a button was pressed.
  Vec2 pointer = Vec2::Zero();
};

/// Sets the window's callbacks, which append to `events` from now on: it must outlive the window.
/// Takes the window's user pointer.
void send_events_to(GLFWwindow* window, WindowEvents& events);

}  // namespace foldless
