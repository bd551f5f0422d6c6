// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/scene/parameters.h"

namespace foldless {

/// What kind of value a parameter is; a flag is 0 or 1, a word the index of one of several.
enum class ParameterKind { real, whole, flag, word };

/// One key under `solver` of a scene file, and the values that it may have.
struct ParameterKey {
  std::string_view name;
  ParameterKind kind = ParameterKind::real;
  double minimum = 0;
  double maximum = 0;
  bool bounds_excluded = false;                     ///< the interval is open
  std::optional<double> (*get)(const Parameters&);  ///< nothing: the default of the energy
  void (*set)(Parameters&, double value);
  std::span<const std::string_view> words;  ///< of a word
};

/// Every key but `method`, in the order in which they are written.
std::span<const ParameterKey> parameter_keys();

/// The row of that name, or null.
const ParameterKey* find_parameter_key(std::string_view name);

/// The index of a word of the key, or nothing.
std::optional<double> index_of_word(const ParameterKey& key, std::string_view word);

/// `must be a number greater than 0 and less than 1`, or nothing when the value is allowed.
std::optional<std::string> objection(const ParameterKey& key, double value);

}  // namespace foldless
