// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/latest_job.h"

#include <utility>

namespace foldless {
namespace {

void run(const LatestJob::Job& job, const std::stop_token& stop) {
  try {
    job(stop);
  } catch (...) {
    return;  // it had no memory to say so; ending the program would lose unsaved work
  }
}

}  // namespace

LatestJob::~LatestJob() {
  cancel();
  thread_.request_stop();
}

void LatestJob::start(Job job) {
  std::stop_source stop;  // made here, so that the thread needs no memory to begin
  {
    const std::lock_guard lock(mutex_);
    newest_.request_stop();
    newest_ = std::move(stop);
    next_ = std::move(job);
  }
  if (!thread_.joinable())
    thread_ = std::jthread([this](const std::stop_token& ended) { work(ended); });
  has_news_.notify_one();
}

void LatestJob::cancel() {
  const std::lock_guard lock(mutex_);
  newest_.request_stop();
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
      stop = newest_.get_token();
    }
    run(job, stop);
  }
}

}  // namespace foldless
