// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/short_text.h"

#include <imgui.h>

#include <array>
#include <cstdio>

namespace foldless {
namespace {

/// Where a character of UTF-8 begins, at or before `at`.
std::size_t beginning(const std::string& text, std::size_t at) {
  while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U)
    --at;
  return at;
}

}  // namespace

std::string short_number(double value, int digits) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  std::string text = buffer.data();
  const auto e = text.find('e');
  if (e == std::string::npos) return text;
  if (text[e + 1] == '+') text.erase(e + 1, 1);
  const std::size_t first = e + (text[e + 1] == '-' ? 2 : 1);
  while (text[first] == '0' && first + 1 < text.size()) text.erase(first, 1);
  return text;
}

std::string shortened(const std::string& text, float width) {
  std::string shown = text;
  for (std::size_t kept = text.size(); ImGui::CalcTextSize(shown.c_str()).x > width && kept > 0;) {
    kept = beginning(text, kept - 1);
    shown = text.substr(0, kept) + "…";
  }
  return shown;
}

std::string elided(const std::string& text, float width) {
  std::string shown = text;
  // One letter less at a time, from the longer half.
  for (std::size_t kept = text.size(); ImGui::CalcTextSize(shown.c_str()).x > width && kept > 0;) {
    --kept;
    const std::size_t head = beginning(text, (kept + 1) / 2);
    const std::size_t tail = beginning(text, text.size() - kept / 2);
    shown = text.substr(0, head) + "…" + text.substr(tail);
  }
  return shown;
}

}  // namespace foldless
