// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

#include "app/editor/keymap.h"

namespace foldless {

/// What the user chose, as it is written: the preset's name, and the keys in words of the commands
/// that differ from it.
nlohmann::json keys_json(const KeyChoice& choice);

/// Reads what keys_json() made. What cannot be used is left out; the second says so in a sentence,
/// or is empty.
std::pair<KeyChoice, std::string> read_keys(const nlohmann::json& json);

}  // namespace foldless
