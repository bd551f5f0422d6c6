// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace foldless {

/// How many scans a JPEG file begins. Of a progressive one each goes over the whole picture, in
/// however few bytes, so that their number is what decoding costs.
std::size_t jpeg_scans(std::string_view file);

/// Throws Error, which names no file, where there are more than any program writes.
void check_jpeg_scans(std::string_view file, long pixels);

}  // namespace foldless
