// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/headless_editor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>
#include <vector>

#include "app/gui/replay.h"
#include "app/gui/session_file.h"
#include "tests/app/gui/drawing_defects.h"

namespace foldless::test {
namespace {

constexpr double kFrameSeconds = 1.0 / 60;
constexpr int kManyFrames = 50;

/// A context in which no other editor draws. Those of editors that have ended are taken again: to
/// make one, with the programs that Mesa compiles in it, takes a good part of the time of a short
/// test.
std::shared_ptr<Offscreen> take_offscreen(Extent size) {
  // Never destroyed: as the process ends what Mesa needs for that may be gone already.
  static std::vector<std::unique_ptr<Offscreen>>& kept =
      *new std::vector<std::unique_ptr<Offscreen>>;
  std::unique_ptr<Offscreen> taken;
  if (kept.empty()) {
    taken = std::make_unique<Offscreen>(size.width, size.height);
  } else {
    taken = std::move(kept.back());
    kept.pop_back();
    taken->make_current();
    if (taken->width() != size.width || taken->height() != size.height)
      taken->resize(size.width, size.height);
  }
  return {taken.release(), [](Offscreen* offscreen) { kept.emplace_back(offscreen); }};
}

}  // namespace

HeadlessEditor::HeadlessEditor(Extent size, UiOptions options, EditorOptions editor_options)
    : size_(size),
      offscreen_(take_offscreen(size)),
      editor_(std::move(editor_options)),
      ui_(std::move(options)) {
  ui_.restore(editor_);
  settle();
}

void HeadlessEditor::frame() {
  time_ += kFrameSeconds;
  unseen_.bind();
  const Extent window{static_cast<int>(static_cast<float>(size_.width) / content_scale_),
                      static_cast<int>(static_cast<float>(size_.height) / content_scale_)};
  if (!ui_.frame(editor_, {size_, window, content_scale_, time_, true})) return;
  ++drawn_frames_;
  is_picture_drawn_ = false;
}

void HeadlessEditor::settle() {
  frame();
  draw_what_is_due();
  wait_for_file();
  expect_no_defects();
}

/// Frames that the interface asks for: as in a window, no more.
void HeadlessEditor::draw_what_is_due() {
  for (int i = 0; i < kManyFrames && ui_.next_frame(editor_, time_) == 0.0; ++i) frame();
}

/// Tests look at the file as soon as the keys for it were pressed.
void HeadlessEditor::wait_for_file() {
  while (ui_.is_writing_a_file()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    frame();
  }
  draw_what_is_due();
}

/// While something is solved lists grow from frame to frame, and ImGui learns how wide they are and
/// how far they scroll some frames later. What then rests on screen has none.
void HeadlessEditor::expect_no_defects() {
  const bool is_racing = editor_.race().is_open() && !editor_.race().is_finished();
  if (drawing_defects().empty() || editor_.playback().is_solving() || is_racing) return;
  for (const std::string& defect : drawing_defects())
    if (known_defects_.insert(defect).second) ADD_FAILURE() << defect;
}

bool HeadlessEditor::wait_until(const std::function<bool()>& done, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!done()) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    frame();
  }
  settle();
  return true;
}

void HeadlessEditor::calm_down() {
  move({-100, -100});
  ui_.receive(WindowLeft{});
  time_ += 60;
  settle();
}

void HeadlessEditor::send(InputEvent event) {
  ui_.receive(std::move(event));
  settle();
}

void HeadlessEditor::move(const Vec2& to) { send(PointerMoved{to, held_}); }

void HeadlessEditor::press(const Vec2& at, Button button) {
  move(at);
  send(PointerPressed{button, at, held_});
}

void HeadlessEditor::release(const Vec2& at, Button button) {
  send(PointerReleased{button, at, held_});
}

void HeadlessEditor::click(const Vec2& at) {
  press(at);
  release(at);
}

void HeadlessEditor::key(Key key, Modifiers modifiers) {
  ui_.receive(ModifiersHeld{modifiers});
  send(KeyPressed{key, modifiers, false});
  send(KeyReleased{key});
  ui_.receive(ModifiersHeld{});
  settle();
}

void HeadlessEditor::hold(Modifiers modifiers) {
  held_ = modifiers;
  ui_.receive(ModifiersHeld{modifiers});
  settle();
}

void HeadlessEditor::type(std::string_view ascii) {
  for (const char c : ascii) ui_.receive(CharacterTyped{static_cast<char32_t>(c)});
  settle();
}

std::map<std::string, Image> HeadlessEditor::play(const std::string& lines) {
  const std::string head = first_line({size_, size_}, {}, {});
  const SessionFile session = parse_session(head + lines, "session", {});
  const double start = time_;
  std::map<std::string, Image> pictures;
  for (const SessionEntry& entry : session.entries) {
    time_ = std::max(time_, start + entry.time);
    if (const auto* event = std::get_if<UiEvent>(&entry.event)) ui_.receive(*event);
    settle();
    EXPECT_TRUE(wait_until([this] { return !is_busy(editor_, ui_); })) << "line " << entry.line;
    if (const auto* shot = std::get_if<Shot>(&entry.event)) pictures[shot->name] = picture();
  }
  return pictures;
}

std::optional<Vec2> HeadlessEditor::find_words(const std::string& words) const {
  const auto place = place_of_words(words);
  if (!place) return std::nullopt;
  return Vec2(place->x, place->y) / content_scale_;
}

Vec2 HeadlessEditor::window_point(const Vec2& world) const {
  const Rectangle& canvas = ui_.layout().canvas;
  const Vec2 pixel = editor_.canvas().to_pixel(world) + Vec2(canvas.x, canvas.y);
  return pixel / content_scale_;
}

Vec2 HeadlessEditor::position(int vertex) const { return editor_.shown()->deformed.col(vertex); }

Image HeadlessEditor::picture() {
  offscreen_->bind();
  if (!std::exchange(is_picture_drawn_, true)) ui_.draw_again();
  return offscreen_->read();
}

Image HeadlessEditor::canvas_picture() {
  const Image whole = picture();
  const Rectangle& canvas = ui_.layout().canvas;
  Image part(static_cast<int>(canvas.width), static_cast<int>(canvas.height));
  for (int y = 0; y < part.height; ++y)
    std::memcpy(part.at(0, y), whole.at(static_cast<int>(canvas.x), static_cast<int>(canvas.y) + y),
                4 * static_cast<std::size_t>(part.width));
  return part;
}

int differing_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < std::min(a.height, b.height); ++y)
    for (int x = 0; x < std::min(a.width, b.width); ++x)
      count += std::memcmp(a.at(x, y), b.at(x, y), 4) != 0;
  return count;
}

}  // namespace foldless::test
