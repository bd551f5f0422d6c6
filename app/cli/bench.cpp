// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include "app/bench/bench_pool.h"
#include "app/bench/bench_report.h"
#include "app/bench/drag_suite.h"
#include "app/bench/drag_table.h"
#include "app/bench/hard_suite.h"
#include "app/bench/paper_suite.h"
#include "app/bench/random_suite.h"
#include "app/bench/scale_suite.h"
#include "app/cli/bench_sweep.h"
#include "app/cli/bench_tables.h"
#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "app/cli/problem.h"
#include "app/cli/result_folder.h"
#include "app/cli/scene_files.h"
#include "core/error.h"
#include "core/method/methods.h"
#include "core/run/interrupt.h"

namespace foldless {
namespace {

bool is_wanted(const BenchCall& call, int index) {
  return call.only.empty() || std::ranges::find(call.only, index) != call.only.end();
}

BenchScene scene_of(const std::filesystem::path& file) {
  LoadedScene loaded = load_scene_file(file);
  print_notices(loaded.notices);
  return {name_of_scene(file), "", std::move(loaded.scene)};
}

void expect_scenes(const BenchCall& call, std::size_t count) {
  for (const int index : call.only)
    if (static_cast<std::size_t>(index) >= count)
      throw Error("--only " + std::to_string(index) + ": there is no such scene, only " +
                  std::to_string(count) + ", counted from 0");
}

/// Those of `count` scenes that are wanted.
std::vector<BenchScene> wanted(const BenchCall& call, std::size_t count,
                               const std::function<BenchScene(int)>& scene) {
  expect_scenes(call, count);
  std::vector<BenchScene> scenes;
  for (int i = 0; i < static_cast<int>(count); ++i)
    if (is_wanted(call, i)) scenes.push_back(scene(i));
  return scenes;
}

/// The methods that were asked for, or all of the program.
std::vector<std::string> methods_of(const BenchCall& call) {
  if (!call.methods.empty()) return call.methods;
  const std::vector<std::string_view> names = method_names();
  return {names.begin(), names.end()};
}

std::vector<BenchJob> jobs_of(const BenchCall& call, const std::vector<BenchScene>& scenes) {
  std::vector<BenchJob> jobs;
  for (const BenchScene& scene : scenes)
    for (const std::string& method : methods_of(call)) {
      jobs.push_back({&scene, scene.scene.parameters});
      jobs.back().parameters.method = method;
    }
  return jobs;
}

void keep_scenes(const std::filesystem::path& folder, const std::vector<BenchScene>& scenes) {
  const MadeFolder made(folder);
  for (const BenchScene& scene : scenes) save_scene(scene.scene, folder / (scene.name + ".json"));
}

/// One line on stderr that is written over, where a person looks on.
class BenchProgress {
 public:
  explicit BenchProgress(std::size_t total)
      : total_(total), is_shown_(isatty(STDERR_FILENO) == 1) {}
  ~BenchProgress() {
    if (is_shown_) std::cerr << "\r\033[K" << std::flush;
  }
  BenchProgress(const BenchProgress&) = delete;
  BenchProgress& operator=(const BenchProgress&) = delete;

