// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot_export.h"

#include <gtest/gtest.h>

#include <array>

#include "core/mesh/generate.h"

namespace foldless {
namespace {

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(PlotExport, DrawsAPictureForEverySeriesThatIsOn) {
  Editor editor;
  editor.files().open_shape(bar(4, 1, 4), "bar");
  std::array<bool, 8> shown{};
  shown[0] = shown[3] = shown[6] = true;
  const std::string svg = convergence_svg(editor, shown);
  EXPECT_EQ(occurrences(svg, "<svg"), 4U) << "three pictures in one";
  EXPECT_EQ(occurrences(svg, "</svg>"), 4U);
  EXPECT_NE(svg.find("Energy E"), std::string::npos);
  EXPECT_NE(svg.find("Flips"), std::string::npos);
  EXPECT_EQ(svg.find("Splits"), std::string::npos);
}

TEST(PlotExport, AnEmptyTimelineHasColumnNamesOnly) {
  const std::string csv = convergence_csv(Editor());
  EXPECT_EQ(occurrences(csv, "\n"), 1U);
  EXPECT_TRUE(csv.starts_with("outer,inner,phase,")) << csv;
}

}  // namespace
}  // namespace foldless
