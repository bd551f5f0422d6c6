// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/image_dialog.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/gui/dialog_keys.h"
#include "app/gui/side_dialog.h"
#include "app/gui/widgets.h"
#include "core/files/mesh_source.h"

namespace foldless {
namespace {

/// One number of the options.
struct Row {
  const char* title;
  const char* format;
  const char* tip;
  double ImageMeshOptions::*value;
  double minimum, maximum;
  bool is_logarithmic = false;
};

/// The largest lengths follow the size of the image.
std::array<Row, 5> rows_for(const AlphaMap& alpha) {
  const double side = std::sqrt(static_cast<double>(alpha.width) * alpha.height);
  using O = ImageMeshOptions;
  return {{
      {"Longest edge", "%.3g px",
       "No edge of a triangle is longer: shorter edges bend more finely.", &O::edge_length,
       std::max(1.0, side / 250), std::max(2.0, side / 4), true},
      {"Margin", "%.3g px", "How far the outline stays away from what is drawn.", &O::margin, 0,
       std::max(10.0, side / 20)},
      {"Simplification", "%.3g px", "By how much the outline may leave out details.", &O::simplify,
       0, std::max(5.0, side / 50)},
      {"Threshold", "%.2f", "How opaque a pixel must be to belong to the drawing.", &O::threshold,
       0.01, 1},
      {"Smallest angle", "%.0f°", "Of the triangles; sharp corners of the outline excepted.",
       &O::min_angle, 0, 33},
  }};
}

bool draw_row(const Row& row, ImageMeshOptions& options, const Look& look) {
  double& value = options.*row.value;
  ImGui::TextUnformatted(row.title);
  ImGui::SetNextItemWidth(-1);
  ImGui::PushID(row.title);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, ImVec4{0, 0, 0, 0});
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, ImVec4{0, 0, 0, 0});
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_AlwaysClamp | (row.is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  const bool changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &row.minimum,
                                           &row.maximum, row.format, flags);
  ImGui::PopStyleColor(2);
  ImGui::PopID();
  const double low = row.is_logarithmic ? std::log(row.minimum) : row.minimum;
  const double high = row.is_logarithmic ? std::log(row.maximum) : row.maximum;
  slider_line(((row.is_logarithmic ? std::log(value) : value) - low) / (high - low), look);
  tooltip(std::string(row.tip) + " Ctrl-click to type a number.", look);
  return changed;
}

void draw_presets(const ImportedImage& image, ImageMeshOptions& options) {
  constexpr std::array kTitles{"Coarse", "Medium", "Fine"};
  for (std::size_t i = 0; i < kTitles.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    if (ImGui::RadioButton(kTitles[i], options == image.presets[i])) options = image.presets[i];
  }
}

void draw_layer_choice(ImageImport& import) {
  if (!import.image()->has_layers()) return;
  bool is_by_layer = import.is_by_layer();
  if (ImGui::RadioButton("Layer by layer", is_by_layer)) is_by_layer = true;
  ImGui::SameLine();
  if (ImGui::RadioButton("One picture", !is_by_layer)) is_by_layer = false;
  import.set_by_layer(is_by_layer);
}

void draw_options(Editor& editor, const Look& look) {
  ImageImport& import = editor.files().image_import();
  if (!import.image()) return dim_text("Reading the image…", look);
  const AlphaMap& alpha = import.image()->alpha;
  dim_text(std::to_string(alpha.width) + " × " + std::to_string(alpha.height) + " pixels", look);
  ImGui::Spacing();
  draw_layer_choice(import);
  ImGui::Spacing();
  ImageMeshOptions options = import.options();
  draw_presets(*import.image(), options);
  ImGui::Spacing();
  for (const Row& row : rows_for(alpha)) draw_row(row, options, look);
  import.set_options(options);
}

std::string angle_words(double angle) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "smallest angle %.1f°", angle);
  return text.data();
}

std::string count(int number, const char* noun) {
  return counted(static_cast<std::size_t>(number), noun);
}

void draw_notice(const std::string& notice, const Look& look) {
  ImGui::PushTextWrapPos();
  dim_text(notice, look);
  ImGui::PopTextWrapPos();
}

/// What became of the layers.
void draw_layers(const ImageImport& import, const Look& look) {
  const ImportedMesh& mesh = *import.mesh();
  if (import.image()->has_layers() && !mesh.document.parts) return;
  if (mesh.document.parts)
    dim_text(count(static_cast<int>(mesh.document.parts->size()), "layer"), look);
  for (const std::string& notice : import.image()->notices) draw_notice(notice, look);
  for (const std::string& name : mesh.left_out)
    draw_notice("Nothing of the layer '" + name + "' is opaque enough", look);
}

void draw_result(const ImageImport& import, const Look& look) {
  if (!import.problem().empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, look.palette->warning);
    ImGui::TextWrapped("%s", import.problem().c_str());
    ImGui::PopStyleColor();
    return;
  }
  if (!import.mesh()) return;
  const ImageMesh& mesh = import.mesh()->mesh;
  dim_text(count(static_cast<int>(mesh.shape.rest.cols()), "vertex") + ", " +
               count(static_cast<int>(mesh.shape.triangles.cols()), "triangle"),
           look);
  dim_text(count(mesh.parts, "part") + ", " + count(mesh.holes, "hole") + ", " +
               angle_words(mesh.min_angle),
           look);
  draw_layers(import, look);
  if (mesh.specks > 0) dim_text(count(mesh.specks, "speck") + " left out", look);
  if (mesh.filled_holes > 0) dim_text(count(mesh.filled_holes, "tiny hole") + " filled", look);
}

void draw_buttons(Editor& editor, const Look& look) {
  const bool has_problem = !editor.files().image_import().problem().empty();
  ImGui::BeginDisabled(has_problem);
  const bool takes = main_button("Make the mesh", look);
  ImGui::EndDisabled();
  ImGui::SameLine();
  const bool leaves = ImGui::Button("Cancel");
  const DialogKeys keys = dialog_keys();
  if (takes || (!has_problem && keys.takes)) return editor.files().take_image();
  if (leaves || keys.leaves) editor.files().close_import();
}

}  // namespace

void draw_image_dialog(Editor& editor, const PanelContext& context) {
  const DocumentFiles& files = editor.files();
  const bool is_open =
      files.image_import().is_open() && !files.recovery().is_open() && !files.question();
  if (!begin_side_dialog("##image", is_open, context)) return;
  const Look& look = context.look;
  title_text("New from an image", look);
  // In a low window the options scroll, the buttons stay.
  begin_controls("options", {0, -ImGui::GetFrameHeightWithSpacing()}, look);
  dim_text(editor.files().image_import().file().filename().string(), look);
  draw_options(editor, look);
  ImGui::Spacing();
  draw_result(editor.files().image_import(), look);
  ImGui::EndChild();
  if (is_open) draw_buttons(editor, look);
  end_side_dialog();
}

}  // namespace foldless
