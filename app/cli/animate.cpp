// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "app/cli/problem.h"
#include "app/cli/progress_line.h"
#include "app/export/animation_writer.h"
#include "app/export/held_steps.h"
#include "core/error.h"
#include "core/files/text_lines.h"
#include "core/run/interrupt.h"
#include "core/run/solved_animation.h"
#include "core/run/stop_watch.h"
#include "core/scene/failure_words.h"
#include "render/figure.h"

namespace foldless {
namespace {

std::string rounded(double value, double unit) {
  std::string text;
  append_number(text, std::round(value / unit) * unit);
  return text.substr(0, text.find('.') == text.npos ? text.npos : text.find('.') + 4);
}

/// The call while it is carried out.
class Animate {
 public:
  Animate(const AnimateCall& call, Scene scene, const std::stop_token& token)
      : call_(call),
        scene_(std::make_shared<const Scene>(std::move(scene))),
        frames_(problem_at_rest(*scene_), *scene_->animation),
        token_(token),
        progress_(!call.quiet) {}

  int run() {
    fill_in();
    expect_no_source(animation_);
    const auto progress = [&](std::size_t done, std::size_t count, int round) {
      if (std::exchange(round_, round) != round) start_ = std::chrono::steady_clock::now();
      show("solved", done, count);
    };
    const FramesWanted wanted{moments_to_solve(), closing_tolerance(scene_->rest), progress};
    auto solved = naming(call_.scene, [&] { return solve_animation(frames_, wanted, token_); });
    if (!solved) return kExitInterrupted;
    gap_ = solved->gap;
    animation_.solved = std::move(solved->frames);
    if (call_.range) keep_range(animation_, *call_.range);
    round_ = 1;
    return animation_.format.is_baked() ? write_baked() : write_film();
  }

 private:
  /// What the call and the scene say.
  void fill_in() {
    animation_.output = call_.output;
    animation_.format = *find_animation_format(call_.output);
    animation_.scene = scene_;
    animation_.scene_file = call_.scene;
    animation_.loops = scene_->animation->cycle.loops;
    animation_.fps = call_.fps.value_or(scene_->animation->fps);
    animation_.size = call_.size;
    animation_.layers = call_.layers;
    animation_.figure = call_.figure;
    animation_.texts = {{"Software", "Foldless"}, {"Scene", call_.scene.string()}};
    animation_.tolerance = call_.tolerance;
    animation_.power_of_two = call_.power_of_two;
  }

  std::vector<double> moments_to_solve() const {
    const Animation& animation = *scene_->animation;
    const double fps = animation_.fps;
    if (animation.cycle.frames / animation.fps * fps > kMostFrames)
      throw Error("--fps makes more than " + std::to_string(kMostFrames) + " frames");
    std::vector<double> moments = moments_of(animation, fps);
    if (call_.range && static_cast<std::size_t>((*call_.range)[1]) >= moments.size())
      throw Error("--range ends with frame " + std::to_string((*call_.range)[1]) +
                  ", but the last is " + std::to_string(moments.size() - 1));
    return moments;
  }

  void show(const char* what, std::size_t done, std::size_t count) {
    if (!progress_.is_due()) return;
    std::string text =
        std::string(what) + " " + std::to_string(done) + " of " + std::to_string(count) + " frames";
    if (round_ > 1) text += " in the second round of the loop";
    progress_.show(text + time_left(static_cast<double>(done) / static_cast<double>(count)));
  }

  void show_bake(double share) {
    if (progress_.is_due())
      progress_.show("baked " + rounded(100 * share, 1) + " %" + time_left(share));
  }

  /// When a share of it is done; empty while nobody can know.
  std::string time_left(double share) const {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return share > 0 ? ", " + rounded(seconds / share * (1 - share), 1) + " s left" : "";
  }

  int write_film() {
    read_scene_texture();
    const FigureOptions figure = figure_of(animation_);
    FigureRenderer renderer;
    start_ = std::chrono::steady_clock::now();
    const AnimationMeans means{
        [&](const Snapshot& snapshot) { return std::optional(renderer.render(snapshot, figure)); },
        [&](std::size_t done, std::size_t count) { show("drawn", done, count); }};
    if (!write_pictures(animation_, means, token_)) return kExitInterrupted;
    if (!call_.quiet) print_frames();
    return is_reached() ? kExitDone : kExitNotSatisfied;
  }

  int write_baked() {
    if (animation_.format.kind != AnimationFormat::Kind::foldless) read_scene_texture();
    start_ = std::chrono::steady_clock::now();
    const auto written = write_bake(
        animation_, frames_, [&](double share) { show_bake(share); }, token_);
    if (!written) return kExitInterrupted;
    if (!call_.quiet) {
      print_frames();
      print_bake(*written);
    }
    return is_reached() && written->is_good(call_.tolerance) ? kExitDone : kExitNotSatisfied;
  }

  void read_scene_texture() {
    if (!scene_->texture_path.empty())
      animation_.texture = read_texture(scene_->folder / scene_->texture_path, scene_->parts);
  }

  bool is_reached() const {
    return std::ranges::all_of(animation_.solved, &SolvedFrame::is_satisfied);
  }

  void print_frames() const {
    const std::vector<SolvedFrame>& solved = animation_.solved;
    std::cout << solved.size() << (solved.size() == 1 ? " frame: " : " frames: ");
    const auto first = std::ranges::find(solved, false, &SolvedFrame::is_satisfied);
    if (first == solved.end()) {
      std::cout << "every handle is at its target";
    } else {
      std::cout << std::ranges::count(solved, false, &SolvedFrame::is_satisfied)
                << " with handles that are not at their targets, the first at " << first->frame;
      if (!first->verdict.empty()) std::cout << " (" << first->verdict << ")";
    }
    if (animation_.loops)
      std::cout << "; the loop comes back to within "
                << rounded(gap_ / length_of_a_pixel(box_round(solved), call_.size), 0.001) << " px";
    std::cout << "; written to " << call_.output.string() << '\n';
  }

  void print_bake(const WrittenBake& written) const {
    const BakedAnimation& baked = written.baked;
    const std::vector<BakedFailure>& failures = written.failures;
    std::cout << "baked onto " << baked.rest.cols() << " vertices (" << baked.original_vertices
              << " of the drawing), " << baked.frames.size() << " frames, at most "
              << rounded(written.deviation, 0.001) << " px from the solver's map; ";
    if (failures.empty())
      std::cout << "proved to be injective at every moment\n";
    else
      std::cout << failures.size() << " steps are not proved: " << words_of(failures.front(), baked)
                << "; in the file " << jump_words(failures.size()) << '\n';
  }

  const AnimateCall& call_;
  std::shared_ptr<const Scene> scene_;
  Frames frames_;
  std::stop_token token_;
  ProgressLine progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  AnimationToWrite animation_;
  double gap_ = 0;
  int round_ = 1;
};

}  // namespace

int animate(const AnimateCall& call) {
  LoadedScene loaded = load_scene_file(call.scene);
  if (!loaded.scene.animation)
    throw Error(call.scene.string() + ": has no animation; give its handles tracks under " +
                "'animation'");
  if (!call.quiet) print_notices(loaded.notices);
  const Interrupt interrupt;
  const StopWatch watch(
      {.time_limit = {}, .is_interrupted = [&] { return interrupt.is_requested(); }});
  return Animate(call, std::move(loaded.scene), watch.token()).run();
}

}  // namespace foldless
