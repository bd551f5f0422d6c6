// SPDX-License-Identifier: GPL-3.0-or-later
// A full disk and a folder that cannot be written to: one sentence that says what and what to do,
// the old file as it was, nothing half written, and all goes on where there is room again.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <set>
#include <string>

#include "app/gui/sequence_export.h"
#include "app/gui/session_recorder.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/entries_below.h"
#include "tests/support/errors.h"
#include "tests/support/troubled_disk.h"

namespace foldless::test {
namespace {

struct Trouble {
  const char* name;
  void (TroubledDisk::*begin)();
};

constexpr std::array kTroubles = std::to_array<Trouble>({
    {"full disk", &TroubledDisk::fill},
    {"read-only folder", &TroubledDisk::make_read_only},
});

class Troubled : public testing::Test {
 protected:
  /// A scene on the disk, opened and changed.
  Troubled() {
    editor().files().open_shape(bar(4, 1, 5), "bar");
    EXPECT_TRUE(editor().files().save_as(disk_ / "bar.json"));
    headless_.calm_down();
    place(Vec2(0, 0.5));
    headless_.calm_down();
    // One that is being written as the disk becomes full gives its room back for what comes then.
    EXPECT_TRUE(headless_.wait_until([this] {
      return std::ranges::any_of(
          copies(), [](const std::string& copy) { return copy.ends_with("/000001.json"); });
    }));
    old_ = read_file(disk_ / "bar.json");
  }

  Editor& editor() { return headless_.editor(); }
  void place(const Vec2& at) {
    headless_.click(headless_.window_point(at));
    EXPECT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  }
  void type_name(const std::filesystem::path& file) {
    headless_.key(Key::a, kControl);
    headless_.type(file.string());
    headless_.key(Key::enter);
  }
  /// How often a message with both parts was shown.
  std::ptrdiff_t said(const std::string& part, const std::string& other = "") {
    return std::ranges::count_if(editor().messages().log(), [&](const LoggedMessage& message) {
      return message.text.find(part) != std::string::npos &&
             message.text.find(other) != std::string::npos;
    });
  }
  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(disk_.path()))
      if (entry.path().filename() != "filler") names.insert(entry.path().filename().string());
    return names;
  }
  /// Of unsaved work, whole or half written.
  std::set<std::string> copies() const {
    std::set<std::string> copies;
    for (const std::filesystem::path& entry : entries_below(disk_ / "state/autosave"))
      if (entry.string().find(".json") != std::string::npos) copies.insert(entry.string());
    return copies;
  }
  /// The last copy failed, and none is being written.
  bool waits_to_copy_again() { return editor().files().autosave().next_wake().has_value(); }
  /// Whole ones: of one that is being written the name does not end so.
  bool has_one_more(const std::set<std::string>& before) const {
    const auto count = std::ranges::count_if(
        copies(), [](const std::string& copy) { return copy.ends_with(".json"); });
    return count > std::ssize(before);
  }
  /// Does something in each trouble, which has to leave the folder as it was.
  void in_every_trouble(const std::function<void()>& action, const std::function<void()>& after) {
    for (const Trouble& trouble : kTroubles) {
      SCOPED_TRACE(trouble.name);
      const std::set<std::string> before = names();
      (disk_.*trouble.begin)();
      action();
      EXPECT_EQ(names(), before);
      disk_.end();
      after();
    }
  }

  TroubledDisk disk_;
  HeadlessEditor headless_{{1000, 640},
                           {.state_folder = disk_ / "state", .pictures_folder = disk_.path()},
                           {.state_folder = disk_ / "state", .wake = {}}};
  std::string old_;
};

TEST_F(Troubled, ASaveThatFailsSaysWhatToDoAndTheOldFileStays) {
  in_every_trouble(
      [&] {
        headless_.key(Key::s, kControl);
        EXPECT_EQ(said("bar.json: cannot be written", "choose another folder"), 1);
        EXPECT_TRUE(editor().files().is_dirty());
        EXPECT_EQ(read_file(disk_ / "bar.json"), old_);
        headless_.calm_down();
      },
      [&] {
        headless_.key(Key::s, kControl);
        EXPECT_FALSE(editor().files().is_dirty());
        EXPECT_NE(read_file(disk_ / "bar.json"), old_);
        old_ = read_file(disk_ / "bar.json");
        place(Vec2(4, 0.5));
        editor().messages() = {};
      });
}

TEST_F(Troubled, TheSaveDialogKeepsTheNameThatWasTyped) {
  int number = 0;
  in_every_trouble(
      [&] {
        headless_.key(Key::s, kControlShift);
        type_name(disk_ / ("new" + std::to_string(++number) + ".json"));
        EXPECT_TRUE(editor().files().is_dirty());
      },
      [&] {
        headless_.key(Key::enter);
        EXPECT_FALSE(editor().files().is_dirty());
        EXPECT_TRUE(names().contains("new" + std::to_string(number) + ".json"));
        place(Vec2(4, 0.5));
      });
}

