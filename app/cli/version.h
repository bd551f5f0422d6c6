// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace foldless {

/// `foldless 1.0.0` on a line.
std::string version_text();

/// The same, then the compiler and the packages that the program was built with, a line each.
std::string verbose_version_text();

}  // namespace foldless
