// SPDX-License-Identifier: GPL-3.0-or-later
// Gestures of which the tests off screen have many, each once in a real window.
#include <array>

#include "tests/app/gui/real_window.h"
#include "tests/support/fake_portal.h"
#include "tests/support/pictures.h"

namespace foldless::test {
namespace {

/// The scene's two handles are at the left corners of its bar, which stands in a window of
/// 1280 × 800: see the pictures of the interface.
class RealGestures : public RealWindow {
 protected:
  static constexpr int kLeft = 316, kTop = 224, kBottom = 540;

  nlohmann::json saved() {
    const auto before = std::filesystem::last_write_time(scene_);
    tool("key --clearmodifiers ctrl+s");
    EXPECT_TRUE(wait_for([&] { return std::filesystem::last_write_time(scene_) != before; }));
    return nlohmann::json::parse(std::ifstream(scene_));
  }
  /// Deletes what is selected; returns the targets of the handles that are left.
  nlohmann::json targets_left() {
    tool("key Delete");
    EXPECT_TRUE(comes_to_rest());
    nlohmann::json targets = nlohmann::json::array();
    const nlohmann::json scene = saved();
    for (const auto& handle : scene.at("handles")) targets.push_back(handle.at("target"));
    return targets;
  }
  double magnification() {
    return saved().at("state").at("view").at("camera").at("pixels_per_unit");
  }
  void type(const std::string& text) { tool("type --delay 20 '" + text + "'"); }
};

TEST_F(RealGestures, ABoxSelects) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  drag(kLeft - 25, kTop - 25, 50, 50);
  EXPECT_EQ(targets_left(), nlohmann::json::parse("[[0, 0]]"));
}

TEST_F(RealGestures, ALassoSelectsWhileLIsHeld) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  tool("keydown l sleep 0.2 " + move_to(kLeft - 20, kBottom + 20) + " sleep 0.2 mousedown 1");
  for (const auto& [x, y] : {std::pair{-20, 0}, {-20, -20}, {0, -20}, {20, -20}, {20, 20}, {0, 20}})
    tool("sleep 0.1 " + move_to(kLeft + x, kBottom + y));
  tool("sleep 0.2 mouseup 1 sleep 0.1 keyup l");
  EXPECT_EQ(targets_left(), nlohmann::json::parse("[[0, 6]]"));
}

TEST_F(RealGestures, ADragIsUndoneAndRedone) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  drag(640, 400, 40, 120);
  ASSERT_TRUE(comes_to_rest());
  tool("key --clearmodifiers ctrl+z");
  EXPECT_EQ(saved().at("handles").size(), 2U);
  tool("key --clearmodifiers ctrl+shift+z");
  EXPECT_EQ(saved().at("handles").size(), 3U);
}

TEST_F(RealGestures, TheWheelZooms) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  const double before = magnification();
  tool(move_to(640, 400) + " sleep 0.2 click --repeat 3 4");
  ASSERT_TRUE(comes_to_rest());
  EXPECT_GT(magnification(), 1.1 * before);
}

TEST_F(RealGestures, AFileThatIsDroppedBecomesTheTexture) {
#ifndef FOLDLESS_DROP_FILES
  GTEST_SKIP() << "needs Xlib's headers (package libx11-dev)";
#else
  ASSERT_NO_FATAL_FAILURE(start_program());
  write_ring(folder_ / "ring.png", 60);
  const std::string words = std::string(FOLDLESS_DROP_FILES) + " " + window_ + " 640 400 " +
                            (folder_ / "ring.png").string();
  ASSERT_EQ(std::system(("timeout 20 " + words).c_str()), 0);
  ASSERT_TRUE(comes_to_rest());
  EXPECT_EQ(saved().at("texture"), "ring.png");
#endif
}

TEST_F(RealGestures, ANameIsTypedAndEnterSavesUnderIt) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  tool("key --clearmodifiers ctrl+shift+s");
  ASSERT_TRUE(comes_to_rest());
  tool("key --clearmodifiers ctrl+a");
  type((folder_ / "Other-1.json").string());
  tool("sleep 0.3 key Return");
  EXPECT_TRUE(wait_for([this] { return std::filesystem::exists(folder_ / "Other-1.json"); }));
}

TEST_F(RealGestures, EscapeKeepsTheProgramAndTabLeadsToDiscard) {
  ASSERT_NO_FATAL_FAILURE(start_program());
  drag(640, 400, 40, 120);
  ASSERT_TRUE(comes_to_rest());
  tool("key --clearmodifiers ctrl+q");
  ASSERT_TRUE(comes_to_rest());
  tool("key Escape");
  ASSERT_TRUE(comes_to_rest());
  EXPECT_TRUE(program_->is_running());
  for (const char* key : {"--clearmodifiers ctrl+q", "Tab", "Tab", "Return"}) {
    ASSERT_TRUE(comes_to_rest());
    tool(std::string("key ") + key);
  }
  ASSERT_TRUE(wait_for([this] { return !program_->is_running(); }));
  EXPECT_EQ(program_->status(), 0);
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(scene_)).at("handles").size(), 2U);
}

TEST_F(RealGestures, TheDialogOfTheDesktopIsToldOfTheWindow) {
  const PrivateBus bus;
  if (bus.address().empty()) GTEST_SKIP() << "needs dbus-daemon (package dbus-daemon)";
  setenv("DBUS_SESSION_BUS_ADDRESS", bus.address().c_str(), 1);
  FakePortal desktop(bus.address());
  const auto is_asked = [&] {
    desktop.update();
    return !desktop.calls().empty();
  };
  ASSERT_NO_FATAL_FAILURE(start_program());
  wait_for(is_asked, 1s);  // the program learns that there is one
  bool is_there = false;
  for (int i = 0; i < 20 && !is_there; ++i) {
    tool("key Escape sleep 0.2 key --clearmodifiers ctrl+shift+s");
    is_there = wait_for(is_asked, 4s);
  }
  ASSERT_TRUE(is_there);
  std::ostringstream window;
  window << "('x11:" << std::hex << std::stoul(window_) << "', ";
  EXPECT_NE(desktop.calls().front().find(window.str()), std::string::npos)
      << desktop.calls().front();
  desktop.answer(0, folder_ / "posed");
  EXPECT_TRUE(wait_for([this] { return std::filesystem::exists(folder_ / "posed.json"); }));
}

TEST_F(RealGestures, TheWindowHasAnIcon) {
  if (!is_installed("xprop")) GTEST_SKIP() << "needs xprop (package x11-utils)";
  ASSERT_NO_FATAL_FAILURE(start_program());
  const std::string icon = output_of("xprop -id " + window_ + " _NET_WM_ICON | head -n 2");
  EXPECT_NE(icon.find("Icon ("), std::string::npos) << icon;
}

}  // namespace
}  // namespace foldless::test
