// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/session_file.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/editor/commands.h"
#include "core/files/atomic_file.h"
#include "core/scene/json_value.h"

namespace foldless {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kButtons{"left", "right", "middle"};  // as in Button
constexpr int kLargestSide = 8192;

// Writing.

json point_json(const Vec2& p) { return {p.x(), p.y()}; }
json extent_json(Extent extent) { return {extent.width, extent.height}; }

json held_json(const Modifiers& modifiers) {
  json held = json::array();
  if (modifiers.shift) held.push_back("shift");
  if (modifiers.control) held.push_back("ctrl");
  if (modifiers.alt) held.push_back("alt");
  return held;
}

std::string_view button_name(Button button) { return kButtons[static_cast<std::size_t>(button)]; }

struct LineWriter {
  json& line;

  void operator()(const UiEvent& event) { std::visit(*this, event); }
  void operator()(const InputEvent& event) { std::visit(*this, event); }
  void operator()(const PointerPressed& e) { pointer("press", e); }
  void operator()(const PointerReleased& e) { pointer("release", e); }
  void operator()(const PointerMoved& e) {
    line["move"] = point_json(e.position);
    hold(e.modifiers);
  }
  void operator()(const PointerLeft&) { line["leave"] = true; }
  void operator()(const WindowLeft&) { line["leave"] = true; }
  void operator()(const WheelTurned& e) {
    line["wheel"] = e.notches;
    line["at"] = point_json(e.position);
  }
  void operator()(const KeyPressed& e) {
    line["key"] = words_of(Shortcut{e.key, {}});
    hold(e.modifiers);
    if (e.is_repeat) line["repeat"] = true;
  }
  void operator()(const KeyReleased& e) { line["key_up"] = words_of(Shortcut{e.key, {}}); }
  void operator()(const FilesDropped& e) {
    line["drop"] = json::array();
    for (const auto& path : e.paths) line["drop"].push_back(path.string());
  }
  void operator()(const FocusLost&) { line["focus_lost"] = true; }
  void operator()(const CharacterTyped& e) {
    std::array<char, 5> text{};
    ImTextCharToUtf8(text.data(), e.code_point);
    line["type"] = text.data();
  }
  void operator()(const ModifiersHeld& e) { line["held"] = held_json(e.modifiers); }
  void operator()(const SessionWindow& window) {
    line["size"] = extent_json(window.framebuffer);
    if (window.window != window.framebuffer) line["window"] = extent_json(window.window);
    if (window.content_scale != 1) line["scale"] = window.content_scale;
  }
  void operator()(const Shot& shot) { line["shot"] = shot.name; }

