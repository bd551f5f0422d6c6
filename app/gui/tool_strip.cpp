// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>
#include <string_view>

#include "app/gui/command_button.h"
#include "app/gui/panels.h"

namespace foldless {
namespace {

struct Tool {
  std::string_view command;
  Icon icon;
};

constexpr std::array kHandTools{
    Tool{"handle.move", Icon::pointer}, Tool{"stiffness.paint", Icon::brush},
    Tool{"bones.draw", Icon::bones}, Tool{"mirror.toggle", Icon::mirror}};
constexpr std::array kHandleTools{
    Tool{"handle.turn", Icon::turn},     Tool{"handle.scale", Icon::scale},
    Tool{"handle.pin", Icon::pin},       Tool{"handle.forward", Icon::forward},
    Tool{"handle.back", Icon::backward}, Tool{"edit.delete", Icon::remove}};
constexpr std::array kStepTools{Tool{"edit.undo", Icon::undo}, Tool{"edit.redo", Icon::redo},
                                Tool{"edit.reset_pose", Icon::reset_pose}};
constexpr std::array kViewTools{Tool{"view.fit", Icon::fit}, Tool{"view.mesh", Icon::mesh},
                                Tool{"view.remesh_diff", Icon::compare},
                                Tool{"race.toggle", Icon::race},
                                Tool{"file.export", Icon::picture}};

/// In a low window the last groups are left out; the menus have all of them.
void draw_groups(Editor& editor, const Look& look) {
  const std::array<std::span<const Tool>, 4> groups{kHandTools, kHandleTools, kStepTools,
                                                    kViewTools};
  const float gap = look.px(9);
  for (const auto& group : groups) {
    const float height = static_cast<float>(group.size()) *
                         (ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y);
    if (ImGui::GetContentRegionAvail().y < height) return;
    if (group.data() != groups.front().data()) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float y = at.y + gap / 2 - ImGui::GetStyle().ItemSpacing.y / 2;
      ImGui::GetWindowDrawList()->AddLine({at.x + look.px(4), y},
                                          {at.x + ImGui::GetFrameHeight() - look.px(4), y},
                                          packed(look.palette->border));
      ImGui::Dummy({0, gap - ImGui::GetStyle().ItemSpacing.y});
    }
    for (const Tool& tool : group) command_button(tool.command, tool.icon, editor, look);
  }
}

constexpr ImGuiWindowFlags kStripFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus |
                                         ImGuiWindowFlags_NoScrollWithMouse;

}  // namespace

void draw_tool_strip(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle& place = context.layout.strip;
  if (place.width <= 0) return;
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(5), look.px(8)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{0, look.px(2)});
  const float padding = (place.width - 2 * look.px(5) - ImGui::GetFontSize()) / 2;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{padding, padding});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->bar);
  if (ImGui::Begin("##tools", nullptr, kStripFlags)) draw_groups(editor, look);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace foldless
