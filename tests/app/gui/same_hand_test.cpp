// SPDX-License-Identifier: GPL-3.0-or-later
// The same path of the hand, seen often or seldom, and paths there and back (EDITOR row 56).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class SameHand : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "foldless-hand-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    bar_ = bar(4, 1, 5);
    write_mesh(folder_ / "bar.obj", bar_.triangles, bar_.rest);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  int vertex_at(const Vec2& point) const {
    Eigen::Index nearest = 0;
    (bar_.rest.colwise() - point).colwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  }

  /// The bar at rest after its tip was led along stops, in the window's coordinates from where it
  /// was, with its other end pinned.
  Points dragged(const std::vector<Vec2>& stops) {
    HeadlessEditor headless;
    Editor& editor = headless.editor();
    editor.files().open(folder_ / "bar.obj");
    editor.edits().set_method("foldless");
    headless.calm_down();
    const int tip = vertex_at({4, 0.5});
    for (const int v : {vertex_at({0, 0}), vertex_at({0, 1}), tip})
      headless.click(headless.window_point(headless.position(v)));
    const auto rests = [&] { return !editor.playback().is_solving(); };
    EXPECT_TRUE(headless.wait_until(rests));
    const Vec2 from = headless.window_point(headless.position(tip));
    headless.press(from);
    for (const Vec2& stop : stops) headless.move(from + stop);
    headless.release(from + stops.back());
    EXPECT_TRUE(headless.wait_until(rests));
    const Snapshot& shown = *editor.shown();
    EXPECT_TRUE(is_injective(*shown.triangles, shown.deformed));
    return shown.deformed;
  }

  std::filesystem::path folder_;
  Shape bar_;
};

std::vector<Vec2> bow(int stops) {
  std::vector<Vec2> way;
  for (int i = 1; i <= stops; ++i) {
    const double t = static_cast<double>(i) / stops;
    way.emplace_back(-180 * t, -240 * t + 160 * t * (1 - t));
  }
  return way;
}

TEST_F(SameHand, LeavesTheSameShapeHoweverManyPointerEventsThereAre) {
  const Points often = dragged(bow(60)), seldom = dragged(bow(6)), once = dragged(bow(1));
  const double D = std::sqrt(17.0);
  EXPECT_LT((often - seldom).colwise().norm().maxCoeff(), 1e-3 * D);
  EXPECT_LT((often - once).colwise().norm().maxCoeff(), 1e-3 * D);
  EXPECT_GT((often - bar_.rest).colwise().norm().maxCoeff(), 0.1 * D) << "the claim would be empty";
}

TEST_F(SameHand, ThereAndBackGivesTheShapeBefore) {
  std::vector<Vec2> way = bow(30);
  for (int i = 29; i >= 0; --i) way.emplace_back(way[static_cast<std::size_t>(i)]);
  way.emplace_back(0, 0);
  EXPECT_LT((dragged(way) - bar_.rest).colwise().norm().maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace foldless::test
