// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/interface_commands.h"

#include <array>
#include <cmath>
#include <utility>

#include "app/editor/editor.h"

namespace foldless {
namespace {

/// A submenu of a menu.
struct Submenu {
  std::string_view menu, title;
};
constexpr Submenu kAutosave{"File", "Keep a copy of changes within"};
constexpr Submenu kTheme{"View", "Theme"};
constexpr Submenu kScale{"View", "Interface size"};
constexpr Submenu kWorkspace{"View", "Workspace"};

/// One of several values of a setting.
template <class Value>
InterfaceCommand choice(const Submenu& place, std::string title, Value Settings::*setting,
                        Value value) {
  return {place.menu,
          place.title,
          std::move(title),
          {},
          [=](UiState& state) { state.settings.*setting = value; },
          [=](const UiState& state) { return state.settings.*setting == value; }};
}

void add_autosave(std::vector<InterfaceCommand>& commands) {
  for (const auto& [title, seconds] :
       {std::pair{"15 seconds", 15.0}, std::pair{"1 minute", 60.0}, std::pair{"5 minutes", 300.0},
        std::pair{"15 minutes", 900.0}, std::pair{"1 hour", 3600.0}})
    commands.push_back(choice(kAutosave, title, &Settings::autosave_seconds, seconds));
}

void add_look(std::vector<InterfaceCommand>& commands) {
  for (const auto& [title, theme] :
       {std::pair{"Dark", Theme::dark}, std::pair{"Light", Theme::light},
        std::pair{"High contrast", Theme::contrast}})
    commands.push_back(choice(kTheme, title, &Settings::theme, theme));
  for (const int percent : {75, 100, 125, 150, 175, 200, 250, 300})
    commands.push_back(
        choice(kScale, std::to_string(percent) + " %", &Settings::scale, percent / 100.0));
}

void add_panels(std::vector<InterfaceCommand>& commands) {
  commands.push_back(
      choice(kWorkspace, "Animate", &Settings::workspace, std::optional(Workspace::animate)));
  commands.push_back(
      choice(kWorkspace, "Lab", &Settings::workspace, std::optional(Workspace::lab)));
  commands.push_back({kWorkspace.menu,
                      kWorkspace.title,
                      "Switch to the other",
                      {Key::f3, {}},
                      [](UiState& state) {
                        state.settings.workspace =
                            state.workspace == Workspace::lab ? Workspace::animate : Workspace::lab;
                      },
                      {}});
  commands.push_back(
      {"View",
       "",
       "Side panels",
       {Key::f4, {}},
       [](UiState& state) { state.settings.shows_panels = !state.settings.shows_panels; },
       [](const UiState& state) { return state.settings.shows_panels; }});
}

std::string words_of(const InterfaceCommand& command) {
  std::string words = std::string(command.menu) + ": ";
  if (!command.submenu.empty()) words += std::string(command.submenu) + ": ";
  return words + command.title;
}

void add_commands(std::vector<Action>& actions, Editor& editor) {
  for (const Command& command : commands())
    actions.push_back({std::string(command.menu) + ": " + std::string(command.title),
                       shortcut_words(command), is_available(command, editor),
                       [&editor, name = command.name] { editor.run_command(name); }});
}

void add_interface(std::vector<Action>& actions, UiState& state) {
  for (const InterfaceCommand& command : interface_commands()) {
    const bool has_key = command.shortcut.key != Key::none;
    actions.push_back({words_of(command), has_key ? words_of(command.shortcut) : "", true,
                       [&state, &command] { command.run(state); }});
  }
}

void add_files(std::vector<Action>& actions, Editor& editor, const UiState& state) {
  for (const auto& path : editor.files().recent())
    actions.push_back({"File: Open recent: " + path.string(), "", true,
                       [&editor, path] { editor.files().open(path); }});
  for (const Sample& sample : state.samples)
    actions.push_back({"File: Samples: " + sample.title, "", true,
                       [&editor, path = sample.path] { editor.files().open_sample(path); }});
}

}  // namespace

const std::vector<InterfaceCommand>& interface_commands() {
  static const std::vector<InterfaceCommand> table = [] {
    std::vector<InterfaceCommand> commands;
    add_autosave(commands);
    add_look(commands);
    add_panels(commands);
    commands.push_back(
        {"Help", "", "Messages…", {}, [](UiState& state) { state.shows_log = true; }, {}});
    commands.push_back(
        {"Help", "", "About Foldless", {}, [](UiState& state) { state.shows_about = true; }, {}});
    return commands;
  }();
  return table;
}

bool run_interface_command(const Shortcut& shortcut, UiState& state) {
  for (const InterfaceCommand& command : interface_commands()) {
    if (command.shortcut.key == Key::none || command.shortcut != shortcut) continue;
    command.run(state);
    return true;
  }
  return false;
}

std::vector<Action> all_actions(Editor& editor, UiState& state) {
  std::vector<Action> actions;
  add_commands(actions, editor);
  add_interface(actions, state);
  add_files(actions, editor, state);
  return actions;
}

}  // namespace foldless
