// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

// Keys by their index in ImGui's io, which is the number of a Key.

/// Until it is let go and pressed anew, as its repeats do not press it.
void forget_key(int index);

/// Whether it went down in this frame; nobody sees that after this.
bool take_press(int index);

}  // namespace foldless
