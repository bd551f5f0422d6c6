// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/results.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/iterations_csv.h"
#include "core/files/mesh_io.h"
#include "core/files/mesh_text.h"
#include "core/files/text_lines.h"
#include "core/threads/team.h"
#include "render/figure_panes.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// Triangles from which on it is worth starting threads that write and read the two meshes.
constexpr Eigen::Index kSharedFrom = 5'000;

/// Room for what a mesh does between its start and its targets.
Box widened(Box box) {
  const auto margin = 0.15 * (box.max - box.min);
  box.min -= margin;
  box.max += margin;
  return box;
}

ImageTexts texts_of(const Snapshot& snapshot) {
  ImageTexts texts{{"Software", "Foldless"}};
  if (!snapshot.iteration) return texts;
  append_number(texts["Iteration"], snapshot.iteration->updates);
  append_number(texts["Energy"], snapshot.iteration->energy);
  return texts;
}

}  // namespace

Results::Results(fs::path folder, bool has_frames, const std::optional<FigureOptions>& figure)
    // A context first: without one nothing is to be written.
    : renderer_(figure ? std::make_unique<FigureRenderer>() : nullptr), folder_(std::move(folder)) {
  if (figure) figure_ = frame_figure_ = *figure;
  for (const char* name : {"rest.obj", "deformed.obj", "iterations.csv", "report.json"})
    folder_.expect_free(name);
  if (figure) folder_.expect_free("deformed.png");
  if (has_frames) folder_.expect_free_frames();
}

void Results::stage_frame(const Snapshot& snapshot) {
  const fs::path frames = folder_.staged() / "frames";
  if (frames_ == 0) make_folder(frames);
  std::string number = std::to_string(frames_++);
  number.insert(0, 6 - std::min<std::size_t>(6, number.size()), '0');
  const fs::path file = frames / number;
  write_mesh(file.string() + ".obj", *snapshot.triangles, snapshot.deformed, snapshot.rest.get());
  if (!renderer_) return;
  // All frames show what the first one does and a little more, so that they make a film.
  if (!frame_figure_.frame) frame_figure_.frame = widened(frame_of(snapshot, frame_figure_.view));
  draw(snapshot, frame_figure_, file.string() + ".png");
}

template <typename Task>
void Results::told_by_final_names(const Task& task) {
  try {
    task();
  } catch (const Error& error) {
    throw Error(folder_.with_final_names(error.what()));
  }
}

void Results::add_frame(const Snapshot& snapshot) {
  told_by_final_names([&] { stage_frame(snapshot); });
}

void Results::finish(const Solved& solved, const JsonNode& report) {
  const bool is_little = frames_ == 0 && solved.snapshot->triangles->cols() < kSharedFrom;
  const WithTeam with(is_little ? nullptr : present_team());
  told_by_final_names([&] {
    stage_rest(solved, report);
    folder_.commit();
  });
}

void Results::stage_rest(const Solved& solved, const JsonNode& report) {
  const Snapshot& state = *solved.snapshot;
  const Points& rest = *state.rest;
  const fs::path staged = folder_.staged();
  // Side by side, and what both meshes have but once: a million triangles are a second of text.
  std::string vertices[2], after;
  in_parallel(3, [&](int i) {
    if (i == 0) after = obj_lines_after_vertices(*state.triangles, &rest);
    if (i > 0) vertices[i - 1] = obj_vertex_lines(i == 1 ? rest : state.deformed);
  });
  in_parallel(2, [&](int i) {
    const std::string_view parts[] = {vertices[i], after};
    const fs::path file = staged / (i == 0 ? "rest.obj" : "deformed.obj");
    write_new_file(file, parts, file);
  });
  write_new_file(staged / "iterations.csv", iterations_csv(solved.iterations),
                 staged / "iterations.csv");
  write_new_file(staged / "report.json", json_text(report), staged / "report.json");
  if (renderer_) draw(state, figure_, staged / "deformed.png");
}

void Results::draw(const Snapshot& snapshot, const FigureOptions& figure, const fs::path& picture) {
  save_png(picture, renderer_->render(snapshot, figure), texts_of(snapshot));
}

}  // namespace foldless
