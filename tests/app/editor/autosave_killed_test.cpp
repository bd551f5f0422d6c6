// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of the work of a program that was killed.
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <new>
#include <random>

#include "tests/app/editor/autosave_fixture.h"
#include "tests/support/kept_work.h"
#include "tests/support/number_from.h"

namespace foldless::test {
namespace {

using AutosaveKilled = AutosaveTest;

/// Where the second handle is dragged to: every step to another place, farther than a click may go.
Vec2 target_at(int step) {
  const double radius = 0.3 + 0.0005 * step, angle = 0.3 * step;
  return Vec2(2.5, 2.5) + radius * Vec2(std::cos(angle), std::sin(angle));
}

/// The step that led to a document; -1: none did.
int step_of(const Document& document) {
  for (int step = 0; step < 2000 && document.handles.size() == 2; ++step)
    if ((document.handles.back().target - target_at(step)).norm() < 1e-6) return step;
  return -1;
}

/// A program that drags a handle on and on until it is killed, and saves now and then. Counts the
/// steps that are done.
[[noreturn]] void drag_until_killed(const fs::path& folder, std::atomic<int>& steps) {
  Editor editor({.state_folder = folder / "state", .wake = {}});
  editor.view().resize(800, 600, 1);
  Fixture grid = square_grid(6);
  editor.files().open_shape(Shape{std::move(grid.triangles), std::move(grid.rest)}, "grid");
  editor.files().autosave().set_interval(0.005);
  double now = 0;
  for (const int vertex : {0, 35}) {
    const Vec2 at = editor.canvas().to_pixel(editor.shown()->deformed.col(vertex));
    editor.receive(PointerPressed{Button::left, at, {}}, now);
    editor.receive(PointerReleased{Button::left, at, {}}, now);
  }
  for (int step = 0;; ++step) {
    const Vec2 from = editor.canvas().to_pixel(editor.document().handles.back().target);
    const Vec2 to = editor.canvas().to_pixel(target_at(step));
    editor.receive(PointerPressed{Button::left, from, {}}, now);
    for (int k = 1; k <= 4; ++k) {
      editor.receive(PointerMoved{from + (to - from) * k / 4, {}}, now);
      editor.update(now += 0.002);
    }
    editor.receive(PointerReleased{Button::left, to, {}}, now);
    steps = step + 1;
    if (step % 37 == 36) editor.files().save_as(folder / "scene.json");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// FOLDLESS_KILLS says how often, FOLDLESS_SEED where the random moments begin.
TEST_F(AutosaveKilled, AtAnyMomentItLeavesWhatWasKept) {
  editor_.reset();  // no thread of ours may run when the process is doubled
  void* shared = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  auto& steps = *new (shared) std::atomic<int>(0);
  const int rounds = number_from("FOLDLESS_KILLS", 6);
  const auto seed = static_cast<unsigned>(number_from("FOLDLESS_SEED", 20261123));
  std::mt19937 random(seed);
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    TemporaryFolder folder;
    steps = 0;
    const pid_t child = fork();
    if (child == 0) drag_until_killed(folder.path(), steps);
    ASSERT_GT(child, 0);
    ASSERT_TRUE(comes_true([&] { return steps > 0; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 300));
    const int steps_before = steps;
    ASSERT_TRUE(is_kept_anew(folder.path() / "state", folder.path() / "scene.json"));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20'000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);

    make_editor({.state_folder = folder.path() / "state", .wake = {}});
    int saved = -1, recovered = -1;
    if (fs::exists(folder / "scene.json")) {
      editor_->files().open(folder / "scene.json");
      EXPECT_FALSE(editor_->document().is_empty()) << toasts();
      saved = step_of(editor_->document());
    }
    find_lost_work();
    const bool is_found = editor_->files().recovery().is_open();
    if (is_found) {
      EXPECT_EQ(editor_->files().recovery().problem(), "");
      editor_->files().recover();
      EXPECT_TRUE(is_valid());
      recovered = step_of(editor_->document());
    }
    EXPECT_GE(std::max(saved, recovered) + 1, steps_before)
        << "it was copied; in the file is step " << saved << ", "
        << (is_found ? "recovered is " + std::to_string(recovered) : "nothing was left")
        << ", done were " << steps;
    editor_.reset();
  }
  munmap(shared, sizeof(std::atomic<int>));
}

}  // namespace
}  // namespace foldless::test
