// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/editor/motion.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {

/// A grid that is held in three places, with the time line open and twelve frames.
class EditorMotion : public EditorTest {
 protected:
  void SetUp() override {
    EditorTest::SetUp();
    open_grid(9);
    for (const int vertex : {0, 8, 76}) ids_.push_back(place(vertex));
    settle();
    key(Key::t);
    ASSERT_EQ(editor_->document().handles.size(), 3U);
    motion().keys().set_cycle({12, false});
    frame();
  }

  Motion& motion() { return editor_->motion(); }
  const Animation& animation() { return motion().animation(); }
  /// Drags a handle as a person does, in the canvas.
  void drag_handle(int id, const Vec2& by) {
    const Vec2 from = pixel_of(shown_at(id));
    drag(from, from + by);
    frame();
  }
  Vec2 shown_at(int id) {
    const int vertex = find_handle(editor_->document(), id)->vertex;
    return editor_->shown()->deformed.col(vertex);
  }
  void solve_all() {
    const auto give_up = std::chrono::steady_clock::now() + kPatience;
    frame();
    while (!motion().frames().status().is_done) {
      ASSERT_LT(std::chrono::steady_clock::now(), give_up) << motion().frames().status().error;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      frame();
    }
    frame();
  }
  /// A handle that goes up from frame 0 to frame 8.
  void animate() {
    motion().play_head().go_to(8);
    frame();
    drag_handle(ids_[2], {0, -40});
    solve_all();
  }
  std::vector<int> key_frames() {
    std::vector<int> frames;
    for (const KeyPlace& key : keys_of(animation())) frames.push_back(key.frame);
    return frames;
  }

  std::vector<int> ids_;
};

}  // namespace foldless::test
