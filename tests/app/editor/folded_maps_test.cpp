// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of methods that may fold are shown, but no document keeps one.
#include "app/editor/document.h"
#include "core/energy/densities.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

class FoldedMaps : public EditorTest {
 protected:
  /// Corners that are held and a middle that is pulled over its neighbours, solved by
  /// injective projection as far as its first, folded map.
  void SetUp() override {
    open_grid(5);
    editor_->playback().toggle_pause();
    editor_->edits().set_energy(*find_density("dirichlet"));
    for (const int v : {0, 4, 20, 24}) place(v);
    middle_ = place(12);
    drag(pixel_of_handle(middle_), pixel_of(Vec2(4.2, 3.8)));
    editor_->edits().set_method("injective-projection");
    ASSERT_EQ(editor_->status().kind, StatusKind::paused) << editor_->status().words;
    editor_->playback().step_forward();
    wait_for([this] { return !editor_->shown()->is_valid(); });
  }
  bool document_is_valid() const {
    const Snapshot& pose = *editor_->document().pose;
    return pose.is_valid() && is_injective(*pose.triangles, *pose.rest, pose.deformed);
  }
  bool says(std::string_view words) const {
    for (const Toast& toast : editor_->messages().toasts())
      if (toast.text.find(words) != std::string::npos) return true;
    return false;
  }
  int middle_ = 0;
};

TEST_F(FoldedMaps, AreShownAndNamedButTheDocumentKeepsTheLastValidPose) {
  EXPECT_FALSE(is_valid());
  EXPECT_GT(editor_->shown()->folded_triangles, 0);
  EXPECT_GT(editor_->draft().proof().inverted, 0);
  EXPECT_NE(editor_->status().words.find(" folded. "), std::string::npos)
      << editor_->status().words;
  EXPECT_TRUE(document_is_valid());
}

TEST_F(FoldedMaps, AnEditGoesOnFromTheLastValidPoseAndSaysSo) {
  editor_->edits().set_method("paper-flip");
  EXPECT_TRUE(is_valid());
  EXPECT_TRUE(says("goes on from the last valid one"));
  EXPECT_TRUE(document_is_valid());
  editor_->playback().toggle_pause();
  settle();
  EXPECT_TRUE(is_valid());
}

TEST_F(FoldedMaps, ADraggedHandleBeginsAgainWhereTheMapWasValid) {
  drag(pixel_of_vertex(12), pixel_of(Vec2(2.2, 2.1)));
  EXPECT_TRUE(document_is_valid());
  editor_->playback().toggle_pause();
  settle();
  EXPECT_TRUE(document_is_valid());
  EXPECT_TRUE(is_at_targets(editor_->document()));
}

TEST_F(FoldedMaps, SavingKeepsTheLastValidPose) {
  const TemporaryFolder folder;
  ASSERT_TRUE(editor_->files().save_as(folder.path() / "scene.json"));
  EXPECT_TRUE(says("not the folded one"));
  make_editor({});
  editor_->files().open(folder.path() / "scene.json");
  ASSERT_FALSE(editor_->document().is_empty());
  EXPECT_TRUE(document_is_valid());
  EXPECT_EQ(editor_->document().parameters.method, "injective-projection");
}

TEST_F(FoldedMaps, AFoldedIterationCanBeSeenButNotUsed) {
  editor_->playback().step_forward();
  wait_for([this] { return editor_->playback().iterations().size() >= 2; });
  editor_->playback().first();
  ASSERT_FALSE(is_valid());
  editor_->playback().use_iteration();
  EXPECT_TRUE(says("This iteration is folded"));
  EXPECT_TRUE(document_is_valid());
  place(7);
  EXPECT_TRUE(document_is_valid());
  EXPECT_TRUE(is_valid());
}

TEST_F(FoldedMaps, UndoShowsTheValidPoseAgain) {
  editor_->draft().undo();
  EXPECT_TRUE(is_valid());
  EXPECT_TRUE(document_is_valid());
}

}  // namespace
}  // namespace foldless::test
