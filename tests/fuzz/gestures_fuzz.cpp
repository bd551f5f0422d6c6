// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody at the editor: nothing folds, and undo to the start gives the first state bit for bit.
#include "tests/app/editor/random_work.h"
#include "tests/fuzz/input.h"

namespace foldless {
namespace {

class Hands : public test::RandomWork {
 public:
  void work(std::span<const std::uint8_t> choices) {
    constexpr int kMostGestures = 30;
    begin(1);
    choices_.say(choices);
    for (int k = 0; k < kMostGestures && !choices_.has_said_all(); ++k) {
      make_gesture();
      fuzz::expect(is_sound(), "nothing folds");
    }
    expect_undo_to_the_start_and_back();
  }

 private:
  void TestBody() override {}
};

}  // namespace
}  // namespace foldless

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  GTEST_FLAG_SET(throw_on_failure, true);
  foldless::Hands().work({data, size});
  return 0;
}
