// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "app/editor/editor.h"
#include "app/gui/file_browser.h"
#include "core/run/latest_job.h"

namespace foldless {

/// One file that is made and written on a thread of its own while the user goes on: a picture, a
/// figure or a mesh.
class FileExport {
 public:
  using IsCancelled = std::atomic<bool>;
  /// Makes and writes it, on the thread; returns whether it did: not where it is cancelled before
  /// there is anything to write. Throws std::exception when it cannot.
  using Write = std::function<bool(const IsCancelled& is_cancelled)>;

  /// Begins. `asks_again`: the file browser, to ask for another name where it cannot be written;
  /// null: a message says it.
  /// Throws Error while it still writes another.
  void start(const std::filesystem::path& path, Write write, const FileBrowser* asks_again);
  /// Says what became of it when it is done.
  void update(Editor& editor, FileBrowser& browser);
  /// Nothing is written where that has not begun yet.
  void cancel() { is_cancelled_ = true; }
  bool is_busy() const { return is_busy_; }
  /// Throws Error while it still writes another.
  void expect_idle() const;
  /// That is being written.
  const std::filesystem::path& path() const { return path_; }

 private:
  struct End {
    bool is_written = false;
    std::string problem;
  };
  End end_of(const Write& write) const;

  bool is_busy_ = false;
  bool asks_again_ = false;
  std::size_t asked_ = 0;  ///< requests of the file browser up to that for this file
  std::filesystem::path path_;
  std::atomic<bool> is_cancelled_ = false;
  std::mutex mutex_;  ///< of what follows
  std::optional<End> end_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
