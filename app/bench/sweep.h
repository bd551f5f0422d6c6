// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/bench_pool.h"

namespace foldless {

/// What the runs of a sweep have in common, so that a record of one can be traced: a sweep may be
/// spread over processes and machines.
struct Sweep {
  std::string version;     ///< of the program
  std::string machine;     ///< that the runs are made on
  std::string suite;       ///< empty: scene files
  std::uint64_t seed = 1;  ///< of the suite
  double time_limit = 60;  ///< processor seconds of a run
  int repeat = 1;          ///< runs of which the median time counts
};

/// One of `count` equal parts of a sweep, which takes its jobs in turn.
struct Shard {
  int number = 1;  ///< from 1 to count
  int count = 1;

  bool holds(std::size_t job) const {
    return job % static_cast<std::size_t>(count) == static_cast<std::size_t>(number - 1);
  }
};

/// `x86_64, 8 processors, NAME OF THE PROCESSOR`
std::string words_of_machine();

/// The record of a run, a line of JSON without its end. `jobs`: of the whole sweep.
std::string line_of(BenchRow row, const Sweep& sweep, std::size_t jobs);

/// A record that was read.
struct SweepRecord {
  BenchRow row;          ///< without iterations
  std::string sweep;     ///< equal for records of one sweep
  std::string run;       ///< equal for records of one run of one sweep
  std::size_t jobs = 0;  ///< of the whole sweep
};

/// The record in a line. Throws Error `FILE:NUMBER: …` where it is none.
SweepRecord read_record(const std::string& line, const std::string& file, int number);

/// What the record of a job that has not been run will be, but for what comes of it.
SweepRecord record_of(const BenchJob& job, std::size_t number, const Sweep& sweep,
                      std::size_t jobs);

}  // namespace foldless
