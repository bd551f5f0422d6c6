// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that may fold, in the whole editor off screen: what is seen and what is said.
#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "render/theme.h"
#include "tests/app/gui/folding_document.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/pixels.h"

namespace foldless::test {
namespace {

int pixels_of(const Image& image, const glm::vec4& colour) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += difference(image.at(x, y), colour) <= 2;
  return count;
}

class BaselinesInTheEditor : public testing::Test {
 protected:
  Editor& editor() { return headless_.editor(); }
  int yellow_pixels() {
    return pixels_of(headless_.canvas_picture(),
                     canvas_colours(editor().view().options().theme).folded);
  }
  bool says(std::string_view words) {
    return editor().status().words.find(words) != std::string::npos;
  }
  bool document_is_valid() {
    const Snapshot& pose = *editor().document().pose;
    return is_injective(*pose.triangles, *pose.rest, pose.deformed);
  }

  HeadlessEditor headless_{{1000, 640}};
};

TEST_F(BaselinesInTheEditor, AFoldingSequenceIsYellowUntilItIsUnfolded) {
  open_folding_disk(headless_, "injective-projection");
  EXPECT_EQ(yellow_pixels(), 0);
  editor().playback().step_forward();
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().iterations().empty(); }));
  headless_.calm_down();
  ASSERT_GT(editor().shown()->folded_triangles, 0) << "the scene was chosen to fold";
  EXPECT_GT(yellow_pixels(), 300);
  EXPECT_TRUE(says(std::to_string(editor().shown()->folded_triangles) + " triangles folded"))
      << editor().status().words;
  EXPECT_TRUE(document_is_valid());

  editor().playback().toggle_pause();
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  headless_.calm_down();
  EXPECT_EQ(editor().shown()->folded_triangles, 0) << editor().status().words;
  EXPECT_EQ(yellow_pixels(), 0);
  EXPECT_TRUE(document_is_valid());
}

TEST_F(BaselinesInTheEditor, BoundedConformalShowsItsVerdictOrItsMap) {
  open_folding_disk(headless_, "bounded-conformal");
  editor().edits().set_parameter(*find_parameter_row("start"), 0);
  editor().playback().toggle_pause();
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  EXPECT_EQ(editor().status().kind, StatusKind::blocked);
  EXPECT_TRUE(says("Infeasible for these frames (certificate)")) << editor().status().words;
  EXPECT_EQ(yellow_pixels(), 0);

  editor().edits().reset_parameter(*find_parameter_row("start"));
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  EXPECT_EQ(editor().status().kind, StatusKind::converged) << editor().status().words;
  EXPECT_LE(editor().draft().proof().max_conformal_distortion, 100 * (1 + 1e-4));
  EXPECT_EQ(yellow_pixels(), 0);
  EXPECT_TRUE(document_is_valid());
}

}  // namespace
}  // namespace foldless::test
