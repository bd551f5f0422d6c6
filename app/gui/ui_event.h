// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "app/editor/input.h"

namespace foldless {

/// A character was typed, after keyboard layout and dead keys.
struct CharacterTyped {
  char32_t code_point = 0;
};

/// A modifier key went down or up.
struct ModifiersHeld {
  Modifiers modifiers;
};

/// The pointer left the window.
struct WindowLeft {};

/// What a window tells the interface. Constraints of pointer events are window coordinates, y down;
/// the interface turns them into framebuffer pixels of the canvas for the editor.
using UiEvent = std::variant<InputEvent, CharacterTyped, ModifiersHeld, WindowLeft>;

}  // namespace foldless
