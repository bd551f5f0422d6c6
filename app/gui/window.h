// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "app/gui/extent.h"
#include "app/gui/window_events.h"

struct GLFWwindow;
struct GLFWcursor;

namespace foldless {

/// True when there is a display to open a window on; says nothing about OpenGL.
bool has_display();

/// A GLFW window with an OpenGL 3.3 core context, made current. One at a time; only the thread
/// that made it may use it, but wake() is for any thread.
class Window {
 public:
  /// Size in design pixels. Asks for 4 samples a pixel; takes fewer when they are refused, and none
  /// when there is no graphics card.
  /// Throws Error when there is no display or no OpenGL 3.3.
  Window(const std::string& title, Extent size, bool is_maximised);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Sleeps until something happens, at most `seconds`; without limit when negative.
  void wait_events(double seconds);
  /// Ends wait_events(); cheap when called often.
  void wake();
  /// What happened since the last call, positions in window coordinates.
  std::vector<UiEvent> take_events();

  /// True once after the window's picture was lost, as behind another window.
  bool take_damage() { return std::exchange(events_.is_damaged, false); }
  /// True once after the user asked to close the window.
  bool take_close_request();
  Extent size() const;              ///< window coordinates
  Extent framebuffer_size() const;  ///< pixels
  float content_scale() const;      ///< pixels in a design pixel that the desktop asks for
  bool is_maximised() const;
  /// As portals name it, `x11:1a2b`; empty where it has no such name.
  std::string portal_name() const;
  double refresh_interval() const;  ///< seconds between two pictures of the display

  void set_title(const std::string& title);
  void set_cursor(CursorShape shape);
  std::string clipboard() const;
  void set_clipboard(const std::string& text);
  void swap_buffers();

 private:
  void make_cursors();
  void set_icon();

  GLFWwindow* window_ = nullptr;
  std::vector<GLFWcursor*> cursors_;
  WindowEvents events_;
  std::string title_;
  CursorShape cursor_ = CursorShape::arrow;
  std::atomic<bool> is_woken_ = false;
};

}  // namespace foldless
