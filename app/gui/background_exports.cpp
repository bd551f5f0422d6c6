// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/background_exports.h"

#include <glad/gl.h>
#include <imgui.h>

#include <cmath>
#include <string>

#include "app/gui/short_text.h"
#include "app/gui/theme.h"

namespace foldless {
namespace {

constexpr ImGuiWindowFlags kProgress =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;

std::string progress_words(const SequenceExport& sequence) {
  std::string words = std::to_string(sequence.written());
  words += " of ";
  words += std::to_string(sequence.count());
  if (const auto seconds = sequence.seconds_left()) {
    words += ", ";
    words += std::to_string(static_cast<long>(std::ceil(*seconds)));
    words += " s left";
  }
  return words;
}

/// What follows stands beside it.
void draw_bar(float share, const std::string& words, const Look& look) {
  ImGui::ProgressBar(share, {look.px(220), 0}, words.c_str());
  ImGui::SameLine();
}

}  // namespace

void update_exports(BackgroundExports& exports, Editor& editor, FileBrowser& browser, double time) {
  exports.file.update(editor, browser);
  if (!exports.sequence.is_busy() && !exports.animation.is_busy()) return;
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  if (exports.sequence.is_busy()) exports.sequence.update(editor, time);
  exports.animation.update(editor, time);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
}

void draw_progress(BackgroundExports& exports, const Rectangle& canvas, const Look& look) {
  SequenceExport& sequence = exports.sequence;
  AnimationExport& animation = exports.animation;
  if (!exports.is_busy()) return;
  ImGui::SetNextWindowPos({canvas.x + look.px(12), canvas.y + canvas.height - look.px(12)},
                          ImGuiCond_Always, {0, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->popup);
  ImGui::Begin("##exports", nullptr, kProgress);
  if (exports.file.is_busy()) {
    const std::string name = exports.file.path().filename().string();
    ImGui::TextUnformatted(("Writing " + shortened(name, look.px(220))).c_str());
    ImGui::SameLine();
    if (ImGui::Button("Cancel##file")) exports.file.cancel();
  }
  if (sequence.is_busy()) {
    ImGui::TextUnformatted("Writing the sequence");
    const auto done = static_cast<float>(sequence.written());
    draw_bar(done / static_cast<float>(sequence.count()), progress_words(sequence), look);
    if (ImGui::Button("Cancel##sequence")) sequence.cancel();
  }
  if (animation.is_busy()) {
    ImGui::TextUnformatted("Writing the animation");
    draw_bar(animation.share().value_or(0), animation.progress_words(), look);
    if (ImGui::Button("Cancel##animation")) animation.cancel();
  }
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace foldless
