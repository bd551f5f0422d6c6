// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/commands.h"

#include <set>

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

TEST(Commands, NamesAndShortcutsAreThereOnce) {
  std::set<std::string_view> names;
  std::set<std::string> shortcuts;
  for (const Command& command : commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_FALSE(command.title.empty()) << command.name;
    EXPECT_FALSE(command.menu.empty()) << command.name;
    for (const Shortcut& shortcut : command.shortcuts) {
      EXPECT_TRUE(shortcuts.insert(words_of(shortcut)).second) << words_of(shortcut);
      EXPECT_EQ(Keymap().command_of(shortcut), command.name);
      EXPECT_EQ(shortcut_of(words_of(shortcut)), shortcut);
    }
    EXPECT_EQ(find_command(command.name), &command);
  }
}

TEST(Commands, ShortcutsHaveWords) {
  EXPECT_EQ(words_of(Shortcut{Key::s, kControlShift}), "Ctrl+Shift+S");
  EXPECT_EQ(words_of(Shortcut{Key::f12, {}}), "F12");
  EXPECT_EQ(words_of(Shortcut{Key::digit_0, kControl}), "Ctrl+0");
  EXPECT_EQ(words_of(Shortcut{Key::period, kShift}), "Shift+.");
  for (const Command& command : commands())
    for (const Shortcut& shortcut : command.shortcuts)
      EXPECT_FALSE(words_of(Shortcut{shortcut.key, {}}).empty()) << command.name;
}

using CommandKeys = EditorTest;

TEST_F(CommandKeys, EveryCommandRunsOnAnEmptyDocument) {
  for (const Command& command : commands()) {
    editor_->run_command(command.name);
    frame();
    EXPECT_TRUE(editor_->document().is_empty());
  }
}

TEST_F(CommandKeys, DisabledCommandsDoNothing) {
  EXPECT_FALSE(editor_->run_command("edit.undo"));
  EXPECT_FALSE(editor_->run_command("edit.delete"));
  EXPECT_FALSE(editor_->run_command("no.such.command"));
  EXPECT_TRUE(editor_->run_command("help.keys"));
}

TEST_F(CommandKeys, DigitsSwitchTheLayers) {
  for (std::size_t k = 0; k < kLayerRows.size(); ++k) {
    const bool before = editor_->view().options().layers.*kLayerRows[k].shown;
    key(static_cast<Key>(static_cast<std::size_t>(Key::digit_1) + k));
    EXPECT_NE(editor_->view().options().layers.*kLayerRows[k].shown, before) << kLayerRows[k].name;
  }
}

TEST_F(CommandKeys, OverlaysAreHiddenAsLongAsHIsHeld) {
  const ViewOptions before = editor_->view().shown_options();
  editor_->receive(KeyPressed{Key::h, {}, false}, now_);
  EXPECT_TRUE(editor_->view().shown_options().layers.fill);
  EXPECT_FALSE(editor_->view().shown_options().layers.wireframe);
  EXPECT_FALSE(editor_->view().shown_options().layers.handles);
  editor_->receive(KeyReleased{Key::h}, now_);
  EXPECT_EQ(editor_->view().shown_options(), before);
}

TEST_F(CommandKeys, HeldKeysRepeatOnlyWhereThatIsMeant) {
  open_grid(4);
  const double before = editor_->canvas().camera.pixels_per_unit;
  editor_->receive(KeyPressed{Key::plus, {}, true}, now_);
  EXPECT_GT(editor_->canvas().camera.pixels_per_unit, before);
  const bool wireframe = editor_->view().options().layers.wireframe;
  editor_->receive(KeyPressed{Key::digit_2, {}, true}, now_);
  EXPECT_EQ(editor_->view().options().layers.wireframe, wireframe);
}

TEST_F(CommandKeys, RequestsAreGivenOnce) {
  open_grid(4);
  key(Key::f12);
  key(Key::e, kControl);
  key(Key::e, kControlShift);
  EXPECT_EQ(editor_->messages().take_requests(),
            (std::vector<Request>{Request::write_snapshot, Request::export_dialog,
                                  Request::export_again}));
  EXPECT_TRUE(editor_->messages().take_requests().empty());
}

TEST_F(CommandKeys, ViewKeysFitAndZoom) {
  open_grid(5);
  place(24);
  const double fitted = editor_->canvas().camera.pixels_per_unit;
  key(Key::digit_0, kControl);
  EXPECT_EQ(editor_->canvas().camera.pixels_per_unit, 100);
  key(Key::home);
  EXPECT_EQ(editor_->canvas().camera.pixels_per_unit, fitted);
  key(Key::f);
  EXPECT_GT(editor_->canvas().camera.pixels_per_unit, 2 * fitted);
  EXPECT_LT((pixel_of_vertex(24) - Vec2(400, 300)).norm(), 1e-6);
}

}  // namespace
}  // namespace foldless::test
