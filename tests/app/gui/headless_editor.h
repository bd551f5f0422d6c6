// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "app/editor/editor.h"
#include "app/gui/ui.h"
#include "render/image.h"
#include "render/offscreen.h"
#include "render/render_target.h"
#include "tests/support/patience.h"

namespace foldless::test {

inline constexpr Modifiers kControl{.control = true};
inline constexpr Modifiers kControlShift{.shift = true, .control = true};

/// The whole editor without a window: events in, pixels out, in OSMesa.
class HeadlessEditor {
 public:
  explicit HeadlessEditor(Extent size = {1280, 800}, UiOptions options = {},
                          EditorOptions editor_options = {});

  Editor& editor() { return editor_; }
  Ui& ui() { return ui_; }

  /// Framebuffer pixels in a window coordinate and a design pixel, as on a HiDPI desktop.
  void set_content_scale(float scale) { content_scale_ = scale; }

  /// Draws until nothing is left to do but wait, and until a file that is exported is there; the
  /// test fails if what was drawn then has defects.
  void settle();
  /// Draws until `done`, at most `seconds` of real time. False when it never was.
  bool wait_until(const std::function<bool()>& done, double seconds = kPatience.count());
  /// Seconds until the interface wants another frame; nothing: not until something happens.
  std::optional<double> next_frame() const { return ui_.next_frame(editor_, time_); }
  /// Lets messages go away and the pointer leave, so that nothing but the document is on screen.
  void calm_down();

  // Input, positions in window coordinates.

  void move(const Vec2& to);
  void press(const Vec2& at, Button button = Button::left);
  void release(const Vec2& at, Button button = Button::left);
  void click(const Vec2& at);
  void key(Key key, Modifiers modifiers = {});
  /// Keys that stay down until the next call.
  void hold(Modifiers modifiers);
  void type(std::string_view ascii);

  /// Plays the lines of a session after its first, see SessionFile; every event waits until the
  /// editor has come to rest. Returns its pictures by their names.
  std::map<std::string, Image> play(const std::string& lines);

  /// Where words are on screen, the topmost ones; nothing: nowhere.
  std::optional<Vec2> find_words(const std::string& words) const;
  /// Where a point of the mesh's plane is in the window.
  Vec2 window_point(const Vec2& world) const;
  /// The newest position of a vertex.
  Vec2 position(int vertex) const;

  /// How many frames were drawn: those like the one before are not.
  int drawn_frames() const { return drawn_frames_; }
  Image picture();
  /// The canvas alone.
  Image canvas_picture();

 private:
  void frame();
  void draw_what_is_due();
  void wait_for_file();
  void expect_no_defects();
  void send(InputEvent event);

  Extent size_;
  std::shared_ptr<Offscreen> offscreen_;
  /// What frames are drawn into that are not looked at: their pixels would take most of the time.
  RenderTarget unseen_{1, 1, 1};
  bool is_picture_drawn_ = false;
  Editor editor_;
  Ui ui_;
  float content_scale_ = 1;
  double time_ = 0;
  int drawn_frames_ = 0;
  Modifiers held_;
  std::set<std::string> known_defects_;  ///< each is said once
};

/// How many pixels of two pictures of one size differ.
int differing_pixels(const Image& a, const Image& b);

}  // namespace foldless::test
