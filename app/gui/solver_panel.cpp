// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/gui/choice_list.h"
#include "app/gui/panels.h"
#include "app/gui/plot.h"
#include "app/gui/widgets.h"
#include "core/energy/densities.h"
#include "core/method/methods.h"

namespace foldless {
namespace {

/// ImGui takes the smallest step of a logarithmic slider from the digits of its format.
constexpr const char* kExactFormat = "%.16g";

/// 0.012, 5·10⁷.
std::string number_words(double value) {
  std::array<char, 32> text{};
  const double exponent = value == 0 ? 0 : std::floor(std::log10(std::abs(value)) + 1e-9);
  if (exponent >= -3 && exponent <= 5) {
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
  }
  const double mantissa = value / std::pow(10.0, exponent);
  std::string power = power_of_ten(static_cast<int>(exponent));
  if (std::abs(mantissa - 1) < 1e-6) return power;
  std::snprintf(text.data(), text.size(), "%.3g·", mantissa);
  return text.data() + power;
}

/// Two digits suffice for what a slider was dragged to; what was typed stays as it is.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1);
  return std::round(value / unit) * unit;
}

double slider_position(const ParameterRow& row, double value) {
  if (row.scale == ParameterScale::linear)
    return (value - row.minimum) / (row.maximum - row.minimum);
  return std::log(value / row.minimum) / std::log(row.maximum / row.minimum);
}

/// A slider that shows its number in words, but exactly while one types.
bool draw_slider(const ParameterRow& row, double& value, const Look& look) {
  bool& is_typing = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("typing"), false);
  const bool shows_words = !is_typing;
  const ImVec4 invisible{0, 0, 0, 0};
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, invisible);
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, invisible);
  if (shows_words) ImGui::PushStyleColor(ImGuiCol_Text, invisible);
  ImGuiSliderFlags flags = ImGuiSliderFlags_NoRoundToFormat | ImGuiSliderFlags_AlwaysClamp;
  if (row.scale != ParameterScale::linear) flags |= ImGuiSliderFlags_Logarithmic;
  const bool changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &row.minimum,
                                           &row.maximum, kExactFormat, flags);
  ImGui::PopStyleColor(shows_words ? 3 : 2);
  is_typing = ImGui::IsItemActive() && ImGui::GetIO().WantTextInput;
  if (changed && shows_words && value != 0) value = rounded(value);
  if (row.scale == ParameterScale::whole) value = std::round(value);
  if (!shows_words) return changed;
  slider_line(slider_position(row, value), look);
  const std::string words = number_words(value);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  ImGui::GetWindowDrawList()->AddText(
      {(low.x + high.x - size.x) / 2, (low.y + high.y - size.y) / 2 - look.px(1)},
      ImGui::GetColorU32(ImGuiCol_Text), words.c_str());
  return changed;
}

void draw_choice(const ParameterRow& row, double value, Editor& editor) {
  const auto current = static_cast<std::size_t>(value);
  if (!begin_combo("##value", row.choices[current].data())) return;
  for (std::size_t k = 0; k < row.choices.size(); ++k)
    if (choice_entry(row.choices[k].data(), k == current))
      editor.edits().set_parameter(row, static_cast<double>(k));
  ImGui::EndCombo();
}

void draw_value(const ParameterRow& row, Editor& editor, float width, const Look& look) {
  const Document& document = editor.document();
  double value = row.get(document.parameters, *document.energy);
  if (row.scale == ParameterScale::on_off) {
    bool on = value != 0;
    if (ImGui::Checkbox("##value", &on)) editor.edits().set_parameter(row, on ? 1 : 0);
    return;
  }
  ImGui::SetNextItemWidth(width);
  if (row.scale == ParameterScale::choice) return draw_choice(row, value, editor);
  if (draw_slider(row, value, look)) editor.edits().set_parameter(row, value);
}

std::string tooltip_words(const ParameterRow& row, const Parameters& parameters,
                          const Density& energy) {
  std::string words = std::string(row.tooltip) + "\nDefault ";
  if (row.scale == ParameterScale::on_off) {
    words += default_of(row, parameters, energy) != 0 ? "on." : "off.";
    return words;
  }
  if (row.scale == ParameterScale::choice)
    return words +
           std::string(row.choices[static_cast<std::size_t>(default_of(row, parameters, energy))]) +
           ".";
  return words + number_words(default_of(row, parameters, energy)) + ", from " +
         number_words(row.minimum) + " to " + number_words(row.maximum) +
         ". Ctrl-click to type a number.";
}

void draw_parameter(const ParameterRow& row, Editor& editor, const Look& look) {
  const Document& document = editor.document();
  const bool changed = is_changed(row, document.parameters, *document.energy);
  const std::string words = tooltip_words(row, document.parameters, *document.energy);
  ImGui::PushID(row.name.data());
  ImGui::TableNextColumn();
  label_of_choice(row.title, changed, look);
  tooltip(words, look);
  ImGui::TableNextColumn();
  const float side = ImGui::GetFrameHeight();
  const ImVec2 cell = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  draw_value(row, editor, width - side - look.px(3), look);
  tooltip(words, look);
  if (changed) {
    ImGui::SameLine();
    ImGui::SetCursorScreenPos({cell.x + width - side, cell.y});
    if (icon_button({"reset", Icon::reset, "Back to the default"}, look))
      editor.edits().reset_parameter(row);
  }
  ImGui::PopID();
}

void draw_method_choice(Editor& editor, const Look& look) {
  const MethodRow* current = find_method(editor.document().parameters.method);
  ImGui::SetNextItemWidth(-1);
  if (begin_combo("##method", current ? current->title.data() : "Unknown method")) {
    for (const MethodRow& row : methods())
      if (choice_entry(row.title.data(), &row == current)) editor.edits().set_method(row.name);
    ImGui::EndCombo();
  }
  tooltip("The method that moves the vertices and changes the mesh.", look);
}

void draw_energy_choice(Editor& editor, const Look& look) {
  const Density* current = editor.document().energy;
  ImGui::SetNextItemWidth(-1);
  if (begin_combo("##energy", current->title.data())) {
    for (const Density& row : densities())
      if (choice_entry(row.title.data(), &row == current)) editor.edits().set_energy(row);
    ImGui::EndCombo();
  }
  tooltip("The energy: what counts as distortion of a triangle.", look);
}

void draw_choices(Editor& editor, const Look& look) {
  if (!ImGui::BeginTable("choices", 2)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, look.px(56));
  ImGui::TableSetupColumn("choice", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Method");
  ImGui::TableNextColumn();
  draw_method_choice(editor, look);
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Energy");
  ImGui::TableNextColumn();
  draw_energy_choice(editor, look);
  ImGui::EndTable();
}

}  // namespace

void draw_solver_panel(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  draw_choices(editor, look);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{look.px(5), look.px(1.5F)});
  if (ImGui::BeginTable("parameters", 2)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, look.px(134));
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    const MethodRow* method = find_method(editor.document().parameters.method);
    for (const ParameterRow& row : parameter_rows())
      if (!method || reads(*method, row.name)) draw_parameter(row, editor, look);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

}  // namespace foldless
