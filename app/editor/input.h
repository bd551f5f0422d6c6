// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Modifier keys that are held.
struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;

  bool operator==(const Modifiers&) const = default;
};

/// A key by what is printed on it, without Shift: '.' and never '>'.
// clang-format off
enum class Key {
  none,
  a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
  digit_0, digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
  f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
  space, escape, enter, tab, backspace, del, home, end, page_up, page_down, left, right, up, down,
  plus, minus, comma, period, backslash, slash, left_bracket, right_bracket
};
// clang-format on
inline constexpr Key kLastKey = Key::right_bracket;

enum class Button { left, right, middle };

/// Constraints of pointer events are framebuffer pixels from the top left corner of the canvas, y
/// down; they may lie outside it during a drag.
struct PointerPressed {
  Button button = Button::left;
  Vec2 position = Vec2::Zero();
  Modifiers modifiers;
};

struct PointerMoved {
  Vec2 position = Vec2::Zero();
  Modifiers modifiers;
};

struct PointerReleased {
  Button button = Button::left;
  Vec2 position = Vec2::Zero();
  Modifiers modifiers;
};

/// The pointer is no longer over the canvas, and no button is held.
struct PointerLeft {};

struct WheelTurned {
  double notches = 0;  ///< away from the user is positive and zooms in
  Vec2 position = Vec2::Zero();
};

struct KeyPressed {
  Key key = Key::none;
  Modifiers modifiers;
  bool is_repeat = false;
};

struct KeyReleased {
  Key key = Key::none;
};

/// Files were dropped on the window.
struct FilesDropped {
  std::vector<std::filesystem::path> paths;
};

/// The window lost the keyboard: whatever is held counts as released.
struct FocusLost {};

using InputEvent = std::variant<PointerPressed, PointerMoved, PointerReleased, PointerLeft,
                                WheelTurned, KeyPressed, KeyReleased, FilesDropped, FocusLost>;

}  // namespace foldless
