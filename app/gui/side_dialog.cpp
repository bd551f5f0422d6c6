// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/side_dialog.h"

#include <algorithm>
#include <cmath>

#include "app/gui/dialog_focus.h"

namespace foldless {
namespace {

constexpr float kDialogWidth = 284;  // design pixels

Rectangle dialog_place(const Layout& layout, float scale) {
  const float right = layout.status_bar.width;
  const float width =
      std::min(std::max(layout.right.width, std::round(kDialogWidth * scale)), 0.6F * right);
  const float top = layout.menu_bar.height;
  return {right - width, top, width, layout.status_bar.y - top};
}

}  // namespace

bool begin_side_dialog(const char* id, bool is_open, const PanelContext& context) {
  if (is_open && !ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  const Rectangle place = dialog_place(context.layout, context.look.scale);
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2{context.look.px(16), context.look.px(14)});
  const bool is_begun =
      ImGui::BeginPopupModal(id, nullptr,
                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (is_begun && !is_open) ImGui::CloseCurrentPopup();
  if (is_begun) begin_tab_stops();
  return is_begun;
}

void end_side_dialog() {
  end_tab_stops();
  ImGui::EndPopup();
}

Rectangle preview_place(const Layout& layout, float scale) {
  Rectangle place = layout.canvas;
  const float right = dialog_place(layout, scale).x;
  place.width = std::max(1.0F, std::min(place.width, right - place.x));
  return place;
}

}  // namespace foldless
