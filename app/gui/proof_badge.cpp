// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/proof_badge.h"

#include <array>
#include <cstdio>
#include <vector>

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

using State = MotionProofStatus::State;

/// `  ·  60 vertices, 0.31 px off at most`: the baked mesh beside the solver's.
std::string baked_words(const MotionProofStatus& motion) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "  ·  %td vertices, %.2g px off at most", motion.vertices,
                motion.deviation);
  return text.data();
}

/// Before what is told of the frame on screen.
std::string motion_tip(const MotionProofStatus& motion) {
  const std::string of_frame = "\n\nOf the frame on screen:\n\n";
  switch (motion.state) {
    case State::none: return {};
    case State::running:
      return "The frames are being baked onto one mesh, and the ways of its vertices from frame to "
             "frame proved." +
             of_frame;
    case State::unproved:
      return "The frames were baked onto one mesh, but not every moment is proved: " +
             motion.problem + "." + of_frame;
    case State::proved: break;
  }
  return "Proved with exact arithmetic: baked onto one mesh whose vertices go straight from frame "
         "to frame, the animation is injective at every moment" +
         baked_words(motion) + "." + of_frame;
}

/// The first of some that takes at most `room` pixels, else the last.
std::string longest_that_fits(const std::vector<std::string>& candidates, float room) {
  for (const std::string& words : candidates)
    if (ImGui::CalcTextSize(words.c_str()).x <= room) return words;
  return candidates.back();
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
  return longest_that_fits({candidates.begin(), candidates.end()}, room);
}

std::string motion_badge_words(const MotionProofStatus& motion, float room) {
  const std::string frames = std::to_string(motion.frames) + " frames";
  switch (motion.state) {
    case State::none: return {};
    case State::running:
      return longest_that_fits({"Proving every moment between " + frames + "…", "Proving…"}, room);
    case State::unproved:
      return longest_that_fits({"Not proved: " + motion.problem, "Not proved between frames"},
                               room);
    case State::proved: break;
  }
  const std::string all = frames + " and every moment between them injective";
  return longest_that_fits({all + baked_words(motion), all, "every moment injective"}, room);
}

void draw_proof_badge(const Proof& proof, const MotionProofStatus& motion, float room,
                      const Look& look) {
  const float words_room = room - look.px(kMark + 16);
  const std::string of_motion =
      proof.holds() ? motion_badge_words(motion, words_room) : std::string();
  const std::string words = of_motion.empty() ? badge_words(proof, words_room) : of_motion;
  const bool is_good = proof.holds() && motion.state != State::unproved;
  const ImVec2 text = ImGui::CalcTextSize(words.c_str());
  const float width = text.x + look.px(kMark);
  ImGui::SameLine(ImGui::GetWindowWidth() - width - look.px(12));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (!is_good)
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x - look.px(6), corner.y - look.px(2)},
        {corner.x + width + look.px(6), corner.y + text.y + look.px(2)},
        packed(look.palette->caution), look.px(4));
  const ImVec4& mark = is_good ? look.palette->good : look.palette->on_caution;
  const ImVec4& colour = is_good ? look.palette->text : look.palette->on_caution;
  const ImVec2 centre{corner.x + look.px(5), corner.y + text.y / 2};
  if (is_good && motion.state == State::running)
    ImGui::GetWindowDrawList()->AddCircle(centre, look.px(4), packed(look.palette->busy), 0,
                                          look.px(1.4F));
  else
    draw_mark(is_good, centre, packed(mark), look);
  ImGui::SetCursorScreenPos({corner.x + look.px(kMark), corner.y});
  ImGui::TextColored(colour, "%s", words.c_str());
  tooltip(motion_tip(motion) + tip_of(proof), look);
}

}  // namespace foldless
