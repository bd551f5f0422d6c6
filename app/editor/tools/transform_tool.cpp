// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/mirroring.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

constexpr double kTurnSnap = 15, kScaleSnap = 0.1;  // degrees, and a part
constexpr double kDegree = std::numbers::pi / 180;

/// What a key adds to a number that is typed, or nothing.
std::optional<char> typed(Key key) {
  if (Key::digit_0 <= key && key <= Key::digit_9)
    return static_cast<char>('0' + static_cast<int>(key) - static_cast<int>(Key::digit_0));
  if (key == Key::period) return '.';
  if (key == Key::minus) return '-';
  return std::nullopt;
}

double snapped(double value, double unit) { return std::round(value / unit) * unit; }

std::string short_words(const char* format, double value) {
  std::array<char, 48> words{};
  std::snprintf(words.data(), words.size(), format, value);
  return words.data();
}

class TransformTool final : public Tool {
 public:
  /// Which button takes what was done, by going down or by going up.
  enum class Ends { with_press, with_release };

  TransformTool(Transformation what, const Vec2& from, std::vector<Target> starts, Ends ends)
      : what_(what), last_(from), starts_(std::move(starts)), ends_(ends) {
    for (const Target& start : starts_) centre_ += start.position;
    centre_ /= static_cast<double>(starts_.size());
  }

  bool is_editing() const override { return true; }

  std::string words() const override {
    const std::string what = what_ == Transformation::turn ? short_words("Turn by %.4g°", shown_)
                                                           : short_words("Scale by %.4g", shown_);
    if (ends_ == Ends::with_release) return what + " · Shift snaps · Esc takes it back";
    return what + " · click or Enter takes it · Esc takes it back · Shift snaps, or type a number";
  }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    const Vec2 centre = editor.canvas().to_pixel(centre_);
    const Vec2 before = last_ - centre, now = event.position - centre;
    last_ = event.position;
    if (what_ == Transformation::turn)  // y is down in pixels
      by_hand_ -= std::atan2(cross(before, now), before.dot(now)) / kDegree;
    else if (before.norm() > 1 && now.norm() > 1)
      by_hand_ *= now.norm() / before.norm();
    is_snapped_ = event.modifiers.shift;
    if (text_.empty()) apply(editor);
    return nullptr;
  }

  std::unique_ptr<Tool> press(Editor& editor, const PointerPressed& event) override {
    return event.button == Button::left ? take(editor) : take_back(editor);
  }

  std::unique_ptr<Tool> release(Editor& editor, const PointerReleased& event) override {
    if (ends_ == Ends::with_press || event.button != Button::left) return nullptr;
    return take(editor);
  }

  bool key(Editor& editor, const KeyPressed& event, std::unique_ptr<Tool>& next) override {
    next = nullptr;
    if (event.key == Key::enter) {
      next = take(editor);
      return true;
    }
    if (event.key == Key::backspace) {
      if (!text_.empty()) text_.pop_back();
    } else if (const auto character = typed(event.key); character && !event.modifiers.control) {
      text_ += *character;
    } else {
      return false;
    }
    apply(editor);
    return true;
  }

  void cancel(Editor& editor) override { editor.draft().abandon_edit(); }

 private:
  double value() const {
    if (!text_.empty()) return std::strtod(text_.c_str(), nullptr);
    if (!is_snapped_) return by_hand_;
    if (what_ == Transformation::scale) return snapped(by_hand_, kScaleSnap);
    // One handle alone comes to an angle that is a multiple, not by one.
    const double from = starts_.size() == 1 ? starts_.front().angle.value_or(0) : 0;
    return snapped(from + by_hand_, kTurnSnap) - from;
  }

  Eigen::Matrix2d matrix() const {
    if (what_ == Transformation::scale) return shown_ * Eigen::Matrix2d::Identity();
    const double c = std::cos(shown_ * kDegree), s = std::sin(shown_ * kDegree);
    return Eigen::Matrix2d{{c, -s}, {s, c}};
  }

  void apply(Editor& editor) {
    shown_ = value();
    const Eigen::Matrix2d linear = matrix();
    std::vector<Target> targets = starts_;
    for (Target& target : targets) {
      target.position = centre_ + linear * (target.position - centre_);
      if (target.angle && what_ == Transformation::turn) *target.angle += shown_;
    }
    if (!before_) before_ = editor.document();
    targets = with_rig(editor, *before_, std::move(targets));
    editor.draft().apply(with_targets(editor.document(), targets), Change::targets);
  }

  std::unique_ptr<Tool> take(Editor& editor) {
    if (ends_ == Ends::with_release && shown_ == 0) return take_back(editor);  // a click
    editor.draft().commit(what_ == Transformation::turn ? turn_label() : "Scale handles");
    return make_idle_tool();
  }
  const char* turn_label() const { return starts_.size() == 1 ? "Turn handle" : "Turn handles"; }
  static std::unique_ptr<Tool> take_back(Editor& editor) {
    editor.draft().abandon_edit();
    return make_idle_tool();
  }

  Transformation what_;
  Vec2 last_;  ///< of the pointer, in pixels
  std::vector<Target> starts_;
  Ends ends_;
  std::optional<Document> before_;  ///< the first move
  Vec2 centre_ = Vec2::Zero();
  double by_hand_ = what_ == Transformation::turn ? 0 : 1;  ///< degrees, or a factor
  bool is_snapped_ = false;
  std::string text_;  ///< that was typed
  double shown_ = by_hand_;
};

}  // namespace

std::unique_ptr<Tool> make_transform_tool(Transformation what, const Vec2& from,
                                          std::vector<Target> starts) {
  return std::make_unique<TransformTool>(what, from, std::move(starts),
                                         TransformTool::Ends::with_press);
}

std::unique_ptr<Tool> make_ring_tool(const Vec2& from, std::vector<Target> starts) {
  return std::make_unique<TransformTool>(Transformation::turn, from, std::move(starts),
                                         TransformTool::Ends::with_release);
}

}  // namespace foldless
