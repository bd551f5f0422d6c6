// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace foldless {

/// A number in few letters: `1.23e4` and `2.8e-7`, where printf would write `1.23e+04`.
std::string short_number(double value, int digits);

/// The text, with "…" in place of its middle where it is wider than `width` in the present font.
std::string elided(const std::string& text, float width);
/// The same with "…" in place of its end.
std::string shortened(const std::string& text, float width);

}  // namespace foldless
