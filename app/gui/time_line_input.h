// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/gui/time_line.h"
#include "app/gui/time_line_place.h"

namespace foldless {

/// Where a gesture would take a selected key of a frame; empty where it moves none.
std::function<int(int)> pulled_frame(const TimeLineGesture& gesture, const TimeLinePlace& place);

/// The pointer on the last item of ImGui, which is the whole time line.
void handle_time_line(Editor& editor, TimeLineState& state, const TimeLinePlace& place);

}  // namespace foldless
