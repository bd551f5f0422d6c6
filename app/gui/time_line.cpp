// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/time_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/editor/handle_view.h"
#include "app/gui/panels.h"
#include "app/gui/short_text.h"
#include "app/gui/time_line_input.h"
#include "app/gui/time_line_place.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr std::array kPropertyWords{"position", "angle", "depth", "weight"};  // as KeyedProperty

std::string row_words(const Editor& editor, const TimeLineRow& row) {
  const Handle* handle = find_handle(editor.document(), row.handle);
  const std::string name = handle ? handle_title(handle->name, handle->vertex) : "";
  return name + " " + kPropertyWords[static_cast<std::size_t>(row.property)];
}

/// Steps between the numbers of the ruler: 1, 2 or 5 times a power of ten, with room for them.
int ruler_step(const TimeLinePlace& place, float room) {
  int step = 1;
  for (int k = 0; place.width() * static_cast<float>(step / place.shown) < room; ++k)
    step = k % 3 == 1 ? step / 2 * 5 : step * 2;
  return step;
}

/// Draws one part after the other, all of one time line.
class TimeLineDrawing {
 public:
  TimeLineDrawing(Editor& editor, const PanelContext& context, const TimeLinePlace& place)
      : editor_(editor),
        look_(context.look),
        place_(place),
        gesture_(context.state.time_line.gesture),
        list_(*ImGui::GetWindowDrawList()),
        rows_(time_line_rows(editor.motion().animation())) {}

  void draw() {
    draw_ruler();
    draw_states();
    draw_labels();
    draw_keys();
    draw_play_head();
    draw_sight();
    if (gesture_.kind == TimeLineGesture::Kind::band) draw_band();
    if (rows_.empty()) draw_hint();
  }

 private:
  float bottom() const { return place_.area.y + place_.area.height; }

  void draw_ruler() {
    const int step = ruler_step(place_, look_.px(44));
    const float y = place_.area.y;
    const float play_head = place_.x_of(editor_.motion().play_head().moment());
    for (int frame = 0; frame <= place_.last; frame += step) {
      if (!place_.is_in_sight(frame)) continue;
      const float x = place_.x_of(frame);
      list_.AddLine({x, y + place_.ruler * 0.6F}, {x, bottom()}, packed(look_.palette->dim, 0.35F));
      const std::string words = std::to_string(frame);
      const ImVec2 size = ImGui::CalcTextSize(words.c_str());
      if (std::abs(x - play_head) > size.x + look_.px(8))
        list_.AddText({x - size.x / 2, y}, packed(look_.palette->dim), words.c_str());
    }
  }

  /// A line under the ruler: thick where a frame is solved, a triangle where it is not at its
  /// targets, nothing where it is not ready.
  void draw_states() {
    const MotionFrames& frames = editor_.motion().frames();
    const FramesStatus status = frames.status();
    const float y = place_.area.y + place_.ruler - look_.px(3);
    const float half = std::max(1.0F, place_.width() / static_cast<float>(place_.shown) / 2);
    const ImU32 good = packed(look_.palette->good, status.is_done ? 1.0F : 0.6F);
    for (int f = 0; f < static_cast<int>(status.solved); ++f) {
      if (!place_.is_in_sight(f)) continue;
      const auto frame = frames.frame(f);
      const float x = place_.x_of(f), r = look_.px(4);
      const float from = std::max(x - half, place_.left());
      const float to = std::min(x + half, place_.left() + place_.width());
      if (frame && frame->is_satisfied)
        list_.AddRectFilled({from, y - look_.px(1)}, {to, y + look_.px(1)}, good);
      else
        list_.AddTriangleFilled({x - r, y + r * 0.7F}, {x + r, y + r * 0.7F}, {x, y - r},
                                packed(look_.palette->warning));
    }
  }

  void draw_labels() {
    const auto label = [&](const std::string& words, float y, bool is_lit) {
      const float room = place_.labels - look_.px(12);
      list_.AddText({place_.area.x + look_.px(8), y - ImGui::GetTextLineHeight() / 2},
                    packed(is_lit ? look_.palette->text : look_.palette->dim),
                    elided(words, room).c_str());
    };
    label("All keys", place_.y_of_all(), false);
    for (int i = place_.first_row; i < last_row(); ++i) {
      const TimeLineRow& row = rows_[static_cast<std::size_t>(i)];
      label(row_words(editor_, row), place_.y_of(i),
            editor_.selection().ids().contains(row.handle));
    }
  }

