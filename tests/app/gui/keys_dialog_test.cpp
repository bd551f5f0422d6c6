// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of commands are changed in a dialog, kept in the settings, and said everywhere.
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include "app/gui/hints.h"
#include "app/gui/interface_commands.h"
#include "app/gui/settings.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class KeysDialogTest : public testing::Test {
 protected:
  KeysDialogTest() { start(); }

  void start() {
    headless_.reset();
    UiOptions options;
    options.state_folder = folder_.path();
    headless_.emplace(Extent{1100, 700}, options);
    editor().files().open_shape(bar(4, 1, 2), "bar");
    headless_->calm_down();
  }
  Editor& editor() { return headless_->editor(); }
  /// By Ctrl+K, with the rows of one command.
  void open_dialog(std::string_view search) {
    headless_->key(Key::k, kControl);
    headless_->type("edit: keys");
    headless_->key(Key::enter);
    headless_->click(place_of("Search by command or key"));
    headless_->type(search);
  }
  /// Of words on screen.
  Vec2 place_of(const std::string& words) {
    const auto place = headless_->find_words(words);
    EXPECT_TRUE(place) << words;
    return place.value_or(Vec2(0, 0));
  }
  void press_button(const std::string& words) { headless_->click(place_of(words)); }
  std::string words(std::string_view command) { return editor().keys().words(command); }
  std::string settings_text() {
    headless_.reset();  // what is unwritten is written
    std::ostringstream text;
    text << std::ifstream(settings_file(folder_.path())).rdbuf();
    return text.str();
  }

  TemporaryFolder folder_;
  std::optional<HeadlessEditor> headless_;
};

TEST_F(KeysDialogTest, AKeyIsChangedByPressingItAndRemembered) {
  open_dialog("heat map");
  press_button("4");
  headless_->key(Key::j, kControl);
  EXPECT_EQ(words("view.heat"), "Ctrl+J");
  headless_->key(Key::escape);
  headless_->key(Key::j, kControl);
  EXPECT_TRUE(editor().view().options().layers.heat);
  start();
  EXPECT_EQ(words("view.heat"), "Ctrl+J");
  const std::string text = settings_text();
  EXPECT_NE(text.find("view.heat"), std::string::npos) << text;
  EXPECT_EQ(text.find("edit.undo"), std::string::npos) << "only what differs is written";
}

TEST_F(KeysDialogTest, EscapeLeavesTheKeyAndDeleteTakesItAway) {
  open_dialog("heat map");
  press_button("4");
  headless_->key(Key::escape);
  EXPECT_EQ(words("view.heat"), "4");
  ASSERT_TRUE(headless_->find_words("Close")) << "Esc left the key alone, not the dialog";
  press_button("4");
  headless_->key(Key::del);
  EXPECT_EQ(words("view.heat"), "");
}

TEST_F(KeysDialogTest, AKeyOfAnotherCommandIsTakenOnlyWhenThatIsSaid) {
  open_dialog("heat map");
  press_button("4");
  headless_->key(Key::z, kControl);
  ASSERT_TRUE(headless_->find_words("Ctrl+Z is the key of “Undo”."));
  EXPECT_EQ(words("edit.undo"), "Ctrl+Z");
  press_button("Leave it there");
  EXPECT_EQ(words("edit.undo"), "Ctrl+Z");
  press_button("4");
  headless_->key(Key::z, kControl);
  press_button("Take it");
  EXPECT_EQ(words("edit.undo"), "");
  EXPECT_EQ(words("view.heat"), "Ctrl+Z");
}

TEST_F(KeysDialogTest, KeysOfDialogsAreRefusedInASentenceAndFixedOnesAreShown) {
  open_dialog("heat map");
  press_button("4");
  headless_->key(Key::enter);
  EXPECT_TRUE(headless_->find_words("Enter is for dialogs and gestures; choose another key."));
  headless_->key(Key::h);
  EXPECT_TRUE(
      headless_->find_words("H is fixed to “Hide overlays while held”; choose another key."));
  EXPECT_EQ(words("view.heat"), "4");
  headless_->key(Key::escape);
  headless_->key(Key::escape);
  open_dialog("overlays");
  EXPECT_TRUE(headless_->find_words("H, fixed"));
}

