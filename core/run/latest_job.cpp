// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/latest_job.h"

#include <utility>

namespace foldless {

LatestJob::~LatestJob() {
  cancel();
  thread_.request_stop();
}

void LatestJob::start(Job job) {
  {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
    next_ = std::move(job);
  }
  if (!thread_.joinable())
    thread_ = std::jthread([this](const std::stop_token& ended) { work(ended); });
  has_news_.notify_one();
}

void LatestJob::cancel() {
  const std::lock_guard lock(mutex_);
  running_.request_stop();
  next_ = nullptr;
}

void LatestJob::work(const std::stop_token& ended) {
  while (true) {
    Job job;
    std::stop_token stop;
    {
      std::unique_lock lock(mutex_);
      if (!has_news_.wait(lock, ended, [this] { return static_cast<bool>(next_); })) return;
      job = std::exchange(next_, nullptr);
      running_ = std::stop_source();
      stop = running_.get_token();
    }
    job(stop);
  }
}

}  // namespace foldless
