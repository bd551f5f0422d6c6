// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {

namespace fs = std::filesystem;

/// An editor that keeps copies of unsaved work.
class AutosaveTest : public EditorTest {
 protected:
  AutosaveTest() { start(); }

  /// As a program that is started anew.
  void start() {
    editor_.reset();
    now_ = 0;
    make_editor({.state_folder = folder_.path() / "state", .wake = {}});
  }
  fs::path root() const { return folder_.path() / "state/autosave"; }
  /// Copies come and go on a thread of the editor: what has gone while the folders are listed does
  /// not count.
  std::size_t copies() const {
    std::size_t count = 0;
    std::error_code gone;
    for (const fs::directory_entry& folder : fs::directory_iterator(root(), gone))
      for (const fs::directory_entry& entry : fs::directory_iterator(folder, gone))
        count += entry.path().extension() == ".json" && entry.path().stem() != "origin";
    return count;
  }
  void pass(double seconds) {
    now_ += seconds;
    frame();
  }
  void pose() {
    open_grid(6);
    place(0);
    const int id = place(35);
    const Vec2 from = pixel_of_handle(id);
    drag(from, from + Vec2(-120, 90));
    settle();
  }
  void wait_for_copies(std::size_t count) {
    wait_for([&] { return copies() >= count; });
  }
  /// Ends without being asked to, once there is a copy.
  void crash() {
    pass(61);
    wait_for_copies(1);
    start();
  }
  void find_lost_work() {
    editor_->files().recovery().find();
    if (!editor_->files().recovery().is_open()) return;
    wait_for([&] {
      const Recovery& recovery = editor_->files().recovery();
      return recovery.work() || !recovery.problem().empty();
    });
  }
  std::string toasts() const {
    std::string all;
    for (const Toast& toast : editor_->messages().toasts()) all += toast.text + "\n";
    return all;
  }

  TemporaryFolder folder_;
};

}  // namespace foldless::test
