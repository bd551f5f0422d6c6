// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/race_layout.h"

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

// Design pixels.
constexpr float kSetup = 42;
constexpr float kTwoLines = 74;
constexpr float kNarrowRace = 640;  ///< under this the setup takes two lines
constexpr float kHead = 78;
constexpr float kFewestResults = 96;
constexpr float kMostResults = 340;
constexpr float kLine = 2;

}  // namespace

RaceLayout race_layout_for(const Rectangle& area, std::size_t lanes, float scale) {
  const auto px = [scale](float design) { return std::round(design * scale); };
  RaceLayout layout;
  const float setup = std::min(px(area.width < px(kNarrowRace) ? kTwoLines : kSetup), area.height);
  const float results =
      std::min(std::clamp(std::round(0.42F * area.height), px(kFewestResults), px(kMostResults)),
               area.height - setup);
  const float top = area.y + setup;
  const float height = area.height - setup - results;
  const float head = std::min(px(kHead), height);
  layout.setup = {area.x, area.y, area.width, setup};
  layout.results = {area.x, top + height, area.width, results};
  const auto count = static_cast<float>(std::max<std::size_t>(lanes, 1));
  const float width = std::floor((area.width - px(kLine) * (count - 1)) / count);
  for (std::size_t i = 0; i < lanes; ++i) {
    const float x = area.x + static_cast<float>(i) * (width + px(kLine));
    layout.lanes.push_back({{x, top, width, head}, {x, top + head, width, height - head}});
  }
  return layout;
}

}  // namespace foldless
