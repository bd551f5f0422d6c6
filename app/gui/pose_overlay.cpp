// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "app/gui/canvas_brush.h"

namespace foldless {

void draw_outlines(const Editor& editor, const CanvasBrush& brush, const Look& look) {
  auto outlines = editor.comparison().outlines();
  std::vector<PoseComparison::Outline> neighbours;
  for (const auto& pose : editor.motion().neighbours())
    neighbours.push_back(PoseComparison::outline_of(*pose));
  for (const auto& outline : neighbours) outlines.push_back(&outline);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    // Later ones stand out more.
    const float age = static_cast<float>(i + 1) / static_cast<float>(outlines.size());
    const float strength = 0.45F + 0.5F * age;
    for (const Points& loop : *outlines[i]) {
      std::vector<ImVec2> points;
      for (const auto& point : loop.colwise())
        points.push_back(brush.at(editor.canvas().to_pixel(point)));
      const int count = static_cast<int>(points.size());
      brush.list.AddPolyline(points.data(), count, packed(look.palette->popup, 0.6F),
                             ImDrawFlags_Closed, look.px(3.5F));
      brush.list.AddPolyline(points.data(), count, packed(look.palette->accent, strength),
                             ImDrawFlags_Closed, look.px(1.6F));
    }
  }
}

}  // namespace foldless
