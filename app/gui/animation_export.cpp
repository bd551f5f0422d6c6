// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/animation_export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include "app/editor/scene_document.h"
#include "app/export/held_steps.h"
#include "core/error.h"
#include "core/exception_words.h"
#include "core/run/thread_priority.h"
#include "core/scene/failure_words.h"

namespace foldless {
namespace {

// As Stage. A loop that does not close is gone through once more.
constexpr std::array kStageWords{"Solving", "Solving, second round:", "Drawing", "Baking"};
constexpr std::size_t kWholeBake = 100;  // of progress: per cent

/// 0.25 as a picture's pixels: `0.25 px`.
std::string pixel_words(double pixels) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g px", pixels);
  return text.data();
}

std::string frame_words(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " frame" : " frames");
}

std::vector<double> moments_for(const Animation& animation, double fps) {
  if (animation.cycle.frames / animation.fps * fps > kMostFrames)
    throw Error("That many frames a second make more than " + std::to_string(kMostFrames) +
                " frames; choose fewer.");
  return moments_of(animation, fps);
}

AnimationToWrite what_to_write(const std::filesystem::path& path, const Editor& editor,
                               const AnimationChoice& choice) {
  const Document& document = editor.document();
  AnimationToWrite animation;
  animation.output = path;
  animation.format = choice.format;
  animation.scene = std::make_shared<const Scene>(scene_of(document, path, nullptr));
  animation.texture = editor.files().texture_image().image();
  animation.loops = document.animation->cycle.loops;
  animation.fps = choice.fps.value_or(document.animation->fps);
  animation.size = choice.size;
  animation.figure.style.theme = editor.view().options().theme;
  if (choice.is_transparent) animation.figure.style.background = Background::transparent;
  const std::filesystem::path& file = animation.scene_file = editor.files().path();
  animation.texts = {{"Software", "Foldless"},
                     {"Scene", file.empty() ? document.name : file.string()}};
  animation.tolerance = choice.tolerance;
  animation.power_of_two = choice.power_of_two;
  return animation;
}

}  // namespace

AnimationExport::~AnimationExport() { stop_.request_stop(); }

void AnimationExport::start(const std::filesystem::path& path, Editor& editor,
                            const AnimationChoice& choice) {
  if (is_busy_) throw Error("Another animation is being written; wait for it, or cancel it.");
  const Document& document = editor.document();
  if (document.is_empty() || !document.animation || document.animation->tracks.empty())
    throw Error("There is no animation to write: set keys on the time line first.");
  AnimationToSolve to_solve = animation_to_solve(document);
  auto job = std::make_shared<Job>(Job{what_to_write(path, editor, choice),
                                       Frames(std::move(to_solve.at_rest), *document.animation),
                                       {},
                                       to_solve.tolerance,
                                       choice.range});
  expect_no_source(job->animation);
  if (job->animation.fps == document.animation->fps)
    job->animation.solved = editor.motion().frames().all(document);
  if (job->animation.solved.empty())
    job->moments = moments_for(*document.animation, job->animation.fps);
  is_busy_ = true;
  stop_ = std::stop_source();
  stage_began_.reset();
  seen_ = progress_ = {};
  end_.reset();
  thread_.start([this, job](const std::stop_token&) {
    End end = write(*job);
    const std::lock_guard lock(mutex_);
    end_ = std::move(end);
  });
}

AnimationExport::End AnimationExport::write(Job& job) {
  give_way_to_the_window();
  try {
    return write_job(job);
  } catch (const std::exception& error) {
    return {ToastKind::error, words_of_exception(error, job.animation.output)};
  }
}

