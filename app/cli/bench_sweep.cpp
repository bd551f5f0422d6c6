// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench_sweep.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/bench/sweep.h"
#include "app/bench/sweep_file.h"
#include "app/cli/problem.h"
#include "app/cli/version.h"
#include "core/error.h"
#include "core/files/mesh_source.h"

namespace foldless {
namespace {

using Rows = std::vector<BenchRow>;

Sweep sweep_of(const BenchCall& call) {
  std::string version = version_text();
  version.pop_back();  // the end of the line
  return {.version = std::move(version),
          .machine = words_of_machine(),
          .suite = call.suite,
          .seed = call.seed,
          .time_limit = call.options.time_limit,
          .repeat = call.options.repeat};
}

/// A job of the sweep.
struct Numbered {
  std::size_t number = 0;
  BenchJob job;
};

/// The rows that the file has already; the jobs that it lacks stay.
Rows take_done(const SweepFile& file, const Sweep& sweep, const std::vector<BenchJob>& jobs,
               std::vector<Numbered>& mine) {
  Rows rows;
  for (const SweepRecord& record : file.records()) {
    const std::size_t number = record.row.job;
    if (number >= jobs.size() ||
        record_of(jobs[number], number, sweep, jobs.size()).run != record.run)
      throw Error(file.name().string() +
                  ": has runs of another sweep, or of another version of the program; give this "
                  "one a file of its own");
    if (std::erase_if(mine, [&](const Numbered& job) { return job.number == number; }) > 0)
      rows.push_back(record.row);
  }
  return rows;
}

}  // namespace

std::vector<BenchRow> run_sweep(const BenchCall& call, const std::vector<BenchJob>& jobs,
                                const RunJobs& run) {
  const Sweep sweep = sweep_of(call);
  const Shard shard = call.shard.value_or(Shard{});
  std::vector<Numbered> mine;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (shard.holds(i)) mine.push_back({i, jobs[i]});
  std::optional<SweepFile> file;
  Rows rows;
  if (call.append) {
    file.emplace(*call.append);
    rows = take_done(*file, sweep, jobs, mine);
    if (file->cut_off() > 0)
      print_notices({call.append->string() +
                     ": the last line had no end and was cut off; its run is made again"});
  }
  std::vector<BenchJob> missing;
  missing.reserve(mine.size());
  for (const Numbered& job : mine) missing.push_back(job.job);
  Rows made = run(missing, [&](const BenchRow& row) {
    if (!file) return;
    BenchRow numbered = row;
    numbered.job = mine[row.job].number;
    file->append(line_of(std::move(numbered), sweep, jobs.size()));
  });
  for (BenchRow& row : made) {
    row.job = mine[row.job].number;
    rows.push_back(std::move(row));
  }
  std::ranges::sort(rows, {}, &BenchRow::job);
  return rows;
}

std::vector<BenchRow> merge_sweep(const BenchCall& call) {
  MergedSweep sweep = merged(call.scenes);
  if (sweep.rows.size() < sweep.jobs)
    print_notices({counted(sweep.jobs - sweep.rows.size(), "run") + " of " +
                   std::to_string(sweep.jobs) +
                   " missing; begin the shards again that have not ended"});
  return std::move(sweep.rows);
}

}  // namespace foldless
