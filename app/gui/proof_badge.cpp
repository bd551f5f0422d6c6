// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/proof_badge.h"

#include <array>
#include <cstdio>

#include "app/gui/widgets.h"

namespace foldless {
namespace {

/// The mark, and the space round it. [design pixels]
constexpr float kMark = 16;

std::string numbers_of(const Proof& proof) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "A′/A ≥ %.3g  ·  σ₁/σ₂ ≤ %.3g", proof.min_area_ratio,
                proof.max_conformal_distortion);
  return text.data();
}

/// A tick or a cross: colour alone tells nobody apart.
void draw_mark(bool holds, const ImVec2& c, ImU32 colour, const Look& look) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = look.px(5), thickness = look.px(1.8F);
  if (holds) {
    list.AddLine({c.x - r, c.y}, {c.x - r * 0.2F, c.y + r * 0.7F}, colour, thickness);
    list.AddLine({c.x - r * 0.2F, c.y + r * 0.7F}, {c.x + r, c.y - r * 0.7F}, colour, thickness);
  } else {
    list.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, thickness);
    list.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, colour, thickness);
  }
}

const char* verdict_of(const Proof& proof) {
  if (proof.holds())
    return "Proved with exact arithmetic: no triangle of this map is turned over, no vertex is "
           "wound twice, and no boundary vertex overlaps itself.";
  if (proof.folds())
    return "This map folds. The method that made it does not prevent that; the remeshing-assisted "
           "methods do.";
  return "At some boundary vertices the angles of this map add up to a full turn or more. The "
         "method that made it does not look there; Foldless does.";
}

std::string tip_of(const Proof& proof) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(),
                "%s\n\nInverted triangles: %d\nVertices wound twice: %d\nBoundary vertices that "
                "overlap themselves: %d\nSmallest area ratio A′/A: %.6g\nLargest conformal "
                "distortion σ₁/σ₂: %.6g\nTriangles: %d, vertices: %d",
                verdict_of(proof), proof.inverted, proof.branch_vertices,
                proof.overlapping_boundary_vertices, proof.min_area_ratio,
                proof.max_conformal_distortion, proof.triangles, proof.vertices);
  return text.data();
}

}  // namespace

std::string badge_words(const Proof& proof, float room) {
  const std::string folds = std::to_string(proof.inverted) + " inverted";
  const std::string verdict = proof.holds() ? folds : fold_words(proof);
  const std::string numbers = numbers_of(proof);
  const std::array candidates{
      verdict + "  ·  " + numbers + "  ·  " + std::to_string(proof.triangles) + " △",
      verdict + "  ·  " + numbers, verdict,
      proof.holds() ? folds : std::string(proof.folds() ? "Folded" : "Overlaps")};
  for (const std::string& words : candidates)
    if (ImGui::CalcTextSize(words.c_str()).x <= room) return words;
  return candidates.back();
}

void draw_proof_badge(const Proof& proof, float room, const Look& look) {
  const std::string words = badge_words(proof, room - look.px(kMark + 16));
  const ImVec2 text = ImGui::CalcTextSize(words.c_str());
  const float width = text.x + look.px(kMark);
  ImGui::SameLine(ImGui::GetWindowWidth() - width - look.px(12));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (!proof.holds())
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x - look.px(6), corner.y - look.px(2)},
        {corner.x + width + look.px(6), corner.y + text.y + look.px(2)},
        packed(look.palette->caution), look.px(4));
  const ImVec4& mark = proof.holds() ? look.palette->good : look.palette->on_caution;
  const ImVec4& colour = proof.holds() ? look.palette->text : look.palette->on_caution;
  draw_mark(proof.holds(), {corner.x + look.px(5), corner.y + text.y / 2}, packed(mark), look);
  ImGui::SetCursorScreenPos({corner.x + look.px(kMark), corner.y});
  ImGui::TextColored(colour, "%s", words.c_str());
  tooltip(tip_of(proof), look);
}

}  // namespace foldless
