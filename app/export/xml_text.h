// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace foldless {

/// A text inside of XML: & < > and quotes as entities.
std::string xml_escaped(std::string_view text);

/// A text of any bytes as UTF-8 in one line: what is no UTF-8 becomes U+FFFD, control characters
/// become spaces.
std::string readable(const std::string& text);

}  // namespace foldless
