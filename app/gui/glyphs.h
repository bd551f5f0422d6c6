// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string_view>

namespace foldless {

/// The characters that the interface has been asked to show beyond those of its own words: names
/// of files, what people type. They stay for as long as the program runs.
class Glyphs {
 public:
  /// Takes note of a text, UTF-8. What is no character is passed over.
  void need(std::string_view text);
  void need(char32_t character);

  const std::set<char32_t>& all() const { return characters_; }

 private:
  std::set<char32_t> characters_;
};

/// True for the characters that every font of the interface has from the start.
bool is_always_there(char32_t character);

}  // namespace foldless
