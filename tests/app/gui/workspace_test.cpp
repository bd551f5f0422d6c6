// SPDX-License-Identifier: GPL-3.0-or-later
// Two workspaces, and commands of the interface by key and by search.
#include <gtest/gtest.h>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class Workspaces : public testing::Test {
 protected:
  explicit Workspaces()
      : headless_(std::make_unique<HeadlessEditor>(Extent{1280, 800},
                                                   UiOptions{.state_folder = state_.path()})) {
    open();
  }

  void open() {
    editor().files().open_shape(bar(4, 1, 3), "bar");
    headless_->calm_down();
  }
  Editor& editor() { return headless_->editor(); }
  const Layout& layout() { return headless_->ui().layout(); }
  Settings& settings() { return headless_->ui().settings(); }
  void run(std::string_view letters) {
    headless_->key(Key::k, kControl);
    headless_->type(letters);
    headless_->key(Key::enter);
    headless_->settle();
  }

  TemporaryFolder state_;
  std::unique_ptr<HeadlessEditor> headless_;
};

TEST_F(Workspaces, F3ChangesThemAndTheChoiceIsRemembered) {
  EXPECT_GT(layout().left.width, 0) << "meshes are studied";
  headless_->key(Key::f3);
  headless_->settle();
  EXPECT_EQ(layout().left.width, 0);
  EXPECT_GT(layout().right.width, 0);
  const float canvas = layout().canvas.width;
  headless_.reset();
  headless_ =
      std::make_unique<HeadlessEditor>(Extent{1280, 800}, UiOptions{.state_folder = state_.path()});
  open();
  EXPECT_EQ(layout().canvas.width, canvas);
  headless_->key(Key::f3);
  headless_->settle();
  EXPECT_GT(layout().left.width, 0);
}

TEST_F(Workspaces, AViewThatWasFittedIsFittedAgain) {
  const Vec2 before = headless_->window_point(Vec2(2, 0.5));
  headless_->key(Key::f3);
  headless_->settle();
  const Rectangle& canvas = layout().canvas;
  const Vec2 middle(canvas.x + canvas.width / 2, canvas.y + canvas.height / 2);
  EXPECT_GT((headless_->window_point(Vec2(2, 0.5)) - before).norm(), 10);
  EXPECT_LT((headless_->window_point(Vec2(2, 0.5)) - middle).norm(), 2);
}

TEST_F(Workspaces, EachHasItsOwnClosedSections) {
  headless_->key(Key::f3);
  headless_->settle();
  EXPECT_TRUE(settings().closed_in_animate.contains("Solver"));
  EXPECT_FALSE(settings().closed_sections.contains("Solver"));
  headless_->click({layout().right.x + 40, 47});  // the heading of the first section
  headless_->settle();
  EXPECT_TRUE(settings().closed_in_animate.contains("Handles"));
  EXPECT_FALSE(settings().closed_sections.contains("Handles"));
}

TEST_F(Workspaces, F4HidesThePanels) {
  headless_->key(Key::f4);
  headless_->settle();
  EXPECT_EQ(layout().canvas.width, 1280);
  headless_->key(Key::f4);
  headless_->settle();
  EXPECT_GT(layout().left.width, 0);
}

TEST_F(Workspaces, TheSearchFindsThemesSizesSamplesAndRecentFiles) {
  run("theme: light");
  EXPECT_EQ(settings().theme, Theme::light);
  run("size: 125");
  EXPECT_EQ(settings().scale, 1.25);
  run("workspace: animate");
  EXPECT_EQ(settings().workspace, Workspace::animate);
  run("within: 5 min");
  EXPECT_EQ(settings().autosave_seconds, 300);
  run("samples: alligator");
  EXPECT_EQ(editor().document().name, "figure10_alligator");
}

TEST_F(Workspaces, KeysBelongToADialogWhileThereIsOne) {
  headless_->key(Key::o, kControl);
  headless_->key(Key::f3);
  headless_->key(Key::escape);
  headless_->settle();
  EXPECT_FALSE(settings().workspace);
}

}  // namespace
}  // namespace foldless::test
