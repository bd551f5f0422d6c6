// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench_tables.h"

#include <string>
#include <utility>

#include "app/bench/bench_report.h"
#include "app/bench/drag_table.h"
#include "app/bench/scale_suite.h"
#include "core/files/file_group.h"

namespace foldless {
namespace {

using Rows = std::vector<BenchRow>;

constexpr const char* kRows = "results.csv";

std::string comparison_markdown(const Rows& rows) {
  std::string summary = "## Summary\n\n" + summary_table(summaries_of(rows)).markdown();
  if (const TextTable table = difficulty_table(rows); !table.is_empty())
    summary += "\n## Reached by difficulty\n\n" + table.markdown();
  return summary + "\n## Runs\n\n" + rows_table(rows).markdown();
}

/// The rows, with tables that were made of them.
void write_with_rows(const std::filesystem::path& folder, const Rows& rows,
                     std::vector<NamedBytes> tables) {
  tables.push_back({"results.json", json_text(rows_node(rows))});
  write_files_together(folder / kRows, rows_csv_table(rows).csv(), tables);
}

}  // namespace

void write_comparison(const std::filesystem::path& folder, const Rows& rows) {
  write_with_rows(folder, rows,
                  {{"summary.md", comparison_markdown(rows)},
                   {"summary.tex", summary_table(summaries_of(rows)).latex()},
                   {"runs.tex", rows_table(rows).latex()}});
}

void write_paper(const std::filesystem::path& folder, const PaperSuite& suite, const Rows& rows) {
  const TextTable table = table1(suite, rows);
  std::vector<NamedBytes> tables{
      {"table1.csv", table.csv()}, {"table1.md", table.markdown()}, {"table1.tex", table.latex()}};
  for (const PlotFile& plot : figure13(rows)) tables.push_back({plot.name, plot.svg});
  write_with_rows(folder, rows, std::move(tables));
}

void write_scale(const std::filesystem::path& folder, const Rows& rows) {
  write_with_rows(
      folder, rows,
      {{"summary.md", scale_table(rows).markdown()}, {"summary.tex", scale_table(rows).latex()}});
}

void write_drags(const std::filesystem::path& folder, const Rows& rows) {
  write_files_together(folder / kRows, drag_csv_table(rows).csv(),
                       {{"results.json", json_text(drag_node(rows))},
                        {"frames.csv", drag_frames_table(rows).csv()},
                        {"summary.md", drag_table(rows).markdown()},
                        {"summary.tex", drag_table(rows).latex()}});
}

}  // namespace foldless
