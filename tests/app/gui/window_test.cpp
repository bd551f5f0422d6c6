// SPDX-License-Identifier: GPL-3.0-or-later
// The real program in a real window on a virtual display, with a real mouse.
#include "tests/app/gui/real_window.h"

namespace foldless::test {
namespace {

TEST_F(RealWindow, MouseDragBendsTheMeshAndSavingKeepsIt) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  const auto written = std::filesystem::last_write_time(scene_);
  ASSERT_NO_FATAL_FAILURE(drag(640, 400, 40, 120));
  ASSERT_TRUE(comes_to_rest());
  ASSERT_NO_FATAL_FAILURE(tool("key --clearmodifiers ctrl+s"));
  ASSERT_TRUE(wait_for([&] { return std::filesystem::last_write_time(scene_) != written; }))
      << "Ctrl+S saved nothing";

  const std::vector<std::string_view> methods{"paper-flip"};
  const Scene scene = load_scene(scene_, methods).scene;
  EXPECT_EQ(scene.handles.size(), 3U) << "the press should have placed a handle";
  ASSERT_TRUE(scene.state.has_value());
  const double moved = (scene.state->deformed - scene.state->rest).colwise().norm().maxCoeff();
  EXPECT_GT(moved, 0.5) << "the drag should have bent the mesh";
  EXPECT_TRUE(is_injective(scene.state->triangles, scene.state->rest));
  EXPECT_TRUE(is_injective(scene.state->triangles, scene.state->deformed));
}

TEST_F(RealWindow, WhatWasRecordedIsReplayedWithoutAWindow) {
  const std::string session = folder_ / "session.jsonl", shots = folder_ / "shots";
  ASSERT_NO_FATAL_FAILURE(start_program({"--record", session}));
  const auto written = std::filesystem::last_write_time(scene_);
  ASSERT_NO_FATAL_FAILURE(drag(640, 400, 40, 120));
  ASSERT_TRUE(comes_to_rest());
  ASSERT_NO_FATAL_FAILURE(tool("key --clearmodifiers shift+F12 key --clearmodifiers ctrl+s"));
  ASSERT_TRUE(wait_for([&] { return std::filesystem::last_write_time(scene_) != written; }));
  program_.reset();
  const std::vector<std::string_view> methods{"foldless", "paper-flip"};
  const Scene recorded = load_scene(scene_, methods).scene;

  write_scene();
  ASSERT_EQ(std::system((std::string(FOLDLESS_PROGRAM) + " replay " + session + " --shots " +
                         shots + " > /dev/null")
                            .c_str()),
            0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "shots/0001.png"));
  const Scene replayed = load_scene(scene_, methods).scene;
  ASSERT_EQ(recorded.handles.size(), 3U);
  EXPECT_EQ(replayed.handles, recorded.handles);
}

TEST_F(RealWindow, CtrlQLeavesAtOnceWhenNothingIsUnsaved) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  ASSERT_NO_FATAL_FAILURE(tool("key --clearmodifiers ctrl+q"));
  ASSERT_TRUE(wait_for([this] { return !program_->is_running(); }));
  EXPECT_EQ(program_->status(), 0);
}

TEST_F(RealWindow, ASignalEndsItAndUnsavedWorkIsKept) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  ASSERT_NO_FATAL_FAILURE(drag(640, 400, 40, 120));
  ASSERT_TRUE(comes_to_rest());
  EXPECT_TRUE(copy().empty()) << "a minute has not passed";
  kill(program_->pid(), SIGTERM);
  ASSERT_TRUE(wait_for([this] { return !program_->is_running(); }));
  EXPECT_TRUE(WIFEXITED(program_->status()) && WEXITSTATUS(program_->status()) == 130);
  expect_copy_of_the_drag();

  // It is offered at the next start, and Enter takes it; Ctrl+S gives it to its file.
  const auto written = std::filesystem::last_write_time(scene_);
  ASSERT_NO_FATAL_FAILURE(start_program());
  ASSERT_NO_FATAL_FAILURE(tool("key Return"));
  ASSERT_TRUE(comes_to_rest());
  ASSERT_NO_FATAL_FAILURE(tool("key --clearmodifiers ctrl+s"));
  ASSERT_TRUE(wait_for([&] { return std::filesystem::last_write_time(scene_) != written; }));
  const std::vector<std::string_view> methods{"foldless", "paper-flip"};
  EXPECT_EQ(load_scene(scene_, methods).scene.handles.size(), 3U);
  EXPECT_TRUE(wait_for([this] { return copy().empty(); }));
}

TEST_F(RealWindow, WhenTheDisplayGoesUnsavedWorkIsKept) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  ASSERT_NO_FATAL_FAILURE(drag(640, 400, 40, 120));
  ASSERT_TRUE(comes_to_rest());
  server_.reset();
  ASSERT_TRUE(wait_for([this] { return !program_->is_running(); }));
  expect_copy_of_the_drag();
}

#ifdef FOLDLESS_FAULTS_LIBRARY
TEST_F(RealWindow, WhenAFrameThrowsUnsavedWorkIsKept) {
  setenv("LD_PRELOAD", FOLDLESS_FAULTS_LIBRARY, 1);
  setenv("FOLDLESS_FAULT", "frame:1", 1);
  ASSERT_NO_FATAL_FAILURE(start_program());
  unsetenv("LD_PRELOAD");
  ASSERT_NO_FATAL_FAILURE(drag(640, 400, 40, 120));
  ASSERT_TRUE(comes_to_rest());
  kill(program_->pid(), SIGUSR2);
  ASSERT_NO_FATAL_FAILURE(tool("mousemove 300 300 mousemove 320 320"));
  ASSERT_TRUE(wait_for([this] { return !program_->is_running(); }));
  EXPECT_TRUE(WIFEXITED(program_->status()) && WEXITSTATUS(program_->status()) == 2);
  expect_copy_of_the_drag();
}
#endif

TEST(NoDisplay, EditorSaysSoInOneLineAndEndsWithStatus2) {
  const std::string output = output_of("env -u DISPLAY " FOLDLESS_PROGRAM " 2>&1; echo status $?");
  EXPECT_NE(output.find("display"), std::string::npos) << output;
  EXPECT_NE(output.find("foldless solve"), std::string::npos) << output;
  EXPECT_NE(output.find("status 2"), std::string::npos) << output;
  EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
}

}  // namespace
}  // namespace foldless::test
