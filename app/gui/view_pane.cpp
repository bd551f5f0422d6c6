// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/view_pane.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

constexpr double kZoomPerNotch = 1.15;
constexpr ImGuiWindowFlags kSeeThrough =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
    ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse;
constexpr ImGuiButtonFlags kAnyButton = ImGuiButtonFlags_MouseButtonLeft |
                                        ImGuiButtonFlags_MouseButtonRight |
                                        ImGuiButtonFlags_MouseButtonMiddle;

PaneInput read_mouse(const Rectangle& place, const Canvas& canvas) {
  const ImGuiIO& io = ImGui::GetIO();
  PaneInput input;
  const Vec2 pointer(io.MousePos.x - place.x, io.MousePos.y - place.y);
  if (ImGui::IsItemHovered()) input.pointer = pointer;
  if (ImGui::IsItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
    input.camera = panned(canvas.camera, {io.MouseDelta.x, io.MouseDelta.y});
  if (input.pointer && io.MouseWheel != 0)
    input.camera = zoomed_about(canvas.camera, canvas.size(), {pointer.x(), pointer.y()},
                                std::pow(kZoomPerNotch, static_cast<double>(io.MouseWheel)));
  return input;
}

}  // namespace

PaneInput view_pane(const char* id, const Rectangle& place, const Canvas& canvas) {
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
  PaneInput input;
  if (ImGui::Begin(id, nullptr, kSeeThrough)) {
    ImGui::InvisibleButton("##view", {std::max(1.0F, place.width), std::max(1.0F, place.height)},
                           kAnyButton);
    input = read_mouse(place, canvas);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  return input;
}

}  // namespace foldless
