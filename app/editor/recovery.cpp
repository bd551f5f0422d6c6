// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/recovery.h"

#include <exception>
#include <system_error>
#include <utility>

#include "app/editor/scene_document.h"
#include "core/error.h"
#include "core/exception_words.h"
#include "core/method/methods.h"
#include "core/scene/scene_io.h"

namespace foldless {

Recovery::Recovery(std::filesystem::path root, std::function<void()> wake)
    : root_(std::move(root)), wake_(std::move(wake)), texture_image_(wake_) {}

void Recovery::find() {
  close();
  if (root_.empty()) return;
  LostWork found = find_lost_work(root_);
  unseen_ = std::move(found.problem);
  for (AutosaveFolder& folder : found.folders) {
    try {
      lost_.push_back(look_into(std::move(folder)));
    } catch (const Error& error) {
      unseen_ = error.what();
    }
  }
  if (is_open()) select(0);
}

Recovery::Lost Recovery::look_into(AutosaveFolder folder) {
  std::vector<std::filesystem::path> copies = folder.copies();
  std::error_code ignored;
  std::string time = time_words(std::filesystem::last_write_time(copies.at(0), ignored));
  Lost lost{std::move(folder), std::move(copies), {}, std::move(time), {}};
  try {
    lost.origin = lost.folder.origin();
  } catch (const Error& error) {
    lost.unread = error.what();
  }
  return lost;
}

void Recovery::close() {
  ++request_;
  job_.cancel();
  lost_.clear();
  work_.reset();
  problem_.clear();
  unread_.clear();
  texture_image_.follow({}, nullptr);
}

void Recovery::select(std::size_t index) {
  selected_ = index;
  work_.reset();
  problem_.clear();
  unread_.clear();
  const Lost& lost = lost_[index];
  const News news{++request_, nullptr, {}, lost.unread};
  job_.start([this, news, copies = lost.copies, origin = lost.origin](const std::stop_token&) {
    read(news, copies, origin);
  });
}

/// The newest copy that can be read.
void Recovery::read(News news, const std::vector<std::filesystem::path>& copies,
                    const Origin& origin) {
  for (const std::filesystem::path& copy : copies) {
    try {
      const Scene scene = load_scene(copy, method_names()).scene;
      auto work = std::make_shared<RecoveredWork>(
          RecoveredWork{document_of(scene, copy), scene.view, copy});
      work->document.name = origin.name;
      news.work = std::move(work);
      break;
    } catch (const std::exception& failure) {
      if (news.problem.empty()) news.problem = words_of_exception(failure, copy);
    }
  }
  if (news.work && !news.problem.empty()) news.unread = std::exchange(news.problem, {});
  {
    const std::lock_guard lock(mutex_);
    news_ = std::move(news);
  }
  if (wake_) wake_();
}

bool Recovery::poll() {
  std::optional<News> news;
  {
    const std::lock_guard lock(mutex_);
    news = std::exchange(news_, std::nullopt);
  }
  if (news && news->request == request_) {
    work_ = std::move(news->work);
    problem_ = std::move(news->problem);
    unread_ = std::move(news->unread);
  }
  if (is_open() && work_) texture_image_.follow(work_->document.texture, work_->document.parts);
  return texture_image_.poll() || news;
}

void Recovery::discard() {
  lost_[selected_].folder.remove();
  lost_.erase(lost_.begin() + static_cast<std::ptrdiff_t>(selected_));
  if (!is_open()) return close();
  select(std::min(selected_, lost_.size() - 1));
}

AutosaveFolder Recovery::take() {
  AutosaveFolder folder = std::move(lost_[selected_].folder);
  close();
  return folder;
}

}  // namespace foldless
