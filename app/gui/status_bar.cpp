// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>
#include <string>

#include "app/gui/hints.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

ImVec4 colour_of(StatusKind kind, const Palette& palette) {
  switch (kind) {
    case StatusKind::solving: return palette.busy;
    case StatusKind::converged: return palette.good;
    case StatusKind::blocked:
    case StatusKind::failed: return palette.warning;
    default: return palette.dim;
  }
}

/// A filled shape beside the words, another for each kind: colour alone tells nobody apart.
void draw_status_mark(StatusKind kind, const ImVec2& centre, const Look& look) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = packed(colour_of(kind, *look.palette));
  const float r = look.px(4);
  switch (kind) {
    case StatusKind::solving:
      list.AddTriangleFilled({centre.x - r, centre.y - r}, {centre.x - r, centre.y + r},
                             {centre.x + r, centre.y}, colour);
      break;
    case StatusKind::converged: list.AddCircleFilled(centre, r, colour); break;
    case StatusKind::blocked:
    case StatusKind::failed:
      list.AddTriangleFilled({centre.x - r, centre.y + r}, {centre.x + r, centre.y + r},
                             {centre.x, centre.y - r}, colour);
      break;
    default: list.AddCircle(centre, r, colour, 0, look.px(1.4F)); break;
  }
}

void draw_status(const Status& status, const Look& look) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  draw_status_mark(status.kind, {corner.x + look.px(5), corner.y + line / 2}, look);
  ImGui::SetCursorScreenPos({corner.x + look.px(16), corner.y});
  ImGui::TextUnformatted(status.words.c_str());
}

/// Always in sight: whether the map on screen is proved to be without fold.
std::string badge_words(const Proof& proof) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%d inverted  ·  area ≥ %.3g  ·  σ₁/σ₂ ≤ %.3g  ·  %d △",
                proof.inverted, proof.min_area_ratio, proof.max_conformal_distortion,
                proof.triangles);
  return text.data();
}

void draw_badge(const Editor& editor, const PanelContext& context) {
  if (!editor.shown()) return;
  const Look& look = context.look;
  const Proof& proof = editor.proof();
  const std::string words = badge_words(proof);
  const float width = ImGui::CalcTextSize(words.c_str()).x + look.px(18);
  ImGui::SameLine(ImGui::GetWindowWidth() - width - look.px(10));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  const ImVec4& colour = proof.inverted == 0 ? look.palette->good : look.palette->warning;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 c{corner.x + look.px(5), corner.y + line / 2};
  const float r = look.px(5);
  const float thickness = look.px(1.8F);
  if (proof.inverted == 0) {
    list.AddLine({c.x - r, c.y}, {c.x - r * 0.2F, c.y + r * 0.7F}, packed(colour), thickness);
    list.AddLine({c.x - r * 0.2F, c.y + r * 0.7F}, {c.x + r, c.y - r * 0.7F}, packed(colour),
                 thickness);
  } else {
    list.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, packed(colour), thickness);
    list.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, packed(colour), thickness);
  }
  ImGui::SetCursorScreenPos({corner.x + look.px(16), corner.y});
  ImGui::TextUnformatted(words.c_str());
  tooltip(
      "The proof, with exact arithmetic: how many triangles are inverted, the smallest ratio of "
      "deformed to original area, the largest stretch ratio, and how many triangles there are.",
      look);
}

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace

void draw_status_bar(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle& place = context.layout.status_bar;
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::PushFont(look.fonts.small);
  const float padding = std::max(0.0F, (place.height - ImGui::GetTextLineHeight()) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(10), padding});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->bar);
  if (ImGui::Begin("##status", nullptr, kFixed)) {
    draw_status(editor.status(), look);
    const std::string hint = hint_words(editor, context.state.modifiers);
    const float badge = editor.shown() ? look.px(330) : 0;
    const float width = ImGui::CalcTextSize(hint.c_str()).x;
    ImGui::SameLine(0, look.px(24));
    if (ImGui::GetCursorPosX() + width < place.width - badge)
      ImGui::TextColored(look.palette->dim, "%s", hint.c_str());
    else
      ImGui::Dummy({1, 1});
    draw_badge(editor, context);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace foldless
