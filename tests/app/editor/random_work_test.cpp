// SPDX-License-Identifier: GPL-3.0-or-later
// Random gestures that make sense: nothing folds, and undo brings every step back bit for bit.
#include <iostream>

#include "tests/app/editor/random_work.h"
#include "tests/support/number_from.h"

namespace foldless::test {
namespace {

constexpr int kGesturesOfASession = 100;

/// Handles are on vertices of the mesh, no two on one, and what is selected exists.
bool is_consistent(const Editor& editor) {
  const Document& document = editor.document();
  std::set<int> vertices, ids;
  for (const Handle& handle : document.handles) {
    if (handle.vertex < 0 || handle.vertex >= document.pose->deformed.cols()) return false;
    if (handle.id >= document.next_handle_id || !handle.target.allFinite()) return false;
    if (!vertices.insert(handle.vertex).second || !ids.insert(handle.id).second) return false;
  }
  for (const int id : editor.selection().ids())
    if (!ids.contains(id)) return false;
  return true;
}

/// FOLDLESS_GESTURES says how many, FOLDLESS_SEED where the seeds begin.
TEST_F(RandomWork, NeverFoldsAndUndoLeadsToTheStartBitForBit) {
  const int wanted = number_from("FOLDLESS_GESTURES", 300);
  auto seed = static_cast<unsigned>(number_from("FOLDLESS_SEED", 1));
  for (int made = 0; made < wanted; ++seed) {
    std::cout << "seed " << seed << std::endl;
    SCOPED_TRACE("seed " + std::to_string(seed));
    begin(seed);
    for (int k = 0; k < kGesturesOfASession && made < wanted; ++k, ++made) {
      const Gesture& gesture = make_gesture();
      ASSERT_TRUE(is_sound()) << "gesture " << k << ": " << gesture.name;
      ASSERT_TRUE(is_consistent(*editor_)) << "gesture " << k << ": " << gesture.name;
      ASSERT_FALSE(HasFailure()) << "gesture " << k << ": " << gesture.name;
    }
    expect_undo_to_the_start_and_back();
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace foldless::test
