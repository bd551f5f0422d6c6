// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

struct LogSlider {
  const char* id;
  const char* format;
  double least, largest;
};

/// Returns whether it was moved.
bool draw_slider(const LogSlider& slider, double& value, const Look& look) {
  auto number = static_cast<float>(value);
  const auto least = static_cast<float>(slider.least), most = static_cast<float>(slider.largest);
  ImGui::SetNextItemWidth(-1);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, ImVec4{0, 0, 0, 0});
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, ImVec4{0, 0, 0, 0});
  const bool is_moved =
      ImGui::SliderFloat(slider.id, &number, least, most, slider.format,
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopStyleColor(2);
  slider_line(std::log(number / least) / std::log(most / least), look);
  if (is_moved) value = number;
  return is_moved;
}

}  // namespace

void draw_stiffness_panel(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  StiffnessBrush& brush = editor.brush();
  bool is_on = brush.is_on();
  if (ImGui::Checkbox("Paint", &is_on)) editor.run_command("stiffness.paint");
  tooltip(
      "B takes the brush and puts it away. Drag over the drawing: what is painted keeps its shape "
      "better; Shift takes it back.",
      look);
  if (brush.can_clear()) {
    ImGui::SameLine();
    if (ImGui::Button("Remove all", {-1, 0})) brush.clear();
    tooltip("The whole drawing is as stiff as ever.", look);
  }
  if (!brush.is_on()) return;
  double factor = brush.factor(), radius = brush.radius();
  if (draw_slider({"##factor", "%.3g times as stiff", StiffnessBrush::kLeastFactor,
                   StiffnessBrush::kLargestFactor},
                  factor, look))
    brush.set_factor(factor);
  tooltip("Below 1 it gives way more easily. Ctrl-click to type a number.", look);
  if (draw_slider(
          {"##size", "size %.0f", StiffnessBrush::kLeastRadius, StiffnessBrush::kLargestRadius},
          radius, look))
    brush.set_radius(radius);
  tooltip("Radius on screen; [ and ] change it.", look);
}

}  // namespace foldless
