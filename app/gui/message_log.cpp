// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <cstdio>
#include <string>

#include "app/gui/dialog_keys.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

std::string time_words(double seconds) {
  const int whole = static_cast<int>(seconds);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%02d:%02d:%02d", whole / 3600, whole / 60 % 60,
                whole % 60);
  return text.data();
}

std::string text_of(const std::vector<LoggedMessage>& log) {
  std::string text;
  for (const LoggedMessage& message : log)
    text += time_words(message.time) + (message.kind == ToastKind::error ? "  error: " : "  ") +
            message.text + '\n';
  return text;
}

}  // namespace

void draw_message_log(Editor& editor, const PanelContext& context) {
  const char* id = "##log";
  if (context.state.shows_log && !ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  const Look& look = context.look;
  if (!begin_dialog(id, look, ImVec2{720, 420})) return;
  title_text("Messages", look);
  dim_text("Since the program was started, by hours, minutes and seconds.", look);
  std::string text = text_of(editor.messages().log());
  const float below = ImGui::GetFrameHeightWithSpacing() + look.px(4);
  ImGui::InputTextMultiline("##text", &text, {-1, ImGui::GetContentRegionAvail().y - below},
                            ImGuiInputTextFlags_ReadOnly);
  const DialogKeys keys = dialog_keys();
  if (main_button("Copy all", look)) ImGui::SetClipboardText(text.c_str());
  ImGui::SameLine();
  if (ImGui::Button("Close") || keys.leaves || keys.takes) {
    context.state.shows_log = false;
    ImGui::CloseCurrentPopup();
  }
  end_dialog();
}

}  // namespace foldless
