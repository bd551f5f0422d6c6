// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window.h"

#include <cstdlib>
#include <sstream>
#include <utility>

#include "app/gui/app_icon.h"
#include "app/gui/glfw.h"
#include "core/error.h"

namespace foldless {
namespace {

/// GLFW's last error as the end of a sentence.
std::string glfw_reason() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  return reason ? std::string(": ") + reason + "." : ".";
}

void set_context_hints() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "foldless");
}

/// The functions of GL for the window's context. Ends GLFW and throws Error when they are missing.
void load_gl(GLFWwindow* window) {
  glfwMakeContextCurrent(window);
  if (gladLoadGL(glfwGetProcAddress) != 0) return;
  glfwTerminate();
  throw Error("The functions of OpenGL 3.3 cannot be loaded.");
}

/// True when the processor draws: four samples a pixel would make every frame several times slower.
bool is_drawn_by_processor() {
  const auto* words = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = words ? words : "";
  return renderer.find("llvmpipe") != std::string::npos ||
         renderer.find("softpipe") != std::string::npos;
}

/// A hidden window with its context current and its functions loaded, or null.
GLFWwindow* make_window(const std::string& title, Extent size) {
  set_context_hints();
  for (const int samples : {4, 2, 0}) {
    glfwWindowHint(GLFW_SAMPLES, samples);
    GLFWwindow* window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (!window) continue;
    load_gl(window);
    if (samples == 0 || !is_drawn_by_processor()) return window;
    glfwDestroyWindow(window);
  }
  return nullptr;
}

}  // namespace

bool has_display() {
  const char* x11 = std::getenv("DISPLAY");
  return x11 && *x11 != '\0';
}

Window::Window(const std::string& title, Extent size, bool is_maximised) : title_(title) {
  if (!glfwInit()) throw Error("The window system cannot be used" + glfw_reason());
  window_ = make_window(title, size);
  if (!window_) {
    const std::string reason = glfw_reason();
    glfwTerminate();
    throw Error("No window with OpenGL 3.3 can be opened" + reason);
  }
  glfwSwapInterval(1);
  glfwSetWindowSizeLimits(window_, 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
  make_cursors();
  set_icon();
  if (is_maximised) glfwMaximizeWindow(window_);
  send_events_to(window_, events_);
  glfwShowWindow(window_);
}

Window::~Window() {
  for (GLFWcursor* cursor : cursors_) glfwDestroyCursor(cursor);
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::make_cursors() {
  for (const int shape : {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_HAND_CURSOR,
                          GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR})
    cursors_.push_back(glfwCreateStandardCursor(shape));
}

void Window::wait_events(double seconds) {
  if (seconds < 0) {
    glfwWaitEvents();
  } else if (seconds == 0) {
    glfwPollEvents();
  } else {
    glfwWaitEventsTimeout(seconds);
  }
  is_woken_ = false;
}

void Window::wake() {
  if (!is_woken_.exchange(true)) glfwPostEmptyEvent();
}

void Window::set_icon() {
  std::vector<Image> pictures{app_icon(16), app_icon(32), app_icon(64)};
  std::vector<GLFWimage> icons;
  icons.reserve(pictures.size());
  for (Image& picture : pictures)
    icons.push_back({picture.width, picture.height, picture.pixels.data()});
  glfwSetWindowIcon(window_, static_cast<int>(icons.size()), icons.data());
}

bool Window::is_maximised() const {
  return glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
}

std::vector<UiEvent> Window::take_events() { return std::exchange(events_.events, {}); }

bool Window::take_close_request() {
  const bool asked = glfwWindowShouldClose(window_) != 0;
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  return asked;
}

Extent Window::size() const {
  Extent extent;
  glfwGetWindowSize(window_, &extent.width, &extent.height);
  return extent;
}

Extent Window::framebuffer_size() const {
  Extent extent;
  glfwGetFramebufferSize(window_, &extent.width, &extent.height);
  return extent;
}

float Window::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0 ? x : 1;
}

/// Only GLFW for X11 has the function, and which one is installed is known when we run.
std::string Window::portal_name() const {
  using WindowNumber = unsigned long (*)(GLFWwindow*);
  const auto number = reinterpret_cast<WindowNumber>(look_for_function(kGlfw, "glfwGetX11Window"));
  if (!number) return "";
  std::ostringstream name;
  name << "x11:" << std::hex << number(window_);
  return name.str();
}

double Window::refresh_interval() const {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  return mode && mode->refreshRate > 0 ? 1.0 / mode->refreshRate : 1.0 / 60;
}

void Window::set_title(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::set_cursor(CursorShape shape) {
  if (shape == cursor_) return;
  cursor_ = shape;
  glfwSetCursor(window_, cursors_[static_cast<std::size_t>(shape)]);
}

std::string Window::clipboard() const {
  const char* text = glfwGetClipboardString(window_);
  return text ? text : "";
}

void Window::set_clipboard(const std::string& text) {
  glfwSetClipboardString(window_, text.c_str());
}

void Window::swap_buffers() { glfwSwapBuffers(window_); }

}  // namespace foldless
