// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace foldless {
namespace {

class SettingsFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "foldless-set-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(SettingsFile, ComesBackAsItWasWritten) {
  Settings settings;
  settings.scale = 1.5;
  settings.theme = Theme::contrast;
  settings.shows_panels = false;
  settings.shows_artboard = false;
  settings.shows_rulers = true;
  settings.uses_desktop_dialogs = false;
  settings.closed_sections = {"History", "Solver"};
  settings.pace = 12.5;
  settings.layers = Layers{.wireframe = false, .heat = true};
  settings.window_width = 1000;
  settings.window_height = 700;
  settings.is_maximised = true;
  settings.autosave_seconds = 300;
  save_settings(folder_ / "new" / "settings.json", settings);
  EXPECT_EQ(load_settings(folder_ / "new" / "settings.json"), settings);
}

TEST_F(SettingsFile, FallsBackOnDefaultsForWhatCannotBeUsed) {
  EXPECT_EQ(load_settings(folder_ / "missing.json"), Settings{});
  std::ofstream(folder_ / "bad.json") << "{\"scale\": \"big\", \"theme\": 7";
  EXPECT_EQ(load_settings(folder_ / "bad.json"), Settings{});
  std::ofstream(folder_ / "large.json") << R"({"scale": 1.5})" << std::string(2 << 20, ' ');
  EXPECT_EQ(load_settings(folder_ / "large.json"), Settings{});
}

TEST_F(SettingsFile, APipeInItsPlaceIsNotWaitedFor) {
  ASSERT_EQ(mkfifo((folder_ / "settings.json").c_str(), 0600), 0);
  EXPECT_EQ(load_settings(folder_ / "settings.json"), Settings{});
}

TEST_F(SettingsFile, KeepsTheScaleInItsRange) {
  std::ofstream(folder_ / "huge.json") << R"({"scale": 1e6})";
  EXPECT_EQ(load_settings(folder_ / "huge.json").scale, kLargestScale);
}

}  // namespace
}  // namespace foldless