TEST_F(Troubled, NoExportLeavesAHalfWrittenFile) {
  const std::array<const char*, 6> files{"a.png", "a.svg", "a.pdf", "a.obj", "a.off", "a.ply"};
  in_every_trouble(
      [&] {
        for (const char* file : files) {
          SCOPED_TRACE(file);
          const std::size_t messages = editor().messages().log().size();
          headless_.key(Key::e, kControl);
          headless_.key(Key::enter);
          type_name(disk_ / file);
          ASSERT_TRUE(headless_.wait_until([&] { return !headless_.ui().is_exporting(); }));
          EXPECT_FALSE(names().contains(file));
          EXPECT_EQ(said(std::string("Wrote ") + (disk_ / file).string()), 0);
          headless_.key(Key::escape);  // the dialog that asks again
          if (std::string(file).ends_with("g") || std::string(file).ends_with("f")) continue;
          EXPECT_EQ(editor().messages().log().size(), messages) << "the dialog says it";
        }
        headless_.key(Key::f12);
        EXPECT_GE(said(".png: cannot be written"), 1);
      },
      [&] {
        headless_.key(Key::e, kControl);
        headless_.key(Key::enter);
        type_name(disk_ / "a.obj");
        EXPECT_TRUE(names().contains("a.obj"));
        std::filesystem::remove(disk_ / "a.obj");
        editor().messages() = {};
      });
}

TEST_F(Troubled, NoSequenceLeavesPicturesOrAFolder) {
  double time = 0;
  in_every_trouble(
      [&] {
        SequenceExport sequence;
        std::string problem = error_of([&] { sequence.start(disk_ / "film", editor(), {}); });
        EXPECT_TRUE(headless_.wait_until([&] {
          sequence.update(editor(), ++time);
          return !sequence.is_busy();
        }));
        EXPECT_EQ(problem.empty(), said("film/000001.png: cannot be written") == 1) << problem;
      },
      [&] { editor().messages() = {}; });
}

TEST_F(Troubled, WorkOfWhichNoCopyCanBeKeptIsToldOnceAndCopiedWhenThereIsRoom) {
  double x = 4;
  std::set<std::string> before;
  in_every_trouble(
      [&] {
        before = copies();
        place(Vec2(x--, 0.5));
        for (int minute = 0; minute < 4; ++minute) headless_.calm_down();
        EXPECT_TRUE(headless_.wait_until([&] { return said("unsaved work") > 0; }));
        for (int minute = 0; minute < 4; ++minute) headless_.calm_down();
        EXPECT_TRUE(headless_.wait_until([&] { return waits_to_copy_again(); }));
        EXPECT_EQ(said("unsaved work", "save it"), 1);
        EXPECT_EQ(copies(), before);
      },
      [&] {
        for (int minute = 0; minute < 3; ++minute) headless_.calm_down();
        EXPECT_TRUE(headless_.wait_until([&] { return has_one_more(before); }));
        editor().messages() = {};
      });
}

TEST_F(Troubled, SettingsThatCannotBeKeptAreToldOnceAndLastForTheSession) {
  const auto settings = disk_ / "state/settings.json";
  double scale = 1;
  in_every_trouble(
      [&] {
        for (int change = 0; change < 2; ++change) {
          headless_.ui().settings().scale = scale += 0.125;
          headless_.settle();
          headless_.calm_down();
          headless_.settle();
        }
        EXPECT_EQ(said("settings.json: cannot be written", "last until"), 1);
        EXPECT_EQ(headless_.ui().settings().scale, scale);
      },
      [&] {
        headless_.ui().settings().scale = scale += 0.125;
        headless_.settle();
        headless_.calm_down();
        headless_.settle();
        EXPECT_EQ(load_settings(settings).scale, scale);
        editor().messages() = {};
      });
}

TEST_F(Troubled, ARecordingEndsWithOneSentenceAndKeepsItsLines) {
  const auto file = disk_ / "session.jsonl";
  SessionRecorder recorder(file);
  recorder.follow(0, {{800, 600}, {800, 600}, 1}, {});
  recorder.add(1, WindowLeft{});
  disk_.fill();
  std::string problem;
  for (int k = 0; k < 5000 && recorder.is_on(); ++k) {
    try {
      recorder.add(2 + k, WindowLeft{});
    } catch (const Error& error) {
      problem = error.what();
    }
  }
  EXPECT_FALSE(recorder.is_on());
  EXPECT_TRUE(problem.starts_with(file.string())) << problem;
  EXPECT_NE(problem.find("make room"), std::string::npos) << problem;
  recorder.add(9999, WindowLeft{});
  disk_.end();
  EXPECT_TRUE(read_file(file).starts_with(R"({"session")"));
}

}  // namespace
}  // namespace foldless::test
