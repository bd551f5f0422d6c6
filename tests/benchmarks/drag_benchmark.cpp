// SPDX-License-Identifier: GPL-3.0-or-later
// Frame times of the whole editor, off screen, while a handle of a mesh is dragged round and the
// solver works behind it, and while an animation plays. The argument is the number of triangles.
#include <benchmark/benchmark.h>

#include <glad/gl.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <thread>
#include <utility>
#include <vector>

#include "app/editor/editor.h"
#include "app/gui/ui.h"
#include "render/offscreen.h"
#include "tests/benchmarks/turned_disk.h"

namespace foldless::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Extent kSize{1280, 720};
constexpr std::chrono::duration<double> kRefresh{1.0 / 60};
constexpr int kFrames = 300;

/// What drawing a picture took.
struct FrameCost {
  double seconds = 0;    ///< on the clock: what the user waits for
  double processor = 0;  ///< of this thread alone, so without the solver's [s]
};

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Makes the software rasteriser draw on the thread that calls it, whose time is measured, when it
/// comes to be before the context.
struct DrawsOnThisThread {
  DrawsOnThisThread() { setenv("LP_NUM_THREADS", "0", 1); }
};

/// The editor off screen at the pace of a display.
class Stage {
 public:
  explicit Stage(int faces) : offscreen_(kSize.width, kSize.height, 1) {
    editor_.files().open_shape(disk(disk_of(faces)), "disk");
    for (int i = 0; i < 10; ++i) frame();
  }

  /// Framebuffer pixel of a point of the plane.
  Vec2 pixel(const Vec2& world) const {
    const Rectangle& canvas = ui_.layout().canvas;
    return editor_.canvas().to_pixel(world) + Vec2(canvas.x, canvas.y);
  }
  void send(const InputEvent& event) { ui_.receive(event); }
  Editor& editor() { return editor_; }

  /// Draws one picture, then waits for the next refresh.
  FrameCost frame() {
    const Clock::time_point start = Clock::now();
    const double processor = thread_seconds();
    offscreen_.bind();
    ui_.frame(editor_, {kSize, kSize, 1, std::chrono::duration<double>(start - start_).count()});
    glFinish();
    const std::chrono::duration<double> took = Clock::now() - start;
    const FrameCost cost{took.count(), thread_seconds() - processor};
    std::this_thread::sleep_for(kRefresh - took);
    return cost;
  }

 private:
  Clock::time_point start_ = Clock::now();
  DrawsOnThisThread draws_on_this_thread_;
  Offscreen offscreen_;
  Editor editor_;
  Ui ui_;
};

void click(Stage& stage, const Vec2& at) {
  stage.send(PointerMoved{at, {}});
  stage.frame();
  stage.send(PointerPressed{Button::left, at, {}});
  stage.frame();
  stage.send(PointerReleased{Button::left, at, {}});
  stage.frame();
}

double percentile(std::vector<double> seconds, double fraction) {
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(seconds.size() - 1));
  std::ranges::nth_element(seconds, seconds.begin() + rank);
  return 1000 * seconds[static_cast<std::size_t>(rank)];
}

void report(benchmark::State& state, const std::vector<FrameCost>& frames) {
  std::vector<double> seconds;
  std::vector<double> processor;
  for (const FrameCost& frame : frames) {
    seconds.push_back(frame.seconds);
    processor.push_back(frame.processor);
  }
  state.counters["p50_ms"] = percentile(seconds, 0.5);
  state.counters["p95_ms"] = percentile(seconds, 0.95);
  state.counters["max_ms"] = percentile(seconds, 1);
  state.counters["cpu_p50_ms"] = percentile(processor, 0.5);
  state.counters["cpu_p95_ms"] = percentile(processor, 0.95);
}

/// Two handles hold the disk at its sides, a third in the middle goes round.
void drag(benchmark::State& state) {
  Stage stage(static_cast<int>(state.range(0)));
  click(stage, stage.pixel({-0.4, 0}));
  click(stage, stage.pixel({0.4, 0}));
  const Vec2 middle = stage.pixel({0, 0});
  const double radius = 0.2 * (stage.pixel({1, 0}) - middle).norm();
  std::vector<FrameCost> frames;
  std::size_t iterations = 0;
  for (auto _ : state) {
    stage.send(PointerMoved{middle, {}});
    stage.frame();
    stage.send(PointerPressed{Button::left, middle, {}});
    for (int i = 0; i < kFrames; ++i) {
      const double angle = 4 * std::numbers::pi * i / kFrames;
      const Vec2 offset(radius * std::sin(angle), radius * (1 - std::cos(angle)));
      stage.send(PointerMoved{middle + offset, {}});
      frames.push_back(stage.frame());
    }
    iterations = stage.editor().playback().iterations().size();
    stage.send(PointerReleased{Button::left, middle, {}});
    stage.frame();
  }
  report(state, frames);
  state.counters["iterations"] = static_cast<double>(iterations);
}
BENCHMARK(drag)->Arg(500)->Arg(5000)->Arg(50000)->Iterations(1)->Unit(benchmark::kSecond);

/// The same without a drag: what drawing alone costs.
void draw(benchmark::State& state) {
  Stage stage(static_cast<int>(state.range(0)));
  std::vector<FrameCost> frames;
  for (auto _ : state)
    for (int i = 0; i < kFrames; ++i) frames.push_back(stage.frame());
  report(state, frames);
}
BENCHMARK(draw)->Arg(500)->Arg(5000)->Arg(50000)->Iterations(1)->Unit(benchmark::kSecond);

void press(Stage& stage, Key key) {
  stage.send(KeyPressed{key, {}, false});
  stage.send(KeyReleased{key});
  stage.frame();
}

/// Keys at frames 0 and 12 of a loop of 24: the middle goes to the side and back.
void animate(Stage& stage) {
  for (const double x : {-0.4, 0.4, 0.0}) click(stage, stage.pixel({x, 0}));
  press(stage, Key::t);
  Motion& motion = stage.editor().motion();
  motion.keys().set_cycle({24, true});
  motion.play_head().go_to(12);
  stage.frame();
  const Vec2 middle = stage.pixel({0, 0});
  stage.send(PointerMoved{middle, {}});
  stage.send(PointerPressed{Button::left, middle, {}});
  for (int i = 0; i <= 10; ++i) {
    stage.send(PointerMoved{middle + Vec2(0, 6 * i), {}});
    stage.frame();
  }
  stage.send(PointerReleased{Button::left, middle + Vec2(0, 60), {}});
  do stage.frame();
  while (!motion.frames().status().is_done ||
         motion.proof().state == MotionProofStatus::State::running);
  motion.play_head().go_to(0);
}

/// All frames are solved and proved; what a display waits for while they play.
void play(benchmark::State& state) {
  Stage stage(static_cast<int>(state.range(0)));
  animate(stage);
  std::vector<FrameCost> frames;
  int changes = 0;
  for (auto _ : state) {
    press(stage, Key::space);
    const Clock::time_point start = Clock::now();
    int before = stage.editor().motion().play_head().frame();
    for (int i = 0; i < kFrames; ++i) {
      frames.push_back(stage.frame());
      if (std::exchange(before, stage.editor().motion().play_head().frame()) != before) ++changes;
    }
    const std::chrono::duration<double> took = Clock::now() - start;
    state.counters["frames_a_second"] = changes / took.count();
  }
  report(state, frames);
}
BENCHMARK(play)->Arg(2000)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace foldless::benchmarks
