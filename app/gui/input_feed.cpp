// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input_feed.h"

#include <imgui.h>

#include <cfloat>
#include <optional>
#include <utility>

namespace foldless {
namespace {

template <class Event>
const Event* input_as(const UiEvent& event) {
  const InputEvent* input = std::get_if<InputEvent>(&event);
  return input ? std::get_if<Event>(input) : nullptr;
}

Key key_changed_by(const UiEvent& event) {
  if (const auto* pressed = input_as<KeyPressed>(event)) return pressed->key;
  if (const auto* released = input_as<KeyReleased>(event)) return released->key;
  return Key::none;
}

std::optional<Modifiers> modifiers_after(const UiEvent& event) {
  if (const auto* held = std::get_if<ModifiersHeld>(&event)) return held->modifiers;
  if (const auto* pressed = input_as<KeyPressed>(event)) return pressed->modifiers;
  return std::nullopt;
}

/// Multiplies the position of a pointer event.
void scale_position(UiEvent& event, const Vec2& pixels) {
  InputEvent* input = std::get_if<InputEvent>(&event);
  if (!input) return;
  std::visit(
      [&pixels](auto& e) {
        if constexpr (requires { e.position; }) e.position = e.position.cwiseProduct(pixels).eval();
      },
      *input);
}

void set_pointer(ImGuiIO& io, const Vec2& position) {
  io.MousePos = {static_cast<float>(position.x()), static_cast<float>(position.y())};
}

void release_everything(ImGuiIO& io) {
  for (bool& down : io.KeysDown) down = false;
  for (bool& down : io.MouseDown) down = false;
}

}  // namespace

void InputFeed::map_keys(ImGuiIO& io) {
  for (int& index : io.KeyMap) index = -1;
  for (const auto& [imgui, key] :
       std::initializer_list<std::pair<ImGuiKey_, Key>>{{ImGuiKey_Tab, Key::tab},
                                                        {ImGuiKey_LeftArrow, Key::left},
                                                        {ImGuiKey_RightArrow, Key::right},
                                                        {ImGuiKey_UpArrow, Key::up},
                                                        {ImGuiKey_DownArrow, Key::down},
                                                        {ImGuiKey_Home, Key::home},
                                                        {ImGuiKey_End, Key::end},
                                                        {ImGuiKey_PageUp, Key::page_up},
                                                        {ImGuiKey_PageDown, Key::page_down},
                                                        {ImGuiKey_Delete, Key::del},
                                                        {ImGuiKey_Backspace, Key::backspace},
                                                        {ImGuiKey_Space, Key::space},
                                                        {ImGuiKey_Enter, Key::enter},
                                                        {ImGuiKey_Escape, Key::escape},
                                                        {ImGuiKey_A, Key::a},
                                                        {ImGuiKey_C, Key::c},
                                                        {ImGuiKey_V, Key::v},
                                                        {ImGuiKey_X, Key::x},
                                                        {ImGuiKey_Y, Key::y},
                                                        {ImGuiKey_Z, Key::z}})
    io.KeyMap[imgui] = static_cast<int>(key);
}

bool InputFeed::fits(const UiEvent& event, Frame& frame) const {
  const bool is_button = input_as<PointerPressed>(event) || input_as<PointerReleased>(event);
  if (is_button || input_as<PointerMoved>(event)) {
    if (frame.has_button_change) return false;
    frame.has_button_change = is_button;
  }
  const auto modifiers = modifiers_after(event);
  if (modifiers && *modifiers != modifiers_ && !frame.changed_keys.empty()) return false;
  const Key key = key_changed_by(event);
  return key == Key::none || frame.changed_keys.insert(key).second;
}

std::vector<UiEvent> InputFeed::take_frame(ImGuiIO& io, const Vec2& pixels) {
  std::vector<UiEvent> taken;
  for (Frame frame; !queue_.empty() && fits(queue_.front(), frame); queue_.pop_front()) {
    taken.push_back(std::move(queue_.front()));
    scale_position(taken.back(), pixels);
    apply(taken.back(), io);
  }
  io.KeyShift = modifiers_.shift;
  io.KeyCtrl = modifiers_.control;
  io.KeyAlt = modifiers_.alt;
  return taken;
}

void InputFeed::apply(const UiEvent& event, ImGuiIO& io) {
  if (const auto* input = std::get_if<InputEvent>(&event)) apply(*input, io);
  if (const auto* typed = std::get_if<CharacterTyped>(&event))
    io.AddInputCharacter(typed->code_point);
  if (const auto* held = std::get_if<ModifiersHeld>(&event)) modifiers_ = held->modifiers;
  if (std::holds_alternative<WindowLeft>(event) && !ImGui::IsAnyMouseDown())
    io.MousePos = {-FLT_MAX, -FLT_MAX};
}

void InputFeed::apply(const InputEvent& event, ImGuiIO& io) {
  std::visit(
      [&](const auto& e) {
        using E = std::decay_t<decltype(e)>;
        if constexpr (requires { e.position; }) set_pointer(io, e.position);
        if constexpr (requires { e.modifiers; }) modifiers_ = e.modifiers;
        if constexpr (std::is_same_v<E, PointerPressed>)
          io.MouseDown[static_cast<int>(e.button)] = true;
        if constexpr (std::is_same_v<E, PointerReleased>)
          io.MouseDown[static_cast<int>(e.button)] = false;
        if constexpr (std::is_same_v<E, WheelTurned>)
          io.MouseWheel += static_cast<float>(e.notches);
        if constexpr (std::is_same_v<E, KeyPressed>)
          if (!e.is_repeat) io.KeysDown[static_cast<int>(e.key)] = true;
        if constexpr (std::is_same_v<E, KeyReleased>) io.KeysDown[static_cast<int>(e.key)] = false;
        if constexpr (std::is_same_v<E, FocusLost>) release_everything(io);
      },
      event);
  if (std::holds_alternative<FocusLost>(event)) modifiers_ = {};
}

}  // namespace foldless
