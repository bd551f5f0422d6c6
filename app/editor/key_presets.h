// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "app/editor/commands.h"

namespace foldless {

/// A command whose keys are others in a preset.
struct KeyDifference {
  std::string_view command;
  std::vector<Shortcut> keys;  ///< all it has there
};

/// Keys for people who come from elsewhere: what differs from the program's own.
struct KeyPreset {
  std::string_view name;   ///< stable, in the settings
  std::string_view title;  ///< words on screen
  std::vector<KeyDifference> differences;
};

/// The name of the preset without differences.
inline constexpr std::string_view kOwnKeys = "foldless";

/// All presets, the program's own first.
std::span<const KeyPreset> key_presets();

/// The preset of that name, or null.
const KeyPreset* find_key_preset(std::string_view name);

}  // namespace foldless
