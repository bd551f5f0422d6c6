// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/run_editor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "app/editor/editor.h"
#include "app/exit_status.h"
#include "app/gui/frame_log.h"
#include "app/gui/samples.h"
#include "app/gui/session_recorder.h"
#include "app/gui/ui.h"
#include "app/gui/window.h"
#include "core/error.h"
#include "core/run/interrupt.h"

namespace foldless {
namespace {

constexpr double kLongestNap = 0.5;  // seconds
constexpr const char* kNoDisplay =
    "There is no display to open a window on; `foldless solve SCENE -o DIR` and `foldless render "
    "FILE -o OUT.png` work without one (see `foldless --help`).";

/// Seconds since the program started.
class Clock {
 public:
  double now() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::filesystem::path frame_log_file() {
  const char* file = std::getenv("FOLDLESS_FRAME_LOG");
  return file ? file : "";
}

/// Where F12 writes while a scene has no file: the user's pictures, or the present folder.
std::filesystem::path pictures_folder() {
  std::error_code ignored;
  if (const char* home = std::getenv("HOME")) {
    auto pictures = std::filesystem::path(home) / "Pictures";
    if (std::filesystem::is_directory(pictures, ignored)) return pictures;
  }
  return std::filesystem::current_path(ignored);
}

class Session;

/// The session that runs, for a function that exit() calls, which is given nothing.
Session* running = nullptr;

/// The parts of the running program and its loop.
class Session {
 public:
  Session(const Settings& settings, const std::filesystem::path& state_folder,
          const std::filesystem::path& record)
      : window_("Foldless", {settings.window_width, settings.window_height}, settings.is_maximised),
        portal_(record.empty() ? session_bus_address() : "", window_.portal_name()),
        editor_({.state_folder = state_folder, .wake = [this] { window_.wake(); }}),
        ui_({.state_folder = state_folder,
             .pictures_folder = pictures_folder(),
             .clipboard = [this] { return window_.clipboard(); },
             .set_clipboard = [this](const std::string& text) { window_.set_clipboard(text); },
             .portal = &portal_}),
        log_(frame_log_file()),
        recorder_(record) {
    ui_.restore(editor_);
    running = this;
    std::atexit([] {
      if (running) running->rescue();
    });
  }
  ~Session() { running = nullptr; }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void open(const std::optional<std::filesystem::path>& file) {
    opened_ = opened_first(file, editor_.files().recent());
    if (opened_.is_sample)
      editor_.files().open_sample(opened_.file);
    else if (!opened_.file.empty())
      editor_.files().open(opened_.file);
    editor_.files().recovery().find();
  }

  /// Until the user leaves. Whatever else ends the program, unsaved work is kept: a signal, an
  /// exception, or the display's end, upon which Xlib calls exit().
  int run() {
    try {
      while (!ui_.wants_to_quit() && !interrupt_.is_requested()) {
        draw_frame();
        wait();
      }
    } catch (...) {
      rescue();
      throw;
    }
    if (ui_.wants_to_quit()) return kExitDone;
    if (const std::string problem = rescue(); !problem.empty())
      throw Error("no copy of unsaved work could be kept: " + problem);
    return kExitInterrupted;
  }

  /// Returns why that cannot be done.
  std::string rescue() { return editor_.files().rescue(); }

 private:
  void draw_frame() {
    const Extent framebuffer = window_.framebuffer_size();
    if (framebuffer.width == 0 || framebuffer.height == 0) return;
    last_start_ = clock_.now();
    const SessionWindow window{framebuffer, window_.size(), window_.content_scale()};
    record([&] { recorder_.follow(last_start_, window, opened_); });
    const bool has_drawn = ui_.frame(editor_, {framebuffer, window_.size(), window_.content_scale(),
                                               last_start_, !window_.take_damage()});
    window_.set_title(editor_.files().title() + " – Foldless");
    window_.set_cursor(ui_.cursor());
    remember_size();
    if (!has_drawn) return;
    const double drawn = clock_.now();
    window_.swap_buffers();
    log_.add({last_start_, drawn - last_start_, clock_.now() - last_start_,
              editor_.draft().is_editing(), editor_.playback().iterations().size()});
  }

  /// The work goes on where it can no longer be recorded.
  template <class Action>
  void record(const Action& action) {
    try {
      action();
    } catch (const Error& error) {
      editor_.messages().toast(ToastKind::error, error.what());
    }
  }

  void remember_size() {
    Settings& settings = ui_.settings();
    settings.is_maximised = window_.is_maximised();
    if (settings.is_maximised) return;
    const Extent size = window_.size();
    settings.window_width = static_cast<int>(std::lround(size.width / window_.content_scale()));
    settings.window_height = static_cast<int>(std::lround(size.height / window_.content_scale()));
  }

  /// Sleeps until the next frame is worth drawing: the solver may wake us more often than the
  /// display can show.
  void wait() {
    const auto next = ui_.next_frame(editor_, clock_.now());
    nap(next ? clock_.now() + *next : std::numeric_limits<double>::infinity());
    take_events();
    const double rest = last_start_ + window_.refresh_interval() - clock_.now();
    if (rest > 0) {
      window_.wait_events(rest);
      take_events();
    }
  }

  /// Sleeps until something happens, at most until then. A signal wakes nobody, so we look for one.
  void nap(double until) {
    bool is_woken = false;
    while (!is_woken && !interrupt_.is_requested() && clock_.now() < until) {
      const double start = clock_.now();
      const double length = std::min(until - start, kLongestNap);
      window_.wait_events(length);
      is_woken = clock_.now() - start < length;
    }
  }

  void take_events() {
    for (const UiEvent& event : window_.take_events()) {
      record([&] { recorder_.add(clock_.now(), event); });
      ui_.receive(event);
    }
    if (window_.take_close_request()) editor_.files().close();
  }

  Clock clock_;
  Window window_;
  Portal portal_;  ///< to nothing while a session is recorded: what it chose could not be replayed
  Editor editor_;
  Ui ui_;
  FrameLog log_;
  SessionRecorder recorder_;
  SessionStart opened_;
  Interrupt interrupt_;
  double last_start_ = 0;
};

}  // namespace

SessionStart opened_first(const std::optional<std::filesystem::path>& file,
                          const std::vector<std::filesystem::path>& recent) {
  if (file) return {*file, is_sample(*file)};
  std::error_code ignored;
  const auto is_there = [&](const auto& path) { return std::filesystem::exists(path, ignored); };
  if (std::ranges::any_of(recent, is_there)) return {};
  return {welcome_scene(), true};
}

int run_editor(const std::optional<std::filesystem::path>& file,
               const std::filesystem::path& record) {
  if (!has_display()) throw Error(kNoDisplay);
  const bool records = !record.empty();
  const std::filesystem::path state_folder = records ? "" : default_state_folder();
  Session session(records ? Settings() : load_settings(settings_file(state_folder)), state_folder,
                  record);
  session.open(file);
  return session.run();
}

}  // namespace foldless
