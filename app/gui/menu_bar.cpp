// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <string>

#include "app/editor/commands.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

void draw_command(const Command& command, Editor& editor) {
  const bool checked = command.is_checked && command.is_checked(editor);
  if (ImGui::MenuItem(std::string(command.title).c_str(), shortcut_words(command).c_str(), checked,
                      is_available(command, editor)))
    editor.run_command(command.name);
}

void draw_samples(Editor& editor, const PanelContext& context) {
  if (!ImGui::BeginMenu("Samples", !context.state.samples.empty())) return;
  for (const Sample& sample : context.state.samples) {
    if (ImGui::MenuItem(sample.title.c_str())) editor.files().open_sample(sample.path);
    tooltip(sample.description, context.look);
  }
  ImGui::EndMenu();
}

void draw_recent(Editor& editor) {
  if (!ImGui::BeginMenu("Open recent", !editor.files().recent().empty())) return;
  const auto recent = editor.files().recent();
  for (const auto& path : recent)
    if (ImGui::MenuItem(path.c_str())) editor.files().open(path);
  ImGui::EndMenu();
}

void draw_autosave_menu(UiState& state) {
  struct Interval {
    const char* title;
    double seconds;
  };
  static constexpr std::array<Interval, 5> kIntervals{{{"15 seconds", 15},
                                                       {"1 minute", 60},
                                                       {"5 minutes", 300},
                                                       {"15 minutes", 900},
                                                       {"1 hour", 3600}}};
  if (!ImGui::BeginMenu("Keep a copy of changes within")) return;
  for (const Interval& interval : kIntervals)
    if (ImGui::MenuItem(interval.title, nullptr,
                        state.settings.autosave_seconds == interval.seconds))
      state.settings.autosave_seconds = interval.seconds;
  ImGui::EndMenu();
}

void draw_theme_menu(UiState& state) {
  static constexpr std::array kTitles{"Dark", "Light", "High contrast"};
  if (!ImGui::BeginMenu("Theme")) return;
  for (std::size_t i = 0; i < kTitles.size(); ++i) {
    const auto theme = static_cast<Theme>(i);
    if (ImGui::MenuItem(kTitles[i], nullptr, state.settings.theme == theme))
      state.settings.theme = theme;
  }
  ImGui::EndMenu();
}

void draw_scale_menu(UiState& state) {
  if (!ImGui::BeginMenu("Interface size")) return;
  for (const int percent : {75, 100, 125, 150, 175, 200, 250, 300}) {
    const double scale = percent / 100.0;
    const bool is_chosen = std::abs(state.settings.scale - scale) < 1e-6;
    if (ImGui::MenuItem((std::to_string(percent) + " %").c_str(), nullptr, is_chosen))
      state.settings.scale = scale;
  }
  ImGui::EndMenu();
}

void draw_extras(std::string_view menu, Editor& editor, const PanelContext& context) {
  UiState& state = context.state;
  if (menu == "File") {
    ImGui::Separator();
    draw_recent(editor);
    draw_samples(editor, context);
    draw_autosave_menu(state);
  } else if (menu == "View") {
    ImGui::Separator();
    draw_theme_menu(state);
    draw_scale_menu(state);
    ImGui::MenuItem("Side panels", nullptr, &state.settings.shows_panels);
  } else if (menu == "Help") {
    if (ImGui::MenuItem("About Foldless")) state.shows_about = true;
  }
}

/// The name of the document in the middle of what is left of the bar.
void draw_document_name(const Editor& editor, const PanelContext& context) {
  const std::string title = editor.files().title();
  const float width = ImGui::CalcTextSize(title.c_str()).x;
  const float middle = (context.layout.menu_bar.width - width) / 2;
  if (middle < ImGui::GetCursorPosX() + context.look.px(12)) return;
  ImGui::SameLine(middle);
  ImGui::TextColored(context.look.palette->dim, "%s", title.c_str());
}

}  // namespace

void draw_menu_bar(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const float padding =
      std::max(0.0F, (context.layout.menu_bar.height - look.fonts.text->FontSize) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{look.px(8), padding});
  const bool is_open = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!is_open) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{look.px(10), look.px(7)});
  for (const char* menu : {"File", "Edit", "Handles", "Solve", "View", "Help"}) {
    if (!ImGui::BeginMenu(menu)) continue;
    for (const Command& command : commands())
      if (command.menu == menu) draw_command(command, editor);
    draw_extras(menu, editor, context);
    ImGui::EndMenu();
  }
  draw_document_name(editor, context);
  ImGui::PopStyleVar();
  ImGui::EndMainMenuBar();
}

}  // namespace foldless
