// SPDX-License-Identifier: GPL-3.0-or-later
// Files are chosen in the desktop's dialog where there is one: a portal that answers for the user,
// on a bus of its own.
#include "app/gui/portal.h"

#include <gtest/gtest.h>

#include <optional>

#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/fake_portal.h"
#include "tests/support/patience.h"

namespace foldless::test {
namespace {

class DesktopDialogs : public testing::Test {
 protected:
  void SetUp() override {
    if (bus_.address().empty()) GTEST_SKIP() << "needs dbus-daemon (package dbus-daemon)";
    desktop_.emplace(bus_.address());
    const Shape shape = bar(4, 1, 2);
    bar_ = folder_ / "a bär.obj";
    write_mesh(bar_, shape.triangles, shape.rest);
    start();
  }
  /// An editor that has looked for the portal.
  void start() {
    portal_.emplace(bus_.address(), "x11:12ab");
    headless_.emplace(Extent{1000, 640}, UiOptions{.portal = &*portal_});
    ASSERT_TRUE(wait_until([this] { return !portal_->is_waiting(); }));
  }
  template <class Condition>
  bool wait_until(const Condition& condition) {
    const auto look = [&] {
      if (desktop_) desktop_->update();
      return condition();
    };
    return headless_->wait_until(look);
  }
  /// Presses keys upon which the desktop's dialog is asked for; what it was asked.
  std::string asked_by(Key key, Modifiers modifiers) {
    const std::size_t before = desktop_->calls().size();
    headless_->key(key, modifiers);
    EXPECT_TRUE(wait_until([&] { return desktop_->calls().size() > before; }));
    return desktop_->calls().empty() ? "" : desktop_->calls().back();
  }
  bool is_open(const std::string& words) { return headless_->find_words(words).has_value(); }
  bool waits_for_desktop() { return is_open("Choose in the dialog of your desktop."); }
  /// Our own dialog lists places.
  bool is_ours_open() { return is_open("Whole disk"); }
  void open_bar() {
    headless_->editor().files().open(bar_);
    headless_->calm_down();
  }
  const std::string& name() { return headless_->editor().document().name; }

