// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/editor/canvas.h"
#include "core/motion/animation.h"

namespace foldless {

class Editor;

/// The centres on screen: of groups that swing, while the time line is open; by their index in the
/// animation. Those of what is selected alone, where anything is.
std::vector<std::size_t> shown_swings(const Editor& editor);

/// Where a centre is pulled, beside it: a handle may lie on the centre itself. [pixels]
Vec2 swing_grip(const Canvas& canvas, const Vec2& centre);

/// The group whose grip is under a pixel.
std::optional<std::size_t> swing_at(const Editor& editor, const Vec2& pixel);

}  // namespace foldless
