// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// Lets the window's thread, and the driver's threads where the processor draws, go first when the
/// cores are busy: frames are on time and the calling thread takes the rest. Without effect where
/// refused.
void give_way_to_the_window();

}  // namespace foldless
