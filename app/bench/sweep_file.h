// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/bench/sweep.h"

namespace foldless {

/// The records in a file. Throws Error when it cannot be read or has a line that is none; a last
/// line without an end, which a process that was killed leaves, is left out.
std::vector<SweepRecord> read_records(const std::filesystem::path& file);

/// Rows of a whole sweep from records that may come in any order, and twice.
struct MergedSweep {
  std::vector<BenchRow> rows;  ///< in the order of the jobs
  std::size_t jobs = 0;        ///< of the whole sweep: with none missing, as many as rows
};

/// Throws Error where files are of several sweeps, or have no record.
MergedSweep merged(const std::vector<std::filesystem::path>& files);

/// A file of records that a sweep goes on with, for one process at a time.
class SweepFile {
 public:
  /// Opens or makes it, and cuts off a last line without an end. Throws Error when it cannot be
  /// written, another process has it, or it is not a file of records.
  explicit SweepFile(std::filesystem::path file);
  ~SweepFile();
  SweepFile(const SweepFile&) = delete;
  SweepFile& operator=(const SweepFile&) = delete;

  const std::filesystem::path& name() const { return file_; }
  const std::vector<SweepRecord>& records() const { return records_; }
  /// Bytes of a line that was cut off.
  std::size_t cut_off() const { return cut_off_; }
  /// Adds a line, which has reached the disk when this returns. Throws Error when it is full.
  void append(const std::string& line);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::vector<SweepRecord> records_;
  std::size_t cut_off_ = 0;
};

}  // namespace foldless
