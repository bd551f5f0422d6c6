// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr ImGuiWindowFlags kToast = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_AlwaysAutoResize;

/// Returns its height. A click sends it away.
float draw_toast(const Toast& toast, const ImVec2& corner, Editor& editor, const Look& look) {
  const bool is_error = toast.kind == ToastKind::error;
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->popup);
  ImGui::PushStyleColor(ImGuiCol_Border, is_error ? look.palette->warning : look.palette->border);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0F, look.px(1)));
  ImGui::Begin(("##toast" + std::to_string(toast.id)).c_str(), nullptr, kToast);
  ImGui::PushTextWrapPos(
      std::min(look.px(360), corner.x - look.px(32)));  // the window may be small
  if (is_error) {
    ImGui::TextColored(look.palette->warning, "▲");
    ImGui::SameLine();
  }
  ImGui::TextUnformatted(toast.text.c_str());
  ImGui::PopTextWrapPos();
  const float height = ImGui::GetWindowHeight();
  const bool is_clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0);
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor(2);
  if (is_clicked) editor.messages().dismiss_toast(toast.id);
  return height;
}

}  // namespace

void draw_toasts(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle& canvas = context.layout.canvas;
  ImVec2 corner{canvas.x + canvas.width - look.px(12), canvas.y + canvas.height - look.px(12)};
  const auto toasts = editor.messages().toasts();
  for (const Toast& toast : toasts)
    corner.y -= draw_toast(toast, corner, editor, look) + look.px(8);
}

}  // namespace foldless