TEST_F(KeysDialogTest, ARowAndAllAreReset) {
  editor().keys().set("view.heat", {{Key::j, {}}});
  editor().keys().set("edit.undo", {{Key::u, {}}});
  open_dialog("heat map");
  const Vec2 row = place_of("Heat map");
  headless_->click({1100 / 2 + 600 / 2 - 37, row.y()});
  EXPECT_EQ(words("view.heat"), "4");
  EXPECT_EQ(words("edit.undo"), "U");
  press_button("Reset all");
  EXPECT_EQ(words("edit.undo"), "Ctrl+Z");
}

TEST_F(KeysDialogTest, APresetIsChosen) {
  open_dialog("select none");
  press_button("Foldless");
  press_button("Photoshop");
  EXPECT_EQ(words("select.none"), "Ctrl+D");
  start();
  EXPECT_EQ(words("select.none"), "Ctrl+D");
}

TEST_F(KeysDialogTest, MenusHintsSheetAndSearchSayTheKeyInForce) {
  editor().keys().set("help.keys", {{Key::j, kControl}});
  EXPECT_NE(hint_words(editor(), {}).find("Ctrl+J all keys"), std::string::npos);
  headless_->key(Key::j, kControl);
  EXPECT_TRUE(headless_->find_words("Ctrl+J")) << "on the sheet of keys";
  EXPECT_FALSE(headless_->find_words("F1"));
  headless_->key(Key::j, kControl);
  EXPECT_FALSE(headless_->find_words("Keys and mouse")) << "it closes by the key that opened it";
  headless_->key(Key::k, kControl);
  headless_->type("help: shortcuts");
  EXPECT_TRUE(headless_->find_words("Ctrl+J")) << "in the search";
  headless_->key(Key::escape);
  headless_->click(place_of("Help"));
  EXPECT_TRUE(headless_->find_words("Ctrl+J")) << "in the menu";
}

TEST_F(KeysDialogTest, ABrokenEntryOfTheFileIsSaidAndTheRestIsKept) {
  headless_.reset();
  std::ofstream(settings_file(folder_.path()))
      << R"({"keys": {"preset": "blender", "changes": {"edit.undo": ["Ctrl+Nothing"],
             "view.heat": ["Ctrl+J"], "file.save": ["Enter"], "edit.redo": 7}}})";
  start();
  EXPECT_EQ(words("edit.undo"), "Ctrl+Z");
  EXPECT_EQ(words("file.save"), "Ctrl+S");
  EXPECT_EQ(words("edit.redo"), "Ctrl+Shift+Z");
  EXPECT_EQ(words("view.heat"), "Ctrl+J");
  EXPECT_EQ(words("select.all"), "A");
  int errors = 0;
  for (const LoggedMessage& message : editor().messages().log())
    errors += message.kind == ToastKind::error;
  EXPECT_EQ(errors, 1);
  const std::string text = editor().messages().log().front().text;
  EXPECT_NE(text.find("settings.json: The keys of \"edit.redo\" stay as they were. "
                      "A list of keys is needed. More that is of no use: 2."),
            std::string::npos)
      << text;
}

TEST_F(KeysDialogTest, KeysThatAreNoObjectOrGivenTwiceAreSaid) {
  for (const auto& [keys, words] :
       {std::pair{"7", "is no object"}, std::pair{R"({"preset": "emacs"})", "no preset"},
        std::pair{R"({"changes": {"file.save": ["J"], "file.open": ["J"]}})", "already"},
        std::pair{R"({"changes": [1]})", "A list of keys"},
        std::pair{R"({"changes": {"no.such": ["J"]}})", "no such command"}}) {
    const auto file = folder_ / "other.json";
    std::ofstream(file) << "{\"keys\": " << keys << "}";
    const Settings settings = load_settings(file);
    EXPECT_NE(settings.problem.find(words), std::string::npos) << settings.problem;
  }
}

TEST(KeyPresets, GiveEveryKeyToOneCommandThatIsThere) {
  for (const KeyPreset& preset : key_presets()) {
    Keymap keymap = all_keys();
    keymap.choose({std::string(preset.name), {}});
    std::set<std::string> seen;
    for (const KeyRow& row : keymap.rows())
      for (const Shortcut& key : keymap.keys(row.name))
        EXPECT_TRUE(seen.insert(words_of(key)).second) << preset.title << words_of(key);
    for (const KeyDifference& difference : preset.differences)
      EXPECT_NE(keymap.find(difference.command), nullptr) << difference.command;
    for (const KeyDifference& difference : preset.differences)
      EXPECT_EQ(all_keys().problem_of(difference.command, difference.keys), "");
  }
}

}  // namespace
}  // namespace foldless::test
