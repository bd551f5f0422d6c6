// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/theme.h"

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

ImVec4 rgb(unsigned hex, float alpha = 1.0F) {
  return {static_cast<float>((hex >> 16) & 0xFF) / 255.0F,
          static_cast<float>((hex >> 8) & 0xFF) / 255.0F, static_cast<float>(hex & 0xFF) / 255.0F,
          alpha};
}

void set_surface_colours(ImGuiStyle& style, const Palette& p) {
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = p.text;
  c[ImGuiCol_TextDisabled] = p.dim;
  c[ImGuiCol_WindowBg] = p.window;
  c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
  c[ImGuiCol_PopupBg] = p.popup;
  c[ImGuiCol_MenuBarBg] = p.bar;
  c[ImGuiCol_TitleBg] = p.bar;
  c[ImGuiCol_TitleBgActive] = p.bar;
  c[ImGuiCol_TitleBgCollapsed] = p.bar;
  c[ImGuiCol_Border] = p.outline;
  c[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
  c[ImGuiCol_Separator] = p.border;
  c[ImGuiCol_SeparatorHovered] = p.border;
  c[ImGuiCol_SeparatorActive] = p.accent;
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  c[ImGuiCol_ScrollbarGrab] = p.frame;
  c[ImGuiCol_ScrollbarGrabHovered] = p.hover;
  c[ImGuiCol_ScrollbarGrabActive] = p.press;
  c[ImGuiCol_TableHeaderBg] = p.bar;
  c[ImGuiCol_TableBorderLight] = p.border;
  c[ImGuiCol_TableBorderStrong] = p.border;
  c[ImGuiCol_TableRowBg] = {0, 0, 0, 0};
  c[ImGuiCol_TableRowBgAlt] = {0, 0, 0, 0};
  c[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, kDimmed};
}

void set_control_colours(ImGuiStyle& style, const Palette& p) {
  ImVec4* c = style.Colors;
  for (const int frame : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Tab}) c[frame] = p.frame;
  for (const int hover : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered,
                          ImGuiCol_TabHovered})
    c[hover] = p.hover;
  for (const int press :
       {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive, ImGuiCol_TabActive})
    c[press] = p.press;
  for (const int accent : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive,
                           ImGuiCol_NavHighlight, ImGuiCol_DragDropTarget})
    c[accent] = p.accent;
  c[ImGuiCol_Header] = p.frame;
  // Numbers are written over the grab.
  c[ImGuiCol_SliderGrab].w = 0.55F;
  c[ImGuiCol_SliderGrabActive].w = 0.8F;
  c[ImGuiCol_TextSelectedBg] = p.accent;
  c[ImGuiCol_TextSelectedBg].w = 0.4F;
}

void set_metrics(ImGuiStyle& style) {
  style.WindowPadding = {10, 8};
  style.FramePadding = {7, 3};
  style.ItemSpacing = {6, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 2};
  style.IndentSpacing = 12;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 9;
  style.WindowRounding = 0;
  style.ChildRounding = 5;
  style.PopupRounding = 6;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 1;
  style.WindowTitleAlign = {0.0F, 0.5F};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.DisabledAlpha = 0.45F;
}

}  // namespace

const Palette& dark_palette() {
  static const Palette palette{
      rgb(0x1E2127), rgb(0x17191E), rgb(0x262A32),
      rgb(0x343944), rgb(0x767E8C), rgb(0xE4E7EC),
      rgb(0x929AA8), rgb(0x2C313A), rgb(0x373D48),
      rgb(0x444C5A), rgb(0x5B9DFF), rgb(0x0B1220),
      rgb(0x4EC9B0), rgb(0x5B9DFF), rgb(0xF2A65A),
      rgb(0xFFD84D), rgb(0x1C1600), {rgb(0x5B9DFF), rgb(0xF2A65A), rgb(0x4EC9B0), rgb(0xE28BD6)}};
  return palette;
}

const Palette& light_palette() {
  static const Palette palette{
      rgb(0xF6F7F9), rgb(0xE9ECF0), rgb(0xFFFFFF),
      rgb(0xD3D8DF), rgb(0x7A818E), rgb(0x1D2229),
      rgb(0x5D6674), rgb(0xE3E7EC), rgb(0xD6DCE4),
      rgb(0xC5CDD8), rgb(0x1F6FEB), rgb(0xFFFFFF),
      rgb(0x0B7F6B), rgb(0x1F6FEB), rgb(0xB45309),
      rgb(0xFFD33D), rgb(0x1C1600), {rgb(0x1F6FEB), rgb(0xB45309), rgb(0x0B7F6B), rgb(0xA2329A)}};
  return palette;
}

const Palette& contrast_palette() {
  static const Palette palette{
      rgb(0x000000), rgb(0x000000), rgb(0x000000),
      rgb(0xFFFFFF), rgb(0xFFFFFF), rgb(0xFFFFFF),
      rgb(0xE0E0E0), rgb(0x262626), rgb(0x404040),
      rgb(0x606060), rgb(0xFFD400), rgb(0x000000),
      rgb(0x5CFFE0), rgb(0xFFD400), rgb(0xFFA64D),
      rgb(0xFFFF00), rgb(0x000000), {rgb(0xFFD400), rgb(0x4DC3FF), rgb(0xFFFFFF), rgb(0xFF8AE0)}};
  return palette;
}

void apply_theme(const Palette& palette, float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_metrics(style);
  set_surface_colours(style, palette);
  set_control_colours(style, palette);
  style.ScaleAllSizes(scale);
  const float hairline = std::max(1.0F, std::floor(scale));
  style.PopupBorderSize = hairline;
  style.FrameBorderSize = hairline;
}

ImU32 packed(const ImVec4& colour, float opacity) {
  return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, colour.w * opacity});
}

}  // namespace foldless
