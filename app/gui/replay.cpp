// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/editor/editor.h"
#include "app/gui/session_file.h"
#include "app/gui/ui.h"
#include "core/error.h"
#include "render/offscreen.h"
#include "render/render_target.h"

namespace foldless {
namespace {

constexpr double kFrameSeconds = 0.001;  ///< between frames that no event asks for
constexpr int kMostFrames = 100;         ///< until the interface has nothing to do at once
constexpr std::chrono::seconds kPatience{120};

class Player {
 public:
  Player(const SessionWindow& window, const std::filesystem::path& shots)
      : window_(window),
        offscreen_(window.framebuffer.width, window.framebuffer.height),
        ui_({.pictures_folder = shots}),
        shots_(shots) {
    ui_.restore(editor_);
  }

  void open(const SessionStart& start) {
    if (start.is_sample)
      editor_.files().open_sample(start.file);
    else if (!start.file.empty())
      editor_.files().open(start.file);
    rest();
    const bool is_open = !editor_.document().is_empty() || editor_.files().image_import().is_open();
    if (!start.file.empty() && !is_open) throw Error(editor_.messages().log().back().text);
  }

  void play(const SessionEntry& entry) {
    time_ = std::max(time_, entry.time);
    if (const auto* event = std::get_if<UiEvent>(&entry.event)) ui_.receive(*event);
    if (const auto* window = std::get_if<SessionWindow>(&entry.event)) resize(*window);
    rest();
    if (const auto* shot = std::get_if<Shot>(&entry.event)) {
      save_png(shots_ / (shot->name + ".png"), picture());
      ++written_;
    }
  }

  void set_theme(Theme theme) { ui_.settings().theme = theme; }
  Image picture() {
    offscreen_.bind();
    ui_.draw_again();
    return offscreen_.read();
  }

  int written() const { return written_; }
  bool has_ended() const { return ui_.wants_to_quit(); }

 private:
  void resize(const SessionWindow& window) {
    window_ = window;
    offscreen_.resize(window.framebuffer.width, window.framebuffer.height);
  }

  void frame() {
    time_ += kFrameSeconds;
    unseen_.bind();
    ui_.frame(editor_, {window_.framebuffer, window_.window, window_.content_scale, time_, true});
  }

  /// Frames until nothing happens without an event.
  void rest() {
    const auto give_up = std::chrono::steady_clock::now() + kPatience;
    do {
      settle();
      while (is_busy(editor_, ui_)) {
        if (std::chrono::steady_clock::now() > give_up)
          throw Error("the editor did not come to rest");
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        frame();
      }
      settle();
    } while (is_busy(editor_, ui_));
  }

  void settle() {
    frame();
    for (int i = 0; i < kMostFrames && ui_.next_frame(editor_, time_) == 0.0; ++i) frame();
  }

  SessionWindow window_;
  Offscreen offscreen_;
  /// What frames are drawn into that are not looked at: their pixels would take most of the time.
  RenderTarget unseen_{1, 1, 1};
  Editor editor_;
  Ui ui_;
  std::filesystem::path shots_;
  double time_ = 0;
  int written_ = 0;
};

}  // namespace

bool is_busy(const Editor& editor, const Ui& ui) {
  return ui.is_exporting() || editor.playback().is_solving() || editor.race().is_playing() ||
         editor.files().texture_image().is_reading() || editor.files().image_import().is_busy();
}

Image picture_of_editor(const std::filesystem::path& file, Extent size,
                        std::optional<Theme> theme) {
  constexpr int kLeast = 64, kMost = 16384;  // pixels a side
  if (std::min(size.width, size.height) < kLeast || std::max(size.width, size.height) > kMost)
    throw Error("a window of " + std::to_string(size.width) + " × " + std::to_string(size.height) +
                " pixels cannot be drawn; a side has 64 to 16384");
  Player player({size, size, 1}, {});
  if (theme) player.set_theme(*theme);
  player.open({file, false});
  return player.picture();
}

int replay_session(const ReplayOptions& options) {
  SessionFile session = read_session(options.session);
  if (options.size) session.window.framebuffer = session.window.window = *options.size;
  std::error_code failure;
  std::filesystem::create_directories(options.shots, failure);
  if (failure) throw Error(options.shots.string() + ": " + failure.message());
  Player player(session.window, options.shots);
  player.open(session.start);
  for (const SessionEntry& entry : session.entries) {
    if (player.has_ended()) break;
    try {
      player.play(entry);
    } catch (const Error& error) {
      throw Error(options.session.string() + ':' + std::to_string(entry.line) + ": " +
                  error.what());
    }
  }
  return player.written();
}

}  // namespace foldless
