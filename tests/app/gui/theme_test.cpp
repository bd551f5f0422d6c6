// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foldless {
namespace {

/// Relative luminance of an sRGB colour [WCAG 2.1].
double luminance(const ImVec4& c) {
  const auto linear = [](double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

double contrast(const ImVec4& a, const ImVec4& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

class PaletteOf : public testing::TestWithParam<const Palette*> {};

TEST_P(PaletteOf, OutlinesOfControlsAndWhatIsChosenStandOut) {
  const Palette& p = *GetParam();
  for (const ImVec4& ground : {p.window, p.bar, p.popup})
    for (const ImVec4& mark : {p.outline, p.accent, p.good, p.warning})
      EXPECT_GE(contrast(mark, ground), 3);
}

TEST_P(PaletteOf, WordsAreReadable) {
  const Palette& p = *GetParam();
  for (const ImVec4& ground : {p.window, p.bar, p.popup, p.frame, p.hover})
    EXPECT_GE(contrast(p.text, ground), 4.5);
  for (const ImVec4& ground : {p.window, p.bar, p.popup}) EXPECT_GE(contrast(p.dim, ground), 4.5);
  EXPECT_GE(contrast(p.on_accent, p.accent), 4.5);
  EXPECT_GE(contrast(p.on_caution, p.caution), 4.5);
}

INSTANTIATE_TEST_SUITE_P(AllThemes, PaletteOf,
                         testing::Values(&dark_palette(), &light_palette(), &contrast_palette()));

}  // namespace
}  // namespace foldless