AnimationExport::End AnimationExport::write_job(Job& job) {
  End cancelled{ToastKind::notice, "The animation was cancelled; nothing was kept."};
  const std::stop_token token = stop_.get_token();
  AnimationToWrite& animation = job.animation;
  if (!job.moments.empty()) {
    const auto progress = [this](std::size_t done, std::size_t count, int round) {
      tell(round == 1 ? Stage::solving : Stage::second_round, done, count);
    };
    auto solved =
        solve_animation(job.frames, {job.moments, job.closing_tolerance, progress}, token);
    if (!solved) return cancelled;
    animation.solved = std::move(solved->frames);
  }
  if (job.range) keep_range(animation, *job.range);
  const std::string wrote =
      "Wrote " + animation.output.string() + ": " + frame_words(animation.solved.size());
  if (!animation.format.is_baked()) {
    const FigureOptions figure = figure_of(animation);
    const AnimationMeans means{
        [&](const Snapshot& snapshot) { return ask_for(snapshot, figure); },
        [this](std::size_t done, std::size_t count) { tell(Stage::drawing, done, count); }};
    tell(Stage::drawing, 0, animation.solved.size());
    if (!write_pictures(animation, means, token)) return cancelled;
    return {ToastKind::notice, wrote};
  }
  tell(Stage::baking, 0, kWholeBake);
  const auto progress = [this](double share) {
    tell(Stage::baking, static_cast<std::size_t>(share * kWholeBake), kWholeBake);
  };
  const auto written = write_bake(animation, job.frames, progress, token);
  if (!written) return cancelled;
  if (!written->failures.empty())
    return {ToastKind::error, wrote + ", but it is not proved at every moment: " +
                                  words_of(written->failures.front(), written->baked) + "; " +
                                  jump_words(written->failures.size())};
  const std::string far = "at most " + pixel_words(written->deviation) + " from the solver's map";
  return {written->is_good(animation.tolerance) ? ToastKind::notice : ToastKind::error,
          wrote + ", " + std::to_string(written->baked.rest.cols()) + " vertices, " + far +
              "; every moment of the animation proved injective"};
}

/// On the export's own thread: waits until the window's has drawn it.
std::optional<Image> AnimationExport::ask_for(const Snapshot& snapshot,
                                              const FigureOptions& figure) {
  std::unique_lock lock(mutex_);
  wanted_ = &snapshot;
  figure_ = &figure;
  const auto is_done = [this] { return drawn_ || !problem_.empty(); };
  const bool has_ended = is_drawn_.wait(lock, stop_.get_token(), is_done);
  wanted_ = nullptr;
  if (!problem_.empty()) throw Error(std::exchange(problem_, {}));
  if (!has_ended) return std::nullopt;
  return std::exchange(drawn_, {});
}

/// With the lock held: who waits could not go on anyway.
void AnimationExport::draw() {
  const std::lock_guard lock(mutex_);
  if (!wanted_) return;
  try {
    if (!renderer_)
      renderer_ = std::make_unique<FigureRenderer>(FigureRenderer::InCurrentContext());
    drawn_ = renderer_->render(*wanted_, *figure_);
  } catch (const std::exception& error) {
    problem_ = words_of_exception(error);
  }
  wanted_ = nullptr;
  is_drawn_.notify_one();
}

void AnimationExport::tell(Stage stage, std::size_t done, std::size_t count) {
  const std::lock_guard lock(mutex_);
  progress_ = {stage, done, count};
}

void AnimationExport::update(Editor& editor, double time) {
  if (!is_busy_) return;
  draw();
  std::optional<End> end;
  {
    const std::lock_guard lock(mutex_);
    end = std::exchange(end_, {});
    if (!stage_began_ || seen_.stage != progress_.stage) stage_began_ = time;
    seen_ = progress_;
  }
  time_ = time;
  if (!end) return;
  is_busy_ = false;
  renderer_.reset();
  editor.messages().toast(end->kind, end->words);
}

std::optional<float> AnimationExport::share() const {
  if (seen_.count == 0) return std::nullopt;
  return static_cast<float>(seen_.done) / static_cast<float>(seen_.count);
}

std::string AnimationExport::progress_words() const {
  std::string words = kStageWords[static_cast<std::size_t>(seen_.stage)];
  if (seen_.count == 0) return words + "…";
  words += ' ';
  words += std::to_string(seen_.done) +
           (seen_.stage == Stage::baking ? " %" : " of " + std::to_string(seen_.count));
  if (seen_.done == 0 || !stage_began_) return words;
  const double left = (time_ - *stage_began_) / static_cast<double>(seen_.done) *
                      static_cast<double>(seen_.count - seen_.done);
  return words + ", " + std::to_string(static_cast<long>(std::ceil(left))) + " s left";
}

}  // namespace foldless
