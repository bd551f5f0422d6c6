// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "app/bench/bench_pool.h"
#include "app/cli/calls.h"

namespace foldless {

/// Runs jobs and tells of each row that is finished.
using RunJobs = std::function<std::vector<BenchRow>(
    const std::vector<BenchJob>& jobs, const std::function<void(const BenchRow& row)>& finished)>;

/// Runs those of the jobs that fall to the shard of the call and are not in its file, which gets
/// their records one by one. Returns the rows of the shard, numbered as `jobs`, those of the file
/// too. Throws Error where the file is of another sweep.
std::vector<BenchRow> run_sweep(const BenchCall& call, const std::vector<BenchJob>& jobs,
                                const RunJobs& run);

/// The rows of the records in the files of the call; how many are missing is noted.
std::vector<BenchRow> merge_sweep(const BenchCall& call);

}  // namespace foldless
