// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/autosave.h"

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/editor/scene_document.h"
#include "core/exception_words.h"
#include "core/scene/scene_io.h"

namespace foldless {

Autosave::Autosave(std::filesystem::path root, std::function<void()> wake)
    : root_(std::move(root)), wake_(std::move(wake)) {}

bool Autosave::is_due(double now, const Document* document, std::uint64_t step) {
  const bool has_copy = document && copied_ && copied_->step == step &&
                        copied_->pose == document->pose && copied_->handles == document->handles;
  if (root_.empty() || !document || has_copy) {
    due_.reset();
    return false;
  }
  due_ = std::min(due_.value_or(now + interval_), now + interval_);
  return now >= *due_;
}

void Autosave::begin(UnsavedWork work) {
  copied_ = Mark{work.document.pose, work.document.handles, work.step};
  due_.reset();
  const std::uint64_t generation = generation_;
  job_.start([this, generation, work = std::move(work)](const std::stop_token&) {
    report(write(work, generation));
    if (wake_) wake_();
  });
}

std::string Autosave::write_now(const UnsavedWork& work) {
  return root_.empty() ? std::string() : write(work, generation_);
}

std::string Autosave::write(const UnsavedWork& work, std::uint64_t generation) {
  const std::lock_guard lock(folder_mutex_);
  if (generation != generation_) return {};
  try {
    if (!folder_) folder_ = AutosaveFolder::create(root_);
    if (origin_ != work.origin) folder_->set_origin(work.origin);
    origin_ = work.origin;
    const std::filesystem::path file = folder_->next_copy();
    save_scene(scene_of(work.document, file, work.view), file);
    folder_->trim();
    return {};
  } catch (const std::exception& failure) {
    return words_of_exception(failure, root_);
  }
}

void Autosave::report(std::string problem) {
  const std::lock_guard lock(news_mutex_);
  const bool failed = !problem.empty();
  if (failed && !has_failed_) problem_ = std::move(problem);
  has_failed_ = wants_another_ = failed;
}

void Autosave::forget() {
  due_.reset();
  copied_.reset();
  ++generation_;
  job_.cancel();
  const std::lock_guard lock(folder_mutex_);
  origin_.reset();
  if (folder_) folder_->remove();
  folder_.reset();
}

void Autosave::adopt(AutosaveFolder folder) {
  forget();
  const std::lock_guard lock(folder_mutex_);
  folder_ = std::move(folder);
}

std::string Autosave::take_problem() {
  const std::lock_guard lock(news_mutex_);
  if (std::exchange(wants_another_, false)) copied_.reset();
  return std::exchange(problem_, {});
}

}  // namespace foldless
