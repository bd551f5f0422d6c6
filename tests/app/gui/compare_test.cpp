// SPDX-License-Identifier: GPL-3.0-or-later
// Rest and deformed mesh side by side, the race, what stands in a handle's way, and the badge: the
// whole editor off screen.
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <string_view>
#include <thread>
#include <vector>

#include "app/editor/edits.h"
#include "app/gui/race_layout.h"
#include "core/energy/densities.h"
#include "core/files/atomic_file.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/scene/scene_io.h"
#include "render/theme.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// A bar that is bent so far that edges flip.
class Compare : public testing::Test {
 protected:
  /// Without a frame in between, which would take longer than solving.
  Compare() {
    editor().files().open_shape(bar(4, 1, 5), "bar");
    Document document = editor().document();
    for (const int vertex : {2 * 21, 2 * 21 + 20, 2 * 21 + 4})
      document = place_handle(document, {.vertex = vertex}).document;
    document = with_targets(document, {{1, Vec2(2, 2.5)}});
    editor().draft().begin_edit();
    editor().draft().apply(document, Change::mesh);
    editor().draft().commit("Bend");
    while (editor().update(0), editor().playback().is_solving())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    headless_.settle();
  }

  Editor& editor() { return headless_.editor(); }
  static Vec2 middle(const Rectangle& r) { return {r.x + r.width / 2, r.y + r.height / 2}; }
  Vec2 rest_point(int vertex) {
    const Rectangle& pane = headless_.ui().layout().side;
    return editor().view().side_pane().pane().to_pixel(editor().shown()->rest->col(vertex)) +
           Vec2(pane.x, pane.y);
  }
  /// Pixels in a rectangle that are as good as a colour.
  int pixels_of(const glm::vec4& colour, const Rectangle& place) {
    const Image picture = headless_.picture();
    int count = 0;
    for (int y = static_cast<int>(place.y); y < static_cast<int>(place.y + place.height); ++y)
      for (int x = static_cast<int>(place.x); x < static_cast<int>(place.x + place.width); ++x) {
        const std::uint8_t* p = picture.at(x, y);
        int most = 0;
        for (int c = 0; c < 3; ++c)
          most = std::max(most, std::abs(p[c] - static_cast<int>(255 * colour[c] + 0.5F)));
        count += most <= 8;
      }
    return count;
  }

  HeadlessEditor headless_{{640, 400}};
};

TEST_F(Compare, ShowsFlippedEdgesInBothPanes) {
  ASSERT_FALSE(editor().shown()->flipped_edges->empty());
  headless_.key(Key::d);
  const Layout& layout = headless_.ui().layout();
  ASSERT_GT(layout.side.width, 100);
  const glm::vec4& blue = canvas_colours(Theme::dark).flipped;
  EXPECT_GT(pixels_of(blue, layout.side), 15);
  EXPECT_GE(pixels_of(blue, layout.canvas), 15);
  headless_.key(Key::d);
  EXPECT_EQ(layout.side.width, 0);
  EXPECT_EQ(pixels_of(blue, layout.canvas), 0);
}

TEST_F(Compare, PointingInOnePaneMarksTheSameVertexInTheOther) {
  headless_.key(Key::d);
  headless_.calm_down();
  const Image before = headless_.canvas_picture();
  const int vertex = 12;
  headless_.move(rest_point(vertex));
  const Image after = headless_.canvas_picture();
  const Vec2 mark = editor().canvas().to_pixel(headless_.position(vertex));
  int inside = 0, outside = 0;
  for (int y = 0; y < after.height; ++y)
    for (int x = 0; x < after.width; ++x) {
      const bool differs = std::memcmp(before.at(x, y), after.at(x, y), 4) != 0;
      (((Vec2(x, y) - mark).norm() < 14) ? inside : outside) += differs;
    }
  EXPECT_GT(inside, 30) << "a ring round the vertex";
  EXPECT_EQ(outside, 0) << "and nothing else";
}