 private:
  template <class Event>
  void pointer(const char* what, const Event& e) {
    line[what] = button_name(e.button);
    line["at"] = point_json(e.position);
    hold(e.modifiers);
  }
  void hold(const Modifiers& modifiers) {
    if (!(modifiers == Modifiers{})) line["held"] = held_json(modifiers);
  }
};

template <class Write>
std::string line_by(double time, const Write& write) {
  json line{{"t", time}};
  write(LineWriter{line});
  return line.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

// Reading.

Extent read_extent(const JsonValue& value) {
  const Vec2 size = value.point();
  const auto is_side = [](double side) {
    return side >= 1 && side <= kLargestSide && side == static_cast<int>(side);
  };
  if (!is_side(size.x()) || !is_side(size.y()))
    value.refuse("is " + value.shown() + ", but a width and a height from 1 to " +
                 std::to_string(kLargestSide) + " pixels are needed");
  return {static_cast<int>(size.x()), static_cast<int>(size.y())};
}

SessionWindow read_window(const JsonValue& line) {
  SessionWindow window;
  window.framebuffer = window.window = read_extent(line.at("size"));
  if (const auto size = line.find("window")) window.window = read_extent(*size);
  if (const auto scale = line.find("scale"))
    window.content_scale = static_cast<float>(scale->number_above_zero());
  return window;
}

Modifiers read_held(const JsonValue& line) {
  Modifiers modifiers;
  const auto held = line.find("held");
  if (!held) return modifiers;
  for (const JsonValue& name : held->items()) {
    if (name.text() == "shift")
      modifiers.shift = true;
    else if (name.text() == "ctrl")
      modifiers.control = true;
    else if (name.text() == "alt")
      modifiers.alt = true;
    else
      name.refuse("is " + name.shown() + ", but shift, ctrl or alt is needed");
  }
  return modifiers;
}

Button read_button(const JsonValue& value) {
  for (std::size_t i = 0; i < kButtons.size(); ++i)
    if (value.text() == kButtons[i]) return static_cast<Button>(i);
  value.refuse("is " + value.shown() + ", but left, right or middle is needed");
}

Key read_key(const JsonValue& value) {
  const auto shortcut = shortcut_of(value.text());
  if (shortcut && shortcut->modifiers == Modifiers{}) return shortcut->key;
  value.refuse("is " + value.shown() + ", which is no key");
}

FilesDropped read_drop(const JsonValue& value, const std::filesystem::path& folder) {
  FilesDropped dropped;
  for (const JsonValue& path : value.items()) dropped.paths.push_back(folder / path.text());
  return dropped;
}

std::string read_shot(const JsonValue& value) {
  const std::string& name = value.text();
  if (name.empty() || name.front() == '.' || name.find('/') != std::string::npos)
    value.refuse("is " + value.shown() + ", but the name of a file without its folder is needed");
  return name;
}

/// One character each.
std::vector<SessionEvent> read_typed(const std::string& text) {
  std::vector<SessionEvent> events;
  const char* next = text.data();
  const char* end = next + text.size();
  while (next < end) {
    unsigned code_point = 0;
    next += ImTextCharFromUtf8(&code_point, next, end);
    events.emplace_back(UiEvent(CharacterTyped{code_point}));
  }
  return events;
}

std::vector<SessionEvent> read_events(const JsonValue& line, const std::filesystem::path& folder) {
  line.allow_only({"t", "press", "release", "move", "at", "held", "wheel", "key", "repeat",
                   "key_up", "drop", "focus_lost", "leave", "type", "size", "window", "scale",
                   "shot"});
  const Modifiers held = read_held(line);
  const auto input = [](const InputEvent& event) {
    std::vector<SessionEvent> events;
    events.emplace_back(std::in_place_type<UiEvent>, event);
    return events;
  };
  if (const auto v = line.find("press"))
    return input(PointerPressed{read_button(*v), line.at("at").point(), held});
  if (const auto v = line.find("release"))
    return input(PointerReleased{read_button(*v), line.at("at").point(), held});
  if (const auto v = line.find("move")) return input(PointerMoved{v->point(), held});
  if (const auto v = line.find("wheel"))
    return input(WheelTurned{v->number(), line.at("at").point()});
  if (const auto v = line.find("key")) {
    const auto repeat = line.find("repeat");
    return input(KeyPressed{read_key(*v), held, repeat && repeat->boolean()});
  }
  if (const auto v = line.find("key_up")) return input(KeyReleased{read_key(*v)});
  if (const auto v = line.find("drop")) return input(read_drop(*v, folder));
  if (line.find("focus_lost")) return input(FocusLost{});
  if (line.find("leave")) return {UiEvent(WindowLeft{})};
  if (const auto v = line.find("type")) return read_typed(v->text());
  if (line.find("size")) return {read_window(line)};
  if (const auto v = line.find("shot")) return {Shot{read_shot(*v)}};
  if (line.find("held")) return {UiEvent(ModifiersHeld{held})};
  line.refuse("has no event, such as move, press, key or shot");
}

/// The lines as the items of one array, each on its line.
std::string as_array(const std::string& lines) {
  std::string array = "[";
  bool is_first = true;
  std::size_t begin = 0;
  while (begin < lines.size()) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    const std::string line = lines.substr(begin, end - begin);
    if (line.find_first_not_of(" \t\r") != std::string::npos) {
      if (!std::exchange(is_first, false)) array += ',';
      array += line;
    }
    array += '\n';
    begin = end + 1;
  }
  return array + "]";
}

}  // namespace

SessionFile read_session(const std::filesystem::path& path) {
  return parse_session(read_file(path), path.string(),
                       std::filesystem::absolute(path).parent_path());
}

SessionFile parse_session(const std::string& text, const std::string& name,
                          const std::filesystem::path& folder) {
  const JsonNode node = parse_json(as_array(text), name);
  const std::vector<JsonValue> lines = JsonValue(node, name).items();
  if (lines.empty() || !lines.front().find("session"))
    JsonValue(node, name)
        .refuse(
            "is no session: it has to begin with a line such as "
            "{\"session\": 1, \"size\": [1280, 800]}");
  SessionFile session;
  const JsonValue& head = lines.front();
  head.allow_only({"session", "size", "window", "scale", "file", "sample"});
  if (head.at("session").integer() != 1)
    head.at("session").refuse("is " + head.at("session").shown() +
                              ", but this program reads version 1; use a newer Foldless");
  session.window = read_window(head);
  for (const char* key : {"file", "sample"})
    if (const auto file = head.find(key))
      session.start = {(folder / file->text()).lexically_normal(),
                       key == std::string_view("sample")};
  for (auto line = lines.begin() + 1; line != lines.end(); ++line) {
    const auto t = line->find("t");
    const double before = session.entries.empty() ? 0 : session.entries.back().time;
    for (SessionEvent& event : read_events(*line, folder))
      session.entries.push_back({t ? t->number() : before, std::move(event), line->node().line});
  }
  return session;
}

std::string first_line(const SessionWindow& window, const SessionStart& start,
                       const std::filesystem::path& folder) {
  json line{{"session", 1}};
  LineWriter{line}(window);
  if (!start.file.empty())
    line[start.is_sample ? "sample" : "file"] =
        std::filesystem::absolute(start.file).lexically_proximate(folder);
  return line.dump() + '\n';
}

std::string line_of(double time, const SessionEvent& event) {
  return line_by(time, [&event](LineWriter writer) { std::visit(writer, event); });
}

std::string line_of(double time, const UiEvent& event) {
  return line_by(time, [&event](LineWriter writer) { writer(event); });
}

}  // namespace foldless
