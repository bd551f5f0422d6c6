// SPDX-License-Identifier: GPL-3.0-or-later
// What an animation of the document goes through.
#include <gtest/gtest.h>

#include "app/editor/scene_document.h"
#include "core/scene/scene_io.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class EditorAnimation : public EditorTest {
 protected:
  void SetUp() override {
    EditorTest::SetUp();
    open_grid(9);
    for (const int vertex : {42, 40, 38}) ids_.push_back(place(vertex));
    Animation animation;
    for (const int id : ids_) {
      HandleTracks tracks;
      tracks.handle = id;
      tracks.position = {{0, {1, 2}, {}}, {24, {3, 4}, *find_easing("both")}};
      animation.tracks.push_back(tracks);
    }
    animation.groups = {{{0, 0}, {ids_[0], ids_[1]}}};
    Document document = editor_->document();
    document.animation = std::make_shared<const Animation>(animation);
    editor_->draft().edit("Keys", document, Change::appearance);
    frame();
  }
  const Animation& animation() const { return *editor_->document().animation; }

  std::vector<int> ids_;
};

TEST_F(EditorAnimation, IsSavedAndOpenedAgain) {
  const TemporaryFolder folder;
  EXPECT_TRUE(editor_->files().is_dirty());
  ASSERT_TRUE(editor_->files().save_as(folder / "moves.json"));
  const Animation saved = animation();
  editor_->files().open(folder / "moves.json");
  frame();
  ASSERT_NE(editor_->document().animation, nullptr);
  EXPECT_EQ(animation(), saved);
  EXPECT_FALSE(editor_->files().is_dirty());
}

TEST_F(EditorAnimation, IsSomethingToSave) {
  Document other = editor_->document();
  EXPECT_TRUE(is_same_content(other, editor_->document()));
  other.animation = nullptr;
  EXPECT_FALSE(is_same_content(other, editor_->document()));
}

TEST_F(EditorAnimation, LosesTheTracksOfAHandleThatIsRemovedUntilUndo) {
  const Animation before = animation();
  editor_->selection().select({ids_[1]});
  editor_->run_command("edit.delete");
  frame();
  ASSERT_EQ(animation().tracks.size(), 2U);
  EXPECT_EQ(animation().groups[0].handles, std::vector<int>{ids_[0]});
  editor_->draft().undo();
  EXPECT_EQ(animation(), before);
}

}  // namespace
}  // namespace foldless::test
