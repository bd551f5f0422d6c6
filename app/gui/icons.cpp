// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons.h"

#include <array>
#include <cmath>
#include <string>

namespace foldless {
namespace {

constexpr std::array kIcons{Icon::play,       Icon::pause,   Icon::step,       Icon::back,
                            Icon::first,      Icon::last,    Icon::stop,       Icon::film,
                            Icon::up,         Icon::reset,   Icon::pointer,    Icon::brush,
                            Icon::pin,        Icon::turn,    Icon::scale,      Icon::forward,
                            Icon::backward,   Icon::remove,  Icon::undo,       Icon::redo,
                            Icon::reset_pose, Icon::fit,     Icon::mesh,       Icon::compare,
                            Icon::race,       Icon::picture, Icon::bones,      Icon::mirror,
                            Icon::record,     Icon::key,     Icon::onion_skin, Icon::time_line};

std::string utf8(Icon icon) {
  const auto character = static_cast<unsigned>(icon);
  return {static_cast<char>(0xE0U | (character >> 12U)),
          static_cast<char>(0x80U | ((character >> 6U) & 0x3FU)),
          static_cast<char>(0x80U | (character & 0x3FU))};
}

}  // namespace

std::span<const ImWchar> icon_ranges() {
  static const auto ranges = [] {
    std::array<ImWchar, 2 * kIcons.size() + 1> all{};
    for (std::size_t i = 0; i < kIcons.size(); ++i)
      all[2 * i] = all[2 * i + 1] = static_cast<ImWchar>(kIcons[i]);
    return all;
  }();
  return ranges;
}

void draw_icon(Icon icon, const IconPlace& place, ImU32 colour, const Look& look) {
  const auto& [corner, side] = place;
  ImFont* font = side < look.px(28) ? look.fonts.small_icons : look.fonts.icons;
  const std::string text = utf8(icon);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  const ImVec2 at{std::round(corner.x + (side - size.x) / 2),
                  std::round(corner.y + (side - size.y) / 2)};
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, colour, text.c_str());
}

}  // namespace foldless
