// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace foldless::test {

/// The text with one to six random changes: a byte replaced, removed, doubled or inserted, or the
/// end cut off.
inline std::string mutated(std::string text, std::mt19937& random) {
  constexpr std::string_view kLikely = "0123456789-+.eE \n\r\t/\\#[]{}:,\"vfnaniOFFpply";
  const auto below = [&random](std::size_t n) { return random() % n; };
  const std::size_t changes = 1 + below(6);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    const char byte =
        below(4) == 0 ? static_cast<char>(below(256)) : kLikely[below(kLikely.size())];
    switch (below(6)) {
      case 0: text.erase(at, 1 + below(4)); break;
      case 1: text.insert(at, 1, byte); break;
      case 2: text.insert(at, text.substr(at, 1 + below(12))); break;
      case 3:
        if (below(8) == 0) text.resize(at);
        break;
      default: text[at] = byte;
    }
  }
  return text;
}

}  // namespace foldless::test