  void show(const BenchRow& row) {
    ++done_;
    if (!is_shown_) return;
    std::cerr << "\r\033[K" << done_ << "/" << total_ << " " << row.scene << " " << row.method
              << (row.has_reached() ? ": reached, " : ": not reached, ") << number_text(row.seconds)
              << " s" << std::flush;
  }

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool is_shown_;
};

/// Why a run was refused, once each.
std::string notes_of(const std::vector<BenchRow>& rows) {
  std::string text;
  for (const BenchRow& row : rows) {
    if (row.note.empty()) continue;
    const std::string line = row.method + ": " + row.note + '\n';
    if (text.find(line) == std::string::npos) text += line;
  }
  return text;
}

using Rows = std::vector<BenchRow>;

/// The most memory that the process has had so far.
double peak_gibibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

void print_comparison(const Rows& rows) {
  std::cout << rows_table(rows).plain() << '\n';
  if (const TextTable table = difficulty_table(rows); !table.is_empty())
    std::cout << table.plain() << '\n';
  std::cout << summary_table(summaries_of(rows)).plain();
}

Rows run_with_progress(const BenchCall& call, const std::vector<BenchJob>& jobs,
                       const Interrupt& interrupt,
                       const std::function<void(const BenchRow&)>& finished = {}) {
  BenchProgress progress(jobs.size());
  return run_jobs(jobs, call.options,
                  {.is_interrupted = [&] { return interrupt.is_requested(); },
                   .finished =
                       [&](const BenchRow& row) {
                         if (finished) finished(row);
                         progress.show(row);
                       }});
}

/// Every method on every scene.
Rows run_scenes(const BenchCall& call, const std::vector<BenchScene>& scenes,
                const Interrupt& interrupt) {
  if (call.keep) keep_scenes(*call.keep, scenes);
  return run_with_progress(call, jobs_of(call, scenes), interrupt);
}

void print_notes(const Rows& rows) {
  if (const std::string notes = notes_of(rows); !notes.empty()) std::cout << '\n' << notes;
}

void show_comparison(const BenchCall& call, const Rows& rows) {
  print_comparison(rows);
  print_notes(rows);
  if (call.folder) write_comparison(*call.folder, rows);
}

void run_comparison(const BenchCall& call, const Interrupt& interrupt) {
  const std::vector<std::filesystem::path> files = scene_files(call.scenes);
  const auto from_file = [&](int i) { return scene_of(files[static_cast<std::size_t>(i)]); };
  const auto drawn = [&](int i) { return random_scene(call.seed, i); };
  const auto hard = [&](int i) { return hard_scene(call.seed, i); };
  const std::vector<BenchScene> scenes =
      call.suite == "random" ? wanted(call, static_cast<std::size_t>(call.count), drawn)
      : call.suite == "hard" ? wanted(call, kHardScenes, hard)
                             : wanted(call, files.size(), from_file);
  if (call.keep) keep_scenes(*call.keep, scenes);
  show_comparison(call, run_sweep(call, jobs_of(call, scenes),
                                  [&](const std::vector<BenchJob>& jobs, const auto& finished) {
                                    return run_with_progress(call, jobs, interrupt, finished);
                                  }));
}

void run_scale(const BenchCall& call, const Interrupt& interrupt) {
  const Rows rows = run_scenes(call, wanted(call, kScaleScenes, scale_scene), interrupt);
  std::cout << scale_table(rows).plain();
  std::cout << "\npeak memory of the process: " << number_text(peak_gibibytes()) << " GiB\n";
  print_notes(rows);
  if (call.folder) write_scale(*call.folder, rows);
}

void run_drags(const BenchCall& call, const Interrupt& interrupt) {
  const Rows rows = run_scenes(call, wanted(call, kDragScenes, drag_scene), interrupt);
  std::cout << drag_table(rows).plain();
  print_notes(rows);
  if (call.folder) write_drags(*call.folder, rows);
}

/// Keeps the jobs of the scenes that are wanted, numbered as paper_suite() has them.
void keep_wanted(const BenchCall& call, PaperSuite& suite) {
  expect_scenes(call, suite.scenes.size());
  std::vector<BenchJob> jobs;
  std::vector<const PaperRow*> rows;
  for (std::size_t i = 0; i < suite.jobs.size(); ++i) {
    if (!is_wanted(call, static_cast<int>(suite.jobs[i].scene - suite.scenes.data()))) continue;
    jobs.push_back(suite.jobs[i]);
    rows.push_back(suite.rows[i]);
  }
  suite.jobs = std::move(jobs);
  suite.rows = std::move(rows);
}

void run_paper(const BenchCall& call, const Interrupt& interrupt) {
  PaperSuite suite = paper_suite(call.methods);
  keep_wanted(call, suite);
  if (call.keep) keep_scenes(*call.keep, suite.scenes);
  for (const std::string& method : suite.left_out)
    std::cerr << "foldless: note: this program has no method " << method << "; left out\n";
  const Rows rows = run_with_progress(call, suite.jobs, interrupt);
  std::cout << table1(suite, rows).plain();
  print_notes(rows);
  if (call.folder) write_paper(*call.folder, suite, rows);
}

}  // namespace

int bench(const BenchCall& call) {
  const Interrupt interrupt;
  std::optional<MadeFolder> folder;
  if (call.folder) folder.emplace(*call.folder);
  if (call.merge)
    show_comparison(call, merge_sweep(call));
  else if (call.suite == "paper")
    run_paper(call, interrupt);
  else if (call.suite == "scale")
    run_scale(call, interrupt);
  else if (call.suite == "drag")
    run_drags(call, interrupt);
  else
    run_comparison(call, interrupt);
  return interrupt.is_requested() ? kExitInterrupted : kExitDone;
}

}  // namespace foldless
