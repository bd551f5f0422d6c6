// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/json_value.h"
#include "core/scene/parameter_keys.h"

namespace foldless {

/// The value of `key` in a JSON file as ParameterKey::set() takes it: of a flag 0 or 1, of a word
/// its index. Throws Error for what the key may not have.
double parameter_value(const ParameterKey& key, const JsonValue& value);

}  // namespace foldless
