// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/drawing_defects.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <span>
#include <sstream>
#include <utility>

namespace foldless::test {
namespace {

constexpr float kLine = 4;       ///< pixels: no shape is thinner
constexpr float kFringe = 1.5F;  ///< pixels: smoothed borders lie a little outside of their shape

/// A rectangle in pixels, y down.
struct Extents {
  ImVec2 low{1e9F, 1e9F}, high{-1e9F, -1e9F};

  void take(const ImVec2& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool is_empty() const { return low.x >= high.x || low.y >= high.y; }
};

Extents intersection(const Extents& a, const Extents& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

std::ostream& operator<<(std::ostream& out, const Extents& e) {
  return out << "(" << std::lround(e.low.x) << ", " << std::lround(e.low.y) << ") to ("
             << std::lround(e.high.x) << ", " << std::lround(e.high.y) << ")";
}

/// A line of text or a part of one, as it is drawn.
struct Words {
  std::string text;
  ImU32 colour = 0;
  float top = 0;  ///< of the line
  Extents whole;  ///< with what the clip rectangle takes away
  Extents seen;
  bool is_cut = false;
};

/// The characters of the atlas by their places in it.
class GlyphPlaces {
 public:
  explicit GlyphPlaces(const ImFontAtlas& atlas) : atlas_(atlas) {
    for (const ImFont* font : atlas.Fonts)
      for (const ImFontGlyph& glyph : font->Glyphs) by_row_[glyph.V0].emplace(glyph.U0, &glyph);
  }

  /// The one that a part of the atlas is taken from, or null.
  const ImFontGlyph* find(const ImVec2& low, const ImVec2& high) const {
    for (auto row = by_row_.upper_bound(low.y); row != by_row_.begin();) {
      --row;
      auto glyph = row->second.upper_bound(low.x);
      if (glyph == row->second.begin()) continue;
      const ImFontGlyph& found = *std::prev(glyph)->second;
      if (high.x <= found.U1 && high.y <= found.V1) return &found;
    }
    return nullptr;
  }
  ImTextureID texture() const { return atlas_.TexID; }

 private:
  const ImFontAtlas& atlas_;
  std::map<float, std::map<float, const ImFontGlyph*>> by_row_;
};

void append_utf8(std::string& text, unsigned character) {
  char bytes[5];
  text += ImTextCharToUtf8(bytes, character);
}

/// What one window draws, command by command.
class WindowReader {
 public:
  WindowReader(const ImDrawList& list, const ImGuiWindow& window, const GlyphPlaces& glyphs,
               std::vector<std::string>& defects)
      : list_(list), window_(window), glyphs_(glyphs), defects_(defects) {}

  const std::vector<Words>& read() {
    for (const ImDrawCmd& command : list_.CmdBuffer) read(command);
    for (const Words& words : words_)
      if (words.is_cut) complain_of(words);
    return words_;
  }

 private:
  const ImDrawVert& vertex(const ImDrawCmd& command, unsigned i) const {
    const ImDrawIdx index = list_.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
    return list_.VtxBuffer[static_cast<int>(command.VtxOffset + index)];
  }

  void read(const ImDrawCmd& command) {
    words_before_ = words_.size();
    const Extents clip{{command.ClipRect.x, command.ClipRect.y},
                       {command.ClipRect.z, command.ClipRect.w}};
    if (clip.is_empty()) return;
    std::vector<std::pair<unsigned, Extents>> shapes;  // triangles in a row with common vertices
    unsigned highest = 0;
    for (unsigned i = 0; i + 2 < command.ElemCount;) {
      if (i + 5 < command.ElemCount && command.GetTexID() == glyphs_.texture() &&
          take_glyph(command, i, clip)) {
        i += 6;
        continue;
      }
      const ImDrawIdx* index = &list_.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
      const auto [least, most] = std::minmax({index[0], index[1], index[2]});
      if (shapes.empty() || least > highest) shapes.emplace_back(i, Extents{});
      highest = std::max<unsigned>(highest, most);
      for (unsigned k = 0; k < 3; ++k) shapes.back().second.take(vertex(command, i + k).pos);
      i += 3;
    }
    for (const auto& [first, shape] : shapes) check_shape(shape, clip);
  }

  /// Two triangles that show a part of the atlas which is neither a point nor a line of it.
  bool take_glyph(const ImDrawCmd& command, unsigned i, const Extents& clip) {
    const ImDrawVert& a = vertex(command, i);
    const ImDrawVert& c = vertex(command, i + 2);
    if (vertex(command, i + 3).pos.x != a.pos.x || vertex(command, i + 4).pos.x != c.pos.x)
      return false;
    if (a.uv.x == c.uv.x || a.uv.y == c.uv.y) return false;
    const ImFontGlyph* glyph = glyphs_.find(a.uv, c.uv);
    if (!glyph) return false;
    const float left_out = (a.uv.y - glyph->V0) / (glyph->V1 - glyph->V0);
    const float top = a.pos.y - glyph->Y0 - left_out * (glyph->Y1 - glyph->Y0);
    const Extents quad{a.pos, c.pos};
    const Extents seen = intersection(quad, clip);
    if (seen.is_empty()) {
      if (goes_on(quad, top, a.col) && is_cut(quad, clip)) words_.back().is_cut = true;
      return true;
    }
    if (!goes_on(quad, top, a.col))
      words_.push_back(
          {.text = {}, .colour = a.col, .top = top, .whole = {}, .seen = {}, .is_cut = false});
    Words& words = words_.back();
    append_utf8(words.text, glyph->Codepoint);
    if (is_cut(*glyph, a.uv, c.uv) || is_cut(quad, clip)) words.is_cut = true;
    for (const ImVec2& p : {quad.low, quad.high}) words.whole.take(p);
    for (const ImVec2& p : {seen.low, seen.high}) words.seen.take(p);
    return true;
  }

  /// The next character of the same line, which one command draws.
  bool goes_on(const Extents& quad, float top, ImU32 colour) const {
    if (words_.size() == words_before_) return false;
    const Words& words = words_.back();
    const float space = std::max(8.0F, words.whole.high.y - words.whole.low.y);
    return words.colour == colour && std::abs(words.top - top) < 2 &&
           quad.low.x > words.whole.high.x - 3 && quad.low.x < words.whole.high.x + space;
  }

  /// By more than smoothing, in a direction in which the window does not scroll.
  bool is_cut(const Extents& shape, const Extents& clip) const {
    const bool across = shape.low.x < clip.low.x - kFringe || shape.high.x > clip.high.x + kFringe;
    const bool down = shape.low.y < clip.low.y - kFringe || shape.high.y > clip.high.y + kFringe;
    return (across && !scrolls(&ImVec2::x)) || (down && !scrolls(&ImVec2::y));
  }

  /// The same where a part of it was not drawn at all.
  bool is_cut(const ImFontGlyph& glyph, const ImVec2& low, const ImVec2& high) const {
    const float across = 1 - (high.x - low.x) / (glyph.U1 - glyph.U0);
    const float down = 1 - (high.y - low.y) / (glyph.V1 - glyph.V0);
    return (across * (glyph.X1 - glyph.X0) > kFringe && !scrolls(&ImVec2::x)) ||
           (down * (glyph.Y1 - glyph.Y0) > kFringe && !scrolls(&ImVec2::y));
  }

  /// It, or what it is a part of.
  bool scrolls(float ImVec2::*along) const {
    const ImGuiWindow* window = &window_;
    while (window->ScrollMax.*along <= 0 && (window->Flags & ImGuiWindowFlags_ChildWindow))
      window = window->ParentWindow;
    return window->ScrollMax.*along > 0;
  }

  void check_shape(const Extents& shape, const Extents& clip) {
    if (intersection(shape, clip).is_empty() || !is_cut(shape, clip)) return;
    const bool is_line_across = shape.high.y - shape.low.y < kLine && shape.low.x < clip.low.x &&
                                shape.high.x > clip.high.x;
    if (is_line_across) return;  // a separator
    std::ostringstream words;
    words << "a shape " << shape << " is cut by " << clip;
    complain(words.str());
  }

  void complain_of(const Words& words) {
    std::ostringstream out;
    out << "the text \"" << words.text << "\" at " << words.whole << " is cut";
    complain(out.str());
  }

  void complain(const std::string& what) {
    std::ostringstream words;
    words << window_.Name << ": " << what;
    defects_.push_back(words.str());
  }

  const ImDrawList& list_;
  const ImGuiWindow& window_;
  const GlyphPlaces& glyphs_;
  std::vector<std::string>& defects_;
  std::vector<Words> words_;
  std::size_t words_before_ = 0;  ///< of earlier commands
};

/// Popups, dialogs, messages: all but the panels, which never come to the front.
bool covers_others(const ImGuiWindow& window) {
  return (window.Flags & ImGuiWindowFlags_NoBringToFrontOnFocus) == 0;
}

/// Texts that are seen together: those of one popup or dialog, or of everything else.
using Sheet = std::vector<std::pair<const ImGuiWindow*, Words>>;

void find_overlaps(const Sheet& sheet, std::vector<std::string>& defects) {
  for (std::size_t i = 0; i < sheet.size(); ++i)
    for (std::size_t k = i + 1; k < sheet.size(); ++k) {
      const Extents common = intersection(sheet[i].second.seen, sheet[k].second.seen);
      if (common.high.x - common.low.x <= 1 || common.high.y - common.low.y <= 1) continue;
      std::ostringstream words;
      words << sheet[i].first->Name << ": the text \"" << sheet[i].second.text << "\" lies over \""
            << sheet[k].second.text << "\" of " << sheet[k].first->Name;
      defects.push_back(words.str());
    }
}

/// All texts in the order in which they were drawn.
Sheet read_windows(std::vector<std::string>& defects) {
  Sheet texts;
  const GlyphPlaces glyphs(*ImGui::GetIO().Fonts);
  const ImDrawData& data = *ImGui::GetDrawData();
  for (const ImDrawList* list :
       std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount))) {
    const ImGuiWindow* window =
        list->_OwnerName ? ImGui::FindWindowByName(list->_OwnerName) : nullptr;
    if (!window || window->DrawList != list) continue;  // the canvas: pictures, not panels
    WindowReader reader(*list, *window, glyphs, defects);
    for (const Words& words : reader.read()) texts.emplace_back(window, words);
  }
  return texts;
}

}  // namespace

std::vector<std::string> drawing_defects() {
  std::vector<std::string> defects;
  std::map<const ImGuiWindow*, Sheet> sheets;
  for (const auto& text : read_windows(defects)) {
    const ImGuiWindow* root = text.first->RootWindow;
    sheets[covers_others(*root) ? root : nullptr].push_back(text);
  }
  for (const auto& [root, sheet] : sheets) find_overlaps(sheet, defects);
  return defects;
}

std::optional<ImVec2> place_of_words(const std::string& words) {
  std::string wanted = words;
  std::erase(wanted, ' ');  // blanks are not drawn
  std::vector<std::string> ignored;
  std::optional<ImVec2> place;
  for (const auto& [window, text] : read_windows(ignored))
    if (text.text == wanted)
      place = {(text.seen.low.x + text.seen.high.x) / 2, (text.seen.low.y + text.seen.high.y) / 2};
  return place;
}

}  // namespace foldless::test
