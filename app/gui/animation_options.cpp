// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/animation_options.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/export/video_file.h"
#include "app/gui/choice_list.h"
#include "app/gui/widgets.h"
#include "core/run/solved_animation.h"

namespace foldless {
namespace {

using Kind = AnimationFormat::Kind;

constexpr int kMostPixels = 16384;           // of a side
constexpr PictureSize kFirstSize{512, 512};  // where one is asked for

/// `Animated WebP (.webp)`; a name such as glTF keeps its letters.
std::string format_title(const AnimationFormat& format) {
  std::string title(format.words);
  const std::string first = title.substr(0, title.find_first_of(" ,"));
  const bool is_word = std::ranges::all_of(first, [](char c) { return 'a' <= c && c <= 'z'; });
  if (is_word) title[0] = static_cast<char>(title[0] - 'a' + 'A');
  if (!format.ending.empty()) title += " (" + std::string(format.ending) + ")";
  return title;
}

int last_frame_at(const Animation& animation, double fps) {
  if (animation.cycle.frames / animation.fps * fps > kMostFrames) return kMostFrames - 1;
  return static_cast<int>(moments_of(animation, fps).size()) - 1;
}

bool can_be_transparent(const AnimationFormat& format) {
  return !format.is_baked() && format.ending != ".mp4";
}

}  // namespace

std::string why_no_animation(const Editor& editor) {
  return editor.motion().has_keys() ? ""
                                    : "There are no keys. Open the time line (T), put the play "
                                      "head where a pose should be, and move handles.";
}

AnimationOptions::AnimationOptions() {
  const auto webp = std::ranges::find(animation_formats(), ".webp", &AnimationFormat::ending);
  row_ = static_cast<std::size_t>(webp - animation_formats().begin());
}

void AnimationOptions::open() { has_video_ = has_ffmpeg(); }

const AnimationFormat& AnimationOptions::format() const { return animation_formats()[row_]; }

AnimationChoice AnimationOptions::choice(bool is_transparent) const {
  return {format(),
          size_,
          fps_,
          is_transparent && can_be_transparent(format()),
          tolerance_,
          range_,
          power_of_two_ && format().kind == Kind::sheet};
}

void AnimationOptions::draw(const Editor& editor, bool& is_transparent, const Look& look) {
  draw_formats(look);
  draw_size(look);
  draw_rate(editor.motion().animation(), look);
  draw_range(editor.motion().animation(), look);
  if (format().is_baked()) return draw_tolerance(look);
  ImGui::BeginDisabled(!can_be_transparent(format()));
  ImGui::Checkbox("Transparent background", &is_transparent);
  ImGui::EndDisabled();
  if (format().kind != Kind::sheet) return;
  ImGui::Checkbox("Sides that are powers of two", &power_of_two_);
  tooltip("Some programs ask that of the picture that has all frames.", look);
}

void AnimationOptions::draw_formats(const Look& look) {
  ImGui::SetNextItemWidth(look.px(300));
  if (begin_combo("##format", format_title(format()), ImGuiComboFlags_HeightLargest)) {
    const auto formats = animation_formats();
    for (std::size_t i = 0; i < formats.size(); ++i) {
      const bool is_missing = formats[i].kind == Kind::video && !has_video_;
      ImGui::BeginDisabled(is_missing);
      std::string title = format_title(formats[i]);
      if (is_missing) title += ": needs ffmpeg, which is not installed";
      if (choice_entry(title.c_str(), i == row_)) row_ = i;
      ImGui::EndDisabled();
    }
    ImGui::EndCombo();
  }
  ImGui::PushTextWrapPos(0);
  dim_text(format().is_baked()
               ? "One mesh that moves, refined until every moment is proved injective."
               : "All frames, cropped to what any of them shows.",
           look);
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
}

/// Of a bake it is that of the pictures whose pixels the tolerance is in.
void AnimationOptions::draw_size(const Look& look) {
  if (ImGui::RadioButton("1024 pixels along the longer side", !size_)) size_.reset();
  if (ImGui::RadioButton("Width and height##animation", size_.has_value())) size_ = kFirstSize;
  if (!size_) return;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(look.px(130));
  if (ImGui::InputInt2("##animation size", size_->data()))
    for (int& pixels : *size_) pixels = std::clamp(pixels, 1, kMostPixels);
}

void AnimationOptions::draw_rate(const Animation& animation, const Look& look) {
  double fps = fps_.value_or(animation.fps);
  ImGui::SetNextItemWidth(look.px(70));
  if (ImGui::InputDouble("frames a second", &fps, 0, 0, "%.4g"))
    fps_ = std::clamp(fps, kLeastFps, kLargestFps);
  if (fps_ == animation.fps) fps_.reset();
  tooltip("The animation has the same length with more frames or fewer: they are solved anew.",
          look);
}

void AnimationOptions::draw_range(const Animation& animation, const Look& look) {
  const int last = last_frame_at(animation, fps_.value_or(animation.fps));
  bool is_cut = range_.has_value();
  if (ImGui::Checkbox("Some of the frames", &is_cut)) {
    range_.reset();
    if (is_cut) range_ = std::array{0, last};
  }
  tooltip("The first and the last that are written, from 0; a loop that is cut does not loop.",
          look);
  if (!range_) return;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(look.px(130));
  ImGui::InputInt2("##range", range_->data());
  auto& [first, end] = *range_;
  first = std::clamp(first, 0, last);
  end = std::clamp(end, first, last);
}

void AnimationOptions::draw_tolerance(const Look& look) {
  ImGui::SetNextItemWidth(look.px(70));
  if (ImGui::InputDouble("pixels of deviation at most", &tolerance_, 0, 0, "%.3g"))
    tolerance_ = std::clamp(tolerance_, 0.001, 100.0);
  tooltip("How far the baked mesh may be from the solver's; less makes more vertices.", look);
}

}  // namespace foldless