  int last_row() const {
    return std::min(static_cast<int>(rows_.size()), place_.first_row + place_.rows_in_sight());
  }

  void diamond(float x, float y, bool is_selected) {
    const float r = look_.px(5);
    const ImVec2 a{x, y - r}, b{x + r, y}, c{x, y + r}, d{x - r, y};
    list_.AddQuadFilled(a, b, c, d,
                        packed(is_selected ? look_.palette->accent : look_.palette->bar));
    list_.AddQuad(a, b, c, d, packed(is_selected ? look_.palette->text : look_.palette->dim),
                  look_.px(1.4F));
  }

  void draw_keys() {
    const Motion& motion = editor_.motion();
    const Keys keys = keys_of(motion.animation());
    const auto to = pulled_frame(gesture_, place_);
    // Those that are pulled are drawn where they would come to, over the others.
    for (const bool is_selected : {false, true})
      for (const KeyPlace& key : keys) {
        if (motion.keys().selected().contains(key) != is_selected) continue;
        const int frame = is_selected && to ? to(key.frame) : key.frame;
        if (!place_.is_in_sight(frame)) continue;
        const float x = place_.x_of(frame);
        diamond(x, place_.y_of_all(), is_selected);
        const auto row = std::ranges::find_if(rows_, [&](const TimeLineRow& r) {
          return r.handle == key.handle && r.property == key.property;
        });
        const int index = static_cast<int>(row - rows_.begin());
        if (index >= place_.first_row && index < last_row())
          diamond(x, place_.y_of(index), is_selected);
      }
  }

  /// What part of the frames is in sight, where it is not all.
  void draw_sight() {
    if (place_.shown >= place_.last) return;
    const float left = place_.left(), width = place_.width(), y = bottom() - look_.px(3);
    const auto at = [&](double frame) {
      return left + width * static_cast<float>(frame / place_.last);
    };
    list_.AddLine({left, y}, {left + width, y}, packed(look_.palette->dim, 0.3F), look_.px(2));
    list_.AddLine({at(place_.first), y}, {at(place_.first + place_.shown), y},
                  packed(look_.palette->dim), look_.px(3));
  }

  void draw_play_head() {
    if (!place_.is_in_sight(editor_.motion().play_head().moment())) return;
    const float x = place_.x_of(editor_.motion().play_head().moment());
    const ImU32 colour = packed(look_.palette->accent);
    list_.AddLine({x, place_.area.y}, {x, bottom()}, colour, look_.px(1.6F));
    const std::string words = moment_words(editor_.motion().play_head().moment());
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float half = size.x / 2 + look_.px(4);
    list_.AddRectFilled({x - half, place_.area.y}, {x + half, place_.area.y + size.y}, colour,
                        look_.px(3));
    list_.AddText({x - size.x / 2, place_.area.y}, packed(look_.palette->on_accent), words.c_str());
  }

  void draw_band() {
    const ImVec2 end = ImGui::GetIO().MousePos;
    list_.AddRectFilled(gesture_.start, end, packed(look_.palette->accent, 0.15F));
    list_.AddRect(gesture_.start, end, packed(look_.palette->accent));
  }

  void draw_hint() {
    const float y = place_.y_of(0) - ImGui::GetTextLineHeight() / 2;
    const std::string words =
        "Put the play head where a pose should be, then move handles: they get keys.";
    list_.AddText({place_.left(), y}, packed(look_.palette->dim),
                  elided(words, place_.width()).c_str());
  }

  Editor& editor_;
  const Look& look_;
  const TimeLinePlace& place_;
  const TimeLineGesture& gesture_;
  ImDrawList& list_;
  std::vector<TimeLineRow> rows_;
};

constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace

void draw_time_line(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  TimeLineState& state = context.state.time_line;
  const TimeLinePlace place = time_line_place(context.layout.timeline, look.scale,
                                              editor.motion().animation().cycle, state.view);
  if (place.area.height < 2 * place.row) return;  // It was opened after the layout was made.
  ImGui::SetNextWindowPos({place.area.x, place.area.y});
  ImGui::SetNextWindowSize({place.area.width, place.area.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
  ImGui::PushFont(look.fonts.small);
  const bool is_in_sight = ImGui::Begin("##keys", nullptr, kFlags);
  ImGui::PopStyleVar(2);
  if (is_in_sight) {
    ImGui::InvisibleButton("##time line", {place.area.width, place.area.height},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    handle_time_line(editor, state, place);
    TimeLineDrawing(editor, context, place).draw();
  }
  ImGui::End();
  ImGui::PopFont();
}

}  // namespace foldless
