// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui_internal.h>

namespace foldless {

// The list of a combo box and its keys: arrows, PageUp, PageDown, Home and End walk from the entry
// that is chosen, and a letter leads to the next entry that begins with it.

/// An entry; true when it is taken. Between begin_combo() and ImGui::EndCombo().
bool choice_entry(const char* title, bool is_chosen);

/// Once a frame, before anything is drawn: moves the focus in the list as the keys say; returns
/// whether it did.
bool walk_choices(ImGuiWindow& list);

}  // namespace foldless
