// SPDX-License-Identifier: GPL-3.0-or-later
// Handles that make the mesh round them stiff.
#include "app/editor/handle_edits.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// A handle in the middle of a grid of side 8, selected; two corners are held.
class StiffHandles : public EditorTest {
 protected:
  StiffHandles() {
    open_grid(9);
    place(0);
    place(80);
    id_ = place(40);
    frame();
  }
  const Handle& handle() const { return *find_handle(editor_->document(), id_); }

  int id_ = 0;
};

TEST_F(StiffHandles, AFactorIsAStepThatTheSolverSees) {
  set_stiffness(*editor_, 100);
  ASSERT_TRUE(handle().stiff);
  EXPECT_EQ(handle().stiff->factor, 100);
  EXPECT_NEAR(handle().stiff->radius, 0.8 * std::sqrt(2), 1e-12) << "a tenth of the diagonal";
  const auto stiffness = mesh_of(editor_->document()).stiffness();
  ASSERT_TRUE(stiffness);
  EXPECT_EQ(stiffness->at({4.5, 4.5}), 100);
  EXPECT_EQ(stiffness->at({6, 6}), 1);
  settle();
  key(Key::z, kControl);
  EXPECT_FALSE(handle().stiff);
  EXPECT_FALSE(mesh_of(editor_->document()).stiffness());
}

TEST_F(StiffHandles, KeepTheShapeRoundThem) {
  const auto stretch = [&] {
    const Points& p = editor_->document().pose->deformed;
    return std::abs((p.col(41) - p.col(40)).norm() - 1) +
           std::abs((p.col(49) - p.col(40)).norm() - 1);
  };
  drag(pixel_of_vertex(80), pixel_of({11, 10}));
  settle();
  const double soft = stretch();
  editor_->selection().select({id_});
  set_stiffness(*editor_, 1000);
  set_stiff_radius(*editor_, 2);
  settle();
  EXPECT_LT(stretch(), soft / 3);
  EXPECT_TRUE(is_valid());
}

TEST_F(StiffHandles, StayWhereTheyAreAtRest) {
  set_stiffness(*editor_, 10);
  drag(pixel_of_handle(id_), pixel_of({6, 6}));
  settle();
  EXPECT_EQ(mesh_of(editor_->document()).stiffness()->at({4, 4}), 10);
  EXPECT_EQ(mesh_of(editor_->document()).stiffness()->at({6, 6}), 1);
}

TEST_F(StiffHandles, NumbersAreClampedAndOneIsNone) {
  set_stiffness(*editor_, 1e9);
  EXPECT_EQ(handle().stiff->factor, 1000);
  set_stiffness(*editor_, 0);
  EXPECT_EQ(handle().stiff->factor, 0.1);
  set_stiffness(*editor_, std::nan(""));
  set_stiff_radius(*editor_, -1);
  set_stiff_radius(*editor_, 3);
  EXPECT_EQ(*handle().stiff, (StiffDisk{0.1, 3}));
  EXPECT_EQ(*selected_handles(*editor_).stiffness, 0.1);
  editor_->selection().select_all();
  EXPECT_FALSE(selected_handles(*editor_).stiffness) << "they differ";
  set_stiffness(*editor_, 1);
  EXPECT_FALSE(handle().stiff);
}

TEST_F(StiffHandles, AreTintedWhileTheyAreSelected) {
  EXPECT_FALSE(editor_->brush().is_tinted());
  EXPECT_TRUE(editor_->brush().factors().empty());
  set_stiffness(*editor_, 10);
  EXPECT_TRUE(editor_->brush().is_tinted());
  EXPECT_EQ(std::ranges::count(editor_->brush().factors(), 10.0F), 8);
  editor_->selection().select_none();
  EXPECT_FALSE(editor_->brush().is_tinted());
}

TEST_F(StiffHandles, AreSavedAndOpenedAgain) {
  const TemporaryFolder folder;
  set_stiffness(*editor_, 10);
  const Handle saved = handle();
  ASSERT_TRUE(editor_->files().save_as(folder / "stiff.json"));
  editor_->files().open(folder / "stiff.json");
  EXPECT_EQ(handle(), saved);
}

}  // namespace
}  // namespace foldless::test
