// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/picking.h"

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

using Picking = EditorTest;

TEST_F(Picking, NothingIsUnderThePointerWhenNothingIsOpen) {
  EXPECT_FALSE(pick_handle(nullptr, editor_->canvas(), {1, 1}).has_value());
  EXPECT_FALSE(
      pick_mesh(nullptr, editor_->canvas(), {1, 1}, editor_->draft().paint_order()).has_value());
  EXPECT_TRUE(handles_in(nullptr, editor_->canvas(), {{0, 0}, {800, 600}}).empty());
}

TEST_F(Picking, VertexWinsWithinTheHitRadiusAndThePointBeyond) {
  open_grid(5);
  const Snapshot* shown = editor_->shown().get();
  const auto at = [&](const Vec2& pixel) {
    return pick_mesh(shown, editor_->canvas(), pixel, editor_->draft().paint_order());
  };
  ASSERT_TRUE(at(pixel_of_vertex(12) + Vec2(9, 0)).has_value());
  EXPECT_EQ(at(pixel_of_vertex(12) + Vec2(9, 0))->vertex, 12);
  const auto inside = at(pixel_of_vertex(12) + Vec2(25, 12));
  ASSERT_TRUE(inside.has_value());
  EXPECT_FALSE(inside->vertex.has_value());
  EXPECT_NEAR(inside->barycentric.sum(), 1, 1e-12);
  EXPECT_GT(inside->barycentric.minCoeff(), 0);
}

TEST_F(Picking, VertexOnTheBoundaryIsFoundFromOutside) {
  open_grid(5);
  const Snapshot* shown = editor_->shown().get();
  const auto hit = pick_mesh(shown, editor_->canvas(), pixel_of_vertex(4) + Vec2(5, 5),
                             editor_->draft().paint_order());
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->vertex, 4);
  EXPECT_FALSE(pick_mesh(shown, editor_->canvas(), pixel_of_vertex(4) + Vec2(15, 15),
                         editor_->draft().paint_order())
                   .has_value());
}

TEST_F(Picking, RingOfATargetCanBeCaughtToo) {
  open_grid(5);
  place(0);
  key(Key::space);  // the mesh stays where it is
  const Vec2 from = pixel_of_vertex(24);
  drag(from, from + Vec2(60, -40));
  const auto hit = pick_handle(editor_->shown().get(), editor_->canvas(), from + Vec2(62, -40));
  ASSERT_TRUE(hit.has_value());
  EXPECT_TRUE(hit->is_target);
  const Vec2 target_before = target(1);
  drag(from + Vec2(60, -40), from + Vec2(70, -40));
  const double by = 10 / editor_->canvas().camera.pixels_per_unit;
  EXPECT_LT((target(1) - target_before - Vec2(by, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace foldless::test
