// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/editor/editor.h"

namespace foldless {

/// What the mouse would do now, given what it is over and which modifiers are held.
std::string hint_words(const Editor& editor, const Modifiers& modifiers);

}  // namespace foldless