  PrivateBus bus_;
  TemporaryFolder folder_;
  std::filesystem::path bar_;
  std::optional<FakePortal> desktop_;
  std::optional<Portal> portal_;
  std::optional<HeadlessEditor> headless_;
};

testing::AssertionResult has(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << part << " is not in " << text;
}

TEST_F(DesktopDialogs, AFileThatIsChosenThereIsOpened) {
  const std::string call = asked_by(Key::o, kControl);
  EXPECT_TRUE(call.starts_with("OpenFile ('x11:12ab', 'Open'")) << call;
  EXPECT_TRUE(has(call, "(0, '*.obj'), (0, '*.OBJ')"));
  EXPECT_TRUE(has(call, "('All files', [(0, '*')])"));
  EXPECT_TRUE(has(call, "'current_folder': <b'" + std::filesystem::current_path().string()));
  EXPECT_TRUE(waits_for_desktop());
  desktop_->answer(0, bar_);
  EXPECT_TRUE(wait_until([this] { return name() == "a bär"; }));
  EXPECT_FALSE(waits_for_desktop());
  EXPECT_FALSE(is_ours_open());
}

TEST_F(DesktopDialogs, WhatIsSavedGetsTheNameThatIsGivenThere) {
  open_bar();
  const std::string call = asked_by(Key::s, kControlShift);
  EXPECT_TRUE(call.starts_with("SaveFile (")) << call;
  EXPECT_TRUE(has(call, "'current_name': <'a bär.json'>"));
  EXPECT_TRUE(has(call, "'current_folder': <b'" + folder_.path().string()));
  desktop_->answer(0, folder_ / "posed");
  EXPECT_TRUE(wait_until([this] { return std::filesystem::exists(folder_ / "posed.json"); }));
}

TEST_F(DesktopDialogs, AnExtensionOfOursReplacesNothingUnasked) {
  open_bar();
  const auto there = folder_.write("posed.json", "old");
  asked_by(Key::s, kControlShift);
  desktop_->answer(0, folder_ / "posed");
  ASSERT_TRUE(wait_until([this] { return is_open("Keep it"); }));
  EXPECT_EQ(read_file(there), "old");
  headless_->key(Key::r);
  EXPECT_NE(read_file(there), "old");
}

TEST_F(DesktopDialogs, WhatTheDesktopHasAskedAboutIsNotAskedAgain) {
  open_bar();
  const auto there = folder_.write("posed.json", "old");
  asked_by(Key::s, kControlShift);
  desktop_->answer(0, there);
  EXPECT_TRUE(wait_until([&] { return read_file(there) != "old"; }));
}

TEST_F(DesktopDialogs, ASaveThatFailsGoesOnInOursWithTheName) {
  open_bar();
  const auto blocker = folder_.write("blocker", "a file, no folder");
  asked_by(Key::s, kControlShift);
  desktop_->answer(0, blocker / "posed.json");
  ASSERT_TRUE(wait_until([this] { return is_ours_open(); }));
  std::filesystem::remove(blocker);
  std::filesystem::create_directory(blocker);
  headless_->key(Key::enter);
  EXPECT_TRUE(std::filesystem::exists(blocker / "posed.json"));
}

TEST_F(DesktopDialogs, LeftThereNothingHappens) {
  open_bar();
  headless_->click(headless_->window_point({0, 0.5}));
  headless_->key(Key::q, kControl);
  asked_by(Key::enter, {});
  desktop_->answer(1);
  ASSERT_TRUE(wait_until([this] { return !waits_for_desktop(); }));
  EXPECT_FALSE(is_ours_open());
  EXPECT_FALSE(headless_->ui().wants_to_quit());
  EXPECT_TRUE(headless_->editor().files().is_dirty());
}

TEST_F(DesktopDialogs, EscapeClosesItThere) {
  asked_by(Key::o, kControl);
  headless_->key(Key::escape);
  EXPECT_FALSE(waits_for_desktop());
  EXPECT_TRUE(wait_until([this] { return desktop_->closed() == 1; }));
  desktop_->answer(0, bar_);
  asked_by(Key::o, kControl);
  EXPECT_TRUE(waits_for_desktop()) << "an answer to what was closed is none to what is open";
}

TEST_F(DesktopDialogs, OursIsChosenInstead) {
  asked_by(Key::o, kControl);
  headless_->key(Key::enter);
  EXPECT_TRUE(is_ours_open());
  EXPECT_TRUE(wait_until([this] { return desktop_->closed() == 1; }));
}

TEST_F(DesktopDialogs, OursOpensWhereTheDesktopFails) {
  asked_by(Key::o, kControl);
  desktop_->answer(2);
  EXPECT_TRUE(wait_until([this] { return is_ours_open(); }));
}

TEST_F(DesktopDialogs, OursOpensWhenThePortalEnds) {
  asked_by(Key::o, kControl);
  desktop_.reset();
  EXPECT_TRUE(wait_until([this] { return is_ours_open(); }));
  headless_->key(Key::escape);
  headless_->key(Key::o, kControl);
  EXPECT_TRUE(wait_until([this] { return is_ours_open(); })) << "nobody answers the call";
}

TEST_F(DesktopDialogs, OursOpensWhereThePortalHasNone) {
  desktop_.reset();
  desktop_.emplace(bus_.address(), false);
  ASSERT_NO_FATAL_FAILURE(start());
  headless_->key(Key::o, kControl);
  EXPECT_TRUE(is_ours_open());
}

TEST_F(DesktopDialogs, OursOpensWhereTheyAreSwitchedOff) {
  headless_->ui().settings().uses_desktop_dialogs = false;
  headless_->key(Key::o, kControl);
  EXPECT_TRUE(is_ours_open());
  EXPECT_TRUE(desktop_->calls().empty());
}

TEST(Portal, IsNotWhereThereIsNoBus) {
  Portal none("", ""), gone("unix:path=/nowhere/bus", "");
  comes_true([&gone] {
    gone.update();
    return !gone.is_waiting();
  });
  for (const Portal* portal : {&none, &gone}) {
    EXPECT_FALSE(portal->is_waiting());
    EXPECT_FALSE(portal->is_there());
  }
}

}  // namespace
}  // namespace foldless::test
