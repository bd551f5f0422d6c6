// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/heat_legend.h"

#include <array>
#include <cstdio>
#include <string>

#include "app/gui/widgets.h"
#include "render/colormap.h"

namespace foldless {
namespace {

constexpr int kStripes = 64;

std::string heat_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), value >= 100 ? "%.3g" : "%.2f", value);
  return text.data();
}

void draw_gradient(const ImVec2& corner, const ImVec2& size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto colour_at = [](int stripe) {
    const glm::vec3 c = viridis(static_cast<float>(stripe) / kStripes);
    return packed({c.x, c.y, c.z, 1});
  };
  for (int i = 0; i < kStripes; ++i) {
    const float x0 = corner.x + size.x * static_cast<float>(i) / kStripes;
    const float x1 = corner.x + size.x * static_cast<float>(i + 1) / kStripes;
    list.AddRectFilledMultiColor({x0, corner.y}, {x1, corner.y + size.y}, colour_at(i),
                                 colour_at(i + 1), colour_at(i + 1), colour_at(i));
  }
}

/// Numbers at the ends and the quarters of the scale; each under its place.
void draw_numbers(const HeatRange& range, const ImVec2& corner, float width, const Look& look) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = look.fonts.small;
  for (const double t : {0.0, 1.0 / 3, 2.0 / 3, 1.0}) {
    const std::string number = heat_number(value_at(range, t));
    const float text_width =
        font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, number.c_str(), nullptr).x;
    const float x = corner.x + static_cast<float>(t) * (width - text_width);
    list.AddText(font, font->FontSize, {x, corner.y}, packed(look.palette->dim), number.c_str());
  }
}

void draw_marker(const ImVec2& corner, float x, const Look& look) {
  const float s = look.px(5);
  ImGui::GetWindowDrawList()->AddTriangleFilled({x - s, corner.y - s}, {x + s, corner.y - s},
                                                {x, corner.y + s * 0.6F},
                                                packed(look.palette->text));
}

}  // namespace

void draw_heat_legend(const HeatRange& range, std::optional<double> hovered, const Look& look) {
  static constexpr std::array kNames{"σ₁/σ₂, 1 keeps angles", "A′/A, 1 keeps areas",
                                     "ψ, energy per rest area"};  // in the order of HeatMeasure
  const std::string name = kNames[static_cast<std::size_t>(range.measure)];
  dim_text(hovered ? name + " · here " + heat_number(*hovered) : name + " · log scale", look);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = look.px(12);
  draw_gradient(corner, {width, height});
  if (hovered) {
    const auto t = static_cast<float>(position_on(range, *hovered));
    draw_marker(corner, corner.x + t * width, look);
  }
  draw_numbers(range, {corner.x, corner.y + height + look.px(2)}, width, look);
  ImGui::Dummy({width, height + look.px(4) + look.fonts.small->FontSize});
}

}  // namespace foldless
