// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>

#include "app/editor/commands.h"

namespace foldless {

// One rule for the keys of whatever covers the rest. The topmost of dialogs, menus, combo boxes
// and other popups alone has them: Esc closes it, Enter presses the main button of a dialog. A key
// press is used once: nothing below sees it. Keys that were down when it opened count as let go.

/// Once a frame, after the canvas got its events and before anything is drawn: Esc closes the
/// topmost popup. Dialogs close themselves, by dialog_keys(). `captures_keys`: the topmost dialog
/// asks for a key, whatever it is.
void begin_dialog_keys(bool captures_keys);

/// Who has Enter and Esc while a text field of the dialog is edited.
enum class TextKeys {
  field,  ///< they end the editing
  dialog  ///< its one field is what the dialog is about
};

/// What the keys ask of the dialog that is being drawn.
struct DialogKeys {
  bool takes = false;   ///< Enter: what the main button does
  bool leaves = false;  ///< Esc: what cancel or close does
};

/// Takes Enter and Esc where they are the dialog's. Call it in the dialog, not in a child of it.
DialogKeys dialog_keys(TextKeys text_keys = TextKeys::field);

/// Takes another key of the dialog or popup that is being drawn, when it went down in this frame.
bool takes_key(Key key);

/// Takes a key with its modifiers.
bool takes_shortcut(const Shortcut& shortcut);

/// Takes the key that went down in this frame, whatever it is; nothing where none did.
std::optional<Shortcut> take_any_key();

/// The row that arrows, PageUp, PageDown, Home and End lead to in a list; nothing without such a
/// key. Home and End are a text field's while it `has_text`.
std::optional<std::size_t> walk_list(std::size_t selected, std::size_t count,
                                     bool has_text = false);

}  // namespace foldless
