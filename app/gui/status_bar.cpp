// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "app/gui/hints.h"
#include "app/gui/panels.h"
#include "app/gui/proof_badge.h"
#include "app/gui/widgets.h"
#include "app/gui/zoom_menu.h"

namespace foldless {
namespace {

/// What the badge needs for its shortest words. [design pixels]
constexpr float kShortBadge = 120;

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

/// In a race every lane has its own.
bool has_badge(const Editor& editor) { return editor.shown() && !editor.race().is_open(); }

/// While an animation is on screen.
MotionProofStatus motion_proof(const Editor& editor) {
  const bool shows_frame = editor.draft().look_back() && !editor.draft().look_back()->iteration;
  return shows_frame ? editor.motion().proof() : MotionProofStatus();
}

/// At the right end; returns where what is left of the bar ends.
float draw_badge_and_zoom(Editor& editor, const PanelContext& context, float left) {
  const Look& look = context.look;
  const float width = context.layout.status_bar.width;
  if (!has_badge(editor)) return width;
  const float room = width - left - look.px(24);
  const float zoom = zoom_button_width(editor, look) + look.px(36);
  const bool has_zoom = room > zoom + look.px(kShortBadge);
  draw_proof_badge(editor.draft().proof(), motion_proof(editor), has_zoom ? room - zoom : room,
                   look);
  const float badge = ImGui::GetItemRectMin().x - ImGui::GetWindowPos().x;
  if (!has_zoom) return badge;
  draw_zoom_menu(editor, badge - look.px(30), look);
  return badge - zoom;
}

/// Between status and what is at the right, where there is room.
void draw_hint(const Editor& editor, const PanelContext& context, float left, float right) {
  const std::string hint = hint_words(editor, context.state.modifiers);
  if (left + ImGui::CalcTextSize(hint.c_str()).x + context.look.px(24) > right) return;
  ImGui::SameLine(left);
  ImGui::TextColored(context.look.palette->dim, "%s", hint.c_str());
}

constexpr ImGuiWindowFlags kStatusBarFlags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus;

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
  if (ImGui::Begin("##status", nullptr, kStatusBarFlags)) {
    draw_status(editor.race().is_open() ? editor.race().status() : editor.status(), look);
    const float left = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    const float right = draw_badge_and_zoom(editor, context, left);
    draw_hint(editor, context, left + look.px(24), right);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace foldless
