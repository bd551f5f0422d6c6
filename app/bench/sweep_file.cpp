// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/sweep_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

/// Bytes of whole lines.
std::size_t whole_lines(const std::string& text) { return text.rfind('\n') + 1; }

std::vector<SweepRecord> records_in(const std::string& text, const std::string& name) {
  std::vector<SweepRecord> records;
  const std::string whole = text.substr(0, whole_lines(text));
  for (TextLines lines(whole); lines.next();)
    if (!lines.line().empty())
      records.push_back(read_record(std::string(lines.line()), name, lines.number()));
  return records;
}

[[noreturn]] void refuse_file(const std::filesystem::path& file) {
  throw Error(file.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace

std::vector<SweepRecord> read_records(const std::filesystem::path& file) {
  return records_in(read_file(file), file.string());
}

MergedSweep merged(const std::vector<std::filesystem::path>& files) {
  MergedSweep sweep;
  std::map<std::size_t, SweepRecord> by_job;
  for (const std::filesystem::path& file : files)
    for (SweepRecord& record : read_records(file)) {
      if (!by_job.empty() && by_job.begin()->second.sweep != record.sweep)
        throw Error(file.string() +
                    ": is of another sweep than the files before it, or of another version of the "
                    "program; merge each by itself");
      sweep.jobs = record.jobs;
      const std::size_t job = record.row.job;
      const auto [place, is_new] = by_job.try_emplace(job, std::move(record));
      if (!is_new && place->second.run != record.run)
        throw Error(file.string() + ": has another run " + std::to_string(job) +
                    " than the files before it; merge each sweep by itself");
    }
  if (by_job.empty()) throw Error("there is no record to merge in the files");
  for (auto& [job, record] : by_job) sweep.rows.push_back(std::move(record.row));
  return sweep;
}

SweepFile::SweepFile(std::filesystem::path file) : file_(std::move(file)) {
  descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) refuse_file(file_);
  try {
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw Error(file_.string() +
                  ": another process appends to it; give every shard a file of its own");
    const std::string text = read_file(file_);
    records_ = records_in(text, file_.string());
    cut_off_ = text.size() - whole_lines(text);
    sync_folder(std::filesystem::absolute(file_).parent_path());
    if (cut_off_ > 0 && ftruncate(descriptor_, static_cast<off_t>(whole_lines(text))) != 0)
      refuse_file(file_);
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

SweepFile::~SweepFile() { close(descriptor_); }

void SweepFile::append(const std::string& line) {
  const std::string text = line + '\n';
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t count = write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno != EINTR) refuse_file(file_);
    if (count > 0) written += static_cast<std::size_t>(count);
  }
  if (fsync(descriptor_) != 0) refuse_file(file_);
}

}  // namespace foldless
