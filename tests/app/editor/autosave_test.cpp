// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of unsaved work, and what is recovered from them after the program was killed.
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <atomic>
#include <cmath>
#include <new>
#include <random>

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

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
  std::size_t copies() const {
    std::size_t count = 0;
    if (fs::exists(root()))
      for (const auto& entry : fs::recursive_directory_iterator(root()))
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
  /// Returns whether a condition holds within twenty seconds.
  template <typename Condition>
  static bool comes_true(const Condition& condition) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition() && std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return condition();
  }
  void find_lost_work() {
    editor_->files().find_lost_work();
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

TEST_F(AutosaveTest, AChangeHasItsCopyAMinuteLater) {
  open_grid(6);
  pass(500);
  EXPECT_FALSE(editor_->files().autosave().next_wake()) << "nothing is unsaved";
  place(3);
  settle();
  const double changed = now_;
  ASSERT_TRUE(editor_->next_wake());
  EXPECT_NEAR(*editor_->files().autosave().next_wake(), changed + 60, 1);
  pass(58);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(copies(), 0U);
  pass(3);
  wait_for_copies(1);
  pass(500);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(copies(), 1U) << "nothing has changed since";
  EXPECT_FALSE(editor_->files().autosave().next_wake());
}

TEST_F(AutosaveTest, TheIntervalIsTheUsers) {
  open_grid(6);
  editor_->files().autosave().set_interval(15);
  place(3);
  settle();
  pass(16);
  wait_for_copies(1);
}

TEST_F(AutosaveTest, WhatIsSavedOrNotWantedHasNoCopies) {
  pose();
  pass(61);
  wait_for_copies(1);
  ASSERT_TRUE(editor_->files().save_as(folder_ / "scene.json"));
  EXPECT_EQ(copies(), 0U);

  place(3);
  settle();
  pass(61);
  wait_for_copies(1);
  editor_->files().close();
  EXPECT_EQ(copies(), 1U) << "the question is not answered yet";
  editor_->files().answer(Answer::discard);
  EXPECT_EQ(copies(), 0U);
  start();
  find_lost_work();
  EXPECT_FALSE(editor_->files().recovery().is_open());
}

TEST_F(AutosaveTest, OpeningWhatCannotBeReadLosesNoCopy) {
  pose();
  pass(61);
  wait_for_copies(1);
  editor_->files().open(folder_.write("bad.json", "{"));
  editor_->files().answer(Answer::discard);
  EXPECT_EQ(copies(), 1U);
}

TEST_F(AutosaveTest, RecoveryGivesEverythingBack) {
  pose();
  editor_->selection().select_all();
  editor_->edits().change_selected("Depth", [](Handle& handle) { handle.depth = 2.5; });
  editor_->files().set_texture(folder_.write("a.png", "no image, but a file"));
  ASSERT_TRUE(editor_->files().save_as(folder_ / "scene.json"));
  const Vec2 from = pixel_of_handle(1);
  drag(from, from + Vec2(40, -30));
  settle();
  editor_->view().set_camera({{1.25, 3.5}, 77});
  const Document lost = editor_->document();
  crash();

  find_lost_work();
  ASSERT_TRUE(editor_->files().recovery().is_open());
  EXPECT_EQ(editor_->files().recovery().origin(0).path, folder_ / "scene.json");
  EXPECT_TRUE(editor_->document().is_empty()) << "to offer is not to open";
  editor_->files().recover();
  EXPECT_TRUE(is_same_content(editor_->document(), lost));
  EXPECT_EQ(editor_->document().texture, folder_ / "a.png");
  EXPECT_EQ(editor_->document().handles.front().depth, 2.5);
  EXPECT_EQ(editor_->canvas().camera, (Camera{{1.25, 3.5}, 77}));
  EXPECT_EQ(editor_->files().path(), folder_ / "scene.json");
  EXPECT_TRUE(editor_->files().is_dirty());
  EXPECT_EQ(copies(), 1U) << "until it is saved";
  editor_->files().save();
  EXPECT_FALSE(editor_->files().is_dirty());
  EXPECT_EQ(copies(), 0U);
}

TEST_F(AutosaveTest, WhatWasNeverSavedIsRecoveredToo) {
  pose();
  const Document lost = editor_->document();
  crash();
  find_lost_work();
  ASSERT_TRUE(editor_->files().recovery().is_open());
  editor_->files().recover();
  EXPECT_TRUE(is_same_content(editor_->document(), lost));
  EXPECT_EQ(editor_->document().name, "grid");
  EXPECT_TRUE(editor_->files().path().empty());
  // And once more, as it was not saved.
  start();
  find_lost_work();
  EXPECT_TRUE(editor_->files().recovery().is_open());
}

TEST_F(AutosaveTest, LaterMeansTheNextTimeAndDiscardNever) {
  pose();
  crash();
  find_lost_work();
  editor_->escape();
  EXPECT_FALSE(editor_->files().recovery().is_open());
  find_lost_work();
  ASSERT_TRUE(editor_->files().recovery().is_open());
  editor_->files().recovery().discard();
  EXPECT_FALSE(editor_->files().recovery().is_open());
  find_lost_work();
  EXPECT_FALSE(editor_->files().recovery().is_open());
  EXPECT_EQ(copies(), 0U);
}

TEST_F(AutosaveTest, ASecondProgramIsNotOfferedTheWorkOfARunningOne) {
  pose();
  pass(61);
  wait_for_copies(1);
  Editor second({.state_folder = folder_.path() / "state", .wake = {}});
  second.files().find_lost_work();
  EXPECT_FALSE(second.files().recovery().is_open());
}

TEST_F(AutosaveTest, AnUnreadableCopyGivesWayToTheOneBefore) {
  pose();
  const Document first = editor_->document();
  pass(61);
  wait_for_copies(1);
  place(3);
  settle();
  pass(61);
  wait_for_copies(2);
  for (const auto& entry : fs::recursive_directory_iterator(root()))
    if (entry.path().filename() == "000002.json") std::ofstream(entry.path()) << "{";
  start();
  find_lost_work();
  ASSERT_TRUE(editor_->files().recovery().work());
  EXPECT_TRUE(is_same_content(editor_->files().recovery().work()->document, first));
}

TEST_F(AutosaveTest, WhereNoCopyCanBeReadThatIsSaid) {
  pose();
  crash();
  for (const auto& entry : fs::recursive_directory_iterator(root()))
    if (entry.path().filename() == "000001.json") std::ofstream(entry.path()) << "{";
  find_lost_work();
  ASSERT_TRUE(editor_->files().recovery().is_open());
  EXPECT_NE(editor_->files().recovery().problem().find("000001.json"), std::string::npos);
  editor_->files().recover();
  EXPECT_TRUE(editor_->document().is_empty());
  EXPECT_EQ(copies(), 1U);
}

TEST_F(AutosaveTest, UnsavedChangesAreAskedAboutBeforeARecovery) {
  pose();
  crash();
  open_grid(3);
  place(0);
  const Document present = editor_->document();
  find_lost_work();
  editor_->files().recover();
  ASSERT_NE(editor_->files().question(), nullptr);
  editor_->files().answer(Answer::cancel);
  EXPECT_TRUE(is_same_content(editor_->document(), present));
  ASSERT_TRUE(editor_->files().recovery().is_open());
  editor_->files().recover();
  editor_->files().answer(Answer::discard);
  EXPECT_EQ(editor_->document().handles.size(), 2U);
}

TEST_F(AutosaveTest, ACopyThatCannotBeWrittenIsToldOnce) {
  fs::create_directories(root().parent_path());
  std::ofstream(root()) << "a file where the folder should be";
  pose();
  pass(61);
  wait_for([&] { return toasts().find("unsaved work") != std::string::npos; });
  pass(30);
  EXPECT_EQ(toasts().find("unsaved work"), std::string::npos);
  pass(61);
  pass(61);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  pass(1);
  EXPECT_EQ(toasts().find("unsaved work"), std::string::npos) << "it was said before";
  // As soon as it works again, it does.
  fs::remove(root());
  pass(61);
  pass(61);
  wait_for_copies(1);
}

TEST_F(AutosaveTest, ARescueDoesNotWait) {
  pose();
  editor_->files().rescue();
  EXPECT_EQ(copies(), 1U);
  start();
  editor_->files().rescue();
  EXPECT_EQ(copies(), 1U) << "nothing is open";
}

/// Where the second handle is dragged to: every step to another place.
Vec2 target_at(int step) {
  const double radius = 0.3 + 0.0005 * step, angle = 0.1 * step;
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

TEST_F(AutosaveTest, KilledAtAnyMomentItLeavesWhatWasDoneABlinkBefore) {
  editor_.reset();  // no thread of ours may run when the process is doubled
  void* shared = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  auto& steps = *new (shared) std::atomic<int>(0);
  const unsigned seed = 20261123;
  std::mt19937 random(seed);
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    TemporaryFolder folder;
    steps = 0;
    const pid_t child = fork();
    if (child == 0) drag_until_killed(folder.path(), steps);
    ASSERT_GT(child, 0);
    ASSERT_TRUE(comes_true([&] { return steps > 0; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 300));
    const int steps_before = steps;
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);

    make_editor({.state_folder = folder.path() / "state", .wake = {}});
    int kept = -1;
    if (fs::exists(folder / "scene.json")) {
      editor_->files().open(folder / "scene.json");
      EXPECT_FALSE(editor_->document().is_empty()) << toasts();
      kept = step_of(editor_->document());
    }
    find_lost_work();
    if (editor_->files().recovery().is_open()) {
      EXPECT_EQ(editor_->files().recovery().problem(), "");
      editor_->files().recover();
      EXPECT_TRUE(is_valid());
      kept = std::max(kept, step_of(editor_->document()));
    }
    EXPECT_GE(kept + 1, steps_before) << "a second was more than enough for a copy";
    editor_.reset();
  }
  munmap(shared, sizeof(std::atomic<int>));
}

}  // namespace
}  // namespace foldless::test
