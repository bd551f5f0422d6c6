// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "app/editor/handle_edits.h"
#include "app/editor/parameter_rows.h"
#include "core/energy/densities.h"
#include "core/method/methods.h"
#include "tests/app/editor/random_work.h"

namespace foldless::test {

std::span<const RandomWork::Gesture> RandomWork::gestures() {
  static constexpr std::array kTable = std::to_array<Gesture>({
      {"place", 14, &RandomWork::place_one},
      {"drag a handle", 24, &RandomWork::drag_a_handle},
      {"drag from anywhere", 8, &RandomWork::drag_from_anywhere},
      {"box or lasso", 6, &RandomWork::band_or_lasso},
      {"select by keys", 4, &RandomWork::select_by_keys},
      {"delete", 5, &RandomWork::delete_some},
      {"turn or scale", 6, &RandomWork::turn_or_scale},
      {"nudge", 5, &RandomWork::nudge_some},
      {"kind and weight", 4, &RandomWork::change_kinds},
      {"depth and name", 4, &RandomWork::change_depths},
      {"angle", 6, &RandomWork::turn_with_handles},
      {"stiffness brush", 5, &RandomWork::paint},
      {"undo and redo", 14, &RandomWork::undo_and_redo},
      {"jump", 3, &RandomWork::jump},
      {"earlier iterations", 8, &RandomWork::look_back},
      {"solve by steps", 5, &RandomWork::solve_by_steps},
      {"numbers", 4, &RandomWork::change_numbers},
      {"flip or split, reset pose", 7, &RandomWork::flip_or_split},
      {"image", 1, &RandomWork::import_image},
      {"open", 1, &RandomWork::open_another},
      {"save and open", 2, &RandomWork::save_and_open},
      {"view", 5, &RandomWork::look_around},
      {"race", 1, &RandomWork::race_methods},
      {"texture", 2, &RandomWork::texture},
      {"any key", 4, &RandomWork::any_key},
      {"bones", 3, &RandomWork::bones},
      {"mirror", 3, &RandomWork::mirror},
  });
  return kTable;
}

void RandomWork::place_one() {
  const Vec2 at = on_the_mesh();
  send(PointerPressed{Button::left, at, {}});
  send(PointerReleased{Button::left, at, {}});
}

void RandomWork::drag_a_handle() {
  const auto at = a_handle();
  if (!at) return place_one();
  stroke(*at, {.shift = happens_in(2), .control = happens_in(1)});
}

void RandomWork::drag_from_anywhere() {
  const Button button = happens_in(8) ? Button::left : static_cast<Button>(whole(0, 2));
  stroke(happens_in(6) ? on_the_mesh() : anywhere(), {}, button);
}

void RandomWork::band_or_lasso() {
  const bool is_lasso = happens_in(5);
  if (is_lasso) send(KeyPressed{Key::l, {}, false});
  stroke({real(0, 100), real(0, 100)}, {.shift = happens_in(3), .control = happens_in(2)});
  if (is_lasso) send(KeyReleased{Key::l});
}

void RandomWork::select_by_keys() {
  switch (whole(0, 3)) {
    case 0: return tap(Key::a, kControl);
    case 1: return tap(Key::a, kControlShift);
    case 2: return tap(Key::i, kControl);
    default: return select_some();
  }
}

void RandomWork::select_some() {
  std::set<int> ids;
  for (const Handle& handle : editor_->document().handles)
    if (happens_in(4)) ids.insert(handle.id);
  editor_->selection().select(ids);
}

void RandomWork::delete_some() {
  if (happens_in(5)) select_some();
  tap(happens_in(5) ? Key::del : Key::backspace);
}

void RandomWork::turn_or_scale() {
  if (happens_in(6)) select_some();
  tap(happens_in(6) ? Key::r : Key::s);
  for (int k = whole(0, 4); k > 0; --k) {
    send(PointerMoved{anywhere(), {.shift = happens_in(2)}});
    draw(whole(0, 1));
  }
  if (happens_in(3)) tap(Key::digit_2);
  if (happens_in(2)) tap(Key::backspace);
  switch (whole(0, 3)) {
    case 0: return tap(Key::enter);
    case 1: return tap(Key::escape);
    case 2: return tap(Key::z, kControl);
    default: send(PointerPressed{Button::left, anywhere(), {}});
  }
  send(PointerReleased{Button::left, anywhere(), {}});
}

void RandomWork::nudge_some() {
  if (happens_in(4)) select_some();
  const Key key =
      std::array{Key::left, Key::right, Key::up, Key::down}[static_cast<std::size_t>(whole(0, 3))];
  const Modifiers modifiers{.shift = happens_in(3), .alt = happens_in(2)};
  for (int k = whole(1, 4); k > 0; --k) send(KeyPressed{key, modifiers, k > 1});
  send(KeyReleased{key});
  if (happens_in(3)) now_ += 2;
}

void RandomWork::change_kinds() {
  if (happens_in(4)) select_some();
  switch (whole(0, 2)) {
    case 0: return tap(Key::k);
    case 1: return set_kind(*editor_, static_cast<HandleKind>(whole(0, 2)));
    default: return set_weight(*editor_, real(0, 5));
  }
}

void RandomWork::change_depths() {
  if (happens_in(4)) select_some();
  switch (whole(0, 3)) {
    case 0: return tap(Key::left_bracket);
    case 1: return tap(Key::right_bracket);
    case 2: return set_depth(*editor_, real(-5, 5));
    default: return set_name(*editor_, "pin " + std::to_string(whole(0, 9)));
  }
}

void RandomWork::paint() {
  if (happens_in(1)) return editor_->brush().clear();
  tap(Key::b);
  editor_->brush().set_factor(happens_in(5) ? 100 : real(0.1, 10));
  editor_->brush().set_radius(real(3, 80));
  for (int k = whole(1, 2); k > 0; --k) stroke(on_the_mesh(), {.shift = happens_in(2)});
  if (happens_in(9)) tap(Key::v);
}

void RandomWork::undo_and_redo() {
  for (int k = whole(1, 4); k > 0; --k) tap(Key::z, kControl);
  draw(whole(0, 2));
  for (int k = whole(0, 3); k > 0; --k) tap(Key::y, kControl);
}

void RandomWork::jump() {
  const int steps = static_cast<int>(editor_->draft().history().steps().size());
  editor_->draft().jump_to_step(static_cast<std::size_t>(whole(0, steps)));
}

void RandomWork::look_back() {
  Playback& playback = editor_->playback();
  if (happens_in(5)) playback.stop();
  draw();
  const int count = static_cast<int>(playback.iterations().size());
  switch (whole(0, 5)) {
    case 0: tap(Key::comma); break;
    case 1: tap(Key::comma, kShift); break;
    case 2: tap(Key::p); break;
    default:
      if (count > 0) playback.scrub(static_cast<std::size_t>(whole(0, count - 1)));
  }
  look();
  draw(whole(0, 4));
  if (happens_in(4)) tap(Key::enter);
  if (happens_in(2)) tap(Key::period, kShift);
}

void RandomWork::solve_by_steps() {
  switch (whole(0, 3)) {
    case 0: return tap(Key::space);
    case 1: return tap(Key::escape);
    case 2: return editor_->playback().set_pace(happens_in(7) ? std::nullopt : std::optional(60.0));
    default:
      for (int k = whole(1, 4); k > 0; --k) {
        tap(Key::period);
        draw(2);
      }
  }
  if (happens_in(7)) tap(Key::space);
}

void RandomWork::change_numbers() {
  const auto rows = parameter_rows();
  const auto& row = rows[static_cast<std::size_t>(whole(0, 3))];
  const double value = default_of(row, editor_->document().parameters, *editor_->document().energy);
  const auto energies = densities();
  const auto all = methods();
  const auto one_of = [this](const auto& many) -> decltype(auto) {
    return many[static_cast<std::size_t>(whole(0, static_cast<int>(many.size()) - 1))];
  };
  switch (whole(0, 4)) {
    case 0: editor_->edits().set_parameter(row, value * real(0.5, 2)); return;
    case 1: editor_->edits().reset_parameter(row); return;
    case 2: {
      const MethodRow& method = one_of(all);
      has_left_the_method_ |= method.may_fold || method.may_overlap;
      editor_->edits().set_method(method.name);
      draw(2);
      if (happens_in(8)) editor_->edits().set_method("foldless");
      return;
    }
    default: editor_->edits().set_energy(one_of(energies));
  }
}

void RandomWork::flip_or_split() {
  if (happens_in(3)) return tap(Key::r, kControl);
  for (int k = 0; k < 100 && editor_->playback().is_solving(); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    draw();
  }
  tap(happens_in(5) ? Key::f : Key::s, kShift);
}

void RandomWork::import_image() {
  expect_undo_to_the_start_and_back();
  editor_->files().open(folder_ / "ring.png");
  answer_questions();
  if (!editor_->files().image_import().is_open()) return;
  draw(whole(0, 3));
  if (happens_in(4)) return editor_->escape();
  editor_->files().take_image();
  wait_for([&] { return !editor_->files().image_import().is_open(); });
}

void RandomWork::open_another() {
  expect_undo_to_the_start_and_back();
  if (happens_in(3)) return editor_->files().new_document();
  open_something();
}

void RandomWork::save_and_open() {
  expect_undo_to_the_start_and_back();
  if (editor_->document().is_empty()) return;
  ASSERT_TRUE(editor_->files().save_as(folder_ / "work.json"));
  if (happens_in(5)) return;
  const Document saved = editor_->document();
  editor_->files().open(folder_ / "work.json");
  EXPECT_TRUE(is_same_content(editor_->document(), saved));
}

void RandomWork::look_around() {
  switch (whole(0, 8)) {
    case 0: return send(WheelTurned{real(-2, 2), anywhere()});
    case 1: return tap(Key::home);
    case 2: return tap(Key::f);
    case 3: return tap(Key::d);
    case 4: return tap(Key::backslash, kShift);
    case 5: return tap(Key::o);
    case 6: return tap(Key::tab);
    case 7: return stroke(anywhere(), {}, Button::middle);
    default: return send(PointerLeft{});
  }
}

void RandomWork::race_methods() {
  tap(Key::m);
  for (int k = whole(0, 10); k > 0; --k) {
    draw();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (!editor_->race().is_open()) return;
  if (happens_in(5)) return tap(Key::escape);
  has_left_the_method_ = true;  // lanes may end as the published methods do
  editor_->use_race_lane(0);
}

void RandomWork::texture() {
  if (happens_in(5)) return editor_->files().set_texture(folder_ / "ring.png");
  editor_->files().clear_texture();
}

void RandomWork::any_key() {
  tap(static_cast<Key>(whole(1, static_cast<int>(Key::right_bracket))),
      {.shift = happens_in(2), .control = happens_in(3), .alt = happens_in(1)});
}

}  // namespace foldless::test
