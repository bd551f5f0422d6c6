// SPDX-License-Identifier: GPL-3.0-or-later
// An editor that is used for long takes no more memory, files or time than at the beginning.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <vector>

#include "tests/app/editor/editor_fixture.h"
#include "tests/support/number_from.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What the process has at a moment.
struct Load {
  double mebibytes = 0;  ///< in memory
  std::ptrdiff_t descriptors = 0;
  double latency = 0;  ///< median time of a frame while a handle is dragged [s]
};

double mebibytes_now() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmRSS:" && status >> word) return std::stod(word) / 1024;
  return 0;
}

std::ptrdiff_t descriptors_now() {
  return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
}

class Soak : public EditorTest {
 protected:
  Soak() {
    make_editor({.state_folder = folder_ / "state", .wake = {}});
    editor_->files().autosave().set_interval(0.2);
  }

  /// Opens a drawing, poses it, takes all back and does it again, saves and opens it anew.
  Load work(int round) {
    open_grid(12);
    const int pinned = place(0), moved = place(143);
    std::vector<double> times;
    for (int k = 0; k < 10; ++k) {
      const double angle = k + 0.1 * round;
      const Vec2 to = Vec2(11, 11) + 2 * Vec2(std::cos(angle), std::sin(angle));
      const Vec2 from = pixel_of_handle(moved);
      press(from);
      for (int step = 1; step <= 4; ++step) {
        move(from + (pixel_of(to) - from) * step / 4);
        const auto start = Clock::now();
        frame();
        times.push_back(seconds_since(start));
      }
      release(pixel_of(to));
      settle();
    }
    EXPECT_NE(pinned, moved);
    while (editor_->draft().history().can_undo()) key(Key::z, kControl);
    while (editor_->draft().history().can_redo()) key(Key::y, kControl);
    EXPECT_TRUE(editor_->files().save_as(folder_ / "work.json"));
    editor_->files().open(folder_ / "work.json");
    EXPECT_TRUE(is_valid());
    std::ranges::nth_element(times, times.begin() + static_cast<long>(times.size() / 2));
    return {mebibytes_now(), descriptors_now(), times[times.size() / 2]};
  }

  TemporaryFolder folder_;
};

/// FOLDLESS_SOAK says for how many seconds.
TEST_F(Soak, TakesNoMoreMemoryFilesOrTimeThanAtTheBeginning) {
  const double wanted = number_from("FOLDLESS_SOAK", 4);
  const auto start = Clock::now();
  constexpr int kToWarmUp = 3;
  std::vector<Load> loads;
  for (int round = 0; round < kToWarmUp + 2 || seconds_since(start) < wanted; ++round) {
    loads.push_back(work(round));
    ASSERT_FALSE(HasFailure());
  }
  const Load &first = loads[kToWarmUp], &last = loads.back();
  std::cout << loads.size() << " rounds; from " << first.mebibytes << " to " << last.mebibytes
            << " MiB, " << first.descriptors << " to " << last.descriptors << " descriptors, "
            << 1e3 * first.latency << " to " << 1e3 * last.latency << " ms a frame\n";
  EXPECT_LE(last.mebibytes, 1.2 * first.mebibytes + 20);
  EXPECT_LE(last.descriptors, first.descriptors + 2);  // a copy may be being written
  EXPECT_LE(last.latency, 5 * first.latency + 0.005);
}

}  // namespace
}  // namespace foldless::test
