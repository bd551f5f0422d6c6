// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/glyphs.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "app/gui/fonts.h"

namespace foldless {

void Glyphs::need(std::string_view text) {
  const char* at = text.data();
  const char* end = at + text.size();
  while (at < end) {
    // Most texts are ASCII.
    at = std::find_if(at, end, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    if (at == end) return;
    unsigned int character = 0;
    at += ImTextCharFromUtf8(&character, at, end);
    need(character);
  }
}

void Glyphs::need(char32_t character) {
  // ImGui has no text beyond the basic plane, nor controls.
  if (character < 0xA0 || character > IM_UNICODE_CODEPOINT_MAX || character == 0xFFFD) return;
  if (!is_always_there(character)) characters_.insert(character);
}

bool is_always_there(char32_t character) {
  const auto ranges = interface_ranges();
  for (std::size_t i = 0; i + 1 < ranges.size(); i += 2)
    if (character >= ranges[i] && character <= ranges[i + 1]) return true;
  return false;
}

}  // namespace foldless
