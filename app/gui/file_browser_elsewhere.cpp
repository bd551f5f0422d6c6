// SPDX-License-Identifier: GPL-3.0-or-later
// The file browser while the desktop's own dialog stands in for it.
#include <imgui.h>

#include <utility>

#include "app/gui/dialog_keys.h"
#include "app/gui/file_browser.h"
#include "app/gui/widgets.h"

namespace foldless {

bool FileBrowser::follow(Portal* portal) {
  if (!is_elsewhere_) portal_ = portal;
  if (!portal_) return false;
  portal_->update();
  if (is_elsewhere_ && !answer_) answer_ = portal_->take_answer();
  return answer_.has_value();
}

/// The desktop's dialog has asked whether the file that was named is to be replaced; of a name that
/// gets its extension here it knew nothing. Ours goes on from there where more is to be asked.
void FileBrowser::take_answer(const PortalAnswer& answer) {
  if (answer.kind == PortalAnswer::Kind::dismissed) return dismiss();
  if (answer.kind == PortalAnswer::Kind::failed) {
    show();
    message_ = "The desktop’s dialog gave no file of this machine; choose one here.";
    return;
  }
  request_.start = saves() ? with_extension(request_, answer.file) : answer.file;
  show();
  std::error_code ignored;
  const bool is_known =
      request_.start == answer.file || !std::filesystem::exists(request_.start, ignored);
  if (!is_known) {
    replacing_ = request_.start;
    return;
  }
  opens_now_ = false;
  finish(request_.start);
}

void FileBrowser::draw_elsewhere(const Look& look) {
  const char* id = "##elsewhere";
  if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
  if (!begin_dialog(id, look)) return;
  title_text(request_.title.c_str(), look);
  dim_text("Choose in the dialog of your desktop.", look);
  ImGui::Spacing();
  const DialogKeys keys = dialog_keys();
  const bool shows = main_button("Choose here instead", look) || keys.takes;
  ImGui::SameLine();
  const bool leaves = ImGui::Button("Cancel") || keys.leaves;
  if (shows || leaves) portal_->withdraw();
  if (const auto answer = std::exchange(answer_, std::nullopt)) {
    ImGui::CloseCurrentPopup();
    take_answer(*answer);
  } else if (leaves) {
    dismiss();
  } else if (shows) {
    ImGui::CloseCurrentPopup();
    show();
  }
  end_dialog();
}

}  // namespace foldless
