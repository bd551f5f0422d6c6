// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/keymap.h"

#include <set>

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

const Shortcut kUndoKey{Key::z, kControl};
const Shortcut kFreeKey{Key::j, kControl};

/// A key that is in force twice, in words, or empty.
std::string doubled_key(const Keymap& keymap) {
  std::set<std::string> seen;
  for (const KeyRow& row : keymap.rows())
    for (const Shortcut& key : keymap.keys(row.name))
      if (!seen.insert(words_of(key)).second) return words_of(key);
  return {};
}

TEST(KeymapTest, ACommandGetsAKeyAndItsFormerKeysDoNothing) {
  Keymap keymap;
  keymap.set("edit.redo", {kFreeKey});
  EXPECT_EQ(keymap.command_of(kFreeKey), "edit.redo");
  EXPECT_EQ(keymap.words("edit.redo"), "Ctrl+J");
  EXPECT_EQ(keymap.command_of({Key::y, kControl}), "");
  EXPECT_TRUE(keymap.is_changed("edit.redo"));
}

TEST(KeymapTest, AKeyIsTakenFromTheCommandThatHadIt) {
  Keymap keymap;
  keymap.set("file.save", {kUndoKey});
  EXPECT_EQ(keymap.command_of(kUndoKey), "file.save");
  EXPECT_EQ(keymap.words("edit.undo"), "");
  EXPECT_TRUE(keymap.is_changed("edit.undo"));
  keymap.set("file.open", {kUndoKey});
  EXPECT_EQ(keymap.words("file.save"), "");
  keymap.set("edit.undo", keymap.preset_keys("edit.undo"));
  EXPECT_EQ(keymap.command_of(kUndoKey), "edit.undo");
  EXPECT_EQ(keymap.words("file.open"), "");
  EXPECT_EQ(doubled_key(keymap), "");
}

TEST(KeymapTest, OnlyWhatDiffersFromThePresetIsAChange) {
  Keymap keymap;
  keymap.set("edit.undo", {kFreeKey});
  EXPECT_EQ(keymap.choice().changes.size(), 1U);
  keymap.set("edit.undo", {kUndoKey});
  EXPECT_EQ(keymap.choice(), KeyChoice{});
  keymap.set("edit.undo", {});
  keymap.reset();
  EXPECT_EQ(keymap.choice(), KeyChoice{});
  EXPECT_EQ(keymap.words("edit.undo"), "Ctrl+Z");
}

TEST(KeymapTest, OfDialogsAndHeldKeysNoneIsGiven) {
  Keymap keymap;
  for (const Key key :
       {Key::escape, Key::enter, Key::tab, Key::space, Key::left, Key::l, Key::h, Key::backslash})
    EXPECT_NE(keymap.refusal_of({key, {}}), "") << words_of(Shortcut{key, {}});
  EXPECT_EQ(keymap.refusal_of(kUndoKey), "");
  EXPECT_NE(keymap.problem_of("view.hide_overlays", std::vector{kFreeKey}), "");
  EXPECT_NE(keymap.problem_of("no.such", std::vector{kFreeKey}), "");
  EXPECT_EQ(keymap.problem_of("edit.undo", std::vector{kFreeKey}), "");
}

TEST(KeymapTest, WhatTheUserChangedWinsOverAnotherPreset) {
  Keymap keymap;
  keymap.set("file.save", {{Key::d, kControl}});
  KeyChoice choice = keymap.choice();
  choice.preset = "photoshop";
  keymap.choose(choice);
  EXPECT_EQ(keymap.command_of({Key::d, kControl}), "file.save");
  EXPECT_EQ(keymap.words("select.none"), "");
  EXPECT_EQ(keymap.words("view.actual_size"), "Ctrl+1");
  keymap.reset();
  EXPECT_EQ(keymap.words("select.none"), "Ctrl+D");
}

using RemappedKeys = EditorTest;

TEST_F(RemappedKeys, TheNewKeyActsAndTheOldOneDoesNot) {
  open_grid(4);
  editor_->keys().set("view.heat", {{Key::j, {}}});
  key(Key::digit_4);
  EXPECT_FALSE(editor_->view().options().layers.heat);
  key(Key::j);
  EXPECT_TRUE(editor_->view().options().layers.heat);
}

}  // namespace
}  // namespace foldless::test
