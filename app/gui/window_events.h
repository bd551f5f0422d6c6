// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/ui_event.h"

struct GLFWwindow;

namespace foldless {

/// Sets the window's callbacks, which append to `events` from now on: it must outlive the window.
/// Takes the window's user pointer.
void send_events_to(GLFWwindow* window, std::vector<UiEvent>& events);

}  // namespace foldless
