// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/time_line_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/editor.h"
#include "app/gui/command_item.h"

namespace foldless {
namespace {

using Kind = TimeLineGesture::Kind;
constexpr const char* kMenu = "##keys menu";
constexpr std::array kMenuRows{"motion.copy", "motion.paste", "motion.select_keys", "edit.delete"};

constexpr double kZoomOfANotch = 1.25;
constexpr double kSightOfANotch = 0.1;  ///< of what is in sight

bool is_in_row(const KeyPlace& key, const TimeLineRow& row) {
  return key.handle == row.handle && key.property == row.property;
}

/// The library counts keys as this program does, and has a table to its own.
bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// The hand on the time line in one frame.
class Hand {
 public:
  Hand(Editor& editor, TimeLineState& state, const TimeLinePlace& place)
      : motion_(editor.motion()),
        editor_(editor),
        gesture_(state.gesture),
        state_(state),
        place_(place),
        io_(ImGui::GetIO()),
        rows_(time_line_rows(motion_.animation())) {}

  void act() {
    scroll();
    if (ImGui::IsItemActivated() && io_.MouseDown[ImGuiMouseButton_Left]) press();
    if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) open_menu();
    if (gesture_.kind != Kind::none && is_pressed(ImGuiKey_Escape)) take_back();
    if (gesture_.kind == Kind::scrub) scrub();
    if (gesture_.kind == Kind::band) select_band();
    if (gesture_.kind != Kind::none && !io_.MouseDown[ImGuiMouseButton_Left]) release();
    draw_menu();
  }

 private:
  /// The wheel goes through the rows; with Ctrl it zooms, with Shift it goes along the frames.
  void scroll() {
    TimeLineView& view = state_.view;
    const Cycle& cycle = motion_.animation().cycle;
    if (ImGui::IsItemHovered()) {
      const auto notches = static_cast<double>(io_.MouseWheel);
      const double along = static_cast<double>(io_.MouseWheelH) + (io_.KeyShift ? notches : 0);
      if (io_.KeyCtrl)
        view =
            zoomed(view, std::pow(kZoomOfANotch, notches), place_.moment_at(io_.MousePos.x), cycle);
      else if (!io_.KeyShift)
        view.first_row -= static_cast<int>(notches);
      view = scrolled(view, -along * kSightOfANotch * place_.shown, cycle);
    }
    const int most = std::max(0, static_cast<int>(rows_.size()) - place_.rows_in_sight());
    view.first_row = std::clamp(view.first_row, 0, most);
    if (std::exchange(state_.seen_moment, motion_.play_head().moment()) !=
        motion_.play_head().moment())
      view = with_moment_in_sight(view, motion_.play_head().moment(), cycle);
  }

  void scrub() {
    if (io_.KeyAlt)
      motion_.play_head().go_between(place_.moment_at(io_.MousePos.x));
    else
      motion_.play_head().go_to(place_.frame_at(io_.MousePos.x));
  }

  /// The keys under the pointer: several in the row of all.
  Keys keys_under_pointer() const {
    const float reach = 0.4F * place_.row;
    const int row = place_.row_at(io_.MousePos.y);
    Keys found;
    if (io_.MousePos.y < place_.area.y + place_.ruler || row >= static_cast<int>(rows_.size()))
      return found;
    std::optional<int> frame;
    for (const KeyPlace& key : keys_of(motion_.animation())) {
      if (row >= 0 && !is_in_row(key, rows_[static_cast<std::size_t>(row)])) continue;
      const float distance = std::abs(place_.x_of(key.frame) - io_.MousePos.x);
      if (distance > reach || !place_.is_in_sight(key.frame)) continue;
      if (!frame || distance < std::abs(place_.x_of(*frame) - io_.MousePos.x)) {
        frame = key.frame;
        found.clear();
      }
      if (key.frame == *frame) found.insert(key);
    }
    return found;
  }

  bool is_selected(const Keys& keys) const {
    const Keys& selected = motion_.keys().selected();
    return std::includes(selected.begin(), selected.end(), keys.begin(), keys.end());
  }

  void press() {
    gesture_ = {};
    gesture_.start = io_.MousePos;
    if (io_.MousePos.y < place_.area.y + place_.ruler) {
      gesture_.kind = Kind::scrub;
      return motion_.play_head().stop();
    }
    const Keys under = keys_under_pointer();
    if (under.empty()) return press_on_nothing();
    const bool was_selected = is_selected(under);
    if (io_.KeyShift)
      toggle(under, was_selected);
    else if (!was_selected)
      motion_.keys().select(under);
    if (motion_.keys().selected().empty()) return;
    gesture_.kind = io_.KeyAlt ? Kind::stretch : Kind::keys;
    gesture_.grabbed_frame = under.begin()->frame;
    const auto [low, high] =
        std::ranges::minmax_element(motion_.keys().selected(), {}, &KeyPlace::frame);
    gesture_.low = low->frame;
    gesture_.high = high->frame;
  }