TEST_F(Compare, DraggingTheRestPaneMovesBothOrOne) {
  headless_.key(Key::d);
  const Camera canvas = editor().canvas().camera;
  const Vec2 from(headless_.ui().layout().side.x + 20, headless_.ui().layout().side.y + 60);
  const auto drag = [&] {
    headless_.press(from);
    headless_.move(from + Vec2(40, 10));
    headless_.release(from + Vec2(40, 10));
  };
  drag();
  EXPECT_NEAR(editor().canvas().camera.centre.x, canvas.centre.x - 40 / canvas.pixels_per_unit,
              1e-9);
  headless_.key(Key::d, {.shift = true});
  const Camera moved = editor().canvas().camera;
  drag();
  EXPECT_EQ(editor().canvas().camera, moved);
  EXPECT_EQ(editor().document().handles.size(), 3U) << "the rest pane is for looking only";
}

TEST_F(Compare, HandlesAreDraggedBesideTheRestMesh) {
  editor().view().toggle_beside(Beside::rest_mesh);
  headless_.settle();
  const Points before = editor().shown()->deformed;
  const Vec2 from = headless_.window_point(editor().document().handles[1].target);
  headless_.press(from);
  headless_.move(from + Vec2(10, 20));
  headless_.release(from + Vec2(10, 20));
  headless_.wait_until([this] { return !editor().playback().is_solving(); });
  EXPECT_NE(editor().shown()->deformed, before);
}

TEST_F(Compare, RacesWithTheKeyboardAndClosesUntouched) {
  const auto pose = editor().document().pose;
  headless_.calm_down();
  const Image before = headless_.picture();
  headless_.key(Key::m);
  ASSERT_TRUE(editor().race().is_open());
  ASSERT_TRUE(headless_.wait_until([this] { return editor().race().is_finished(); }));
  const auto layout =
      race_layout_for(headless_.ui().layout().canvas, editor().race().lanes().size(), 1);
  for (const auto& lane : layout.lanes) {
    const Rectangle inner{lane.view.x + 4, lane.view.y + 4, lane.view.width - 8,
                          lane.view.height - 8};
    EXPECT_LT(pixels_of(canvas_colours(Theme::dark).background, inner),
              0.95 * static_cast<double>(inner.width) * static_cast<double>(inner.height))
        << "a mesh is seen in every lane";
  }
  headless_.calm_down();
  EXPECT_FALSE(headless_.next_frame()) << "a race that is over costs nothing";
  headless_.key(Key::escape);
  headless_.calm_down();
  EXPECT_FALSE(editor().race().is_open());
  EXPECT_EQ(editor().document().pose, pose);
  EXPECT_EQ(differing_pixels(before, headless_.picture()), 0);
}

TEST_F(Compare, LanesAreMovedAndZoomedTogether) {
  headless_.key(Key::m);
  const auto layout =
      race_layout_for(headless_.ui().layout().canvas, editor().race().lanes().size(), 1);
  // Only then is the view at rest: the end of a race is fitted too.
  ASSERT_TRUE(headless_.wait_until([this] { return editor().race().is_finished(); }));
  const Camera before = editor().race().canvas().camera;
  const Vec2 from = middle(layout.lanes.back().view);
  headless_.press(from);
  headless_.move(from + Vec2(30, 0));
  headless_.release(from + Vec2(30, 0));
  EXPECT_NEAR(editor().race().canvas().camera.centre.x,
              before.centre.x - 30 / before.pixels_per_unit, 1e-9);
  headless_.key(Key::home);
  EXPECT_EQ(editor().document().handles.size(), 3U) << "no click reaches the document";
}

TEST_F(Compare, WritesItsTableAsCsvOrLatex) {
  const TemporaryFolder folder;
  headless_.key(Key::m);
  ASSERT_TRUE(headless_.wait_until([this] { return editor().race().is_finished(); }));
  editor().run_command("file.export_table");
  const auto save_as = [&](const std::filesystem::path& file) {
    headless_.settle();
    headless_.key(Key::a, kControl);
    // All at once: a frame for every letter takes its time.
    for (const char c : file.string())
      headless_.ui().receive(CharacterTyped{static_cast<char32_t>(c)});
    headless_.settle();
    headless_.key(Key::enter);
    headless_.settle();
  };
  save_as(folder / "t.txt");
  EXPECT_FALSE(std::filesystem::exists(folder / "t.txt")) << "it asks again";
  save_as(folder / "t.csv");
  EXPECT_TRUE(read_file(folder / "t.csv").starts_with("lane,mesh,"));
  editor().run_command("file.export_table");
  save_as(folder / "t.tex");
  const std::string latex = read_file(folder / "t.tex");
  EXPECT_NE(latex.find("\\toprule\nlane & method"), std::string::npos) << latex;
  EXPECT_NE(latex.find("paper-noflip"), std::string::npos);
}

