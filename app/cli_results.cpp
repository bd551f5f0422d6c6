// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_results.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/text_lines.h"

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

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw Error(folder.string() + ": cannot be made: " + failure.message());
  if (!fs::is_directory(folder)) throw Error(folder.string() + ": is not a folder");
}

ImageTexts texts_of(const Snapshot& snapshot) {
  ImageTexts texts{{"Software", "Foldless"}};
  if (!snapshot.iteration) return texts;
  append_number(texts["Iteration"], snapshot.iteration->updates);
  append_number(texts["Energy"], snapshot.iteration->energy);
  return texts;
}

}  // namespace

Results::Results(fs::path folder, std::optional<FigureOptions> figure)
    : folder_(std::move(folder)), figure_(std::move(figure)) {
  // A context first: without one nothing is to be written.
  if (figure_) renderer_ = std::make_unique<FigureRenderer>();
  make_folder(folder_);
  remove_frames(folder_ / "frames");
}

void Results::add_frame(const Snapshot& snapshot) {
  if (frames_ == 0) make_folder(folder_ / "frames");
  std::string number = std::to_string(frames_++);
  number.insert(0, 6 - std::min<std::size_t>(6, number.size()), '0');
  const fs::path file = folder_ / "frames" / number;
  write_mesh(file.string() + ".obj", *snapshot.triangles, snapshot.deformed, snapshot.rest.get());
  if (renderer_) draw(snapshot, file.string() + ".png");
}

void Results::finish(const Solved& solved, const JsonNode& report) {
  const Snapshot& state = *solved.snapshot;
  const Points& rest = *state.rest;
  write_mesh(folder_ / "rest.obj", *state.triangles, rest, &rest);
  write_mesh(folder_ / "deformed.obj", *state.triangles, state.deformed, &rest);
  write_file_atomically(folder_ / "iterations.csv", iterations_csv(solved.iterations));
  write_file_atomically(folder_ / "report.json", json_text(report));
  if (renderer_) draw(state, folder_ / "deformed.png");
}

void Results::draw(const Snapshot& snapshot, const fs::path& picture) {
  // The first picture fixes what the others show, so that they make a film.
  if (!figure_->frame) figure_->frame = frame_of(snapshot, figure_->view);
  save_png(picture, renderer_->render(snapshot, *figure_), texts_of(snapshot));
}

}  // namespace foldless