  void toggle(const Keys& keys, bool were_selected) {
    Keys selected = motion_.keys().selected();
    for (const KeyPlace& key : keys)
      if (were_selected)
        selected.erase(key);
      else
        selected.insert(key);
    motion_.keys().select(selected);
  }

  void press_on_nothing() {
    const int row = place_.row_at(io_.MousePos.y);
    const bool has_row = row >= 0 && row < static_cast<int>(rows_.size());
    if (has_row && io_.MousePos.x < place_.area.x + place_.labels)
      return editor_.selection().select({rows_[static_cast<std::size_t>(row)].handle});
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      motion_.play_head().go_to(place_.frame_at(io_.MousePos.x));
      if (!has_row) return motion_.keys().key_handles();
      const auto [handle, property] = rows_[static_cast<std::size_t>(row)];
      editor_.selection().select({handle});
      return motion_.keys().key_row(handle, property);
    }
    gesture_.selected = motion_.keys().selected();
    if (io_.KeyShift) gesture_.before = gesture_.selected;
    gesture_.kind = Kind::band;
  }

  /// Nothing has changed before the end but what a band has selected.
  void take_back() {
    const TimeLineGesture given_up = std::exchange(gesture_, {});
    if (given_up.kind == Kind::band) motion_.keys().select(given_up.selected);
  }

  void select_band() {
    Keys selected = gesture_.before;
    const ImVec2 from = gesture_.start, to = io_.MousePos;
    const float left = std::min(from.x, to.x), right = std::max(from.x, to.x);
    const float top = std::min(from.y, to.y), bottom = std::max(from.y, to.y);
    for (const KeyPlace& key : keys_of(motion_.animation())) {
      const auto row =
          std::ranges::find_if(rows_, [&](const TimeLineRow& r) { return is_in_row(key, r); });
      const float x = place_.x_of(key.frame);
      const float y = place_.y_of(static_cast<int>(row - rows_.begin()));
      const auto is_inside = [&](float height) { return top <= height && height <= bottom; };
      if (left <= x && x <= right && (is_inside(y) || is_inside(place_.y_of_all())))
        selected.insert(key);
    }
    motion_.keys().select(selected);
  }

  /// A click that pulled nothing leaves the one key that it was on selected.
  void release() {
    const TimeLineGesture done = std::exchange(gesture_, {});
    const auto to = pulled_frame(done, place_);
    if (!to) return;
    if (to(done.grabbed_frame) != done.grabbed_frame)
      motion_.keys().move_selected(to, done.kind == Kind::keys && io_.KeyCtrl);
  }

  void open_menu() {
    const Keys under = keys_under_pointer();
    if (!under.empty() && !is_selected(under)) motion_.keys().select(under);
    ImGui::OpenPopup(kMenu);
  }

  void draw_menu() {
    if (!ImGui::BeginPopup(kMenu)) return;
    for (const char* name : kMenuRows)
      if (const Command* command = find_command(name)) draw_command_item(*command, editor_);
    ImGui::Separator();
    for (const NamedEasing& row : easings())
      if (ImGui::MenuItem(title_of(row).c_str(), nullptr, false,
                          !motion_.keys().selected().empty()))
        motion_.keys().set_easing(row.easing);
    ImGui::EndPopup();
  }

  Motion& motion_;
  Editor& editor_;
  TimeLineGesture& gesture_;
  TimeLineState& state_;
  const TimeLinePlace& place_;
  const ImGuiIO& io_;
  std::vector<TimeLineRow> rows_;
};

}  // namespace

std::function<int(int)> pulled_frame(const TimeLineGesture& gesture, const TimeLinePlace& place) {
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const int by = place.frame_at(pointer.x) - place.frame_at(gesture.start.x);
  const int low = gesture.low, high = gesture.high, grabbed = gesture.grabbed_frame;
  if (gesture.kind == Kind::keys) {
    // All of them stay within the cycle, and so none takes the place of another.
    const int possible = std::clamp(by, -low, place.last - high);
    return [possible](int frame) { return frame + possible; };
  }
  if (gesture.kind != Kind::stretch) return {};
  const int fixed = grabbed - low < high - grabbed ? high : low, length = grabbed - fixed;
  if (length == 0) return {};
  return [by, fixed, length](int frame) {
    const double factor = static_cast<double>(length + by) / length;
    return fixed + static_cast<int>(std::lround((frame - fixed) * factor));
  };
}

void handle_time_line(Editor& editor, TimeLineState& state, const TimeLinePlace& place) {
  Hand(editor, state, place).act();
}

}  // namespace foldless