TEST_F(Compare, MarksTheEdgeInTheWayUntilItIsFlipped) {
  const glm::vec4 mark(0xFF / 255.0F, 0xD8 / 255.0F, 0x4D / 255.0F, 1);
  Shape square{Triangles(3, 2), Points(2, 4)};
  square.triangles << 0, 0, 1, 2, 2, 3;
  square.rest << 0, 1, 1, 0, 0, 0, 1, 1;
  editor().files().open_shape(square, "square");
  Document document = editor().document();
  document.parameters.method = "paper-noflip";
  for (const int vertex : {0, 1, 2, 3})
    document = place_handle(document, {.vertex = vertex}).document;
  document = with_targets(document, {{3, Vec2(0.7, 0.3)}});
  editor().draft().begin_edit();
  editor().draft().apply(document, Change::mesh);
  editor().draft().commit("Past the diagonal");
  ASSERT_TRUE(headless_.wait_until([this] { return editor().stuck().handle() != nullptr; }));
  headless_.calm_down();
  const Rectangle canvas = headless_.ui().layout().canvas;
  EXPECT_GT(pixels_of(mark, canvas), 100);
  headless_.key(Key::f, {.shift = true});
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  headless_.calm_down();
  EXPECT_EQ(editor().status().kind, StatusKind::converged) << editor().status().words;
  EXPECT_EQ(pixels_of(mark, canvas), 0);
}

TEST_F(Compare, TheBadgeTurnsYellowWhereAMapFolds) {
  const glm::vec4 yellow(0xFF / 255.0F, 0xD8 / 255.0F, 0x4D / 255.0F, 1);
  const Rectangle bar = headless_.ui().layout().status_bar;
  EXPECT_EQ(pixels_of(yellow, bar), 0);
  Document folded = editor().document();
  auto pose = std::make_shared<Snapshot>(*folded.pose);
  pose->deformed.col(12) += Vec2(3, 3);
  folded.pose = pose;
  folded.handles.clear();
  editor().draft().begin_edit();
  editor().draft().apply(folded, Change::appearance);
  editor().draft().commit("Fold");
  headless_.calm_down();
  ASSERT_FALSE(editor().draft().proof().holds());
  EXPECT_GT(pixels_of(yellow, bar), 1000);
}

TEST_F(Compare, AMapThatOverlapsAtTheBoundaryIsYellowAndMayBeKept) {
  const Fixture fan = open_fan(300);
  Scene scene;
  scene.triangles = fan.triangles;
  scene.rest = fan.rest;
  scene.energy = find_density("arap");
  scene.parameters.method = "lim";
  scene.state = SceneState{fan.triangles, fan.rest, open_fan(400).rest};
  const TemporaryFolder folder;
  save_scene(scene, folder / "fan.json");
  ASSERT_TRUE(editor().files().save_as(folder / "bar.json"));
  editor().files().open(folder / "fan.json");
  headless_.calm_down();
  EXPECT_EQ(editor().draft().proof().overlapping_boundary_vertices, 1);
  EXPECT_FALSE(editor().draft().proof().folds());
  const glm::vec4 yellow(0xFF / 255.0F, 0xD8 / 255.0F, 0x4D / 255.0F, 1);
  EXPECT_GT(pixels_of(yellow, headless_.ui().layout().status_bar), 1000);
  ASSERT_TRUE(editor().files().save_as(folder / "kept.json"));
  const std::vector<std::string_view> methods{"lim"};
  const Scene kept = load_scene(folder / "kept.json", methods).scene;
  ASSERT_TRUE(kept.state);
  EXPECT_EQ(overlapping_boundary_vertices(kept.state->triangles, kept.state->deformed).size(), 1U);
}

}  // namespace
}  // namespace foldless::test
