// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/tooltips.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

namespace foldless {
namespace {

constexpr double kTooltipSeconds = 0.5;
constexpr float kTextWidth = 300;  // design pixels

Rectangle rectangle_of(const ImVec2& low, const ImVec2& high) {
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}

/// The window or popup that the present child window is a part of.
const ImGuiWindow& whole_window() {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  while ((window->Flags & ImGuiWindowFlags_ChildWindow) &&
         !(window->Flags & ImGuiWindowFlags_Popup) && window->ParentWindow)
    window = window->ParentWindow;
  return *window;
}

bool fits(const Rectangle& place, const Rectangle& display) {
  return place.x >= display.x && place.y >= display.y &&
         place.x + place.width <= display.x + display.width &&
         place.y + place.height <= display.y + display.height;
}

}  // namespace

Rectangle tooltip_place(const TooltipSite& site, const ImVec2& size, float gap) {
  const auto& [item, surroundings, display] = site;
  const auto [width, height] = size;
  const auto within = [](float at, float length, float low, float room) {
    return std::max(low, std::min(at, low + room - length));
  };
  const float x = within(item.x, width, display.x, display.width);
  const float y = within(item.y, height, display.y, display.height);
  const float right = surroundings.x + surroundings.width;
  const float bottom = surroundings.y + surroundings.height;
  struct Side {
    float distance;  ///< between item and edge
    Rectangle place;
  };
  std::array<Side, 4> sides{{
      {bottom - item.y - item.height, {x, bottom + gap, width, height}},
      {item.y - surroundings.y, {x, surroundings.y - gap - height, width, height}},
      {item.x - surroundings.x, {surroundings.x - gap - width, y, width, height}},
      {right - item.x - item.width, {right + gap, y, width, height}},
  }};
  std::ranges::stable_sort(sides, {}, &Side::distance);
  for (const Side& side : sides)
    if (fits(side.place, display)) return side.place;
  const Rectangle below{x, item.y + item.height + gap, width, height};
  return fits(below, display) ? below : Rectangle{x, item.y - gap - height, width, height};
}

void Tooltips::begin_frame(double time) {
  const ImGuiIO& io = ImGui::GetIO();
  time_ = time;
  is_awaited_ = false;
  shown_before_ = std::exchange(shown_, std::nullopt);
  if (io.MousePos.x != pointer_.x || io.MousePos.y != pointer_.y) rests_since_ = time;
  pointer_ = io.MousePos;
  if (!ImGui::IsAnyMouseDown()) return;
  rests_since_.reset();
  shown_before_.reset();
}

bool Tooltips::is_due() const { return rests_since_ && time_ - *rests_since_ >= kTooltipSeconds; }

std::optional<double> Tooltips::due() const {
  if (!is_awaited_ || !rests_since_) return std::nullopt;
  return *rests_since_ + kTooltipSeconds;
}

void Tooltips::show(const std::string& text, const Look& look) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const Rectangle place = rectangle_of(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  const Item item{place.x, place.y, place.width, place.height};
  if (!is_due() && shown_before_ != item) {
    is_awaited_ = true;
    return;
  }
  shown_ = item;
  const ImVec2 padding{look.px(8), look.px(6)};
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, look.px(kTextWidth));
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImGuiWindow& window = whole_window();
  const Rectangle at =
      tooltip_place({.item = place,
                     .surroundings = {window.Pos.x, window.Pos.y, window.Size.x, window.Size.y},
                     .display = {0, 0, display.x, display.y}},
                    {size.x + 2 * padding.x, size.y + 2 * padding.y}, look.px(4));
  ImGui::SetNextWindowPos({at.x, at.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // of a greyed item too
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(look.px(kTextWidth) + padding.x);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar(2);
}

}  // namespace foldless
