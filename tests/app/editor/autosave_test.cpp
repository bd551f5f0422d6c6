// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/editor/autosave_fixture.h"
#include "tests/support/entries_below.h"

namespace foldless::test {
namespace {

TEST_F(AutosaveTest, AChangeHasItsCopyAMinuteLater) {
  open_grid(6);
  pass(500);
  EXPECT_FALSE(editor_->files().autosave().next_wake()) << "nothing is unsaved";
  const double before = now_;
  place(3);
  settle();
  ASSERT_TRUE(editor_->next_wake());
  const double due = *editor_->files().autosave().next_wake();
  EXPECT_GE(due, before + 60);
  EXPECT_LE(due, now_ + 60);
  now_ = due;
  pass(-1);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(copies(), 0U);
  pass(2);
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
  editor_->edits().change_selected("Depth", Change::appearance,
                                   [](Handle& handle) { handle.depth = 2.5; });
  editor_->files().set_texture(folder_.write("a.png", "no image, but a file"));
  Document of_layers = editor_->document();
  const auto vertices = static_cast<int>(of_layers.original->rest.cols());
  of_layers.parts = std::make_shared<const MeshParts>(MeshParts{{"Body", 0, vertices, 1.5}});
  Animation moves;
  moves.tracks = {{.handle = of_layers.handles.front().id}};
  moves.tracks[0].position = {{0, {0, 0}, {}}, {12, {1, 1}, {}}};
  of_layers.animation = std::make_shared<const Animation>(moves);
  editor_->draft().edit("Parts", of_layers, Change::appearance);
  editor_->run_command("bones.make");
  editor_->run_command("mirror.toggle");
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
  EXPECT_EQ(editor_->document().rig.bones.size(), 1U);
  EXPECT_TRUE(editor_->document().rig.mirror);
  ASSERT_NE(editor_->document().animation, nullptr);
  EXPECT_EQ(*editor_->document().animation, moves);
  EXPECT_EQ(editor_->document().texture, folder_ / "a.png");
  ASSERT_NE(editor_->document().parts, nullptr);
  EXPECT_EQ(*editor_->document().parts, *of_layers.parts);
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
  second.files().recovery().find();
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
  for (const fs::path& entry : entries_below(root()))
    if (entry.filename() == "000002.json") std::ofstream(entry) << "{";
  start();
  find_lost_work();
  ASSERT_TRUE(editor_->files().recovery().work());
  EXPECT_TRUE(is_same_content(editor_->files().recovery().work()->document, first));
  EXPECT_NE(editor_->files().recovery().unread().find("000002.json"), std::string::npos);

  editor_->files().recover();
  EXPECT_NE(toasts().find("000002.json"), std::string::npos) << toasts();
  ASSERT_TRUE(editor_->files().save_as(folder_ / "scene.json"));
  EXPECT_EQ(copies(), 2U) << "the newer one may be readable another time";
}

TEST_F(AutosaveTest, WhereNoCopyCanBeReadThatIsSaid) {
  pose();
  crash();
  for (const fs::path& entry : entries_below(root()))
    if (entry.filename() == "000001.json") std::ofstream(entry) << "{";
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

}  // namespace
}  // namespace foldless::test
