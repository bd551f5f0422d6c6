// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_results.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/iterations_csv.h"
#include "core/files/mesh_io.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// True for 000000.obj, 000000.png and the like.
bool is_frame(const fs::path& file) {
  const std::string stem = file.stem().string();
  const bool is_number =
      stem.size() >= 6 && std::ranges::all_of(stem, [](char c) { return '0' <= c && c <= '9'; });
  return is_number && (file.extension() == ".obj" || file.extension() == ".png");
}

void remove_frames(const fs::path& frames) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(frames, ignored))
    if (is_frame(entry.path())) fs::remove(entry.path(), ignored);
  // Removes the folder where nothing else is in it.
  fs::remove(frames, ignored);
}

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

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw Error(folder.string() + ": cannot be made: " + failure.message());
  if (!fs::is_directory(folder)) throw Error(folder.string() + ": is not a folder");
}

Results::Results(fs::path folder, const std::optional<FigureOptions>& figure)
    : folder_(std::move(folder)) {
  if (figure) figure_ = frame_figure_ = *figure;
  // A context first: without one nothing is to be written.
  if (figure) renderer_ = std::make_unique<FigureRenderer>();
  make_folder(folder_);
  remove_frames(folder_ / "frames");
  std::error_code ignored;
  if (!figure) fs::remove(folder_ / "deformed.png", ignored);
}

void Results::add_frame(const Snapshot& snapshot) {
  if (frames_ == 0) make_folder(folder_ / "frames");
  std::string number = std::to_string(frames_++);
  number.insert(0, 6 - std::min<std::size_t>(6, number.size()), '0');
  const fs::path file = folder_ / "frames" / number;
  write_mesh(file.string() + ".obj", *snapshot.triangles, snapshot.deformed, snapshot.rest.get());
  if (!renderer_) return;
  // All frames show what the first one does and a little more, so that they make a film.
  if (!frame_figure_.frame) frame_figure_.frame = widened(frame_of(snapshot, frame_figure_.view));
  draw(snapshot, frame_figure_, file.string() + ".png");
}

void Results::finish(const Solved& solved, const JsonNode& report) {
  const Snapshot& state = *solved.snapshot;
  const Points& rest = *state.rest;
  write_mesh(folder_ / "rest.obj", *state.triangles, rest, &rest);
  write_mesh(folder_ / "deformed.obj", *state.triangles, state.deformed, &rest);
  write_file_atomically(folder_ / "iterations.csv", iterations_csv(solved.iterations));
  write_file_atomically(folder_ / "report.json", json_text(report));
  if (renderer_) draw(state, figure_, folder_ / "deformed.png");
}

void Results::draw(const Snapshot& snapshot, const FigureOptions& figure, const fs::path& picture) {
  save_png(picture, renderer_->render(snapshot, figure), texts_of(snapshot));
}

}  // namespace foldless
