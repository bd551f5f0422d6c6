// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "app/editor/parameter_rows.h"
#include "core/energy/densities.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// Random events from a seed, without regard to whether they make sense.
class RandomHands {
 public:
  explicit RandomHands(unsigned seed) : random_(seed) {}

  InputEvent next() {
    const Vec2 at(real(-20, 820), real(-20, 620));
    switch (whole(0, 12)) {
      case 0:
      case 1:
      case 2: return PointerPressed{button(), at, modifiers()};
      case 3:
      case 4:
      case 5: return PointerReleased{button(), at, {}};
      case 6: return WheelTurned{real(-3, 3), at};
      case 7: return KeyPressed{key(), modifiers(), whole(0, 4) == 0};
      case 8: return KeyReleased{key()};
      case 9: return whole(0, 9) == 0 ? InputEvent(FocusLost{}) : PointerMoved{at, {}};
      default: return PointerMoved{at, modifiers()};
    }
  }

  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }

 private:
  Button button() { return whole(0, 5) == 0 ? static_cast<Button>(whole(0, 2)) : Button::left; }
  Modifiers modifiers() { return {whole(0, 6) == 0, whole(0, 6) == 0, whole(0, 20) == 0}; }
  Key key() { return static_cast<Key>(whole(0, static_cast<int>(Key::slash))); }

  std::mt19937 random_;
};

class RandomGestures : public EditorTest {
 protected:
  void play(unsigned seed, int events) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomHands hands(seed);
    for (int k = 0; k < events; ++k) {
      now_ += 0.01;
      editor_->receive(hands.next(), now_);
      editor_->messages().take_requests();
      if (editor_->files().question())
        editor_->files().answer(static_cast<Answer>(hands.whole(1, 2)));
      if (hands.whole(0, 40) == 0) change_something(hands);
      if (hands.whole(0, 2) == 0) frame();
      if (hands.whole(0, 50) == 0) wait_a_little();
      ASSERT_TRUE(is_valid()) << "event " << k;
      ASSERT_TRUE(is_consistent()) << "event " << k;
    }
  }

  void change_something(RandomHands& hands) {
    const auto rows = parameter_rows();
    const auto& row = rows[static_cast<std::size_t>(hands.whole(0, 3))];
    editor_->edits().set_parameter(
        row, default_of(row, editor_->document().parameters, *editor_->document().energy) *
                 hands.real(0.5, 2));
    const auto energies = densities();
    editor_->edits().set_energy(
        energies[static_cast<std::size_t>(hands.whole(0, static_cast<int>(energies.size()) - 1))]);
  }

  void wait_a_little() {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    frame();
  }

  /// Handles are on vertices of the mesh, no two on one, and what is selected exists.
  bool is_consistent() const {
    const Document& document = editor_->document();
    std::set<int> vertices;
    for (const Handle& handle : document.handles) {
      if (handle.vertex < 0 || handle.vertex >= document.pose->deformed.cols()) return false;
      if (!vertices.insert(handle.vertex).second || !handle.target.allFinite()) return false;
    }
    for (const int id : editor_->selection().ids())
      if (!find_handle(document, id)) return false;
    return handle_views(editor_->draft()).size() ==
           (editor_->shown() ? editor_->shown()->handles.size() : 0);
  }
};

TEST_F(RandomGestures, LeaveAGridValid) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    open_grid(6);
    play(seed, 300);
  }
}

TEST_F(RandomGestures, LeaveOneTriangleValid) {
  for (unsigned seed = 11; seed <= 14; ++seed) {
    Shape shape{Triangles(3, 1), Points(2, 3)};
    shape.triangles << 0, 1, 2;
    shape.rest << 0, 1, 0, 0, 0, 1;
    editor_->files().open_shape(std::move(shape), "triangle");
    play(seed, 300);
  }
}

TEST_F(RandomGestures, DoNothingToAnEmptyDocument) {
  play(21, 500);
  EXPECT_TRUE(editor_->document().is_empty());
}

}  // namespace
}  // namespace foldless::test
