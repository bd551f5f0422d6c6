// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <utility>

#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "app/cli/failure_words.h"
#include "app/cli/film_output.h"
#include "app/cli/gltf_pieces.h"
#include "app/cli/problem.h"
#include "app/cli/progress_line.h"
#include "app/export/animation_format.h"
#include "app/export/baked_files.h"
#include "core/error.h"
#include "core/files/text_lines.h"
#include "core/run/interrupt.h"
#include "core/run/solved_animation.h"
#include "core/run/stop_watch.h"
#include "render/figure.h"

namespace foldless {
namespace {

constexpr double kPixels = 1024;  ///< along the longer side, where no size is given

/// At most so many pictures are sampled for a palette.
constexpr std::size_t kSamples = 12;

std::string rounded(double value, double unit) {
  std::string text;
  append_number(text, std::round(value / unit) * unit);
  return text.substr(0, text.find('.') == text.npos ? text.npos : text.find('.') + 4);
}

/// What all frames need: the box round every shape, with a margin.
Box box_round(const std::vector<SolvedFrame>& frames) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const SolvedFrame& frame : frames)
    for (const int v : frame.snapshot->triangles->reshaped()) {
      const Vec2 p = frame.snapshot->deformed.col(v);
      box.min = {std::min(box.min.x, p.x()), std::min(box.min.y, p.y())};
      box.max = {std::max(box.max.x, p.x()), std::max(box.max.y, p.y())};
    }
  const auto margin = 0.03 * std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  box.min -= margin;
  box.max += margin;
  return box;
}

std::array<int, 2> size_for(const Box& box) {
  const double width = box.max.x - box.min.x, height = box.max.y - box.min.y;
  const double scale = kPixels / std::max(width, height);
  // Even numbers: what codecs of films take.
  const auto pixels = [&](double length) {
    return 2 * std::max(1, static_cast<int>(std::lround(0.5 * scale * length)));
  };
  return {pixels(width), pixels(height)};
}

/// Throws Error where what is to be written would take the place of what it is made of.
void expect_no_source(const std::vector<std::filesystem::path>& written, const Scene& scene,
                      const std::filesystem::path& scene_file) {
  std::vector<std::filesystem::path> sources{scene_file};
  for (const std::string& path : {scene.mesh_path, scene.texture_path})
    if (!path.empty()) sources.push_back(scene.folder / path);
  for (const std::filesystem::path& file : written)
    for (const std::filesystem::path& source : sources) {
      std::error_code ignored;  // They are not there.
      if (std::filesystem::equivalent(file, source, ignored))
        throw Error(file.string() + ": the animation is made of it; write it under another name");
    }
}

/// The call while it is carried out.
class Animate {
 public:
  Animate(const AnimateCall& call, Scene scene, const std::stop_token& token)
      : call_(call),
        format_(*find_animation_format(call.output)),
        scene_(std::move(scene)),
        frames_(problem_at_rest(scene_), *scene_.animation),
        token_(token),
        progress_(!call.quiet) {}

  int run() {
    const double fps = call_.fps.value_or(scene_.animation->fps);
    const auto progress = [&](std::size_t done, std::size_t count) { show("solved", done, count); };
    auto solved = solve_animation(
        frames_, {moments_to_solve(fps), closing_tolerance(scene_.rest), progress}, token_);
    if (!solved) return kExitInterrupted;
    gap_ = solved->gap;
    solved_ = std::move(solved->frames);
    cut_to_range();
    return format_.is_baked() ? write_bake() : write_pictures(fps);
  }

 private:
  std::vector<double> moments_to_solve(double fps) const {
    const Animation& animation = *scene_.animation;
    if (animation.cycle.frames / animation.fps * fps > kMostFrames)
      throw Error("--fps makes more than " + std::to_string(kMostFrames) + " frames");
    std::vector<double> moments = moments_of(animation, fps);
    if (call_.range && static_cast<std::size_t>((*call_.range)[1]) >= moments.size())
      throw Error("--range ends with frame " + std::to_string((*call_.range)[1]) +
                  ", but the last is " + std::to_string(moments.size() - 1));
    return moments;
  }

