// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/sequence_export.h"

#include <array>
#include <cstdio>
#include <exception>
#include <utility>

#include "core/error.h"
#include "core/exception_words.h"
#include "render/render_target.h"

namespace foldless {
namespace {

std::filesystem::path numbered_frame(const std::filesystem::path& folder, std::size_t number) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%06zu.png", number);
  return folder / name.data();
}

void make_new_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  if (std::filesystem::exists(folder, failure))
    throw Error(folder.string() + " is there already; choose a name for a new folder.");
  if (!std::filesystem::create_directory(folder, failure))
    throw Error(folder.string() + ": the folder cannot be made: " + failure.message());
}

std::vector<std::shared_ptr<const Snapshot>> snapshots_of(Editor& editor) {
  std::vector<std::shared_ptr<const Snapshot>> snapshots;
  const Solving& solving = editor.draft().solving();
  for (std::size_t i = 0; i < solving.iterations().size(); ++i)
    if (auto snapshot = solving.snapshot_of(i)) snapshots.push_back(std::move(snapshot));
  return snapshots;
}

}  // namespace

void SequenceExport::start(const std::filesystem::path& folder, Editor& editor,
                           const PictureOptions& options) {
  if (job_) throw Error("Another sequence is being written; wait for it, or cancel it.");
  if (!editor.playback().can_scrub())
    throw Error("There are no iterations to write: move a handle and let the solver come to rest.");
  Job job{folder,
          snapshots_of(editor),
          picture_setting(editor, options),
          editor.document().energy,
          picture_texts(editor),
          std::make_unique<SceneRenderer>()};
  job.texts.erase("Energy");  // of one iteration
  if (const auto& image = editor.files().texture_image().image())
    job.renderer->set_texture(*image, box_of(editor.document().texture_box));
  job.renderer->set_parts(editor.document().parts);
  make_new_folder(folder);
  job_ = std::move(job);
  written_ = 0;
  is_writing_ = is_cancelled_ = false;
  first_time_.reset();
  if (!writer_) writer_ = std::make_unique<LatestJob>();
}

void SequenceExport::update(Editor& editor, double time) {
  if (!job_) return;
  time_ = time;
  if (!first_time_) first_time_ = time;
  std::optional<std::string> problem;
  {
    const std::lock_guard lock(mutex_);
    problem = std::exchange(problem_, {});
  }
  if (problem) {
    is_writing_ = false;
    ++written_;
    if (!problem->empty()) return end(editor, *problem);
  }
  if (is_writing_) return;
  if (is_cancelled_ || written_ == job_->snapshots.size()) return end(editor, "");
  try {
    draw_next();
  } catch (const std::exception& error) {
    end(editor, words_of_exception(error, job_->folder));
  }
}

void SequenceExport::draw_next() {
  Job& job = *job_;
  const Snapshot& snapshot = *job.snapshots[written_];
  SceneView view = job.setting.view;
  view.energy_densities = energy_densities(snapshot, *job.energy, job.setting.style);
  RenderTarget target(view.viewport.width, view.viewport.height);
  target.bind();
  job.renderer->draw(snapshot, view, job.setting.style);
  ImageTexts texts = job.texts;
  texts["Iteration"] = std::to_string(written_ + 1);
  is_writing_ = true;
  writer_->start([this, picture = target.read(), texts = std::move(texts),
                  file = numbered_frame(job.folder, written_ + 1)](const std::stop_token&) {
    std::string problem;
    try {
      save_png(file, picture, texts);
    } catch (const std::exception& error) {
      problem = words_of_exception(error, file);
    }
    const std::lock_guard lock(mutex_);
    problem_ = std::move(problem);
  });
}

void SequenceExport::end(Editor& editor, const std::string& problem) {
  if (!problem.empty() || is_cancelled_) take_away();
  const std::string folder = job_->folder.string();
  job_.reset();
  if (!problem.empty())
    editor.messages().toast(ToastKind::error, problem);
  else if (is_cancelled_)
    editor.messages().toast(ToastKind::notice, "The sequence was cancelled; nothing was kept.");
  else
    editor.messages().toast(ToastKind::notice,
                            "Wrote " + std::to_string(written_) + " pictures to " + folder);
}

/// The folder stays where there is something else in it by now.
void SequenceExport::take_away() const {
  std::error_code ignored;
  for (std::size_t number = 1; number <= job_->snapshots.size(); ++number)
    std::filesystem::remove(numbered_frame(job_->folder, number), ignored);
  std::filesystem::remove(job_->folder, ignored);
}

SequenceExport::~SequenceExport() {
  writer_.reset();  // waits for the picture that is being written
  if (job_) take_away();
}

std::optional<double> SequenceExport::seconds_left() const {
  if (!job_ || written_ == 0 || !first_time_) return std::nullopt;
  const auto left = static_cast<double>(job_->snapshots.size() - written_);
  return (time_ - *first_time_) / static_cast<double>(written_) * left;
}

}  // namespace foldless
