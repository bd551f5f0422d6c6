// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui_internal.h>

#include <string>

#include "app/gui/dialog_focus.h"
#include "app/gui/dialog_keys.h"
#include "app/gui/image_dialog.h"
#include "app/gui/panels.h"
#include "app/gui/preview.h"
#include "app/gui/recovery_dialog.h"
#include "app/gui/widgets.h"

namespace foldless {
void draw_unsaved_question(Editor& editor, const PanelContext& context) {
  const char* id = "##unsaved";
  const bool is_asked = editor.files().question() != nullptr && !context.state.browser.is_open();
  if (is_asked && !ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  const Look& look = context.look;
  if (!begin_dialog(id, look)) return;
  if (!is_asked) ImGui::CloseCurrentPopup();
  title_text("Save the changes?", look);
  const std::string name = editor.files().path().empty() ? "This scene has never been saved."
                                                         : editor.files().path().string();
  dim_text(name, look);
  ImGui::Spacing();
  const DialogKeys keys = dialog_keys();
  if (main_button("Save", look) || keys.takes) editor.files().answer(Answer::save);
  ImGui::SameLine();
  if (ImGui::Button("Discard the changes")) editor.files().answer(Answer::discard);
  ImGui::SameLine();
  if (ImGui::Button("Cancel") || keys.leaves) editor.files().answer(Answer::cancel);
  end_dialog();
}

/// What was replaced does not come back: Enter saves beside it, and only a key of its own replaces.
void draw_overwrite_question(Editor& editor, const PanelContext& context) {
  const char* id = "##overwrite";
  DocumentFiles& files = editor.files();
  if (files.asks_to_overwrite() && !ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  const Look& look = context.look;
  if (!begin_dialog(id, look)) return;
  if (!files.asks_to_overwrite()) ImGui::CloseCurrentPopup();
  title_text("Overwrite what another program saved?", look);
  ImGui::PushTextWrapPos(look.px(460));
  dim_text(files.path().string() + " has changed since it was opened or saved here.", look);
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  const DialogKeys keys = dialog_keys();
  if (main_button("Save as…", look) || keys.takes) files.answer_overwrite(OverwriteAnswer::save_as);
  ImGui::SameLine();
  if (ImGui::Button("Overwrite (O)") || takes_key(Key::o))
    files.answer_overwrite(OverwriteAnswer::overwrite);
  ImGui::SameLine();
  if (ImGui::Button("Cancel") || keys.leaves) files.answer_overwrite(OverwriteAnswer::cancel);
  end_dialog();
}

void draw_about(const PanelContext& context) {
  const char* id = "##about";
  if (context.state.shows_about && !ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  const Look& look = context.look;
  if (!begin_dialog(id, look)) return;
  title_text("Foldless", look);
  ImGui::PushTextWrapPos(look.px(400));
  ImGui::TextUnformatted(
      "Deforms planar triangle meshes without a fold: every mesh on screen and "
      "in every file is proved to be locally injective.");
  ImGui::Spacing();
  dim_text(
      "An implementation of “Remeshing-assisted Optimization for Locally Injective "
      "Mappings” by Yao Jin, Jin Huang and Ruofeng Tong, SGP 2014.",
      look);
  dim_text("Free software under the GNU General Public License, version 3 or later.", look);
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  const DialogKeys keys = dialog_keys();
  if (main_button("Close", look) || keys.takes || keys.leaves) {
    context.state.shows_about = false;
    ImGui::CloseCurrentPopup();
  }
  end_dialog();
}

void draw_dialogs(Editor& editor, const PanelContext& context) {
  UiState& state = context.state;
  draw_unsaved_question(editor, context);
  draw_overwrite_question(editor, context);
  // Beside those two the canvas is looked at; other dialogs darken what they cover.
  const bool has_preview = preview_of(editor) && !editor.files().question();
  ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg].w = has_preview ? 0 : kDimmed;
  draw_image_dialog(editor, context);
  draw_recovery_dialog(editor, context);
  state.exporting.draw(editor, state, context.look);
  state.browser.draw(context.look);
  state.search.draw(editor, state, context.look);
  draw_cheat_sheet(editor, context);
  draw_message_log(editor, context);
  state.keys.draw(editor, context.look);
  draw_about(context);
  state.context_menu.draw(editor, context.look);
  draw_dialog_focus(context.look);
  // Frames are drawn when something happens: a fade would stand still half way.
  ImGui::GetCurrentContext()->DimBgRatio = ImGui::GetTopMostPopupModal() ? 1.0F : 0.0F;
}

}  // namespace foldless
