// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window_events.h"

#include <optional>

#include "app/gui/glfw.h"

namespace foldless {
namespace {

WindowEvents& state_of(GLFWwindow* window) {
  return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

std::vector<UiEvent>& events_of(GLFWwindow* window) { return state_of(window).events; }

void send(GLFWwindow* window, InputEvent event) {
  events_of(window).emplace_back(std::move(event));
}

Modifiers modifiers_of(int mods) {
  return {(mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_ALT) != 0};
}

/// Pointer motion has no modifiers in GLFW: ask the keyboard.
Modifiers held_modifiers(GLFWwindow* window) {
  const auto is_down = [window](int left, int right) {
    return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
  };
  return {is_down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
          is_down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
          is_down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

std::optional<Button> button_of(int button) {
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT: return Button::left;
    case GLFW_MOUSE_BUTTON_RIGHT: return Button::right;
    case GLFW_MOUSE_BUTTON_MIDDLE: return Button::middle;
    default: return std::nullopt;
  }
}

Key offset(Key first, int by) { return static_cast<Key>(static_cast<int>(first) + by); }

Key named_key(int key) {
  switch (key) {
    case GLFW_KEY_SPACE: return Key::space;
    case GLFW_KEY_ESCAPE: return Key::escape;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return Key::enter;
    case GLFW_KEY_TAB: return Key::tab;
    case GLFW_KEY_BACKSPACE: return Key::backspace;
    case GLFW_KEY_DELETE: return Key::del;
    case GLFW_KEY_HOME: return Key::home;
    case GLFW_KEY_END: return Key::end;
    case GLFW_KEY_PAGE_UP: return Key::page_up;
    case GLFW_KEY_PAGE_DOWN: return Key::page_down;
    case GLFW_KEY_LEFT: return Key::left;
    case GLFW_KEY_RIGHT: return Key::right;
    case GLFW_KEY_UP: return Key::up;
    case GLFW_KEY_DOWN: return Key::down;
    case GLFW_KEY_KP_ADD:
    case GLFW_KEY_EQUAL: return Key::plus;
    case GLFW_KEY_KP_SUBTRACT:
    case GLFW_KEY_MINUS: return Key::minus;
    case GLFW_KEY_COMMA: return Key::comma;
    case GLFW_KEY_PERIOD:
    case GLFW_KEY_KP_DECIMAL: return Key::period;
    case GLFW_KEY_BACKSLASH: return Key::backslash;
    case GLFW_KEY_SLASH: return Key::slash;
    case GLFW_KEY_LEFT_BRACKET: return Key::left_bracket;
    case GLFW_KEY_RIGHT_BRACKET: return Key::right_bracket;
    default: return Key::none;
  }
}

/// What is printed on the key in the user's layout, so that Ctrl+Z is where the Z is.
Key printed_key(int key, int scancode) {
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || name[0] == '\0' || name[1] != '\0') return Key::none;
  const char c = name[0];
  if (c >= 'a' && c <= 'z') return offset(Key::a, c - 'a');
  if (c >= '0' && c <= '9') return offset(Key::digit_0, c - '0');
  switch (c) {
    case '+':
    case '=': return Key::plus;
    case '-': return Key::minus;
    case ',': return Key::comma;
    case '.': return Key::period;
    case '\\': return Key::backslash;
    case '/': return Key::slash;
    case '[': return Key::left_bracket;
    case ']': return Key::right_bracket;
    default: return Key::none;
  }
}

Key key_of(int key, int scancode) {
  if (const Key printed = printed_key(key, scancode); printed != Key::none) return printed;
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return offset(Key::a, key - GLFW_KEY_A);
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return offset(Key::digit_0, key - GLFW_KEY_0);
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return offset(Key::f1, key - GLFW_KEY_F1);
  return named_key(key);
}

/// The key's own modifier counts: GLFW's `mods` are those before the event.
// NOLINTNEXTLINE(readability-function-size): GLFW says which parameters the function has.
void on_key(GLFWwindow* window, int glfw_key, int scancode, int action, int) {
  const Modifiers modifiers = held_modifiers(window);
  events_of(window).emplace_back(ModifiersHeld{modifiers});
  const Key key = key_of(glfw_key, scancode);
  if (key == Key::none) return;
  if (action == GLFW_RELEASE) return send(window, KeyReleased{key});
  send(window, KeyPressed{key, modifiers, action == GLFW_REPEAT});
}

void on_character(GLFWwindow* window, unsigned code_point) {
  events_of(window).emplace_back(CharacterTyped{code_point});
}

void on_button(GLFWwindow* window, int glfw_button, int action, int mods) {
  const auto button = button_of(glfw_button);
  if (!button) return;
  if (action == GLFW_PRESS)
    return send(window, PointerPressed{*button, state_of(window).pointer, modifiers_of(mods)});
  send(window, PointerReleased{*button, state_of(window).pointer, modifiers_of(mods)});
}

void on_motion(GLFWwindow* window, double x, double y) {
  state_of(window).pointer = {x, y};
  send(window, PointerMoved{{x, y}, held_modifiers(window)});
}

void on_wheel(GLFWwindow* window, double, double notches) {
  send(window, WheelTurned{notches, state_of(window).pointer});
}

void on_enter(GLFWwindow* window, int entered) {
  if (!entered) events_of(window).emplace_back(WindowLeft{});
}

void on_focus(GLFWwindow* window, int focused) {
  if (!focused) send(window, FocusLost{});
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
  FilesDropped dropped;
  for (int i = 0; i < count; ++i) dropped.paths.emplace_back(paths[i]);
  send(window, std::move(dropped));
}

}  // namespace

void send_events_to(GLFWwindow* window, WindowEvents& events) {
  glfwGetCursorPos(window, &events.pointer.x(), &events.pointer.y());
  glfwSetWindowUserPointer(window, &events);
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, on_character);
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetCursorPosCallback(window, on_motion);
  glfwSetScrollCallback(window, on_wheel);
  glfwSetCursorEnterCallback(window, on_enter);
  glfwSetWindowFocusCallback(window, on_focus);
  glfwSetDropCallback(window, on_drop);
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { state_of(w).is_damaged = true; });
}

}  // namespace foldless
