// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace foldless {

/// Bytes made smaller in little time, for what has to be kept in memory. Throws Error where there
/// is not enough of it.
std::string packed(const std::vector<std::uint8_t>& bytes);

/// The `count` bytes that packed() was given.
std::vector<std::uint8_t> unpacked(const std::string& packed, std::size_t count);

}  // namespace foldless
