// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/editor.h"
#include "app/gui/extent.h"
#include "app/gui/layout.h"
#include "app/gui/portal.h"
#include "app/gui/settings.h"
#include "app/gui/ui_event.h"

namespace foldless {

/// What the interface needs from outside.
struct UiOptions {
  std::filesystem::path state_folder = {};     ///< settings; empty: nothing is kept on disk
  std::filesystem::path pictures_folder = {};  ///< for F12 while the scene has no file
  std::function<std::string()> clipboard = {};
  std::function<void(const std::string&)> set_clipboard = {};
  Portal* portal = nullptr;  ///< to the desktop's file dialog; null: our own is used
};

/// The framebuffer of one frame.
struct FrameSpec {
  Extent framebuffer;       ///< pixels
  Extent window;            ///< window coordinates, which pointer events use
  float content_scale = 1;  ///< pixels in a design pixel that the desktop asks for
  double time = 0;          ///< a clock that never goes back [s]
  bool is_kept = false;     ///< it still shows the last frame: one like that need not be drawn
};

/// The interface: panels, dialogs and the canvas, drawn into the framebuffer that is bound. Knows
/// no window system: events come in, pixels go out, in a window or off screen alike. Owns the
/// ImGui context; one at a time. All functions need the GL context of the constructor.
class Ui {
 public:
  /// Throws Error when the renderer cannot be built.
  explicit Ui(UiOptions options = {});
  ~Ui();
  Ui(const Ui&) = delete;
  Ui& operator=(const Ui&) = delete;

  /// Gives an editor in which nothing was opened yet what the user had the last time.
  void restore(Editor& editor) const;
  void receive(const UiEvent& event);
  /// Handles what was received, updates the editor, and draws both. Returns whether it drew: not
  /// where the framebuffer keeps a picture that would be the same.
  bool frame(Editor& editor, const FrameSpec& spec);
  /// Draws what was drawn last once more, into what is bound now.
  void draw_again();
  /// Seconds until another frame is due though nothing happens; nothing: only when something does.
  std::optional<double> next_frame(const Editor& editor, double now) const;

  /// A file is being written while the user goes on.
  bool is_exporting() const;
  /// It is one that takes a moment: a picture, a figure or a mesh.
  bool is_writing_a_file() const;

  /// Where things were in the last frame.
  const Layout& layout() const;
  CursorShape cursor() const;
  /// The user wants to leave, and nothing is unsaved.
  bool wants_to_quit() const;
  /// What the user chose for all documents; change it freely between frames.
  Settings& settings();

 private:
  struct Parts;
  void prepare(const Editor& editor, const FrameSpec& spec);
  void resize(Editor& editor);
  void route(Editor& editor, const std::vector<UiEvent>& events, double time);
  void draw_panels(Editor& editor);
  bool draw_frame(Editor& editor, const FrameSpec& spec);

  std::unique_ptr<Parts> parts_;
};

}  // namespace foldless
