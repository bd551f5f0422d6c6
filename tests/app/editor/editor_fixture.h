// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "app/editor/editor.h"
#include "core/mesh/injective.h"
#include "tests/support/meshes.h"
#include "tests/support/patience.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {

inline constexpr Modifiers kShift{.shift = true};
inline constexpr Modifiers kControl{.control = true};
inline constexpr Modifiers kControlShift{.shift = true, .control = true};

/// An editor on an 800 × 600 canvas, with hands and a clock.
class EditorTest : public ::testing::Test {
 protected:
  EditorTest() { make_editor({}); }

  void make_editor(EditorOptions options) {
    editor_ = std::make_unique<Editor>(std::move(options));
    editor_->view().resize(800, 600, 1);
  }

  void open_grid(int n) {
    Fixture grid = square_grid(n);
    editor_->files().open_shape(Shape{std::move(grid.triangles), std::move(grid.rest)}, "grid");
  }

  Vec2 pixel_of(const Vec2& world) const { return editor_->canvas().to_pixel(world); }
  Vec2 pixel_of_vertex(int v) const { return pixel_of(editor_->shown()->deformed.col(v)); }
  Vec2 pixel_of_handle(int id) const { return pixel_of(position(id)); }
  Vec2 position(int id) const {
    return position_of(editor_->document(), *find_handle(editor_->document(), id));
  }
  Vec2 target(int id) const { return find_handle(editor_->document(), id)->target; }

  void press(const Vec2& at, Modifiers modifiers = {}, Button button = Button::left) {
    editor_->receive(PointerPressed{button, at, modifiers}, now_);
  }
  void move(const Vec2& to) { editor_->receive(PointerMoved{to, {}}, now_); }
  void release(const Vec2& at, Button button = Button::left) {
    editor_->receive(PointerReleased{button, at, {}}, now_);
  }
  void click(const Vec2& at, Modifiers modifiers = {}) {
    press(at, modifiers);
    release(at);
  }
  void drag(const Vec2& from, const Vec2& to, Modifiers modifiers = {}) {
    press(from, modifiers);
    for (int k = 1; k <= 4; ++k) {
      move(from + (to - from) * k / 4);
      frame();
    }
    release(to);
  }
  void key(Key k, Modifiers modifiers = {}) {
    editor_->receive(KeyPressed{k, modifiers, false}, now_);
    editor_->receive(KeyReleased{k}, now_);
  }

  /// Places a handle on a vertex; returns its id.
  int place(int vertex) {
    click(pixel_of_vertex(vertex));
    return editor_->document().handles.back().id;
  }

  bool frame() {
    now_ += 1.0 / 60;
    return editor_->update(now_);
  }

  /// Frames until the solver rests. Fails when it never does.
  void settle() {
    frame();
    const auto give_up = std::chrono::steady_clock::now() + kPatience;
    while (editor_->playback().is_solving()) {
      ASSERT_LT(std::chrono::steady_clock::now(), give_up) << "the solver does not come to rest";
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      frame();
    }
    frame();
  }

  /// Frames until a condition holds. Fails when it never does.
  template <typename Condition>
  void wait_for(const Condition& condition) {
    const auto give_up = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
      ASSERT_LT(std::chrono::steady_clock::now(), give_up) << "waited in vain";
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      frame();
    }
  }

  bool is_valid() const {
    const auto& shown = editor_->shown();
    return !shown || is_injective(*shown->triangles, *shown->rest, shown->deformed);
  }

  std::unique_ptr<Editor> editor_;
  double now_ = 0;
};

}  // namespace foldless::test