  /// Only now: a frame follows from those before it, and in a loop from the round that is kept.
  void cut_to_range() {
    if (!call_.range) return;
    const auto [first, last] = *call_.range;
    solved_.erase(solved_.begin() + last + 1, solved_.end());
    solved_.erase(solved_.begin(), solved_.begin() + first);
  }

  bool is_whole_loop() const { return scene_.animation->cycle.loops && !call_.range; }

  void show(const char* what, std::size_t done, std::size_t count) {
    if (!progress_.is_due()) return;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    std::string text =
        std::string(what) + " " + std::to_string(done) + " of " + std::to_string(count) + " frames";
    if (done > 0)
      text += ", " +
              rounded(seconds / static_cast<double>(done) * static_cast<double>(count - done), 1) +
              " s left";
    progress_.show(text);
  }

  int write_pictures(double fps) {
    const Box box = box_round(solved_);
    FigureOptions figure = figure_of(box);
    const FilmOptions options{fps,
                              is_whole_loop(),
                              solved_.size(),
                              {{"Software", "Foldless"}, {"Scene", call_.scene.string()}},
                              call_.power_of_two};
    FigureRenderer renderer;
    const auto output = film_output(call_.output, options);
    if (output->wants_samples())
      for (std::size_t i = 0; i < solved_.size(); i += solved_.size() / kSamples + 1)
        output->sample(renderer.render(*solved_[i].snapshot, figure));
    start_ = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < solved_.size(); ++i) {
      if (token_.stop_requested()) return kExitInterrupted;
      output->add(renderer.render(*solved_[i].snapshot, figure));
      show("drawn", i + 1, solved_.size());
    }
    output->finish();
    if (!call_.quiet) print_frames(box);
    return is_reached() ? kExitDone : kExitNotSatisfied;
  }

  FigureOptions figure_of(const Box& box) const {
    FigureOptions figure = call_.figure;
    const auto [width, height] = call_.size.value_or(size_for(box));
    figure.width = width;
    figure.height = height;
    figure.camera = Camera{0.5 * (box.min + box.max), 1 / length_of_a_pixel(box)};
    figure.parts = scene_.parts;
    figure.texture_place = texture_place(scene_);
    Layers plain;
    plain.wireframe = plain.handles = false;
    if (!scene_.texture_path.empty()) {
      figure.texture = texture();
      plain.boundary = false;
    }
    figure.style.layers = call_.layers.value_or(plain);
    return figure;
  }

  int write_bake() {
    FramesToBake frames{
        scene_.triangles,     {}, {}, is_whole_loop(), scene_.animation->cycle.frames,
        scene_.animation->fps};
    for (const SolvedFrame& frame : solved_) {
      frames.moments.push_back(frame.frame);
      frames.snapshots.push_back(frame.snapshot);
    }
    const Box box = box_round(solved_);
    const double unit = length_of_a_pixel(box);
    const auto baked = bake(
        frames, {.tolerance = call_.tolerance * unit},
        [&](std::size_t frame) { return states_after(frame); }, token_);
    if (!baked) return kExitInterrupted;
    BakedLook look;
    if (format_.kind != AnimationFormat::Kind::foldless) look.pieces = pieces_of(*baked);
    look.units = engine_units(scene_.rest, look.pieces);
    const BakedFiles files = baked_files(call_.output, format_, *baked, look);
    for (const NamedBytes& other : files.others)
      expect_no_source({call_.output.parent_path() / other.name}, scene_, call_.scene);
    write_baked(call_.output, files);
    if (!call_.quiet) {
      print_frames(box);
      print_bake(*baked, files.failures, unit);
    }
    const bool is_good = files.failures.empty() && baked->deviation <= call_.tolerance * unit;
    return is_reached() && is_good ? kExitDone : kExitNotSatisfied;
  }

  std::vector<GltfPiece> pieces_of(const BakedAnimation& baked) const {
    const bool has_texture = !scene_.texture_path.empty();
    return gltf_pieces(scene_, baked, has_texture ? texture() : nullptr);
  }

  std::shared_ptr<const TexturePieces> texture() const {
    return read_texture(scene_.folder / scene_.texture_path, scene_.parts);
  }

  /// What leads from a frame to the next, or from the last of a loop to where it begins anew.
  std::optional<std::vector<std::shared_ptr<const Snapshot>>> states_after(
      std::size_t frame) const {
    const bool is_last = frame + 1 == solved_.size();
    const double next = is_last ? scene_.animation->cycle.frames : solved_[frame + 1].frame;
    std::vector<std::shared_ptr<const Snapshot>> states;
    const auto visit = [&](const auto& state) { states.push_back(state); };
    if (!frames_.solve(next, solved_[frame].snapshot.get(), token_, visit)) return std::nullopt;
    if (!is_last && !states.empty()) states.pop_back();  // The next frame itself.
    return states;
  }

  double length_of_a_pixel(const Box& box) const {
    const auto [width, height] = call_.size.value_or(size_for(box));
    return std::max((box.max.x - box.min.x) / width, (box.max.y - box.min.y) / height);
  }

  bool is_reached() const { return std::ranges::all_of(solved_, &SolvedFrame::is_satisfied); }

  void print_frames(const Box& box) const {
    std::cout << solved_.size() << (solved_.size() == 1 ? " frame: " : " frames: ");
    const auto first = std::ranges::find(solved_, false, &SolvedFrame::is_satisfied);
    if (first == solved_.end()) {
      std::cout << "every handle is at its target";
    } else {
      std::cout << std::ranges::count(solved_, false, &SolvedFrame::is_satisfied)
                << " with handles that are not at their targets, the first at " << first->frame;
      if (!first->verdict.empty()) std::cout << " (" << first->verdict << ")";
    }
    if (is_whole_loop())
      std::cout << "; the loop comes back to within "
                << rounded(gap_ / length_of_a_pixel(box), 0.001) << " px";
    std::cout << "; written to " << call_.output.string() << '\n';
  }

  void print_bake(const BakedAnimation& baked, const std::vector<BakedFailure>& failures,
                  double unit) const {
    std::cout << "baked onto " << baked.rest.cols() << " vertices (" << baked.original_vertices
              << " of the drawing), " << baked.frames.size() << " frames, at most "
              << rounded(baked.deviation / unit, 0.001) << " px from the solver's map; ";
    if (failures.empty())
      std::cout << "proved to be injective at every moment\n";
    else
      std::cout << failures.size() << " steps are not proved: " << words_of(failures.front(), baked)
                << '\n';
  }

  const AnimateCall& call_;
  const AnimationFormat& format_;
  Scene scene_;
  Frames frames_;
  std::stop_token token_;
  ProgressLine progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<SolvedFrame> solved_;
  double gap_ = 0;
};

}  // namespace

int animate(const AnimateCall& call) {
  LoadedScene loaded = load_scene_file(call.scene);
  if (!loaded.scene.animation)
    throw Error(call.scene.string() + ": has no animation; give its handles tracks under " +
                "'animation'");
  std::vector<std::filesystem::path> written{call.output};
  if (find_animation_format(call.output)->kind == AnimationFormat::Kind::sheet)
    written.push_back(picture_of_sheet(call.output));
  expect_no_source(written, loaded.scene, call.scene);
  if (!call.quiet) print_notices(loaded.notices);
  const Interrupt interrupt;
  const StopWatch watch(
      {.time_limit = {}, .is_interrupted = [&] { return interrupt.is_requested(); }});
  return Animate(call, std::move(loaded.scene), watch.token()).run();
}

}  // namespace foldless
