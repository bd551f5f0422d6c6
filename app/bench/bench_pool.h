// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "app/bench/bench_run.h"

namespace foldless {

/// How jobs are run. Each run has a thread to itself, and what is reported is its processor time;
/// while it waits for helpers it does not sleep.
struct BenchOptions {
  int threads = 1;         ///< runs at a time
  int team = 1;            ///< threads of each run, which has the same result with any number
  int repeat = 1;          ///< runs of each job, of whose processor times the median counts
  double time_limit = 60;  ///< processor seconds of a run, noticed between factorizations
};

/// What run_jobs() tells its caller, always on the calling thread.
struct BenchObserver {
  std::function<bool()> is_interrupted;               ///< asked a hundred times a second
  std::function<void(const BenchRow& row)> finished;  ///< in the order of the jobs
};

/// Runs all jobs and returns their rows in the order of the jobs; after an interrupt, those that
/// had ended. A run over the time limit has the outcome `time-limit`.
std::vector<BenchRow> run_jobs(const std::vector<BenchJob>& jobs, const BenchOptions& options,
                               const BenchObserver& observer);

}  // namespace foldless
