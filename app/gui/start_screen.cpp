// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/start_screen.h"

#include <imgui_internal.h>

#include <algorithm>
#include <functional>
#include <string>

#include "app/gui/short_text.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr float kCardWidth = 196, kPictureHeight = 120, kGap = 14;  // design pixels
constexpr std::size_t kMostRecent = 8;

struct Card {
  std::filesystem::path file;
  std::string title;
  std::string words;  ///< one line, the rest in the tooltip
  std::string tip;
};

/// Where words are, and in how many lines at most.
struct Lines {
  ImVec2 corner;
  float width;
  int count;
};

/// The last line has what is left, shortened where it has no room.
void draw_lines(const std::string& words, const Lines& place) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float height = ImGui::GetFontSize();
  const char* begin = words.c_str();
  const char* const end = begin + words.size();
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
  for (int line = 0; line < place.count && begin < end; ++line) {
    const ImVec2 at{place.corner.x, place.corner.y + height * static_cast<float>(line)};
    const char* next = ImGui::GetFont()->CalcWordWrapPositionA(1, begin, end, place.width);
    if (line + 1 < place.count && next > begin) {
      list.AddText(at, colour, begin, next);
      begin = next + (next < end && *next == ' ' ? 1 : 0);
    } else {
      return list.AddText(at, colour, shortened(begin, place.width).c_str());
    }
  }
}

void draw_words(const std::string& words, const Lines& place, ImFont* font, const ImVec4& colour) {
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  draw_lines(words, place);
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

/// A button with a picture, a title and a line; true when it is pressed.
bool draw_card(const Card& card, Thumbnails& thumbnails, const Look& look) {
  const ImVec2 size{look.px(kCardWidth), look.px(kPictureHeight + 60)};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(card.file.c_str());
  const bool is_pressed = ImGui::InvisibleButton("##card", size);
  ImGui::PopID();
  const bool is_hovered = ImGui::IsItemHovered() || ImGui::IsItemFocused();
  tooltip(card.tip, look);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  const ImVec2 picture_end{end.x, corner.y + look.px(kPictureHeight)};
  const float rounding = look.px(6);
  list.AddRectFilled(corner, end, packed(look.palette->popup), rounding);
  if (const ImTextureID picture = thumbnails.of(card.file))
    list.AddImageRounded(picture, corner, picture_end, {0, 0}, {1, 1}, IM_COL32_WHITE, rounding,
                         ImDrawFlags_RoundCornersTop);
  list.AddRect(corner, end, packed(is_hovered ? look.palette->accent : look.palette->border),
               rounding, 0, look.px(is_hovered ? 2 : 1));
  const float left = corner.x + look.px(9), width = size.x - look.px(18);
  const float top = picture_end.y + look.px(6), middle = top + look.px(18);
  draw_words(card.title, {{left, top}, width, 1}, look.fonts.text, look.palette->text);
  draw_words(card.words, {{left, middle}, width, 2}, look.fonts.small, look.palette->dim);
  return is_pressed;
}

/// In rows as wide as the window.
void draw_cards(const std::vector<Card>& cards, Thumbnails& thumbnails, const Look& look,
                const std::function<void(const std::filesystem::path&)>& open) {
  const float step = look.px(kCardWidth + kGap);
  const float room = ImGui::GetContentRegionAvail().x + look.px(kGap);
  const int columns = std::max(1, static_cast<int>(room / step));
  const ImVec2 corner = ImGui::GetCursorPos();
  const float height = look.px(kPictureHeight + 60 + kGap);
  for (std::size_t i = 0; i < cards.size(); ++i) {
    const int index = static_cast<int>(i), column = index % columns, row = index / columns;
    ImGui::SetCursorPos({corner.x + static_cast<float>(column) * step,
                         corner.y + static_cast<float>(row) * height});
    if (draw_card(cards[i], thumbnails, look)) return open(cards[i].file);
  }
  ImGui::NewLine();
}

void heading(const char* words, const Look& look) {
  ImGui::Dummy({0, look.px(8)});
  ImGui::PushFont(look.fonts.bold);
  ImGui::TextUnformatted(words);
  ImGui::PopFont();
  ImGui::Dummy({0, look.px(2)});
}

void draw_welcome(Editor& editor, const Look& look) {
  ImGui::PushFont(look.fonts.title);
  ImGui::TextUnformatted("Bend anything. Nothing folds.");
  ImGui::PopFont();
  ImGui::Dummy({0, look.px(4)});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, look.px(74)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                     packed(look.palette->accent, 0.07F), look.px(8));
  list.AddRect(corner, {corner.x + size.x, corner.y + size.y}, packed(look.palette->accent, 0.6F),
               look.px(8), 0, look.px(1.2F));
  ImGui::SetCursorScreenPos({corner.x + look.px(16), corner.y + look.px(25)});
  if (main_button("Open…", look)) editor.run_command("file.open");
  ImGui::SameLine(0, look.px(14));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("or drop a drawing, a mesh or a scene here");
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy(size);
}

std::vector<Card> recent_cards(const Editor& editor) {
  std::vector<Card> cards;
  for (const auto& path : editor.files().recent()) {
    std::error_code ignored;
    if (cards.size() == kMostRecent || !std::filesystem::exists(path, ignored)) continue;
    cards.push_back({path, path.filename().string(), path.parent_path().string(), path.string()});
  }
  return cards;
}

std::vector<Card> sample_cards(const UiState& state) {
  std::vector<Card> cards;
  for (const Sample& sample : state.samples)
    cards.push_back({sample.path, sample.title, sample.description, sample.description});
  return cards;
}

}  // namespace

void draw_start_screen(Editor& editor, Thumbnails& thumbnails, const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle& canvas = context.layout.canvas;
  thumbnails.set_look(static_cast<int>(look.px(kCardWidth)),
                      static_cast<int>(look.px(kPictureHeight)), context.state.settings.theme);
  const float width = std::min(canvas.width, look.px(5 * kCardWidth + 4 * kGap + 60));
  ImGui::SetNextWindowPos({canvas.x + (canvas.width - width) / 2, canvas.y});
  ImGui::SetNextWindowSize({width, canvas.height});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4{0, 0, 0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(24), look.px(24)});
  if (ImGui::Begin("##start", nullptr,
                   ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus)) {
    draw_welcome(editor, look);
    const auto recent = recent_cards(editor);
    if (!recent.empty()) {
      heading("Recent", look);
      draw_cards(recent, thumbnails, look, [&](const auto& file) { editor.files().open(file); });
    }
    heading("Samples", look);
    draw_cards(sample_cards(context.state), thumbnails, look,
               [&](const auto& file) { editor.files().open_sample(file); });
  }
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

}  // namespace foldless
