// SPDX-License-Identifier: GPL-3.0-or-later
// Files of records that bench --append wrote, or that look as if it had.
#include "app/bench/bench_report.h"
#include "app/bench/sweep_file.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foldless;
  const fuzz::MemoryFile file(fuzz::Input(data, size).rest());
  fuzz::refuse_or_do([&] {
    const MergedSweep sweep = merged({file.path()});
    fuzz::expect(!sweep.rows.empty(), "a sweep has rows");
    rows_csv_table(sweep.rows).csv();
    json_text(rows_node(sweep.rows));
    summary_table(summaries_of(sweep.rows)).markdown();
  });
  return 0;
}
