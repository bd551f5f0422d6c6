// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/editor/random_work.h"

#include <array>
#include <bit>
#include <sstream>

#include "app/editor/scene_document.h"
#include "core/scene/scene_io.h"
#include "tests/support/pictures.h"

namespace foldless::test {
namespace {

const Vec2 kCanvas{800, 600};

template <class Matrix>
void append(std::string& bits, const Matrix& matrix) {
  bits.append(reinterpret_cast<const char*>(matrix.data()),
              static_cast<std::size_t>(matrix.size()) * sizeof(*matrix.data()));
  bits += '|';
}

void append(std::string& bits, double number) {
  bits += std::to_string(std::bit_cast<std::uint64_t>(number)) + ' ';
}

void append(std::string& bits, const Handle& handle) {
  append(bits, handle.target);
  for (const double number : {handle.weight, handle.depth, handle.turn.value_or(Turn{}).angle,
                              handle.turn.value_or(Turn{}).radius})
    append(bits, number);
  std::ostringstream words;
  words << handle.id << ' ' << handle.vertex << ' ' << static_cast<int>(handle.kind) << ' '
        << handle.turn.has_value() << ' ' << handle.name << '|';
  bits += words.str();
}

}  // namespace

std::string bits_of(const Document& document) {
  std::string bits = document.name + '|' + document.texture.string() + '|';
  if (document.is_empty()) return bits;
  append(bits, document.original->triangles);
  append(bits, document.original->rest);
  append(bits, *document.pose->triangles);
  append(bits, *document.pose->rest);
  append(bits, document.pose->deformed);
  for (const Handle& handle : document.handles) append(bits, handle);
  bits += std::string(document.energy->name) + '|' + document.parameters.method + '|';
  for (const double number : {document.parameters.alpha, document.parameters.beta.value_or(-1),
                              document.parameters.delta, document.parameters.eta})
    append(bits, number);
  // Numbers stand in files with all their digits: bones, mirror, keys, parts, strokes, parameters.
  const std::filesystem::path folder = "/";
  return bits + scene_text(scene_of(document, folder / "scene.json", nullptr), folder);
}

RandomWork::RandomWork() { write_ring(folder_ / "ring.png", 40); }

void RandomWork::begin(unsigned seed) {
  choices_.seed(seed);
  left_.clear();
  step_ = 0;
  was_editing_ = has_left_the_method_ = false;
  make_editor({.state_folder = folder_ / "state", .wake = {}});
  editor_->files().autosave().set_interval(0.5);
  look();
  open_something();
}

bool RandomWork::is_sound() const {
  const Document& document = editor_->document();
  if (document.is_empty()) return true;
  if (!has_left_the_method_) return is_valid();
  const Snapshot &pose = *document.pose, &shown = *editor_->shown();
  return is_injective_inside(*pose.triangles, *pose.rest, pose.deformed) &&
         (editor_->draft().proof().folds() ||
          is_injective_inside(*shown.triangles, *shown.rest, shown.deformed));
}

void RandomWork::look() {
  const Draft& draft = editor_->draft();
  const std::uint64_t step = draft.history().current_id();
  const Document& document = draft.document();
  const bool was_editing = std::exchange(was_editing_, draft.is_editing());
  if (draft.is_editing()) return;
  const bool comes_back = step != step_ || was_editing;
  left_.erase(left_.begin(), left_.lower_bound(draft.history().steps().front().id));
  const auto known = left_.find(step);
  if (comes_back && known != left_.end()) {
    EXPECT_TRUE(bits_of(document) == bits_of(known->second))
        << (step == step_ ? "an edit that was given up" : "a step that was gone back to") << ": "
        << draft.history().steps()[draft.history().current()].label;
  }
  if (draft.history().current() == 0) {
    const std::string bits = bits_of(document);
    EXPECT_TRUE(known == left_.end() || step == step_ || bits == first_);
    first_ = bits;
  }
  step_ = step;
  left_.insert_or_assign(step, document);
}

void RandomWork::send(const InputEvent& event) {
  now_ += 0.005;
  editor_->receive(event, now_);
  look();
}

void RandomWork::draw(int frames) {
  for (int k = 0; k < frames; ++k) {
    frame();
    look();
  }
}

void RandomWork::answer_questions() {
  for (const Request request : editor_->messages().take_requests()) {
    if (request != Request::save_dialog) continue;
    if (happens_in(7))
      editor_->files().save_as(folder_ / "work.json");
    else
      editor_->files().answer(Answer::cancel);
  }
  if (!editor_->files().question()) return look();
  editor_->files().answer(static_cast<Answer>(whole(0, 2)));
  look();
  answer_questions();
}

const RandomWork::Gesture& RandomWork::make_gesture() {
  if (editor_->document().is_empty() && happens_in(5)) open_something();
  const auto table = gestures();
  int sum = 0;
  for (const Gesture& gesture : table) sum += gesture.weight;
  int left = whole(1, sum);
  const Gesture* chosen = table.data();
  while ((left -= chosen->weight) > 0) ++chosen;
  (this->*chosen->make)();
  look();
  answer_questions();
  draw(whole(0, 3));
  if (happens_in(4)) std::this_thread::sleep_for(std::chrono::milliseconds(whole(1, 4)));
  if (happens_in(3)) {
    for (int k = 0; k < 40 && editor_->playback().is_solving(); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      draw();
    }
  }
  draw();
  return *chosen;
}

/// The keys that end whatever is under way, and no question left.
void RandomWork::leave_everything() {
  send(FocusLost{});
  for (int k = 0; k < 6; ++k) tap(Key::escape);
  if (editor_->brush().is_on()) editor_->brush().toggle();
  if (editor_->race().is_open()) editor_->toggle_race();
  editor_->playback().stop();
  draw();
  ASSERT_TRUE(editor_->input().is_idle());
}

void RandomWork::expect_undo_to_the_start_and_back() {
  leave_everything();
  const Draft& draft = editor_->draft();
  const std::string last = bits_of(draft.document());
  const std::size_t here = draft.history().current(), all = draft.history().steps().size();
  while (draft.history().can_undo()) {
    tap(Key::z, kControl);
    ASSERT_TRUE(is_sound()) << draft.history().steps()[draft.history().current()].label;
  }
  EXPECT_TRUE(bits_of(draft.document()) == first_);
  draw(2);
  EXPECT_TRUE(bits_of(draft.document()) == first_) << "nothing runs after undo";
  while (draft.history().can_redo()) {
    tap(Key::y, kControl);
    EXPECT_TRUE(draft.history().current() != here || bits_of(draft.document()) == last);
  }
  EXPECT_EQ(draft.history().current() + 1, all);
}

void RandomWork::open_something() {
  has_left_the_method_ = false;
  switch (whole(0, 5)) {
    case 0: {
      Shape shape{Triangles(3, 1), Points(2, 3)};
      shape.triangles << 0, 1, 2;
      shape.rest << 0, 1, 0, 0, 0, 1;
      editor_->files().open_shape(std::move(shape), "triangle");
      break;
    }
    case 1: {
      editor_->files().open(folder_ / "ring.png");
      answer_questions();
      editor_->files().take_image();
      wait_for([&] { return !editor_->files().image_import().is_open(); });
      break;
    }
    case 2: {
      Fixture fan = open_fan(340, 9);
      editor_->files().open_shape({std::move(fan.triangles), std::move(fan.rest)}, "fan");
      break;
    }
    default: open_grid(whole(2, 9));
  }
  look();
}

Vec2 RandomWork::on_the_mesh() {
  const auto& shown = editor_->shown();
  if (!shown) return anywhere();
  const auto triangle =
      shown->triangles->col(whole(0, static_cast<int>(shown->triangles->cols()) - 1));
  std::array<double, 3> weights{real(0, 1), real(0, 1), real(0, 1)};
  if (happens_in(4)) weights = {1, 0, 0};
  Vec2 point = Vec2::Zero();
  for (int k = 0; k < 3; ++k)
    point += weights[static_cast<std::size_t>(k)] * shown->deformed.col(triangle[k]);
  return pixel_of(point / (weights[0] + weights[1] + weights[2]));
}

Vec2 RandomWork::by_some_way() {
  const double length = happens_in(1) ? 900 : happens_in(5) ? 200 : 40;
  return {real(-length, length), real(-length, length)};
}

std::optional<Vec2> RandomWork::a_handle() {
  const auto handles = handle_views(editor_->draft());
  if (handles.empty()) return std::nullopt;
  const auto& handle =
      handles[static_cast<std::size_t>(whole(0, static_cast<int>(handles.size()) - 1))];
  return pixel_of(happens_in(7) ? handle.position : handle.target);
}

/// A press, a way and a release, which something may come in between of.
void RandomWork::stroke(const Vec2& from, Modifiers modifiers, Button button) {
  send(PointerMoved{from, modifiers});
  send(PointerPressed{button, from, modifiers});
  Vec2 at = from;
  for (int moves = whole(1, 6); moves > 0; --moves) {
    at += by_some_way() / 3;
    if (happens_in(8)) at = at.cwiseMax(Vec2::Zero()).cwiseMin(kCanvas);
    send(PointerMoved{at, modifiers});
    draw(whole(0, 2));
    if (happens_in(2)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (whole(0, 15) == 0) tap(Key::escape);
  if (whole(0, 25) == 0) tap(Key::z, kControl);
  if (whole(0, 40) == 0) return send(FocusLost{});
  send(PointerReleased{button, at, modifiers});
}

void RandomWork::tap(Key key, Modifiers modifiers) {
  send(KeyPressed{key, modifiers, false});
  send(KeyReleased{key});
}

}  // namespace foldless::test
