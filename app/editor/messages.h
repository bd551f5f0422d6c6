// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace foldless {

/// What the editor wants its surroundings to do; they take it with
/// Messages::take_requests().
enum class Request {
  open_dialog,     ///< ask for a file, then DocumentFiles::open
  image_dialog,    ///< ask for an image, then DocumentFiles::open
  save_dialog,     ///< ask for a path, then its save_as or, when dismissed, its answer(cancel)
  texture_dialog,  ///< ask for an image, then DocumentEdits::set_texture
  write_snapshot,  ///< a numbered PNG at once
  export_dialog,   ///< ask how to export
  export_again,    ///< export as last time
  export_csv,      ///< ask for a file, then write the iterations, the race's while there is one
  export_svg,      ///< ask for a file, then draw their convergence
  export_table,    ///< ask for a file, then write the race's table
  command_search,  ///< show the search over commands()
  cheat_sheet,     ///< show or hide the table of shortcuts
  quit             ///< nothing is unsaved, or the user said so: close the window
};

enum class ToastKind { notice, error };

/// A short message that goes away by itself.
struct Toast {
  int id = 0;
  ToastKind kind = ToastKind::notice;
  std::string text;  ///< one sentence
  double until = 0;  ///< when it goes away [s]
};

/// A message that was shown.
struct LoggedMessage {
  double time = 0;  ///< by the editor's clock [s]
  ToastKind kind = ToastKind::notice;
  std::string text;
};

/// What an editor says to its surroundings: requests, toasts, and that the picture is out of date.
/// Has the editor's clock, as toasts go away by it.
class Messages {
 public:
  /// Moves the clock on; toasts whose time has come go away. [s]
  void tick(double now);
  double now() const { return now_; }

  void request(Request request);
  /// What the surroundings should do, oldest first; each is given once.
  std::vector<Request> take_requests();

  void toast(ToastKind kind, std::string text);
  void dismiss_toast(int id);
  const std::vector<Toast>& toasts() const { return toasts_; }
  /// All that were shown, oldest first; the newest kMostLogged of them.
  const std::vector<LoggedMessage>& log() const { return log_; }
  static constexpr std::size_t kMostLogged = 1000;
  /// When the next toast goes away, if there is one. [s]
  std::optional<double> next_wake() const;

  /// Something on screen may have changed.
  void redraw() { needs_redraw_ = true; }
  /// Whether it was said since the last call.
  bool take_redraw();

 private:
  double now_ = 0;
  std::vector<Request> requests_;
  std::vector<Toast> toasts_;
  std::vector<LoggedMessage> log_;
  int next_toast_ = 1;
  bool needs_redraw_ = true;
};

}  // namespace foldless
