// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/time_line_pictures.h"

#include <string>

#include "core/data_path.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/pictures.h"

namespace foldless::test {
namespace {

/// Outlines of the keys beside, frames that are not reached, a band over keys in a closer view.
template <class Shoot>
void draw_marks(HeadlessEditor& headless, const Shoot& shoot) {
  Motion& motion = headless.editor().motion();
  headless.key(Key::u);
  motion.play_head().go_to(8);
  shoot("time-line-outlines");
  headless.key(Key::u);
  const Document reached = headless.editor().document();
  Document weak = reached;
  weak.parameters.method = "paper";
  weak.parameters.alpha = 1e-6;
  headless.editor().draft().edit("Weak handles", weak, Change::appearance);
  headless.settle();
  headless.wait_until([&] { return motion.frames().status().is_done; }, 20);
  const Vec2 corner = *headless.find_words("All keys") + Vec2(260, -8);
  headless.hold(kControl);
  headless.move(corner);
  for (int i = 0; i < 3; ++i) headless.ui().receive(InputEvent(WheelTurned{1, corner}));
  headless.settle();
  headless.hold({});
  headless.press(corner);
  headless.move(corner + Vec2(200, 60));
  shoot("time-line-not-reached");
  headless.release(corner + Vec2(200, 60));
  headless.editor().draft().undo();
  headless.wait_until([&] { return motion.frames().status().is_done; }, 20);
  motion.keys().select(keys_of(motion.animation()));
  headless.settle();
}

}  // namespace

void draw_time_line(const std::filesystem::path& folder) {
  for (const int scale : {1, 2}) {
    HeadlessEditor headless({1280 * scale, 800 * scale});
    headless.set_content_scale(static_cast<float>(scale));
    const auto shoot = [&](const std::string& name) {
      headless.settle();
      save_png(folder / (name + "-" + std::to_string(scale) + "00.png"), headless.picture());
    };
    Motion& motion = headless.editor().motion();
    headless.editor().files().open_sample(data_path("assets/scenes/walk.json"));
    headless.wait_until([&] { return motion.frames().status().is_done; }, 20);
    shoot("time-line-proving");
    headless.wait_until([&] { return motion.proof().state == MotionProofStatus::State::proved; },
                        20);
    motion.play_head().go_between(11.5);
    headless.wait_until([&] { return motion.solved() != nullptr; }, 20);
    motion.keys().select(keys_of(motion.animation()));
    shoot("time-line");
    draw_marks(headless, shoot);
    if (const auto easing = headless.find_words("Linear")) headless.click(*easing);
    shoot("time-line-easing");
    headless.key(Key::escape);
    headless.key(Key::e, kControl);
    shoot("export-animation");
    if (const auto format = headless.find_words("Animated WebP (.webp)")) headless.click(*format);
    shoot("export-animation-formats");
  }
}

}  // namespace foldless::test
