// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/easing_curve.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

constexpr float kBeyondCurve = 0.5F;  ///< of the height, above and below
constexpr float kCurveEnd = 5;        ///< radius of an end [design pixels]

/// Where shares are in the window.
struct CurvePlace {
  ImVec2 corner;  ///< upper left
  float width, height;

  ImVec2 at(const Vec2& share) const {
    return {corner.x + width * static_cast<float>(share.x()),
            corner.y + height * (1 + kBeyondCurve - static_cast<float>(share.y()))};
  }
  /// Kept within what is drawn.
  Vec2 share_at(const ImVec2& pointer) const {
    const auto x = static_cast<double>((pointer.x - corner.x) / width);
    const auto y = static_cast<double>(1 + kBeyondCurve - (pointer.y - corner.y) / height);
    constexpr double kMost = static_cast<double>(kBeyondCurve);
    return {std::clamp(x, 0.0, 1.0), std::clamp(y, -kMost, 1 + kMost)};
  }
  float distance(const Vec2& share, const ImVec2& pointer) const {
    const ImVec2 point = at(share);
    const float x = point.x - pointer.x, y = point.y - pointer.y;
    return x * x + y * y;
  }
};

void paint_curve(const Easing& easing, const CurvePlace& place, const Look& look) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 faint = packed(look.palette->dim, 0.4F), accent = packed(look.palette->accent);
  const ImVec2 from = place.at({0, 0}), to = place.at({1, 1});
  list.AddRect({from.x, to.y}, {to.x, from.y}, faint);
  if (easing.is_held) {
    list.AddLine(from, place.at({1, 0}), accent, look.px(2));
    list.AddLine(place.at({1, 0}), to, accent, look.px(2));
    return;
  }
  const ImVec2 first = place.at(easing.first), second = place.at(easing.second);
  list.AddBezierCubic(from, first, second, to, accent, look.px(2));
  for (const auto& [end, start] : {std::pair{first, from}, {second, to}}) {
    list.AddLine(start, end, packed(look.palette->text), look.px(1));
    list.AddCircleFilled(end, look.px(kCurveEnd), packed(look.palette->text));
  }
}

}  // namespace

std::optional<Easing> draw_easing_curve(const Easing& easing, std::optional<PulledCurve>& pulled,
                                        const Look& look) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float room = look.px(kCurveEnd + 1);  // for ends at the borders
  const CurvePlace place{
      {corner.x + room, corner.y + room}, look.px(kCurveWidth), look.px(kCurveHeight)};
  ImGui::InvisibleButton(
      "##easing curve", {place.width + 2 * room, place.height * (1 + 2 * kBeyondCurve) + 2 * room});
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if (ImGui::IsItemActivated()) {
    pulled = PulledCurve{easing};
    pulled->easing.is_held = false;
    if (place.distance(easing.second, pointer) < place.distance(easing.first, pointer))
      pulled->end = &Easing::second;
  }
  std::optional<Easing> chosen;
  if (pulled && ImGui::IsItemActive()) {
    const bool is_pulled = ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1);
    if (is_pulled) pulled->easing.*pulled->end = place.share_at(pointer);
  } else if (pulled) {
    // Otherwise the list was closed while it was pulled.
    const bool is_let_go = ImGui::IsItemDeactivated();
    const Easing easing_so_far = std::exchange(pulled, {})->easing;
    if (is_let_go) chosen = easing_so_far;
  }
  paint_curve(pulled ? pulled->easing : chosen.value_or(easing), place, look);
  return chosen;
}

}  // namespace foldless
