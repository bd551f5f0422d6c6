// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/interface_commands.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/editor.h"

namespace foldless {
namespace {

/// A submenu of a menu.
struct Submenu {
  std::string_view menu, title, name;
};
constexpr Submenu kAutosave{"File", "Keep a copy of changes within", "file.autosave."};
constexpr Submenu kTheme{"View", "Theme", "view.theme."};
constexpr Submenu kScale{"View", "Interface size", "view.size."};
constexpr Submenu kWorkspace{"View", "Workspace", "view.workspace."};

/// What a choice is called in its submenu, and by the rest of its stable name.
struct ChoiceWords {
  std::string title, name;
};

/// One of several values of a setting.
template <class Value>
InterfaceCommand choice(const Submenu& place, const ChoiceWords& words, Value Settings::*setting,
                        Value value) {
  return {std::string(place.name) + words.name,
          place.menu,
          place.title,
          words.title,
          {},
          [=](UiState& state) { state.settings.*setting = value; },
          [=](const UiState& state) { return state.settings.*setting == value; }};
}

/// A switch in a menu.
struct SwitchWords {
  std::string name, title;
  std::vector<Shortcut> shortcuts;
  std::string_view menu = "View";
};
InterfaceCommand on_off(SwitchWords words, bool Settings::*setting) {
  return {std::move(words.name),
          words.menu,
          "",
          std::move(words.title),
          std::move(words.shortcuts),
          [=](UiState& state) { state.settings.*setting = !(state.settings.*setting); },
          [=](const UiState& state) { return state.settings.*setting; }};
}

void add_autosave(std::vector<InterfaceCommand>& commands) {
  for (const auto& [title, seconds] :
       {std::pair{"15 seconds", 15.0}, std::pair{"1 minute", 60.0}, std::pair{"5 minutes", 300.0},
        std::pair{"15 minutes", 900.0}, std::pair{"1 hour", 3600.0}})
    commands.push_back(choice(kAutosave, {title, std::to_string(static_cast<int>(seconds))},
                              &Settings::autosave_seconds, seconds));
}

void add_desktop(std::vector<InterfaceCommand>& commands) {
  commands.push_back(on_off({"file.desktop_dialogs", "Dialogs of the desktop", {}, "File"},
                            &Settings::uses_desktop_dialogs));
}

void add_look(std::vector<InterfaceCommand>& commands) {
  const auto add_theme = [&commands](const ChoiceWords& words, Theme theme) {
    commands.push_back(choice(kTheme, words, &Settings::theme, theme));
  };
  add_theme({"Dark", "dark"}, Theme::dark);
  add_theme({"Light", "light"}, Theme::light);
  add_theme({"High contrast", "contrast"}, Theme::contrast);
  for (const int percent : {75, 100, 125, 150, 175, 200, 250, 300})
    commands.push_back(choice(kScale, {std::to_string(percent) + " %", std::to_string(percent)},
                              &Settings::scale, percent / 100.0));
}

void add_panels(std::vector<InterfaceCommand>& commands) {
  commands.push_back(choice(kWorkspace, {"Animate", "animate"}, &Settings::workspace,
                            std::optional(Workspace::animate)));
  commands.push_back(
      choice(kWorkspace, {"Lab", "lab"}, &Settings::workspace, std::optional(Workspace::lab)));
  commands.push_back({"view.workspace.switch",
                      kWorkspace.menu,
                      kWorkspace.title,
                      "Switch to the other",
                      {{Key::f3, {}}},
                      [](UiState& state) {
                        state.settings.workspace =
                            state.workspace == Workspace::lab ? Workspace::animate : Workspace::lab;
                      },
                      {}});
  commands.push_back(
      on_off({"view.panels", "Side panels", {{Key::f4, {}}}}, &Settings::shows_panels));
  commands.push_back(
      on_off({"view.rulers", "Rulers", {{Key::r, {.shift = true}}}}, &Settings::shows_rulers));
  commands.push_back(
      on_off({"view.artboard", "Outline of the canvas", {}}, &Settings::shows_artboard));
  commands.push_back(
      on_off({"view.squares", "Squares behind the picture", {}}, &Settings::shows_squares));
}

void add_dialogs(std::vector<InterfaceCommand>& commands) {
  commands.push_back({"handle.name",
                      "Handles",
                      "",
                      "Name…",
                      {{Key::f2, {}}},
                      [](UiState& state) { state.handle_name_frame = ImGui::GetFrameCount(); },
                      {}});
  commands.push_back(
      {"edit.keys", "Edit", "", "Keys…", {}, [](UiState& state) { state.keys.open(); }, {}});
  commands.push_back({"help.messages",
                      "Help",
                      "",
                      "Messages…",
                      {},
                      [](UiState& state) { state.shows_log = true; },
                      {}});
  commands.push_back({"help.about",
                      "Help",
                      "",
                      "About Foldless",
                      {},
                      [](UiState& state) { state.shows_about = true; },
                      {}});
}

std::string words_of(const InterfaceCommand& command) {
  return std::string(command.menu).append(": ") += words_in_menu(command);
}

void add_commands(std::vector<Action>& actions, Editor& editor) {
  for (const Command& command : commands())
    actions.push_back({std::string(command.menu) + ": " + std::string(command.title),
                       editor.keys().words(command.name), is_available(command, editor),
                       [&editor, name = command.name] { editor.run_command(name); }});
}

void add_interface(std::vector<Action>& actions, const Keymap& keys, UiState& state) {
  for (const InterfaceCommand& command : interface_commands())
    actions.push_back({words_of(command), keys.words(command.name), true,
                       [&state, &command] { command.run(state); }});
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
    add_desktop(commands);
    add_look(commands);
    add_panels(commands);
    add_dialogs(commands);
    return commands;
  }();
  return table;
}

bool run_interface_command(std::string_view name, UiState& state) {
  const auto& table = interface_commands();
  const auto it = std::ranges::find(table, name, &InterfaceCommand::name);
  if (it != table.end()) it->run(state);
  return it != table.end();
}

std::string words_in_menu(const InterfaceCommand& command) {
  if (command.submenu.empty()) return command.title;
  return std::string(command.submenu).append(": ") += command.title;
}

Keymap all_keys() {
  Keymap keys;
  for (const InterfaceCommand& command : interface_commands())
    keys.add({command.name, std::string(command.menu), words_in_menu(command), command.shortcuts});
  return keys;
}

std::vector<Action> all_actions(Editor& editor, UiState& state) {
  std::vector<Action> actions;
  add_commands(actions, editor);
  add_interface(actions, editor.keys(), state);
  add_files(actions, editor, state);
  return actions;
}

}  // namespace foldless
