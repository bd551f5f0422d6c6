// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <vector>

namespace foldless {

/// A font file and which of the characters that were asked for are drawn with it.
struct FallbackFont {
  std::filesystem::path file;
  int index = 0;  ///< of the face in the file
  std::set<char32_t> characters;
};

/// Fonts for characters: first those of `own`, font files in the order in which they are preferred,
/// then whatever outline font the system has, as fontconfig finds it. Characters that no font has
/// are in none of the sets.
std::vector<FallbackFont> fonts_for(std::set<char32_t> characters,
                                    const std::vector<std::filesystem::path>& own);

}  // namespace foldless
