// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/export_dialog.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/gui/dialog_keys.h"
#include "app/gui/export_place.h"
#include "app/gui/ui_state.h"
#include "app/gui/widgets.h"
#include "core/error.h"
#include "core/files/mesh_io.h"

namespace foldless {
namespace {

/// One format of the dialog.
struct Format {
  const char* title;
  std::string_view extension;
  const char* words;
};

constexpr int kMostPixelsOfASide = 16384;
constexpr int kLastPicture = 3;  // of the formats; the others are meshes

constexpr std::array<Format, 7> kFormats{{
    {"PNG picture", ".png", "The canvas as you see it. Scene, iteration and energy go along."},
    {"SVG figure", ".svg", "The canvas as lines and areas, sharp at any size, for the web."},
    {"PDF figure", ".pdf", "The canvas as lines and areas, sharp at any size, for papers."},
    {"PNG sequence", "", "Every iteration as a picture, 000001.png and on, in a new folder."},
    {"OBJ mesh", ".obj", "The deformed mesh; the rest positions are its texture coordinates."},
    {"OFF mesh", ".off", "The deformed mesh, positions and triangles alone."},
    {"PLY mesh", ".ply", "The deformed mesh, positions and triangles alone."},
}};

constexpr int kAnimation = static_cast<int>(kFormats.size());

}  // namespace

bool ExportDialog::is_animation() const { return format_ == kAnimation; }

/// While the time line is open it is about the animation.
void ExportDialog::open(const Editor& editor) {
  opens_now_ = true;
  animation_.open();
  const bool has_animation = why_no_animation(editor).empty();
  if (editor.motion().is_open() && has_animation)
    format_ = kAnimation;
  else if (is_animation() && !has_animation)
    format_ = 0;
  job_.picture.layers = exported_layers(editor);
  job_.picture.is_transparent = is_transparent_.value_or(!editor.document().texture.empty());
}

void ExportDialog::repeat(const Editor& editor) {
  if (!last_) return open(editor);
  ordered_ = last_;
}

std::optional<ExportJob> ExportDialog::take_order() { return std::exchange(ordered_, {}); }

void ExportDialog::draw(Editor& editor, UiState& state, const Look& look) {
  if (std::exchange(opens_now_, false)) ImGui::OpenPopup("##export");
  if (!begin_dialog("##export", look, ImVec2{480, 420})) return;
  title_text("Export", look);
  begin_controls("options", {0, -ImGui::GetFrameHeightWithSpacing()}, look);
  draw_options(editor, look);
  ImGui::EndChild();
  const DialogKeys keys = dialog_keys();
  if (main_button("Choose a file…", look) || keys.takes) {
    ImGui::CloseCurrentPopup();
    ask_for_file(editor, state);
  }
  ImGui::SameLine();
  if (ImGui::Button("Cancel") || keys.leaves) ImGui::CloseCurrentPopup();
  end_dialog();
}

void ExportDialog::draw_animation_row(const Editor& editor, const Look& look) {
  const std::string why_not = why_no_animation(editor);
  ImGui::BeginDisabled(!why_not.empty());
  ImGui::RadioButton("Animation", &format_, kAnimation);
  ImGui::EndDisabled();
  if (!why_not.empty()) tooltip(why_not, look);
}

void ExportDialog::draw_options(const Editor& editor, const Look& look) {
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    if (i > 0 && i != kLastPicture + 1) ImGui::SameLine();
    ImGui::RadioButton(kFormats[i].title, &format_, static_cast<int>(i));
  }
  draw_animation_row(editor, look);
  ImGui::Spacing();
  if (is_animation()) {
    bool& is_transparent = job_.picture.is_transparent;
    const bool before = is_transparent;
    animation_.draw(editor, is_transparent, look);
    if (is_transparent != before) is_transparent_ = is_transparent;
    return;
  }
  ImGui::PushTextWrapPos(0);
  dim_text(kFormats[static_cast<std::size_t>(format_)].words, look);
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  if (format_ <= kLastPicture) draw_picture_options(editor, look);
}

void ExportDialog::draw_picture_options(const Editor& editor, const Look& look) {
  const Canvas& canvas = editor.canvas();
  for (const int factor : {1, 2, 4}) {
    if (factor > 1) ImGui::SameLine();
    const std::string label = "×" + std::to_string(factor) + "  " +
                              std::to_string(canvas.width * factor) + " × " +
                              std::to_string(canvas.height * factor);
    const bool is_on = !job_.picture.size && job_.picture.factor == factor;
    if (ImGui::RadioButton(label.c_str(), is_on)) {
      job_.picture.factor = factor;
      job_.picture.size.reset();
    }
  }
  draw_free_size(editor, look);
  if (ImGui::Checkbox("Transparent background", &job_.picture.is_transparent))
    is_transparent_ = job_.picture.is_transparent;
  ImGui::Spacing();
  dim_text("Layers", look);
  if (!ImGui::BeginTable("layers", 2)) return;
  for (const LayerRow& row : kLayerRows) {
    ImGui::TableNextColumn();
    ImGui::Checkbox(row.title.data(), &(job_.picture.layers.*row.shown));
  }
  ImGui::EndTable();
}

void ExportDialog::draw_free_size(const Editor& editor, const Look& look) {
  std::array<int, 2> size = size_of_picture(editor, job_.picture);
  if (ImGui::RadioButton("Any size", job_.picture.size.has_value())) job_.picture.size = size;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(look.px(160));
  if (ImGui::InputInt2("##size", size.data())) {
    for (int& pixels : size) pixels = std::clamp(pixels, 1, kMostPixelsOfASide);
    job_.picture.size = size;
  }
  tooltip("Width and height in pixels. What the canvas shows is in the middle.", look);
}

void ExportDialog::ask_for_file(Editor& editor, UiState& state) {
  const std::string extension(is_animation()
                                  ? animation_.format().ending
                                  : kFormats[static_cast<std::size_t>(format_)].extension);
  const bool is_folder = extension.empty();
  FileRequest request;
  request.purpose = FileRequest::Purpose::save;
  request.title = is_folder ? "Export: name of a new folder" : "Export";
  if (!is_folder) request.extensions = {extension};
  const std::string folder = is_animation() ? "-frames" : "-iterations";
  request.start = suggested_export(editor, state, is_folder ? folder : extension);
  job_.animation.reset();
  if (is_animation()) job_.animation = animation_.choice(job_.picture.is_transparent);
  job_.is_sequence = is_folder && !is_animation();
  request.chosen = [this, &editor, &state](const std::filesystem::path& path) {
    remember_export(editor, state, path);
    job_.path = path;
    last_ = ordered_ = job_;
    ordered_->is_chosen_now = true;
  };
  state.browser.ask(std::move(request));
}

}  // namespace foldless
