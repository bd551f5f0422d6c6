// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/editor/choices.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {

/// All of a document that undo restores, byte by byte where it is numbers.
std::string bits_of(const Document& document);

/// An editor in the hands of somebody who does whatever a hand can do, chosen by a seed. Every
/// event and every frame is followed by a look at what undo has promised.
class RandomWork : public EditorTest {
 protected:
  struct Gesture {
    const char* name;
    int weight;  ///< how often it is made
    void (RandomWork::*make)();
  };
  static std::span<const Gesture> gestures();

  RandomWork();
  /// Another editor, and other numbers to follow.
  void begin(unsigned seed);
  /// Makes a gesture of the table and gives the solver some time, or all that it wants.
  const Gesture& make_gesture();
  /// Opens a document without handles, by the seed.
  void open_something();
  /// Whatever is under way ends; then back to the first step and forth to the last.
  void expect_undo_to_the_start_and_back();

  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(choices_); }
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(choices_);
  }
  bool happens_in(int out_of_ten) { return whole(1, 10) <= out_of_ten; }

  /// By the exact predicates. A method that folds by its nature may show that, and says so; the
  /// document never has it.
  bool is_sound() const;

  Choices choices_;  ///< of what is done

 private:
  /// What the history holds of a step, as it was when the step was left.
  void look();
  void send(const InputEvent& event);
  void draw(int frames = 1);
  void answer_questions();
  void leave_everything();

  Vec2 anywhere() { return {real(-20, 820), real(-20, 620)}; }
  Vec2 on_the_mesh();
  Vec2 by_some_way();
  std::optional<Vec2> a_handle();
  void stroke(const Vec2& from, Modifiers modifiers, Button button = Button::left);
  void tap(Key key, Modifiers modifiers = {});
  void select_some();

  // The gestures.

  void place_one();
  void drag_a_handle();
  void drag_from_anywhere();
  void band_or_lasso();
  void select_by_keys();
  void delete_some();
  void turn_or_scale();
  void nudge_some();
  void change_kinds();
  void change_depths();
  void turn_with_handles();
  void paint();
  void undo_and_redo();
  void jump();
  void look_back();
  void solve_by_steps();
  void change_numbers();
  void flip_or_split();
  void import_image();
  void open_another();
  void save_and_open();
  void look_around();
  void race_methods();
  void texture();
  void any_key();
  void bones();
  void mirror();

  TemporaryFolder folder_;
  bool has_left_the_method_ = false;        ///< for one that may fold, or overlap at the boundary
  std::map<std::uint64_t, Document> left_;  ///< by the id of the step
  std::uint64_t step_ = 0;
  bool was_editing_ = false;
  std::string first_;  ///< bits of the first step when it was left
};

}  // namespace foldless::test
